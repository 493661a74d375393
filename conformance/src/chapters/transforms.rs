//! Matrices, window coordinates, the raster position, feedback and selection.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::{self, *};
use crate::mutation::{Mutation, Variant};
use crate::oracle::matrix::{Matrix, from_columns};
use crate::oracle::transform::{
    IDENTITY, Viewport, clip, frustum, in_volume, look_at, ortho, perspective, product, rotation,
    scaling, translation,
};
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;
use gl_api::glu::{gluLookAt, gluOrtho2D, gluPerspective};

/// Rotations.
pub const ROTATE: Check = Check {
    name: "matrix-rotate",
    citation: "GL 2.1, 2.11.2, equation 2.1: glRotate",
    what: "matrices of random angles of up to two turns about axes of lengths 1e-3 to 1e3",
    unit: Unit::FullScale,
    tolerance: 1.001 / (1 << 25) as f64,
    why: "elements up to 1 that are computed in f64 and rounded to f32 once: 2^-25",
    run: |harness, tally| matrices(harness, tally, Maker::Rotate),
};

/// Projections.
pub const FRUSTUM: Check = Check {
    name: "matrix-frustum",
    citation: "GL 2.1, 2.11.2: glFrustum; GLU 1.3, 4.1 and 4.2: gluPerspective, gluOrtho2D",
    what: "matrices of random frusta, off centre too, of random fields of view, and of rectangles",
    unit: Unit::Ulp,
    tolerance: 0.501,
    why: "in f64, then rounded once: half a ULP; what differences of f64 lose, up to 2^-43 of an element that is 2^-9 of its terms, is below a thousandth",
    run: |harness, tally| {
        matrices(harness, tally, Maker::Frustum)?;
        matrices(harness, tally, Maker::Perspective)?;
        matrices(harness, tally, Maker::Ortho2D)
    },
};

/// Parallel projections.
pub const ORTHO: Check = Check {
    name: "matrix-ortho",
    citation: "GL 2.1, 2.11.2: glOrtho",
    what: "matrices of random boxes",
    unit: Unit::Ulp,
    tolerance: 0.501,
    why: "in f64, then rounded once: half a ULP; what differences of f64 lose, up to 2^-43 of an element that is 2^-9 of its terms, is below a thousandth",
    run: |harness, tally| matrices(harness, tally, Maker::Ortho),
};

/// The viewing matrix.
pub const LOOK_AT: Check = Check {
    name: "matrix-look-at",
    citation: "GLU 1.3, 4.2: gluLookAt",
    what: "matrices of random eyes, centres and ups that are not orthogonal",
    unit: Unit::FullScale,
    tolerance: 1.4 / (1 << 22) as f64,
    why: "f32 elements up to 6, half a step is 2^-22, after two products that are rounded",
    run: |harness, tally| matrices(harness, tally, Maker::LookAt),
};

/// Products and the stack.
pub const PRODUCT: Check = Check {
    name: "matrix-product",
    citation: "GL 2.1, 2.11.2: glMultMatrix, glMultTransposeMatrix, glTranslate, glScale, glPushMatrix",
    what: "products of five random matrices, with others pushed and popped between them",
    unit: Unit::FullScale,
    tolerance: 1.2 / (1 << 20) as f64,
    why: "f32 elements up to 16, half a step is 2^-21, and what earlier products were rounded by",
    run: |harness, tally| matrices(harness, tally, Maker::Product),
};

/// Window coordinates.
pub const VIEWPORT: Check = Check {
    name: "viewport",
    citation: "GL 2.1, 2.11.1: x_w = (p_x/2)·x_d + o_x, z_w = ((f − n)/2)·z_d + (n + f)/2; 5.3: GL_FEEDBACK",
    what: "window coordinates of points in feedback, of viewports with odd sizes and negative corners",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 16) as f64,
    why: "f32 window coordinates up to 200: products and sums are rounded by 2^-17",
    run: |harness, tally| placed(harness, tally, How::Feedback),
};

/// The raster position.
pub const RASTER_POSITION: Check = Check {
    name: "raster-position",
    citation: "GL 2.1, 2.13: glRasterPos is transformed as a vertex; GL_CURRENT_RASTER_POSITION_VALID",
    what: "window coordinates, w and validity of random positions, within and outside the view volume",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 16) as f64,
    why: "f32 window coordinates up to 200: products and sums are rounded by 2^-17",
    run: |harness, tally| placed(harness, tally, How::RasterPosition),
};

