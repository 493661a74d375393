//! `glMap` and `glGetMap`: GL 2.1, sections 5.1 and 6.1.3.

use crate::base::args::{DataOut, LocatedOut};
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::context::Context;
use crate::state::evaluators::{Dimension, EvaluatorMap, EvaluatorName, MAP, MAX_EVAL_ORDER};

const SECTION: &str = "GL 2.1, section 5.1";

/// What `glMap1` takes.
const MAP_1: Table<EvaluatorName> = Table { section: MAP.section, rows: MAP.rows.split_at(9).0 };
/// What `glMap2` takes.
const MAP_2: Table<EvaluatorName> = Table { section: MAP.section, rows: MAP.rows.split_at(9).1 };

/// One parameter of a map, as a call gives it.
struct Axis {
    /// The arguments' first letter.
    letter: &'static str,
    domain: [f64; 2],
    stride: GLint,
    order: GLint,
}

impl Axis {
    /// The parameter that a map with one does not have.
    const NONE: Self = Self { letter: "v", domain: [0.0, 1.0], stride: 4, order: 1 };

    /// Stride and order.
    fn checked(&self, components: usize) -> Result<[usize; 2]> {
        let Self { letter, domain, stride, order } = self;
        if domain[0] == domain[1] {
            return invalid_value(
                SECTION,
                format!("{letter}1 = {0} and {letter}2 = {0} must differ", domain[0]),
            );
        }
        let order = match usize::try_from(*order) {
            Ok(order) if (1..=MAX_EVAL_ORDER).contains(&order) => order,
            Ok(_) | Err(_) => {
                let what = format!("{letter}order = {order} must be 1 to GL_MAX_EVAL_ORDER");
                return invalid_value(SECTION, format!("{what}, {MAX_EVAL_ORDER}"));
            }
        };
        match usize::try_from(*stride) {
            Ok(stride) if stride >= components => Ok([stride, order]),
            Ok(_) | Err(_) => invalid_value(
                SECTION,
                format!("{letter}stride = {stride} must be at least {components} numbers, a point"),
            ),
        }
    }
}

/// Copies a map's control points. The numbers between them, of which a large stride has many, are not copied.
fn set<T: Copy + Into<f64>>(
    context: &mut Context,
    name: EvaluatorName,
    axes: [Axis; 2],
    points: &[T],
) -> Result<()> {
    let components = name.kind.components();
    let [u, v] = [axes[0].checked(components)?, axes[1].checked(components)?];
    if context.state.units.active != 0 {
        return invalid_operation(
            "GL 2.1, section 5.1",
            "maps are of texture unit 0: call glActiveTexture(GL_TEXTURE0) first",
        );
    }
    let needed = (u[1] - 1).saturating_mul(u[0]).saturating_add((v[1] - 1).saturating_mul(v[0]));
    let needed = needed.saturating_add(components);
    if points.len() < needed {
        return invalid_operation(
            SECTION,
            format!("the control points take {needed} numbers; points has {}", points.len()),
        );
    }
    let of = |(i, j): (usize, usize)| &points[i * u[0] + j * v[0]..][..components];
    let grid = (0..u[1]).flat_map(|i| (0..v[1]).map(move |j| (i, j)));
    *context.evaluators.get_mut(name) = EvaluatorMap {
        order: [u[1], v[1]],
        domain: axes.map(|axis| axis.domain),
        components,
        points: grid.flat_map(of).map(|&value| value.into() as f32).collect(),
    };
    Ok(())
}

macro_rules! maps {
    ($($map1:ident $map2:ident $ty:ty;)*) => { $(
        pub(crate) fn $map1(
            context: &mut Context,
            target: GLenum,
            u1: $ty,
            u2: $ty,
            stride: GLint,
            order: GLint,
            points: &[$ty],
        ) -> Result<()> {
            let name = MAP_1.decode("target", target)?;
            let domain = [u1.into(), u2.into()];
            let along = Axis { letter: "u", domain, stride, order };
            set(context, name, [along, Axis::NONE], points)
        }

        #[expect(clippy::too_many_arguments, reason = "GL's signature")]
        pub(crate) fn $map2(
            context: &mut Context,
            target: GLenum,
            u1: $ty,
            u2: $ty,
            ustride: GLint,
            uorder: GLint,
            v1: $ty,
            v2: $ty,
            vstride: GLint,
            vorder: GLint,
            points: &[$ty],
        ) -> Result<()> {
            let name = MAP_2.decode("target", target)?;
            let u = Axis {
                letter: "u",
                domain: [u1.into(), u2.into()],
                stride: ustride,
                order: uorder,
            };
            let v = Axis {
                letter: "v",
                domain: [v1.into(), v2.into()],
                stride: vstride,
                order: vorder,
            };
            set(context, name, [u, v], points)
        }
    )* };
}

maps! {
    map1f map2f GLfloat;
    map1d map2d GLdouble;
}

/// What `glGetMap` is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Query {
    Points,
    Order,
    Domain,
}

fn answer(context: &Context, target: GLenum, query: GLenum) -> Result<Vec<f64>> {
    const QUERY: Table<Query> = Table {
        section: "GL 2.1, section 6.1.3",
        rows: &[(GL_COEFF, Query::Points), (GL_ORDER, Query::Order), (GL_DOMAIN, Query::Domain)],
    };
    let name = MAP.decode("target", target)?;
    let map = context.evaluators.get(name);
    let axes = match name.dimension {
        Dimension::One => 1,
        Dimension::Two => 2,
    };
    Ok(match QUERY.decode("query", query)? {
        Query::Points => map.points.iter().map(|&value| value.into()).collect(),
        Query::Order => map.order[..axes].iter().map(|&order| order as f64).collect(),
        Query::Domain => map.domain[..axes].concat(),
    })
}

/// Writes an answer, value by value.
fn write<T: bytemuck::NoUninit>(
    values: Vec<f64>,
    to: DataOut<'_>,
    as_type: fn(f64) -> T,
) -> Result<()> {
    let values: Vec<T> = values.into_iter().map(as_type).collect();
    let bytes: &[u8] = bytemuck::cast_slice(&values);
    let destination = match to.locate(0, bytes.len()) {
        LocatedOut::Bytes(bytes) => bytes,
        LocatedOut::Offset(_) | LocatedOut::Null => &mut [],
    };
    let has = destination.len() / size_of::<T>();
    match destination.get_mut(..bytes.len()) {
        Some(destination) => {
            destination.copy_from_slice(bytes);
            Ok(())
        }
        None => invalid_operation(
            "GL 2.1, section 6.1.3",
            format!("the answer has {} values, v has room for {has}", values.len()),
        ),
    }
}

pub(crate) fn get_mapfv(
    context: &mut Context,
    target: GLenum,
    query: GLenum,
    v: DataOut<'_>,
) -> Result<()> {
    write(answer(context, target, query)?, v, |value| value as GLfloat)
}

pub(crate) fn get_mapdv(
    context: &mut Context,
    target: GLenum,
    query: GLenum,
    v: DataOut<'_>,
) -> Result<()> {
    write(answer(context, target, query)?, v, |value| value)
}

pub(crate) fn get_mapiv(
    context: &mut Context,
    target: GLenum,
    query: GLenum,
    v: DataOut<'_>,
) -> Result<()> {
    write(answer(context, target, query)?, v, |value| value.round() as GLint)
}
