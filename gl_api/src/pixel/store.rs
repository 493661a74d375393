//! Pixel storage modes: `glPixelStore`, GL 2.1, section 3.6.1 and table 3.1.

/// The modes of packing or of unpacking.
#[derive(Clone, Debug)]
pub(crate) struct PixelStore {
    pub swap_bytes: bool,
    /// Kept for queries; it concerns bitmaps alone.
    pub lsb_first: bool,
    /// Pixels in a row, where not 0; else as many as the rectangle has.
    pub row_length: usize,
    pub skip_rows: usize,
    /// Rows of an image of a volume, where not 0; else as many as the box has.
    pub image_height: usize,
    pub skip_images: usize,
    pub skip_pixels: usize,
    /// Each row begins at a multiple of this: 1, 2, 4 or 8 bytes.
    pub alignment: usize,
}

impl Default for PixelStore {
    fn default() -> Self {
        Self {
            swap_bytes: false,
            lsb_first: false,
            row_length: 0,
            skip_rows: 0,
            image_height: 0,
            skip_images: 0,
            skip_pixels: 0,
            alignment: 4,
        }
    }
}
