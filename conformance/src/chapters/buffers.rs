//! Depth and stencil buffers: what they keep, faces, masks, and what queries count.

use super::pictures::{Pictures, Pixel, all, cover, drawn, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::compare::Compare;
use crate::oracle::fragment::{Stencil, StencilOp};
use crate::oracle::painter::Rect;
use crate::oracle::polygon::slopes;
use crate::probe::{ProbeError, compare_enum, operation_enum};
use crate::rng::Rng;
use gl_api::constants::*;

/// Depth formats.
pub const DEPTH_FORMATS: Check = Check {
    name: "depth-formats",
    citation: "GL 2.1, 2.11.1 and 4.1.6: z_w = ((f − n)/2)·z_d + (n + f)/2, to the buffer's fixed-point numbers",
    what: "every pixel of tilted planes under random depth ranges, reversed ones too, in five formats",
    unit: Unit::Codes,
    tolerance: 1.0,
    why: "in half steps of the buffer plus 2^-23, for the f32 that a depth is before, scaled and moved",
    run: depth_formats,
};

/// The depth mask.
pub const DEPTH_MASK: Check = Check {
    name: "depth-mask",
    citation: "GL 2.1, 4.2.2 and 4.1.6: no depth is written by draws and clears where glDepthMask is false; none without the test",
    what: "every pixel of the depth buffer after draws and clears with masks and tests on and off",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 24) as f64,
    why: "24 bits of depth",
    run: depth_mask,
};

/// Both faces.
pub const STENCIL_FACES: Check = Check {
    name: "stencil-faces",
    citation: "GL 2.1, 4.1.5: glStencilFuncSeparate, glStencilOpSeparate, glStencilMaskSeparate",
    what: "every pixel of front and back faces, both states random: 8 functions, 8 operations in 3 places, masks",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers",
    run: stencil_faces,
};

/// The mask of clears.
pub const STENCIL_CLEAR: Check = Check {
    name: "stencil-clear",
    citation: "GL 2.1, 4.2.3 and 4.2.2: glClearStencil under glStencilMask and the scissor",
    what: "every pixel of the stencil buffer after clears under random masks and boxes",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers",
    run: stencil_clear,
};

/// Occlusion queries.
pub const QUERY: Check = Check {
    name: "occlusion-query",
    citation: "GL 2.1, 4.1.7: samples that pass the depth test; GL 3.3: whether any does",
    what: "counts of random rectangles over one another with 1 and 4 samples, under scissor, depth and stencil",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers; edges lie between pixels",
    run: query,
};

/// Conditional rendering.
pub const CONDITIONAL: Check = Check {
    name: "conditional-render",
    citation: "GL 3.0, 2.14: nothing is drawn between glBeginConditionalRender and its end if no sample passed",
    what: "every pixel of rectangles and clears that depend on hidden and on seen ones",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not",
    run: conditional,
};

const PICTURE: Pixel = [41, 33];

const DEPTHS: [(u32, i32); 5] = [
    (GL_DEPTH_COMPONENT16, 16),
    (GL_DEPTH_COMPONENT24, 24),
    (GL_DEPTH24_STENCIL8, 24),
    (GL_DEPTH_COMPONENT32F, 25),
    (GL_DEPTH32F_STENCIL8, 25),
];

