//! Memory whose size a client chooses: where there is none, that is `GL_OUT_OF_MEMORY`, never the end of the process.

use crate::base::error::{ErrorCode, GlError};
use std::collections::TryReserveError;
pub(crate) use texunit::image::copied;

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
