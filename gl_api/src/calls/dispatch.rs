//! How every call runs: the share group's objects are fetched, what ended is drawn, errors are noted.

use crate::base::begin_end::BeginEnd;
use crate::base::error::{ErrorCode, GlError, Result};
use crate::base::fallback::Fallback;
use crate::calls::flush::flush;
use crate::context::sharing::{Shared, Turn};
use crate::context::{Context, ContextDesc, ContextError};
use crate::draw::ended::draw_ended;
use texunit::lanes::FloatEnv;

impl Context {
    /// A context that shares textures, samplers, buffers, renderbuffers, shaders, programs and
    /// display lists with this one (GL 2.1, appendix D), and its device unless `desc` has one. The
    /// two may be current on different threads; their calls take turns.
    ///
    /// # Errors
    /// As [`Context::new`].
    pub fn new_shared(&mut self, desc: ContextDesc) -> Result<Self, ContextError> {
        Self::boxed(desc, Some(self.share())).map(|context| *context)
    }

    /// What a new context needs to share this one's objects.
    pub(crate) fn share(&mut self) -> Shared {
        // What was recorded is drawn before another thread can change what it reads.
        self.call("glFlush", BeginEnd::Refused, flush);
        self.shared()
    }

    /// Gives another thread what it waits for. Not within a call, whose objects are in use.
    pub(crate) fn answer_invitation(&mut self) {
        if self.invitation.is_open() {
            let shared = self.share();
            self.invitation.answer(shared);
        }
    }

    /// Runs the entry point `name`: an error sets the flag and says why.
    pub(crate) fn call<R: Fallback>(
        &mut self,
        name: &'static str,
        begin_end: BeginEnd,
        f: impl FnOnce(&mut Self) -> Result<R>,
    ) -> R {
        let _float_env = FloatEnv::enter();
        self.call_of_attribute(name, begin_end, f)
    }

    /// As [`Self::call`], in the host's floating-point state: what sets an attribute is called per vertex, and to
    /// read that state takes as long as the call. Where it converts, it sets the state itself.
    #[inline(always)]
    pub(crate) fn call_of_attribute<R: Fallback>(
        &mut self,
        name: &'static str,
        begin_end: BeginEnd,
        f: impl FnOnce(&mut Self) -> Result<R>,
    ) -> R {
        let turn = Turn::begin(self);
        let result = match begin_end {
            BeginEnd::Refused if !turn.context.leave_vertices(name) => Ok(R::fallback()),
            BeginEnd::Refused | BeginEnd::Allowed => f(turn.context),
        };
        drop(turn);
        let result = result.unwrap_or_else(|error: GlError| {
            self.refuse(name, error);
            R::fallback()
        });
        self.debug.deliver();
        result
    }

    /// Before a call that may not stand between `glBegin` and `glEnd`: what ended is drawn with the
    /// state of now. Whether the call may follow.
    #[inline(never)]
    fn leave_vertices(&mut self, name: &'static str) -> bool {
        if self.immediate.is_some() {
            self.refuse(name, between_begin_and_end());
            return false;
        }
        if self.ended.as_ref().is_some_and(|ended| !ended.outlasts(name)) {
            draw_ended(self);
        }
        self.changes.count();
        true
    }
}

#[cold]
#[inline(never)]
fn between_begin_and_end() -> GlError {
    GlError::new(
        ErrorCode::InvalidOperation,
        "GL 2.1, section 2.6.3",
        "must not be called between glBegin and glEnd",
    )
}
