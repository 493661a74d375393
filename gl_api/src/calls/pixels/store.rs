//! `glPixelStore`: GL 2.1, section 3.6.1 and table 3.1.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_value};
use crate::base::types::*;
use crate::context::Context;

const SECTION: &str = "GL 2.1, section 3.6.1";

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
    let param = match PARAMETER.decode("pname", pname)?.1 {
        Parameter::SwapBytes | Parameter::LsbFirst => GLint::from(param != 0.0),
        Parameter::RowLength
        | Parameter::SkipRows
        | Parameter::ImageHeight
        | Parameter::SkipImages
        | Parameter::SkipPixels
        | Parameter::Alignment => param.round() as GLint,
    };
    pixel_storei(context, pname, param)
}
