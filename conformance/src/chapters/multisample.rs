//! Four samples a pixel: coverage from alpha and values, edges of lines and points, depth, and resolves.

use super::pictures::{
    Brush, Pictures, Pixel, all, cover, point_between_ties, random_colors, window,
};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::format::{Base, Encoding, stored};
use crate::oracle::line::Segment;
use crate::oracle::point::faded;
use crate::oracle::polygon::{inside_convex, slopes};
use crate::oracle::samples::{SAMPLES, sample_position};
use crate::probe::{ProbeError, Stages};
use crate::rng::Rng;
use gl_api::constants::*;

/// Coverage from alpha.
pub const ALPHA_TO_COVERAGE: Check = Check {
    name: "alpha-to-coverage",
    citation: "GL 2.1, 4.1.3: coverage from alpha, 1 for all samples, 0 for none; GL_SAMPLE_ALPHA_TO_ONE",
    what: "samples that every pixel of random alphas is drawn to, and the alpha that they keep",
    unit: Unit::FullScale,
    tolerance: 0.2501,
    why: "four samples: the share of those that are drawn is off by up to a quarter, however it is rounded",
    run: alpha_to_coverage,
};

/// Coverage from a value.
pub const COVERAGE: Check = Check {
    name: "sample-coverage",
    citation: "GL 2.1, 4.1.3: GL_SAMPLE_COVERAGE_VALUE, GL_SAMPLE_COVERAGE_INVERT: the complement",
    what: "samples of every pixel that quarters leave, and their complements",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "quarters are whole samples",
    run: sample_coverage,
};

/// Resolves in every format.
pub const RESOLVE: Check = Check {
    name: "resolve-formats",
    citation: "GL 3.0, 4.3.2: glBlitFramebuffer from 4 samples to one: their mean",
    what: "every pixel of random colours of each sample in ten formats",
    unit: Unit::Codes,
    tolerance: 1.0 + 1.0 / (1 << 7) as f64,
    why: "in halves of the format's step about the exact mean of stored codes: the nearest code; the sum in f32 and its product with the largest code, below 2^16, are rounded by 2^-9 each",
    run: resolve,
};

/// Depth of samples.
pub const DEPTH: Check = Check {
    name: "sample-depth",
    citation: "GL 2.1, 3.2.1 and 4.1.6: each sample has a depth of its own, that of the plane at its place",
    what: "samples of every pixel along the line where two tilted planes meet",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "a sample shows the one or the other; those within 2^-17 of both are left out",
    run: depth,
};

/// Lines of samples.
pub const LINES: Check = Check {
    name: "sample-lines",
    citation: "GL 2.1, 3.4.4: samples in the rectangle of an antialiased line",
    what: "samples of every pixel of random lines of widths 0.5 to 8",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "a sample is covered or not; places within 1/128 of an edge are left out",
    run: lines,
};

/// Points of samples.
pub const POINTS: Check = Check {
    name: "sample-points",
    citation: "GL 2.1, 3.3.3: samples in the circle of an antialiased point",
    what: "samples of every pixel of random points of sizes 1 to 20",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "a sample is covered or not; places within 1/128 of the circle are left out",
    run: points,
};

/// Points that fade.
pub const FADE: Check = Check {
    name: "point-fade",
    citation: "GL 2.1, 3.3 and 3.13: alpha · (derived size / GL_POINT_FADE_THRESHOLD_SIZE)² below the threshold",
    what: "samples and alpha of every pixel of points of sizes 0.2 to 12, by the state, attenuated, and by a program",
    unit: Unit::FullScale,
    tolerance: 2.25 / (1 << 24) as f64,
    why: "f32: nine roundings by 2^-25 (sums and products of the attenuation, root, quotients, square, product) of 3/4: twice the root of the sum of their squares",
    run: fade,
};

const PICTURE: Pixel = [43, 31];

fn at([x, y]: Pixel) -> usize {
    y * PICTURE[0] + x
}

/// The share of samples for which something holds; `None` if it is open for one.
fn share(pixel: Pixel, variant: Variant, holds: impl Fn([f64; 2]) -> Option<bool>) -> Option<f64> {
    let mut count = 0;
    for sample in 0..SAMPLES {
        count += usize::from(holds(sample_position(pixel, sample, variant))?);
    }
    Some(count as f64 / SAMPLES as f64)
}

