//! The general filters on one level: the nearest texel, or the weighted mean of 2, 2×2 or 2×2×2 (GL 2.1, section 3.8.8).
//!
//! The mean is linear interpolations, first along s, then along t, then along r, each
//! `a + (b - a) · α` in this order: two equal texels give exactly themselves. Channels of bytes are
//! weighed as 0 to 255 and divided at last, which is one division for all texels.

use super::interpolate::{divide, lerp_of_any, mean};
use super::level_view::LevelView;
use super::recorder::Recorder;
use super::wrap::{Indices, LinearTexels};
use super::{fast, fetch, seamless};
use crate::format::Block;
use crate::kernels::LookupKernel;
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s};
use crate::plan::{TexelClass, TexelPath};
use crate::sampler::{Filter, Seamless};
use crate::trace::SampleStep;

/// Samples one level in all 64 lanes. Only the stored channels of `out` are written.
#[inline(always)]
pub fn sample_level<S: Simd>(
    view: &LevelView<'_>,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let texels = match (view.texture.texel_path, view.filter) {
        (TexelPath::Words(class), Filter::Nearest | Filter::Linear) => {
            Some(FastTexels::Words(class))
        }
        (TexelPath::Blocks(block), Filter::Linear) => Some(FastTexels::Blocks(block)),
        // The general fetch of one texel is as fast.
        (TexelPath::Blocks(_), Filter::Nearest) => None,
        (
            TexelPath::General | TexelPath::ComparedWords(_) | TexelPath::ScatteredWords(_),
            Filter::Nearest | Filter::Linear,
        ) => None,
    };
    let done =
        texels.is_some_and(|texels| S::outlined(FastPath { view, texels, at, out: &mut *out }));
    match view.filter {
        _ if done => {}
        Filter::Nearest => {
            LookupKernel::GeneralTexelNearest.note();
            nearest::<S>(view, at, out, recorder);
        }
        Filter::Linear => {
            LookupKernel::GeneralTexelLinear.note();
            linear::<S>(view, at, out, recorder);
        }
    }
}

/// Texels that have a fast path.
#[derive(Clone, Copy)]
pub enum FastTexels {
    Words(TexelClass),
    /// With a linear filter.
    Blocks(Block),
}

/// The fast path, without depth compare; `false` where it does not apply. One copy for all kernels.
pub struct FastPath<'a> {
    pub view: &'a LevelView<'a>,
    pub texels: FastTexels,
    pub at: [&'a F32s; 3],
    pub out: &'a mut [F32s; 4],
}

impl Kernel for FastPath<'_> {
    type Output = bool;
    #[inline(always)]
    fn run<S: Simd>(self) -> bool {
        let Self { view, texels, at, out } = self;
        match texels {
            FastTexels::Words(TexelClass::Bytes) => LookupKernel::FastBytes.note(),
            FastTexels::Words(TexelClass::Srgb) => LookupKernel::FastSrgb.note(),
            FastTexels::Words(TexelClass::Halves) => LookupKernel::FastHalves.note(),
            FastTexels::Words(TexelClass::Floats) => LookupKernel::FastFloats.note(),
            FastTexels::Words(TexelClass::Depth { .. }) => LookupKernel::FastDepths.note(),
            FastTexels::Blocks(_) => LookupKernel::FastBlocks.note(),
        }
        match (texels, view.filter) {
            (FastTexels::Words(class), Filter::Nearest) => fast::nearest::<S>(view, class, at, out),
            (FastTexels::Words(class), Filter::Linear) => fast::linear::<S>(view, class, at, out),
            (FastTexels::Blocks(block), Filter::Linear) => {
                fast::blocks::linear::<S>(view, block, at, out)
            }
            (FastTexels::Blocks(_), Filter::Nearest) => false,
        }
    }
}

#[inline(always)]
fn nearest<S: Simd>(
    view: &LevelView<'_>,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let axes = view.texture.shape.axes();
    recorder.record(|lane| SampleStep::Nearest { u: texel_coordinates::<S>(view, at, lane) });
    let x = view.axis(0).nearest_texel::<S>(at[0]);
    let mut y = Indices { index: U32s::ZERO, outside: U32s::ZERO };
    let mut z = view.slice();
    if axes > 1 {
        y = view.axis(1).nearest_texel::<S>(at[1]);
    }
    if axes > 2 {
        z = view.axis(2).nearest_texel::<S>(at[2]);
    }
    fetch::texels::<S>(view, [&x, &y, &z], out, recorder);
}

/// `u, v, w` of a lane, for a trace.
#[inline(always)]
fn texel_coordinates<S: Simd>(view: &LevelView<'_>, at: [&F32s; 3], lane: usize) -> [f32; 3] {
    let axes = view.texture.shape.axes();
    let mut u = [0.0; 3];
    for (axis, u) in u.iter_mut().enumerate().take(axes) {
        *u = view.axis(axis).texel_coordinate_outlined::<S>(at[axis])[lane];
    }
    u
}

#[inline(always)]
fn linear<S: Simd>(
    view: &LevelView<'_>,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let axes = view.texture.shape.axes();
    let axis = view.axis(0);
    let LinearTexels { lower: i, weight: alpha, texels: xs } = axis.linear_texels::<S>(at[0]);
    let close = fetch::side_by_side::<S>(&i, axis.size);
    let none = || Indices { index: U32s::ZERO, outside: U32s::ZERO };
    let (mut ys, mut beta) = ([none(), none()], F32s::ZERO);
    let (mut zs, mut gamma) = ([view.slice(), none()], F32s::ZERO);
    if axes > 1 {
        let axis = view.axis(1);
        let LinearTexels { lower: j, weight, texels } = axis.linear_texels::<S>(at[1]);
        beta = weight;
        let crosses = view.texture.seamless == Seamless::On
            && !(close && fetch::side_by_side::<S>(&j, axis.size));
        if crosses {
            recorder.record(|lane| SampleStep::Linear {
                u: texel_coordinates::<S>(view, at, lane),
                weights: [alpha[lane], beta[lane], 0.0],
                axes,
            });
            return seamless::linear::<S>(view, [&i, &j], [&alpha, &beta], out, recorder);
        }
        ys = texels;
    }
    if axes > 2 {
        LinearTexels { weight: gamma, texels: zs, .. } = view.axis(2).linear_texels::<S>(at[2]);
    }
    recorder.record(|lane| SampleStep::Linear {
        u: texel_coordinates::<S>(view, at, lane),
        weights: [alpha[lane], beta[lane], gamma[lane]],
        axes,
    });
    let slices = if axes > 2 { 2 } else { 1 };
    let mut corners = [[F32s::ZERO; 4]; 4];
    for (slice, z) in zs.iter().enumerate().take(slices) {
        for row in 0..axes.min(2) {
            let y = &ys[row];
            let [left, right] = &mut corners[2 * row..2 * row + 2] else { continue };
            if close && view.level.format.words() == 1 && view.level.format.block().is_none() {
                fetch::row::<S>(view, &xs, y, z, [left, right], recorder);
            } else {
                fetch::texels::<S>(view, [&xs[0], y, z], left, recorder);
                fetch::texels::<S>(view, [&xs[1], y, z], right, recorder);
            }
        }
        for (channel, out) in out.iter_mut().enumerate().take(view.texture.format.channels()) {
            let mean = mean(view.texture.format, &corners, channel, [&alpha, &beta]);
            if slice == 0 {
                *out = mean;
            } else {
                for lane in 0..LANES {
                    out[lane] = lerp_of_any(out[lane], mean[lane], gamma[lane]);
                }
            }
        }
    }
    divide(view.texture.format, out);
}
