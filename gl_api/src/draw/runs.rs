//! Several draws by one call: `glMultiDrawArrays` and its kin. What is no array's or buffer's is checked
//! before the first is drawn, so that a call that is refused for it draws nothing.

use super::calls::{INDEX_TYPE, IndexRequest, SECTION, draw_arrays, draw_indexed, topology};
use crate::context::Context;
use crate::entry::{Data, Pointers};
use crate::error::{Result, invalid_operation, not_negative};
use crate::types::*;

/// How many draws a multi-draw has, of these counts and as many others; all are checked before the
/// first is drawn.
fn draws(primcount: GLsizei, count: &[GLsizei], others: usize) -> Result<usize> {
    let draws = not_negative(SECTION, "primcount", primcount.into())?;
    let has = count.len().min(others);
    if has < draws {
        return invalid_operation(
            SECTION,
            format!("primcount = {draws}, but the memory has {has} elements"),
        );
    }
    for &count in &count[..draws] {
        not_negative(SECTION, "count", count.into())?;
    }
    Ok(draws)
}

pub(crate) fn multi_draw_arrays(
    context: &mut Context,
    mode: GLenum,
    first: &[GLint],
    count: &[GLsizei],
    primcount: GLsizei,
) -> Result<()> {
    topology(mode)?;
    let draws = draws(primcount, count, first.len())?;
    let all = first.iter().zip(count).take(draws);
    for (&first, _) in all.clone().filter(|(_, count)| **count != 0) {
        not_negative(SECTION, "first", first.into())?;
    }
    for (&first, &count) in all {
        draw_arrays(context, mode, if count == 0 { 0 } else { first }, count)?;
    }
    Ok(())
}

pub(crate) fn multi_draw_elements(
    context: &mut Context,
    mode: GLenum,
    count: &[GLsizei],
    ty: GLenum,
    indices: Pointers<'_>,
    primcount: GLsizei,
) -> Result<()> {
    multi_draw_indexed(context, mode, count, ty, indices, primcount, None)
}

/// Draws several runs of indices, each with its own base vertex or all with 0.
fn multi_draw_indexed(
    context: &mut Context,
    mode: GLenum,
    count: &[GLsizei],
    ty: GLenum,
    indices: Pointers<'_>,
    primcount: GLsizei,
    base_vertices: Option<&[GLint]>,
) -> Result<()> {
    topology(mode)?;
    INDEX_TYPE.decode("type", ty)?;
    let others = base_vertices.map_or(usize::MAX, <[_]>::len);
    let draws = draws(primcount, count, indices.0.len().min(others))?;
    for (at, (&count, &indices)) in count.iter().zip(&indices.0).enumerate().take(draws) {
        // Where no index is read, it does not matter from where.
        let indices = if count == 0 { Data::Null } else { indices };
        let base_vertex = base_vertices.map_or(0, |all| all[at]);
        draw_indexed(context, mode, IndexRequest { count, ty, indices, base_vertex }, 1)?;
    }
    Ok(())
}

pub(crate) fn multi_draw_elements_base_vertex(
    context: &mut Context,
    mode: GLenum,
    count: &[GLsizei],
    ty: GLenum,
    indices: Pointers<'_>,
    primcount: GLsizei,
    base_vertex: &[GLint],
) -> Result<()> {
    multi_draw_indexed(context, mode, count, ty, indices, primcount, Some(base_vertex))
}
