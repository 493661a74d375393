//! The same bits on every instruction set, whatever the bits of the coordinates.

use crate::scene::{self, Random};
use proptest::prelude::*;
use texunit::lanes::{F32s, Isa, LANES};
use texunit::plan::SamplePlan;
use texunit::sample::{Addresses, Lod, LookupScratch, Points};

/// Bits that no range of coordinates leaves out.
fn anything(random: &mut Random) -> F32s {
    F32s::from_fn(|_| match random.bits() % 8 {
        0 => f32::from_bits(random.bits() as u32),
        1 => f32::NAN,
        2 => f32::INFINITY,
        3 => f32::NEG_INFINITY,
        4 => random.within(-1e7, 1e7),
        _ => random.within(-2.0, 2.0),
    })
}

/// Bits, with every NaN alike.
fn bits(x: f32) -> u32 {
    if x.is_nan() { f32::NAN.to_bits() } else { x.to_bits() }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn all_instruction_sets_give_the_same_bits(
        shape in scene::shapes(),
        format in scene::formats(),
        width in 4..40_u32,
        height in 4..40_u32,
        sampler in scene::samplers(),
        seed in any::<u64>(),
    ) {
        let image = scene::image(shape, format, width, height, seed);
        let plan = SamplePlan::new(&image, &scene::for_shape(shape, sampler));
        let mut random = Random(seed);
        for round in 0..3 {
            let coords = match round {
                0 => [(); 3].map(|()| anything(&mut random)),
                _ => scene::block(&mut random, 0.05),
            };
            let [layer, reference] = [(); 2].map(|()| anything(&mut random));
            let bias = anything(&mut random);
            let points = Points {
                coords: coords.each_ref(),
                layer: Some(&layer),
                reference: Some(&reference),
            };
            let gather = |isa| {
                let mut out = [F32s::ZERO; 4];
                plan.gather(isa, points, [-32, 31], &mut out);
                out.map(|texels| texels.0.map(bits))
            };
            if shape.axes() == 2 {
                let want = gather(Isa::BASELINE);
                for isa in Isa::available() {
                    prop_assert_eq!(gather(isa), want, "{} {}", isa.name(), plan.describe());
                }
            }
            let lods =
                [Lod::Implicit { bias: None }, Lod::Implicit { bias: Some(&bias) }, Lod::Explicit(&bias)];
            for lod in lods {
                let sample = |isa| {
                    let mut room = LookupScratch::default();
                    plan.sample_offset(isa, points, [0; 3], lod, Addresses::Compute, &mut room);
                    room.lanes
                };
                let want = sample(Isa::BASELINE);
                for isa in Isa::available() {
                    let got = sample(isa);
                    for c in 0..4 {
                        for lane in 0..LANES {
                            let [got, want] = [got[c][lane], want[c][lane]];
                            prop_assert_eq!(
                                bits(got), bits(want), "{} {}: {} for {}",
                                isa.name(), plan.describe(), got, want
                            );
                        }
                    }
                }
            }
        }
    }
}