/// What makes a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Maker {
    Rotate,
    Frustum,
    Perspective,
    Ortho,
    Ortho2D,
    LookAt,
    Product,
}

/// Random parameters of a matrix.
fn parameters(rng: &mut Rng, maker: Maker) -> Vec<f64> {
    let mut real = |low: f64, high: f64| f64::from(rng.real(low, high));
    match maker {
        Maker::Rotate => {
            let length = 10f64.powf(real(-3.0, 3.0));
            let axis: Vec<f64> = (0..3).map(|_| real(0.2, 1.0) * length).collect();
            [vec![real(-720.0, 720.0)], axis].concat()
        }
        Maker::Frustum | Maker::Ortho => {
            let [l, b, n] = [real(-3.0, 1.0), real(-3.0, 1.0), real(0.1, 2.0)];
            vec![l, l + real(0.5, 5.0), b, b + real(0.5, 5.0), n, n + real(0.5, 90.0)]
        }
        Maker::Ortho2D => {
            let [l, b] = [real(-3.0, 1.0), real(-3.0, 1.0)];
            vec![l, l + real(0.5, 5.0), b, b + real(0.5, 5.0), -1.0, 1.0]
        }
        Maker::Perspective => {
            vec![real(5.0, 150.0), real(0.3, 3.0), real(0.1, 2.0), real(3.0, 90.0)]
        }
        Maker::LookAt => {
            let eye = [real(-2.0, 2.0), real(-2.0, 2.0), real(-2.0, 2.0)];
            let ahead = [real(1.0, 2.0), real(-1.0, 1.0), real(-1.0, 1.0)];
            let centre = [0, 1, 2].map(|i| eye[i] + ahead[i]);
            [eye.to_vec(), centre.to_vec(), vec![real(-0.3, 0.3), real(0.5, 1.0), real(-1.0, 1.0)]]
                .concat()
        }
        Maker::Product => (0..11 + 32).map(|_| real(-1.5, 1.5)).collect(),
    }
}

fn three(p: &[f64], from: usize) -> [f64; 3] {
    [p[from], p[from + 1], p[from + 2]]
}

fn six(p: &[f64]) -> [f64; 6] {
    [p[0], p[1], p[2], p[3], p[4], p[5]]
}

/// Sixteen numbers in columns.
fn sixteen(p: &[f64]) -> [f32; 16] {
    std::array::from_fn(|i| p[i] as f32)
}

fn expected(maker: Maker, p: &[f64], variant: Variant) -> Matrix {
    match maker {
        Maker::Rotate => rotation(p[0], three(p, 1), variant),
        Maker::Frustum => frustum(six(p), variant),
        Maker::Perspective => perspective([p[0], p[1], p[2], p[3]], variant),
        Maker::Ortho | Maker::Ortho2D => ortho(six(p), variant),
        Maker::LookAt => look_at([three(p, 0), three(p, 3), three(p, 6)], variant),
        Maker::Product => {
            let transposed = from_columns(&sixteen(&p[27..]));
            let second: Matrix = if variant.has(Mutation::TransposeIgnored) {
                transposed
            } else {
                [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| transposed[j][i]))
            };
            let steps = [
                translation(three(p, 0)),
                from_columns(&sixteen(&p[11..])),
                rotation(p[3] * 90.0, three(p, 4), Variant::CORRECT),
                second,
                scaling(three(p, 7)),
            ];
            let reversed = variant.has(Mutation::ProductReversed);
            steps.iter().fold(IDENTITY, |m, step| {
                if reversed { product(step, &m) } else { product(&m, step) }
            })
        }
    }
}

fn make(maker: Maker, p: &[f64]) {
    match maker {
        Maker::Rotate => glRotated(p[0], p[1], p[2], p[3]),
        Maker::Frustum => glFrustum(p[0], p[1], p[2], p[3], p[4], p[5]),
        Maker::Perspective => gluPerspective(p[0], p[1], p[2], p[3]),
        Maker::Ortho => glOrtho(p[0], p[1], p[2], p[3], p[4], p[5]),
        Maker::Ortho2D => gluOrtho2D(p[0], p[1], p[2], p[3]),
        Maker::LookAt => gluLookAt(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8]),
        Maker::Product => {
            glTranslated(p[0], p[1], p[2]);
            glMultMatrixf(&sixteen(&p[11..]));
            glPushMatrix();
            glScaled(3, 4, 5);
            glPopMatrix();
            glRotated(p[3] * 90.0, p[4], p[5], p[6]);
            glMultTransposeMatrixf(&sixteen(&p[27..]));
            glScaled(p[7], p[8], p[9]);
        }
    }
}

