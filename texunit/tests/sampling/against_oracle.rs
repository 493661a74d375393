//! Random images, samplers and coordinates against the `f64` oracle.

use crate::oracle::{Answer, Detail, Oracle};
use crate::scene::{self, Random};
use proptest::prelude::*;
use texunit::format::Format;
use texunit::image::{Image, Shape};
use texunit::lanes::{F32s, Isa, LANES};
use texunit::plan::SamplePlan;
use texunit::sample::{Addresses, Lod, LookupScratch, Points};
use texunit::sampler::Sampler;

/// What a filter may be off by. A coordinate of magnitude up to about 20 has an error of a few
/// units in the last place, times the texels of a side, times the largest step between texels
/// and border (3); then a dozen roundings of values up to 2.
const SIDE: u32 = 40;
const TOLERANCE: f64 = f32::EPSILON as f64 * 3.0 * (20.0 * SIDE as f64 + 12.0);

/// Points nearer to a step than this (in texels or levels) may fall on either side.
const MARGIN: f64 = 4e-3;

#[derive(Default)]
struct Tally {
    checked: usize,
    on_a_step: usize,
}

impl Tally {
    fn check(&mut self, got: &[F32s; 4], lane: usize, want: Answer, what: &str) {
        if want.margin < MARGIN {
            self.on_a_step += 1;
            return;
        }
        self.checked += 1;
        for (got, want) in got.iter().zip(want.rgba) {
            let got = got[lane];
            let error = (f64::from(got) - want).abs();
            assert!(error <= TOLERANCE, "{what}: lane {lane}: {got} for {want}, off by {error:e}");
        }
    }
}

fn check(image: &Image, sampler: &Sampler, seed: u64) -> Tally {
    let mut random = Random(seed);
    let mut tally = Tally::default();
    let plan = SamplePlan::new(image, sampler);
    let what = plan.describe();
    assert!(plan.incomplete().is_none(), "{what}");
    for scale in [0.001, 0.02, 0.3] {
        let scale = if image.shape() == Shape::Rect { scale * SIDE as f32 } else { scale };
        let coords = scene::block(&mut random, scale);
        // Every other reference is a depth that the image holds, for the equalities.
        let base = image.level(0, sampler.base_level as usize).unwrap();
        let held = base.channels_at([0; 3]).unwrap()[0];
        let offset = if random.bits().is_multiple_of(2) { [0; 3] } else { [3, -2, 1] };
        let reference = F32s::from_fn(|l| if l % 2 == 0 { held } else { random.within(-0.2, 1.2) });
        let bias = F32s::from_fn(|_| random.within(-1.0, 1.0));
        let lambda = F32s::from_fn(|_| random.within(-2.0, 7.0));
        let layer = F32s::from_fn(|_| random.within(-1.5, 4.0));
        let dx = [(); 3].map(|()| F32s::from_fn(|_| random.within(-scale, scale)));
        let dy = [(); 3].map(|()| F32s::from_fn(|_| random.within(-scale, scale)));
        let points =
            Points { coords: coords.each_ref(), layer: Some(&layer), reference: Some(&reference) };
        if image.shape().axes() == 2 {
            // Of cubes there is no gather with an offset.
            let is_near = offset == [0; 3] || image.shape().is_cube();
            let far = if is_near { [0; 3] } else { [31, -32, 0] };
            let mut got = [F32s::splat(f32::NAN); 4];
            plan.gather(Isa::best(), points, [far[0], far[1]], &mut got);
            for lane in 0..LANES {
                let at = coords.each_ref().map(|c| f64::from(c[lane]));
                let (layer, reference) = (f64::from(layer[lane]), f64::from(reference[lane]));
                let oracle = Oracle { image, sampler, layer, reference, offset: far };
                tally.check(&got, lane, oracle.gather(at), &what);
            }
        }
        let lods = [
            Lod::Implicit { bias: None },
            Lod::Implicit { bias: Some(&bias) },
            Lod::Explicit(&lambda),
            Lod::Gradient { dx: dx.each_ref(), dy: dy.each_ref(), bias: None },
        ];
        for lod in lods {
            let mut room = LookupScratch::default();
            room.lanes = [F32s::splat(f32::NAN); 4];
            plan.sample_offset(Isa::best(), points, offset, lod, Addresses::Compute, &mut room);
            let got = room.lanes;
            for lane in 0..LANES {
                let at = coords.each_ref().map(|c| f64::from(c[lane]));
                let detail = match lod {
                    Lod::Implicit { bias } => {
                        let [x, y, z] = coords.each_ref().map(|c| scene::quad_derivatives(c, lane));
                        let bias = bias.map_or(0.0, |b| f64::from(b[lane]));
                        let (dx, dy) = ([x[0], y[0], z[0]], [x[1], y[1], z[1]]);
                        Detail::Derivatives { dx, dy, bias }
                    }
                    Lod::Explicit(lambda) => Detail::Lambda(f64::from(lambda[lane])),
                    Lod::Gradient { dx, dy, .. } => {
                        let lane_of = |d: [&F32s; 3]| d.map(|d| f64::from(d[lane]));
                        Detail::Derivatives { dx: lane_of(dx), dy: lane_of(dy), bias: 0.0 }
                    }
                };
                let (layer, reference) = (f64::from(layer[lane]), f64::from(reference[lane]));
                let oracle = Oracle { image, sampler, layer, reference, offset };
                tally.check(&got, lane, oracle.sample(at, detail), &what);
            }
        }
    }
    tally
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]
    #[test]
    fn a_sample_is_what_the_formulas_give(
        shape in scene::shapes(),
        format in scene::formats(),
        width in 4..=SIDE,
        height in 4..=SIDE,
        sampler in scene::samplers(),
        seed in any::<u64>(),
    ) {
        let image = scene::image(shape, format, width, height, seed);
        let sampler = scene::for_shape(shape, sampler);
        let tally = check(&image, &sampler, seed);
        prop_assert!(tally.checked > tally.on_a_step, "too many points lie on a step");
    }
}

#[test]
fn images_of_one_texel_row_or_column_follow_the_formulas_too() {
    for (width, height) in [(1, 1), (1, 16), (16, 1), (3, 1)] {
        let image = scene::image(Shape::D2, Format::Rgba8, width, height, 5);
        let tally = check(&image, &Sampler::default(), u64::from(width));
        assert!(tally.checked > tally.on_a_step);
    }
}
