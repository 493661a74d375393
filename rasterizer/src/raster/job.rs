//! The work of a pass: its draws, chunks of shapes and clears, and the commands of each tile.

use super::budget::{Charge, DrawBudget};
use super::clear::ClearJob;
use super::watched::WatchedPixel;
use crate::attachment::TileTarget;
use crate::desc::Counter;
use crate::plan::DrawPlan;
use crate::primitive::Shape;
use crate::trace::Watch;
use crate::vertex::Geometry;
use std::sync::Arc;
use texunit::lanes::Isa;

/// A draw of a pass.
#[derive(Debug)]
pub struct DrawJob {
    /// Its decisions.
    pub plan: Arc<DrawPlan>,
    /// First and one past the last pixel its triangles may touch, x then y.
    pub area: [[i32; 2]; 2],
    /// The counter of the samples that pass its tests.
    pub counter: Option<Counter>,
    /// What it may still run beyond the budget.
    pub budget: DrawBudget,
    /// The label of the draw in the events of a watched pixel.
    pub label: u32,
}

impl DrawJob {
    /// Whether pixels of the next draw may be in one batch with those of this one: same plan, same counter, no loops.
    pub fn can_share_batches(&self, next: &Self) -> bool {
        Arc::ptr_eq(&self.plan, &next.plan)
            && self.counter == next.counter
            && self.plan.pipeline.compiled().fragment.is_straight()
    }

    /// Whether shapes of the next draw may be in one chunk with those of this one.
    pub fn can_share_chunk(&self, next: &Self) -> bool {
        self.can_share_batches(next)
            && (self.area, self.label) == (next.area, next.label)
            && !self.budget.is_stopped
    }

    /// Counts the samples of masks, if the draw has a counter.
    pub fn count(&self, masks: &[u64]) {
        if let Some(counter) = &self.counter {
            for &mask in masks {
                counter.add(mask);
            }
        }
    }
}

/// The shapes of a run of primitives and their vertices.
#[derive(Debug)]
pub struct Chunk {
    /// Which draw.
    pub draw: usize,
    /// The vertices.
    pub geometry: Arc<Geometry>,
    /// Its shapes.
    pub lists: ShapeLists,
    /// About how many batches of fragments they are together.
    pub batches: u64,
}

/// The shapes of a chunk, and their order by tiles.
#[derive(Debug, Default)]
pub struct ShapeLists {
    /// The shapes.
    pub shapes: Vec<Shape>,
    /// The shapes of each tile, in order, tile after tile.
    pub binned: Vec<u32>,
}

/// An operation of a tile: a clear, or shapes of a chunk.
#[derive(Clone, Copy, Debug)]
pub enum TileCommand {
    /// A clear, by index.
    Clear(u32),
    /// Shapes of a chunk: a range of its `binned`.
    Shapes {
        /// Which chunk.
        chunk: u32,
        /// The first.
        first: u32,
        /// One past the last.
        end: u32,
    },
}

/// Everything that tiles read.
#[derive(Debug)]
pub struct PassJob {
    /// The instruction set.
    pub isa: Isa,
    /// Pixels across.
    pub width: u32,
    /// Pixels up.
    pub height: u32,
    /// The draws.
    pub draws: Vec<DrawJob>,
    /// The chunks of all draws, in order.
    pub chunks: Vec<Chunk>,
    /// The clears.
    pub clears: Vec<ClearJob>,
    /// The watched pixel.
    pub watch: Option<Watch>,
}

/// One tile, and the operations on it.
#[derive(Debug)]
pub struct TileJob {
    /// Its first pixel.
    pub x: i32,
    /// Its first row.
    pub y: i32,
    /// Its part of each colour attachment.
    pub colors: Vec<Option<TileTarget>>,
    /// Its part of the depth attachment.
    pub depth: Option<TileTarget>,
    /// Its operations, in order.
    pub commands: Vec<TileCommand>,
    /// What the loops of draws have run in it.
    pub charges: Vec<Charge>,
    /// The watched pixel, if it is in this tile.
    pub watched: Option<Box<WatchedPixel>>,
}

impl TileJob {
    /// Prefetches the words of the blocks that a draw will write its colours to.
    #[inline]
    pub fn prefetch(&self, plan: &DrawPlan, blocks: impl Iterator<Item = usize> + Clone) {
        for color in &plan.colors {
            if let Some(target) = &self.colors[color.target] {
                target.prefetch(blocks.clone());
            }
        }
    }
}
