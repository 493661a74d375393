//! How pixels lie in the client's memory: GL 2.1, section 3.6.1 and table 3.1.

use crate::constants::*;
use crate::context::Context;
use crate::error::{Result, Table, invalid_value};
use crate::types::*;

const SECTION: &str = "GL 2.1, section 3.6.1";

/// The parameters of one direction.
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

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parameter {
    SwapBytes,
    LsbFirst,
    RowLength,
    SkipRows,
    ImageHeight,
    SkipImages,
    SkipPixels,
    Alignment,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Direction {
    Pack,
    Unpack,
}

const PARAMETER: Table<(Direction, Parameter)> = Table {
    section: SECTION,
    rows: &[
        (GL_UNPACK_ALIGNMENT, (Direction::Unpack, Parameter::Alignment)),
        (GL_UNPACK_ROW_LENGTH, (Direction::Unpack, Parameter::RowLength)),
        (GL_UNPACK_SKIP_ROWS, (Direction::Unpack, Parameter::SkipRows)),
        (GL_UNPACK_IMAGE_HEIGHT, (Direction::Unpack, Parameter::ImageHeight)),
        (GL_UNPACK_SKIP_IMAGES, (Direction::Unpack, Parameter::SkipImages)),
        (GL_UNPACK_SKIP_PIXELS, (Direction::Unpack, Parameter::SkipPixels)),
        (GL_UNPACK_SWAP_BYTES, (Direction::Unpack, Parameter::SwapBytes)),
        (GL_UNPACK_LSB_FIRST, (Direction::Unpack, Parameter::LsbFirst)),
        (GL_PACK_ALIGNMENT, (Direction::Pack, Parameter::Alignment)),
        (GL_PACK_ROW_LENGTH, (Direction::Pack, Parameter::RowLength)),
        (GL_PACK_SKIP_ROWS, (Direction::Pack, Parameter::SkipRows)),
        (GL_PACK_IMAGE_HEIGHT, (Direction::Pack, Parameter::ImageHeight)),
        (GL_PACK_SKIP_IMAGES, (Direction::Pack, Parameter::SkipImages)),
        (GL_PACK_SKIP_PIXELS, (Direction::Pack, Parameter::SkipPixels)),
        (GL_PACK_SWAP_BYTES, (Direction::Pack, Parameter::SwapBytes)),
        (GL_PACK_LSB_FIRST, (Direction::Pack, Parameter::LsbFirst)),
    ],
};

pub(crate) fn pixel_storei(context: &mut Context, pname: GLenum, param: GLint) -> Result<()> {
    let (direction, parameter) = PARAMETER.decode("pname", pname)?;
    let store = match direction {
        Direction::Pack => &mut context.state.pack,
        Direction::Unpack => &mut context.state.unpack,
    };
    let size = usize::try_from(param);
    match (parameter, size) {
        (Parameter::SwapBytes, _) => store.swap_bytes = param != 0,
        (Parameter::LsbFirst, _) => store.lsb_first = param != 0,
        (Parameter::RowLength, Ok(size)) => store.row_length = size,
        (Parameter::SkipRows, Ok(size)) => store.skip_rows = size,
        (Parameter::ImageHeight, Ok(size)) => store.image_height = size,
        (Parameter::SkipImages, Ok(size)) => store.skip_images = size,
        (Parameter::SkipPixels, Ok(size)) => store.skip_pixels = size,
        (Parameter::Alignment, Ok(size @ (1 | 2 | 4 | 8))) => store.alignment = size,
        (Parameter::Alignment, _) => {
            return invalid_value(
                SECTION,
                format!("{} = {param} must be 1, 2, 4 or 8", enum_name(pname)),
            );
        }
        (
            Parameter::RowLength
            | Parameter::SkipRows
            | Parameter::ImageHeight
            | Parameter::SkipImages
            | Parameter::SkipPixels,
            Err(_),
        ) => {
            return invalid_value(
                SECTION,
                format!("{} = {param} must not be negative", enum_name(pname)),
            );
        }
    }
    Ok(())
}

pub(crate) fn pixel_storef(context: &mut Context, pname: GLenum, param: GLfloat) -> Result<()> {
    pixel_storei(context, pname, (param + 0.5).floor() as GLint)
}
