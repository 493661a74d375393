//! The coverage of a tile by a triangle at each of several samples, whose edge functions differ by a constant.

use super::edge_functions::{Edge, TileEdges, edges};
use super::large_triangles::{MIN_BLOCKS, TILE_BLOCKS, bits, blocks};
use crate::attachment::BLOCKS;
use crate::plan::SampleMasks;
use crate::sizes::MAX_SAMPLES;
use texunit::lanes::{Isa, Kernel, Simd};

/// What a triangle covers of each block of a tile, by sample.
#[derive(Debug)]
pub struct SampledTriangle {
    /// By sample: the blocks of which it covers any pixel there, bit by block.
    touched: [u64; MAX_SAMPLES],
    /// By sample: the covered lanes of each touched block.
    covered: [[u64; BLOCKS]; MAX_SAMPLES],
}

impl Default for SampledTriangle {
    fn default() -> Self {
        Self { touched: [0; MAX_SAMPLES], covered: [[0; BLOCKS]; MAX_SAMPLES] }
    }
}

impl SampledTriangle {
    /// Computes what the triangle of these `corners` covers of the blocks in `range` (first and last, x then y) of the
    /// tile whose first pixel is `tile`. Each sample lies at its position, in subpixels, from the pixel's centre.
    pub fn compute(
        &mut self,
        isa: Isa,
        corners: &[[i32; 2]; 3],
        tile: [i32; 2],
        range: [[i32; 2]; 2],
        positions: &[[i32; 2]],
    ) {
        isa.run(CoverSamples { out: self, corners, tile, range, positions });
    }

    /// The blocks of which it covers any sample, bit by block.
    pub fn touched(&self) -> u64 {
        self.touched.iter().fold(0, |all, touched| all | touched)
    }

    /// The blocks of which it covers any pixel at a sample, bit by block, and the covered lanes of each.
    pub fn sample_mut(&mut self, sample: usize) -> (u64, &mut [u64; BLOCKS]) {
        (self.touched[sample], &mut self.covered[sample])
    }

    /// Removes the lanes of a touched block that `kept` does not give for a sample.
    pub fn keep(&mut self, block: usize, kept: impl Fn(usize) -> u64) {
        for (sample, covered) in self.covered.iter_mut().enumerate() {
            covered[block] &= kept(sample);
        }
    }

    /// Writes the lanes of a block that are covered, by sample.
    #[inline]
    pub fn write_masks(&self, block: usize, masks: &mut SampleMasks) {
        let samples = self.touched.iter().zip(&self.covered);
        for (mask, (touched, covered)) in masks.iter_mut().zip(samples) {
            *mask = if touched >> block & 1 == 1 { covered[block] } else { 0 };
        }
    }
}

struct CoverSamples<'a> {
    out: &'a mut SampledTriangle,
    corners: &'a [[i32; 2]; 3],
    tile: [i32; 2],
    range: [[i32; 2]; 2],
    positions: &'a [[i32; 2]],
}

impl Kernel for CoverSamples<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { out, corners, tile, range: [first, last], positions } = self;
        let rows = first[1] as usize..last[1] as usize + 1;
        let columns = (0xFF_u64 << first[0] & 0xFF >> (7 - last[0])) * 0x0101_0101_0101_0101;
        let at_sample = |position: &[i32; 2]| -> [Edge; 3] {
            let corners = corners.map(|c| [c[0] - position[0], c[1] - position[1]]);
            edges(&corners, tile[0], tile[1])
        };
        out.touched = [0; MAX_SAMPLES];
        let [across, up] = [0, 1].map(|axis| last[axis] - first[axis] + 1);
        let is_small = across * up < MIN_BLOCKS;
        let Some(steps) = positions.first().map(|position| TileEdges::of(&at_sample(position)))
        else {
            return;
        };
        let samples = out.touched.iter_mut().zip(&mut out.covered);
        for (position, (all, covered)) in positions.iter().zip(samples) {
            let edges = at_sample(position);
            // Few blocks are sorted one by one.
            let [touched, full] = match is_small {
                true => sorted_one_by_one(&edges, [first, last]),
                false => blocks::<S>(&edges, rows.clone()).map(|blocks| blocks & columns),
            };
            *all = full;
            for block in bits(touched) {
                covered[block] = !0;
                if full >> block & 1 == 0 {
                    let at = [block % TILE_BLOCKS, block / TILE_BLOCKS].map(|at| at as i32);
                    covered[block] = steps.lanes::<S>(&edges, at);
                    *all |= u64::from(covered[block] != 0) << block;
                }
            }
        }
    }
}

/// As [`blocks`], of the blocks from the first to the last.
fn sorted_one_by_one(edges: &[Edge; 3], [first, last]: [[i32; 2]; 2]) -> [u64; 2] {
    let [mut touched, mut full] = [0, 0];
    for by in first[1]..=last[1] {
        for bx in first[0]..=last[0] {
            let (mut is_touched, mut is_full) = (true, true);
            for edge in edges {
                let (_, [least, most]) = edge.over_block([bx, by]);
                is_touched &= most >= 0;
                is_full &= least >= 0;
            }
            let block = bx as usize + TILE_BLOCKS * by as usize;
            touched |= u64::from(is_touched) << block;
            full |= u64::from(is_full) << block;
        }
    }
    [touched, full]
}

#[cfg(test)]
mod tests {
    use super::super::edge_functions::block;
    use super::*;
    use proptest::prelude::*;

    const POSITIONS: [[i32; 2]; 4] = [[-32, -96], [96, -32], [-96, 32], [32, 96]];

    proptest! {
        #[test]
        fn samples_are_covered_as_centres_of_a_triangle_that_was_moved(
            corners in prop::array::uniform3(prop::array::uniform2(
                prop_oneof![-8_000..24_000i32, -8_388_000..=8_388_000i32])),
            range in prop::array::uniform2((0..8i32, 0..8i32)),
        ) {
            let [(x0, y0), (x1, y1)] = range;
            let range = [[x0.min(x1), y0.min(y1)], [x0.max(x1), y0.max(y1)]];
            for isa in Isa::available() {
                let mut triangle = SampledTriangle::default();
                triangle.compute(isa, &corners, [0, 0], range, &POSITIONS);
                let mut any = 0;
                for at in 0..BLOCKS {
                    let mut masks = SampleMasks::none(4);
                    triangle.write_masks(at, &mut masks);
                    let [bx, by] = [at as i32 % 8, at as i32 / 8];
                    let [first, last] = range;
                    let is_in = (first[0]..=last[0]).contains(&bx) && (first[1]..=last[1]).contains(&by);
                    for (mask, [x, y]) in masks.iter().zip(POSITIONS) {
                        let moved = corners.map(|c| [c[0] - x, c[1] - y]);
                        let want = block(isa, &edges(&moved, 0, 0), bx, by).lanes();
                        prop_assert_eq!(*mask, if is_in { want } else { 0 }, "{} block {}", isa.name(), at);
                    }
                    any |= u64::from(masks.any() != 0) << at;
                }
                prop_assert_eq!(triangle.touched(), any);
            }
        }
    }
}
