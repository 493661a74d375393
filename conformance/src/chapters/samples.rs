//! Multisampling: where samples lie, what a mask lets through, single samples in shaders, and resolves.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::samples::{POSITIONS, SAMPLES, masked, resolved, sample_position, shown};
use crate::probe::{Dialect, ProbeError, Session, Stages};
use crate::rng::Rng;
use gl_api::constants::*;

/// Positions and coverage.
pub const POSITION: Check = Check {
    name: "sample-position",
    citation: "GL 3.2, 3.3.1: GL_SAMPLE_POSITION; 3.6.1: a fragment covers the samples inside",
    what: "each sample of each pixel under random triangles, fetched, and the positions that are queried",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "a sample is covered or not; places on an edge are left out",
    run: position,
};

/// Masks.
pub const MASK: Check = Check {
    name: "sample-mask",
    citation: "GL 3.2, 4.1.3: GL_SAMPLE_MASK; ARB_texture_multisample: texelFetch",
    what: "each sample after draws under random masks, fetched",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers pass as they are",
    run: mask,
};

/// Resolves.
pub const RESOLVE: Check = Check {
    name: "sample-resolve",
    citation: "GL 3.2, 4.3.2: glBlitFramebuffer from samples to one",
    what: "the mean of four random colours of floats",
    unit: Unit::FullScale,
    tolerance: 5.0 / (1 << 24) as f64,
    why: "f32: sums up to 8, 12 and 16 are rounded by 2^-22, 2^-21 and 2^-21, a quarter of which is left in the mean",
    run: resolve,
};

const SIDE: usize = 32;

/// A sample: column, row, number.
type Case = [usize; 3];

fn all() -> Vec<Case> {
    let rows = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)));
    rows.flat_map(|(x, y)| (0..SAMPLES).map(move |sample| [x, y, sample])).collect()
}

/// A triangle over everything.
const WHOLE: [[f64; 2]; 3] = [[-1.0, -1.0], [99.0, -1.0], [-1.0, 99.0]];

/// Binds a framebuffer of a texture with four samples, which is bound too, and a program that draws `color`.
fn samples(session: &Session, internal: u32) -> Result<i32, ProbeError> {
    let fragment = if internal == GL_RGBA32F {
        "uniform vec4 color; out vec4 result; void main() { result = color; }"
    } else {
        "uniform uvec4 color; out uvec4 result; void main() { result = color; }"
    };
    let vertex = "layout(location = 0) in vec2 at;
        void main() { gl_Position = vec4(at / 16.0 - 1.0, 0.0, 1.0); }";
    let program = session.stages(&Stages { vertex, geometry: "", fragment })?;
    let (mut texture, mut framebuffer) = (0u32, 0u32);
    glGenTextures(1, &mut texture);
    glGenFramebuffers(1, &mut framebuffer);
    let target = GL_TEXTURE_2D_MULTISAMPLE;
    glBindTexture(target, texture);
    glTexImage2DMultisample(target, SAMPLES, internal, SIDE, SIDE, true);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, texture, 0);
    session.begin_frame([SIDE; 2])?;
    Ok(glGetUniformLocation(program, "color"))
}

/// Draws triangles, one after the other; `before` is called with the number of each.
fn triangles(
    session: &Session,
    triangles: &[[[f64; 2]; 3]],
    before: impl Fn(usize),
) -> Result<(), ProbeError> {
    let places: Vec<f32> =
        triangles.as_flattened().as_flattened().iter().map(|&c| c as f32).collect();
    session.float_array(0, 2, &places)?;
    for number in 0..triangles.len() {
        before(number);
        glDrawArrays(GL_TRIANGLES, 3 * number, 3);
    }
    session.check("drawing triangles")
}

/// The first component of each sample of the bound texture.
fn fetched(session: &Session, cases: &[Case]) -> Result<Vec<[f64; 4]>, ProbeError> {
    let inputs: Vec<_> = cases
        .iter()
        .map(|case| [[case[0], case[1], case[2], 0].map(|c| c as u32), [0; 4]])
        .collect();
    let body = "uniform usampler2DMS image;
        uvec4 value(uvec4 a, uvec4 b) { return texelFetch(image, ivec2(a.xy), int(a.z)); }";
    let words = session.words(body, &inputs)?;
    Ok(words.into_iter().map(|word| [word[0].into(), 0.0, 0.0, 0.0]).collect())
}

