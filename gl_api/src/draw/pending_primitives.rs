//! `glEnd`s that follow one another as one draw: which vertices may be pending, and when they are drawn.
//! [`PendingPrimitives`] has them, and says why.

use crate::base::limits::LOCATIONS;
use crate::context::Context;
use crate::context::immediate::{Column, Immediate};
use crate::context::pending_primitives::{PendingPrimitives, vertices_of_primitive};
use crate::draw::completeness::{checked_drawable, draws_integers};
use crate::draw::no_effect;
use crate::state::enable::Flag;

/// Pending vertices are drawn when there are this many.
const MAX_PENDING: usize = 1 << 16;

/// Whether primitives give the same picture in one draw as in several, without an error. Programs can read the number
/// of a primitive in its draw, and while a pixel is watched each draw has a note.
pub(crate) fn can_batch(context: &Context) -> bool {
    let enables = &context.state.enables;
    no_effect::leaves_out(context)
        && context.immediate.is_none()
        && context.watched.is_none()
        && !context.has_program()
        && !enables.has(Flag::VertexProgram)
        && !enables.has(Flag::FragmentProgram)
        && !context.transform_feedback.is_active()
        && !draws_integers(context)
        && checked_drawable(context).is_ok()
}

/// Moves vertices to the pending ones, if they can be drawn together; `false` if they are left.
pub(crate) fn append_pending(context: &mut Context, immediate: &mut Immediate) -> bool {
    let Some(PendingPrimitives::Vertices(pending)) = &mut context.pending else { return false };
    let same = pending.topology == immediate.topology
        && has_whole_primitives(immediate)
        && pending.columns.len() == immediate.columns.len()
        && pending.columns.iter().all(|column| immediate.column_of(column.location).is_some());
    if !same {
        return false;
    }
    let changes = &context.state_changes;
    if let Some(kept) = &mut context.pending_state
        && changes.last_change() > kept.call
    {
        if !kept.state.is_of(&context.state) {
            return false;
        }
        kept.call = changes.calls;
    }
    // Where there is no memory, they are drawn as they are.
    if pending.make_room(immediate.positions.len()).is_err() {
        return false;
    }
    pending.positions.append(&mut immediate.positions);
    for Column { location, values } in &mut pending.columns {
        if let Some(column) = immediate.column_of(*location) {
            values.append(&mut immediate.columns[column].values);
        }
    }
    if pending.positions.len() >= MAX_PENDING {
        draw_pending_vertices(context);
    }
    true
}

/// Whether the vertices form whole primitives, at least one.
fn has_whole_primitives(immediate: &Immediate) -> bool {
    let count = immediate.positions.len();
    let each = vertices_of_primitive(immediate.topology);
    count > 0 && each.is_some_and(|each| count.is_multiple_of(each))
}

/// Keeps what was just drawn without an error, emptied of its vertices, so that others like it can be pending.
pub(crate) fn keep_pending(context: &mut Context, mut immediate: Immediate) {
    let constant = immediate.columns.iter().all(|column| column.location < LOCATIONS);
    if constant
        && has_whole_primitives(&immediate)
        && context.objects.shared.is_exclusive()
        && can_batch(context)
    {
        immediate.positions.clear();
        immediate.columns.iter_mut().for_each(|column| column.values.clear());
        context.pending = Some(PendingPrimitives::Vertices(immediate));
    }
}

/// Draws what is pending, and keeps nothing: something else is about to happen.
pub(crate) fn draw_pending(context: &mut Context) {
    draw_pending_vertices(context);
    context.pending = None;
}

fn draw_pending_vertices(context: &mut Context) {
    let mut pending = match context.pending.take() {
        Some(PendingPrimitives::Vertices(pending)) => pending,
        Some(PendingPrimitives::Bitmaps(bitmaps)) => {
            return crate::draw::pending_bitmaps::draw_pending_bitmaps(context, &bitmaps);
        }
        None => return,
    };
    let kept = context.pending_state.take();
    let mut state = kept.filter(|kept| context.state_changes.last_change() > kept.call);
    if !pending.positions.is_empty() {
        if let Some(state) = &mut state {
            state.state.swap(&mut context.state);
        }
        // The driver may refuse it, as every draw.
        if let Err(error) = pending.draw(context) {
            context.refuse("glEnd", error);
        }
        if let Some(state) = &mut state {
            state.state.swap(&mut context.state);
            // What was decided with the state from before does not hold.
            context.state_changes.count_call();
        }
        pending.positions.clear();
        pending.columns.iter_mut().for_each(|column| column.values.clear());
    }
    context.pending = Some(PendingPrimitives::Vertices(pending));
}