fn matrices(harness: &Harness, tally: &mut Tally, maker: Maker) -> Result<(), ProbeError> {
    let mut rng = Rng::named("matrices");
    // A matrix, and one of its rows.
    let made: Vec<Vec<f64>> =
        (0..harness.cases(512)).map(|_| parameters(&mut rng, maker)).collect();
    let cases: Vec<(usize, usize)> =
        (0..made.len()).flat_map(|k| (0..4).map(move |row| (k, row))).collect();
    let expect =
        |&(k, row): &(usize, usize), variant: Variant| expected(maker, &made[k], variant)[row];
    harness.compare(tally, &maker, &cases, expect, |session| {
        let mut rows = Vec::new();
        for p in &made {
            glMatrixMode(GL_MODELVIEW);
            glLoadIdentity();
            make(maker, p);
            let mut columns = [0.0f32; 16];
            glGetFloatv(GL_MODELVIEW_MATRIX, &mut columns);
            rows.extend(from_columns(&columns));
        }
        session.check("making matrices")?;
        Ok(rows)
    })
}

/// How window coordinates are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum How {
    Feedback,
    RasterPosition,
}

fn placed(harness: &Harness, tally: &mut Tally, how: How) -> Result<(), ProbeError> {
    let mut rng = Rng::named("viewport");
    let mut seen = [0usize; 2];
    for _ in 0..harness.cases(32).max(4) {
        let low = [0; 2].map(|_: i32| rng.integer(-40, 60) as f64);
        let size = [0; 2].map(|_: i32| rng.integer(1, 140) as f64);
        let depth = [f64::from(rng.real(0.0, 1.0)), f64::from(rng.real(0.0, 1.0))];
        let viewport = Viewport { low, size, depth };
        let n = f64::from(rng.real(0.5, 1.0));
        let projection = [-1.0, 1.5, -1.25, 1.0, n, n + 9.0];
        let model_view = parameters(&mut rng, Maker::Rotate);
        let move_by = [0.0, 0.0, -4.0];
        let made = |variant| {
            (
                frustum(projection, variant),
                product(
                    &translation(move_by),
                    &rotation(model_view[0], three(&model_view, 1), variant),
                ),
            )
        };
        let reach = if how == How::RasterPosition { 5.0 } else { 2.5 };
        let clipped = |object: &[f32; 3]| {
            let (projection, model_view) = made(Variant::CORRECT);
            let [x, y, z] = object.map(f64::from);
            clip(&projection, &model_view, [x, y, z, 1.0])
        };
        let cases: Vec<[f32; 3]> =
            std::iter::repeat_with(|| [0; 3].map(|_: i32| rng.real(-reach, reach)))
                .filter(|object| match in_volume(clipped(object)) {
                    Some(inside) => inside || how == How::RasterPosition,
                    None => false,
                })
                .take(64)
                .collect();
        for case in &cases {
            seen[usize::from(in_volume(clipped(case)) == Some(true))] += 1;
        }
        let expect = |object: &[f32; 3], variant: Variant| {
            let clip = clipped(object);
            let valid = in_volume(clip) == Some(true) || variant.has(Mutation::AlwaysValid);
            let [x, y, z, w] = viewport.window(clip, variant);
            match (how, valid) {
                (How::Feedback, _) => [x, y, z, w],
                (How::RasterPosition, true) => [x, y, z, w],
                (How::RasterPosition, false) => [0.0; 4],
            }
        };
        harness.compare(tally, &(viewport, projection), &cases, expect, |session| {
            let ([x, y], [w, h]) = (low.map(|c| c as i32), size.map(|c| c as usize));
            glViewport(x, y, w, h);
            session.depth_range(depth);
            glMatrixMode(GL_PROJECTION);
            glLoadIdentity();
            let p = projection;
            glFrustum(p[0], p[1], p[2], p[3], p[4], p[5]);
            glMatrixMode(GL_MODELVIEW);
            glTranslated(move_by[0], move_by[1], move_by[2]);
            glRotated(model_view[0], model_view[1], model_view[2], model_view[3]);
            match how {
                How::Feedback => feedback(session, &cases),
                How::RasterPosition => cases.iter().map(|of| raster(session, *of)).collect(),
            }
        })?;
    }
    tally.reach("places within the view volume", seen[1], 64);
    if how == How::RasterPosition {
        tally.reach("places outside", seen[0], 16);
    }
    Ok(())
}

