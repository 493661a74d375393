//! How every call runs: pending immediate mode is drawn, errors are recorded, the share group is released.

use crate::base::begin_end::BeginEnd;
use crate::base::error::{ErrorCode, GlError, Result};
use crate::base::refused_result::RefusedResult;
use crate::context::pending_primitives::{PendingPrimitives, PendingState};
use crate::context::sharing::CallScope;
use crate::context::{Context, ContextDesc, ContextError};
use crate::draw::pending_primitives::draw_pending;
use crate::state::State;
use crate::state::plain::PlainState;
use texunit::lanes::FloatEnv;

impl Context {
    /// A context that shares textures, samplers, buffers, renderbuffers, shaders, programs and
    /// display lists with this one (GL 2.1, appendix D), and its device unless `desc` has one. The
    /// two may be current on different threads.
    ///
    /// # Errors
    /// As [`Context::new`].
    pub fn new_shared(&self, desc: ContextDesc) -> Result<Self, ContextError> {
        Self::boxed(desc, Some(self.share())).map(|context| *context)
    }

    /// Runs the entry point `name`: an error sets the flag and says why.
    pub(crate) fn call<R: RefusedResult>(
        &mut self,
        name: &'static str,
        begin_end: BeginEnd,
        f: impl FnOnce(&mut Self) -> Result<R>,
    ) -> R {
        let effect = match begin_end {
            BeginEnd::Refused => CallEffect::AnyState,
            BeginEnd::Allowed => CallEffect::Vertices,
        };
        self.call_with(name, effect, f)
    }

    /// As [`Self::call`], of a call that may not stand between `glBegin` and `glEnd` and changes nothing that draws depend
    /// on but plain state ([`PlainState`]): vertices stay pending, and are drawn with the state from before if it is
    /// another one when more vertices come.
    pub(crate) fn call_setter<R: RefusedResult>(
        &mut self,
        name: &'static str,
        f: impl FnOnce(&mut Self) -> Result<R>,
    ) -> R {
        self.call_with(name, CallEffect::PlainState, f)
    }

    /// As [`Self::call`], of a call that may not stand between `glBegin` and `glEnd`, draws nothing and changes nothing.
    pub(crate) fn call_query<R: RefusedResult>(
        &mut self,
        name: &'static str,
        f: impl FnOnce(&mut Self) -> Result<R>,
    ) -> R {
        self.call_with(name, CallEffect::Nothing, f)
    }

    /// Runs an entry point.
    #[inline(always)]
    fn call_with<R: RefusedResult>(
        &mut self,
        name: &'static str,
        effect: CallEffect,
        f: impl FnOnce(&mut Self) -> Result<R>,
    ) -> R {
        let Some(call) = ComputingCall::begin(self, name, effect) else {
            return R::refused_result();
        };
        match f(&mut *call.scope.context) {
            Ok(result) => {
                call.end();
                result
            }
            Err(error) => {
                call.fail(name, error);
                R::refused_result()
            }
        }
    }

    /// As [`Self::call`], in the host's floating-point state: what sets an attribute is called per vertex, and to
    /// read that state takes as long as the call. Where it converts, it sets the state itself.
    #[inline(always)]
    pub(crate) fn call_of_attribute<R: RefusedResult>(
        &mut self,
        name: &'static str,
        begin_end: BeginEnd,
        f: impl FnOnce(&mut Self) -> Result<R>,
    ) -> R {
        let scope = CallScope { context: self };
        let result = match begin_end {
            BeginEnd::Refused if !scope.context.leave_vertices(name) => Ok(R::refused_result()),
            BeginEnd::Refused | BeginEnd::Allowed => f(scope.context),
        };
        drop(scope);
        self.answer(name, result)
    }

    /// Notes an error of the call `name`, and hands messages to the client's callback.
    #[inline(always)]
    fn answer<R: RefusedResult>(&mut self, name: &'static str, result: Result<R>) -> R {
        let result = result.unwrap_or_else(|error: GlError| {
            self.refuse(name, error);
            R::refused_result()
        });
        self.debug.deliver();
        result
    }

    /// Whether the call is not between `glBegin` and `glEnd`, where it is refused.
    #[inline]
    fn is_outside_primitive(&mut self, name: &'static str) -> bool {
        let is_outside = self.immediate.is_none();
        if !is_outside {
            self.refuse(name, between_begin_and_end());
        }
        is_outside
    }

