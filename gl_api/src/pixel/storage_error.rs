//! What an image that cannot be stored means to the client.

use crate::base::error::{ErrorCode, GlError};
use texunit::image::ImageError;

/// What an image that cannot be stored means to the client.
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
