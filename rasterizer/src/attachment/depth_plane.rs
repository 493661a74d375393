//! Depths of shapes over the blocks of a tile: planes, from which the words of any pixel follow (GL 2.1, section 3.5.1).

use super::depth_format::{DepthFormat, depth_words};
use super::mask::expand_mask;
use texunit::lanes::{F32s, Isa, Kernel, LANES, Simd, U32s, lane_x, lane_y};
use texunit::sampler::Compare;

/// A plane, given its value at the first pixel, per pixel across and per pixel up, so far across and up from there.
#[inline(always)]
pub fn value_at([corner, a, b]: [f32; 3], [dx, dy]: [f32; 2]) -> f32 {
    (corner + dx * a) + dy * b
}

/// Window depth lies within bounds, [0, 1] or closer ones, also after planes and offsets (GL 2.1,
/// section 2.11.1; `ARB_depth_clamp`).
#[inline(always)]
pub fn clamp_depth(depth: &mut F32s, [low, high]: [f32; 2]) {
    for lane in 0..LANES {
        depth[lane] = texunit::lanes::math::clamp(depth[lane], low, high);
    }
}

/// The depth of a block of one shape.
pub struct BlockDepth {
    /// At the first pixel, per pixel across, per pixel up.
    pub plane: [f32; 3],
    /// The least and the largest depth.
    pub depths: [f32; 2],
}

impl Kernel for BlockDepth {
    type Output = F32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> F32s {
        let mut out = F32s::ZERO;
        for lane in 0..LANES {
            out[lane] = value_at(self.plane, [lane_x(lane) as f32, lane_y(lane) as f32]);
        }
        clamp_depth(&mut out, self.depths);
        out
    }
}

/// A plane of depths for each block of a tile, and how depths are stored.
#[derive(Clone, Debug)]
pub struct DepthPlanes {
    /// The instruction set that evaluates them.
    pub isa: Isa,
    /// How depths are stored.
    pub format: DepthFormat,
    /// The least and the largest depth.
    pub depths: [f32; 2],
    /// By block: the depth at its first pixel, per pixel across, per pixel up.
    pub planes: [F32s; 3],
}

impl DepthPlanes {
    /// The plane of a block.
    #[inline(always)]
    fn plane(&self, block: usize) -> [f32; 3] {
        self.planes.each_ref().map(|of| of[block % LANES])
    }

    /// The words of a block.
    pub fn block(&self, block: usize) -> U32s {
        self.isa.run(BlockWords { planes: self, block })
    }

    /// The words of a row of a block.
    #[inline]
    pub fn row(&self, block: usize, y: usize) -> [u32; 8] {
        std::array::from_fn(|x| self.word_at(block, [x as f32, y as f32]))
    }

    /// The word of a lane of a block.
    pub fn word(&self, block: usize, lane: usize) -> u32 {
        self.word_at(block, [lane_x(lane) as f32, lane_y(lane) as f32])
    }

    /// The word of the pixel so far across and up from the first of a block.
    #[inline(always)]
    fn word_at(&self, block: usize, at: [f32; 2]) -> u32 {
        let [low, high] = self.depths;
        let depth = value_at(self.plane(block), at);
        self.format.word(texunit::lanes::math::clamp(depth, low, high))
    }

    /// The words of pixels: lane by lane the plane of its block, and the block times 64 and the lane there of each.
    #[inline(always)]
    pub fn words_at(&self, [corners, a, b]: &[F32s; 3], places: &U32s) -> U32s {
        let (mut depth, mut words) = (F32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            let place = places[lane];
            // As `lane_x` and `lane_y`.
            let x = (place & 3) << 1 | place >> 4 & 1;
            let y = (place >> 2 & 3) << 1 | place >> 5 & 1;
            depth[lane] = value_at([corners[lane], a[lane], b[lane]], [x as f32, y as f32]);
        }
        clamp_depth(&mut depth, self.depths);
        depth_words(self.format, &depth, &mut words);
        words
    }

    /// Whether words are those of these planes if they are stored with them.
    pub fn are_stored_as(&self, other: &Self) -> bool {
        self.format == other.format
            && self.depths.map(f32::to_bits) == other.depths.map(f32::to_bits)
    }

    /// Replaces the planes of some blocks, bit by block.
    pub fn replace(&mut self, blocks: u64, by: &Self) {
        for block in (0..LANES).filter(|block| blocks >> block & 1 == 1) {
            for (plane, by) in self.planes.iter_mut().zip(&by.planes) {
                plane[block] = by[block];
            }
        }
    }
}

struct BlockWords<'a> {
    planes: &'a DepthPlanes,
    block: usize,
}

impl Kernel for BlockWords<'_> {
    type Output = U32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> U32s {
        let Self { planes: of @ &DepthPlanes { format, depths, .. }, block } = self;
        let depth = BlockDepth { plane: of.plane(block), depths }.run::<S>();
        let mut words = U32s::ZERO;
        depth_words(format, &depth, &mut words);
        words
    }
}

