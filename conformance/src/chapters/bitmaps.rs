//! Bitmaps: where they land, and how their bits lie in memory.

use super::pictures::{Pictures, Pixel, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Bitmaps.
pub const BITMAP: Check = Check {
    name: "bitmap",
    citation: "GL 2.1, 3.7: fragments from floor(raster position − origin); the position moves on",
    what: "every pixel of three bitmaps after one another, of 1 to 90 columns, added and replaced, in both orders of bits, with skips and row lengths",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not",
    run: bitmap,
};

const PICTURE: Pixel = [147, 83];

/// A bitmap: its raster bits, row by row from the lowest, and where it lands.
#[derive(Clone, Debug)]
struct Bits {
    size: [usize; 2],
    bits: Vec<bool>,
    origin: [f32; 2],
    movement: [f32; 2],
    lowest_first: bool,
    skip: [usize; 2],
    row_length: usize,
}

impl Bits {
    fn random(rng: &mut Rng) -> Self {
        let widest = rng.pick(&[19, 90, 90]);
        let size = [rng.integer(1, widest) as usize, rng.integer(1, 11) as usize];
        let skip = [rng.integer(0, 9) as usize, rng.integer(0, 2) as usize];
        Self {
            size,
            bits: (0..size[0] * size[1]).map(|_| rng.integer(0, 1) == 1).collect(),
            origin: [0; 2].map(|_: i32| rng.dyadic(-3.0, 3.0, 0.25)),
            movement: [0; 2].map(|_: i32| rng.dyadic(-2.0, 14.0, 0.25)),
            lowest_first: rng.integer(0, 1) == 1,
            skip,
            row_length: rng.pick(&[0, size[0] + skip[0] + 3]),
        }
    }

    /// The bytes of the client, in rows of two bytes' alignment; other bits are set, too.
    fn memory(&self) -> Vec<u8> {
        let length = if self.row_length > 0 { self.row_length } else { self.size[0] };
        let stride = length.div_ceil(16) * 2;
        let rows = self.skip[1] + self.size[1];
        let mut bytes = vec![0xffu8; stride * rows + 4];
        for (k, bit) in self.bits.iter().enumerate() {
            let column = self.skip[0] + k % self.size[0];
            let index = (self.skip[1] + k / self.size[0]) * stride + column / 8;
            let shift = if self.lowest_first { column % 8 } else { 7 - column % 8 };
            if !bit {
                bytes[index] &= !(1 << shift);
            }
        }
        bytes
    }
}

fn bitmap(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("bitmap");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(64) {
        let blends = round % 3 != 2;
        let mut bitmaps: Vec<Bits> = (0..3).map(|_| Bits::random(&mut rng)).collect();
        // Columns that are skipped are part of a row only where its length says so.
        for of in &mut bitmaps {
            if of.row_length == 0 {
                of.skip[0] = 0;
            }
        }
        let start = [rng.dyadic(2.0, 110.0, 0.25), rng.dyadic(2.0, 60.0, 0.25)];
        let expect = |pixel: Pixel, variant: Variant| {
            let mut raster = start.map(f64::from);
            let mut times = 0.0;
            for of in &bitmaps {
                let local = [0, 1].map(|i| {
                    let origin = f64::from(of.origin[i]);
                    let corner = if variant.has(Mutation::BitmapRounded) {
                        (raster[i] - origin).round()
                    } else {
                        (raster[i] - origin).floor()
                    };
                    pixel[i] as i64 - corner as i64
                });
                if (0..2).all(|i| (0..of.size[i] as i64).contains(&local[i])) {
                    let bit = of.bits[local[1] as usize * of.size[0] + local[0] as usize];
                    times += f64::from(u8::from(bit));
                }
                if !variant.has(Mutation::RasterStays) {
                    raster = [0, 1].map(|i| raster[i] + f64::from(of.movement[i]));
                }
            }
            Some([if blends { times } else { times.min(1.0) }, 0.0, 0.0, 0.0])
        };
        pictures.compare(&(start, &bitmaps[0].origin), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            if blends {
                glEnable(GL_BLEND);
            }
            glBlendFunc(GL_ONE, GL_ONE);
            glColor4f(1, 0, 0, 0);
            glWindowPos2f(start[0], start[1]);
            glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
            for of in &bitmaps {
                glPixelStorei(GL_UNPACK_LSB_FIRST, i32::from(of.lowest_first));
                glPixelStorei(GL_UNPACK_ROW_LENGTH, of.row_length as i32);
                glPixelStorei(GL_UNPACK_SKIP_PIXELS, of.skip[0] as i32);
                glPixelStorei(GL_UNPACK_SKIP_ROWS, of.skip[1] as i32);
                let ([w, h], [x, y], [u, v]) = (of.size, of.origin, of.movement);
                glBitmap(w, h, x, y, u, v, &of.memory());
            }
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 2);
    Ok(())
}
