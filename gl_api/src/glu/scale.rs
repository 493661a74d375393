//! GLU's box filter: each new pixel is the mean of the area it covers in the old image ([`boxes`]), rounded once,
//! halves up. libGLU truncates where it rescales or halves a side of one pixel: its last bit differs there.
//!
//! Mipmaps of bytes, which nearly all are, are halved as GL's own are ([`halve`]).

use super::pixels::{Layout, Meaning, TooShort};
use crate::entry::with_current;
use texunit::format::Format;
use texunit::image::{ImageError, Level, Shape};
use texunit::lanes::Isa;
use texunit::pixel::boxes;

/// The pixels of one image as those of another, at its size and of its type.
///
/// Halving an even side is the mean of two pixels; a side that keeps its length keeps its pixels.
///
/// # Errors
/// When the bytes of either end before it does; nothing is written then.
pub fn scale(
    meaning: Meaning,
    (from, given): (&Layout, &[u8]),
    (to, out): (&Layout, &mut [u8]),
) -> Result<(), TooShort> {
    to.check(out)?;
    from.check(given)?;
    let (isa, count) = (isa(), from.count);
    let records = [from, to].map(Layout::record);
    let read = |[y, z]: [usize; 2], numbers: &mut boxes::Planes| {
        let row = &given[from.row(y, z)..][..from.row_bytes()];
        boxes::read_row(isa, &records[0], row, numbers);
    };
    let steps = [from, to].map(|layout| layout.storage.steps());
    let between = [steps[0], from.storage.to(to.storage), steps[1]];
    let changes = match meaning {
        _ if from.storage == to.storage => &between[..1],
        Meaning::Fractions => &between[..],
        Meaning::Indices => &steps[..],
    };
    let mut rows = to.rows();
    let write = |numbers: &boxes::Planes| {
        if let Some(at) = rows.next() {
            let row = &mut out[at..][..to.row_bytes()];
            boxes::write_row(isa, &records[1], changes, numbers, row);
        }
    };
    boxes::scale(isa, [from.size, to.size], count, read, write);
    Ok(())
}

/// The instruction set of the current context's device; the plainest without a context.
fn isa() -> Isa {
    with_current(|context| context.recorder.isa()).unwrap_or(Isa::BASELINE)
}

/// Bytes, one to four a pixel, at half the size: what [`scale`] makes of them. A side of one pixel stays.
pub fn halve(pixels: &Level) -> Result<Level, ImageError> {
    pixels.halved(Shape::D3, isa())
}

/// Bytes without gaps, so many a pixel.
pub fn bytes(size: [usize; 3], count: usize, texels: &[u8]) -> Result<Level, ImageError> {
    let format = [Format::R8, Format::Rg8, Format::Rgb8, Format::Rgba8][(count - 1).min(3)];
    let size = size.map(|side| side as u32);
    let mut level = Level::with_size(format, size, [0; 3])?;
    level.write_box([0; 3], size, texels)?;
    Ok(level)
}

#[cfg(test)]
mod tests {
    use super::super::pixels::{Components, Storage};
    use super::*;
    use crate::pixel::convert;
    use proptest::prelude::*;

    /// An image of this storage at another size.
    fn scale(image: &Components, size: [usize; 3], storage: Storage) -> Components {
        let [from, to] = [image.size, size].map(|size| Layout::tight(size, image.count, storage));
        let (mut given, mut out) = (vec![0; from.needed()], vec![0; to.needed()]);
        from.write(image, &mut given).unwrap();
        super::scale(Meaning::Fractions, (&from, &given), (&to, &mut out)).unwrap();
        to.read(&out).unwrap()
    }

    /// The old pixels that new pixel `index` covers, and how much of each.
    fn covered(index: usize, old: usize, new: usize) -> impl Iterator<Item = (usize, f64)> + Clone {
        let (low, high) = (index * old, (index + 1) * old);
        (low / new..high.div_ceil(new)).map(move |pixel| {
            let overlap = high.min((pixel + 1) * new) - low.max(pixel * new);
            (pixel, overlap as f64)
        })
    }

    fn bytes(width: usize, height: usize, values: &[u8]) -> Components {
        Layout::tight([width, height, 1], 1, Storage::U8).read(values).unwrap()
    }

    #[test]
    fn halving_is_the_rounded_mean_of_four() {
        let image = bytes(4, 2, &[0, 1, 10, 20, 0, 1, 30, 41]);
        assert_eq!(scale(&image, [2, 1, 1], Storage::U8).values, [1.0, 25.0]);
        assert_eq!(scale(&image, [4, 1, 1], Storage::U8).values, [0.0, 1.0, 20.0, 31.0]);
    }

    #[test]
    fn three_pixels_to_two_share_the_middle_one() {
        let image = bytes(3, 1, &[0, 90, 240]);
        assert_eq!(scale(&image, [2, 1, 1], Storage::U8).values, [30.0, 190.0]);
        assert_eq!(
            scale(&image, [6, 1, 1], Storage::U8).values,
            [0.0, 0.0, 90.0, 90.0, 240.0, 240.0]
        );
    }

