//! `glInterleavedArrays`: GL 2.1, table 2.5.

use crate::base::args::Data;
use crate::base::constants::*;
use crate::base::error::{Result, Table, not_negative};
use crate::base::types::*;
use crate::calls::enable::{disable_client_state, enable_client_state};
use crate::context::Context;

const F: usize = size_of::<f32>();
/// Bytes of a colour of four bytes.
const C: usize = 4;

/// A row of table 2.5: sizes of texture coordinates, colour and vertex, type of the colour, the
/// bytes where colour, normal and vertex begin, and bytes of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Row {
    tex_coord: Option<GLint>,
    color: Option<(GLint, GLenum, usize)>,
    normal: Option<usize>,
    vertex: (GLint, usize),
    stride: usize,
}

const fn row(
    tex_coord: Option<GLint>,
    color: Option<(GLint, GLenum, usize)>,
    normal: Option<usize>,
    vertex: (GLint, usize),
    stride: usize,
) -> Row {
    Row { tex_coord, color, normal, vertex, stride }
}

const UB: GLenum = GL_UNSIGNED_BYTE;

const FORMAT: Table<Row> = Table {
    section: "GL 2.1, table 2.5",
    rows: &[
        (GL_V2F, row(None, None, None, (2, 0), 2 * F)),
        (GL_V3F, row(None, None, None, (3, 0), 3 * F)),
        (GL_C4UB_V2F, row(None, Some((4, UB, 0)), None, (2, C), C + 2 * F)),
        (GL_C4UB_V3F, row(None, Some((4, UB, 0)), None, (3, C), C + 3 * F)),
        (GL_C3F_V3F, row(None, Some((3, GL_FLOAT, 0)), None, (3, 3 * F), 6 * F)),
        (GL_N3F_V3F, row(None, None, Some(0), (3, 3 * F), 6 * F)),
        (GL_C4F_N3F_V3F, row(None, Some((4, GL_FLOAT, 0)), Some(4 * F), (3, 7 * F), 10 * F)),
        (GL_T2F_V3F, row(Some(2), None, None, (3, 2 * F), 5 * F)),
        (GL_T4F_V4F, row(Some(4), None, None, (4, 4 * F), 8 * F)),
        (GL_T2F_C4UB_V3F, row(Some(2), Some((4, UB, 2 * F)), None, (3, C + 2 * F), C + 5 * F)),
        (GL_T2F_C3F_V3F, row(Some(2), Some((3, GL_FLOAT, 2 * F)), None, (3, 5 * F), 8 * F)),
        (GL_T2F_N3F_V3F, row(Some(2), None, Some(2 * F), (3, 5 * F), 8 * F)),
        (
            GL_T2F_C4F_N3F_V3F,
            row(Some(2), Some((4, GL_FLOAT, 2 * F)), Some(6 * F), (3, 9 * F), 12 * F),
        ),
        (
            GL_T4F_C4F_N3F_V4F,
            row(Some(4), Some((4, GL_FLOAT, 4 * F)), Some(8 * F), (4, 11 * F), 15 * F),
        ),
    ],
};

/// The same memory from a byte on. Where there is none, no part has any.
fn from<'a>(context: &Context, pointer: Data<'a>, bytes: usize) -> Data<'a> {
    let is_null = match pointer {
        Data::Null | Data::Offset(0) => true,
        Data::Client(pointer) => pointer.is_null(),
        Data::Bytes(_) | Data::Offset(_) => false,
    };
    if is_null && context.state.bindings.array_buffer.name() == 0 {
        return Data::Null;
    }
    match pointer {
        Data::Bytes(all) => Data::Bytes(all.get(bytes..).unwrap_or(&[])),
        Data::Offset(offset) => Data::Offset(offset.saturating_add(bytes)),
        Data::Client(pointer) if !pointer.is_null() => Data::Client(pointer.forward(bytes)),
        Data::Null | Data::Client(_) if bytes == 0 => Data::Null,
        Data::Null | Data::Client(_) => Data::Offset(bytes),
    }
}

pub(crate) fn interleaved_arrays(
    context: &mut Context,
    format: GLenum,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let row = FORMAT.decode("format", format)?;
    let given = not_negative("GL 2.1, section 2.8", "stride", stride.into())?;
    let stride = if given == 0 { row.stride as GLsizei } else { stride };
    // What is refused is refused here, before anything has changed.
    let (size, at) = row.vertex;
    crate::calls::vertex::arrays::vertex_pointer(
        context,
        size,
        GL_FLOAT,
        stride,
        from(context, pointer, at),
    )?;
    enable_client_state(context, GL_VERTEX_ARRAY)?;
    disable_client_state(context, GL_EDGE_FLAG_ARRAY)?;
    disable_client_state(context, GL_INDEX_ARRAY)?;
    disable_client_state(context, GL_SECONDARY_COLOR_ARRAY)?;
    disable_client_state(context, GL_FOG_COORD_ARRAY)?;
    match row.tex_coord {
        Some(size) => {
            enable_client_state(context, GL_TEXTURE_COORD_ARRAY)?;
            crate::calls::vertex::arrays::tex_coord_pointer(
                context, size, GL_FLOAT, stride, pointer,
            )?;
        }
        None => disable_client_state(context, GL_TEXTURE_COORD_ARRAY)?,
    }
    match row.color {
        Some((size, ty, at)) => {
            enable_client_state(context, GL_COLOR_ARRAY)?;
            let pointer = from(context, pointer, at);
            crate::calls::vertex::arrays::color_pointer(context, size, ty, stride, pointer)?;
        }
        None => disable_client_state(context, GL_COLOR_ARRAY)?,
    }
    match row.normal {
        Some(at) => {
            enable_client_state(context, GL_NORMAL_ARRAY)?;
            let pointer = from(context, pointer, at);
            crate::calls::vertex::arrays::normal_pointer(context, GL_FLOAT, stride, pointer)?;
        }
        None => disable_client_state(context, GL_NORMAL_ARRAY)?,
    }
    Ok(())
}
