//! `glEnd` without a draw of its own: vertices that ended wait for more of their kind, and so do bitmaps.
//!
//! A program that draws face by face calls `glBegin` and `glEnd` by the thousand, and a draw costs what
//! hundreds of vertices do. The first of them is drawn. As long as nothing but vertices follows, what
//! was true of it is true of the next: they can be drawn without an error, with the same state, at any
//! time before something else happens ([`draw_ended`]).

use super::immediate::{Column, Immediate};
use crate::context::Context;
use crate::framebuffer::complete::{checked_drawable, draws_integers};
use crate::pixels::bitmap::{self, Bitmaps};
use crate::state::LOCATIONS;
use crate::state::enable::Flag;
use rasterizer::driver::Topology;

/// What waits.
#[derive(Debug)]
pub(crate) enum Ended {
    /// Primitives.
    Vertices(Immediate),
    /// Bitmaps.
    Bitmaps(Box<Bitmaps>),
}

impl Ended {
    /// Whether it may wait while a call is made that may not stand between `glBegin` and `glEnd`.
    pub fn outlasts(&self, call: &str) -> bool {
        match self {
            Self::Vertices(_) => false,
            Self::Bitmaps(_) => bitmap::outlast(call),
        }
    }
}

/// So many vertices do not wait any longer.
const MOST: usize = 1 << 16;

/// How many vertices a primitive has, if it has none in common with others.
pub(crate) fn vertices_of_primitive(topology: Topology) -> Option<usize> {
    match topology {
        Topology::Points => Some(1),
        Topology::Lines => Some(2),
        Topology::Triangles => Some(3),
        Topology::Quads => Some(4),
        Topology::LineStrip
        | Topology::LineLoop
        | Topology::TriangleStrip
        | Topology::TriangleFan
        | Topology::QuadStrip
        | Topology::Polygon => None,
    }
}

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
pub(super) fn joins(context: &mut Context, immediate: &mut Immediate) -> bool {
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
pub(super) fn keep_for_more(context: &mut Context, mut immediate: Immediate) {
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
        Some(Ended::Bitmaps(bitmaps)) => return bitmap::draw_waiting(context, &bitmaps),
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

#[cfg(test)]
mod tests {
    use crate::constants::*;
    use crate::context::{Context, ContextDesc};
    use rasterizer::driver::Command;

    fn ten_points(c: &mut Context) {
        for x in 0..10 {
            c.begin(GL_POINTS);
            c.color_3f(1.0, 0.0, 0.0);
            c.vertex_2f(x as f32 / 10.0, 0.0);
            c.end();
        }
    }

    fn draws(c: &Context) -> Vec<u32> {
        let commands = c.recorder.commands.commands.iter();
        let counts = commands.filter_map(|command| match command {
            Command::Draw { count, .. } => Some(*count),
            _ => None,
        });
        counts.collect()
    }

    #[test]
    fn what_follows_the_first_is_one_draw_and_a_list_is_one() {
        let mut c = Context::new(ContextDesc::default()).expect("a device");
        ten_points(&mut c);
        assert_eq!(draws(&c), [1]);
        c.matrix_mode(GL_PROJECTION);
        assert_eq!(draws(&c), [1, 9]);
        c.new_list(1, GL_COMPILE);
        ten_points(&mut c);
        c.end_list();
        c.call_list(1);
        assert_eq!(draws(&c), [1, 9, 10]);
    }
}
