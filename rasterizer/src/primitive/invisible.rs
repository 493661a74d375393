//! Why a primitive covers nothing. Computed only for draws without any shape.

use super::clip::planes;
use super::setup::{Scratch, Setup, doubled_area};
use crate::desc::Cull;
use crate::vertex::{Geometry, Outcode, Primitive, Primitives, VertexList};
use std::ops::Range;

/// Why a primitive covers no sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum InvisibleReason {
    /// A coordinate is inf or NaN.
    NotFinite,
    /// All its vertices are beyond one side of the view volume.
    Outside(ViewVolumeSide),
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
pub enum ViewVolumeSide {
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
const SIDES: [(u32, ViewVolumeSide); 7] = [
    (Outcode::BEHIND, ViewVolumeSide::Behind),
    (Outcode::LEFT, ViewVolumeSide::Left),
    (Outcode::RIGHT, ViewVolumeSide::Right),
    (Outcode::BOTTOM, ViewVolumeSide::Bottom),
    (Outcode::TOP, ViewVolumeSide::Top),
    (Outcode::NEAR, ViewVolumeSide::Near),
    (Outcode::FAR, ViewVolumeSide::Far),
];

/// The kind of a primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PrimitiveKind {
    /// A point.
    Point,
    /// A line.
    Line,
    /// A triangle, or a part of a larger polygon.
    Triangle,
}

/// For each primitive, in order, its kind and the reason.
pub type InvisibleReasons = Vec<(PrimitiveKind, InvisibleReason)>;

/// The reasons of a range of primitives without shapes.
pub fn reasons(
    setup: &Setup<'_>,
    geometry: &Geometry,
    (primitives, range): (&Primitives, Range<u32>),
    vertex_list: &VertexList,
) -> InvisibleReasons {
    let mut scratch = Scratch { planes: planes(&setup.viewport), ..Scratch::default() };
    let mut reasons = InvisibleReasons::new();
    for at in range {
        let (kind, ordinals) = match primitives.get(at) {
            Primitive::Point(ordinal) => (PrimitiveKind::Point, vec![ordinal]),
            Primitive::Line(ordinals, _) => (PrimitiveKind::Line, ordinals.to_vec()),
            Primitive::Triangle(ordinals, ..) => (PrimitiveKind::Triangle, ordinals.to_vec()),
        };
        let vertices: Vec<u32> = ordinals.into_iter().map(|v| vertex_list.local(v)).collect();
        let reason = setup.reason(geometry, &vertices, &mut scratch);
        reasons.push((kind, reason));
    }
    reasons
}

impl Setup<'_> {
    /// Why nothing is seen of a primitive of these vertices, which has no shapes.
    fn reason(
        &self,
        geometry: &Geometry,
        vertices: &[u32],
        scratch: &mut Scratch,
    ) -> InvisibleReason {
        let outcodes = vertices.iter().map(|&v| geometry.outcode(v).0);
        let any = outcodes.clone().fold(0, |any, code| any | code);
        let every = outcodes.fold(!0, |every, code| every & code);
        if any & Outcode::INVALID != 0 {
            return InvisibleReason::NotFinite;
        }
        let outside =
            if vertices.len() < 3 { self.outside_for_outlines() } else { Outcode::OUTSIDE };
        if let Some((_, side)) = SIDES.into_iter().find(|(bit, _)| every & outside & bit != 0) {
            return InvisibleReason::Outside(side);
        }
        if every & Outcode::CULLED != 0 {
            return InvisibleReason::Cut;
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
            return InvisibleReason::Cut;
        }
        if vertices.len() < 3 {
            return InvisibleReason::Missed;
        }
        let triangles = (1..corners.len() - 1).map(|i| [corners[0], corners[i], corners[i + 1]]);
        if triangles.map(doubled_area).sum::<i64>() == 0 && self.cull != Cull::Both {
            return InvisibleReason::Flat;
        }
        if self.facing(corners).is_none() {
            InvisibleReason::Culled
        } else {
            InvisibleReason::Missed
        }
    }
}
