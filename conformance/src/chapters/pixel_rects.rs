//! Pixel rectangles: where they land, zoom, transfer and maps, copies.

use super::pictures::{Brush, Pictures, Pixel, all, random_colors, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::blit::zoomed;
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Zoomed rectangles.
pub const ZOOM: Check = Check {
    name: "pixel-zoom",
    citation: "GL 2.1, 3.6.4: the rectangles of groups under glPixelZoom",
    what: "every pixel of random rectangles under zooms from -5 to 5, fractions too",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "floats are copied; places near the edge of a group are left out",
    run: |harness, tally| zoom(harness, tally, From::Memory),
};

/// Copied rectangles.
pub const COPY: Check = Check {
    name: "copy-pixels",
    citation: "GL 2.1, 4.3.3 and 3.6.4: glCopyPixels of colours, with zoom",
    what: "every pixel of copies of random rectangles, overlapping ones too, under zooms from -5 to 5",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "floats are copied; places near the edge of a group are left out",
    run: |harness, tally| zoom(harness, tally, From::Framebuffer),
};

/// Scale, bias and maps.
pub const MAPS: Check = Check {
    name: "pixel-maps",
    citation: "GL 2.1, 3.6.3 and 3.6.5: scale and bias, clamp, then the map's element round(c · (size − 1))",
    what: "every pixel of random colours through four random maps of 2 to 256 elements each",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "an element of the map; colours near the tie of two elements are left out",
    run: maps,
};

/// Colour indices.
pub const INDICES: Check = Check {
    name: "pixel-indices",
    citation: "GL 2.1, 3.6.3 to 3.6.5: shift, offset, GL_PIXEL_MAP_I_TO_R and its relatives",
    what: "every pixel of random colour indices, shifted left and right, through four maps",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "an element of the map",
    run: indices,
};

/// Drawn depths and stencil values.
pub const DEPTH_STENCIL: Check = Check {
    name: "draw-pixels-depth-stencil",
    citation: "GL 2.1, 3.6.3 and 3.6.5: GL_DEPTH_SCALE and _BIAS; shift, offset and GL_PIXEL_MAP_S_TO_S",
    what: "depth and stencil of every pixel after glDrawPixels of random ones",
    unit: Unit::FullScale,
    tolerance: 1.5 / (1 << 24) as f64,
    why: "half a step of 24 bits, as much of f32 in the product and in what is read; stencil values are integers",
    run: depth_stencil,
};

/// Luminance that is read.
pub const READ_LUMINANCE: Check = Check {
    name: "read-luminance",
    citation: "GL 2.1, 4.3.2: L = R + G + B, after scale and bias",
    what: "every pixel of random colours read as luminance and alpha, scaled, clamped to [0, 1]",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 24) as f64,
    why: "f32: sums up to 1 are rounded by 2^-25, twice",
    run: read_luminance,
};

const PICTURE: Pixel = [47, 39];

fn at([x, y]: Pixel) -> usize {
    y * PICTURE[0] + x
}

/// Where a rectangle comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum From {
    Memory,
    Framebuffer,
}

