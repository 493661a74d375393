//! Recorders of the steps of a sample: one that compiles to nothing, and one of a single lane for
//! [`crate::trace`].

use crate::trace::SampleStep;

/// Records the steps of a sample.
pub(crate) trait Recorder {
    /// Records a step; `step` makes it for a lane.
    fn record(&mut self, step: impl FnOnce(usize) -> SampleStep);

    /// The steps that follow are of the lanes for which `participates` is true.
    fn restrict_to(&mut self, participates: impl FnOnce(usize) -> bool);
}

/// Records nothing.
pub(crate) struct NoRecorder;

impl Recorder for NoRecorder {
    #[inline(always)]
    fn record(&mut self, _: impl FnOnce(usize) -> SampleStep) {}

    #[inline(always)]
    fn restrict_to(&mut self, _: impl FnOnce(usize) -> bool) {}
}

/// Records the steps of one lane.
pub(crate) struct LaneRecorder {
    pub lane: usize,
    pub steps: Vec<SampleStep>,
    /// Whether steps are recorded at all.
    enabled: bool,
    /// Whether the current steps are of this lane.
    active: bool,
}

impl LaneRecorder {
    /// A recorder without steps.
    pub fn new(lane: usize) -> Self {
        Self { lane, steps: Vec::new(), enabled: true, active: true }
    }

    /// A recorder that records nothing, so that samples and traces share a kernel.
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
