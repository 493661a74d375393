//! Direct lookups against the general kernel.

use crate::format::Format;
use crate::image::{Image, Level, Shape};
use crate::lanes::{F32s, Isa, Kernel, LANES, Simd, U32s, lane_x, lane_y};
use crate::plan::SamplePlan;
use crate::sample::{AxisTexels, Lod, LookupScratch, NotDirect};
use crate::sampler::{Filter, Mipmap, Sampler, Swizzle, Wrap};

/// Registers, of which the first two are s and t.
struct Lookup<'a> {
    plan: &'a SamplePlan,
    registers: &'a mut [U32s],
    axes: [AxisTexels; 2],
    scratch: &'a mut LookupScratch,
    out: [Option<usize>; 4],
}

impl Kernel for Lookup<'_> {
    type Output = Result<(), NotDirect>;

    #[inline(always)]
    fn run<S: Simd>(self) -> Self::Output {
        let Self { plan, registers, axes, scratch, out } = self;
        plan.sample_registers::<S>(registers, [0, 1], (axes, scratch), out)
    }
}

fn image(shape: Shape, format: Format, size: [u32; 2], border: u32) -> Image {
    let mut image = Image::new(shape);
    let mut level = Level::with_size(format, [size[0], size[1], 1], shape.border(border)).unwrap();
    for (at, byte) in level.texels.iter_mut().enumerate() {
        *byte = (at as u32).wrapping_mul(0x9E37_79B9).rotate_left(9) as u8;
    }
    image.set_level(0, 0, level).unwrap();
    image
}

fn sampler(wrap: [Wrap; 2]) -> Sampler {
    Sampler {
        wrap: [wrap[0], wrap[1], Wrap::Repeat],
        min: Filter::Nearest,
        mag: Filter::Nearest,
        mipmap: Mipmap::None,
        ..Sampler::default()
    }
}

/// Coordinates in texels of the pixels of a block: magnified, one to one, mirrored, turned, minified, and of no map.
const MAPS: [fn(f32, f32) -> [f32; 2]; 7] = [
    |x, y| [3.3 + 0.25 * x, 2.1 + 0.3 * y],
    |x, y| [4.5 + x, 1.5 + y],
    |x, y| [9.5 - x, 7.75 - y],
    |x, y| [5.0 + 0.4 * (x + y), 5.0 + 0.4 * (x - y)],
    |x, y| [3.0 * x, 5.0 * y],
    |x, y| [x * y * 7.7 - 31.0, (x - 3.0) * 1e3],
    |x, y| {
        [-3.7 + 1.1 * x, if x == 5.0 && y == 6.0 { f32::NAN } else { f32::INFINITY * (y - 4.0) }]
    },
];

/// What a lookup gives in four registers, and the general kernel.
fn sampled(plan: &SamplePlan, isa: Isa, at: &[F32s; 2]) -> Option<([U32s; 4], [F32s; 4])> {
    let mut registers = vec![U32s::splat(0x5555_5555); 8];
    registers[0] = *at[0].as_u32();
    registers[1] = *at[1].as_u32();
    // An output may be the register of a coordinate.
    let numbers = [4, 0, 6, 1];
    let scratch = &mut LookupScratch::default();
    let mut look_up = |registers: &mut [U32s], axes| {
        isa.run(Lookup { plan, registers, axes, scratch, out: numbers.map(Some) }).ok()?;
        Some(numbers.map(|number| registers[number]))
    };
    let given = registers.clone();
    let first = look_up(&mut registers, [AxisTexels::Compute; 2])?;
    // Texels that are kept, then reused instead of coordinates that lie elsewhere.
    let [s, t] = [2, 15];
    let [keep, reuse] = [AxisTexels::Keep, AxisTexels::Reuse].map(|axis| [axis(s), axis(t)]);
    let mut elsewhere = given.clone();
    elsewhere[..2].fill(U32s::splat(0.6_f32.to_bits()));
    for (mut registers, axes) in [
        (given.clone(), keep),
        (elsewhere.clone(), reuse),
        ([&elsewhere[..1], &given[1..]].concat(), [reuse[0], AxisTexels::Compute]),
        ([&given[..1], &elsewhere[1..]].concat(), [AxisTexels::Compute, reuse[1]]),
    ] {
        assert_eq!(look_up(&mut registers, axes)?, first, "{axes:?}");
    }
    let mut want = [F32s::ZERO; 4];
    let coords = [&at[0], &at[1], &F32s::ZERO];
    plan.general().sample(isa, coords, None, Lod::Implicit { bias: None }, &mut want);
    Some((first, want))
}

