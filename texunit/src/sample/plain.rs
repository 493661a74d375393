//! The short way for most textures: two-dimensional, of bytes, sRGB bytes, halves, floats, depths or
//! blocks, where neither the border nor another face is reached. Nothing is compared here: where the
//! texel that it gives of each lane is all that a comparison needs, [`super::flat`] makes it.
//!
//! Gives the bits of the general way in `filter` (a test holds this), in fewer passes: whole
//! offsets in one loop, the two texels of a row in one gather, channels from words in registers.

pub mod blocks;
mod channels;
#[cfg(test)]
mod tests;

use channels::of_square;
pub use channels::{Class, of_texel};

use super::fetch::{neighbours, side_by_side, split_threes};
use super::filter::Place;
use super::wrap::{Axis, enclosing, repeated};
use crate::image::Level;
use crate::lanes::math::index;
use crate::lanes::{F32s, I32s, Kernel, LANES, Simd, U32s};
use crate::plan::Alpha;
use crate::sampler::{Filter, Seamless, Wrap};

/// The texel that each point lies in; or `false`, where this way does not lead.
#[inline(always)]
pub fn nearest<S: Simd>(
    place: &Place<'_>,
    class: Class,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
) -> bool {
    let Some(offsets) = texel_offsets::<S>(place, at) else { return false };
    let (texels, format) = (&place.level.texels, place.level.format);
    let mut second = U32s::ZERO;
    for word in 0..format.words() {
        let words = match word % 2 {
            0 if word + 1 < format.words() => {
                let pair = S::gather_pairs(texels, &moved(&offsets, word));
                second = pair[1];
                pair[0]
            }
            0 => S::gather(texels, &moved(&offsets, word)),
            _ => second,
        };
        of_texel::<S>(class, format.channels(), word, &words, out);
    }
    true
}

/// Where the texels begin that the points lie in; `None`, where this way does not lead.
#[inline(always)]
fn texel_offsets<S: Simd>(place: &Place<'_>, at: [&F32s; 3]) -> Option<U32s> {
    if place.texture.reaches_border(Filter::Nearest) {
        return None;
    }
    let (s, t) = (place.axis(0), place.axis(1));
    let (u, v) = (s.texel_coordinate::<S>(at[0]), t.texel_coordinate::<S>(at[1]));
    let level = place.level;
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let origin = level.origin() as u32;
    let (last_s, last_t) = ((s.size - 1) as f32, (t.size - 1) as f32);
    let mut offsets = U32s::ZERO;
    for lane in 0..LANES {
        // A coordinate may be rounded up to the size.
        let (x, y) = (index(u[lane], last_s), index(v[lane], last_t));
        offsets[lane] = y.wrapping_mul(row).wrapping_add(x.wrapping_mul(bytes)) + origin;
    }
    Some(offsets)
}

/// The texels that the points lie in, of one word each; `None`, where this way does not lead.
#[inline(always)]
pub fn texels<S: Simd>(place: &Place<'_>, at: [&F32s; 3]) -> Option<U32s> {
    let offsets = texel_offsets::<S>(place, at)?;
    Some(S::gather_here(&place.level.texels, &offsets))
}

/// The mean of 2×2 texels; or `false`, where this way does not lead.
#[inline(always)]
pub fn linear<S: Simd>(
    place: &Place<'_>,
    class: Class,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
) -> bool {
    let (words, channels) = (place.level.format.words(), place.level.format.channels());
    if words == 1 {
        let mut found = Square::default();
        if square::<S>(place, at, Places::Own, &mut found) == Search::Nowhere {
            return false;
        }
        let Square { words, weights, .. } = &found;
        let alpha = place.texture.alpha;
        of_square::<S>(class, (channels, alpha), 0, words.each_ref(), weights.each_ref(), out);
        return true;
    }
    let Some(reach) = reach::<S>(place, at) else { return false };
    let corners = reach.corners(place);
    let level = place.level;
    let weights = reach.weights.each_ref();
    let mut word = 0;
    while word + 1 < words {
        let a = S::gather_pairs(&level.texels, &moved(&corners[0], word));
        let b = S::gather_pairs(&level.texels, &moved(&corners[1], word));
        let c = S::gather_pairs(&level.texels, &moved(&corners[2], word));
        let d = S::gather_pairs(&level.texels, &moved(&corners[3], word));
        for half in 0..2 {
            let corners = [&a[half], &b[half], &c[half], &d[half]];
            of_square::<S>(class, (channels, Alpha::Read), word + half, corners, weights, out);
        }
        word += 2;
    }
    if word < words {
        let words = one_by_one::<S>(place, &corners, word);
        of_square::<S>(class, (channels, Alpha::Read), word, words.each_ref(), weights, out);
    }
    true
}

