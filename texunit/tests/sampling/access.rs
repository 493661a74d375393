//! Access by index: fetches, sizes, and the bits of integers.

use crate::scene;
use texunit::format::Format;
use texunit::image::{Image, Level, Shape};
use texunit::lanes::{F32s, I32s, Isa};
use texunit::plan::SamplePlan;
use texunit::sample::Lod;
use texunit::sampler::{Filter, Mipmap, Sampler};

fn nearest() -> Sampler {
    let (min, mag) = (Filter::Nearest, Filter::Nearest);
    Sampler { min, mag, mipmap: Mipmap::None, ..Sampler::default() }
}

fn fetch(plan: &SamplePlan, texel: [i32; 3], level: i32, offset: [i32; 3]) -> [f32; 4] {
    let mut out = [F32s::splat(9.0); 4];
    let texel = texel.map(I32s::splat);
    plan.fetch(Isa::best(), texel.each_ref(), &I32s::splat(level), offset, &mut out);
    out.map(|c| c[40])
}

#[test]
fn a_fetch_reads_the_texel_it_names_and_zero_elsewhere() {
    for shape in Shape::ALL {
        let image = scene::image(shape, Format::Rgba8, 9, 6, 3);
        let plan = SamplePlan::new(&image, &nearest());
        // Layers come after what is filtered along.
        let place = |[x, y, z]: [i32; 3]| match shape {
            Shape::D1Array => [x, z, 0],
            _ => [x, y, z],
        };
        for number in 0..2 {
            let Some(level) = image.level(0, number) else { continue };
            let [w, h, d] = level.size().map(|side| side as i32);
            for at in [[0, 0, 0], [w - 1, h - 1, d - 1], [w / 2, 0, d - 1]] {
                let want = level.color_at(at).unwrap();
                assert_eq!(fetch(&plan, place(at), number as i32, [0; 3]), want, "{shape:?}");
                let moved = [at[0] - 2, at[1], at[2]];
                assert_eq!(fetch(&plan, place(moved), number as i32, [2, 0, 0]), want);
            }
            for x in [-1, w, i32::MAX, i32::MIN] {
                assert_eq!(fetch(&plan, [x, 0, 0], number as i32, [0; 3]), [0.0; 4]);
            }
        }
        for level in [-1, 9, i32::MAX] {
            assert_eq!(fetch(&plan, [0; 3], level, [0; 3]), [0.0; 4]);
        }
    }
}

#[test]
fn sizes_follow_the_levels_and_layers_stay() {
    let size = |shape, level| {
        let plan = SamplePlan::new(&scene::image(shape, Format::R8, 9, 6, 2), &nearest());
        plan.size(&I32s::splat(level)).map(|side| side[5])
    };
    assert_eq!(size(Shape::D1, 1), [4, 1, 1]);
    assert_eq!(size(Shape::D2, 1), [4, 3, 1]);
    assert_eq!(size(Shape::D3, 1), [4, 3, 2]);
    assert_eq!(size(Shape::D1Array, 1), [4, 3, 1]);
    assert_eq!(size(Shape::D2Array, 1), [4, 3, 3]);
    assert_eq!(size(Shape::CubeArray, 0), [9, 9, 3]);
    assert_eq!(size(Shape::CubeArray, 1), [4, 4, 3]);
    assert_eq!(size(Shape::Rect, 1), [0; 3]);
    assert_eq!(size(Shape::D2, -1), [0; 3]);
}

#[test]
fn integers_come_as_their_bits() {
    let mut image = Image::new(Shape::D2);
    let texel = [0x78, 0x56, 0x34, 0xF2, 1, 0, 0, 0, 2, 0, 0, 0, 255, 255, 255, 255];
    image.set_level(0, 0, Level::from_texels(Format::Rgba32I, 1, 1, &texel).unwrap()).unwrap();
    let plan = SamplePlan::new(&image, &nearest());
    let want = [0xF234_5678, 1, 2, 0xFFFF_FFFF];
    assert_eq!(fetch(&plan, [0; 3], 0, [0; 3]).map(f32::to_bits), want);
    let mut out = [F32s::ZERO; 4];
    let zero = F32s::ZERO;
    plan.sample(Isa::best(), [&zero; 3], None, Lod::Implicit { bias: None }, &mut out);
    assert_eq!(out.map(|c| c[3].to_bits()), want);
}
