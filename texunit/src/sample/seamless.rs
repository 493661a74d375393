//! Linear filtering across the edges of a cube (ARB_seamless_cube_map).
//!
//! A texel beyond an edge is the one that touches the edge from the other face. Beyond a corner
//! there is none: the mean of the other three replaces it.

use super::interpolate::{divide, mean};
use super::level_view::LevelView;
use super::recorder::{NoRecorder, Recorder};
use super::wrap::Indices;
use super::{cube, fetch};
use crate::format::Format;
use crate::lanes::{F32s, I32s, LANES, Simd, U32s};
use crate::trace::{SampleStep, TexelSource};

/// The mean of 2×2 texels, of which `i` and `j` (-1 to the size - 1) are the lower indices.
#[inline(always)]
pub fn linear<S: Simd>(
    view: &LevelView<'_>,
    [i, j]: [&I32s; 2],
    [alpha, beta]: [&F32s; 2],
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let view_of = |face: u32| LevelView { face: face as usize, ..*view };
    let mut corners = [[F32s::ZERO; 4]; 4];
    let mut missing = [U32s::ZERO; 4];
    for corner in 0..4 {
        let corner_offset = [(corner & 1) as i32, (corner >> 1) as i32];
        let found =
            cube::across_edge(view.face as u32, i, j, corner_offset, view.level.width as i32);
        missing[corner] = found.missing;
        texels::<S>(view, &found, &mut corners[corner]);
        recorder.record(|lane| SampleStep::Texel {
            face: found.face[lane],
            at: [found.x[lane], found.y[lane], view_of(found.face[lane]).slice().index[lane]],
            source: match found.missing[lane] {
                0 => TexelSource::Stored,
                _ => TexelSource::Corner,
            },
            value: corners[corner].each_ref().map(|channel| channel[lane]),
            compare: None,
        });
    }
    mean_of_corners(view.texture.format, &mut corners, &missing, [alpha, beta], out);
}

/// The mean of 2×2 texels, of which one may be missing.
#[inline(always)]
pub fn mean_of_corners(
    format: Format,
    corners: &mut [[F32s; 4]; 4],
    missing: &[U32s; 4],
    [alpha, beta]: [&F32s; 2],
    out: &mut [F32s; 4],
) {
    for (channel, out) in out.iter_mut().enumerate().take(format.channels()) {
        for corner in 0..4 {
            for lane in 0..LANES {
                let a = corners[(corner + 1) % 4][channel][lane];
                let b = corners[(corner + 2) % 4][channel][lane];
                let c = corners[(corner + 3) % 4][channel][lane];
                let texel = corners[corner][channel][lane];
                let exists = missing[corner][lane] == 0;
                corners[corner][channel][lane] = if exists { texel } else { (a + b + c) / 3.0 };
            }
        }
        *out = mean(format, corners, channel, [alpha, beta]);
    }
    divide(format, out);
}

/// One texel of each lane, from whichever faces the lanes ended up on.
#[inline(always)]
pub fn texels<S: Simd>(view: &LevelView<'_>, found: &cube::EdgeTexels, out: &mut [F32s; 4]) {
    for (face, levels) in view.texture.levels.iter().enumerate() {
        let mut on_face = U32s::ZERO;
        for lane in 0..LANES {
            on_face[lane] = if found.face[lane] == face as u32 { !0 } else { 0 };
        }
        if !S::any(&on_face) {
            continue;
        }
        let level = &*levels[view.number];
        let view = LevelView { face, level, ..*view };
        let mut x = Indices { index: found.x, outside: U32s::ZERO };
        let mut y = Indices { index: found.y, outside: U32s::ZERO };
        for lane in 0..LANES {
            x.index[lane] += level.border[0];
            y.index[lane] += level.border[1];
        }
        let mut texel = [F32s::ZERO; 4];
        let texels = [&x, &y, &view.slice()];
        fetch::texels::<S>(&view, texels, &mut texel, &mut NoRecorder);
        for (out, texel) in out.iter_mut().zip(&texel) {
            for lane in 0..LANES {
                out[lane] = if found.face[lane] == face as u32 { texel[lane] } else { out[lane] };
            }
        }
    }
}
