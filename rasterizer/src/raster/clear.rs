//! Clears, tile by tile.

use super::block::BlockAt;
use super::edge_functions;
use super::job::{PassJob, TileJob};
use crate::attachment::WordMask;
use crate::attachment::expand_mask;
use crate::sizes::TILE;
use crate::trace::Cleared;
use texunit::lanes::LANES;

/// A clear of a pass.
#[derive(Clone, Copy, Debug)]
pub struct ClearJob {
    /// What is cleared.
    pub target: Cleared,
    /// The words of a texel.
    pub words: WordMask,
    /// The bits of the words that are written.
    pub write: WordMask,
    /// The bits of the words that the format uses.
    pub all: WordMask,
    /// First and one past the last pixel, within the pass, x then y.
    pub area: [[i32; 2]; 2],
    /// Its label in the events of a watched pixel.
    pub label: u32,
}

impl ClearJob {
    /// Whether it writes all of every pixel of a pass of this size, so that no word is written yet.
    pub fn writes_all(&self, width: u32, height: u32) -> bool {
        let is_written = |(write, all): (&u32, &u32)| *write == 0 || write == all;
        self.covers([0, 0], [width as i32, height as i32])
            && self.write.iter().zip(&self.all).all(is_written)
    }

    /// Whether all pixels from the first to before the last are in its area.
    fn covers(&self, first: [i32; 2], end: [i32; 2]) -> bool {
        let [low, high] = self.area;
        low[0] <= first[0] && low[1] <= first[1] && high[0] >= end[0] && high[1] >= end[1]
    }
}

/// The blocks of a tile that an area touches, bit by block.
fn touched(area: &[[i32; 2]; 2], tile: [i32; 2]) -> u64 {
    let [columns, rows] = [0, 1].map(|axis| {
        let [first, end] = area.map(|pixel| (pixel[axis] - tile[axis]).clamp(0, TILE as i32));
        first / 8..(end + 7) / 8
    });
    let blocks = rows.flat_map(|row| columns.clone().map(move |column| 8 * row + column));
    blocks.fold(0, |all, block| all | 1 << block)
}

/// Clears a tile's part of an attachment.
#[inline(never)]
pub fn clear(pass: &PassJob, job: &ClearJob, tile: &mut TileJob) {
    let (target, first) = match job.target {
        Cleared::Color(index) => (tile.colors.get_mut(index).and_then(Option::as_mut), 0),
        Cleared::Depth => (tile.depth.as_mut(), 0),
        Cleared::Stencil => (tile.depth.as_mut(), 1),
    };
    let Some(target) = target else { return };
    // Pixels of the tile outside of the pass are never read.
    let end = |start: i32, size: u32| (start + TILE as i32).min(size as i32);
    let covers_tile =
        job.covers([tile.x, tile.y], [end(tile.x, pass.width), end(tile.y, pass.height)]);
    for sample in target.planes.chunks_mut(target.planes_per_sample) {
        for (index, plane) in sample.iter_mut().skip(first).enumerate() {
            let (word, write, all) = (job.words[index], job.write[index], job.all[index]);
            if write == 0 {
                continue;
            }
            if covers_tile && write == all {
                plane.clear(word);
                continue;
            }
            let mut touched = touched(&job.area, [tile.x, tile.y]);
            let blocks = plane.blocks_mut(touched);
            while touched != 0 {
                let index = touched.trailing_zeros() as usize;
                touched &= touched - 1;
                let (at, block) = (BlockAt::numbered([tile.x, tile.y], index), &mut blocks[index]);
                let lanes = expand_mask(edge_functions::inside_area(&job.area, at));
                for lane in 0..LANES {
                    let write = lanes[lane] & write;
                    block[lane] = (word & write) | (block[lane] & !write);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_touched_where_a_lane_is_inside() {
        let sides = [-3, 0, 63, 64, 65, 71, 72, 80, 100, 127, 128, 129, 200];
        let areas = sides.into_iter().flat_map(|a| sides.map(|b| [a, b]));
        for [first, end] in areas.filter(|[first, end]| first < end) {
            for area in [[[first, 70], [end, 73]], [[70, first], [73, end]]] {
                let inside = |block| {
                    let at = BlockAt::numbered([64, 64], block);
                    u64::from(edge_functions::inside_area(&area, at) != 0) << block
                };
                let want = (0..64).fold(0, |all, block| all | inside(block));
                assert_eq!(touched(&area, [64, 64]), want, "{area:?}");
            }
        }
    }

    #[test]
    fn a_clear_is_whole_where_no_pixel_and_no_bit_is_left() {
        let clear = |area, write| ClearJob {
            target: Cleared::Color(0),
            words: [7; 4],
            write,
            all: [!0, 0xFF, 0, 0],
            area,
            label: 0,
        };
        let all = [!0, 0xFF, 0, 0];
        for (area, write, want) in [
            ([[0, 0], [70, 30]], all, true),
            ([[-5, 0], [70, 31]], all, true),
            ([[0, 0], [70, 30]], [!0, 0, 0, 0], true),
            ([[1, 0], [70, 30]], all, false),
            ([[0, 2], [70, 30]], all, false),
            ([[0, 0], [69, 30]], all, false),
            ([[0, 0], [70, 29]], all, false),
            ([[0, 0], [70, 30]], [!1, 0xFF, 0, 0], false),
        ] {
            assert_eq!(clear(area, write).writes_all(70, 30), want, "{area:?} {write:x?}");
        }
    }
}
