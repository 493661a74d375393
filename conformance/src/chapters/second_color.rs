//! Blending by the second colour of the fragment stage.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::blend::Equation;
use crate::oracle::second_color::{Colors, Factor, State, blend};
use crate::probe::{Dialect, ProbeError, Session, Stages, equation_enum};
use crate::rng::Rng;
use gl_api::constants::*;

/// Dual-source blending.
pub const BLEND: Check = Check {
    name: "dual-source",
    citation: "GL 3.3, 4.1.7; ARB_blend_func_extended",
    what: "colours and alphas blended by random pairs of factors, one at least of the second colour, \
           and equations in a framebuffer of floats",
    unit: Unit::FullScale,
    tolerance: 3.0 / (1 << 24) as f64,
    why: "f32: of either term, 1 - c and the product are rounded by 2^-25 each; their sum, up to 2, by 2^-24",
    run,
};

/// Colours of a case: first and second of the fragment, the framebuffer's.
type Case = [[f32; 4]; 3];

const WIDTH: usize = 64;

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("dual-source");
    let states = harness.cases(96).max(24);
    let mut seen = [0; Factor::ALL.len()];
    for number in 0..states {
        let second = Factor::ALL[5 + number % 4];
        let mut factor = || rng.pick(&Factor::ALL);
        let mut pairs = [[factor(), factor()], [factor(), factor()]];
        pairs[number / 4 % 2][number / 8 % 2] = second;
        for (seen, factor) in seen.iter_mut().zip(Factor::ALL) {
            *seen += usize::from(pairs.as_flattened().contains(&factor));
        }
        let plain = [Equation::Add, Equation::Add, Equation::Subtract, Equation::ReverseSubtract];
        let equations = [rng.pick(&plain), rng.pick(&Equation::ALL)];
        let state = State { equations, rgb: pairs[0], alpha: pairs[1] };
        let cases: Vec<Case> =
            (0..WIDTH).map(|_| [0; 3].map(|_| [0; 4].map(|_: i32| rng.real(0.0, 1.0)))).collect();
        let expect = |case: &Case, variant: Variant| {
            let [source, second, destination] = case.map(|color| color.map(f64::from));
            blend(&state, &Colors { source, second, destination }, variant)
        };
        harness.compare_with(Dialect::Core, tally, &state, &cases, expect, |session| {
            observe(session, &state, &cases)
        })?;
    }
    for (seen, factor) in seen.into_iter().zip(Factor::ALL) {
        tally.reach(format!("states with {factor:?}"), seen, states / 8);
    }
    Ok(())
}

const VERTEX: &str = "
layout(location = 0) in vec4 a; layout(location = 1) in vec4 b; layout(location = 2) in vec4 c;
flat out vec4 first, second, under;
void main() {
    first = a; second = b; under = c;
    gl_Position = vec4((float(gl_VertexID) + 0.5) / 32.0 - 1.0, 0.0, 0.0, 1.0);
}
";

const UNDER: &str = "flat in vec4 under; out vec4 color; void main() { color = under; }";

const BOTH: &str = "
flat in vec4 first, second;
layout(location = 0, index = 0) out vec4 color;
layout(location = 0, index = 1) out vec4 weight;
void main() { color = first; weight = second; }
";

fn observe(session: &Session, state: &State, cases: &[Case]) -> Result<Vec<[f64; 4]>, ProbeError> {
    session.frame(GL_RGBA32F, [WIDTH, 1], 0)?;
    for fragment in [UNDER, BOTH] {
        session.stages(&Stages { vertex: VERTEX, geometry: "", fragment })?;
        for index in 0..3 {
            let colors: Vec<f32> = cases.iter().flat_map(|case| case[index]).collect();
            session.float_array(index as u32, 4, &colors)?;
        }
        glDrawArrays(GL_POINTS, 0, cases.len());
        glEnable(GL_BLEND);
        let [rgb, alpha] = state.equations.map(equation_enum);
        glBlendEquationSeparate(rgb, alpha);
        let ([sr, dr], [sa, da]) = (state.rgb.map(factor_enum), state.alpha.map(factor_enum));
        glBlendFuncSeparate(sr, dr, sa, da);
    }
    session.read_floats([WIDTH, 1])
}

fn factor_enum(factor: Factor) -> u32 {
    match factor {
        Factor::Zero => GL_ZERO,
        Factor::One => GL_ONE,
        Factor::SrcColor => GL_SRC_COLOR,
        Factor::OneMinusDstColor => GL_ONE_MINUS_DST_COLOR,
        Factor::SrcAlphaSaturate => GL_SRC_ALPHA_SATURATE,
        Factor::Src1Color => GL_SRC1_COLOR,
        Factor::OneMinusSrc1Color => GL_ONE_MINUS_SRC1_COLOR,
        Factor::Src1Alpha => GL_SRC1_ALPHA,
        Factor::OneMinusSrc1Alpha => GL_ONE_MINUS_SRC1_ALPHA,
    }
}