#[test]
fn direct_lookups_give_the_bits_of_the_general_kernel() {
    let (mut direct, mut others) = (0, 0);
    for (number, format) in Format::ALL.into_iter().enumerate() {
        for (at, wrap) in Wrap::ALL.into_iter().enumerate() {
            let shape = [Shape::D2, Shape::Rect][(number + at) / 3 % 2];
            let size = [[16, 9], [8, 1], [5, 13], [64, 64]][(number + at) % 4];
            let other = Wrap::ALL[(at + number) % Wrap::ALL.len()];
            let image =
                image(shape, format, size, u32::from(number % 4 > 1 && format.block().is_none()));
            let mut sampler = sampler([wrap, other]);
            if number % 3 == 1 {
                sampler.swizzle = [Swizzle::Alpha, Swizzle::Red, Swizzle::One, Swizzle::Blue];
            }
            let plan = SamplePlan::new(&image, &sampler);
            for (map, isa) in
                MAPS.iter().flat_map(|map| Isa::available().into_iter().map(move |isa| (map, isa)))
            {
                let scale = match shape {
                    Shape::Rect => [1.0; 2],
                    _ => size.map(|side| 1.0 / side as f32),
                };
                let coordinate = |axis: usize| {
                    F32s::from_fn(|lane| {
                        map(lane_x(lane) as f32, lane_y(lane) as f32)[axis] * scale[axis]
                    })
                };
                let Some((got, want)) = sampled(&plan, isa, &[coordinate(0), coordinate(1)]) else {
                    others += 1;
                    continue;
                };
                direct += 1;
                for (channel, (got, want)) in got.iter().zip(&want).enumerate() {
                    for lane in 0..LANES {
                        let bits = |word: u32| {
                            if f32::from_bits(word).is_nan() { f32::NAN.to_bits() } else { word }
                        };
                        let (got, want) = (bits(got[lane]), bits(want[lane].to_bits()));
                        let name = isa.name();
                        assert_eq!(
                            got, want,
                            "{format:?} {wrap:?} {size:?} {name} {channel} {lane}"
                        );
                    }
                }
            }
        }
    }
    // Of formats of one word without border; never on the baseline.
    let wide = Isa::available().len() - 1;
    assert!(direct >= 500 * wide && others > 500, "{direct} direct, {others} others");
}

#[test]
fn components_that_are_not_used_are_not_written() {
    let plan =
        SamplePlan::new(&image(Shape::D2, Format::Rgba8, [8, 8], 0), &sampler([Wrap::Repeat; 2]));
    for isa in Isa::available().into_iter().filter(|isa| isa.is_wide()) {
        let mut registers = vec![U32s::splat(7); 6];
        let (axes, scratch) = ([AxisTexels::Compute; 2], &mut LookupScratch::default());
        let out = [None, Some(3), None, None];
        let lookup = Lookup { plan: &plan, registers: &mut registers, axes, scratch, out };
        assert_eq!(isa.run(lookup), Ok(()));
        let changed: Vec<_> = (0..6).filter(|&at| registers[at] != U32s::splat(7)).collect();
        assert_eq!(changed, [3]);
    }
}

#[test]
fn lookups_that_select_levels_or_filters_are_not_direct() {
    let image = image(Shape::D2, Format::Rgba8, [8, 8], 0);
    let nearest = sampler([Wrap::Repeat; 2]);
    let linear = Sampler { mag: Filter::Linear, ..nearest.clone() };
    let border = Sampler { wrap: [Wrap::ClampToBorder; 3], ..nearest };
    for sampler in [linear, border] {
        let plan = SamplePlan::new(&image, &sampler);
        for isa in Isa::available() {
            let mut registers = vec![U32s::ZERO; 6];
            let (axes, scratch) = ([AxisTexels::Compute; 2], &mut LookupScratch::default());
            let out = [Some(2), None, None, None];
            let lookup = Lookup { plan: &plan, registers: &mut registers, axes, scratch, out };
            assert_eq!(isa.run(lookup), Err(NotDirect));
        }
    }
}
