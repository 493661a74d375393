//! `glBegin` to `glEnd` in a list: one buffer, filled when the list is compiled. Consecutive ones of the same state share
//! a buffer and a draw.

use crate::base::begin_end::BeginEnd;
use crate::base::error::{Result, invalid_operation};
use crate::base::memory::out_of_memory;
use crate::context::Context;
use crate::context::immediate::Columns;
use crate::context::lists::Step;
use crate::context::lists::primitives::{ListPrimitives, OpenPrimitives};
use crate::draw::pending_primitives::can_batch;
use std::collections::TryReserveError;
use std::ops::Range;

impl OpenPrimitives {
    /// One step for all, where every call is valid; else step by step, so that the errors come
    /// when the list is called.
    ///
    /// # Errors
    /// Where there is no memory.
    pub fn close(self) -> Result<Vec<Step>, TryReserveError> {
        if self.is_lost {
            return Ok(Vec::new());
        }
        match ListPrimitives::new(&self)? {
            Some(shapes) => Ok(vec![Step::Primitives(shapes)]),
            None => {
                let mut steps = self.into_steps()?;
                steps.push(end_step());
                Ok(steps)
            }
        }
    }

    /// The calls one by one.
    ///
    /// # Errors
    /// Where there is no memory.
    pub fn into_steps(self) -> Result<Vec<Step>, TryReserveError> {
        let (mode, mut steps) = (self.mode, Vec::new());
        // One more for the end.
        steps.try_reserve_exact(self.log.len() + 2)?;
        let begin = Step::Call {
            name: "glBegin",
            begin_end: BeginEnd::Allowed,
            unpack: None,
            run: Box::new(move |context| crate::calls::vertex::immediate::begin(context, mode)),
        };
        let attributes = self.log.into_iter().map(|(slot, value)| Step::Attribute(slot, value));
        steps.extend(std::iter::once(begin).chain(attributes));
        Ok(steps)
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
            0 => {
                let what = "the vertices of a display list";
                self.patched(&context.state).map_err(out_of_memory("GL 2.1, section 5.4", what))?
            }
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
