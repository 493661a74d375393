//! State of transform feedback: GL 3.0, section 2.15 (`EXT_transform_feedback`).

use crate::base::constants::*;
use crate::base::error::Table;
use crate::base::limits::MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS;
use crate::base::types::*;
use crate::objects::bound::Bound;
use crate::objects::buffers::BufferRange;
use crate::objects::name_table::NameTable;
use rasterizer::driver::Topology;

pub(crate) const SECTION: &str = "GL 3.0, section 2.15";

/// The type of the captured primitives.
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

    /// The primitives that a topology is captured as.
    pub(crate) fn of(topology: Topology) -> Self {
        match topology {
            Topology::Points => Self::Points,
            Topology::Lines
            | Topology::LineStrip
            | Topology::LineLoop
            | Topology::LinesAdjacency
            | Topology::LineStripAdjacency => Self::Lines,
            Topology::Triangles
            | Topology::TrianglesAdjacency
            | Topology::TriangleStripAdjacency
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

    /// The mode of the same name.
    pub(crate) fn topology(self) -> Topology {
        match self {
            Self::Points => Topology::Points,
            Self::Lines => Topology::Lines,
            Self::Triangles => Topology::Triangles,
        }
    }

    /// The number of vertices of a primitive.
    pub(crate) fn corners(self) -> usize {
        match self {
            Self::Points => 1,
            Self::Lines => 2,
            Self::Triangles => 3,
        }
    }
}

/// Transform feedback between `glBeginTransformFeedback` and `glEndTransformFeedback`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Active {
    pub kind: CapturedPrimitive,
    /// The program in use; 0 if it is a pipeline.
    pub program: GLuint,
    /// The pipeline in use and its programs, by stage; 0 if it is a program.
    pub pipeline: (GLuint, [GLuint; 3]),
    /// Bytes written to each buffer.
    pub written: [usize; MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS],
    /// Vertices written.
    pub vertices: u32,
}

impl Active {
    /// Whether it captures what a program writes.
    pub(crate) fn is_of(&self, program: GLuint) -> bool {
        self.program == program || self.pipeline.1.contains(&program)
    }
}

/// The bound buffers, and active transform feedback.
#[derive(Debug, Default)]
pub(crate) struct TransformFeedback {
    /// Their offsets and sizes are multiples of 4.
    pub buffers: [BufferRange; MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS],
    /// What is captured now.
    pub active: Option<Active>,
    /// What is captured once `glResumeTransformFeedback` is called.
    pub paused: Option<Active>,
    /// The vertices that were captured when `glEndTransformFeedback` was called last.
    pub captured: Option<u32>,
}

impl TransformFeedback {
    /// Whether vertices are captured.
    pub fn is_active(&self) -> bool {
        self.active.is_some()
    }

    /// Whether it is between `glBeginTransformFeedback` and `glEndTransformFeedback`.
    pub fn has_begun(&self) -> bool {
        self.active.is_some() || self.paused.is_some()
    }

    /// Unbinds a deleted buffer.
    pub fn forget_buffer(&mut self, gone: &Bound) {
        for range in self.buffers.iter_mut().filter(|range| range.buffer == *gone) {
            *range = BufferRange::default();
        }
    }
}

/// Transform feedback objects but the bound one, whose state is [`TransformFeedback`] of the context.
#[derive(Debug, Default)]
pub(crate) struct TransformFeedbackObjects {
    /// The name of the bound one.
    pub bound: GLuint,
    pub named: NameTable<TransformFeedback>,
    /// The state of name 0 while another is bound.
    pub default: TransformFeedback,
}
