//! Fence sync objects: `ARB_sync`, GL 3.2, section 5.3. Submitting executes recorded draws, so a fence is signalled by
//! the next flush.

/// Whether the commands before a fence have completed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    Unsignaled,
    Signaled,
}

/// The fences, sorted by handle.
#[derive(Debug, Default)]
pub(crate) struct Syncs {
    pub fences: Vec<(usize, Status)>,
    pub last: usize,
}

impl Syncs {
    /// Whether a handle is a fence.
    pub fn contains(&self, handle: usize) -> bool {
        self.position(handle).is_some()
    }

    /// The index of a fence.
    pub(crate) fn position(&self, handle: usize) -> Option<usize> {
        self.fences.binary_search_by_key(&handle, |(handle, _)| *handle).ok()
    }

    /// Signals all fences.
    pub fn signal(&mut self) {
        for (_, status) in &mut self.fences {
            *status = Status::Signaled;
        }
    }
}
