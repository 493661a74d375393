//! Why a primitive covers nothing. Computed only for draws without any shape.

use super::clip::planes;
use super::setup::{Scratch, Setup, doubled_area};
use crate::desc::Cull;
use crate::vertex::{Geometry, Outcode, Primitive, Primitives, VertexList};
use std::ops::Range;

/// Why a primitive covers no sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reason {
    /// A coordinate is inf or NaN.
    NotFinite,
    /// All its vertices are beyond one side of the view volume.
    Outside(Side),
    /// Clipping by several sides or by user planes removes all of it.
    Cut,
    /// All vertices of a triangle are on a line.
    Flat,
    /// It shows the side that is not drawn.
    Culled,
    /// It lies between the samples, or beside the pixels that can be drawn to.
    Missed,
}

/// A side of the view volume (GL 2.1, section 2.12).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Side {
    /// `w` is not above zero.
    Behind,
    /// `x < -w`.
    Left,
    /// `x > w`.
    Right,
    /// `y < -w`.
    Bottom,
    /// `y > w`.
    Top,
    /// `z < -w`.
    Near,
    /// `z > w`.
    Far,
}

/// The sides, each with its bit of an outcode; what is behind the eye is beyond others only by their formulas.
const SIDES: [(u32, Side); 7] = [
    (Outcode::BEHIND, Side::Behind),
    (Outcode::LEFT, Side::Left),
    (Outcode::RIGHT, Side::Right),
    (Outcode::BOTTOM, Side::Bottom),
    (Outcode::TOP, Side::Top),
    (Outcode::NEAR, Side::Near),
    (Outcode::FAR, Side::Far),
];

/// What a primitive is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Drawn {
    /// A point.
    Point,
    /// A line.
    Line,
    /// A triangle, or a part of a larger polygon.
    Triangle,
}

/// For each primitive, in order, its kind and the reason.
pub type Reasons = Vec<(Drawn, Reason)>;

/// The reasons of a range of primitives without shapes.
pub fn reasons(
    setup: &Setup<'_>,
    geometry: &Geometry,
    (primitives, range): (&Primitives, Range<u32>),
    wanted: &VertexList,
) -> Reasons {
    let mut scratch = Scratch { planes: planes(&setup.viewport), ..Scratch::default() };
    let mut reasons = Reasons::new();
    for at in range {
        let (drawn, ordinals) = match primitives.get(at) {
            Primitive::Point(ordinal) => (Drawn::Point, vec![ordinal]),
            Primitive::Line(ordinals, _) => (Drawn::Line, ordinals.to_vec()),
            Primitive::Triangle(ordinals, ..) => (Drawn::Triangle, ordinals.to_vec()),
        };
        let vertices: Vec<u32> = ordinals.into_iter().map(|v| wanted.local(v)).collect();
        let reason = setup.reason(geometry, &vertices, &mut scratch);
        reasons.push((drawn, reason));
    }
    reasons
}

impl Setup<'_> {
    /// Why nothing is seen of a primitive of these vertices, which has no shapes.
    fn reason(&self, geometry: &Geometry, vertices: &[u32], scratch: &mut Scratch) -> Reason {
        let outcodes = vertices.iter().map(|&v| geometry.outcode(v).0);
        let any = outcodes.clone().fold(0, |any, code| any | code);
        let every = outcodes.fold(!0, |every, code| every & code);
        if any & Outcode::INVALID != 0 {
            return Reason::NotFinite;
        }
        if let Some((_, side)) = SIDES.into_iter().find(|(bit, _)| every & bit != 0) {
            return Reason::Outside(side);
        }
        let whole: Vec<_>;
        let corners = if any & Outcode::CUT == 0 {
            whole = vertices.iter().map(|&v| geometry.snapped[v as usize]).collect();
            &whole
        } else {
            self.cut(geometry, vertices, Outcode(any), scratch);
            &scratch.snapped
        };
        if corners.len() < vertices.len() {
            return Reason::Cut;
        }
        if vertices.len() < 3 {
            return Reason::Missed;
        }
        let parts = (1..corners.len() - 1).map(|i| [corners[0], corners[i], corners[i + 1]]);
        if parts.map(doubled_area).sum::<i64>() == 0 && self.cull != Cull::Both {
            return Reason::Flat;
        }
        if self.facing(corners).is_none() { Reason::Culled } else { Reason::Missed }
    }
}
