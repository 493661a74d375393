//! One component of each of the four texels that a linear filter of the base level would weigh
//! (ARB_texture_gather).
//!
//! Texel indices are wrapped as integers, one by one (OpenGL 3.2, section 3.8.8). A filter clamps the coordinate instead,
//! after which a texel beyond an edge may have no weight and be any texel; a gather has to return the right one.

use super::compare::unit_range;
use super::coordinates::Coordinates;
use super::level_view::LevelView;
use super::lookup::Points;
use super::recorder::NoRecorder;
use super::wrap::{Axis, Indices, lower_and_weight, modulo};
use super::{cube, expand, fetch, seamless};
use crate::lanes::math::{clamp, max};
use crate::lanes::{F32s, I32s, Kernel, LANES, Simd, U32s};
use crate::plan::Texture;
use crate::sampler::{Filter, Seamless, Wrap};

/// One call: 64 times four texels of an image with two axes.
pub(crate) struct Gather<'a> {
    pub texture: &'a Texture,
    pub points: Points<'a>,
    /// Texels added along s, t.
    pub offset: [i32; 2],
    /// The texels at (i, j + 1), (i + 1, j + 1), (i + 1, j), (i, j).
    pub out: &'a mut [F32s; 4],
}

/// The component of `out` for the texel at `(i, j) + (number % 2, number / 2)`.
const GATHER_ORDER: [usize; 4] = [3, 2, 0, 1];

impl Kernel for Gather<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { texture, points: Points { coords, layer, reference }, offset, out } = self;
        let reference = match texture.compare {
            Some(_) => unit_range(reference.unwrap_or(coords[2])),
            None => F32s::ZERO,
        };
        let mut coordinates = Coordinates::in_plane(coords);
        coordinates.locate(texture, layer, &mut NoRecorder);
        let [s, t, _] = coordinates.filtered();
        let mut missing = [U32s::ZERO; 4];
        for (face, levels) in texture.levels.iter().enumerate() {
            let mut on_face = U32s::ZERO;
            for lane in 0..LANES {
                on_face[lane] = if coordinates.face()[lane] == face as u32 { !0 } else { 0 };
            }
            let Some(level) = levels.first().filter(|_| S::any(&on_face)) else { continue };
            let (filter, number, layer, reference) =
                (Filter::Linear, 0, &coordinates.layer, &reference);
            let view = LevelView { texture, filter, face, number, level, layer, reference };
            let x = S::outlined(PairOnAxis { axis: view.axis(0), s, offset: offset[0] });
            let y = S::outlined(PairOnAxis { axis: view.axis(1), s: t, offset: offset[1] });
            for corner in 0..4 {
                let texel = [corner % 2, corner / 2];
                let (component, absent) =
                    S::outlined(CornerTexel { view: &view, along: [&x, &y], texel });
                let to = &mut out[GATHER_ORDER[corner]];
                for lane in 0..LANES {
                    let is_on_face = on_face[lane] != 0;
                    to[lane] = if is_on_face { component[lane] } else { to[lane] };
                    missing[corner][lane] |= absent[lane] & on_face[lane];
                }
            }
        }
        if texture.seamless == Seamless::On {
            fill_missing(texture, &missing, out);
        }
    }
}

/// The two texels that enclose a coordinate along one axis.
struct TexelPair {
    /// Index of the lower one, unwrapped.
    lower: I32s,
    /// Both, wrapped, as stored indices.
    texels: [Indices; 2],
}

struct PairOnAxis<'a> {
    axis: Axis,
    s: &'a F32s,
    /// Texels that are added.
    offset: i32,
}

impl Kernel for PairOnAxis<'_> {
    type Output = TexelPair;

    #[inline(always)]
    fn run<S: Simd>(self) -> TexelPair {
        let Self { axis, s, offset } = self;
        let rule = WrapRule::new(axis.wrap, axis.size as i32);
        let mut u = F32s::ZERO;
        match rule.repeats {
            Some(period) => {
                for lane in 0..LANES {
                    let periods = s[lane] / period;
                    u[lane] = max(periods - S::floor(periods), 0.0) * (period * axis.size as f32);
                }
            }
            None => {
                let limit = axis.size as f32 + MARGIN;
                for lane in 0..LANES {
                    let x = s[lane] * axis.scale;
                    u[lane] = clamp(if x.is_nan() { 0.0 } else { x }, -limit, limit);
                }
            }
        }
        let (mut lower, _) = lower_and_weight::<S>(&u);
        for lane in 0..LANES {
            lower[lane] += offset;
        }
        let texels = [wrap_indices(axis, &rule, &lower, 0), wrap_indices(axis, &rule, &lower, 1)];
        TexelPair { lower, texels }
    }
}

/// Coordinates are clamped to this many texels beyond the image: more than any offset.
const MARGIN: f32 = 64.0;

