//! Lookups with an offset in texels and an explicit level or derivatives.

use super::lod::Footprint;
use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::{Mutation, Variant};
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{self, Filter, Filters, LevelRange, LodState, Mipmap};
use crate::oracle::sample::{self, Sampler};
use crate::oracle::texture::{Level, level_count, level_size};
use crate::oracle::wrap::Wrap;
use crate::probe::{Dialect, ProbeError};
use crate::rng::Rng;

/// Level and offset.
pub const LOD: Check = Check {
    name: "lookup-lod-offset",
    citation: "GLSL 3.30, 8.7: textureLodOffset, textureProjLodOffset; GL 3.3, 3.8.11",
    what: "offsets of -8 to 7 texels of the levels that a λ chooses, also with coordinates that are divided",
    unit: Unit::FullScale,
    tolerance: 3.5 / (1 << 24) as f64,
    why: "f32: λ and the coordinates, scaled by powers of two, are exact; the mix of four texels of two levels is \
          rounded twelve times by 2^-25: twice the root of the sum of their squares is 3.5 · 2^-24",
    run: |harness, tally| run(harness, tally, LookupForm::Lod),
};

/// Derivatives and offset.
pub const GRAD: Check = Check {
    name: "lookup-grad-offset",
    citation: "GLSL 3.30, 8.7: textureGradOffset; GL 3.3, 3.8.11",
    what: "offsets of -8 to 7 texels of the levels that random derivatives choose",
    unit: Unit::FullScale,
    tolerance: 7.0 / (1 << 24) as f64,
    why: "f32: ρ and λ, below 8, are rounded by 2^-22, times a difference of filtered texels of 1/2; the mix of four \
          texels of two levels twelve times by 2^-25: twice the root of the sum of squares is 6.6 · 2^-24",
    run: |harness, tally| run(harness, tally, LookupForm::Grad),
};

/// How a lookup specifies λ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LookupForm {
    Lod,
    Grad,
}

fn run(harness: &Harness, tally: &mut Tally, form: LookupForm) -> Result<(), ProbeError> {
    let mut rng = Rng::named("lookup-offset");
    let size = [64, 32];
    let top = level_count(size) - 1;
    let image: Vec<Level> = (0..=top)
        .map(|l| {
            let [w, h] = level_size(size, l);
            Level::from_fn(w, h, |_, _| [0; 4].map(|_: u8| rng.byte()))
        })
        .collect();
    let sampler = Sampler {
        at: Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] },
        filters: Filters { min: Filter::Linear, mipmap: Mipmap::Linear, mag: Filter::Linear },
        lod: LodState::default(),
        range: LevelRange { base: 0, last: top },
    };
    for _ in 0..harness.cases(8).max(2) {
        let offset = [0; 2].map(|_: i32| rng.pick(&[-8, -7, -3, -1, 1, 2, 5, 7]));
        let cases: Vec<Footprint> = (0..harness.cases(2048))
            .map(|_| Footprint {
                bias: rng.real(-1.0, 7.0),
                ..Footprint::random(&mut rng, size, 0.0)
            })
            .collect();
        // Under GL_REPEAT an offset of texels is the same as an image that is moved by it.
        let moved = |by: &dyn Fn(usize) -> [i64; 2]| -> Vec<Level> {
            let level = |number: usize, level: &Level| {
                let (w, h) = (level.width as i64, level.height as i64);
                let [dx, dy] = by(number);
                Level::from_fn(level.width, level.height, |i, j| {
                    let (i, j) = ((i as i64 + dx).rem_euclid(w), (j as i64 + dy).rem_euclid(h));
                    level.texels[(j * w + i) as usize]
                })
            };
            image.iter().enumerate().map(|(number, of)| level(number, of)).collect()
        };
        let images =
            [moved(&|_| offset), moved(&|_| [0; 2]), moved(&|number| offset.map(|d| d >> number))];
        let expect = |case: &Footprint, variant: Variant| {
            let image = if variant.has(Mutation::OffsetIgnored) {
                &images[1]
            } else if variant.has(Mutation::OffsetOfBaseLevel) {
                &images[2]
            } else {
                &images[0]
            };
            let st = case.st.map(f64::from);
            match form {
                LookupForm::Lod => {
                    let lambda = lod::lambda(f64::from(case.bias).exp2(), &sampler.lod, variant);
                    sample::at_lambda(image, &sampler, st, lambda, variant)
                }
                LookupForm::Grad => {
                    sample::sample(image, &sampler, st, &case.derivatives(), variant)
                }
            }
        };
        let scene = (form, offset);
        harness.compare_with(Dialect::Compatibility, tally, &scene, &cases, expect, |session| {
            session.texture_2d(&image, &sampler)?;
            let inputs: Vec<_> = cases
                .iter()
                .map(|case| {
                    let [a, b, c] = case.inputs();
                    [[a[0], a[1], c[0], 0.0], b]
                })
                .collect();
            let [x, y] = offset;
            let lookup = match form {
                LookupForm::Lod => format!(
                    "fract(a.x * 64.0) < 0.5
                         ? textureLodOffset(image, a.xy, a.z, ivec2({x}, {y}))
                         : textureProjLodOffset(image, vec3(a.xy, 1.0) * 4.0, a.z, ivec2({x}, {y}))"
                ),
                LookupForm::Grad => {
                    format!("textureGradOffset(image, a.xy, b.xy, b.zw, ivec2({x}, {y}))")
                }
            };
            let body = format!(
                "uniform sampler2D image; vec4 value(vec4 a, vec4 b) {{ return {lookup}; }}"
            );
            session.float_words(&body, &inputs)
        })?;
        let minified = cases.iter().filter(|case| case.bias > 0.0).count();
        tally.reach("lookups below the base level", minified, cases.len() / 2);
    }
    Ok(())
}
