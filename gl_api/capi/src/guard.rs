//! The door: every call from C goes through [`enter`].

use gl_api::host::{self, FloatEnv, RefusedResult};
use gl_api::with_current;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs the body of a C function. What a call needs of the host program, and what it must not let out to it, is dealt
/// with here and nowhere else: a panic ends here. What computes sets the floating-point state ([`enter_computing`]).
///
/// # Errors
/// What the body panicked with.
pub(crate) fn enter<R>(body: impl FnOnce() -> R) -> Result<R, Box<dyn Any + Send>> {
    catch_unwind(AssertUnwindSafe(body))
}

/// As [`enter`], in DetGL's floating-point state.
///
/// # Errors
/// As of [`enter`].
pub(crate) fn enter_computing<R>(body: impl FnOnce() -> R) -> Result<R, Box<dyn Any + Send>> {
    let _float_env = FloatEnv::enter();
    enter(body)
}

/// Runs a call; a panic becomes a GL error with a message.
pub(crate) fn guard<R: RefusedResult>(name: &'static str, body: impl FnOnce() -> R) -> R {
    enter_computing(body).unwrap_or_else(|panic| {
        failed(name, &*panic);
        R::refused_result()
    })
}

/// As [`guard`], for the methods of a context, which set the floating-point state where they compute: to read it takes as
/// long as to set an attribute.
pub(crate) fn guard_method<R: RefusedResult>(name: &'static str, body: impl FnOnce() -> R) -> R {
    enter(body).unwrap_or_else(|panic| {
        failed(name, &*panic);
        R::refused_result()
    })
}

/// Makes a panic a GL error.
#[cold]
#[inline(never)]
fn failed(name: &'static str, panic: &(dyn Any + Send)) {
    let rule = format!("DetGL failed inside this call, please report it: {}", text(panic));
    // A second panic, as from a thread that is ending, has nobody to tell.
    let told = catch_unwind(AssertUnwindSafe(|| {
        with_current(|context| host::refuse(context, name, "no rule of the specification", rule));
    }));
    drop(told);
}

/// What a panic said.
fn text(panic: &(dyn Any + Send)) -> &str {
    match (panic.downcast_ref::<&str>(), panic.downcast_ref::<String>()) {
        (Some(text), _) => text,
        (None, Some(text)) => text,
        (None, None) => "no reason given",
    }
}

/// Functions that no table has: each under its C name, and their names and addresses as `FUNCTIONS`.
macro_rules! c_functions {
    ($($name:ident($($param:ident: $ty:ty),* $(,)?) $(-> $ret:ty)? $body:block)*) => {
        $(
            #[cfg_attr(feature = "c-names", unsafe(no_mangle))]
            #[allow(non_snake_case, clippy::too_many_arguments, reason = "C's name and signature")]
            unsafe extern "C" fn $name($($param: $ty),*) $(-> $ret)? {
                $crate::guard::guard(stringify!($name), || {
                    // SAFETY: pointers are what the function's prototype says they are.
                    unsafe { $crate::guard::trust(|| $body) }
                })
            }
        )*
        /// Names and addresses.
        pub(crate) const FUNCTIONS: &[(&str, *const ())] =
            &[$((stringify!($name), $name as *const ())),*];
    };
}
pub(crate) use c_functions;

/// Runs the body of a C function.
///
/// # Safety
/// The pointers that the body was given are what the function's prototype says they are.
#[inline(always)]
pub(crate) unsafe fn trust<R>(body: impl FnOnce() -> R) -> R {
    body()
}