    /// Before a call that may not stand between `glBegin` and `glEnd`: what ended is drawn with the
    /// state of now. Whether the call may follow.
    #[inline(never)]
    fn leave_vertices(&mut self, name: &'static str) -> bool {
        if !self.is_outside_primitive(name) {
            return false;
        }
        if self.pending.as_ref().is_some_and(|ended| !ended.survives(name)) {
            draw_pending(self);
        }
        self.state_changes.count_call();
        true
    }

    /// Before a setter of plain state: as [`Self::leave_vertices`], but pending vertices keep the state instead of being
    /// drawn.
    #[inline]
    fn leave_vertices_to_setter(&mut self, name: &'static str) -> bool {
        if !self.is_outside_primitive(name) {
            return false;
        }
        match &self.pending {
            Some(PendingPrimitives::Vertices(_)) if self.pending_state.is_none() => {
                let state = PlainState::of(&self.state);
                self.pending_state = Some(PendingState { state, call: self.state_changes.calls });
            }
            Some(ended @ PendingPrimitives::Bitmaps(_)) if !ended.survives(name) => {
                draw_pending(self);
            }
            Some(_) | None => {}
        }
        self.state_changes.count_setter();
        true
    }

    /// In a setter of plain state: sets a field. To set what is set already changes nothing that draws depend on.
    #[inline]
    pub(crate) fn set_plain<T: PartialEq>(
        &mut self,
        field: impl FnOnce(&mut State) -> &mut T,
        value: T,
    ) {
        let field = field(&mut self.state);
        if *field == value {
            self.state_changes.no_change();
        }
        // Of equal numbers, queries show the sign of a zero.
        *field = value;
    }

    /// As [`Self::set_plain`], of a field that is changed in part.
    #[inline]
    pub(crate) fn change_plain<T: PartialEq + Clone>(
        &mut self,
        field: impl FnOnce(&mut State) -> &mut T,
        change: impl FnOnce(&mut T),
    ) {
        let field = field(&mut self.state);
        let before = field.clone();
        change(field);
        if *field == before {
            self.state_changes.no_change();
        }
    }

    /// In a setter of plain state that is about to change other state: as the beginning of any other call.
    pub(crate) fn leave_plain_state(&mut self) {
        draw_pending(self);
        self.state_changes.count_call();
    }
}

/// What a call may change that draws depend on, and so what happens to pending vertices before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum CallEffect {
    /// It may stand between `glBegin` and `glEnd`.
    Vertices,
    /// Any state: pending vertices are drawn.
    AnyState,
    /// Plain state: pending vertices keep that of now.
    PlainState,
    /// No state.
    Nothing,
}

/// A call that computes, in DetGL's floating-point state. Neither end is inlined, as each entry point has an instance of
/// [`Context::call_with`].
struct ComputingCall<'a> {
    scope: CallScope<'a>,
    _float_env: FloatEnv,
}

impl<'a> ComputingCall<'a> {
    /// `None` where the call is refused.
    #[inline(never)]
    fn begin(context: &'a mut Context, name: &'static str, effect: CallEffect) -> Option<Self> {
        let float_env = FloatEnv::enter();
        let call = Self { scope: CallScope { context }, _float_env: float_env };
        let context = &mut *call.scope.context;
        let may_follow = match effect {
            CallEffect::Vertices => true,
            CallEffect::AnyState => context.leave_vertices(name),
            CallEffect::PlainState => context.leave_vertices_to_setter(name),
            CallEffect::Nothing => context.is_outside_primitive(name),
        };
        if may_follow {
            return Some(call);
        }
        call.end();
        None
    }

    /// Ends the call, and hands messages to the client's callback.
    #[inline(never)]
    fn end(self) {
        let Self { scope, _float_env: float_env } = self;
        scope.context.objects.shared.release();
        drop(float_env);
        scope.context.debug.deliver();
    }

    /// Ends the call with an error.
    #[cold]
    #[inline(never)]
    fn fail(self, name: &'static str, error: GlError) {
        self.scope.context.refuse(name, error);
        self.end();
    }
}

#[cold]
#[inline(never)]
fn between_begin_and_end() -> GlError {
    GlError::new(
        ErrorCode::InvalidOperation,
        "GL 2.1, section 2.6.3",
        "must not be called between glBegin and glEnd: glEnd is missing",
    )
}
