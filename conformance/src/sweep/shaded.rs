//! Lines of a shader's values: all points of a line are drawn at once.

use super::series::{Compared, Series};
use crate::probe::{ProbeError, Session};

/// The two vectors `a` and `b` that a shader gets.
pub type Inputs = [[f32; 4]; 2];

/// Cases at each value of the parameter.
pub const CASES: usize = 512;

/// `x`, `y`, `z`, `w` of `a` alone.
pub fn of(a: [f32; 4]) -> Inputs {
    [a, [0.0; 4]]
}

/// Three components of a vector as numbers of `f64`.
pub fn three(v: [f32; 4]) -> [f64; 3] {
    [v[0], v[1], v[2]].map(f64::from)
}

/// The sum of products.
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The line of the errors of `vec4 value(vec4 a, vec4 b)`, which `body` defines, in a context that has been
/// prepared. `case` makes a case at a parameter; `error` is its error in the driver's result, and
/// `None` where the case says nothing.
///
/// # Errors
/// When a call sets the error flag or the shader is rejected.
pub fn shaded_in(
    session: &Session,
    name: &str,
    parameters: impl Iterator<Item = f64>,
    body: &str,
    mut case: impl FnMut(f64) -> Inputs,
    error: impl Fn(&Inputs, [f64; 4]) -> Option<f64>,
) -> Result<Series, ProbeError> {
    let parameters: Vec<f64> = parameters.collect();
    let inputs: Vec<Inputs> = parameters
        .iter()
        .flat_map(|&parameter| (0..CASES).map(move |_| parameter))
        .map(&mut case)
        .collect();
    let body = format!("vec4 value(vec4 a, vec4 b);{body}");
    let values = session.float_words(&body, &inputs)?;
    if values.len() != inputs.len() {
        return Err(ProbeError::Missing { cases: inputs.len(), measured: values.len() });
    }
    let all = inputs.chunks(CASES).zip(values.chunks(CASES));
    let points = parameters.iter().zip(all).map(|(&parameter, (inputs, values))| {
        let mut compared = Compared::new();
        for (input, value) in inputs.iter().zip(values) {
            match error(input, *value) {
                Some(error) => compared.add(error, value),
                None => compared.leave_out(),
            }
        }
        compared.at(parameter)
    });
    Ok(Series { name: name.to_owned(), points: points.collect() })
}

/// As [`shaded_in`], in a new context.
///
/// # Errors
/// When a call sets the error flag or the shader is rejected.
pub fn shaded(
    name: &str,
    parameters: impl Iterator<Item = f64>,
    body: &str,
    case: impl FnMut(f64) -> Inputs,
    error: impl Fn(&Inputs, [f64; 4]) -> Option<f64>,
) -> Result<Series, ProbeError> {
    shaded_in(&Session::open()?, name, parameters, body, case, error)
}
