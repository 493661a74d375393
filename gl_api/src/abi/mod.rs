//! The C ABI: every entry point under its own name, and EGL, OSMesa and GLU around them.
//!
//! The tables of [`crate::entry`] call [`c_export!`](macro@c_export) for each name; what it makes
//! turns C's arguments into those of the Rust method ([`param`]) and never lets a panic out. How
//! much memory a pointer stands for is in the Khronos registry, and in [`lengths`] where the
//! registry only names a formula.
//!
//! | module | is |
//! |---|---|
//! | [`memory`] | a pointer of a C program, read with the length that the call computes |
//! | [`param`] | C's arguments and results, and ours |
//! | [`lengths`] | how many elements a typed pointer has |
//! | [`proc_address`] | functions by name |
//! | [`egl`] | EGL 1.5: displays, configs, surfaces, contexts |
//! | [`osmesa`] | OSMesa: contexts that draw into the client's memory |
//! | [`glu`] | GLU under its C names |
//! | [`glx`] | the names of GLX |
//! | [`imaging`] | the names of the imaging subset |
//! | [`thread_ends`] | what becomes of a current context |
//!
//! This is the one place of this crate with `unsafe`. What it trusts is what C's prototypes cannot
//! say: that a pointer has as many elements as the specification lets the call read or write.
#![allow(unsafe_code, reason = "C's pointers; see the module's documentation")]

mod egl;
mod glu;
#[cfg(feature = "c-abi")]
mod glx;
#[cfg(feature = "c-abi")]
mod imaging;
pub(crate) mod lengths;
pub(crate) mod memory;
pub(crate) mod osmesa;
pub(crate) mod param;
pub(crate) mod proc_address;
pub(crate) mod thread_ends;

use crate::entry::{Fallback, with_current};
use crate::error::{ErrorCode, GlError};
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Has the C functions of the GL entry points as associated functions.
pub(crate) struct Exports;

/// The C function of an entry point: `c_export!(method glName (parameters) -> result)`.
macro_rules! c_export {
    ($method:ident $gl:ident ($($param:ident: $ty:ty),*) $(-> $ret:ty)?) => {
        #[allow(unsafe_code, reason = "C's pointers; see the module `abi`")]
        impl $crate::abi::Exports {
            #[cfg_attr(feature = "c-abi", unsafe(no_mangle))]
            #[allow(
                non_snake_case,
                clippy::extra_unused_lifetimes,
                clippy::too_many_arguments,
                reason = "GL's name and signature; 'a is there for the rows that borrow"
            )]
            pub(crate) unsafe extern "C" fn $gl<'a>(
                $($param: <$ty as $crate::abi::param::Param<'a>>::Raw),*
            ) $(-> <$ret as $crate::abi::param::Return>::Raw)? {
                #[allow(clippy::extra_unused_lifetimes, reason = "for the rows that borrow")]
                fn run<'a>(
                    $($param: &'a mut <$ty as $crate::abi::param::Param<'a>>::Held),*
                ) $(-> $ret)? {
                    $crate::entry::call(stringify!($gl), |context| {
                        context.$method(
                            $(<$ty as $crate::abi::param::Param<'a>>::lend($param)),*
                        )
                    })
                }
                let result = $crate::abi::guard(stringify!($gl), || {
                    let rules = const {
                        $crate::abi::lengths::rules(
                            stringify!($gl),
                            [$(<$ty as $crate::abi::param::Param<'a>>::COUNTED),*],
                        )
                    };
                    let _arguments: &[isize] =
                        &[$(<$ty as $crate::abi::param::Param<'a>>::number($param)),*];
                    let mut _rules = rules.iter();
                    $(
                        let rule = _rules.next();
                        let length = match <$ty as $crate::abi::param::Param<'a>>::COUNTED {
                            $crate::abi::param::Counted::No => 0,
                            $crate::abi::param::Counted::Elements
                            | $crate::abi::param::Counted::Text => {
                                rule.map_or(0, |rule| rule.length(_arguments))
                            }
                        };
                        // SAFETY: the caller vouches for its pointers, as C's prototypes cannot.
                        let mut $param = unsafe {
                            <$ty as $crate::abi::param::Param<'a>>::hold($param, length, _arguments)
                        };
                    )*
                    run($(&mut $param),*)
                });
                $crate::abi::param::Return::to_c(result)
            }
        }
    };
}
pub(crate) use c_export;

/// Functions that no table has: each under its C name, and their names and addresses as `FUNCTIONS`.
macro_rules! c_functions {
    ($($name:ident($($param:ident: $ty:ty),* $(,)?) $(-> $ret:ty)? $body:block)*) => {
        $(
            #[cfg_attr(feature = "c-abi", unsafe(no_mangle))]
            #[allow(non_snake_case, clippy::too_many_arguments, reason = "C's name and signature")]
            unsafe extern "C" fn $name($($param: $ty),*) $(-> $ret)? {
                $crate::abi::guard(stringify!($name), || {
                    // SAFETY: pointers are what the function's prototype says they are.
                    unsafe { $crate::abi::trust(|| $body) }
                })
            }
        )*
        /// Names and addresses.
        pub(in $crate::abi) const FUNCTIONS: &[(&str, *const ())] =
            &[$((stringify!($name), $name as *const ())),*];
    };
}
pub(crate) use c_functions;

/// Runs the body of a C function.
///
/// # Safety
/// The pointers that the body was given are what the function's prototype says they are.
#[inline(always)]
unsafe fn trust<R>(body: impl FnOnce() -> R) -> R {
    body()
}

/// Runs a call from C; a panic becomes a GL error with a message.
pub(crate) fn guard<R: Fallback>(name: &'static str, f: impl FnOnce() -> R) -> R {
    catch_unwind(AssertUnwindSafe(f)).unwrap_or_else(|panic| {
        failed(name, &*panic);
        R::fallback()
    })
}

/// Makes a panic a GL error.
#[cold]
#[inline(never)]
fn failed(name: &'static str, panic: &(dyn Any + Send)) {
    let error = GlError::new(
        ErrorCode::InvalidOperation,
        "no rule of the specification",
        format!("DetGL failed inside this call, please report it: {}", text(panic)),
    );
    // A second panic, as from a thread that is ending, has nobody to tell.
    let told = catch_unwind(AssertUnwindSafe(|| {
        with_current(|context| context.debug.error(name, &error));
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
