//! Who looks on while a batch is sampled: nobody, for which the compiler leaves nothing, or a trace
//! of one lane ([`crate::trace`]).

use crate::trace::SampleStep;

/// Takes notes of the steps of a sample.
pub(crate) trait Recorder {
    /// A step; `step` gives it for a lane.
    fn record(&mut self, step: impl FnOnce(usize) -> SampleStep);

    /// What comes next concerns the lanes of which `participates` holds.
    fn restrict_to(&mut self, participates: impl FnOnce(usize) -> bool);
}

/// Nobody.
pub(crate) struct NoRecorder;

impl Recorder for NoRecorder {
    #[inline(always)]
    fn record(&mut self, _: impl FnOnce(usize) -> SampleStep) {}

    #[inline(always)]
    fn restrict_to(&mut self, _: impl FnOnce(usize) -> bool) {}
}

/// The steps of one lane.
pub(crate) struct LaneRecorder {
    pub lane: usize,
    pub steps: Vec<SampleStep>,
    /// Whether anybody wants them.
    enabled: bool,
    /// Whether what runs concerns it.
    active: bool,
}

impl LaneRecorder {
    /// Nothing yet.
    pub fn new(lane: usize) -> Self {
        Self { lane, steps: Vec::new(), enabled: true, active: true }
    }

    /// Nobody wants to know.
    pub fn disabled() -> Self {
        Self { lane: 0, steps: Vec::new(), enabled: false, active: false }
    }
}

impl Recorder for LaneRecorder {
    fn record(&mut self, step: impl FnOnce(usize) -> SampleStep) {
        if self.active {
            self.steps.push(step(self.lane));
        }
    }

    fn restrict_to(&mut self, participates: impl FnOnce(usize) -> bool) {
        self.active = self.enabled && participates(self.lane);
    }
}