fn zoom(harness: &Harness, tally: &mut Tally, from: From) -> Result<(), ProbeError> {
    let mut rng = Rng::named("pixel-zoom");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(64).max(16) {
        let size = [rng.integer(1, 13) as usize, rng.integer(1, 11) as usize];
        let corner = [rng.integer(0, 30) as usize, rng.integer(0, 26) as usize];
        let raster = [rng.dyadic(5.0, 40.0, 0.125), rng.dyadic(5.0, 30.0, 0.125)];
        let zoom = [0; 2]
            .map(|_: i32| rng.pick(&[1.0, 1.0, -1.0, 2.0, 0.5, -1.5, 3.25, -5.0, 5.0, 0.375]));
        let under = random_colors(&mut rng, PICTURE, [0.0, 1.0]);
        let colors = random_colors(&mut rng, size, [0.0, 1.0]);
        let group = |[n, m]: [usize; 2]| match from {
            From::Memory => colors[m * size[0] + n],
            From::Framebuffer => under[at([corner[0] + n, corner[1] + m])],
        };
        let expect = |pixel: Pixel, variant: Variant| {
            let mut place = [0usize; 2];
            for i in 0..2 {
                let of = zoomed(f64::from(raster[i]), zoom[i], pixel[i], variant)?;
                if !(0..size[i] as i64).contains(&of) {
                    return Some(under[at(pixel)].map(f64::from));
                }
                place[i] = of as usize;
            }
            Some(group(place).map(f64::from))
        };
        pictures.compare(&(size, raster, zoom), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            Brush::Texture.paint(PICTURE, &under);
            glWindowPos2f(raster[0], raster[1]);
            glPixelZoom(zoom[0], zoom[1]);
            let [w, h] = size;
            match from {
                From::Memory => {
                    glDrawPixels(w, h, GL_RGBA, GL_FLOAT, colors.as_flattened());
                }
                From::Framebuffer => {
                    glCopyPixels(corner[0] as i32, corner[1] as i32, w, h, GL_COLOR);
                }
            }
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(70, 60);
    Ok(())
}

/// A map's elements.
fn map(rng: &mut Rng) -> Vec<f32> {
    let size = 1usize << rng.integer(1, 8);
    (0..size).map(|_| rng.real(0.0, 1.0)).collect()
}

fn maps(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("pixel-maps");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(32) {
        let maps = [0; 4].map(|_: i32| map(&mut rng));
        let (scale, bias) =
            ([0; 4].map(|_: i32| rng.real(-1.5, 1.5)), [0; 4].map(|_: i32| rng.real(-0.5, 1.0)));
        let colors = random_colors(&mut rng, PICTURE, [0.0, 1.0]);
        let expect = |pixel: Pixel, variant: Variant| {
            let mut mapped = [0.0; 4];
            for i in 0..4 {
                let [c, scale, bias] = [colors[at(pixel)][i], scale[i], bias[i]].map(f64::from);
                let c = if variant.has(Mutation::BiasBeforeScale) {
                    ((c + bias) * scale).clamp(0.0, 1.0)
                } else {
                    (c * scale + bias).clamp(0.0, 1.0)
                };
                let index = c * (maps[i].len() - 1) as f64;
                if (index.fract() - 0.5).abs() < 1e-3 {
                    return None;
                }
                let index =
                    if variant.has(Mutation::MapTruncates) { index.floor() } else { index.round() };
                mapped[i] = f64::from(maps[i][index as usize]);
            }
            Some(mapped)
        };
        pictures.compare(&(scale, bias), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            let names = [
                (GL_RED_SCALE, GL_RED_BIAS, GL_PIXEL_MAP_R_TO_R),
                (GL_GREEN_SCALE, GL_GREEN_BIAS, GL_PIXEL_MAP_G_TO_G),
                (GL_BLUE_SCALE, GL_BLUE_BIAS, GL_PIXEL_MAP_B_TO_B),
                (GL_ALPHA_SCALE, GL_ALPHA_BIAS, GL_PIXEL_MAP_A_TO_A),
            ];
            for (i, (scaled, biased, mapped)) in names.into_iter().enumerate() {
                glPixelTransferf(scaled, scale[i]);
                glPixelTransferf(biased, bias[i]);
                glPixelMapfv(mapped, maps[i].len(), &maps[i]);
            }
            glPixelTransferi(GL_MAP_COLOR, 1);
            glWindowPos2i(0, 0);
            let [w, h] = PICTURE;
            glDrawPixels(w, h, GL_RGBA, GL_FLOAT, colors.as_flattened());
            // What is read passes the transfer, too.
            glPixelTransferi(GL_MAP_COLOR, 0);
            for (scaled, biased, _) in names {
                glPixelTransferf(scaled, 1);
                glPixelTransferf(biased, 0);
            }
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(95, 80);
    Ok(())
}

fn indices(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("pixel-indices");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(32) {
        let maps = [0; 4].map(|_: i32| map(&mut rng));
        let (shift, offset) = (rng.integer(-4, 4), rng.integer(-20, 20));
        let codes: Vec<u8> = (0..PICTURE[0] * PICTURE[1]).map(|_| rng.byte()).collect();
        let expect = |pixel: Pixel, variant: Variant| {
            let code = i64::from(codes[at(pixel)]);
            let shifted = if variant.has(Mutation::IndexShiftReversed) == (shift >= 0) {
                code >> shift.abs()
            } else {
                code << shift.abs()
            };
            let index = shifted + offset;
            Some([0, 1, 2, 3].map(|i: usize| {
                // Sizes are powers of two: the low bits count.
                f64::from(maps[i][(index & (maps[i].len() as i64 - 1)) as usize])
            }))
        };
        pictures.compare(&(shift, offset), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            let names = [
                GL_PIXEL_MAP_I_TO_R,
                GL_PIXEL_MAP_I_TO_G,
                GL_PIXEL_MAP_I_TO_B,
                GL_PIXEL_MAP_I_TO_A,
            ];
            for (map, name) in maps.iter().zip(names) {
                glPixelMapfv(name, map.len(), map);
            }
            glPixelTransferi(GL_INDEX_SHIFT, shift as i32);
            glPixelTransferi(GL_INDEX_OFFSET, offset as i32);
            glWindowPos2i(0, 0);
            glDrawPixels(PICTURE[0], PICTURE[1], GL_COLOR_INDEX, GL_UNSIGNED_BYTE, &codes);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 80);
    Ok(())
}

fn depth_stencil(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("draw-pixels-depth-stencil");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(32) {
        let (scale, bias) = (rng.real(-1.0, 1.5), rng.real(-0.25, 0.75));
        let (shift, offset, write) = (rng.integer(-3, 3), rng.integer(-9, 9), rng.byte());
        let map: Vec<u32> = (0..64).map(|_| u32::from(rng.byte())).collect();
        let depths: Vec<f32> = all(PICTURE).map(|_| rng.real(0.0, 1.0)).collect();
        let values: Vec<u8> = all(PICTURE).map(|_| rng.byte()).collect();
        let expect = |pixel: Pixel, variant: Variant| {
            let [z, scale, bias] = [depths[at(pixel)], scale, bias].map(f64::from);
            let z = if variant.has(Mutation::BiasBeforeScale) {
                (z + bias) * scale
            } else {
                z * scale + bias
            };
            let value = i64::from(values[at(pixel)]);
            let reversed = variant.has(Mutation::IndexShiftReversed);
            let moved =
                if (shift >= 0) != reversed { value << shift.abs() } else { value >> shift.abs() };
            let mapped = map[((moved + offset) & 63) as usize] as u8;
            Some([z.clamp(0.0, 1.0), f64::from(mapped & write), 0.0, 0.0])
        };
        pictures.compare(&(scale, bias, shift, offset), expect, |session| {
            session.deep_frame(GL_RGBA8, GL_DEPTH24_STENCIL8, PICTURE, 0)?;
            glClearStencil(0);
            glClear(GL_STENCIL_BUFFER_BIT);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_ALWAYS);
            glStencilMask(write);
            glWindowPos2i(0, 0);
            let [w, h] = PICTURE;
            glPixelTransferf(GL_DEPTH_SCALE, scale);
            glPixelTransferf(GL_DEPTH_BIAS, bias);
            glDrawPixels(w, h, GL_DEPTH_COMPONENT, GL_FLOAT, &depths);
            glPixelTransferf(GL_DEPTH_SCALE, 1);
            glPixelTransferf(GL_DEPTH_BIAS, 0);
            glPixelTransferi(GL_INDEX_SHIFT, shift as i32);
            glPixelTransferi(GL_INDEX_OFFSET, offset as i32);
            glPixelTransferi(GL_MAP_STENCIL, 1);
            glPixelMapuiv(GL_PIXEL_MAP_S_TO_S, map.len(), &map);
            glDrawPixels(w, h, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &values);
            glPixelTransferi(GL_INDEX_SHIFT, 0);
            glPixelTransferi(GL_INDEX_OFFSET, 0);
            glPixelTransferi(GL_MAP_STENCIL, 0);
            let mut depths = session.read_depths(PICTURE)?;
            for (depth, stencil) in depths.iter_mut().zip(session.read_stencil(PICTURE)?) {
                depth[1] = stencil[0];
            }
            Ok(depths)
        })?;
    }
    pictures.finish(100, 80);
    Ok(())
}

fn read_luminance(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("read-luminance");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(32) {
        let scale = [0; 4].map(|_: i32| rng.real(0.0, 0.8));
        let bias = [0; 4].map(|_: i32| rng.real(-0.2, 0.2));
        let colors = random_colors(&mut rng, PICTURE, [0.0, 1.0]);
        let expect = |pixel: Pixel, variant: Variant| {
            let c: [f64; 4] = std::array::from_fn(|i| {
                f64::from(colors[at(pixel)][i]) * f64::from(scale[i]) + f64::from(bias[i])
            });
            let luminance =
                if variant.has(Mutation::LuminanceIsRed) { c[0] } else { c[0] + c[1] + c[2] };
            Some([luminance, c[3], 0.0, 0.0].map(|c| c.clamp(0.0, 1.0)))
        };
        pictures.compare(&(scale, bias), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            Brush::of(round).paint(PICTURE, &colors);
            glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE);
            let names = [
                (GL_RED_SCALE, GL_RED_BIAS),
                (GL_GREEN_SCALE, GL_GREEN_BIAS),
                (GL_BLUE_SCALE, GL_BLUE_BIAS),
                (GL_ALPHA_SCALE, GL_ALPHA_BIAS),
            ];
            for (i, (scaled, biased)) in names.into_iter().enumerate() {
                glPixelTransferf(scaled, scale[i]);
                glPixelTransferf(biased, bias[i]);
            }
            let [w, h] = PICTURE;
            let mut read = vec![[0.0f32; 2]; w * h];
            let (format, ty) = (GL_LUMINANCE_ALPHA, GL_FLOAT);
            glReadPixels(0, 0, w, h, format, ty, read.as_flattened_mut());
            session.check("reading luminance")?;
            Ok(read.into_iter().map(|[l, a]| [f64::from(l), f64::from(a), 0.0, 0.0]).collect())
        })?;
    }
    pictures.finish(100, 80);
    Ok(())
}
