//! Fences: `ARB_sync`, GL 3.2, section 5.3. A fence is signalled once what was recorded before it is
//! carried out; as submitting carries it out, that is when somebody flushes.

/// Whether what came before a fence is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    Unsignaled,
    Signaled,
}

/// The fences, by the number that is their handle and in its order.
#[derive(Debug, Default)]
pub(crate) struct Syncs {
    pub fences: Vec<(usize, Status)>,
    pub last: usize,
}

impl Syncs {
    /// Whether a handle is a fence.
    pub fn contains(&self, handle: usize) -> bool {
        self.place(handle).is_some()
    }

    /// Where a fence is.
    pub(crate) fn place(&self, handle: usize) -> Option<usize> {
        self.fences.binary_search_by_key(&handle, |(handle, _)| *handle).ok()
    }

    /// Everything before the fences has been carried out.
    pub fn signal(&mut self) {
        for (_, status) in &mut self.fences {
            *status = Status::Signaled;
        }
    }
}