/// 2×2 texels of one word each, in the order (0, 0), (1, 0), (0, 1), (1, 1).
#[derive(Clone, Debug, Default)]
pub struct Square {
    pub words: [U32s; 4],
    /// Of the right and of the upper texels.
    pub weights: [F32s; 2],
    /// Where the first texels begin, where all of them lie inside of their level.
    offsets: U32s,
}

/// Who looks for the places of a lookup's texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Places {
    /// The lookup itself.
    Own,
    /// The one before in the same room ([`crate::plan::Room`]), whose points, offset and level of detail were the same,
    /// of a plan that reads alike ([`crate::plan::SamplePlan::reads_like`]).
    Kept,
}

/// What came of looking for squares of texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// This way does not lead there.
    Nowhere,
    /// They are here, and some reach over an edge of their level.
    OverEdge,
    /// They are here, and their places can be kept.
    Inside,
}

/// The texels whose mean a point takes, of one word each. Places are kept of squares that are [`Search::Inside`].
///
/// A function of its own, which gives them in memory that is the caller's: where they are locals of several ways that
/// lead to the same place, LLVM moves all of them once or twice.
#[inline(always)]
pub fn square<S: Simd>(
    place: &Place<'_>,
    at: [&F32s; 3],
    places: Places,
    out: &mut Square,
) -> Search {
    S::apart(FindSquare { place, at, places, out })
}

struct FindSquare<'a> {
    place: &'a Place<'a>,
    at: [&'a F32s; 3],
    places: Places,
    out: &'a mut Square,
}

impl Kernel for FindSquare<'_> {
    type Output = Search;

    #[inline(always)]
    fn run<S: Simd>(self) -> Search {
        let Self { place, at, places, out } = self;
        let level = place.level;
        let bytes = level.format.bytes();
        let is_inside = match places {
            Places::Kept => true,
            Places::Own => bytes >= 3 && inside::<S>(place, at, &mut out.offsets, &mut out.weights),
        };
        if is_inside {
            let row = level.row_bytes() as u32;
            S::gather_squares(&level.texels, &out.offsets, row, &mut out.words);
            if bytes == 3 {
                let [a, b, c, d] = out.words.each_mut();
                split_threes([a, b]);
                split_threes([c, d]);
            }
            return Search::Inside;
        }
        let Some(reach) = reach::<S>(place, at) else { return Search::Nowhere };
        let corners = reach.corners(place);
        out.weights = reach.weights;
        out.words = if reach.pairs[0] == Pairs::Inside {
            let [a, b] = neighbours::<S>(level, &corners[0]);
            let [c, d] = neighbours::<S>(level, &corners[2]);
            [a, b, c, d]
        } else {
            one_by_one::<S>(place, &corners, 0)
        };
        Search::OverEdge
    }
}

/// Where the lower left texels of the squares begin, and the weights of the right and of the upper texels; or `false`
/// if coordinates do not wrap in a usual way, the same along both axes, or a lane reaches beyond an edge.
///
/// In one loop: of several, what lies between would be stored and loaded again where an instruction set has few
/// registers.
#[inline(always)]
fn inside<S: Simd>(
    place: &Place<'_>,
    [s, t, _]: [&F32s; 3],
    offsets: &mut U32s,
    weights: &mut [F32s; 2],
) -> bool {
    let axes @ [across, up] = [place.axis(0), place.axis(1)];
    match (across.wrap, up.wrap) {
        (Wrap::Repeat, Wrap::Repeat) => {
            let sizes = [across.size as f32, up.size as f32];
            let wrapped = |axis: usize, x| repeated::<S>(x, sizes[axis]);
            inside_of::<S>(place.level, [s, t], wrapped, offsets, weights)
        }
        (Wrap::ClampToEdge, Wrap::ClampToEdge) => {
            let wrapped = |axis: usize, x| axes[axis].held_to_edge(x);
            inside_of::<S>(place.level, [s, t], wrapped, offsets, weights)
        }
        (_, _) => false,
    }
}

/// [`inside`] by what a coordinate is in texels.
#[inline(always)]
fn inside_of<S: Simd>(
    level: &Level,
    [s, t]: [&F32s; 2],
    wrapped: impl Fn(usize, f32) -> f32,
    offsets: &mut U32s,
    [alpha, beta]: &mut [F32s; 2],
) -> bool {
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let origin = level.origin() as u32;
    let [mut column, mut line] = [0; 2];
    for lane in 0..LANES {
        let (u, v) = (wrapped(0, s[lane]) - 0.5, wrapped(1, t[lane]) - 0.5);
        let ((i, left), (j, below)) = (S::floor_small(u), S::floor_small(v));
        alpha[lane] = u - left;
        beta[lane] = v - below;
        // -1 is the largest of all.
        let (i, j) = (i as u32, j as u32);
        column = if i > column { i } else { column };
        line = if j > line { j } else { line };
        offsets[lane] =
            j.wrapping_mul(row).wrapping_add(i.wrapping_mul(bytes).wrapping_add(origin));
    }
    column < level.width - 1 && line < level.height - 1
}