fn alpha_to_coverage(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("alpha-to-coverage");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(32) {
        let mut colors = random_colors(&mut rng, PICTURE, [0.0, 1.0]);
        for (k, color) in colors.iter_mut().enumerate() {
            color[3] = [0.0, 1.0, color[3], color[3]][k % 4];
        }
        let to_one = round % 2 == 0;
        let expect = |pixel: Pixel, variant: Variant| {
            let alpha = f64::from(colors[at(pixel)][3]);
            let share = if variant.has(Mutation::AlphaInverted) { 1.0 - alpha } else { alpha };
            // Red counts samples.
            let kept = if to_one && !variant.has(Mutation::AlphaKept) { 1.0 } else { alpha };
            Some([share, 0.0, 0.0, kept])
        };
        pictures.compare(&to_one, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 4)?;
            window(PICTURE);
            glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
            if to_one {
                glEnable(GL_SAMPLE_ALPHA_TO_ONE);
            }
            let reds: Vec<[f32; 4]> = colors.iter().map(|c| [1.0, 0.0, 0.0, c[3]]).collect();
            Brush::Texture.paint(PICTURE, &reds);
            let picture = session.read_resolved(GL_RGBA32F, PICTURE)?;
            // The alpha of samples that are drawn; where none is, nothing is kept.
            let kept = |(c, color): (&[f64; 4], &[f32; 4])| {
                let alpha = f64::from(color[3]);
                // 0 and 1 are exact, so they must be none and all.
                let exact = (alpha == 0.0 || alpha == 1.0) && c[0] != alpha;
                let none = if to_one { 1.0 } else { alpha };
                let kept = if c[0] > 0.0 { c[3] / c[0] } else { none };
                [if exact { 1e9 } else { c[0] }, 0.0, 0.0, kept]
            };
            Ok(picture.iter().zip(&colors).map(kept).collect())
        })?;
    }
    pictures.finish(100, 70);
    Ok(())
}

fn sample_coverage(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for quarters in 0..=4u32 {
        let value = f64::from(quarters) / 4.0;
        let expect = |_: Pixel, variant: Variant| {
            let rest = if variant.has(Mutation::CoverageNotInverted) { value } else { 1.0 - value };
            // Both write blue, so that no sample may have both.
            Some([value, rest, 1.0, 0.0])
        };
        pictures.compare(&value, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 4)?;
            window(PICTURE);
            glEnable(GL_SAMPLE_COVERAGE);
            for invert in [false, true] {
                glSampleCoverage(value, invert);
                glColorMask(!invert, invert, true, true);
                glColor4f(1, 1, 1, 0);
                cover(PICTURE, 0.5);
            }
            session.read_resolved(GL_RGBA32F, PICTURE)
        })?;
    }
    pictures.finish(100, 90);
    Ok(())
}

