//! `glMultiDrawArrays` and `glMultiDrawElements`: several draws by one call. All are checked before the first is drawn,
//! so that a call that is refused draws nothing.

use crate::base::args::{Data, Pointers};
use crate::base::error::{Result, invalid_operation, not_negative};
use crate::base::topology::topology;
use crate::base::types::*;
use crate::calls::vertex::array_objects::require_vertex_array;
use crate::calls::vertex::draws::{Instances, SECTION, check_arrays, draw_arrays, has_positions};
use crate::calls::vertex::elements::{IndexRequest, draw_indexed};
use crate::calls::vertex::indices::{INDEX_TYPE, check_indices};
use crate::context::Context;

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
    let topology = topology(mode)?;
    require_vertex_array(context)?;
    let draws = draws(primcount, count, first.len())?;
    let all = first.iter().zip(count).take(draws);
    let some = all.clone().filter(|(_, count)| **count != 0);
    for (&first, _) in some.clone() {
        not_negative(SECTION, "first", first.into())?;
    }
    // What goes farthest.
    let farthest = some.max_by_key(|(first, count)| i64::from(**first) + i64::from(**count));
    if let Some((&first, &count)) = farthest.filter(|_| draws > 1) {
        if !has_positions(context, topology) {
            return context.empty_draw("glMultiDrawArrays");
        }
        check_arrays(context, first, count)?;
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
    let index_type = INDEX_TYPE.decode("type", ty)?;
    let others = base_vertices.map_or(usize::MAX, <[_]>::len);
    let draws = draws(primcount, count, indices.0.len().min(others))?;
    let all = count.iter().zip(&indices.0).take(draws);
    for (&count, &indices) in all.clone().filter(|(count, _)| **count != 0) {
        check_indices(context, indices, count, index_type)?;
    }
    for (at, (&count, &indices)) in all.enumerate() {
        // Where no index is read, it does not matter from where.
        let indices = if count == 0 { Data::Null } else { indices };
        let base_vertex = base_vertices.map_or(0, |all| all[at]);
        draw_indexed(
            context,
            mode,
            IndexRequest { count, ty, indices, base_vertex },
            Instances::ONE,
        )?;
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
