//! Which calls may have changed what draws depend on.

/// Calls are counted that may not stand between `glBegin` and `glEnd`, and others that change what draws depend
/// on. Each may have changed anything, unless it says that it has not.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Changes {
    /// How many there were.
    pub calls: u64,
    /// The number of the last that may have changed what draws decide by.
    pub state: u64,
    /// The same before the last call.
    before: u64,
    /// The number of the last that may have changed what is the same to those decisions: uniform words, and where
    /// vertices come from.
    pub numbers: u64,
}

impl Changes {
    /// A call comes.
    pub fn count(&mut self) {
        self.calls += 1;
        self.before = std::mem::replace(&mut self.state, self.calls);
    }

    /// It has left everything as it was: draws before and after it are as if there had been none.
    pub fn nothing(&mut self) {
        self.state = self.before;
    }

    /// It has changed nothing but numbers.
    pub fn only_numbers(&mut self) {
        self.nothing();
        self.numbers = self.calls;
    }
}
