//! What passes of a device use: its description, pools of reusable objects, explanations of plans.

use super::report::DeviceError;
use crate::plan::LeaveOut;
use crate::raster::{
    Chunk, FIRST_WAVE, FREE_OPERATIONS, ShapeLists, TileRenderer, free_operations,
};
use crate::shader::Machine;
use crate::threads::ObjectPool;
use crate::vertex::Geometry;
use parking_lot::Mutex;
use std::collections::BTreeSet;
use std::sync::Arc;
use texunit::lanes::Isa;

/// What a device is made from.
#[derive(Clone, Copy, Debug)]
pub struct DeviceDesc {
    /// The instruction set of every kernel.
    pub isa: Isa,
    /// How many threads shade tiles, with the one that asks; at least 1.
    pub threads: usize,
    /// The operations that the batches of a draw may run, beyond what is free for each batch, before the rest of the draw
    /// is left out: about as many additions of 64 lanes.
    pub budget: u64,
    /// Whether each draw's plan is printed.
    pub explain: Explain,
    /// Whether draws leave out what has no effect.
    pub leave_out: LeaveOut,
}

/// Whether each draw's plan is printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Explain {
    /// It is not.
    #[default]
    Off,
    /// Each different plan once, to standard error.
    Print,
    /// Different plans are recorded for [`super::Device::take_explanations`].
    Keep,
}

impl DeviceDesc {
    /// The default budget. A draw that does not end uses it up, and what is free in the tiles of a wave: less than half
    /// a second of two threads.
    pub const BUDGET: u64 = 1 << 26;

    /// The default budget, silence, and nothing done that has no effect.
    pub const fn new(isa: Isa, threads: usize) -> Self {
        let leave_out = LeaveOut::WithoutEffect;
        Self { isa, threads, budget: Self::BUDGET, explain: Explain::Off, leave_out }
    }

    /// The operations of a batch that are not charged to its draw.
    pub const FREE_OPERATIONS: u64 = FREE_OPERATIONS;

    /// The operations of a batch of vertices, of a draw with this budget.
    pub fn batch_budget(budget: u64) -> u64 {
        Self::batch_budget_after(budget, 0)
    }

    /// The operations of a batch of vertices, of a draw with this budget of which draws of its frame have spent some.
    pub(super) fn batch_budget_after(budget: u64, spent: u64) -> u64 {
        let left = budget.saturating_sub(spent);
        free_operations(budget, spent).saturating_add(left / FIRST_WAVE as u64)
    }

    /// From `DETGL_ISA`, `DETGL_THREADS`, `DETGL_DRAW_BUDGET`, `DETGL_EXPLAIN` and `DETGL_LEAVE_OUT`, else the widest
    /// instruction set, every core, the default budget, silence, and nothing done that has no effect.
    ///
    /// # Errors
    /// When a variable names something that this machine does not have.
    pub fn from_env() -> Result<Self, DeviceError> {
        let isa = Isa::from_env()?;
        let threads = match std::env::var("DETGL_THREADS") {
            Ok(text) => text
                .parse()
                .ok()
                .filter(|n| (1..=1024).contains(n))
                .ok_or(DeviceError::Threads(text))?,
            Err(_) => std::thread::available_parallelism().map_or(1, usize::from),
        };
        let explain = match std::env::var("DETGL_EXPLAIN") {
            Ok(text) if text != "0" => Explain::Print,
            Ok(_) | Err(_) => Explain::Off,
        };
        let budget = match std::env::var("DETGL_DRAW_BUDGET") {
            Ok(text) => text.parse().map_err(|_| DeviceError::Budget(text))?,
            Err(_) => Self::BUDGET,
        };
        let leave_out = match std::env::var("DETGL_LEAVE_OUT") {
            Ok(text) if text == "0" => LeaveOut::Nothing,
            Ok(_) | Err(_) => LeaveOut::WithoutEffect,
        };
        Ok(Self { isa, threads, budget, explain, leave_out })
    }
}

/// What passes of a device use.
#[derive(Debug)]
pub(super) struct Resources {
    pub desc: DeviceDesc,
    /// Interpreters of vertex programs.
    pub machines: ObjectPool<Machine>,
    /// Memory for shaded vertices.
    pub geometries: ObjectPool<Geometry>,
    /// Memory for shapes.
    pub lists: ObjectPool<ShapeLists>,
    /// Scratch of the threads that run tiles.
    pub tile_renderers: ObjectPool<TileRenderer>,
    /// The plans seen so far.
    explained: Mutex<BTreeSet<String>>,
    explanations: Mutex<Vec<String>>,
}

impl Resources {
    /// Nothing in use yet.
    pub fn new(desc: DeviceDesc) -> Self {
        Self {
            desc,
            machines: ObjectPool::default(),
            geometries: ObjectPool::default(),
            lists: ObjectPool::default(),
            tile_renderers: ObjectPool::default(),
            explained: Mutex::default(),
            explanations: Mutex::default(),
        }
    }

    /// Keeps the memory of a chunk for others.
    pub fn give_back(&self, chunk: Chunk) {
        self.lists.give(chunk.lists);
        if let Some(geometry) = Arc::into_inner(chunk.geometry) {
            self.geometries.give(geometry);
        }
    }

    /// The plans recorded since the last call, without duplicates ([`Explain::Keep`]).
    pub fn take_explanations(&self) -> Vec<String> {
        self.explained.lock().clear();
        std::mem::take(&mut self.explanations.lock())
    }

    /// Takes note of a draw's plan.
    pub fn explain(&self, plan: &dyn Fn() -> String) {
        if self.desc.explain == Explain::Off {
            return;
        }
        let text = plan();
        if !self.explained.lock().insert(text.clone()) {
            return;
        }
        match self.desc.explain {
            Explain::Off => {}
            Explain::Print => eprintln!("draw\n{text}"),
            Explain::Keep => self.explanations.lock().push(text),
        }
    }
}
