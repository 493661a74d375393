//! Query objects (GL 2.1, section 4.1.7; GL 3.0, section 2.16; `ARB_occlusion_query2`, `ARB_timer_query`) and
//! conditional rendering (GL 3.0, section 2.14), which waits for the result in every mode so that the picture never
//! depends on timing.

use crate::base::constants::*;
use crate::base::error::Table;
use crate::base::types::*;
use rasterizer::driver::Counter;
use std::time::Instant;

const SECTION: &str = "GL 2.1, section 4.1.7";

/// What is queried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum QueryTarget {
    SamplesPassed,
    AnySamplesPassed,
    /// As exact as the other (OpenGL ES 3.0, section 2.13).
    AnySamplesPassedConservative,
    PrimitivesGenerated,
    TransformFeedbackPrimitivesWritten,
    TimeElapsed,
    Timestamp,
}

/// The number of queries that can be active at once: of samples, of time, of primitives generated and written.
const ACTIVE: usize = 4;

pub(crate) const TARGET: Table<QueryTarget> = Table {
    section: SECTION,
    rows: &[
        (GL_SAMPLES_PASSED, QueryTarget::SamplesPassed),
        (GL_ANY_SAMPLES_PASSED, QueryTarget::AnySamplesPassed),
        (GL_ANY_SAMPLES_PASSED_CONSERVATIVE, QueryTarget::AnySamplesPassedConservative),
        (GL_PRIMITIVES_GENERATED, QueryTarget::PrimitivesGenerated),
        (GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, QueryTarget::TransformFeedbackPrimitivesWritten),
        (GL_TIME_ELAPSED, QueryTarget::TimeElapsed),
    ],
};

/// A query object.
#[derive(Clone, Debug)]
pub(crate) struct Query {
    pub target: QueryTarget,
    pub counter: Counter,
    pub primitives: u64,
    /// When it began, and nanoseconds since, once it has ended.
    pub began: Option<Instant>,
    pub nanoseconds: u64,
}

/// The names of the active queries (0 where none is), and the result of conditional rendering.
#[derive(Clone, Debug, Default)]
pub(crate) struct ActiveQueries {
    pub names: [GLuint; ACTIVE],
    /// Set between `glBeginConditionalRender` and `glEndConditionalRender`.
    pub(crate) conditional: Option<ConditionalResult>,
}

impl Query {
    /// One that has counted nothing.
    pub(crate) fn new(target: QueryTarget) -> Self {
        Self { target, counter: Counter::new(), primitives: 0, began: None, nanoseconds: 0 }
    }

    /// What it counts.
    pub fn target(&self) -> QueryTarget {
        self.target
    }

    /// GL's name of the target.
    pub(crate) fn target_name(&self) -> GLenum {
        match self.target {
            QueryTarget::Timestamp => GL_TIMESTAMP,
            target @ (QueryTarget::SamplesPassed
            | QueryTarget::AnySamplesPassed
            | QueryTarget::AnySamplesPassedConservative
            | QueryTarget::TimeElapsed
            | QueryTarget::PrimitivesGenerated
            | QueryTarget::TransformFeedbackPrimitivesWritten) => TARGET.encode(target),
        }
    }

    /// Samples that passed, of the draws that were submitted.
    pub fn samples(&self) -> u64 {
        self.counter.samples()
    }
}

impl ActiveQueries {
    /// Whether a query has begun and not ended.
    pub fn is_active(&self, id: GLuint) -> bool {
        self.names.contains(&id)
    }

    pub(crate) fn slot(&mut self, target: QueryTarget) -> &mut GLuint {
        // Both targets of samples share the counter that draws have.
        match target {
            QueryTarget::SamplesPassed
            | QueryTarget::AnySamplesPassed
            | QueryTarget::AnySamplesPassedConservative => &mut self.names[0],
            QueryTarget::TimeElapsed | QueryTarget::Timestamp => &mut self.names[1],
            QueryTarget::PrimitivesGenerated => &mut self.names[GENERATED],
            QueryTarget::TransformFeedbackPrimitivesWritten => &mut self.names[WRITTEN],
        }
    }
}

/// The indices of primitive queries among the active ones.
pub(crate) const GENERATED: usize = 2;
pub(crate) const WRITTEN: usize = 3;

/// Nanoseconds since the first call.
pub(crate) fn timestamp() -> u64 {
    use std::sync::LazyLock;
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed().as_nanos() as u64
}

/// Whether conditional rendering lets draws through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ConditionalResult {
    Draw,
    Discard,
}

impl ActiveQueries {
    /// Whether draws, and clears, have no effect now.
    pub fn discards(&self) -> bool {
        self.conditional == Some(ConditionalResult::Discard)
    }
}
