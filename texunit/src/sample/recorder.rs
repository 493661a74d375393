//! Who looks on while a batch is sampled: nobody, for which the compiler leaves nothing, or a trace
//! of one lane ([`crate::trace`]).

use crate::trace::SampleStep;

/// Takes notes of the steps of a sample.
pub(crate) trait Recorder {
    /// A step; `step` gives it for a lane.
    fn note(&mut self, step: impl FnOnce(usize) -> SampleStep);

    /// What comes next concerns the lanes of which `takes_part` holds.
    fn only(&mut self, takes_part: impl FnOnce(usize) -> bool);
}

/// Nobody.
pub(crate) struct Off;

impl Recorder for Off {
    #[inline(always)]
    fn note(&mut self, _: impl FnOnce(usize) -> SampleStep) {}

    #[inline(always)]
    fn only(&mut self, _: impl FnOnce(usize) -> bool) {}
}

/// The steps of one lane.
pub(crate) struct Lane {
    pub lane: usize,
    pub steps: Vec<SampleStep>,
    /// Whether anybody wants them.
    listens: bool,
    /// Whether what runs concerns it.
    concerned: bool,
}

impl Lane {
    /// Nothing yet.
    pub fn new(lane: usize) -> Self {
        Self { lane, steps: Vec::new(), listens: true, concerned: true }
    }

    /// Nobody wants to know.
    pub fn deaf() -> Self {
        Self { lane: 0, steps: Vec::new(), listens: false, concerned: false }
    }
}

impl Recorder for Lane {
    fn note(&mut self, step: impl FnOnce(usize) -> SampleStep) {
        if self.concerned {
            self.steps.push(step(self.lane));
        }
    }

    fn only(&mut self, takes_part: impl FnOnce(usize) -> bool) {
        self.concerned = self.listens && takes_part(self.lane);
    }
}
