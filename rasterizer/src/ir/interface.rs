//! The inputs and outputs of a shader.

use super::types::{Axis, Ty};

/// Which stage of the pipeline a module is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stage {
    /// Runs once a vertex.
    Vertex,
    /// Runs once a primitive, and makes others of it.
    Geometry,
    /// Runs once a fragment.
    Fragment,
}

/// An input of a shader: one scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Input {
    /// Component 0 to 3 of the vertex attribute at a location (`f32`).
    Attribute {
        /// Attribute location.
        location: u8,
        /// 0 to 3 for x, y, z, w.
        component: u8,
    },
    /// The index of the vertex (`i32`).
    VertexId,
    /// The index of the instance (`i32`).
    InstanceId,
    /// Of a geometry program: what the vertex stage wrote for a vertex of the primitive: `Position`, `PointSize`,
    /// `ClipDistance` or `Varying` (`f32`).
    OfVertex {
        /// Which vertex of the primitive.
        vertex: u8,
        /// Which of the outputs of the vertex stage; 0 if it does not write this.
        output: Output,
    },
    /// Of a geometry program: the number of the primitive within its instance of the draw (`i32`).
    PrimitiveId,
    /// A scalar that the stage before wrote to the same slot, interpolated (`f32`).
    Varying(u16),
    /// How that scalar changes from pixel to pixel, at this pixel: the exact derivative of its
    /// interpolation, from the planes of the primitive (`f32`).
    Gradient {
        /// Of which varying.
        slot: u16,
        /// Along which axis.
        axis: Axis,
    },
    /// `gl_FragCoord`: window x, y, depth, and `1/w` (`f32`).
    FragCoord(u8),
    /// Whether the primitive faces the viewer (`bool`).
    FrontFacing,
    /// The position of the fragment in a point sprite, 0 to 1 (`f32`).
    PointCoord(u8),
    /// The part of the pixel that the primitive covers, 0 to 1; 1 unless it is antialiased (`f32`).
    Coverage,
    /// The number of the sample that is shaded; 0 where a fragment is shaded once (`i32`).
    SampleId,
    /// Where the sample that is shaded lies in its pixel, 0 to 1 from the lower left corner; the centre where a fragment
    /// is shaded once (`f32`).
    SamplePosition(Axis),
    /// Of a fragment of a line, the direction of the line in the window, of length 1 and either sign; else 0 (`f32`).
    LineDirection(Axis),
}

/// An output of a shader: one scalar. All are `f32`, but the stencil's reference, the sample mask, the layer, the viewport and the
/// primitive's number (`i32`), and colours for attachments of integers, which are `i32` or `u32`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Output {
    /// `gl_Position`, in clip coordinates.
    Position(u8),
    /// `gl_PointSize`, in pixels.
    PointSize,
    /// Distance to a user clip plane; negative is cut away.
    ClipDistance(u8),
    /// Distance of a vertex; where one is negative at all vertices of a primitive, that is not drawn.
    CullDistance(u8),
    /// A scalar for the fragment stage.
    Varying(u16),
    /// Component 0 to 3 of a colour for a render target.
    Color {
        /// Which colour attachment.
        target: u8,
        /// 0 to 3 for red, green, blue, alpha.
        component: u8,
    },
    /// Component 0 to 3 of the second colour for render target 0, which only the factors of blending read (`f32`).
    SecondColor(u8),
    /// `gl_FragDepth`.
    Depth,
    /// Of the last program before the fragments': the layer of the attachments, taken from the provoking vertex (`i32`).
    Layer,
    /// Of a geometry program: the number of the primitive for the fragment stage (`i32`).
    PrimitiveId,
    /// Of the last program before the fragments': the number of the viewport, taken from the provoking vertex (`i32`).
    /// One that does not exist is 0.
    ViewportIndex,
    /// `gl_SampleMask`: the samples that are kept, bit by sample; nothing where attachments have one (`i32`).
    SampleMask,
    /// `gl_FragStencilRefARB`: replaces the reference of the stencil test of both faces; its lowest 8 bits count.
    StencilReference,
}

/// How a varying is interpolated over a primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// Perspective-correct.
    Smooth,
    /// Linear in window coordinates.
    NoPerspective,
    /// The value at the provoking vertex.
    Flat,
}

impl Input {
    /// The type of the scalar.
    pub fn ty(self) -> Ty {
        match self {
            Self::VertexId | Self::InstanceId | Self::PrimitiveId | Self::SampleId => Ty::I32,
            Self::FrontFacing => Ty::Bool,
            Self::Attribute { .. }
            | Self::OfVertex { .. }
            | Self::Varying(_)
            | Self::Gradient { .. }
            | Self::FragCoord(_)
            | Self::PointCoord(_)
            | Self::Coverage
            | Self::SamplePosition(_)
            | Self::LineDirection(_) => Ty::F32,
        }
    }
}
