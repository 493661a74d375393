//! A trace gives what the sample gives, and its steps tell how.

use crate::scene::{self, Random};
use proptest::prelude::*;
use texunit::format::Format;
use texunit::image::Shape;
use texunit::lanes::{F32s, Isa, LANES};
use texunit::plan::SamplePlan;
use texunit::sample::{Addresses, Lod, LookupScratch, Points};
use texunit::sampler::{Filter, Mipmap, Sampler, Wrap};
use texunit::trace::SampleStep;

/// The bits, but one NaN for all.
fn bits(value: f32) -> u32 {
    if value.is_nan() { f32::NAN.to_bits() } else { value.to_bits() }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn a_trace_ends_in_the_bits_of_the_sample(
        shape in scene::shapes(),
        format in scene::formats(),
        width in 1..=40_u32,
        height in 1..=40_u32,
        sampler in scene::samplers(),
        seed in any::<u64>(),
    ) {
        let image = scene::image(shape, format, width, height, seed);
        let plan = SamplePlan::new(&image, &scene::for_shape(shape, sampler));
        let mut random = Random(seed);
        for scale in [0.02, 0.3] {
            let coords = scene::block(&mut random, scale);
            let reference = F32s::from_fn(|_| random.within(-0.2, 1.2));
            let layer = F32s::from_fn(|_| random.within(-1.5, 4.0));
            let bias = F32s::from_fn(|_| random.within(-1.0, 1.0));
            let d = [(); 6].map(|()| F32s::from_fn(|_| random.within(-scale, scale)));
            let [a, b, c, e, f, g] = d.each_ref();
            let lods = [
                Lod::Implicit { bias: Some(&bias) },
                Lod::Explicit(&bias),
                Lod::Gradient { dx: [a, b, c], dy: [e, f, g], bias: None },
            ];
            for lod in lods {
                let points = Points {
                    coords: coords.each_ref(),
                    layer: Some(&layer),
                    reference: Some(&reference),
                };
                let mut room = LookupScratch::default();
                plan.sample_offset(Isa::best(), points, [1, 0, -2], lod, Addresses::Compute, &mut room);
                for lane in (0..LANES).step_by(7) {
                    let trace = plan.trace(lane, points, [1, 0, -2], lod);
                    let want = room.lanes.each_ref().map(|channel| bits(channel[lane]));
                    prop_assert_eq!(trace.result.map(bits), want, "{}", plan.describe());
                }
            }
        }
    }
}

#[test]
fn the_steps_of_a_trilinear_sample_are_those_of_the_chapter() {
    let image = scene::image(Shape::D2, Format::Rgba8, 8, 8, 2);
    let sampler = Sampler {
        min: Filter::Linear,
        mag: Filter::Linear,
        mipmap: Mipmap::Linear,
        wrap: [Wrap::Repeat; 3],
        ..Sampler::default()
    };
    let plan = SamplePlan::new(&image, &sampler);
    // Three texels a pixel.
    let s = F32s::from_fn(|lane| 0.375 * texunit::lanes::lane_x(lane) as f32);
    let t = F32s::from_fn(|lane| 0.375 * texunit::lanes::lane_y(lane) as f32);
    let points = Points { coords: [&s, &t, &F32s::ZERO], layer: None, reference: None };
    let trace = plan.trace(5, points, [0; 3], Lod::Implicit { bias: None });
    let levels: Vec<u32> = trace
        .steps
        .iter()
        .filter_map(|step| match step {
            SampleStep::Level { level, .. } => Some(*level),
            _ => None,
        })
        .collect();
    assert_eq!(levels, [1, 2]);
    let rho = trace.steps.iter().find_map(|step| match step {
        SampleStep::Isotropic { rho_squared, .. } => Some(*rho_squared),
        _ => None,
    });
    assert_eq!(rho, Some(9.0));
    let texels = trace.steps.iter().filter(|step| matches!(step, SampleStep::Texel { .. })).count();
    assert_eq!(texels, 8);
    assert!(matches!(trace.steps.last(), Some(SampleStep::Mixed(_))));
}
