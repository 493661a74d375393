//! Objects that several contexts share: GL 2.1, appendix D.
//!
//! The contexts of a group take turns: a call puts the group's objects in the place of the
//! context's own for as long as it runs, under the group's lock. A context without a group does
//! none of this. What one context records another sees after `glFlush` or `glFinish`.

use crate::context::Context;
use crate::context::sharing::{Entered, exchange};
use crate::objects::Objects;
use parking_lot::{ArcMutexGuard, RawMutex};

/// A call, which has the objects of its context's group; gives them back, even if it panics.
pub(crate) struct Turn<'a> {
    pub context: &'a mut Context,
    shared: Option<ArcMutexGuard<RawMutex, Objects>>,
}

impl<'a> Turn<'a> {
    /// Waits for the calls of other contexts of the group; without a group there is nothing to do.
    pub fn begin(context: &'a mut Context) -> Self {
        let mut turn = Self { context, shared: None };
        if turn.context.group_outside().is_some() {
            turn.fetch();
        }
        turn
    }

    #[inline(never)]
    fn fetch(&mut self) {
        if let Some(group) = self.context.group_outside() {
            let mut shared = group.0.lock_arc();
            exchange(&mut self.context.objects, &mut shared);
            self.context.entered = Entered::Yes;
            self.shared = Some(shared);
        }
    }

    #[inline(never)]
    fn give_back(&mut self) {
        if let Some(mut shared) = self.shared.take() {
            self.context.entered = Entered::No;
            exchange(&mut self.context.objects, &mut shared);
        }
    }
}

impl Drop for Turn<'_> {
    #[inline]
    fn drop(&mut self) {
        if self.shared.is_some() {
            self.give_back();
        }
    }
}
