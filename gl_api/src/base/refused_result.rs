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
pub trait RefusedResult {
    /// The answer.
    fn refused_result() -> Self;
}

impl RefusedResult for () {
    fn refused_result() {}
}

impl RefusedResult for bool {
    fn refused_result() -> Self {
        false
    }
}

impl RefusedResult for u8 {
    fn refused_result() -> Self {
        0
    }
}

impl RefusedResult for u32 {
    fn refused_result() -> Self {
        0
    }
}

impl RefusedResult for i32 {
    fn refused_result() -> Self {
        -1
    }
}

impl RefusedResult for *mut GLvoid {
    fn refused_result() -> Self {
        std::ptr::null_mut()
    }
}

impl RefusedResult for &'static str {
    fn refused_result() -> Self {
        ""
    }
}

impl<T> RefusedResult for *const T {
    fn refused_result() -> Self {
        std::ptr::null()
    }
}
