//! From a coordinate to texel indices along one axis (GL 2.1, section 3.8.7, and the addressing of
//! section 3.8.8; the mirror clamps are EXT_texture_mirror_clamp's).
//!
//! Every result is a legal index of the stored texels, border included: what lies beyond them has
//! the nearest index and a mask. Defined beyond the specification: NaN counts as 0, and so does
//! ±inf where coordinates repeat; elsewhere ±inf is the end of the range.

use crate::lanes::math::{clamp, floor, floor_small, max, to_i32};
use crate::lanes::{F32s, I32s, Kernel, LANES, Simd, U32s};
use crate::sampler::Wrap;

/// One axis of a level.
#[derive(Clone, Copy)]
pub struct Axis {
    /// The wrap mode.
    pub wrap: Wrap,
    /// Texels, without the border.
    pub size: u32,
    /// Border texels stored on either side, 0 or 1.
    pub border: u32,
    /// Texels per unit of the coordinate: the size, or 1 where coordinates count texels.
    pub scale: f32,
}

/// Indices along one axis, and a mask of those outside of the stored texels.
pub struct Indices {
    /// Of the stored texels: 0 is the first, the border's if there is one.
    pub index: U32s,
    /// `!0` where the texel is the border colour, else 0.
    pub outside: U32s,
}

/// The texels that enclose coordinates along one axis.
pub struct LinearTexels {
    /// The lower one, -1 at least, without the border.
    pub lower: I32s,
    /// Of the upper one, in [0, 1).
    pub weight: F32s,
    /// Both, as they are stored.
    pub texels: [Indices; 2],
}

/// `i mod n`, at least 0. The quotient of `i + 1/2` is never near an integer, so `f32` finds it.
#[inline(always)]
pub fn modulo(i: i32, n: i32) -> i32 {
    let quotient = (i as f32 + 0.5) / n as f32;
    i - floor_small(quotient).0 * n
}

/// The coordinate of a mirrored image within [0, 1], and whether it is mirrored there.
#[inline(always)]
pub fn mirrored_repeat<S: Simd>(s: f32) -> (f32, bool) {
    let whole = S::floor(s);
    let part = max(s - whole, 0.0);
    let half = whole * 0.5;
    let odd = S::floor(half) < half;
    (if odd { 1.0 - part } else { part }, odd)
}

/// `u` with `Wrap::Repeat` over `n` texels.
#[inline(always)]
pub fn repeated<S: Simd>(s: f32, n: f32) -> f32 {
    max(s - S::floor_unsigned(s), 0.0) * n
}

impl Axis {
    /// `u` with `Wrap::ClampToEdge`: clamped to the centres of the outermost texels.
    #[inline(always)]
    pub fn clamped_to_edge(&self, s: f32) -> f32 {
        clamp(s * self.scale, 0.5, self.size as f32 - 0.5)
    }

    /// `u` with `Wrap::Clamp`: clamped to the level.
    #[inline(always)]
    pub fn clamped(&self, s: f32) -> f32 {
        clamp(s * self.scale, 0.0, self.size as f32)
    }

    /// `u`, the wrapped coordinate in texels: within [0, size], half a texel more for the border.
    #[inline(always)]
    pub fn texel_coordinate<S: Simd>(self, s: &F32s) -> F32s {
        let Self { wrap, scale, .. } = self;
        let n = self.size as f32;
        let mut u = F32s::ZERO;
        match wrap {
            Wrap::Repeat => {
                for lane in 0..LANES {
                    u[lane] = repeated::<S>(s[lane], n);
                }
            }
            Wrap::Clamp => {
                for lane in 0..LANES {
                    u[lane] = self.clamped(s[lane]);
                }
            }
            Wrap::ClampToEdge => {
                for lane in 0..LANES {
                    u[lane] = self.clamped_to_edge(s[lane]);
                }
            }
            Wrap::ClampToBorder => {
                for lane in 0..LANES {
                    let x = s[lane] * scale;
                    let number = if x.is_nan() { 0.0 } else { x };
                    u[lane] = clamp(number, -0.5, n + 0.5);
                }
            }
            Wrap::MirroredRepeat => {
                for lane in 0..LANES {
                    let (mirrored, _) = mirrored_repeat::<S>(s[lane]);
                    u[lane] = clamp(mirrored * n, 0.5, n - 0.5);
                }
            }
            Wrap::MirrorClamp | Wrap::MirrorClampToEdge | Wrap::MirrorClampToBorder => {
                let beyond = match wrap {
                    Wrap::MirrorClampToEdge => -0.5,
                    Wrap::MirrorClampToBorder => 0.5,
                    Wrap::MirrorClamp
                    | Wrap::Repeat
                    | Wrap::Clamp
                    | Wrap::ClampToEdge
                    | Wrap::ClampToBorder
                    | Wrap::MirroredRepeat => 0.0,
                };
                for lane in 0..LANES {
                    u[lane] = clamp((s[lane] * scale).abs(), 0.5, n + beyond);
                }
            }
        }
        u
    }

    /// [`Axis::texel_coordinate`], outlined: the code of all wrap modes is large.
    #[inline(always)]
    pub fn texel_coordinate_outlined<S: Simd>(self, s: &F32s) -> F32s {
        S::outlined_unless_wide(TexelCoordinate { axis: self, s })
    }

    /// The texel nearest to a coordinate.
    #[inline(always)]
    pub fn nearest_texel<S: Simd>(self, s: &F32s) -> Indices {
        S::outlined_unless_wide(NearestTexelKernel { axis: self, s })
    }

    /// The texels that enclose a coordinate.
    #[inline(always)]
    pub fn linear_texels<S: Simd>(self, s: &F32s) -> LinearTexels {
        S::outlined_unless_wide(LinearTexelsKernel { axis: self, s })
    }

