//! One component of each of the four texels that a linear filter of the base level would weigh
//! (ARB_texture_gather).
//!
//! Which they are is a matter of integers, wrapped one by one (OpenGL 3.2, section 3.8.8). A filter holds the coordinate
//! first: of two texels beyond an edge, one has no weight then, and may be any.

use super::filter::Place;
use super::record::Off;
use super::wrap::Indices;
use super::{Coordinates, cube, expand, fetch, seamless, unit_range};
use crate::lanes::{F32s, I32s, Kernel, LANES, Simd, U32s};
use crate::plan::{Points, Texture};
use crate::sampler::{Filter, Seamless};

/// One call: 64 times four texels of an image with two axes.
pub(crate) struct Gather<'a> {
    pub texture: &'a Texture,
    pub points: Points<'a>,
    /// Texels added along s, t.
    pub offset: [i32; 2],
    /// Those at (i, j + 1), (i + 1, j + 1), (i + 1, j), (i, j).
    pub out: &'a mut [F32s; 4],
}

/// Where in `out` the texel at `(i, j) + (number % 2, number / 2)` stands.
const PLACES: [usize; 4] = [3, 2, 0, 1];

impl Kernel for Gather<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { texture, points: Points { coords, layer, reference }, offset, out } = self;
        let reference = match texture.compare {
            Some(_) => unit_range(reference.unwrap_or(coords[2])),
            None => F32s::ZERO,
        };
        let at = Coordinates::new(texture, coords, layer, &mut Off);
        let [s, t, _] = at.filtered();
        let mut missing = [U32s::ZERO; 4];
        for (face, levels) in texture.levels.iter().enumerate() {
            let mut here = U32s::ZERO;
            for lane in 0..LANES {
                here[lane] = if at.face[lane] == face as u32 { !0 } else { 0 };
            }
            let Some(level) = levels.first().filter(|_| S::any(&here)) else { continue };
            let (filter, number, layer, reference) = (Filter::Linear, 0, &at.layer, &reference);
            let place = Place { texture, filter, face, number, level, layer, reference };
            let axes = [place.axis(0), place.axis(1)];
            let lower = [axes[0].below::<S>(s, offset[0]), axes[1].below::<S>(t, offset[1])];
            let pairs = [axes[0].wrapped(&lower[0]), axes[1].wrapped(&lower[1])];
            for corner in 0..4 {
                let step = [corner % 2, corner / 2];
                let (found, lacks) = texel::<S>(&place, &lower, &pairs, step);
                let to = &mut out[PLACES[corner]];
                for lane in 0..LANES {
                    let is_here = here[lane] != 0;
                    to[lane] = if is_here { found[lane] } else { to[lane] };
                    missing[corner][lane] |= lacks[lane] & here[lane];
                }
            }
        }
        if texture.seamless == Seamless::On {
            stand_in(texture, &missing, out);
        }
    }
}

/// The first component of a texel after the swizzle, and where there is none (a mask): beyond a corner of a cube.
#[inline(always)]
fn texel<S: Simd>(
    place: &Place<'_>,
    [i, j]: &[I32s; 2],
    [xs, ys]: &[[Indices; 2]; 2],
    step: [usize; 2],
) -> (F32s, U32s) {
    let texture = place.texture;
    let (mut channels, mut missing) = ([F32s::ZERO; 4], U32s::ZERO);
    match texture.seamless {
        Seamless::Off => {
            let at = [&xs[step[0]], &ys[step[1]], &place.slice()];
            fetch::texels::<S>(place, at, &mut channels, &mut Off);
        }
        Seamless::On => {
            let step = [step[0] as i32, step[1] as i32];
            let found = cube::beyond(place.face as u32, i, j, step, place.level.width as i32);
            seamless::texels::<S>(place, &found, &mut channels);
            missing = found.missing;
        }
    }
    expand::expand(texture.format, texture.depth_mode, &mut channels);
    expand::swizzle(texture.format, texture.swizzle, &mut channels);
    (channels[0], missing)
}

/// Where there is no texel, the mean of the other three; of integers, which have no mean, the one texel of the face.
#[inline(always)]
fn stand_in(texture: &Texture, missing: &[U32s; 4], out: &mut [F32s; 4]) {
    let is_integer = texture.format.is_integer();
    for corner in 0..4 {
        let [to, a, b] = [PLACES[corner], PLACES[corner ^ 1], PLACES[corner ^ 2]];
        let opposite = PLACES[corner ^ 3];
        for lane in 0..LANES {
            let alone = out[opposite][lane];
            let mean = (out[a][lane] + out[b][lane] + alone) / 3.0;
            let instead = if is_integer { alone } else { mean };
            let here = out[to][lane];
            out[to][lane] = if missing[corner][lane] == 0 { here } else { instead };
        }
    }
}
