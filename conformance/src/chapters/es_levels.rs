//! The levels of immutable textures of OpenGL ES: base, maximum and clamps of λ.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::lod::{Filters, LevelRange, Levels, LodState, lambda, levels};
use crate::probe::{Dialect, ProbeError, filter_enum, min_filter_enum};
use crate::rng::Rng;
use gl_api::constants::*;

/// Levels.
pub const LEVELS: Check = Check {
    name: "es-levels",
    citation: "OpenGL ES 3.0, 3.8.10: base and maximum level of immutable textures are clamped; 3.8.9, \
               equations 3.14 and 3.21 to 3.23",
    what: "the level that a λ chooses under random GL_TEXTURE_BASE_LEVEL, MAX_LEVEL, MIN_LOD and \
           MAX_LOD, beyond what there is and in the wrong order among them",
    unit: Unit::Levels,
    tolerance: 1.0 / (1 << 21) as f64,
    why: "f32: λ + base and the mix of two numbers of levels, both below 8 where they are mixed, are rounded by 2^-22 each",
    run,
};

/// State of a texture.
#[derive(Clone, Copy, Debug)]
struct State {
    levels: usize,
    base: usize,
    max: usize,
    lod: [f32; 2],
    filters: Filters,
}

const SIDE: usize = 256;

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("es-levels");
    let rounds = harness.cases(96).max(24);
    let (mut clamped, mut mixed) = (0, 0);
    for round in 0..rounds {
        let pairs = Filters::all();
        let state = State {
            levels: [rng.integer(4, 9), rng.integer(1, 9)][round % 2] as usize,
            base: [rng.integer(0, 3), rng.integer(0, 10)][round % 2] as usize,
            max: [rng.integer(3, 10), rng.integer(0, 10)][round % 2] as usize,
            lod: match round % 3 {
                0 => [-1000.0, 1000.0],
                _ => [rng.dyadic(-2.0, 4.0, 0.125), rng.dyadic(1.0, 9.0, 0.125)],
            },
            filters: pairs[round * 5 / 2 % pairs.len()],
        };
        // A maximum below the minimum leaves λ undefined (equation 3.14).
        let state = State { lod: [state.lod[0], state.lod[0].max(state.lod[1])], ..state };
        clamped += usize::from(state.base >= state.levels || state.max < state.base);
        let cases: Vec<f32> = (0..harness.cases(128))
            .map(|_| {
                loop {
                    // Away from the middle between two levels, where either may be taken.
                    let x = rng.real(-4.0, 12.0);
                    if ((x + 0.5).rem_euclid(1.0) - 0.5).abs() < 0.49 && x.abs() > 0.01 {
                        break x;
                    }
                }
            })
            .collect();
        let of = |&x: &f32, variant: Variant| {
            let top = state.levels - 1;
            let unclamped = variant.has(Mutation::ImmutableLevelsUnclamped);
            let base = if unclamped { state.base.min(9) } else { state.base.min(top) };
            let last = if unclamped { state.max } else { state.max.clamp(base, top) };
            let lod = LodState {
                min_lod: state.lod[0].into(),
                max_lod: state.lod[1].into(),
                ..LodState::default()
            };
            let lambda = lambda(f64::from(x).exp2(), &lod, variant);
            levels(lambda, state.filters, LevelRange { base, last }, variant)
        };
        mixed +=
            cases.iter().filter(|x| matches!(of(x, Variant::CORRECT), Levels::Two(..))).count();
        let expect = |x: &f32, variant: Variant| {
            let level = match of(x, variant) {
                Levels::One(level, _) => level as f64,
                Levels::Two([a, b], weight, _) => (1.0 - weight) * a as f64 + weight * b as f64,
            };
            [level, 0.0, 0.0, 0.0]
        };
        harness.compare_with(Dialect::Es, tally, &state, &cases, expect, |session| {
            specify(&state);
            session.check("specifying an immutable texture")?;
            let inputs: Vec<_> = cases.iter().map(|&x| [[x, 0.0, 0.0, 0.0], [0.0; 4]]).collect();
            let body = "uniform sampler2D image;
                vec4 value(vec4 a, vec4 b) {
                    return vec4(textureLod(image, vec2(0.4, 0.6), a.x).x, 0.0, 0.0, 0.0);
                }";
            session.float_words(body, &inputs)
        })?;
    }
    tally.reach("textures whose levels are clamped", clamped, rounds / 8);
    tally.reach("lookups between two levels", mixed, rounds * harness.cases(128) / 32);
    Ok(())
}

/// Each level's texels are its number.
fn specify(state: &State) {
    let (target, mut name) = (GL_TEXTURE_2D, 0u32);
    glGenTextures(1, &mut name);
    glBindTexture(target, name);
    glTexStorage2D(target, state.levels, GL_R32F, SIDE, SIDE);
    for level in 0..state.levels {
        let side = SIDE >> level;
        let texels = vec![level as f32; side * side];
        glTexSubImage2D(target, level, 0, 0, side, side, GL_RED, GL_FLOAT, &texels);
    }
    for (parameter, value) in [
        (GL_TEXTURE_BASE_LEVEL, state.base as u32),
        (GL_TEXTURE_MAX_LEVEL, state.max as u32),
        (GL_TEXTURE_MIN_FILTER, min_filter_enum(state.filters)),
        (GL_TEXTURE_MAG_FILTER, filter_enum(state.filters.mag)),
    ] {
        glTexParameteri(target, parameter, value);
    }
    glTexParameterf(target, GL_TEXTURE_MIN_LOD, state.lod[0]);
    glTexParameterf(target, GL_TEXTURE_MAX_LOD, state.lod[1]);
}
