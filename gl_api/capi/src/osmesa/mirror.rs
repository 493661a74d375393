//! The memory of an OSMesa client, which has the picture after `glFlush` and `glFinish`.

use crate::memory;
use gl_api::Context;
use gl_api::host::{FirstRow, Pixels, SurfaceMirror, copy_colors, pixel_bytes};

/// The client's memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mirror {
    /// The address of its first byte.
    pub memory: usize,
    pub pixels: Pixels,
    /// Pixels from a row to the next; 0 is the width.
    pub row_length: usize,
    pub first: FirstRow,
}

impl SurfaceMirror for Mirror {
    fn update(&self, context: &Context) {
        let Some(pixel) = pixel_bytes(self.pixels) else { return };
        let (width, height) = context.size();
        let [width, height] = [width, height].map(|side| side as usize);
        let length = if self.row_length > 0 { self.row_length } else { width };
        let stride = length.saturating_mul(pixel);
        let before = (height - 1).saturating_mul(stride);
        let bytes = before.saturating_add(width * pixel);
        // SAFETY: OSMesaMakeCurrent was promised so many bytes for as long as the context draws there.
        let bytes =
            unsafe { memory::bytes_mut(std::ptr::with_exposed_provenance_mut(self.memory), bytes) };
        if !bytes.is_empty() {
            copy_colors(context, self.pixels, self.first, bytes, stride);
        }
    }
}
