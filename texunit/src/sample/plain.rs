//! The short way for most textures: two-dimensional, linear bytes, neither border nor compare.
//!
//! Gives the bits of the general way in `filter` (a test holds this), in fewer passes: whole
//! offsets in one loop, a row's two texels in one gather, four channels from words in registers.

use super::fetch;
use super::filter::{Place, lerp};
use super::wrap::{enclosing, floor_i32};
use crate::format::convert::byte_channel;
use crate::lanes::{F32s, LANES, Simd, U32s};
use crate::sampler::Wrap;

/// The texel that each point lies in.
#[inline(always)]
pub fn nearest<S: Simd>(place: &Place<'_>, at: [&F32s; 3], out: &mut [F32s; 4]) {
    let (s, t) = (place.axis(0), place.axis(1));
    let (u, v) = (s.texel_coordinate(at[0]), t.texel_coordinate(at[1]));
    let level = place.level;
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let origin = level.origin() as u32;
    let (last_s, last_t) = (s.size as i32 - 1, t.size as i32 - 1);
    let mut offsets = U32s::ZERO;
    for lane in 0..LANES {
        // Neither is below 0; the coordinate may be rounded up to the size.
        let (i, j) = (floor_i32(u[lane]), floor_i32(v[lane]));
        let x = if i > last_s { last_s } else { i } as u32;
        let y = if j > last_t { last_t } else { j } as u32;
        offsets[lane] = y.wrapping_mul(row).wrapping_add(x.wrapping_mul(bytes)) + origin;
    }
    let words = S::gather(&level.texels, &offsets);
    let channels = level.format.channels();
    let [r, g, b, a] = out;
    bytes_of::<0>(&words, r);
    if channels > 1 {
        bytes_of::<1>(&words, g);
    }
    if channels > 2 {
        bytes_of::<2>(&words, b);
    }
    if channels > 3 {
        bytes_of::<3>(&words, a);
    }
}

#[inline(always)]
fn bytes_of<const CHANNEL: usize>(words: &U32s, out: &mut F32s) {
    for lane in 0..LANES {
        out[lane] = byte_channel(words[lane], CHANNEL);
    }
}

/// The mean of 2×2 texels, where those of a row lie side by side in every lane; otherwise `false`,
/// and nothing is written.
#[inline(always)]
pub fn linear<S: Simd>(place: &Place<'_>, at: [&F32s; 3], out: &mut [F32s; 4]) -> bool {
    let (s, t) = (place.axis(0), place.axis(1));
    let (i, alpha) = enclosing(&s.texel_coordinate(at[0]));
    if !fetch::side_by_side(&i, s.size) {
        return false;
    }
    let (j, beta) = enclosing(&t.texel_coordinate(at[1]));
    let level = place.level;
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let origin = level.origin() as u32;
    let last = t.size as i32 - 1;
    // Only repeating reaches below the first row.
    let after_last = if t.wrap == Wrap::Repeat { 0 } else { last };
    let mut lower = U32s::ZERO;
    let mut upper = U32s::ZERO;
    for lane in 0..LANES {
        let y0 = if j[lane] < 0 { last } else { j[lane] } as u32;
        let y1 = if j[lane] < last { j[lane] + 1 } else { after_last } as u32;
        let x = (i[lane] as u32).wrapping_mul(bytes) + origin;
        lower[lane] = y0.wrapping_mul(row).wrapping_add(x);
        upper[lane] = y1.wrapping_mul(row).wrapping_add(x);
    }
    let lower = fetch::neighbours::<S>(level, &lower);
    let upper = fetch::neighbours::<S>(level, &upper);
    let channels = level.format.channels();
    let [r, g, b, a] = out;
    mean_of_bytes::<0>(&lower, &upper, &alpha, &beta, r);
    if channels > 1 {
        mean_of_bytes::<1>(&lower, &upper, &alpha, &beta, g);
    }
    if channels > 2 {
        mean_of_bytes::<2>(&lower, &upper, &alpha, &beta, b);
    }
    if channels > 3 {
        mean_of_bytes::<3>(&lower, &upper, &alpha, &beta, a);
    }
    true
}