/// A word of each of four texels.
#[inline(always)]
fn one_by_one<S: Simd>(place: &Place<'_>, corners: &[U32s; 4], word: usize) -> [U32s; 4] {
    let texels = &place.level.texels;
    [
        S::gather(texels, &moved(&corners[0], word)),
        S::gather(texels, &moved(&corners[1], word)),
        S::gather(texels, &moved(&corners[2], word)),
        S::gather(texels, &moved(&corners[3], word)),
    ]
}

/// The squares of texels that lanes take means of.
struct Reach {
    /// Of s and t.
    axes: [Axis; 2],
    /// Column and row of the lower left texel; -1 is beyond the edge.
    first: [I32s; 2],
    /// Of the right and of the upper texels.
    weights: [F32s; 2],
    /// Whether both columns, both rows, are the level's.
    pairs: [Pairs; 2],
}

/// The two neighbours along an axis whose mean each lane takes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pairs {
    /// Both are the level's in every lane.
    Inside,
    /// In some lane one is beyond an edge.
    OverEdge,
}

impl Pairs {
    /// Those that begin at `i`.
    #[inline(always)]
    fn of<S: Simd>(i: &I32s, size: u32) -> Self {
        if side_by_side::<S>(i, size) { Self::Inside } else { Self::OverEdge }
    }
}

impl Reach {
    /// Where each texel of the squares begins.
    #[inline(always)]
    fn corners(&self, place: &Place<'_>) -> [U32s; 4] {
        let Self { axes: [s, t], first: [i, j], pairs, .. } = self;
        let level = place.level;
        let xs = ends(s, i, pairs[0], level.format.bytes() as u32, level.origin() as u32);
        let ys = ends(t, j, pairs[1], level.row_bytes() as u32, 0);
        [sum(&xs[0], &ys[0]), sum(&xs[1], &ys[0]), sum(&xs[0], &ys[1]), sum(&xs[1], &ys[1])]
    }
}

/// Finds the squares; `None` where the border or another face is reached.
#[inline(always)]
fn reach<S: Simd>(place: &Place<'_>, at: [&F32s; 3]) -> Option<Reach> {
    let axes = [place.axis(0), place.axis(1)];
    let (i, alpha) = enclosing::<S>(&axes[0].texel_coordinate::<S>(at[0]));
    let (j, beta) = enclosing::<S>(&axes[1].texel_coordinate::<S>(at[1]));
    let pairs = [Pairs::of::<S>(&i, axes[0].size), Pairs::of::<S>(&j, axes[1].size)];
    let seamless = place.texture.seamless == Seamless::On;
    for (axis, pairs) in axes.iter().zip(pairs) {
        let is_over = pairs == Pairs::OverEdge;
        if is_over && (seamless || axis.wrap.reaches_border(Filter::Linear)) {
            return None;
        }
    }
    Some(Reach { axes, first: [i, j], weights: [alpha, beta], pairs })
}

/// The byte offsets of the lower and the upper texel along one axis, `stride` bytes apart.
#[inline(always)]
fn ends(axis: &Axis, i: &I32s, pairs: Pairs, stride: u32, origin: u32) -> [U32s; 2] {
    let mut low = U32s::ZERO;
    let mut high = U32s::ZERO;
    if pairs == Pairs::Inside {
        for lane in 0..LANES {
            let at = (i[lane] as u32).wrapping_mul(stride).wrapping_add(origin);
            low[lane] = at;
            high[lane] = at.wrapping_add(stride);
        }
        return [low, high];
    }
    let last = axis.size as i32 - 1;
    let (below, above) = if axis.wrap == Wrap::Repeat { (last, 0) } else { (0, last) };
    for lane in 0..LANES {
        let lower = if i[lane] < 0 { below } else { i[lane] } as u32;
        let upper = if i[lane] < last { i[lane] + 1 } else { above } as u32;
        low[lane] = lower.wrapping_mul(stride).wrapping_add(origin);
        high[lane] = upper.wrapping_mul(stride).wrapping_add(origin);
    }
    [low, high]
}

#[inline(always)]
fn sum(a: &U32s, b: &U32s) -> U32s {
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        out[lane] = a[lane].wrapping_add(b[lane]);
    }
    out
}

/// The offsets of a later word of the same texels.
#[inline(always)]
pub fn moved(offsets: &U32s, word: usize) -> U32s {
    sum(offsets, &U32s::splat(4 * word as u32))
}