fn feedback(session: &Session, points: &[[f32; 3]]) -> Result<Vec<[f64; 4]>, ProbeError> {
    glFeedbackBuffer(points.len() * 16, GL_4D_COLOR_TEXTURE, NULL);
    glRenderMode(GL_FEEDBACK);
    glBegin(GL_POINTS);
    for [x, y, z] in points {
        glVertex3f(*x, *y, *z);
    }
    glEnd();
    let count = glRenderMode(GL_RENDER);
    session.check("reading feedback")?;
    // A token, x, y, z, w, four of colour, four of texture coordinates.
    let buffer = gl::feedback();
    let records = buffer.get(..count.max(0) as usize).unwrap_or_default().chunks_exact(13);
    Ok(records.map(|record| [1, 2, 3, 4].map(|i| f64::from(record[i]))).collect())
}

fn raster(session: &Session, [x, y, z]: [f32; 3]) -> Result<[f64; 4], ProbeError> {
    glRasterPos3f(x, y, z);
    let (mut place, mut valid) = ([0.0f32; 4], [0i32; 1]);
    glGetIntegerv(GL_CURRENT_RASTER_POSITION_VALID, &mut valid);
    glGetFloatv(GL_CURRENT_RASTER_POSITION, &mut place);
    session.check("reading the raster position")?;
    Ok(if valid[0] == 1 { place.map(f64::from) } else { [0.0; 4] })
}

/// Selection.
pub const SELECTION: Check = Check {
    name: "selection",
    citation: "GL 2.1, 5.2: hit records: names, least and largest window depth times 2^32 − 1",
    what: "records of random triangles, each under a stack of names, some outside the view volume",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1u64 << 32) as f64,
    why: "whole numbers of 2^-32",
    run: selection,
};

fn selection(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("selection");
    type Case = [[f32; 3]; 3];
    let cases: Vec<Case> = (0..harness.cases(128))
        .map(|k| {
            let away = if k % 3 == 0 { 3.0 } else { 0.0 };
            [0; 3].map(|_: i32| {
                [rng.real(-0.9, 0.9) + away, rng.real(-0.9, 0.9), rng.real(-0.9, 0.9)]
            })
        })
        .collect();
    // How many records, the name, and its depths.
    let expect = |case: &Case, variant: Variant| {
        if case[0][0] > 2.0 {
            return [0.0; 4];
        }
        let depth = |z: f32| {
            let z = f64::from(z);
            if variant.has(Mutation::DepthsOfDevice) { z } else { z / 2.0 + 0.5 }
        };
        let depths = case.map(|corner| depth(corner[2]));
        let least = depths.into_iter().fold(f64::INFINITY, f64::min);
        let largest = depths.into_iter().fold(f64::NEG_INFINITY, f64::max);
        [1.0, 7.0, least, largest]
    };
    harness.compare(tally, &"triangles", &cases, expect, |session| {
        let mut found = Vec::new();
        for case in &cases {
            glSelectBuffer(64, NULL);
            glRenderMode(GL_SELECT);
            glInitNames();
            glPushName(3);
            glPushName(7);
            glBegin(GL_TRIANGLES);
            for [x, y, z] in case {
                glVertex3f(*x, *y, *z);
            }
            glEnd();
            glLoadName(9);
            let hits = glRenderMode(GL_RENDER);
            let mut buffer = gl::selection();
            buffer.resize(8, 0);
            let z = |word: u32| f64::from(word) / f64::from(u32::MAX);
            let well = hits == 1 && buffer[0] == 2 && buffer[3] == 3;
            found.push(match hits {
                0 => [0.0; 4],
                _ if well => [1.0, f64::from(buffer[4]), z(buffer[1]), z(buffer[2])],
                _ => [f64::from(hits), -1.0, 0.0, 0.0],
            });
        }
        session.check("selecting")?;
        Ok(found)
    })?;
    let hit = cases.iter().filter(|case| case[0][0] < 2.0).count();
    tally.reach("triangles that are hit", hit, cases.len() / 2);
    Ok(())
}
