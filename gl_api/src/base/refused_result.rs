//! The results of calls that are not carried out: no context is current, or the call is refused.

use crate::base::types::GLvoid;

/// The result of a call that is not carried out.
pub trait RefusedResult {
    /// That result.
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
