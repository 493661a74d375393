//! `glEvalCoord`: evaluates the enabled maps at a point and emits its vertex (GL 2.1, section 5.1). The current values
//! are restored afterwards.

use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::calls::evaluate::basis::{Wanted, evaluate};
use crate::calls::vertex::immediate::attribute;
use crate::context::Context;
use crate::context::immediate::Slot;
use crate::interface::*;
use crate::state::enable::Flag;
use crate::state::evaluators::{Dimension, EvaluatorKind, EvaluatorName};

/// A value as the attribute calls take it: what is missing is 0, 0, 0, 1.
fn filled(value: [f64; 4], components: usize) -> [f32; 4] {
    let mut filled = [0.0, 0.0, 0.0, 1.0];
    for (out, value) in filled.iter_mut().zip(value).take(components) {
        *out = value as f32;
    }
    filled
}

/// The map of the first of these kinds that is on.
fn first_on(
    context: &Context,
    dimension: Dimension,
    kinds: &[EvaluatorKind],
) -> Option<EvaluatorName> {
    let names = kinds.iter().map(|&kind| EvaluatorName { dimension, kind });
    names.into_iter().find(|&name| context.state.evaluators.has(name))
}

/// `m / |m|`, `m` the cross product of how the point moves along both parameters.
fn normal(context: &Context, vertex: EvaluatorName, at: [f64; 2]) -> [f64; 4] {
    let map = context.evaluators.get(vertex);
    let [u, v] = [0, 1].map(|axis| {
        let [dx, dy, dz, dw] = evaluate(map, at, Wanted::Slope(axis));
        match vertex.kind {
            // The point is (x/w, y/w, z/w); a positive factor changes no direction.
            EvaluatorKind::Vertex4 => {
                let [x, y, z, w] = evaluate(map, at, Wanted::Value);
                [dx * w - x * dw, dy * w - y * dw, dz * w - z * dw]
            }
            _ => [dx, dy, dz],
        }
    });
    let m = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]).sqrt();
    if length > 0.0 {
        [m[0] / length, m[1] / length, m[2] / length, 1.0]
    } else {
        [0.0, 0.0, 1.0, 1.0]
    }
}

/// The attributes of a point, and its position last.
pub(crate) fn point(context: &mut Context, dimension: Dimension, at: [f64; 2]) -> Result<()> {
    use crate::state::evaluators::EvaluatorKind::*;
    let before = context.state.current;
    let vertex = first_on(context, dimension, &[Vertex4, Vertex3]);
    let automatic = dimension == Dimension::Two && context.state.enables.has(Flag::AutoNormal);
    let attributes: [(u8, &[EvaluatorKind]); 4] = [
        (ATTRIB_COLOR, &[Color]),
        (ATTRIB_INDEX, &[Index]),
        (ATTRIB_NORMAL, &[Normal]),
        (ATTRIB_TEX_COORD, &[TexCoord4, TexCoord3, TexCoord2, TexCoord1]),
    ];
    let value = |context: &Context, name: EvaluatorName| {
        filled(evaluate(context.evaluators.get(name), at, Wanted::Value), name.kind.components())
    };
    for (location, kinds) in attributes {
        let given = match vertex {
            Some(vertex) if automatic && location == ATTRIB_NORMAL => {
                Some(filled(normal(context, vertex, at), 3))
            }
            Some(_) | None => first_on(context, dimension, kinds).map(|name| value(context, name)),
        };
        if let Some(given) = given {
            attribute(context, Slot::Location(location), given)?;
        }
    }
    if let Some(vertex) = vertex {
        let position = value(context, vertex);
        attribute(context, Slot::Vertex, position)?;
    }
    context.state.current = before;
    Ok(())
}

pub(crate) fn eval_coord1f(context: &mut Context, u: GLfloat) -> Result<()> {
    point(context, Dimension::One, [u.into(), 0.0])
}

pub(crate) fn eval_coord1d(context: &mut Context, u: GLdouble) -> Result<()> {
    point(context, Dimension::One, [u, 0.0])
}

pub(crate) fn eval_coord2f(context: &mut Context, u: GLfloat, v: GLfloat) -> Result<()> {
    point(context, Dimension::Two, [u.into(), v.into()])
}

pub(crate) fn eval_coord2d(context: &mut Context, u: GLdouble, v: GLdouble) -> Result<()> {
    point(context, Dimension::Two, [u, v])
}

/// As many numbers as a vector form needs.
fn numbers<const N: usize, T: Copy + Into<f64>>(u: &[T]) -> Result<[f64; N]> {
    match u.first_chunk::<N>() {
        Some(numbers) => Ok(numbers.map(Into::into)),
        None => {
            invalid_operation("GL 2.1, section 5.1", format!("u has {} of {N} numbers", u.len()))
        }
    }
}

pub(crate) fn eval_coord1fv(context: &mut Context, u: &[GLfloat]) -> Result<()> {
    let [u] = numbers(u)?;
    point(context, Dimension::One, [u, 0.0])
}

pub(crate) fn eval_coord1dv(context: &mut Context, u: &[GLdouble]) -> Result<()> {
    let [u] = numbers(u)?;
    point(context, Dimension::One, [u, 0.0])
}

pub(crate) fn eval_coord2fv(context: &mut Context, u: &[GLfloat]) -> Result<()> {
    point(context, Dimension::Two, numbers(u)?)
}

pub(crate) fn eval_coord2dv(context: &mut Context, u: &[GLdouble]) -> Result<()> {
    point(context, Dimension::Two, numbers(u)?)
}
