//! Memory for texels on the way between the client, textures and framebuffers.

use crate::base::error::{ErrorCode, GlError, Result};
use texunit::format::Format;

const SECTION: &str = "GL 2.1, section 3.8.2";

/// Memory for the texels of a box.
pub(crate) fn scratch(format: Format, size: [usize; 3]) -> Result<Vec<u8>> {
    let sides = size.iter().chain([&format.bytes()]).try_fold(1_usize, |a, &b| a.checked_mul(b));
    let bytes = sides.unwrap_or(usize::MAX);
    texunit::image::zeroed(bytes).ok_or_else(|| {
        GlError::new(
            ErrorCode::OutOfMemory,
            SECTION,
            format!("there is no memory for {bytes} bytes of texels"),
        )
    })
}
