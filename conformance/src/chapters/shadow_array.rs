//! Comparisons with a layer of an array of depths.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::{Mutation, Variant};
use crate::oracle::compare::Compare;
use crate::oracle::lod::Filter;
use crate::oracle::mipmap::Volume;
use crate::oracle::target::{Target, Texture};
use crate::oracle::wrap::Wrap;
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// `sampler1DArrayShadow` and `sampler2DArrayShadow`.
pub const COMPARE: Check = Check {
    name: "shadow-array",
    citation: "GLSL 1.30, 8.7: texture of sampler1DArrayShadow, sampler2DArrayShadow; GL 2.1, 3.8.14",
    what: "the share of a layer's texels that pass, nearest and linear, of the 8 comparisons, under \
           every GL_DEPTH_TEXTURE_MODE",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 24) as f64,
    why: "f32: comparisons are 0 or 1; coordinates are exact in 2^-23 of 8 texels, and the mean of four is rounded once",
    run,
};

/// s, t, the layer and the reference.
type Case = [f32; 4];

const MODES: [u32; 4] = [GL_LUMINANCE, GL_INTENSITY, GL_ALPHA, GL_RED];

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("shadow-array");
    for (target, size) in [(Target::D1Array, [8, 5, 1]), (Target::D2Array, [8, 4, 3])] {
        for (round, compare) in Compare::ALL.into_iter().enumerate() {
            let filter = [Filter::Linear, Filter::Nearest][round % 2];
            let mode = MODES[round / 2];
            let texture = depths(&mut rng, target, size, filter);
            let cases: Vec<Case> =
                (0..harness.cases(512)).map(|_| case(&mut rng, target, size)).collect();
            let expect = |case: &Case, variant: Variant| {
                let [s, t, layer, reference] = case.map(f64::from);
                let at = if target.axes() == 1 { [s, layer, 0.0] } else { [s, t, layer] };
                let passes = |d: f64| f64::from(u8::from(compare.holds(reference, d, variant)));
                let share = if variant.has(Mutation::ComparedAfterFilter) {
                    passes(texture.sample(at, [0; 3], variant)[0])
                } else {
                    let mut compared = texture.clone();
                    for texel in &mut compared.texels.texels {
                        *texel = [passes(texel[0]); 4];
                    }
                    compared.sample(at, [0; 3], variant)[0]
                };
                let lost = variant.has(Mutation::ComparisonPlaced) && mode == GL_ALPHA;
                [if lost { 0.0 } else { share }, 0.0, 0.0, 0.0]
            };
            let scene = (target, compare, filter, enum_name(mode));
            harness.compare(tally, &scene, &cases, expect, |session| {
                session.depth_array(&texture, compare, mode)?;
                let inputs: Vec<_> = cases.iter().map(|&c| [c, [0.0; 4], [0.0; 4]]).collect();
                let (sampler, at) = if target.axes() == 1 {
                    ("sampler1DArrayShadow", "a.xzw")
                } else {
                    ("sampler2DArrayShadow", "a")
                };
                let body = format!(
                    "uniform {sampler} image; vec4 value() {{ return vec4(texture(image, {at})); }}"
                );
                session.field(&body, 1, &inputs)
            })?;
        }
    }
    Ok(())
}

fn depths(rng: &mut Rng, target: Target, size: [usize; 3], filter: Filter) -> Texture {
    let count = size.iter().product();
    // Few enough values that references lie between them.
    let texels = (0..count).map(|_| [rng.integer(0, 8) as f64 / 8.0; 4]).collect();
    Texture {
        target,
        size,
        border: 0,
        texels: Volume { size, texels },
        wrap: [Wrap::ClampToEdge; 3],
        border_color: [0.0; 4],
        filter,
    }
}

/// Layers away from the middle between two integers, coordinates away from texel edges, references equal to
/// texels and between them.
fn case(rng: &mut Rng, target: Target, size: [usize; 3]) -> Case {
    let mut inside = |n: usize| {
        let texel = rng.integer(0, n as i64 - 1) as f64;
        ((texel + f64::from(rng.real(0.01, 0.99))) / n as f64) as f32
    };
    let (s, t) = (inside(size[0]), inside(size[1]));
    let layers = if target == Target::D1Array { size[1] } else { size[2] };
    let layer = rng.integer(-1, layers as i64) as f32 + rng.real(-0.45, 0.45);
    [s, t, layer, rng.integer(0, 16) as f32 / 16.0]
}
