//! `glEnd` without a draw of its own: vertices that ended wait for more of their kind, and so do bitmaps.
//!
//! A program that draws face by face calls `glBegin` and `glEnd` by the thousand, and a draw costs what
//! hundreds of vertices do. The first of them is drawn. As long as nothing but vertices follows, what
//! was true of it is true of the next: they can be drawn without an error, with the same state, at any
//! time before something else happens ([`draw_ended`]).

use crate::base::limits::LOCATIONS;
use crate::context::Context;
use crate::context::ended::{Ended, vertices_of_primitive};
use crate::context::immediate::{Column, Immediate};
use crate::draw::complete::{checked_drawable, draws_integers};
use crate::state::enable::Flag;

/// So many vertices do not wait any longer.
const MOST: usize = 1 << 16;

/// Whether it makes no difference if primitives are drawn together or one after the other, and is no
/// error. A program can count those of a draw, and each draw is written down for who watches.
pub(crate) fn draws_together(context: &Context) -> bool {
    let enables = &context.state.enables;
    context.immediate.is_none()
        && context.watched.is_none()
        && context.state.bindings.program.name() == 0
        && !enables.has(Flag::VertexProgram)
        && !enables.has(Flag::FragmentProgram)
        && !context.transform_feedback.is_active()
        && !draws_integers(context)
        && checked_drawable(context).is_ok()
}

/// Takes what ends to what waits already, if they can be drawn together.
pub(crate) fn joins(context: &mut Context, immediate: &mut Immediate) -> bool {
    let Some(Ended::Vertices(ended)) = &mut context.ended else { return false };
    let same = ended.topology == immediate.topology
        && is_whole(immediate)
        && ended.columns.len() == immediate.columns.len()
        && ended.columns.iter().all(|column| immediate.column_of(column.location).is_some());
    if !same {
        return false;
    }
    ended.positions.append(&mut immediate.positions);
    for Column { location, values } in &mut ended.columns {
        if let Some(place) = immediate.column_of(*location) {
            values.append(&mut immediate.columns[place].values);
        }
    }
    if ended.positions.len() >= MOST {
        draw_waiting(context);
    }
    true
}

/// Whether there are only whole primitives, and at least one.
fn is_whole(immediate: &Immediate) -> bool {
    let count = immediate.positions.len();
    let each = vertices_of_primitive(immediate.topology);
    count > 0 && each.is_some_and(|each| count.is_multiple_of(each))
}

/// Remembers what was just drawn without an error, as others like it may follow.
pub(crate) fn keep_for_more(context: &mut Context, mut immediate: Immediate) {
    let constant = immediate.columns.iter().all(|column| column.location < LOCATIONS);
    if constant && is_whole(&immediate) && context.is_alone() && draws_together(context) {
        immediate.positions.clear();
        immediate.columns.iter_mut().for_each(|column| column.values.clear());
        context.ended = Some(Ended::Vertices(immediate));
    }
}

/// Draws what waits, and lets nothing more join it: something else is about to happen.
pub(crate) fn draw_ended(context: &mut Context) {
    draw_waiting(context);
    context.ended = None;
}

fn draw_waiting(context: &mut Context) {
    let mut ended = match context.ended.take() {
        Some(Ended::Vertices(ended)) => ended,
        Some(Ended::Bitmaps(bitmaps)) => {
            return crate::draw::bitmaps::draw_waiting(context, &bitmaps);
        }
        None => return,
    };
    if !ended.positions.is_empty() {
        // What the driver cannot do is said, as of every draw.
        if let Err(error) = ended.draw(context) {
            context.refuse("glEnd", error);
        }
        ended.positions.clear();
        ended.columns.iter_mut().for_each(|column| column.values.clear());
    }
    context.ended = Some(Ended::Vertices(ended));
}
