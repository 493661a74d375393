//! Transform feedback: GL 3.0, section 2.15 (`EXT_transform_feedback`).
//!
//! While it is active, the vertices of a draw run through the vertex stage once more, here; they
//! are assembled to points, lines or triangles of their own, and what the program captures of them is
//! written to the bound buffers ([`capture`]), before the draw goes on.

use crate::base::constants::*;
use crate::base::error::Table;
use crate::base::limits::MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS;
use crate::objects::bound::Bound;
use crate::objects::buffers::BufferRange;
use rasterizer::driver::Topology;

pub(crate) const SECTION: &str = "GL 3.0, section 2.15";

/// What is captured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CapturedPrimitive {
    Points,
    Lines,
    Triangles,
}

impl CapturedPrimitive {
    pub(crate) const TABLE: Table<Self> = Table {
        section: "GL 3.0, table 2.14",
        rows: &[
            (GL_POINTS, Self::Points),
            (GL_LINES, Self::Lines),
            (GL_TRIANGLES, Self::Triangles),
        ],
    };

    /// What the primitives of a topology are captured as.
    pub(crate) fn of(topology: Topology) -> Self {
        match topology {
            Topology::Points => Self::Points,
            Topology::Lines | Topology::LineStrip | Topology::LineLoop => Self::Lines,
            Topology::Triangles
            | Topology::TriangleStrip
            | Topology::TriangleFan
            | Topology::Quads
            | Topology::QuadStrip
            | Topology::Polygon => Self::Triangles,
        }
    }

    pub(crate) fn noun(self) -> &'static str {
        match self {
            Self::Points => "points",
            Self::Lines => "lines",
            Self::Triangles => "triangles",
        }
    }

    /// How many vertices one has.
    pub(crate) fn corners(self) -> usize {
        match self {
            Self::Points => 1,
            Self::Lines => 2,
            Self::Triangles => 3,
        }
    }
}

/// What is active between `glBeginTransformFeedback` and `glEndTransformFeedback`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Active {
    pub kind: CapturedPrimitive,
    /// Bytes written to each buffer.
    pub written: [usize; MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS],
}

/// The bound buffers, and what is active.
#[derive(Debug, Default)]
pub(crate) struct TransformFeedback {
    /// All of whose numbers are multiples of 4.
    pub buffers: [BufferRange; MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS],
    pub active: Option<Active>,
}

impl TransformFeedback {
    /// Whether vertices are captured.
    pub fn is_active(&self) -> bool {
        self.active.is_some()
    }

    /// A buffer is no more.
    pub fn forget_buffer(&mut self, gone: &Bound) {
        for range in self.buffers.iter_mut().filter(|range| range.buffer == *gone) {
            *range = BufferRange::default();
        }
    }
}
