//! GL errors for images that cannot be stored.

use crate::base::error::{ErrorCode, GlError};
use texunit::image::ImageError;

/// The GL error for an image that cannot be stored.
pub(crate) fn storage_error(section: &'static str, error: &ImageError) -> GlError {
    let code = match error {
        ImageError::NoMean { .. } | ImageError::CutsBlocks { .. } => ErrorCode::InvalidOperation,
        ImageError::TooLarge { .. }
        | ImageError::NotCubes { .. }
        | ImageError::OutOfMemory { .. }
        | ImageError::WrongBorder { .. }
        | ImageError::TooShort { .. }
        | ImageError::Outside { .. }
        | ImageError::NoSuchLevel { .. }
        | ImageError::Missing { .. } => ErrorCode::OutOfMemory,
    };
    GlError::new(code, section, error.to_string())
}
