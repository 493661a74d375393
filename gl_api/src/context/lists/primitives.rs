//! `glBegin` to `glEnd` in a display list: one buffer, filled when the list is compiled. Where several follow one
//! another whose primitives share no vertices, they are joined in one buffer and one draw: it costs what many vertices
//! do.

use crate::base::limits::LOCATIONS;
use crate::base::memory::copied;
use crate::base::topology::topology;
use crate::base::types::*;
use crate::context::immediate;
use crate::context::immediate::{COLUMNS, ColumnComponents, Slot, VALUE};
use crate::context::lists::Step;
use crate::context::pending_primitives::vertices_of_primitive;
use crate::state::State;
use rasterizer::driver::{Buffer, Topology};
use std::collections::TryReserveError;

/// Attributes since `glBegin`, in order.
#[derive(Debug)]
pub(crate) struct OpenPrimitives {
    pub mode: GLenum,
    pub log: Vec<(Slot, [f32; 4])>,
    /// Whether there was no memory for one: then nothing of them is drawn.
    pub is_lost: bool,
}

impl OpenPrimitives {
    pub fn new(mode: GLenum) -> Self {
        Self { mode, log: Vec::new(), is_lost: false }
    }

    /// # Errors
    /// Where there is no memory, once.
    pub fn push(&mut self, slot: Slot, value: [f32; 4]) -> Result<(), TryReserveError> {
        if self.is_lost {
            return Ok(());
        }
        if let Err(error) = self.log.try_reserve(1) {
            (self.log, self.is_lost) = (Vec::new(), true);
            return Err(error);
        }
        self.log.push((slot, value));
        Ok(())
    }
}

/// An attribute that the list sets between `glBegin` and `glEnd`.
#[derive(Debug)]
pub(crate) struct Column {
    pub location: usize,
    /// The vertices before it have the value from before the list.
    inherited: usize,
    /// Of its own values.
    components: ColumnComponents,
    /// What is current in the end.
    pub last: [f32; 4],
}

/// The vertices of a `glBegin` and `glEnd`, or of several.
#[derive(Debug)]
pub(crate) struct ListPrimitives {
    pub topology: Topology,
    pub count: usize,
    /// Where each `glBegin` but the first stands among the vertices.
    pub begins: Vec<usize>,
    /// Positions, then a column for each of `columns`.
    pub buffer: Buffer,
    /// Of the positions.
    position_components: ColumnComponents,
    pub columns: Vec<Column>,
}

impl ListPrimitives {
    /// `None` where a call is not valid.
    ///
    /// # Errors
    /// Where there is no memory.
    pub(crate) fn new(open: &OpenPrimitives) -> Result<Option<Self>, TryReserveError> {
        let Ok(topology) = topology(open.mode) else { return Ok(None) };
        let mut positions: Vec<[f32; 4]> = Vec::new();
        let mut columns: Vec<(Column, Vec<[f32; 4]>)> = Vec::new();
        for &(slot, value) in &open.log {
            let Ok(location) = immediate::location(slot) else { return Ok(None) };
            match location {
                None => {
                    positions.try_reserve(1)?;
                    positions.push(value);
                    for (column, values) in &mut columns {
                        values.try_reserve(1)?;
                        values.push(column.last);
                    }
                }
                Some(location) => {
                    match columns.iter_mut().find(|(column, _)| column.location == location) {
                        Some((column, _)) => column.last = value,
                        None => {
                            let inherited = positions.len();
                            let components = ColumnComponents::default();
                            let column = Column { location, inherited, components, last: value };
                            let mut values = Vec::new();
                            values.try_reserve_exact(inherited)?;
                            values.resize(inherited, [0.0; 4]);
                            columns.push((column, values));
                        }
                    }
                }
            }
        }
        let mut bytes = Vec::new();
        bytes.try_reserve_exact((columns.len() + 1) * positions.len() * VALUE)?;
        bytes.extend_from_slice(bytemuck::cast_slice(&positions));
        for (column, values) in &mut columns {
            bytes.extend_from_slice(bytemuck::cast_slice(values));
            column.components = ColumnComponents::of(&values[column.inherited..]);
        }
        Ok(Some(Self {
            topology,
            count: positions.len(),
            begins: Vec::new(),
            buffer: Buffer::new(bytes),
            position_components: ColumnComponents::of(&positions),
            columns: columns.into_iter().map(|(column, _)| column).collect(),
        }))
    }

    /// The buffer with the values that the first vertices inherit.
    ///
    /// # Errors
    /// Where there is no memory.
    pub(crate) fn patched(&self, state: &State) -> Result<Buffer, TryReserveError> {
        if self.columns.iter().all(|column| column.inherited == 0) {
            return Ok(self.buffer.clone());
        }
        let mut bytes = copied(self.buffer.bytes())?;
        for (index, column) in self.columns.iter().enumerate() {
            let first = (index + 1) * self.count * VALUE;
            let inherited = &mut bytes[first..first + column.inherited * VALUE];
            let current = immediate::current(state, column.location);
            for value in inherited.chunks_exact_mut(VALUE) {
                value.copy_from_slice(bytemuck::cast_slice(&current));
            }
        }
        Ok(Buffer::new(bytes))
    }

