//! Pixel rectangles over pixels of four samples.

use super::pictures::{Brush, Pictures, Pixel, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::samples::{SAMPLES, resolved, sample_position};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Zoomed rectangles over samples.
pub const RECTS: Check = Check {
    name: "sample-pixel-rects",
    citation: "GL 2.1, 3.6.6: the samples of every pixel within the zoomed rectangle of a group have its colour",
    what: "the mean of the samples of every pixel of random rectangles under zooms from -5 to 5, fractions too",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "colours are multiples of 2^-8, whose means f32 has; samples near the edge of a group are left out",
    run,
};

const PICTURE: Pixel = [47, 39];

/// Colours of multiples of 2^-8.
fn colors(rng: &mut Rng, [width, height]: Pixel) -> Vec<[f32; 4]> {
    let mut one = || [0; 4].map(|_: i32| rng.dyadic(0.0, 1.0, 1.0 / 256.0));
    (0..width * height).map(|_| one()).collect()
}

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("sample-pixel-rects");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(64).max(16) {
        let size = [rng.integer(1, 13) as usize, rng.integer(1, 11) as usize];
        // Between the sixteenths of samples.
        let raster =
            [rng.dyadic(5.0, 40.0, 0.25), rng.dyadic(5.0, 30.0, 0.25)].map(|c| c + 1.0 / 32.0);
        let zoom = [0; 2]
            .map(|_: i32| rng.pick(&[1.0, 1.0, -1.0, 2.0, 0.5, -1.5, 3.25, -5.0, 5.0, 0.375]));
        let (under, groups) = (colors(&mut rng, PICTURE), colors(&mut rng, size));
        let expect = |pixel: Pixel, variant: Variant| {
            let below = under[pixel[1] * PICTURE[0] + pixel[0]].map(f64::from);
            let mut samples = [below; SAMPLES];
            for (sample, color) in samples.iter_mut().enumerate() {
                let at = sample_position(pixel, sample, variant);
                let mut group = [0.0; 2];
                for axis in 0..2 {
                    let zoom: f64 = if variant.has(Mutation::ZoomIsPositive) {
                        f64::abs(zoom[axis])
                    } else {
                        zoom[axis]
                    };
                    group[axis] = (at[axis] - f64::from(raster[axis])) / zoom;
                    if (group[axis] - group[axis].round()).abs() < 1e-3 {
                        return None;
                    }
                }
                let [n, m] = group.map(|group| group.floor() as i64);
                if (0..size[0] as i64).contains(&n) && (0..size[1] as i64).contains(&m) {
                    *color = groups[m as usize * size[0] + n as usize].map(f64::from);
                }
            }
            Some(resolved(samples, variant))
        };
        pictures.compare(&(size, raster, zoom), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 4)?;
            window(PICTURE);
            Brush::Texture.paint(PICTURE, &under);
            glWindowPos2f(raster[0], raster[1]);
            glPixelZoom(zoom[0], zoom[1]);
            glDrawPixels(size[0], size[1], GL_RGBA, GL_FLOAT, groups.as_flattened());
            session.read_resolved(GL_RGBA32F, PICTURE)
        })?;
    }
    pictures.finish(70, 60);
    Ok(())
}
