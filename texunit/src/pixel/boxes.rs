//! Images of numbers at another size: each new pixel is the mean of the area that it covers of the old image.
//!
//! Weights are whole numbers (an edge of an old pixel is as long as the new side has pixels, one of a new pixel as
//! long as the old side has), so that the mean of integers is exact before it is rounded once.

use super::{NumberTransform, PixelLayout};
use crate::lanes::{F64s, Isa, Kernel, LANES, Simd};

/// What each new pixel of a side covers of the old ones.
#[derive(Clone, Debug)]
struct AxisCoverage {
    /// The first old pixel, and where its weights begin.
    firsts: Vec<(usize, usize)>,
    weights: Vec<f64>,
}

impl AxisCoverage {
    fn new(old: usize, new: usize) -> Self {
        let mut covers = Self { firsts: Vec::with_capacity(new), weights: Vec::new() };
        for index in 0..new {
            let (low, high) = (index * old, (index + 1) * old);
            let first = low / new;
            covers.firsts.push((first, covers.weights.len()));
            covers.weights.extend((first..high.div_ceil(new)).map(|pixel| {
                let overlap = high.min((pixel + 1) * new) - low.max(pixel * new);
                overlap as f64
            }));
        }
        covers
    }

    /// The first old pixel that a new one covers, and the weights from there on.
    #[inline(always)]
    fn of(&self, index: usize) -> (usize, &[f64]) {
        let (first, begin) = self.firsts[index];
        let end = self.firsts.get(index + 1).map_or(self.weights.len(), |next| next.1);
        (first, &self.weights[begin..end])
    }
}

/// The numbers of the pixels of a row, one to four of each: a plane for the first ones, another for the second.
pub type Planes = [Vec<f64>; 4];

fn planes(width: usize, count: usize) -> Planes {
    [0, 1, 2, 3].map(|number| vec![0.0; if number < count { width } else { 0 }])
}

/// Makes an image of one size, width, height and depth, one of another. Its pixels have `count` numbers. `read` gives
/// row y of slice z of the old image, `write` takes the rows of the new one from first to last.
pub fn scale(
    isa: Isa,
    [old, new]: [[usize; 3]; 2],
    count: usize,
    mut read: impl FnMut([usize; 2], &mut Planes),
    mut write: impl FnMut(&Planes),
) {
    let covers = |axis: usize| AxisCoverage::new(old[axis], new[axis]);
    let (columns, rows, slices) = (covers(0), covers(1), covers(2));
    let volume = old.iter().map(|&side| side as f64).product::<f64>();
    let (mut from, mut row) = (planes(old[0], count), planes(new[0], count));
    let mut sums = from.clone();
    for z in 0..new[2] {
        for y in 0..new[1] {
            sums.iter_mut().for_each(|sums| sums.fill(0.0));
            let (first_slice, inward) = slices.of(z);
            let (first_row, down) = rows.of(y);
            for (z, inward) in (first_slice..).zip(inward) {
                for (y, down) in (first_row..).zip(down) {
                    read([y, z], &mut from);
                    for (numbers, sums) in from.iter().zip(&mut sums) {
                        super::add(isa, inward * down, numbers, sums);
                    }
                }
            }
            for (sums, row) in sums.iter().zip(&mut row) {
                isa.run(AverageRow { columns: &columns, sums, volume, row });
            }
            write(&row);
        }
    }
}

/// The means of what the columns cover.
struct AverageRow<'a> {
    columns: &'a AxisCoverage,
    sums: &'a [f64],
    volume: f64,
    row: &'a mut [f64],
}

impl Kernel for AverageRow<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { columns, sums, volume, row } = self;
        if sums.len() == 2 * row.len() {
            // Of halves, two columns each of the same weight.
            let weight = row.len() as f64;
            for (out, pair) in row.iter_mut().zip(sums.chunks_exact(2)) {
                *out = weight * pair[0] + weight * pair[1];
            }
        } else {
            for (index, out) in row.iter_mut().enumerate() {
                let (first, weights) = columns.of(index);
                // As a sum that begins with the first: what is -0 stays.
                let mut sum = -0.0;
                for (number, weight) in sums[first..].iter().zip(weights) {
                    sum += weight * number;
                }
                *out = sum;
            }
        }
        for out in row {
            *out /= volume;
        }
    }
}

/// The numbers of pixels, those that the record has.
pub fn read_row(isa: Isa, record: &PixelLayout, bytes: &[u8], row: &mut Planes) {
    let mut numbers = [F64s::ZERO; 4];
    for (run, bytes) in bytes.chunks(LANES * record.bytes()).enumerate() {
        super::read(isa, record, bytes, &mut numbers);
        for (plane, numbers) in row.iter_mut().zip(&numbers).take(record.fields().len()) {
            let out = &mut plane[run * LANES..];
            let count = out.len().min(LANES);
            out[..count].copy_from_slice(&numbers.0[..count]);
        }
    }
}

/// Pixels of these numbers, each with all of these done to it, in their order.
pub fn write_row(
    isa: Isa,
    record: &PixelLayout,
    changes: &[[NumberTransform; 4]],
    row: &Planes,
    bytes: &mut [u8],
) {
    let mut numbers = [F64s::ZERO; 4];
    for (run, bytes) in bytes.chunks_mut(LANES * record.bytes()).enumerate() {
        for (number, (plane, numbers)) in row.iter().zip(&mut numbers).enumerate() {
            let from = plane.get(run * LANES..).unwrap_or_default();
            let count = from.len().min(LANES);
            numbers.0[..count].copy_from_slice(&from[..count]);
            for changes in changes {
                let before = *numbers;
                super::transform(isa, changes[number], &before, numbers);
            }
        }
        super::write(isa, record, numbers.each_ref(), bytes);
    }
}
