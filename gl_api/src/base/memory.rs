//! Memory whose size a client chooses: where there is none, that is `GL_OUT_OF_MEMORY`, never the end of the process.

use crate::base::error::{ErrorCode, GlError, Result};
use std::collections::TryReserveError;

/// A copy of a client's memory.
///
/// # Errors
/// If there is no memory for it.
pub(crate) fn copied<T: Copy>(from: &[T]) -> Result<Vec<T>, TryReserveError> {
    let mut to = Vec::new();
    to.try_reserve_exact(from.len())?;
    to.extend_from_slice(from);
    Ok(to)
}

/// `GL_OUT_OF_MEMORY` for `what`, in the plural.
pub(crate) fn out_of_memory(
    section: &'static str,
    what: impl std::fmt::Display,
) -> impl FnOnce(TryReserveError) -> GlError {
    move |error| {
        GlError::new(
            ErrorCode::OutOfMemory,
            section,
            format!("there is no memory for {what}: {error}"),
        )
    }
}