    /// The texel that `u` lies in; `u = size` lies in the last, unless the border is reached.
    #[inline(always)]
    fn containing_texel<S: Simd>(self, u: &F32s) -> Indices {
        let mut i = I32s::ZERO;
        for lane in 0..LANES {
            i[lane] = S::floor_small(u[lane]).0;
        }
        match self.wrap {
            Wrap::ClampToBorder | Wrap::MirrorClampToBorder => self.stored_indices(&i),
            Wrap::Repeat
            | Wrap::Clamp
            | Wrap::ClampToEdge
            | Wrap::MirroredRepeat
            | Wrap::MirrorClamp
            | Wrap::MirrorClampToEdge => {
                let last = self.size as i32 - 1;
                let mut out = Indices { index: U32s::ZERO, outside: U32s::ZERO };
                for lane in 0..LANES {
                    let low = if i[lane] < 0 { 0 } else { i[lane] };
                    let clamped = if low > last { last } else { low };
                    out.index[lane] = clamped as u32 + self.border;
                }
                out
            }
        }
    }

    /// The lower and upper of the two texels that enclose `u`, whose lower is `i`.
    #[inline(always)]
    fn linear_indices(self, i: &I32s) -> [Indices; 2] {
        let last = self.size as i32 - 1;
        match self.wrap {
            Wrap::Repeat => {
                let mut lower = Indices { index: U32s::ZERO, outside: U32s::ZERO };
                let mut upper = Indices { index: U32s::ZERO, outside: U32s::ZERO };
                for lane in 0..LANES {
                    let low = if i[lane] < 0 { last } else { i[lane] };
                    let high = if i[lane] < last { i[lane] + 1 } else { 0 };
                    lower.index[lane] = low as u32 + self.border;
                    upper.index[lane] = high as u32 + self.border;
                }
                [lower, upper]
            }
            // A texel beyond the last has weight 0; it must not be the border.
            Wrap::ClampToEdge | Wrap::MirroredRepeat | Wrap::MirrorClampToEdge => {
                let mut lower = Indices { index: U32s::ZERO, outside: U32s::ZERO };
                let mut upper = Indices { index: U32s::ZERO, outside: U32s::ZERO };
                for lane in 0..LANES {
                    let low = if i[lane] < 0 { 0 } else { i[lane] };
                    let high = if i[lane] < last { i[lane] + 1 } else { last };
                    lower.index[lane] = low as u32 + self.border;
                    upper.index[lane] = high as u32 + self.border;
                }
                [lower, upper]
            }
            Wrap::Clamp | Wrap::ClampToBorder | Wrap::MirrorClamp | Wrap::MirrorClampToBorder => {
                let mut next = I32s::ZERO;
                for lane in 0..LANES {
                    next[lane] = i[lane] + 1;
                }
                [self.stored_indices(i), self.stored_indices(&next)]
            }
        }
    }

    /// The stored index of texel `i`, of which -1 and `size` may be the border's.
    #[inline(always)]
    pub fn stored_indices(self, i: &I32s) -> Indices {
        let border = self.border as i32;
        let last = self.size as i32 - 1 + 2 * border;
        let mut out = Indices { index: U32s::ZERO, outside: U32s::ZERO };
        for lane in 0..LANES {
            let at = i[lane] + border;
            let low = if at < 0 { 0 } else { at };
            out.index[lane] = if low > last { last } else { low } as u32;
            out.outside[lane] = if (at < 0) | (at > last) { !0 } else { 0 };
        }
        out
    }
}

struct TexelCoordinate<'a> {
    axis: Axis,
    s: &'a F32s,
}

impl Kernel for TexelCoordinate<'_> {
    type Output = F32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> F32s {
        self.axis.texel_coordinate::<S>(self.s)
    }
}

struct NearestTexelKernel<'a> {
    axis: Axis,
    s: &'a F32s,
}

impl Kernel for NearestTexelKernel<'_> {
    type Output = Indices;
    #[inline(always)]
    fn run<S: Simd>(self) -> Indices {
        self.axis.containing_texel::<S>(&self.axis.texel_coordinate_outlined::<S>(self.s))
    }
}

struct LinearTexelsKernel<'a> {
    axis: Axis,
    s: &'a F32s,
}

impl Kernel for LinearTexelsKernel<'_> {
    type Output = LinearTexels;
    #[inline(always)]
    fn run<S: Simd>(self) -> LinearTexels {
        let (lower, weight) =
            lower_and_weight::<S>(&self.axis.texel_coordinate_outlined::<S>(self.s));
        let texels = self.axis.linear_indices(&lower);
        LinearTexels { lower, weight, texels }
    }
}

/// The lower of the two texels whose centres enclose `u`, -1 at least, and the weight of the upper
/// in [0, 1).
#[inline(always)]
pub fn lower_and_weight<S: Simd>(u: &F32s) -> (I32s, F32s) {
    let mut i = I32s::ZERO;
    let mut weight = F32s::ZERO;
    for lane in 0..LANES {
        let x = u[lane] - 0.5;
        let whole;
        (i[lane], whole) = S::floor_small(x);
        weight[lane] = x - whole;
    }
    (i, weight)
}

/// The layer of an array: the nearest, held in range (GLSL 1.30, section 8.7). NaN is layer 0.
#[inline(always)]
pub fn layer(r: &F32s, layers: u32) -> U32s {
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        let nearest = floor(clamp(r[lane], 0.0, layers as f32) + 0.5);
        out[lane] = to_i32(clamp(nearest, 0.0, layers as f32 - 1.0)) as u32;
    }
    out
}