fn resolve(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("resolve-formats");
    let formats = [
        (GL_RGBA8, Base::Rgba, Encoding::Unorm([8; 4])),
        (GL_R8, Base::Red, Encoding::Unorm([8; 4])),
        (GL_RG8, Base::Rg, Encoding::Unorm([8; 4])),
        (GL_RGB565, Base::Rgb, Encoding::Unorm([5, 6, 5, 0])),
        (GL_RGBA4, Base::Rgba, Encoding::Unorm([4; 4])),
        (GL_RGB10_A2, Base::Rgba, Encoding::Unorm([10, 10, 10, 2])),
        (GL_RGBA16, Base::Rgba, Encoding::Unorm([16; 4])),
        (GL_RGBA8_SNORM, Base::Rgba, Encoding::Snorm(8)),
        (GL_RGBA16F, Base::Rgba, Encoding::Half),
        (GL_RGBA32F, Base::Rgba, Encoding::Single),
    ];
    for round in 0..harness.cases(40).max(formats.len()) {
        let (internal, base, encoding) = formats[round % formats.len()];
        let low = if matches!(encoding, Encoding::Unorm(_)) { 0.0 } else { -1.0 };
        // Numbers that the format has, so that no sample is on a tie.
        let colors: Vec<Vec<[f32; 4]>> = (0..SAMPLES)
            .map(|_| {
                let colors = random_colors(&mut rng, PICTURE, [low, 1.0]);
                let kept = |color: [f32; 4]| {
                    let codes = stored(base, encoding, color.map(f64::from), Variant::CORRECT);
                    base.queried(codes, Variant::CORRECT).map(|c| c as f32)
                };
                colors.into_iter().map(kept).collect()
            })
            .collect();
        let pixels: Vec<Pixel> = all(PICTURE).collect();
        let expect = |pixel: &Pixel, variant: Variant| {
            let samples = [0, 1, 2, 3].map(|sample: usize| {
                let color = colors[sample][at(*pixel)].map(f64::from);
                let codes = stored(base, encoding, color, Variant::CORRECT);
                base.queried(codes, Variant::CORRECT)
            });
            crate::oracle::samples::resolved(samples, variant)
        };
        let half = |channel: usize, x: f64| match encoding {
            Encoding::Unorm(bits) => 0.5 / f64::from((1u32 << bits[channel].max(1)) - 1),
            Encoding::Snorm(bits) => 0.5 / f64::from((1u32 << (bits - 1)) - 1),
            Encoding::Half => 2f64.powi((x.abs().log2().floor() as i32).max(-14) - 11),
            Encoding::Single
            | Encoding::Srgb
            | Encoding::PackedFloat
            | Encoding::SharedExponent
            | Encoding::Integer(..) => 2f64.powi(-23),
        };
        let error = |_: &Pixel, a: [f64; 4], b: [f64; 4]| {
            (0..4).map(|i| (a[i] - b[i]).abs() / half(i, a[i])).fold(0.0, f64::max)
        };
        let scene = enum_name(internal);
        harness.compare_by(tally, &scene, &pixels, expect, error, |session| {
            session.frame(internal, PICTURE, 4)?;
            window(PICTURE);
            glDisable(GL_DITHER);
            glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
            glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
            glEnable(GL_SAMPLE_MASK);
            for (sample, colors) in colors.iter().enumerate() {
                glSampleMaski(0, 1u32 << sample);
                Brush::Texture.paint(PICTURE, colors);
            }
            session.read_resolved(internal, PICTURE)
        })?;
    }
    Ok(())
}

fn depth(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("sample-depth");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(32) {
        let [w, h] = PICTURE.map(|n| n as f64);
        let planes: [[f64; 3]; 2] =
            std::array::from_fn(|_| std::array::from_fn(|_| f64::from(rng.real(0.3, 0.6))));
        let height = |[a, b, c]: [f64; 3], [x, y]: [f64; 2]| {
            let [dx, dy] = slopes([[0.0, 0.0, a], [w, 0.0, b], [0.0, h, c]]);
            a + dx * x + dy * y
        };
        let expect = |pixel: Pixel, variant: Variant| {
            let second = share(pixel, variant, |place| {
                let difference = height(planes[1], place) - height(planes[0], place);
                (difference.abs() > 2f64.powi(-17)).then_some(difference < 0.0)
            })?;
            Some([1.0 - second, second, 0.0, 0.0])
        };
        pictures.compare(&planes, expect, |session| {
            session.deep_frame(GL_RGBA32F, GL_DEPTH_COMPONENT24, PICTURE, 4)?;
            window(PICTURE);
            glEnable(GL_DEPTH_TEST);
            for (number, plane) in planes.into_iter().enumerate() {
                glColor4f([1, 0][number], [0, 1][number], 0, 0);
                glBegin(GL_TRIANGLE_STRIP);
                for place in [[0.0, 0.0], [w, 0.0], [0.0, h], [w, h]] {
                    glVertex3d(place[0], place[1], height(plane, place));
                }
                glEnd();
            }
            session.read_resolved(GL_RGBA32F, PICTURE)
        })?;
    }
    pictures.finish(95, 90);
    Ok(())
}