fn depth_formats(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("depth-formats");
    for round in 0..harness.cases(60).max(5) {
        let (format, bits) = DEPTHS[round % 5];
        let range = [f64::from(rng.real(0.0, 1.0)), f64::from(rng.real(0.0, 1.0))];
        // Normalized device depths at three corners of the picture; the fourth is on their plane.
        let corners =
            [rng.real(-0.3, 0.3), rng.real(-0.3, 0.3), rng.real(-0.3, 0.3)].map(f64::from);
        let [w, h] = PICTURE.map(|n| n as f64);
        let [dx, dy] = slopes([[0.0, 0.0, corners[0]], [w, 0.0, corners[1]], [0.0, h, corners[2]]]);
        let pixels: Vec<Pixel> = all(PICTURE).collect();
        let expect = |&[x, y]: &Pixel, variant: Variant| {
            let z = corners[0] + dx * (x as f64 + 0.5) + dy * (y as f64 + 0.5);
            let [near, far] =
                if variant.has(Mutation::DepthRangeIgnored) { [0.0, 1.0] } else { range };
            [(far - near) / 2.0 * z + f64::midpoint(near, far), 0.0, 0.0, 0.0]
        };
        let half = 0.5 / (2f64.powi(bits) - 1.0) + 2f64.powi(-23);
        let error = |_: &Pixel, a: [f64; 4], b: [f64; 4]| (a[0] - b[0]).abs() / half;
        let scene = (enum_name(format), range);
        harness.compare_by(tally, &scene, &pixels, expect, error, |session| {
            session.deep_frame(GL_RGBA8, format, PICTURE, 0)?;
            session.depth_range(range);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_ALWAYS);
            glBegin(GL_TRIANGLE_STRIP);
            let last = corners[1] + corners[2] - corners[0];
            let places = [[-1, -1], [1, -1], [-1, 1], [1, 1]];
            for ([x, y], z) in places.into_iter().zip([corners[0], corners[1], corners[2], last]) {
                glVertex3d(f64::from(x), f64::from(y), z);
            }
            glEnd();
            let codes = session.read_depth_codes(PICTURE)?;
            Ok(codes.into_iter().map(|depth| [depth, 0.0, 0.0, 0.0]).collect())
        })?;
    }
    Ok(())
}

fn depth_mask(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("depth-mask");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(32).max(12) {
        // A clear, a draw, a clear, a draw: depth, mask, whether the test is on, and the columns that are drawn.
        let steps: Vec<(f32, bool, bool, usize)> = (0..4)
            .map(|_| {
                let column = rng.integer(0, 30) as usize;
                (rng.real(0.1, 0.9), rng.integer(0, 1) == 1, rng.integer(0, 2) > 0, column)
            })
            .collect();
        let expect = |[x, _]: Pixel, variant: Variant| {
            let mut depth = 0.5;
            for (number, &(z, mask, test, from)) in steps.iter().enumerate() {
                let clear = number % 2 == 0;
                let writes = match clear {
                    true => mask || variant.has(Mutation::MaskIgnoredByClear),
                    false => mask && (test || variant.has(Mutation::DepthWithoutTest)) && x >= from,
                };
                depth = if writes { f64::from(z) } else { depth };
            }
            Some([depth, 0.0, 0.0, 0.0])
        };
        pictures.compare(&steps, expect, |session| {
            session.deep_frame(GL_RGBA8, GL_DEPTH_COMPONENT24, PICTURE, 0)?;
            window(PICTURE);
            glClearDepth(0.5);
            glClear(GL_DEPTH_BUFFER_BIT);
            glDepthFunc(GL_ALWAYS);
            for (number, &(z, mask, test, from)) in steps.iter().enumerate() {
                glDepthMask(mask);
                if number % 2 == 0 {
                    glClearDepth(f64::from(z));
                    glClear(GL_DEPTH_BUFFER_BIT);
                } else {
                    if test {
                        glEnable(GL_DEPTH_TEST)
                    } else {
                        glDisable(GL_DEPTH_TEST)
                    }
                    glEnable(GL_SCISSOR_TEST);
                    glScissor(from as i32, 0, PICTURE[0], PICTURE[1]);
                    cover(PICTURE, f64::from(z));
                    glDisable(GL_SCISSOR_TEST);
                }
            }
            session.read_depths(PICTURE)
        })?;
    }
    pictures.finish(100, 90);
    Ok(())
}

