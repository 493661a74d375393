//! How vertices form primitives, and which sides of polygons are drawn.

use crate::ir::GeometryOutput;

/// How vertices form primitives (GL 2.1, section 2.6.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Topology {
    /// Each vertex a point.
    Points,
    /// Each pair a line.
    Lines,
    /// Each vertex joined to the next.
    LineStrip,
    /// As [`Self::LineStrip`], and the last vertex joined to the first.
    LineLoop,
    /// Each three a triangle.
    Triangles,
    /// Each vertex with the two before it.
    TriangleStrip,
    /// Each two consecutive vertices with the first.
    TriangleFan,
    /// Each four a quadrilateral.
    Quads,
    /// Each pair with the pair before it.
    QuadStrip,
    /// All vertices one convex polygon.
    Polygon,
    /// Each four a line between the second and the third (GL 3.2, section 2.6.1).
    LinesAdjacency,
    /// Each vertex joined to the next, without the first and the last.
    LineStripAdjacency,
    /// Each six a triangle of the first, the third and the fifth.
    TrianglesAdjacency,
    /// Every other vertex with the two such before it.
    TriangleStripAdjacency,
}

/// Which faces are not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Cull {
    /// All are drawn.
    None,
    /// Front faces are not drawn.
    Front,
    /// Back faces are not drawn.
    Back,
    /// No polygon is drawn; points and lines are.
    Both,
}

/// Which winding, seen in the window with y up, is the front.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FrontFace {
    /// Counter-clockwise.
    Ccw,
    /// Clockwise.
    Cw,
}

/// The provoking vertex: the source of flat varyings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Provoking {
    /// GL's default.
    Last,
    /// Vulkan's default.
    First,
}

impl Provoking {
    /// The corners of the primitive that ends with a vertex emitted by a geometry program, as how many vertices before
    /// it they were emitted: none where the vertex is the first of a strip of lines, or the second of triangles.
    /// `position` is its position in its strip, from 0. They are ordered as those of strips in draws.
    pub fn corners_of_strip(self, output: GeometryOutput, position: u32) -> &'static [u32] {
        match (output, position) {
            (GeometryOutput::Points, _) => &[0],
            (GeometryOutput::LineStrip, 0) | (GeometryOutput::TriangleStrip, 0 | 1) => &[],
            (GeometryOutput::LineStrip, _) => &[1, 0],
            (GeometryOutput::TriangleStrip, _) => match (position % 2, self) {
                (0, _) => &[2, 1, 0],
                (_, Self::Last) => &[1, 2, 0],
                (_, Self::First) => &[2, 0, 1],
            },
        }
    }
}

/// The facing of a primitive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Facing {
    /// Front faces, points and lines.
    #[default]
    Front,
    /// Back faces.
    Back,
}

/// What the primitives of a topology are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PrimitiveClass {
    Points,
    Lines,
    /// Triangles, quads and polygons, which polygon modes may draw as lines or points.
    Polygons,
}

impl Topology {
    /// What its primitives are.
    pub(crate) fn class(self) -> PrimitiveClass {
        match self {
            Self::Points => PrimitiveClass::Points,
            Self::Lines
            | Self::LineStrip
            | Self::LineLoop
            | Self::LinesAdjacency
            | Self::LineStripAdjacency => PrimitiveClass::Lines,
            Self::Triangles
            | Self::TrianglesAdjacency
            | Self::TriangleStripAdjacency
            | Self::TriangleStrip
            | Self::TriangleFan
            | Self::Quads
            | Self::QuadStrip
            | Self::Polygon => PrimitiveClass::Polygons,
        }
    }
}