/// For which blocks a depth test has one outcome, bit by block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BlockOutcomes {
    /// Every pixel passes.
    pub pass: u64,
    /// Every pixel fails.
    pub fail: u64,
}

/// Whether `new OP stored` holds for every pixel, or for none, of each block of a tile.
pub struct CompareBlocks<'a> {
    /// The comparison.
    pub test: Compare,
    /// What is compared.
    pub new: &'a DepthPlanes,
    /// The blocks that store planes, bit by block, and these, stored as `new` is.
    pub planes: Option<(u64, &'a DepthPlanes)>,
    /// The word that all other blocks store.
    pub word: u32,
}

impl Kernel for CompareBlocks<'_> {
    type Output = BlockOutcomes;
    #[inline(always)]
    fn run<S: Simd>(self) -> BlockOutcomes {
        let Self { test, new, planes, word } = self;
        let of_new = Ranges::of(new);
        let mut stored =
            Ranges { low: U32s::splat(word), high: U32s::splat(word), is_known: U32s::splat(!0) };
        let mut is_same = U32s::ZERO;
        if let Some((blocks, old)) = planes {
            let of_old = Ranges::of(old);
            let has_plane = expand_mask(blocks);
            for lane in 0..LANES {
                let is_old = has_plane[lane];
                stored.low[lane] = of_old.low[lane] & is_old | stored.low[lane] & !is_old;
                stored.high[lane] = of_old.high[lane] & is_old | stored.high[lane] & !is_old;
                stored.is_known[lane] &= of_old.is_known[lane] | !is_old;
                let mut differ = 0;
                for (new, old) in new.planes.iter().zip(&old.planes) {
                    differ |= new[lane].to_bits() ^ old[lane].to_bits();
                }
                is_same[lane] = if differ == 0 { is_old } else { 0 };
            }
        }
        let (mut below, mut above, mut at_most, mut at_least) =
            (U32s::ZERO, U32s::ZERO, U32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            let known = of_new.is_known[lane] & stored.is_known[lane];
            let (low, high) = (of_new.low[lane], of_new.high[lane]);
            let (old_low, old_high) = (stored.low[lane], stored.high[lane]);
            below[lane] = if high < old_low { known } else { 0 };
            above[lane] = if low > old_high { known } else { 0 };
            // The words of equal planes are equal.
            at_most[lane] = if high <= old_low { known } else { is_same[lane] };
            at_least[lane] = if low >= old_high { known } else { is_same[lane] };
        }
        let [below, above] = [S::nonzero(&below), S::nonzero(&above)];
        let [at_most, at_least] = [S::nonzero(&at_most), S::nonzero(&at_least)];
        let equal = S::nonzero(&is_same);
        let (pass, fail) = match test {
            Compare::Always => (!0, 0),
            Compare::Never => (0, !0),
            Compare::Less => (below, at_least),
            Compare::LessEqual => (at_most, above),
            Compare::Greater => (above, at_most),
            Compare::GreaterEqual => (at_least, below),
            Compare::Equal => (equal, below | above),
            Compare::NotEqual => (below | above, equal),
        };
        BlockOutcomes { pass, fail }
    }
}

/// The least and the largest word of each block.
///
/// All operations of [`value_at`], the clamp and the rounding to words keep order in each argument, so that the extremes of
/// a block are at its corner pixels.
struct Ranges {
    low: U32s,
    high: U32s,
    /// Zero where numbers are infinite or NaN.
    is_known: U32s,
}

impl Ranges {
    #[inline(always)]
    fn of(planes: &DepthPlanes) -> Self {
        let &DepthPlanes { format, depths, planes: [ref corners, ref a, ref b], .. } = planes;
        let (mut lowest, mut highest, mut is_known) = (F32s::ZERO, F32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            let (corner, a, b) = (corners[lane], a[lane], b[lane]);
            let last = |step: f32, up: bool| if (step > 0.0) == up { 7.0 } else { 0.0 };
            lowest[lane] = value_at([corner, a, b], [last(a, false), last(b, false)]);
            highest[lane] = value_at([corner, a, b], [last(a, true), last(b, true)]);
            let is_finite = |value: f32| value.abs() < f32::INFINITY;
            let is_all = is_finite(corner) & is_finite(7.0 * a) & is_finite(7.0 * b);
            is_known[lane] = if is_all { !0 } else { 0 };
        }
        clamp_depth(&mut lowest, depths);
        clamp_depth(&mut highest, depths);
        let (mut low, mut high) = (U32s::ZERO, U32s::ZERO);
        depth_words(format, &lowest, &mut low);
        depth_words(format, &highest, &mut high);
        Self { low, high, is_known }
    }
}
