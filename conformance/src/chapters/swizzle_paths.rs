//! Swizzles of texels that are fetched, gathered, compared, or the border.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::swizzle::{Path, Source, swizzled};
use crate::probe::{Dialect, ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Swizzles.
pub const PATHS: Check = Check {
    name: "swizzle-paths",
    citation: "GL 3.3, 3.8.16; ARB_texture_gather",
    what: "random swizzles in texelFetch, textureGather, lookups of the border and comparisons",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "texels are floats and come back as they are",
    run,
};

const SIDE: usize = 8;
const BORDER: [f32; 4] = [0.25, -3.0, 7.5, 0.625];
/// What the depths, 0 to 7 eighths, are compared with.
const REFERENCE: f32 = 0.4375;

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("swizzle-paths");
    let texels: Vec<[f32; 4]> =
        (0..SIDE * SIDE).map(|_| [0; 4].map(|_: i32| rng.real(-4.0, 4.0))).collect();
    let depths: Vec<f32> = (0..SIDE * SIDE).map(|i| (i * 5 % 8) as f32 / 8.0).collect();
    for path in Path::ALL {
        let mut named = 0;
        let rounds = harness.cases(32).max(4);
        for _ in 0..rounds {
            let sources = [0; 4].map(|_: i32| match path {
                // A comparison is all of red, green and blue in one profile, red alone in the other.
                Path::Shadow => rng.pick(&[Source::Red, Source::Alpha, Source::Zero, Source::One]),
                Path::Fetch | Path::Gather | Path::Border => rng.pick(&Source::ALL),
            });
            named += usize::from(sources[0] != Source::Red);
            let cases: Vec<[usize; 2]> =
                (0..SIDE - 1).flat_map(|y| (0..SIDE - 1).map(move |x| [x, y])).collect();
            let expect = |&[x, y]: &[usize; 2], variant: Variant| {
                let texel = |x: usize, y: usize| {
                    swizzled(path, sources, texels[y * SIDE + x].map(f64::from), variant)
                };
                match path {
                    Path::Fetch => texel(x, y),
                    Path::Gather => [[x, y + 1], [x + 1, y + 1], [x + 1, y], [x, y]]
                        .map(|[x, y]| texel(x, y)[0]),
                    Path::Border => swizzled(path, sources, BORDER.map(f64::from), variant),
                    Path::Shadow => {
                        let passes = f64::from(u8::from(REFERENCE <= depths[y * SIDE + x]));
                        let compared = swizzled(path, sources, [passes, 0.0, 0.0, 1.0], variant);
                        [compared[0], 0.0, 0.0, 0.0]
                    }
                }
            };
            let scene = (path, sources);
            harness.compare_with(Dialect::Core, tally, &scene, &cases, expect, |session| {
                bind(session, path, sources, &texels, &depths)?;
                let inputs: Vec<_> = cases
                    .iter()
                    .map(|&[x, y]| [[x as f32, y as f32, REFERENCE, 0.0], [0.0; 4]])
                    .collect();
                session.float_words(body(path), &inputs)
            })?;
        }
        tally.reach(format!("{path:?}, swizzles of the first component"), named, rounds / 2);
    }
    Ok(())
}

fn body(path: Path) -> &'static str {
    match path {
        Path::Fetch => {
            "uniform sampler2D image;
             vec4 value(vec4 a, vec4 b) { return texelFetch(image, ivec2(a.xy), 0); }"
        }
        Path::Gather => {
            "uniform sampler2D image;
             vec4 value(vec4 a, vec4 b) { return textureGather(image, (a.xy + 1.0) / 8.0); }"
        }
        Path::Border => {
            "uniform sampler2D image;
             vec4 value(vec4 a, vec4 b) { return textureLod(image, a.xy / 8.0 + 1.25, 0.0); }"
        }
        Path::Shadow => {
            "uniform sampler2DShadow image;
             vec4 value(vec4 a, vec4 b) {
                 return vec4(textureLod(image, vec3((a.xy + 0.5) / 8.0, a.z), 0.0), 0.0, 0.0, 0.0);
             }"
        }
    }
}

fn bind(
    session: &Session,
    path: Path,
    sources: [Source; 4],
    texels: &[[f32; 4]],
    depths: &[f32],
) -> Result<(), ProbeError> {
    let (target, mut name) = (GL_TEXTURE_2D, 0u32);
    glGenTextures(1, &mut name);
    glBindTexture(target, name);
    match path {
        Path::Fetch | Path::Gather | Path::Border => {
            let texels = texels.as_flattened();
            glTexImage2D(target, 0, GL_RGBA32F, SIDE, SIDE, 0, GL_RGBA, GL_FLOAT, texels);
        }
        Path::Shadow => {
            let (internal, format) = (GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
            glTexImage2D(target, 0, internal, SIDE, SIDE, 0, format, GL_FLOAT, depths);
            glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        }
    }
    for (place, source) in (GL_TEXTURE_SWIZZLE_R..).zip(sources) {
        let value = match source {
            Source::Red => GL_RED,
            Source::Green => GL_GREEN,
            Source::Blue => GL_BLUE,
            Source::Alpha => GL_ALPHA,
            Source::Zero => GL_ZERO,
            Source::One => GL_ONE,
        };
        glTexParameteri(target, place, value);
    }
    for (name, value) in [
        (GL_TEXTURE_MIN_FILTER, GL_NEAREST),
        (GL_TEXTURE_MAG_FILTER, GL_NEAREST),
        (GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER),
        (GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER),
    ] {
        glTexParameteri(target, name, value);
    }
    glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, &BORDER);
    session.check("specifying a texture with a swizzle")
}