fn position(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let numbers: Vec<usize> = (0..SAMPLES).collect();
    let place = |&sample: &usize, variant: Variant| {
        let [x, y] = sample_position([0, 0], sample, variant);
        [x, y, 0.0, 0.0]
    };
    harness.compare_with(Dialect::Core, tally, &"positions", &numbers, place, |session| {
        samples(session, GL_RGBA32UI)?;
        let position = |sample: usize| {
            let mut at = [0.0f32; 2];
            glGetMultisamplefv(GL_SAMPLE_POSITION, sample, &mut at);
            [at[0].into(), at[1].into(), 0.0, 0.0]
        };
        let positions = (0..POSITIONS.len()).map(position).collect();
        session.check("querying the positions of samples")?;
        Ok(positions)
    })?;
    let mut rng = Rng::named("sample-position");
    for scene in 0..harness.cases(16) {
        // Small ones, and slivers, whose edges pass between the samples of many pixels.
        let drawn: Vec<[[f64; 2]; 3]> = (0..24)
            .map(|_| {
                let first = [0; 2].map(|_: i32| f64::from(rng.dyadic(0.0, 32.0, 1.0 / 64.0)));
                let reach = rng.pick(&[2.0, 6.0, 30.0]);
                let mut near =
                    || first.map(|c| c + f64::from(rng.dyadic(-reach, reach, 1.0 / 64.0)));
                [first, near(), near()]
            })
            .collect();
        let clear = |[x, y, sample]: &Case| shown(&drawn, [*x, *y], *sample, Variant::CORRECT);
        let cases: Vec<Case> = all().into_iter().filter(|case| clear(case).is_some()).collect();
        tally.reach(format!("scene {scene}, samples off edges"), cases.len(), all().len() * 9 / 10);
        let partly = (0..SIDE * SIDE).filter(|pixel| {
            let of = |sample| clear(&[pixel % SIDE, pixel / SIDE, sample]);
            (1..SAMPLES).any(|sample| of(sample) != of(0))
        });
        tally.reach(
            format!("scene {scene}, pixels partly covered"),
            partly.count(),
            SIDE * SIDE / 10,
        );
        let expect = |&[x, y, sample]: &Case, variant: Variant| {
            let number = shown(&drawn, [x, y], sample, variant).unwrap_or(0);
            [number as f64, 0.0, 0.0, 0.0]
        };
        harness.compare_with(Dialect::Core, tally, &scene, &cases, expect, |session| {
            let color = samples(session, GL_RGBA32UI)?;
            triangles(session, &drawn, |number| glUniform4ui(color, number + 1, 0, 0, 0))?;
            fetched(session, &cases)
        })?;
    }
    Ok(())
}

fn mask(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("sample-mask");
    for _ in 0..harness.cases(16) {
        let masks: Vec<u32> = (0..6).map(|_| rng.integer(0, 15) as u32).collect();
        let cases: Vec<Case> = all().into_iter().step_by(5).collect();
        let expect = |&[_, _, sample]: &Case, variant: Variant| {
            let over = (1..).zip(&masks).filter(|(_, mask)| masked(**mask, sample, variant)).last();
            [over.map_or(0.0, |(number, _)| f64::from(number)), 0.0, 0.0, 0.0]
        };
        harness.compare_with(Dialect::Core, tally, &masks, &cases, expect, |session| {
            let color = samples(session, GL_RGBA32UI)?;
            glEnable(GL_SAMPLE_MASK);
            triangles(session, &vec![WHOLE; masks.len()], |number| {
                glSampleMaski(0, masks[number]);
                glUniform4ui(color, number + 1, 0, 0, 0);
            })?;
            glDisable(GL_SAMPLE_MASK);
            fetched(session, &cases)
        })?;
        let drawn = (0..SAMPLES).filter(|s| masks.iter().any(|m| m >> s & 1 == 1)).count();
        tally.reach("samples that some mask lets through", drawn, 2);
    }
    Ok(())
}

fn resolve(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("sample-resolve");
    for _ in 0..harness.cases(32) {
        let colors = [0; SAMPLES].map(|_| [0; 4].map(|_: i32| rng.real(-4.0, 4.0)));
        let cases: Vec<usize> = (0..SIDE * SIDE).collect();
        let expect = |_: &usize, variant: Variant| {
            resolved(colors.map(|color| color.map(f64::from)), variant)
        };
        harness.compare_with(Dialect::Core, tally, &colors, &cases, expect, |session| {
            let color = samples(session, GL_RGBA32F)?;
            let mut source = [0i32; 1];
            glGetIntegerv(GL_FRAMEBUFFER_BINDING, &mut source);
            glEnable(GL_SAMPLE_MASK);
            triangles(session, &[WHOLE; SAMPLES], |sample| {
                glSampleMaski(0, 1 << sample);
                let [r, g, b, a] = colors[sample];
                glUniform4f(color, r, g, b, a);
            })?;
            session.frame(GL_RGBA32F, [SIDE; 2], 0)?;
            glBindFramebuffer(GL_READ_FRAMEBUFFER, source[0]);
            let (s, mask) = (SIDE, GL_COLOR_BUFFER_BIT);
            glBlitFramebuffer(0, 0, s, s, 0, 0, s, s, mask, GL_NEAREST);
            let mut target = [0i32; 1];
            glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &mut target);
            glBindFramebuffer(GL_READ_FRAMEBUFFER, target[0]);
            session.read_floats([SIDE; 2])
        })?;
        let distinct = (1..SAMPLES).filter(|&sample| colors[sample] != colors[0]).count();
        tally.reach("samples unlike the first", distinct, SAMPLES - 1);
    }
    Ok(())
}