    /// How many components are read of the positions, and of each column of the buffer that [`Self::patched`] gives.
    pub(crate) fn components(&self, state: &State) -> [ColumnComponents; COLUMNS + 1] {
        let mut all = [self.position_components; COLUMNS + 1];
        for (components, column) in all[1..].iter_mut().zip(&self.columns) {
            *components = column.components;
            if column.inherited > 0 {
                let inherited = immediate::current(state, column.location);
                *components = components.with(ColumnComponents::of(&[inherited]));
            }
        }
        all
    }

    /// Whether `next` can be joined, without `glEnd` and `glBegin` in between: primitives share no vertices, and the
    /// same attributes vary.
    fn can_join(&self, next: &Self) -> bool {
        let has = |location: usize| next.columns.iter().any(|column| column.location == location);
        vertices_of_primitive(self.topology).is_some_and(|each| {
            let is_whole = |count: usize| count > 0 && count.is_multiple_of(each);
            self.topology == next.topology && is_whole(self.count) && is_whole(next.count)
        }) && self.columns.len() == next.columns.len()
            // What glMaterial changes within glBegin and glEnd counts from glEnd on.
            && self.columns.iter().all(|column| column.location < LOCATIONS && has(column.location))
    }

    /// Joins primitives that can be joined. Where there is no memory for it, they stay as they are.
    fn joined(run: Vec<Self>) -> Vec<Self> {
        match Self::join(&run) {
            Some(joined) => vec![joined],
            None => run,
        }
    }

    /// Several as one; `None` where there are no several, or no memory.
    fn join(run: &[Self]) -> Option<Self> {
        if run.len() < 2 {
            return None;
        }
        let first = &run[0];
        let count = run.iter().map(|shapes| shapes.count).sum();
        let (mut bytes, mut begins) = (Vec::new(), Vec::new());
        bytes.try_reserve_exact((first.columns.len() + 1) * count * VALUE).ok()?;
        begins.try_reserve_exact(run.len()).ok()?;
        let mut begin = 0;
        for shapes in run {
            begins.push(begin);
            begin += shapes.count;
            bytes.extend_from_slice(&shapes.buffer.bytes()[..shapes.count * VALUE]);
        }
        begins.remove(0);
        let mut columns = Vec::with_capacity(first.columns.len());
        for &Column { location, inherited, .. } in &first.columns {
            let mut last: Option<[f32; 4]> = None;
            let mut components = ColumnComponents::default();
            for shapes in run {
                let Some(index) = shapes.columns.iter().position(|own| own.location == location)
                else {
                    continue;
                };
                let column = &shapes.columns[index];
                let values = &shapes.buffer.bytes()[(index + 1) * shapes.count * VALUE..];
                let (before, own) =
                    values[..shapes.count * VALUE].split_at(column.inherited * VALUE);
                match last {
                    None => bytes.extend_from_slice(before),
                    Some(last) => (0..column.inherited).for_each(|_| {
                        bytes.extend_from_slice(bytemuck::cast_slice::<f32, u8>(&last))
                    }),
                }
                bytes.extend_from_slice(own);
                components = components.with(column.components);
                if let Some(last) = last.filter(|_| column.inherited > 0) {
                    components = components.with(ColumnComponents::of(&[last]));
                }
                last = Some(column.last);
            }
            columns.push(Column { location, inherited, components, last: last? });
        }
        let positions = run.iter().map(|shapes| shapes.position_components);
        Some(Self {
            topology: first.topology,
            count,
            begins,
            buffer: Buffer::new(bytes),
            position_components: positions
                .fold(ColumnComponents::default(), ColumnComponents::with),
            columns,
        })
    }
}

/// The steps of a list, with primitives joined that can be.
pub(crate) fn join(steps: Vec<Step>) -> Vec<Step> {
    let mut joined = Vec::new();
    if joined.try_reserve_exact(steps.len()).is_err() {
        return steps;
    }
    let mut run: Vec<ListPrimitives> = Vec::new();
    let close = |joined: &mut Vec<Step>, run: &mut Vec<ListPrimitives>| {
        let all = ListPrimitives::joined(std::mem::take(run));
        joined.extend(all.into_iter().map(Step::Primitives));
    };
    for step in steps {
        match step {
            Step::Primitives(shapes) => {
                if run.last().is_some_and(|last| !last.can_join(&shapes))
                    || run.try_reserve(1).is_err()
                {
                    close(&mut joined, &mut run);
                }
                run.push(shapes);
            }
            Step::Call { .. } | Step::Attribute(..) | Step::Arrays(_) => {
                close(&mut joined, &mut run);
                joined.push(step);
            }
        }
    }
    close(&mut joined, &mut run);
    joined
}
