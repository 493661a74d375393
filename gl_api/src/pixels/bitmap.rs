//! `glBitmap`: GL 2.1, section 3.7.

use super::position;
use super::rectangle::{self, Holds};
use crate::context::Context;
use crate::entry::Data;
use crate::error::{Result, invalid_operation, not_negative};
use crate::feedback::record::Kind;
use crate::feedback::{self, Mode};
use crate::framebuffer::complete::draw_pass;
use crate::state::pixel_store::PixelStore;
use crate::texture::memory;
use crate::types::*;

const SECTION: &str = "GL 2.1, section 3.7";

/// Where the bits of a bitmap lie.
pub(crate) struct Bits {
    /// Bytes from a row to the next.
    stride: usize,
    skip_rows: usize,
    skip_pixels: usize,
    lsb_first: bool,
    /// Bytes that the memory must have.
    needed: usize,
}

impl Bits {
    pub fn new(store: &PixelStore, width: usize, height: usize) -> Result<Self> {
        let per_row = if store.row_length > 0 { store.row_length } else { width };
        let stride = per_row.div_ceil(8).next_multiple_of(store.alignment);
        let last = store.skip_pixels.checked_add(width).map(|bits| bits.div_ceil(8));
        let rows = store.skip_rows.checked_add(height.saturating_sub(1));
        let needed = if width == 0 || height == 0 {
            Some(0)
        } else {
            rows.and_then(|rows| rows.checked_mul(stride))
                .and_then(|start| start.checked_add(last?))
        };
        match needed {
            Some(needed) => Ok(Self {
                stride,
                skip_rows: store.skip_rows,
                skip_pixels: store.skip_pixels,
                lsb_first: store.lsb_first,
                needed,
            }),
            None => invalid_operation(SECTION, "the bitmap reaches beyond the address space"),
        }
    }

    /// Bytes that the memory must have.
    pub fn needed(&self) -> usize {
        self.needed
    }

    /// The bitmap's memory, if all of it is there.
    pub fn checked<'a>(&self, bytes: &'a [u8], [width, height]: [usize; 2]) -> Result<&'a [u8]> {
        if bytes.len() < self.needed {
            return invalid_operation(
                SECTION,
                format!(
                    "a bitmap of {width}×{height} takes {} bytes; there are {}",
                    self.needed,
                    bytes.len()
                ),
            );
        }
        Ok(bytes)
    }

    /// Whether a pixel is set.
    pub fn at(&self, bytes: &[u8], x: usize, y: usize) -> bool {
        let bit = self.skip_pixels + x;
        let byte = bytes[(self.skip_rows + y) * self.stride + bit / 8];
        let place = if self.lsb_first { bit % 8 } else { 7 - bit % 8 };
        byte >> place & 1 == 1
    }
}

/// A window coordinate on the subpixel grid, as vertices have it: a position that was meant to be a
/// whole pixel is one, whatever the transformation's rounding was.
fn snapped(coordinate: f64) -> f64 {
    const SUBPIXEL: f64 = 256.0;
    (coordinate * SUBPIXEL).round_ties_even() / SUBPIXEL
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn bitmap(
    context: &mut Context,
    width: GLsizei,
    height: GLsizei,
    xorig: GLfloat,
    yorig: GLfloat,
    xmove: GLfloat,
    ymove: GLfloat,
    bitmap: Data<'_>,
) -> Result<()> {
    let width = not_negative(SECTION, "width", width.into())?;
    let height = not_negative(SECTION, "height", height.into())?;
    draw_pass(context)?;
    let bits = Bits::new(&context.state.unpack, width, height)?;
    let source = memory::source(context, bitmap, bits.needed)?;
    if !context.state.raster_position.valid {
        return Ok(());
    }
    if let Some(source) = source.filter(|_| bits.needed > 0) {
        let bytes = bits.checked(source.bytes(), [width, height])?;
        if feedback::record::pixels(context, Kind::Bitmap) != Mode::Render {
            position::advance(context, [xmove, ymove]);
            return Ok(());
        }
        // The rectangle begins at a whole pixel, and is not zoomed.
        let before = context.state.raster_position.window;
        let zoom = std::mem::replace(&mut context.state.pixel_zoom, [1.0; 2]);
        let origin = [xorig, yorig].map(f64::from);
        let start = &mut context.state.raster_position.window;
        for axis in 0..2 {
            start[axis] = snapped(before[axis] - origin[axis]).floor();
        }
        let drawn = rectangle::draw(context, [width, height], Holds::Coverage, |x, y| {
            [if bits.at(bytes, x, y) { 1.0 } else { 0.0 }; 4]
        });
        context.state.raster_position.window = before;
        context.state.pixel_zoom = zoom;
        drawn?;
    }
    position::advance(context, [xmove, ymove]);
    Ok(())
}
