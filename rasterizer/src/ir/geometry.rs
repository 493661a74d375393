//! The interface of a geometry program: the primitives that it takes and makes, and what its vertices hold.

use super::interface::Output;
use super::types::Ty;

/// The most vertices that an invocation may emit (`GL_MAX_GEOMETRY_OUTPUT_VERTICES`).
pub const MAX_GEOMETRY_VERTICES: u32 = 256;
/// The most scalars that all vertices of an invocation may hold (`GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS`).
pub const MAX_GEOMETRY_COMPONENTS: u32 = 1024;

/// The primitives that a geometry program runs for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum GeometryInput {
    /// Points.
    Points,
    /// Lines, also of strips and loops.
    Lines,
    /// Lines with a vertex before and a vertex behind them.
    LinesAdjacency,
    /// Triangles, also of strips and fans.
    Triangles,
    /// Triangles whose vertices 0, 2 and 4 are their corners; 1, 3 and 5 belong to the neighbours.
    TrianglesAdjacency,
}

impl GeometryInput {
    /// How many vertices a primitive has.
    pub fn vertices(self) -> u8 {
        match self {
            Self::Points => 1,
            Self::Lines => 2,
            Self::Triangles => 3,
            Self::LinesAdjacency => 4,
            Self::TrianglesAdjacency => 6,
        }
    }
}

/// The primitives that the vertices emitted by a geometry program make.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum GeometryOutput {
    /// A point each.
    Points,
    /// Strips of lines.
    LineStrip,
    /// Strips of triangles.
    TriangleStrip,
}

/// The interface of a geometry program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GeometryInterface {
    /// The primitives that it runs for.
    pub input: GeometryInput,
    /// The primitives that it makes.
    pub output: GeometryOutput,
    /// The most vertices that an invocation emits; [`super::Stmt::EmitVertex`] has no effect beyond.
    pub max_vertices: u32,
    /// What an emitted vertex holds: [`super::Stmt::EmitVertex`] has the value of each.
    pub outputs: Vec<Output>,
}

impl Output {
    /// The type of what a geometry program gives out.
    pub fn emitted_ty(self) -> Ty {
        match self {
            Self::Layer | Self::PrimitiveId | Self::ViewportIndex => Ty::I32,
            Self::Position(_)
            | Self::PointSize
            | Self::ClipDistance(_)
            | Self::CullDistance(_)
            | Self::Varying(_)
            | Self::Color { .. }
            | Self::SecondColor(_)
            | Self::Depth
            | Self::StencilReference
            | Self::SampleMask => Ty::F32,
        }
    }
}
