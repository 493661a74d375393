//! The primitives that `glBegin` and the draw calls name (GL 2.1, section 2.6.1).

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum};
use crate::base::types::*;
use rasterizer::driver::Topology;

const TOPOLOGY: Table<Topology> = Table {
    section: "GL 2.1, section 2.6.1",
    rows: &[
        (GL_POINTS, Topology::Points),
        (GL_LINES, Topology::Lines),
        (GL_LINE_STRIP, Topology::LineStrip),
        (GL_LINE_LOOP, Topology::LineLoop),
        (GL_TRIANGLES, Topology::Triangles),
        (GL_TRIANGLE_STRIP, Topology::TriangleStrip),
        (GL_TRIANGLE_FAN, Topology::TriangleFan),
        (GL_QUADS, Topology::Quads),
        (GL_QUAD_STRIP, Topology::QuadStrip),
        (GL_POLYGON, Topology::Polygon),
        (GL_LINES_ADJACENCY, Topology::LinesAdjacency),
        (GL_LINE_STRIP_ADJACENCY, Topology::LineStripAdjacency),
        (GL_TRIANGLES_ADJACENCY, Topology::TrianglesAdjacency),
        (GL_TRIANGLE_STRIP_ADJACENCY, Topology::TriangleStripAdjacency),
    ],
};

/// The topology of `mode`. The values are too small for [`enum_name`], so the message lists their names.
///
/// # Errors
/// `GL_INVALID_ENUM`.
pub(crate) fn topology(mode: GLenum) -> Result<Topology> {
    match TOPOLOGY.get(mode) {
        Some(topology) => Ok(topology),
        None => invalid_enum(
            TOPOLOGY.section,
            format!(
                "mode = {} must be GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, \
                 GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, \
                 GL_POLYGON, or one of lines and triangles with adjacency (GL 3.2)",
                enum_name(mode)
            ),
        ),
    }
}
