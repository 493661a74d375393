//! GLU's box filter: each new pixel is the mean of the area it covers in the old image.
//!
//! The weights are whole numbers (an edge of the old image's pixel is `new size` long, one of the
//! new image's `old size`), so that the mean of integers is exact before it is rounded once, halves
//! up. libGLU truncates where it rescales or halves a side of one pixel: its last bit differs there.

use super::pixels::{Components, Storage};

/// `image` at another size, in steps of `storage`.
///
/// Halving an even side is the mean of two pixels; a side that keeps its length keeps its pixels.
pub fn scale(image: &Components, size: [usize; 3], storage: Storage) -> Components {
    let Components { size: old, count, .. } = *image;
    let [width, height, depth] = size;
    let volume = old.iter().map(|side| *side as f64).product::<f64>();
    let columns: Vec<_> = (0..width).map(|x| covered(x, old[0], width)).collect();
    let pitch = old[0] * count;
    let mut row = vec![0.0; pitch];
    let mut values = Vec::with_capacity(size.iter().product::<usize>() * count);
    for z in 0..depth {
        for y in 0..height {
            row.fill(0.0);
            for (old_z, inward) in covered(z, old[2], depth) {
                for (old_y, down) in covered(y, old[1], height) {
                    let texels = &image.values[(old_z * old[1] + old_y) * pitch..][..pitch];
                    let weight = inward * down;
                    row.iter_mut().zip(texels).for_each(|(sum, value)| *sum += weight * value);
                }
            }
            for column in &columns {
                for component in 0..count {
                    let sum: f64 = column
                        .clone()
                        .map(|(old_x, weight)| weight * row[old_x * count + component])
                        .sum();
                    values.push(storage.round(component, sum / volume));
                }
            }
        }
    }
    Components { size, count, values }
}

/// The old pixels that new pixel `index` covers, and how much of each.
fn covered(index: usize, old: usize, new: usize) -> impl Iterator<Item = (usize, f64)> + Clone {
    let (low, high) = (index * old, (index + 1) * old);
    (low / new..high.div_ceil(new)).map(move |pixel| {
        let overlap = high.min((pixel + 1) * new) - low.max(pixel * new);
        (pixel, overlap as f64)
    })
}

#[cfg(test)]
mod tests {
    use super::super::pixels::{Layout, Storage};
    use super::*;
    use proptest::prelude::*;

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

        #[test]
        fn a_flat_image_stays_flat(value: u8, w in 1usize..20, h in 1usize..20, nw in 1usize..20, nh in 1usize..20) {
            let scaled = scale(&bytes(w, h, &vec![value; w * h]), [nw, nh, 1], Storage::U8);
            prop_assert!(scaled.values.iter().all(|&v| v == f64::from(value)));
        }
    }
}