fn stencil_faces(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("stencil-faces");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(160).max(32) {
        // The ends of the range, where operations saturate or wrap, half of the time.
        let ends = [0, 1, 254, 255, rng.byte(), rng.byte(), rng.byte(), rng.byte()];
        let stored = rng.pick(&ends);
        let depth_passes = round % 3 > 0;
        let mut state = |number: usize| Stencil {
            compare: Compare::ALL[number % 8],
            // Often equal under the mask.
            reference: if rng.integer(0, 1) == 0 { stored } else { rng.byte() },
            mask: rng.byte() | 1,
            operations: [0; 3].map(|_: i32| rng.pick(&StencilOp::ALL)),
            write_mask: if rng.integer(0, 1) == 0 { 0xff } else { rng.byte() },
            stored,
            depth_passes,
        };
        let states = [state(round), state(round / 8)];
        // The left half is a front face.
        let expect = |[x, _]: Pixel, variant: Variant| {
            let back = usize::from(x >= PICTURE[0] / 2);
            let face = if variant.has(Mutation::FacesSwapped) { 1 - back } else { back };
            let (value, seen) = states[face].apply(variant);
            Some([f64::from(value), f64::from(u8::from(seen)), 0.0, 0.0])
        };
        pictures.compare(&states, expect, |session| {
            session.deep_frame(GL_RGBA8, GL_DEPTH24_STENCIL8, PICTURE, 0)?;
            window(PICTURE);
            glClearStencil(i32::from(stored));
            glClear(GL_STENCIL_BUFFER_BIT);
            glEnable(GL_STENCIL_TEST);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(if depth_passes { GL_LESS } else { GL_GREATER });
            for (face, of) in [GL_FRONT, GL_BACK].into_iter().zip(&states) {
                let [fail, depth_fail, pass] = of.operations.map(operation_enum);
                let compare = compare_enum(of.compare);
                glStencilFuncSeparate(face, compare, i32::from(of.reference), of.mask);
                glStencilOpSeparate(face, fail, depth_fail, pass);
                glStencilMaskSeparate(face, of.write_mask);
            }
            glColor4f(1, 1, 1, 1);
            let ([w, h], half) = (PICTURE.map(|n| n as i32), (PICTURE[0] / 2) as i32);
            let quads =
                [[[0, 0], [half, 0], [half, h], [0, h]], [[half, 0], [half, h], [w, h], [w, 0]]];
            glBegin(GL_QUADS);
            for [x, y] in quads.as_flattened() {
                glVertex3d(f64::from(*x), f64::from(*y), 0.5);
            }
            glEnd();
            let seen = session.read_bytes(PICTURE)?;
            let mut values = session.read_stencil(PICTURE)?;
            for (value, seen) in values.iter_mut().zip(seen) {
                value[1] = seen[0];
            }
            Ok(values)
        })?;
    }
    pictures.finish(100, 50);
    Ok(())
}

fn stencil_clear(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("stencil-clear");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(48) {
        let steps: Vec<(u8, u8, Rect)> =
            (0..4).map(|_| (rng.byte(), rng.byte(), rect(&mut rng))).collect();
        let expect = |pixel: Pixel, variant: Variant| {
            let mut value = 0u8;
            for (clear, mask, rect) in &steps {
                let mask = if variant.has(Mutation::MaskIgnoredByClear) { 0xff } else { *mask };
                if rect.has(pixel) || variant.has(Mutation::ScissorIgnored) {
                    value = (clear & mask) | (value & !mask);
                }
            }
            Some([f64::from(value), 0.0, 0.0, 0.0])
        };
        pictures.compare(&steps, expect, |session| {
            session.deep_frame(GL_RGBA8, GL_DEPTH24_STENCIL8, PICTURE, 0)?;
            glClearStencil(0);
            glClear(GL_STENCIL_BUFFER_BIT);
            glEnable(GL_SCISSOR_TEST);
            for (clear, mask, rect) in &steps {
                glScissor(rect.low[0] as i32, rect.low[1] as i32, rect.size[0], rect.size[1]);
                glStencilMask(*mask);
                glClearStencil(i32::from(*clear));
                glClear(GL_STENCIL_BUFFER_BIT);
            }
            session.read_stencil(PICTURE)
        })?;
    }
    pictures.finish(100, 20);
    Ok(())
}

/// A rectangle in the picture.
fn rect(rng: &mut Rng) -> Rect {
    let low = [rng.integer(0, 30) as usize, rng.integer(0, 24) as usize];
    let size = [0, 1].map(|i| rng.integer(1, (PICTURE[i] - low[i]) as i64) as usize);
    Rect { low, size }
}

fn fill(rect: &Rect, z: f64) {
    let [x0, y0] = rect.low.map(|c| c as f64);
    let [x1, y1] = [0, 1].map(|i| (rect.low[i] + rect.size[i]) as f64);
    glBegin(GL_QUADS);
    for [x, y] in [[x0, y0], [x1, y0], [x1, y1], [x0, y1]] {
        glVertex3d(x, y, z);
    }
    glEnd();
}