#[inline(always)]
fn mean_of_bytes<const CHANNEL: usize>(
    lower: &[U32s; 2],
    upper: &[U32s; 2],
    alpha: &F32s,
    beta: &F32s,
    out: &mut F32s,
) {
    for lane in 0..LANES {
        let a = byte_channel(lower[0][lane], CHANNEL);
        let b = byte_channel(lower[1][lane], CHANNEL);
        let c = byte_channel(upper[0][lane], CHANNEL);
        let d = byte_channel(upper[1][lane], CHANNEL);
        out[lane] = lerp(lerp(a, b, alpha[lane]), lerp(c, d, alpha[lane]), beta[lane]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::Format;
    use crate::image::{Image, Level, Shape};
    use crate::lanes::Isa;
    use crate::plan::{Lod, SamplePlan};
    use crate::sampler::{Filter, Mipmap, Sampler};

    fn noise(seed: u32) -> u32 {
        let mixed = seed.wrapping_mul(0x9E37_79B9) ^ seed >> 13;
        mixed.wrapping_mul(0x85EB_CA6B) ^ mixed >> 15
    }

    fn image(shape: Shape, format: Format, size: [u32; 3], seed: u32) -> Image {
        let mut image = Image::new(shape);
        let mut size = size;
        for number in 0..=size[0].max(size[1]).ilog2() {
            let border = shape.border(seed & 1);
            for face in 0..shape.faces() {
                let mut level = Level::with_size(format, size, border).unwrap();
                for (i, byte) in level.texels.iter_mut().enumerate() {
                    *byte = noise(i as u32 ^ seed << 8 ^ number << 20) as u8;
                }
                image.set_level(face, number as usize, level).unwrap();
            }
            size = shape.halved(size);
        }
        image
    }

    #[test]
    fn the_short_way_gives_the_bits_of_the_general_one() {
        let formats = [Format::Rgba8, Format::Rgb8, Format::La8, Format::L8, Format::A8];
        for round in 0..400_u32 {
            let pick = |salt: u32, n: usize| noise(round * 16 + salt) as usize % n;
            let (shape, border) = [(Shape::D2, round), (Shape::Cube, round & !1)][pick(0, 2)];
            let width = 1 + pick(1, 40) as u32;
            let height = if shape == Shape::Cube { width } else { 1 + pick(2, 40) as u32 };
            let image = image(shape, formats[pick(3, 5)], [width, height, 1], border);
            let filters = [Filter::Nearest, Filter::Linear];
            let sampler = Sampler {
                wrap: [4, 5, 6].map(|salt| Wrap::ALL[pick(salt, Wrap::ALL.len())]),
                min: filters[pick(7, 2)],
                mag: filters[pick(8, 2)],
                mipmap: [Mipmap::None, Mipmap::Nearest, Mipmap::Linear][pick(9, 3)],
                border: [-1.0, 0.25, 2.0, 0.5],
                max_anisotropy: [1.0, 4.0][pick(10, 2)],
                ..Sampler::default()
            };
            let plan = SamplePlan::new(&image, &sampler);
            assert!(plan.incomplete().is_none());
            let scale = [0.01, 0.1, 4.0][pick(11, 3)];
            let coords = [12, 13, 14].map(|salt| {
                F32s::from_fn(|lane| {
                    let part = noise(lane as u32 ^ round << 8 ^ salt << 24) >> 8;
                    match part % 61 {
                        0 => f32::NAN,
                        1 => -1e7,
                        2 => f32::INFINITY,
                        _ => scale * (part as f32 / 8_388_608.0 - 1.0) + 0.01 * lane as f32,
                    }
                })
            });
            for isa in Isa::available() {
                let sample = |plan: &SamplePlan| {
                    let mut out = [F32s::ZERO; 4];
                    let lod = Lod::Implicit { bias: None };
                    plan.sample(isa, coords.each_ref(), None, lod, &mut out);
                    out.map(|c| *c.as_u32())
                };
                assert_eq!(sample(&plan), sample(&plan.general()), "{}", plan.describe());
            }
        }
    }
}
