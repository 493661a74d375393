//! Affine maps, whose derivatives are the same in all lanes: one footprint is computed for the batch, and round ones are
//! filtered as isotropic ones.

use super::*;
use crate::lanes::QUADS;

/// A lookup with gradients as part of a kernel, and whether its levels were known before it.
struct AffineLookup<'a> {
    isa: Isa,
    plan: &'a SamplePlan,
    coords: [&'a F32s; 3],
    lod: Lod<'a>,
}

impl Kernel for AffineLookup<'_> {
    type Output = ([F32s; 4], bool);

    #[inline(always)]
    fn run<S: Simd>(self) -> Self::Output {
        let Self { isa, plan, coords, lod } = self;
        let (scratch, mut weight) = (&mut LookupScratch::default(), F32s::ZERO);
        let levels = plan.uniform_levels::<S>(coords, &lod, &mut weight);
        let is_uniform = levels.is_some();
        let selected = SelectedLevels { levels, weight: &weight, addresses: Addresses::Compute };
        let (colors, _) =
            plan.sample_fused::<S, _>(isa, coords, lod, selected, scratch, KeepTexels);
        (colors, is_uniform)
    }
}

#[test]
fn affine_maps_are_sampled_as_any_other() {
    let (mut round_footprints, mut long_scans) = (0, 0);
    for round in 0..3000_u32 {
        let pick = |salt: u32, n: usize| noise(round * 32 + salt) as usize % n;
        let unit = |salt: u32| (noise(round * 32 + salt) >> 8) as f32 / 16_777_216.0;
        let size = [[64, 64, 1], [64, 16, 1], [37, 53, 1], [2, 128, 1]][pick(0, 4)];
        let format = [Format::Rgba8, Format::Rgb8][pick(1, 2)];
        let image = image(Shape::D2, format, size, 2 * round);
        let image = if pick(2, 2) == 0 { image } else { with_opaque_texels(&image) };
        let sampler = Sampler {
            wrap: [[Wrap::Repeat, Wrap::ClampToEdge, Wrap::MirroredRepeat][pick(3, 3)]; 3],
            min: Filter::Linear,
            mag: Filter::Linear,
            mipmap: [Mipmap::None, Mipmap::Nearest, Mipmap::Linear][pick(4, 3)],
            max_anisotropy: [1.0, 2.0, 16.0, 16.0][pick(5, 4)],
            lod_bias: [0.0, 0.0, 0.75, -1.5][pick(6, 4)],
            min_lod: [-1000.0, -1000.0, 0.3][pick(7, 3)],
            max_lod: [1000.0, 1000.0, 1.6, -0.5][pick(8, 4)],
            ..Sampler::default()
        };
        let plan = SamplePlan::new(&image, &sampler);
        let plan = plan.without_alpha().unwrap_or(plan);
        // Texels per pixel along two axes, and the angle of both.
        let texels = (6.0 * unit(9) - 3.0).exp2();
        let stretch = [1.0, 1.0, 1.000_000_1, 1.000_01, 1.001, 1.1, 5.0][pick(10, 7)];
        let sides = [texels, texels * stretch];
        let angle = [0.0, 0.0, 1.570_796_4, 0.3, 2.1 * unit(11)][pick(12, 5)];
        let (sin, cos) = angle.sin_cos();
        let [width, height] = [size[0] as f32, size[1] as f32];
        let dx = [sides[0] * cos / width, sides[0] * sin / height];
        let dy = [-sides[1] * sin / width, sides[1] * cos / height];
        let start = [unit(13), unit(14)];
        let coords = [0, 1, 2].map(|axis: usize| {
            F32s::from_fn(|lane| {
                let (quad, pixel) = (lane % QUADS, lane / QUADS);
                let x = (2 * (quad % 4) + pixel % 2) as f32;
                let y = (2 * (quad / 4) + pixel / 2) as f32;
                match axis {
                    2 => 0.0,
                    _ if lane == 37 && pick(15, 16) == 0 => f32::NAN,
                    _ => start[axis] + x * dx[axis] + y * dy[axis],
                }
            })
        });
        let splat = |d: [f32; 2]| [F32s::splat(d[0]), F32s::splat(d[1]), F32s::ZERO];
        let [dx, dy] = [splat(dx), splat(dy)];
        let lod = Lod::Gradient { dx: dx.each_ref(), dy: dy.each_ref(), bias: None };
        for isa in Isa::available() {
            let coords = coords.each_ref();
            let sample = |plan: &SamplePlan| {
                let mut out = [F32s::ZERO; 4];
                plan.sample(isa, coords, None, lod, &mut out);
                out.map(bits)
            };
            let want = sample(&plan.general());
            let what = format!("{} {texels} {stretch} {angle}: {}", isa.name(), plan.describe());
            assert_eq!(sample(&plan), want, "{what}");
            let (colors, is_uniform) = isa.run(AffineLookup { isa, plan: &plan, coords, lod });
            assert_eq!(colors.map(bits), want, "as part of a kernel: {what}");
            let is_anisotropic = sampler.max_anisotropy > 1.0;
            let is_round = is_uniform && is_anisotropic;
            if isa.is_wide() && is_anisotropic && stretch == 1.0 && angle == 0.0 {
                assert!(is_round, "{what}");
            }
            if is_round {
                assert!(stretch < 1.05, "{what}");
            }
            round_footprints += u32::from(is_round);
            long_scans += u32::from(is_anisotropic && stretch > 1.05);
        }
    }
    assert!(round_footprints > 500 || Isa::available().len() == 1, "{round_footprints}");
    assert!(long_scans > 500, "{long_scans}");
}