fn query(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("occlusion-query");
    for (samples, target) in
        [(0, GL_SAMPLES_PASSED), (4, GL_SAMPLES_PASSED), (0, GL_ANY_SAMPLES_PASSED)]
    {
        // Rectangles with depths, drawn one over the other; the scissor box.
        type Case = (Vec<(Rect, f32)>, Rect);
        let cases: Vec<Case> = (0..harness.cases(64))
            .map(|_| {
                let count = rng.integer(2, 6);
                let rects = (0..count).map(|_| (rect(&mut rng), rng.real(0.1, 0.9))).collect();
                (rects, rect(&mut rng))
            })
            .collect();
        let expect = |(rects, scissor): &Case, variant: Variant| {
            let passed = |pixel: Pixel| {
                let mut depth = f32::INFINITY;
                let mut passed = 0;
                for (rect, z) in rects {
                    if rect.has(pixel)
                        && scissor.has(pixel)
                        && (*z < depth || variant.has(Mutation::HiddenCounted))
                    {
                        (depth, passed) = (*z, passed + 1);
                    }
                }
                passed
            };
            let total: usize = all(PICTURE).map(passed).sum();
            let each = if samples == 4 && !variant.has(Mutation::PixelsCounted) { 4 } else { 1 };
            [
                if target == GL_SAMPLES_PASSED {
                    (total * each) as f64
                } else {
                    f64::from(u8::from(total > 0))
                },
                0.0,
                0.0,
                0.0,
            ]
        };
        harness.compare(tally, &(samples, enum_name(target)), &cases, expect, |session| {
            session.deep_frame(GL_RGBA8, GL_DEPTH_COMPONENT24, PICTURE, samples)?;
            window(PICTURE);
            glEnable(GL_DEPTH_TEST);
            let (mut name, mut counts) = (0u32, Vec::new());
            glGenQueries(1, &mut name);
            for (rects, scissor) in &cases {
                glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
                glEnable(GL_SCISSOR_TEST);
                let ([x, y], [w, h]) = (scissor.low, scissor.size);
                glScissor(x as i32, y as i32, w, h);
                glBeginQuery(target, name);
                for (rect, z) in rects {
                    fill(rect, f64::from(*z));
                }
                glEndQuery(target);
                glDisable(GL_SCISSOR_TEST);
                let mut count = 0u32;
                glGetQueryObjectuiv(name, GL_QUERY_RESULT, &mut count);
                counts.push([f64::from(count), 0.0, 0.0, 0.0]);
            }
            session.check("counting samples")?;
            Ok(counts)
        })?;
        let some = cases.iter().filter(|case| expect(case, Variant::CORRECT)[0] > 0.0).count();
        tally.reach("queries that count something", some, cases.len() / 4);
    }
    Ok(())
}

fn conditional(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("conditional-render");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(32).max(6) {
        let (hidden, rect) = (round % 2 == 0, rect(&mut rng));
        let expect = |pixel: Pixel, variant: Variant| {
            let shown = !hidden || variant.has(Mutation::ConditionIgnored);
            Some(drawn(shown && rect.has(pixel)))
        };
        pictures.compare(&(hidden, rect), expect, |session| {
            session.deep_frame(GL_RGBA32F, GL_DEPTH_COMPONENT24, PICTURE, 0)?;
            window(PICTURE);
            glEnable(GL_DEPTH_TEST);
            glColorMask(false, false, false, false);
            cover(PICTURE, 0.5);
            let mut name = 0u32;
            glGenQueries(1, &mut name);
            glBeginQuery(GL_SAMPLES_PASSED, name);
            cover(PICTURE, if hidden { 0.75 } else { 0.25 });
            glEndQuery(GL_SAMPLES_PASSED);
            glColorMask(true, true, true, true);
            glBeginConditionalRender(name, GL_QUERY_WAIT);
            glColor4f(1, 0, 0, 0);
            fill(&rect, 0.125);
            glEndConditionalRender();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 3);
    Ok(())
}
