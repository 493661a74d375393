//! The thread's current context.
//!
//! A call takes the context out of its place for as long as it runs, so that nothing can borrow it
//! twice; a call from within a call finds no context, and is ignored.
//!
//! The place has nothing to destroy, so that it is there to the end of the thread: the main thread's
//! destructors run before the functions of `atexit`, which may call GL. What a thread that is
//! ending leaves there is dropped by [`ThreadEnd`], or by the host that the context belongs to.

use crate::base::types::GLvoid;

/// What a call answers where it has nothing to say.
pub trait Fallback {
    /// The answer.
    fn fallback() -> Self;
}

impl Fallback for () {
    fn fallback() {}
}

impl Fallback for bool {
    fn fallback() -> Self {
        false
    }
}

impl Fallback for u8 {
    fn fallback() -> Self {
        0
    }
}

impl Fallback for u32 {
    fn fallback() -> Self {
        0
    }
}

impl Fallback for i32 {
    fn fallback() -> Self {
        -1
    }
}

impl Fallback for *mut GLvoid {
    fn fallback() -> Self {
        std::ptr::null_mut()
    }
}

impl Fallback for &'static str {
    fn fallback() -> Self {
        ""
    }
}

impl<T> Fallback for *const T {
    fn fallback() -> Self {
        std::ptr::null()
    }
}
