//! Grids of points: `glMapGrid`, `glEvalMesh`, `glEvalPoint` (GL 2.1, section 5.1).

use crate::base::constants::*;
use crate::base::error::{ErrorCode, GlError, Result, Table, invalid_value};
use crate::base::types::*;
use crate::calls::evaluate::coord::point;
use crate::calls::vertex::immediate::{begin, end};
use crate::context::Context;
use crate::state::evaluators::{Dimension, EvaluatorKind, GridSteps, name};

const SECTION: &str = "GL 2.1, section 5.1";

/// A mesh of more terms is refused: of control points times components, for each point of the mesh.
const MAX_TERMS: u64 = 1 << 28;
/// The terms that a point takes as long as, beside its own.
const TERMS_OF_POINT: u64 = 64;

impl GridSteps {
    /// The parameter of a grid line; the last one is the end of the domain to the bit.
    fn at(self, line: i32) -> f64 {
        let [start, end] = self.domain;
        if line == self.segments {
            return end;
        }
        f64::from(line) * ((end - start) / f64::from(self.segments)) + start
    }
}

fn steps(argument: &str, segments: GLint, domain: [f64; 2]) -> Result<GridSteps> {
    if segments < 1 {
        return invalid_value(SECTION, format!("{argument} = {segments} must be positive"));
    }
    Ok(GridSteps { segments, domain })
}

pub(crate) fn map_grid1d(
    context: &mut Context,
    un: GLint,
    u1: GLdouble,
    u2: GLdouble,
) -> Result<()> {
    context.state.evaluators.grid_1 = steps("un", un, [u1, u2])?;
    Ok(())
}

pub(crate) fn map_grid1f(context: &mut Context, un: GLint, u1: GLfloat, u2: GLfloat) -> Result<()> {
    map_grid1d(context, un, u1.into(), u2.into())
}

pub(crate) fn map_grid2d(
    context: &mut Context,
    un: GLint,
    u1: GLdouble,
    u2: GLdouble,
    vn: GLint,
    v1: GLdouble,
    v2: GLdouble,
) -> Result<()> {
    context.state.evaluators.grid_2 = [steps("un", un, [u1, u2])?, steps("vn", vn, [v1, v2])?];
    Ok(())
}

pub(crate) fn map_grid2f(
    context: &mut Context,
    un: GLint,
    u1: GLfloat,
    u2: GLfloat,
    vn: GLint,
    v1: GLfloat,
    v2: GLfloat,
) -> Result<()> {
    map_grid2d(context, un, u1.into(), u2.into(), vn, v1.into(), v2.into())
}

pub(crate) fn eval_point1(context: &mut Context, i: GLint) -> Result<()> {
    let at = context.state.evaluators.grid_1.at(i);
    point(context, Dimension::One, [at, 0.0])
}

pub(crate) fn eval_point2(context: &mut Context, i: GLint, j: GLint) -> Result<()> {
    let [u, v] = context.state.evaluators.grid_2;
    point(context, Dimension::Two, [u.at(i), v.at(j)])
}

/// What a mesh is drawn as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mesh {
    Points,
    Lines,
    Filled,
}

const MESH_2: Table<Mesh> = Table {
    section: SECTION,
    rows: &[(GL_POINT, Mesh::Points), (GL_LINE, Mesh::Lines), (GL_FILL, Mesh::Filled)],
};

const MESH_1: Table<Mesh> = Table { section: SECTION, rows: MESH_2.rows.split_at(2).0 };

/// How many lines a range of a grid has.
fn length([first, last]: [GLint; 2]) -> u64 {
    (i64::from(last) - i64::from(first) + 1).max(0) as u64
}

/// What the evaluators of a point add up.
fn terms(context: &Context, dimension: Dimension) -> u64 {
    let evaluators = &context.state.evaluators;
    let names = EvaluatorKind::ALL.map(|kind| name(dimension, kind));
    let enabled = names.into_iter().filter(|name| evaluators.has(*name));
    let terms = enabled.map(|name| {
        let map = context.evaluators.get(name);
        map.order[0] * map.order[1] * map.components
    });
    TERMS_OF_POINT + terms.sum::<usize>() as u64
}

fn checked(context: &mut Context, dimension: Dimension, ranges: [[GLint; 2]; 2]) -> Result<()> {
    let points = length(ranges[0]).saturating_mul(length(ranges[1]));
    let terms = terms(context, dimension);
    let all = points.saturating_mul(terms);
    if all <= MAX_TERMS {
        context.lists.charge(all / TERMS_OF_POINT);
        return Ok(());
    }
    let most = MAX_TERMS / terms;
    Err(GlError::new(
        ErrorCode::OutOfMemory,
        SECTION,
        format!(
            "a mesh of {points} points: with the orders of the enabled evaluators, at most {most} are drawn; draw it in \
             parts"
        ),
    ))
}

pub(crate) fn eval_mesh1(context: &mut Context, mode: GLenum, i1: GLint, i2: GLint) -> Result<()> {
    let primitives = match MESH_1.decode("mode", mode)? {
        Mesh::Points => GL_POINTS,
        Mesh::Lines | Mesh::Filled => GL_LINE_STRIP,
    };
    checked(context, Dimension::One, [[i1, i2], [0, 0]])?;
    begin(context, primitives)?;
    for i in i1..=i2 {
        eval_point1(context, i)?;
    }
    end(context)
}

/// A strip of points, drawn as primitives.
fn strip(
    context: &mut Context,
    primitives: GLenum,
    points: impl Iterator<Item = [GLint; 2]>,
) -> Result<()> {
    begin(context, primitives)?;
    for [i, j] in points {
        eval_point2(context, i, j)?;
    }
    end(context)
}

pub(crate) fn eval_mesh2(
    context: &mut Context,
    mode: GLenum,
    i1: GLint,
    i2: GLint,
    j1: GLint,
    j2: GLint,
) -> Result<()> {
    let mesh = MESH_2.decode("mode", mode)?;
    checked(context, Dimension::Two, [[i1, i2], [j1, j2]])?;
    if i1 > i2 || j1 > j2 {
        return Ok(());
    }
    match mesh {
        Mesh::Points => {
            let points = (j1..=j2).flat_map(|j| (i1..=i2).map(move |i| [i, j]));
            strip(context, GL_POINTS, points)?;
        }
        Mesh::Lines => {
            for j in j1..=j2 {
                strip(context, GL_LINE_STRIP, (i1..=i2).map(|i| [i, j]))?;
            }
            for i in i1..=i2 {
                strip(context, GL_LINE_STRIP, (j1..=j2).map(|j| [i, j]))?;
            }
        }
        Mesh::Filled => {
            for j in j1..j2 {
                let pairs = (i1..=i2).flat_map(|i| [[i, j], [i, j + 1]]);
                strip(context, GL_QUAD_STRIP, pairs)?;
            }
        }
    }
    Ok(())
}
