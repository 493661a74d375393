//! `glBegin` to `glEnd` in a list: one buffer, filled when the list is compiled. Consecutive ones of the same state share
//! a buffer and a draw.

use crate::base::begin_end::BeginEnd;
use crate::base::error::{Result, invalid_operation};
use crate::context::Context;
use crate::context::immediate::Columns;
use crate::context::lists::Step;
use crate::context::lists::primitives::{ListPrimitives, OpenPrimitives};
use crate::draw::pending_primitives::can_batch;
use std::ops::Range;

impl OpenPrimitives {
    /// One step for all, where every call is valid; else step by step, so that the errors come
    /// when the list is called.
    pub fn close(self) -> Vec<Step> {
        match ListPrimitives::new(&self) {
            Some(shapes) => vec![Step::Primitives(shapes)],
            None => {
                let mut steps = self.into_steps();
                steps.push(end_step());
                steps
            }
        }
    }

    /// The calls one by one.
    pub fn into_steps(self) -> Vec<Step> {
        let mode = self.mode;
        let begin = Step::Call {
            name: "glBegin",
            begin_end: BeginEnd::Allowed,
            unpack: None,
            run: Box::new(move |context| crate::calls::vertex::immediate::begin(context, mode)),
        };
        let attributes = self.log.into_iter().map(|(slot, value)| Step::Attribute(slot, value));
        std::iter::once(begin).chain(attributes).collect()
    }
}

impl ListPrimitives {
    /// The vertices of each draw: all at once, where that makes no difference.
    pub fn parts(&self, context: &Context) -> Vec<Range<usize>> {
        let together = self.begins.is_empty() || can_batch(context);
        let others = if together { &[][..] } else { &self.begins };
        let begins = std::iter::once(0).chain(others.iter().copied());
        let ends = others.iter().copied().chain([self.count]);
        begins.zip(ends).map(|(begin, end)| begin..end).collect()
    }

    /// Draws a part of them, and leaves the attributes as the calls would.
    pub fn draw(&self, context: &mut Context, part: Range<usize>) -> Result<()> {
        if context.immediate.is_some() {
            return invalid_operation(
                "GL 2.1, section 2.6.3",
                "glBegin was called before: glEnd is missing",
            );
        }
        let result = if part.is_empty() { Ok(()) } else { self.draw_vertices(context, part) };
        for column in &self.columns {
            crate::calls::vertex::immediate::set_current(context, column.location, column.last);
        }
        result
    }

    fn draw_vertices(&self, context: &mut Context, part: Range<usize>) -> Result<()> {
        let buffer = match part.start {
            0 => self.patched(&context.state),
            _ => self.buffer.clone(),
        };
        let components = self.components(&context.state);
        let columns = Columns { buffer: &buffer, components, count: self.count, range: part };
        crate::calls::vertex::immediate::draw_columns(context, self.topology, columns, |location| {
            self.columns.iter().position(|column| column.location == location)
        })
    }
}

/// `glEnd` on its own.
pub(crate) fn end_step() -> Step {
    Step::Call {
        name: "glEnd",
        begin_end: BeginEnd::Allowed,
        unpack: None,
        run: Box::new(crate::calls::vertex::immediate::end),
    }
}
