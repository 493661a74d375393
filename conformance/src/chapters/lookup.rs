//! Texture lookups of GLSL with explicit level of detail.

use super::lod::Footprint;
use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::{Mutation, Variant};
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{self, Filter, Filters, LevelRange, LodState, Mipmap};
use crate::oracle::sample::{self, Sampler};
use crate::oracle::texture::{Level, level_count, level_size};
use crate::oracle::wrap::Wrap;
use crate::probe::ProbeError;
use crate::rng::Rng;

/// λ from the shader.
pub const LOD: Check = Check {
    name: "lookup-lod",
    citation: "GLSL 1.30, 8.7: textureLod; GL 2.1, 3.8.8",
    what: "texture2DLod with λ below, within and above the levels, clamped by the sampler",
    unit: Unit::FullScale,
    tolerance: 5.0 / (1 << 24) as f64,
    why: "f32: λ is exact; bilinear twice and their mix: eight roundings of 2^-25, and an ulp of a coordinate",
    run: |harness, tally| run(harness, tally, LookupForm::Lod),
};

/// ρ from the shader.
pub const GRAD: Check = Check {
    name: "lookup-grad",
    citation: "GLSL 1.30, 8.7: textureGrad; GL 2.1, 3.8.8",
    what: "texture2DGradARB with random derivatives",
    unit: Unit::FullScale,
    tolerance: 8.0 / (1 << 24) as f64,
    why: "f32: as with a λ that is given, and half an ulp of λ below 4: 2^-23, times a difference of texels up to 1",
    run: |harness, tally| run(harness, tally, LookupForm::Grad),
};

/// How a lookup specifies λ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LookupForm {
    Lod,
    Grad,
}

/// A footprint, and λ in place of its bias.
type Case = Footprint;

fn run(harness: &Harness, tally: &mut Tally, form: LookupForm) -> Result<(), ProbeError> {
    let mut rng = Rng::named("lookup");
    let size = [64, 32];
    let top = level_count(size) - 1;
    let image: Vec<Level> = (0..=top)
        .map(|l| {
            let [w, h] = level_size(size, l);
            Level::from_fn(w, h, |_, _| [0; 4].map(|_: u8| rng.byte()))
        })
        .collect();
    let plain = LodState::default();
    for state in [plain, LodState { min_lod: 1.5, max_lod: 4.25, object_bias: 0.5, ..plain }] {
        let sampler = Sampler {
            at: Addressing { wrap: [Wrap::MirroredRepeat, Wrap::Repeat], border: [0.0; 4] },
            filters: Filters { min: Filter::Linear, mipmap: Mipmap::Linear, mag: Filter::Linear },
            lod: state,
            range: LevelRange { base: 0, last: top },
        };
        let cases: Vec<Case> = (0..harness.cases(4096))
            .map(|_| Footprint {
                bias: rng.real(-3.0, 8.0),
                ..Footprint::random(&mut rng, size, 0.0)
            })
            .collect();
        let expect = |case: &Case, variant: Variant| {
            let st = case.st.map(f64::from);
            match form {
                LookupForm::Lod => {
                    let given = if variant.has(Mutation::ExplicitLodIgnored) {
                        0.0
                    } else {
                        f64::from(case.bias)
                    };
                    let lambda = lod::lambda(given.exp2(), &state, variant);
                    sample::at_lambda(&image, &sampler, st, lambda, variant)
                }
                LookupForm::Grad => {
                    sample::sample(&image, &sampler, st, &case.derivatives(), variant)
                }
            }
        };
        harness.compare(tally, &state, &cases, expect, |session| {
            session.texture_2d(&image, &sampler)?;
            let inputs: Vec<_> = cases.iter().map(Footprint::inputs).collect();
            let body = match form {
                LookupForm::Lod => {
                    "uniform sampler2D image;
                     vec4 value() { return texture2DLod(image, a.xy, c.x); }"
                }
                LookupForm::Grad => {
                    "uniform sampler2D image;
                     vec4 value() { return texture2DGradARB(image, a.xy, b.xy, b.zw); }"
                }
            };
            session.field(body, 4, &inputs)
        })?;
    }
    Ok(())
}