fn lines(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("sample-lines");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(64) {
        let line = Segment {
            from: point_between_ties(&mut rng, PICTURE),
            to: point_between_ties(&mut rng, PICTURE),
        };
        let width = rng.dyadic(0.5, 8.0, 0.125);
        let expect = |pixel: Pixel, variant: Variant| {
            let corners = line.rectangle(f64::from(width), variant);
            let share = share(pixel, variant, |place| inside_convex(&corners, place, 1.0 / 128.0))?;
            Some([share, 0.0, 0.0, 0.0])
        };
        pictures.compare(&(line, width), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 4)?;
            window(PICTURE);
            glLineWidth(width);
            glColor4f(1, 0, 0, 0);
            glBegin(GL_LINES);
            glVertex2f(line.from[0] as f32, line.from[1] as f32);
            glVertex2f(line.to[0] as f32, line.to[1] as f32);
            glEnd();
            session.read_resolved(GL_RGBA32F, PICTURE)
        })?;
    }
    pictures.finish(90, 1);
    Ok(())
}

fn points(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("sample-points");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(64) {
        let (centre, size) =
            (point_between_ties(&mut rng, PICTURE), f64::from(rng.dyadic(1.0, 20.0, 0.125)));
        let expect = |pixel: Pixel, variant: Variant| {
            let radius = size / if variant.has(Mutation::DiameterIsRadius) { 1.0 } else { 2.0 };
            let share = share(pixel, variant, |[x, y]| {
                let far = (x - centre[0]).hypot(y - centre[1]) - radius;
                (far.abs() > 1.0 / 128.0).then_some(far < 0.0)
            })?;
            Some([share, 0.0, 0.0, 0.0])
        };
        pictures.compare(&(centre, size), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 4)?;
            window(PICTURE);
            glPointSize(size as f32);
            glColor4f(1, 0, 0, 0);
            glBegin(GL_POINTS);
            glVertex2f(centre[0] as f32, centre[1] as f32);
            glEnd();
            session.read_resolved(GL_RGBA32F, PICTURE)
        })?;
    }
    pictures.finish(90, 1);
    Ok(())
}

/// Where points have their sizes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SizeFrom {
    State,
    Attenuation,
    Program,
}

fn fade(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("point-fade");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    let mut faded_points = 0;
    for round in 0..harness.cases(48).max(12) {
        let from = [SizeFrom::State, SizeFrom::Attenuation, SizeFrom::Program][round % 3];
        let centre = point_between_ties(&mut rng, PICTURE);
        let (size, threshold) = (rng.real(0.2, 12.0), rng.real(1.0, 10.0));
        let factor = if from == SizeFrom::Attenuation { rng.real(0.2, 8.0) } else { 1.0 };
        let derived = f64::from(size) * (1.0 / f64::from(factor)).sqrt();
        faded_points += usize::from(derived < f64::from(threshold));
        let expect = |pixel: Pixel, variant: Variant| {
            let [width, fade] = faded(derived, f64::from(threshold), variant);
            let share = share(pixel, variant, |[x, y]| {
                let far = (x - centre[0]).hypot(y - centre[1]) - width.max(1.0) / 2.0;
                (far.abs() > 1.0 / 128.0).then_some(far < 0.0)
            })?;
            Some([share, 0.0, 0.0, 0.75 * fade * share])
        };
        pictures.compare(&(from, centre, size, factor, threshold), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 4)?;
            window(PICTURE);
            glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, threshold);
            glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, &[factor, 0.0, 0.0]);
            if from == SizeFrom::Program {
                glEnable(GL_VERTEX_PROGRAM_POINT_SIZE);
                let vertex = "void main() {
                    gl_Position = ftransform(); gl_PointSize = gl_MultiTexCoord0.x; }";
                let fragment = "void main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 0.75); }";
                session.stages(&Stages { vertex, geometry: "", fragment })?;
                glPointSize(1);
            } else {
                glPointSize(size);
            }
            glColor4f(1, 0, 0, 0.75);
            glBegin(GL_POINTS);
            glTexCoord1f(size);
            glVertex2f(centre[0] as f32, centre[1] as f32);
            glEnd();
            session.read_resolved(GL_RGBA32F, PICTURE)
        })?;
    }
    pictures.finish(90, 1);
    tally.reach("points that fade", faded_points, 4);
    Ok(())
}
