//! Watching a pixel: what passes do to it is written down as they run.

use super::record::PixelEvent;
use parking_lot::Mutex;
use std::sync::Arc;

/// A watched pixel. Cloning gives another handle to the same record.
#[derive(Clone, Debug)]
pub struct Watch {
    pixel: [u32; 2],
    label: u32,
    events: Arc<Mutex<Vec<PixelEvent>>>,
}

impl Watch {
    /// The most events that are recorded.
    pub const MAX_EVENTS: usize = 1 << 16;

    /// Nothing recorded yet of pixel `(x, y)`; row 0 is the lowest.
    pub fn new(x: u32, y: u32) -> Self {
        Self { pixel: [x, y], label: 0, events: Arc::default() }
    }

    /// The same record for draws and clears that the client knows by `label`.
    #[must_use]
    pub fn labelled(&self, label: u32) -> Self {
        Self { label, ..self.clone() }
    }

    /// Column and row.
    pub fn pixel(&self) -> [u32; 2] {
        self.pixel
    }

    /// What the client calls the draws and clears that come.
    pub fn label(&self) -> u32 {
        self.label
    }

    /// Takes what the passes submitted so far have recorded, oldest first.
    pub fn take(&self) -> Vec<PixelEvent> {
        std::mem::take(&mut self.events.lock())
    }

    pub(crate) fn append(&self, events: Vec<PixelEvent>) {
        let mut all = self.events.lock();
        let remaining = Self::MAX_EVENTS.saturating_sub(all.len());
        all.extend(events.into_iter().take(remaining));
    }
}
