//! Small triangles into the batch of pixels that waits: the innermost loop of fine meshes. A kernel, so that bits
//! are counted and planes copied by what the instruction set has for it.

use super::group::PlaneGroup;
use super::lanes::ShapeLanes;
use super::pixels::Pixels;
use super::run::BlockRun;
use super::small::{Reached, Share, Windows};
use texunit::lanes::{Kernel, Simd};

/// Pixels of a block from which on it is shaded by itself rather than packed with others, where these
/// need not be quads.
pub const DENSE_PIXELS: u32 = 40;

/// How far the shapes of a group are packed.
#[derive(Debug, Default)]
pub struct Progress {
    /// The first shape that is not begun.
    next: usize,
    /// What is left of the one before it.
    left: Reached,
}

/// Why it goes no further.
#[derive(Clone, Copy, Debug)]
pub enum Stop {
    /// All shapes are packed.
    Done,
    /// The pixels that wait must be shaded first: they are a whole batch, or one of them comes again.
    Pixels,
    /// So must the blocks.
    Blocks,
    /// The shape in this lane has no window: it is for the caller, and will not come again.
    Shape(usize),
    /// So is this share of the shape in this lane, which is dense.
    Dense(usize, Share),
}

/// Packs the shapes of a group that have windows, in order, until the caller is needed.
pub struct Pack<'a> {
    pub shapes: &'a ShapeLanes,
    pub windows: &'a Windows,
    pub group: &'a PlaneGroup,
    pub progress: &'a mut Progress,
    pub pixels: &'a mut Pixels,
    /// The blocks that wait.
    pub run: &'a BlockRun,
}

impl Kernel for Pack<'_> {
    type Output = Stop;

    #[inline(always)]
    fn run<S: Simd>(self) -> Stop {
        let Self { shapes, windows, group, progress, pixels, run } = self;
        let Progress { next, left } = progress;
        loop {
            let Some(share) = left.first() else {
                let lane = *next;
                if lane >= shapes.len {
                    return Stop::Done;
                }
                *next += 1;
                match windows.get(lane) {
                    Some(window) => *left = window.blocks(),
                    None => return Stop::Shape(lane),
                }
                continue;
            };
            let lane = next.saturating_sub(1);
            if share.lanes.count_ones() >= DENSE_PIXELS {
                left.leave(share, 0);
                return Stop::Dense(lane, share);
            }
            let Share { block, lanes, .. } = share;
            if pixels.is_full() || pixels.holds(block, lanes) {
                return Stop::Pixels;
            }
            if run.holds(block, lanes) {
                return Stop::Blocks;
            }
            let planes = group.in_window(lane, share.part);
            let rest = pixels.push(block, lanes, shapes.facing(lane), planes);
            left.leave(share, rest);
        }
    }
}
