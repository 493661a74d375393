//! Texture state that applies after the filter: `GL_DEPTH_TEXTURE_MODE`, swizzles, and percentage-closer
//! filtering.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::{Mutation, Variant};
use crate::oracle::compare::Compare;
use crate::oracle::lod::Filter;
use crate::probe::{DepthTexture, ProbeError, TexelRow};
use crate::rng::Rng;
use gl_api::constants::*;

/// Depth as a colour.
pub const DEPTH_MODE: Check = Check {
    name: "depth-mode",
    citation: "GL 2.1, 3.8.14 and table 3.20: GL_DEPTH_TEXTURE_MODE",
    what: "(D, D, D, 1), (D, D, D, D) or (0, 0, 0, D) of depth texels that are not compared",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "depths are stored as f32, as they are given",
    run: depth_mode,
};

/// Components in another order.
pub const SWIZZLE: Check = Check {
    name: "swizzle",
    citation: "EXT_texture_swizzle, 3.8.8",
    what: "random choices of red, green, blue, alpha, 0 and 1 for each component",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "texels are floats and come back as they are",
    run: swizzle,
};

/// Percentage-closer filtering.
pub const COMPARE_LINEAR: Check = Check {
    name: "shadow-linear",
    citation: "GL 2.1, 3.8.14: the comparison before GL_LINEAR's weights",
    what: "weighted share of the texels that pass, of the 8 comparisons",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "coordinates are dyadic, so that weights are exact, and so are sums of them",
    run: compare_linear,
};

const WIDTH: usize = 256;

/// The coordinate of the centre of a texel of a row.
fn centre(i: usize) -> [[f32; 4]; 3] {
    [[(i as f32 + 0.5) / WIDTH as f32, 0.5, 0.0, 1.0], [0.0; 4], [0.0; 4]]
}

const BODY: &str = "uniform sampler2D image; vec4 value() { return texture2D(image, a.xy); }";

fn depth_mode(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("depth-mode");
    let texels: Vec<[f32; 4]> =
        (0..WIDTH).map(|_| [rng.integer(0, 65535) as f32 / 65535.0, 0.0, 0.0, 0.0]).collect();
    for mode in [GL_LUMINANCE, GL_INTENSITY, GL_ALPHA] {
        let cases: Vec<usize> = (0..harness.cases(WIDTH)).collect();
        let expect = |&case: &usize, variant: Variant| {
            let d = f64::from(texels[case][0]);
            let mode = if variant.has(Mutation::DepthModeIgnored) { GL_LUMINANCE } else { mode };
            match mode {
                GL_LUMINANCE => [d, d, d, 1.0],
                GL_INTENSITY => [d; 4],
                _ => [0.0, 0.0, 0.0, d],
            }
        };
        harness.compare(tally, &enum_name(mode), &cases, expect, |session| {
            let internal = GL_DEPTH_COMPONENT16;
            session.texel_row(&TexelRow { internal, is_depth: true, texels: &texels })?;
            session.parameters(&[(GL_DEPTH_TEXTURE_MODE, mode)])?;
            let inputs: Vec<_> = cases.iter().map(|&i| centre(i)).collect();
            session.field(BODY, 4, &inputs)
        })?;
    }
    Ok(())
}

fn swizzle(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    const NAMES: [u32; 6] = [GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_ZERO, GL_ONE];
    const PLACES: [u32; 4] =
        [GL_TEXTURE_SWIZZLE_R, GL_TEXTURE_SWIZZLE_G, GL_TEXTURE_SWIZZLE_B, GL_TEXTURE_SWIZZLE_A];
    let mut rng = Rng::named("swizzle");
    let texels: Vec<[f32; 4]> =
        (0..WIDTH).map(|_| [0; 4].map(|_: i32| rng.real(-4.0, 4.0))).collect();
    for _ in 0..harness.cases(64).max(8) {
        let sources = [0; 4].map(|_: i32| rng.integer(0, 5) as usize);
        let cases: Vec<usize> =
            (0..32).map(|_| rng.integer(0, WIDTH as i64 - 1) as usize).collect();
        let expect = |&case: &usize, variant: Variant| {
            let texel = texels[case].map(f64::from);
            let all = [texel[0], texel[1], texel[2], texel[3], 0.0, 1.0];
            if variant.has(Mutation::SwizzleInverted) {
                // The texel's component becomes the component that the swizzle names.
                let mut out = texel;
                for (from, &to) in sources.iter().enumerate().filter(|(_, to)| **to < 4) {
                    out[to] = texel[from];
                }
                return out;
            }
            sources.map(|source| all[source])
        };
        harness.compare(tally, &sources, &cases, expect, |session| {
            session.texel_row(&TexelRow {
                internal: GL_RGBA32F,
                is_depth: false,
                texels: &texels,
            })?;
            let parameters = [0, 1, 2, 3].map(|i: usize| (PLACES[i], NAMES[sources[i]]));
            session.parameters(&parameters)?;
            let inputs: Vec<_> = cases.iter().map(|&i| centre(i)).collect();
            session.field(BODY, 4, &inputs)
        })?;
    }
    Ok(())
}

fn compare_linear(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("shadow-linear");
    let row: Vec<u16> = (0..WIDTH).map(|_| rng.integer(1000, 64000) as u16).collect();
    for compare in Compare::ALL {
        let cases: Vec<[f32; 2]> = (0..harness.cases(2048))
            .map(|_| {
                let r = (rng.integer(1000, 64000) as f32 + 0.5) / 65535.0;
                [rng.real(0.01, 0.99), r]
            })
            .collect();
        let expect = |&[s, r]: &[f32; 2], variant: Variant| {
            let u = f64::from(s) * WIDTH as f64 - 0.5;
            let (i, alpha) = (u.floor() as usize, u - u.floor());
            let depth = |i: usize| f64::from(row[i]) / 65535.0;
            let passes = |d: f64| f64::from(u8::from(compare.holds(f64::from(r), d, variant)));
            let share = if variant.has(Mutation::ComparedAfterFilter) {
                passes((1.0 - alpha) * depth(i) + alpha * depth(i + 1))
            } else {
                (1.0 - alpha) * passes(depth(i)) + alpha * passes(depth(i + 1))
            };
            [share, 0.0, 0.0, 0.0]
        };
        harness.compare(tally, &compare, &cases, expect, |session| {
            session.depth_texture(&DepthTexture { compare, filter: Filter::Linear, row: &row })?;
            let inputs: Vec<_> =
                cases.iter().map(|&[s, r]| [[s, 0.5, r, 1.0], [0.0; 4], [0.0; 4]]).collect();
            let body = "uniform sampler2DShadow image;\
                        vec4 value() { return shadow2D(image, a.xyz); }";
            session.field(body, 1, &inputs)
        })?;
    }
    Ok(())
}