/// Larger than any texel index.
const UNBOUNDED: i32 = 1 << 23;

/// The steps that wrap an index `i` or `i + 1` of `n` texels (OpenGL 3.2, table 3.20). A step that does not apply is an
/// identity.
struct WrapRule {
    /// The period of the coordinate, if the image repeats.
    repeats: Option<f32>,
    /// First `i` is clamped to this range. (`GL_CLAMP` keeps one of the two texels inside the image.)
    first: [i32; 2],
    /// Then the index repeats: start and length of one period.
    period: [i32; 2],
    /// Then an index below 0 is XORed with this: all ones mirrors at 0.
    mirror: i32,
    /// Last the index is clamped to this range; -1 and `n` are the border.
    last: [i32; 2],
}

impl WrapRule {
    fn new(wrap: Wrap, n: i32) -> Self {
        let (edge, border) = ([0, n - 1], [-1, n]);
        let straight = Self {
            repeats: None,
            first: [-UNBOUNDED, UNBOUNDED],
            period: [-UNBOUNDED, 2 * UNBOUNDED],
            mirror: 0,
            last: border,
        };
        let mirrored = Self { mirror: !0, ..straight };
        match wrap {
            Wrap::Repeat => Self { repeats: Some(1.0), period: [0, n], ..straight },
            Wrap::MirroredRepeat => Self { repeats: Some(2.0), period: [-n, 2 * n], ..mirrored },
            Wrap::Clamp => Self { first: [-1, n - 1], ..straight },
            Wrap::ClampToEdge => Self { last: edge, ..straight },
            Wrap::ClampToBorder => straight,
            Wrap::MirrorClamp => Self { first: [-n - 1, n - 1], ..mirrored },
            Wrap::MirrorClampToEdge => Self { last: edge, ..mirrored },
            Wrap::MirrorClampToBorder => mirrored,
        }
    }
}

#[inline(always)]
fn clamp_index(i: i32, [low, high]: [i32; 2]) -> i32 {
    let raised = if i < low { low } else { i };
    if raised > high { high } else { raised }
}

#[inline(always)]
fn wrap_indices(axis: Axis, rule: &WrapRule, i: &I32s, added: i32) -> Indices {
    let [start, length] = rule.period;
    let mut wrapped = I32s::ZERO;
    for lane in 0..LANES {
        let index = clamp_index(i[lane], rule.first) + added;
        let repeated = modulo(index - start, length) + start;
        wrapped[lane] = clamp_index(repeated ^ (repeated >> 31 & rule.mirror), rule.last);
    }
    axis.stored_indices(&wrapped)
}

/// The first component of one texel after the swizzle, and a mask of the lanes without a texel (beyond a cube's corner).
struct CornerTexel<'a> {
    view: &'a LevelView<'a>,
    along: [&'a TexelPair; 2],
    /// 0 for the lower, 1 for the upper texel along each axis.
    texel: [usize; 2],
}

impl Kernel for CornerTexel<'_> {
    type Output = (F32s, U32s);

    #[inline(always)]
    fn run<S: Simd>(self) -> (F32s, U32s) {
        let Self { view, along: [x, y], texel } = self;
        let texture = view.texture;
        let (mut channels, mut absent) = ([F32s::ZERO; 4], U32s::ZERO);
        match texture.seamless {
            Seamless::Off => {
                let indices = [&x.texels[texel[0]], &y.texels[texel[1]], &view.slice()];
                fetch::texels::<S>(view, indices, &mut channels, &mut NoRecorder);
            }
            Seamless::On => {
                let (face, size) = (view.face as u32, view.level.width as i32);
                let corner_offset = [texel[0] as i32, texel[1] as i32];
                let found = cube::across_edge(face, &x.lower, &y.lower, corner_offset, size);
                seamless::texels::<S>(view, &found, &mut channels);
                absent = found.missing;
            }
        }
        expand::expand(texture.format, texture.depth_mode, &mut channels);
        expand::swizzle(texture.format, texture.swizzle, &mut channels);
        (channels[0], absent)
    }
}

/// Replaces missing texels by the mean of the other three; for integers, by the texel opposite.
#[inline(always)]
fn fill_missing(texture: &Texture, missing: &[U32s; 4], out: &mut [F32s; 4]) {
    let is_integer = texture.format.is_integer();
    for corner in 0..4 {
        let [to, a, b] = [GATHER_ORDER[corner], GATHER_ORDER[corner ^ 1], GATHER_ORDER[corner ^ 2]];
        let opposite = GATHER_ORDER[corner ^ 3];
        for lane in 0..LANES {
            let opposite_texel = out[opposite][lane];
            let mean = (out[a][lane] + out[b][lane] + opposite_texel) / 3.0;
            let replacement = if is_integer { opposite_texel } else { mean };
            let texel = out[to][lane];
            out[to][lane] = if missing[corner][lane] == 0 { texel } else { replacement };
        }
    }
}
