//! Which calls may have changed the state that draws depend on.

/// Counts the calls that may not stand between `glBegin` and `glEnd`, and other calls that change what draws depend
/// on. Each counts as a change of any state, unless it says otherwise with [`Self::no_change`] or
/// [`Self::values_only`], or is one that sets plain state ([`Self::count_setter`]).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct StateChanges {
    /// How many calls there were.
    pub calls: u64,
    /// The number of the last call that may have changed state by which shaders, pipelines, textures and the framebuffer
    /// are chosen, other than plain state and what the next two have.
    pub last_state_change: u64,
    /// [`Self::last_state_change`] before the last call.
    previous_state_change: u64,
    /// The number of the last call that may have changed plain state ([`crate::state::plain::PlainState`]).
    pub last_plain_change: u64,
    /// [`Self::last_plain_change`] before the last call.
    previous_plain_change: u64,
    /// The number of the last call that may have changed which program is in use, and no other state.
    pub last_program_change: u64,
    /// The number of the last call that may have changed which textures and samplers are bound, and no other state.
    pub last_binding_change: u64,
    /// The number of the last call that may have changed what does not affect those choices: values of uniform words,
    /// the contents of buffers, and where vertices are read from.
    pub last_value_change: u64,
}

impl StateChanges {
    /// The number of the last call that may have changed anything that draws depend on.
    pub fn last_change(&self) -> u64 {
        self.last_decision_change().max(self.last_plain_change).max(self.last_value_change)
    }

    /// The number of the last call that may have changed by what shaders, pipelines and textures are chosen, other than
    /// plain state.
    pub fn last_decision_change(&self) -> u64 {
        self.last_state_change.max(self.last_program_change).max(self.last_binding_change)
    }

    /// Counts a call, as one that may change any state.
    pub fn count_call(&mut self) {
        self.calls += 1;
        self.previous_plain_change = self.last_plain_change;
        self.previous_state_change = std::mem::replace(&mut self.last_state_change, self.calls);
    }

    /// Counts a call, as one that may change plain state and nothing else.
    pub fn count_setter(&mut self) {
        self.calls += 1;
        self.previous_state_change = self.last_state_change;
        self.previous_plain_change = std::mem::replace(&mut self.last_plain_change, self.calls);
    }

    /// The last call has changed no state that draws depend on.
    pub fn no_change(&mut self) {
        self.last_state_change = self.previous_state_change;
        self.last_plain_change = self.previous_plain_change;
    }

    /// The last call has changed nothing but which program is in use.
    pub fn program_only(&mut self) {
        self.no_change();
        self.last_program_change = self.calls;
    }

    /// The last call has changed nothing but which textures and samplers are bound.
    pub fn bindings_only(&mut self) {
        self.no_change();
        self.last_binding_change = self.calls;
    }

    /// The last call has changed nothing but values: uniform words, the contents of buffers, and where vertices are read
    /// from.
    pub fn values_only(&mut self) {
        self.no_change();
        self.last_value_change = self.calls;
    }
}
