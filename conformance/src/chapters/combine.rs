//! Texture environment combiners and fog, in floats.

use crate::check::{self, Check, Harness, Tally};
use crate::gl::{glColor4f, glFogCoordf, glMultiTexCoord2f, glVertex4f};
use crate::mutation::Variant;
use crate::oracle::combine::{Combiner, Fog, Function, Operand, Source, Unit, combine};
use crate::probe::ProbeError;
use crate::rng::Rng;

/// `GL_COMBINE`.
pub const COMBINE: Check = Check {
    name: "combine",
    citation: "GL 2.1, 3.8.13, tables 3.24 and 3.25; ARB_texture_env_crossbar",
    what: "random functions, sources, operands and scales of 1 to 3 units, into a float target",
    unit: check::Unit::FullScale,
    tolerance: 1.0 / (1 << 19) as f64,
    why: "f32: a few roundings of 2^-24 a unit, times scales of 4",
    run: combiners,
};

/// Fog.
pub const FOG: Check = Check {
    name: "fog",
    citation: "GL 2.1, 3.10: f·Cr + (1 - f)·Cf",
    what: "linear, exponential and squared exponential fog by glFogCoord, into a float target",
    unit: check::Unit::FullScale,
    tolerance: 2.5 / (1 << 24) as f64,
    why: "f32: x · e^-x is at most 1/e, so the exponent's two roundings add half a unit of 2^-24; the factor and the mix one each",
    run: fog,
};

/// The primary colour, and the texel of each unit.
type Case = ([f32; 4], [[f32; 4]; 3]);

fn random(rng: &mut Rng) -> [f32; 4] {
    [0; 4].map(|_: i32| rng.real(0.0, 1.0))
}

fn combiner(rng: &mut Rng, units: usize, is_alpha: bool) -> Combiner {
    let functions = if is_alpha { &Function::ALL[..6] } else { &Function::ALL[..] };
    let arguments = [0; 3].map(|_: i32| {
        let source = rng.pick(&[
            Source::Texture,
            Source::TextureOf(rng.clone().integer(0, units as i64 - 1) as usize),
            Source::Constant,
            Source::Primary,
            Source::Previous,
        ]);
        let operands =
            [Operand::Alpha, Operand::OneMinusAlpha, Operand::Color, Operand::OneMinusColor];
        (source, rng.pick(if is_alpha { &operands[..2] } else { &operands[..] }))
    });
    Combiner { function: rng.pick(functions), arguments, scale: rng.pick(&[1.0, 2.0, 4.0]) }
}

fn combiners(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("combine");
    for round in 0..harness.cases(256).max(32) {
        let count = round % 3 + 1;
        let units: Vec<Unit> = (0..count)
            .map(|_| Unit {
                color: combiner(&mut rng, count, false),
                alpha: combiner(&mut rng, count, true),
                constant: random(&mut rng).map(f64::from),
            })
            .collect();
        let cases: Vec<Case> =
            (0..32).map(|_| (random(&mut rng), [0; 3].map(|_: i32| random(&mut rng)))).collect();
        let expect = |(color, texels): &Case, variant: Variant| {
            let texels = texels.map(|texel| texel.map(f64::from));
            combine(&units, &texels, color.map(f64::from), variant)
        };
        harness.compare(tally, &units, &cases, expect, |session| {
            session.float_target()?;
            let rows: Vec<Vec<[f32; 4]>> =
                (0..count).map(|unit| cases.iter().map(|case| case.1[unit]).collect()).collect();
            session.combiners(&units, &rows)?;
            let point = |k: usize| {
                let [r, g, b, a] = cases[k].0;
                glColor4f(r, g, b, a);
                for unit in 0..count as u32 {
                    let s = (k as f32 + 0.5) / cases.len() as f32;
                    glMultiTexCoord2f(gl_api::constants::GL_TEXTURE0 + unit, s, 0.5);
                }
                glVertex4f(0, 0, 0, 1);
            };
            session.points(cases.len(), point)
        })?;
    }
    Ok(())
}

fn fog(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("fog");
    for fog in [
        Fog::Linear([1.0, 9.0]),
        Fog::Linear([8.0, 2.0]),
        Fog::Exp(0.25),
        Fog::Exp(1.0),
        Fog::Exp2(0.125),
        Fog::Exp2(0.25),
    ] {
        let fog_color = random(&mut rng);
        let cases: Vec<(f32, [f32; 4])> =
            (0..harness.cases(1024)).map(|_| (rng.real(0.0, 10.0), random(&mut rng))).collect();
        let expect = |(c, color): &(f32, [f32; 4]), variant: Variant| {
            fog.apply(f64::from(*c), color.map(f64::from), fog_color.map(f64::from), variant)
        };
        harness.compare(tally, &(fog, fog_color), &cases, expect, |session| {
            session.float_target()?;
            session.fog(fog, fog_color)?;
            let point = |k: usize| {
                let (c, [r, g, b, a]) = cases[k];
                glColor4f(r, g, b, a);
                glFogCoordf(c);
                glVertex4f(0, 0, 0, 1);
            };
            session.points(cases.len(), point)
        })?;
    }
    Ok(())
}
