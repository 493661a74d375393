//! The depths of one shape over a tile: a plane, from which the words of any pixel follow (GL 2.1, section 3.5.1).

use super::depth_format::{DepthFormat, depth_words};
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

/// The depths of one shape in each block of a tile, and how they are stored.
#[derive(Clone, Debug)]
pub struct DepthPlane {
    /// The instruction set that evaluates it.
    pub isa: Isa,
    /// How depths are stored.
    pub format: DepthFormat,
    /// The depth at the first pixel of each block.
    pub corners: F32s,
    /// Per pixel across, per pixel up.
    pub steps: [f32; 2],
    /// The least and the largest depth.
    pub depths: [f32; 2],
}

impl DepthPlane {
    /// The words of a block.
    pub fn block(&self, block: usize) -> U32s {
        self.isa.run(BlockWords { plane: self, block })
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
        let ([a, b], [low, high]) = (self.steps, self.depths);
        let depth = value_at([self.corners[block % LANES], a, b], at);
        self.format.word(texunit::lanes::math::clamp(depth, low, high))
    }

    /// The words of pixels: the block times 64 and the lane there of each.
    #[inline(always)]
    pub fn gather<S: Simd>(&self, places: &U32s) -> U32s {
        let [a, b] = self.steps;
        let (mut blocks, mut depth, mut words) = (U32s::ZERO, F32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            blocks[lane] = places[lane] / LANES as u32 % LANES as u32;
        }
        let corners = S::gather_f32(&self.corners.0, &blocks);
        for lane in 0..LANES {
            let place = places[lane];
            // As `lane_x` and `lane_y`.
            let x = (place & 3) << 1 | place >> 4 & 1;
            let y = (place >> 2 & 3) << 1 | place >> 5 & 1;
            depth[lane] = value_at([corners[lane], a, b], [x as f32, y as f32]);
        }
        clamp_depth(&mut depth, self.depths);
        depth_words(self.format, &depth, &mut words);
        words
    }

    /// Whether `new OP stored` holds for every pixel of the tile where all of them store this word; `false` where that is
    /// not sure.
    pub fn passes_everywhere(&self, test: Compare, stored: u32) -> bool {
        let Some([least, largest]) = self.isa.run(Range(self)) else { return false };
        match test {
            Compare::Always => true,
            Compare::Less => largest < stored,
            Compare::LessEqual => largest <= stored,
            Compare::Greater => least > stored,
            Compare::GreaterEqual => least >= stored,
            Compare::NotEqual => largest < stored || least > stored,
            Compare::Never | Compare::Equal => false,
        }
    }
}

struct BlockWords<'a> {
    plane: &'a DepthPlane,
    block: usize,
}

impl Kernel for BlockWords<'_> {
    type Output = U32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> U32s {
        let Self { plane: &DepthPlane { format, ref corners, steps: [a, b], depths, .. }, block } =
            self;
        let depth = BlockDepth { plane: [corners[block % LANES], a, b], depths }.run::<S>();
        let mut words = U32s::ZERO;
        depth_words(format, &depth, &mut words);
        words
    }
}

/// The least and the largest word of a tile; `None` where numbers are infinite or NaN.
///
/// All operations of [`value_at`], the clamp and the rounding to words keep order in each argument, so that the extremes of
/// a block are at its corner pixels.
struct Range<'a>(&'a DepthPlane);

impl Kernel for Range<'_> {
    type Output = Option<[u32; 2]>;
    #[inline(always)]
    fn run<S: Simd>(self) -> Option<[u32; 2]> {
        let &DepthPlane { format, ref corners, steps: [a, b], depths, .. } = self.0;
        let last = |step: f32, up: bool| if (step > 0.0) == up { 7.0 } else { 0.0 };
        let (lowest, highest) = ([last(a, false), last(b, false)], [last(a, true), last(b, true)]);
        let (mut low, mut high, mut unknown) = (F32s::ZERO, F32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            low[lane] = value_at([corners[lane], a, b], lowest);
            high[lane] = value_at([corners[lane], a, b], highest);
            unknown[lane] = if corners[lane].is_finite() { 0 } else { !0 };
        }
        if !(7.0 * a).is_finite() || !(7.0 * b).is_finite() || S::any(&unknown) {
            return None;
        }
        clamp_depth(&mut low, depths);
        clamp_depth(&mut high, depths);
        let (mut least, mut largest) = (U32s::ZERO, U32s::ZERO);
        depth_words(format, &low, &mut least);
        depth_words(format, &high, &mut largest);
        Some([S::smallest(&least), S::largest(&largest)])
    }
}
