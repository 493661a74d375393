//! Clears, tile by tile.

use super::coverage;
use super::tile::{PassJob, TileJob};
use crate::output::expand_mask;
use crate::target::{TILE, WordMask};
use texunit::lanes::LANES;

/// What a clear writes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClearTarget {
    /// A colour attachment.
    Color(usize),
    /// The depths of the depth attachment.
    Depth,
    /// Its stencils.
    Stencil,
}

/// A clear of a pass.
#[derive(Clone, Copy, Debug)]
pub struct ClearJob {
    /// What is cleared.
    pub target: ClearTarget,
    /// The words of a texel.
    pub words: WordMask,
    /// Their bits that are written.
    pub write: WordMask,
    /// Their bits that hold anything.
    pub all: WordMask,
    /// First and one past the last pixel, within the pass, x then y.
    pub area: [[i32; 2]; 2],
    /// What a watch calls it.
    pub label: u32,
}

/// Clears a tile's part of an attachment.
pub fn clear(pass: &PassJob, job: &ClearJob, tile: &mut TileJob) {
    let (target, first) = match job.target {
        ClearTarget::Color(index) => (tile.colors.get_mut(index).and_then(Option::as_mut), 0),
        ClearTarget::Depth => (tile.depth.as_mut(), 0),
        ClearTarget::Stencil => (tile.depth.as_mut(), 1),
    };
    let Some(target) = target else { return };
    // What a tile has beyond the pass is never seen.
    let end = |start: i32, size: u32| (start + TILE as i32).min(size as i32);
    let whole = job.area[0][0] <= tile.x
        && job.area[0][1] <= tile.y
        && job.area[1][0] >= end(tile.x, pass.width)
        && job.area[1][1] >= end(tile.y, pass.height);
    for sample in target.planes.chunks_mut(target.words) {
        for (index, plane) in sample.iter_mut().skip(first).enumerate() {
            let (word, write, all) = (job.words[index], job.write[index], job.all[index]);
            if write == 0 {
                continue;
            }
            if whole && write == all {
                plane.clear(word);
                continue;
            }
            for (index, block) in plane.blocks_mut(!0).iter_mut().enumerate() {
                let (bx, by) = (index as i32 % 8, index as i32 / 8);
                let lanes = expand_mask(coverage::inside_area(&job.area, tile.x, tile.y, bx, by));
                for lane in 0..LANES {
                    let write = lanes[lane] & write;
                    block[lane] = (word & write) | (block[lane] & !write);
                }
            }
        }
    }
}