    #[test]
    fn slices_are_averaged_too() {
        let layout = Layout::tight([2, 1, 3], 1, Storage::U8);
        let image = layout.read(&[0, 10, 30, 40, 90, 220]).unwrap();
        assert_eq!(scale(&image, [1, 1, 1], Storage::U8).values, [65.0]);
        assert_eq!(scale(&image, [2, 1, 1], Storage::U8).values, [40.0, 90.0]);
        assert_eq!(scale(&image, [1, 1, 3], Storage::U8).values, [5.0, 35.0, 155.0]);
    }

    proptest! {
        /// Against the integral of the image, one pixel at a time, by many thin slices.
        #[test]
        fn every_pixel_is_the_mean_of_its_area(
            (width, height, values) in (1usize..12, 1usize..12).prop_flat_map(|(w, h)|
                (Just(w), Just(h), proptest::collection::vec(any::<u8>(), w * h))),
            new_width in 1usize..12,
            new_height in 1usize..12,
        ) {
            let scaled = scale(&bytes(width, height, &values), [new_width, new_height, 1], Storage::F32);
            for y in 0..new_height {
                for x in 0..new_width {
                    let mut sum = 0u64;
                    for sy in 0..height {
                        for sx in 0..width {
                            // Slice (sx, sy) of a pixel cut into old-width by old-height slices.
                            let at = (x * width + sx) / new_width
                                + (y * height + sy) / new_height * width;
                            sum += u64::from(values[at]);
                        }
                    }
                    let oracle = sum as f64 / (width * height) as f64;
                    let got = scaled.values[y * new_width + x];
                    prop_assert!((got - oracle).abs() <= oracle * 1e-7, "{got} {oracle}");
                }
            }
        }

        /// To the bit: as it was written first, a pixel at a time.
        #[test]
        fn the_weights_are_added_up_in_their_order(
            size in (1usize..9, 1usize..9, 1usize..4),
            new in (1usize..9, 1usize..9, 1usize..4),
            count in 1usize..5,
            seed: u64,
            storage in prop::sample::select(vec![Storage::U8, Storage::I16, Storage::F32]),
        ) {
            let (size, new) = ([size.0, size.1, size.2], [new.0, new.1, new.2]);
            let mut random = seed;
            let mut next = || {
                random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                match (storage, random >> 33) {
                    (Storage::U8, bits) => f64::from(bits as u8),
                    (Storage::I16, bits) => f64::from(bits as i16),
                    (_, bits) if bits % 5 == 0 => -0.0,
                    (_, bits) => f64::from(bits as i16 as f32 / 1000.0),
                }
            };
            let values = (0..size.iter().product::<usize>() * count).map(|_| next()).collect();
            let image = Components { size, count, values };
            let mut expected = Vec::new();
            for z in 0..new[2] {
                for y in 0..new[1] {
                    let mut row = vec![0.0; size[0] * count];
                    for (old_z, inward) in covered(z, size[2], new[2]) {
                        for (old_y, down) in covered(y, size[1], new[1]) {
                            let first = (old_z * size[1] + old_y) * size[0] * count;
                            let weight = inward * down;
                            for (sum, value) in row.iter_mut().zip(&image.values[first..]) {
                                *sum += weight * value;
                            }
                        }
                    }
                    for x in 0..new[0] {
                        for component in 0..count {
                            let sum: f64 = covered(x, size[0], new[0])
                                .map(|(old_x, weight)| weight * row[old_x * count + component])
                                .sum();
                            let mean = sum / size.iter().map(|side| *side as f64).product::<f64>();
                            let (low, high) = match storage {
                                Storage::U8 => (0.0, 255.0),
                                _ => (-32_768.0, 32_767.0),
                            };
                            expected.push(match storage {
                                Storage::F32 => f64::from(mean as f32),
                                _ => (mean + 0.5).floor().max(low).min(high),
                            });
                        }
                    }
                }
            }
            let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
            prop_assert_eq!(bits(&scale(&image, new, storage).values), bits(&expected));
        }

        #[test]
        fn bytes_are_halved_as_numbers_are(
            sides in (0u32..6, 0u32..6, 0u32..3),
            count in 1usize..5,
            seed: u64,
        ) {
            let size = [1 << sides.0, 1 << sides.1, 1 << sides.2];
            let mut random = seed;
            let texels: Vec<u8> = (0..size.iter().product::<usize>() * count)
                .map(|_| {
                    random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    (random >> 33) as u8
                })
                .collect();
            let image = Layout::tight(size, count, Storage::U8).read(&texels).unwrap();
            let half = halve(&super::bytes(size, count, &texels).unwrap()).unwrap();
            let half_size = size.map(|side| (side / 2).max(1));
            prop_assert_eq!(half.size().map(|side| side as usize), half_size);
            let scaled = scale(&image, half_size, Storage::U8);
            let expected: Vec<u8> = scaled.values.iter().map(|&value| value as u8).collect();
            prop_assert_eq!(convert::texels(&half), &expected[..]);
        }

        #[test]
        fn a_flat_image_stays_flat(value: u8, w in 1usize..20, h in 1usize..20, nw in 1usize..20, nh in 1usize..20) {
            let scaled = scale(&bytes(w, h, &vec![value; w * h]), [nw, nh, 1], Storage::U8);
            prop_assert!(scaled.values.iter().all(|&v| v == f64::from(value)));
        }
    }
}
