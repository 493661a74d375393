//! Shader built-ins and interpolation: largest error in ULP against nanoseconds a call.

use crate::chapters::checks;
use crate::check::{Effort, Harness, Subject};
use crate::mutation::Variant;
use crate::oracle::builtin::BUILTINS;
use crate::probe::{Precision, ProbeError, Session};
use serde::Serialize;

/// A function's error and time.
#[derive(Clone, Debug, Serialize)]
pub struct FunctionRow {
    /// The call.
    pub function: &'static str,
    /// Largest error in ULP.
    pub ulp: f64,
    /// Nanoseconds a call, without the time of the rest of the shader.
    pub nanoseconds: f64,
}

/// Calls in a shader, enough that the rest of the shader is negligible.
const CALLS: usize = 16;

/// What is not a built-in: the cost of interpolation.
pub const VARYING: &str = "an interpolated varying";

/// The names of all rows.
pub fn names() -> impl Iterator<Item = &'static str> + Clone {
    std::iter::once(VARYING).chain(BUILTINS.iter().map(|builtin| builtin.glsl))
}

/// The rows that `selected` names.
///
/// # Errors
/// When a shader is rejected or a call sets the error flag.
pub fn measure(selected: &[&str]) -> Result<Vec<FunctionRow>, ProbeError> {
    let harness =
        Harness { subject: Subject::Driver, effort: Effort::Quick, variant: Variant::CORRECT };
    let session = Session::open()?;
    // The times of a shader that only adds the arguments, and of one that reads an interpolated value.
    let empty = time(&session, "a.x + a.y")?;
    let mut rows = Vec::new();
    if selected.contains(&VARYING) {
        rows.push(FunctionRow {
            function: VARYING,
            ulp: checks()
                .find(|check| check.name == "perspective")
                .map_or(f64::NAN, |check| check.run(&harness).largest_error * 2f64.powi(23)),
            nanoseconds: session
                .nanoseconds(&session.program("vec4 value() { return a; }", Precision::Bytes)?)?,
        });
    }
    for builtin in BUILTINS.iter().filter(|builtin| selected.contains(&builtin.glsl)) {
        let check = checks().find(|check| check.name == builtin.name);
        let ulp = check.map_or(f64::NAN, |check| check.run(&harness).largest_error);
        let all = time(&session, builtin.glsl)?;
        let nanoseconds = ((all - empty) / CALLS as f64).max(0.0);
        rows.push(FunctionRow { function: builtin.glsl, ulp, nanoseconds });
    }
    Ok(rows)
}

/// The time of a pixel of a shader that sums calls with different arguments.
fn time(session: &Session, call: &str) -> Result<f64, ProbeError> {
    let body = format!(
        "float once(vec4 a, vec4 b, vec4 c) {{ return {call}; }}
         vec4 value() {{
             float sum = 0.0;
             for (int i = 0; i < {CALLS}; i++) {{
                 float x = float(i) * 0.01;
                 sum += once(a + x, b - x, c + 0.5 * x);
             }}
             return vec4(sum);
         }}"
    );
    session.nanoseconds(&session.program(&body, Precision::Bytes)?)
}
