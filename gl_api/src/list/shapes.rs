//! `glBegin` to `glEnd` in a list: one buffer, filled when the list is compiled.

use super::Step;
use crate::context::Context;
use crate::draw::calls::topology;
use crate::draw::immediate::{self, Slot, VALUE};
use crate::entry::Place;
use crate::error::{Result, invalid_operation};
use crate::state::State;
use crate::types::*;
use rasterizer::driver::{Buffer, Topology};

/// Attributes since `glBegin`, in order.
#[derive(Debug)]
pub(super) struct Open {
    mode: GLenum,
    log: Vec<(Slot, [f32; 4])>,
}

impl Open {
    pub fn new(mode: GLenum) -> Self {
        Self { mode, log: Vec::new() }
    }

    pub fn push(&mut self, slot: Slot, value: [f32; 4]) {
        self.log.push((slot, value));
    }

    /// One step for all, where every call is valid; else step by step, so that the errors come
    /// when the list is called.
    pub fn close(self) -> Vec<Step> {
        match Shapes::new(&self) {
            Some(shapes) => vec![Step::Shapes(shapes)],
            None => {
                let mut steps = self.spill();
                steps.push(end_step());
                steps
            }
        }
    }

    /// The calls one by one.
    pub fn spill(self) -> Vec<Step> {
        let mode = self.mode;
        let begin = Step::Call {
            name: "glBegin",
            place: Place::Anywhere,
            unpack: None,
            run: Box::new(move |context| immediate::begin(context, mode)),
        };
        let attributes = self.log.into_iter().map(|(slot, value)| Step::Attribute(slot, value));
        std::iter::once(begin).chain(attributes).collect()
    }
}

/// `glEnd` on its own.
pub(super) fn end_step() -> Step {
    Step::Call {
        name: "glEnd",
        place: Place::Anywhere,
        unpack: None,
        run: Box::new(immediate::end),
    }
}

/// An attribute that the list sets between `glBegin` and `glEnd`.
#[derive(Debug)]
struct Column {
    location: usize,
    /// The vertices before it have the value from before the list.
    inherited: usize,
    /// What is current in the end.
    last: [f32; 4],
}

/// The vertices of a `glBegin` and `glEnd`.
#[derive(Debug)]
pub(super) struct Shapes {
    topology: Topology,
    count: usize,
    /// Positions, then a column for each of `columns`.
    buffer: Buffer,
    columns: Vec<Column>,
}

impl Shapes {
    /// `None` where a call is not valid.
    fn new(open: &Open) -> Option<Self> {
        let topology = topology(open.mode).ok()?;
        let mut positions: Vec<[f32; 4]> = Vec::new();
        let mut columns: Vec<(Column, Vec<[f32; 4]>)> = Vec::new();
        for &(slot, value) in &open.log {
            match immediate::location(slot).ok()? {
                None => {
                    positions.push(value);
                    for (column, values) in &mut columns {
                        values.push(column.last);
                    }
                }
                Some(location) => {
                    match columns.iter_mut().find(|(column, _)| column.location == location) {
                        Some((column, _)) => column.last = value,
                        None => {
                            let inherited = positions.len();
                            let column = Column { location, inherited, last: value };
                            columns.push((column, vec![[0.0; 4]; inherited]));
                        }
                    }
                }
            }
        }
        let mut bytes = Vec::with_capacity((columns.len() + 1) * positions.len() * VALUE);
        bytes.extend_from_slice(bytemuck::cast_slice(&positions));
        for (_, values) in &columns {
            bytes.extend_from_slice(bytemuck::cast_slice(values));
        }
        Some(Self {
            topology,
            count: positions.len(),
            buffer: Buffer::new(bytes),
            columns: columns.into_iter().map(|(column, _)| column).collect(),
        })
    }

    /// The buffer with the values that the first vertices inherit.
    fn patched(&self, state: &State) -> Buffer {
        if self.columns.iter().all(|column| column.inherited == 0) {
            return self.buffer.clone();
        }
        let mut bytes = self.buffer.bytes().to_vec();
        for (index, column) in self.columns.iter().enumerate() {
            let first = (index + 1) * self.count * VALUE;
            let inherited = &mut bytes[first..first + column.inherited * VALUE];
            let current = immediate::current(state, column.location);
            for value in inherited.chunks_exact_mut(VALUE) {
                value.copy_from_slice(bytemuck::cast_slice(&current));
            }
        }
        Buffer::new(bytes)
    }

    /// Draws them, and leaves the attributes as the calls would.
    pub fn draw(&self, context: &mut Context) -> Result<()> {
        if context.immediate.is_some() {
            return invalid_operation(
                "GL 2.1, section 2.6.3",
                "glBegin was called before: glEnd is missing",
            );
        }
        let result = if self.count > 0 { self.draw_vertices(context) } else { Ok(()) };
        for column in &self.columns {
            immediate::set_current(context, column.location, column.last);
        }
        result
    }

    fn draw_vertices(&self, context: &mut Context) -> Result<()> {
        let buffer = self.patched(&context.state);
        immediate::draw_columns(context, self.topology, &buffer, self.count, |location| {
            self.columns.iter().position(|column| column.location == location)
        })
    }
}
