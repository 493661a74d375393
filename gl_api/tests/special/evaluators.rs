//! Evaluators: GL 2.1, section 5.1, seen through feedback.

use super::{context, fine};
use gl_api::*;

/// The numbers of points that a draw makes: x, y, z of 8×8 pixels, and the colour.
fn points(c: &mut Context, draw: impl FnOnce(&mut Context)) -> Vec<[f64; 7]> {
    c.feedback_buffer(1 << 14, GL_3D_COLOR, DataOut::Null);
    c.render_mode(GL_FEEDBACK);
    draw(c);
    assert!(c.render_mode(GL_RENDER) >= 0);
    fine(c);
    let numbers = c.feedback().chunks(8);
    numbers.map(|chunk| [1, 2, 3, 4, 5, 6, 7].map(|at| f64::from(chunk[at]))).collect()
}

/// De Casteljau, which is not how DetGL does it.
fn casteljau(points: &[[f64; 3]], t: f64) -> [f64; 3] {
    let mut points = points.to_vec();
    while points.len() > 1 {
        points = points
            .windows(2)
            .map(|pair| [0, 1, 2].map(|i| pair[0][i] * (1.0 - t) + pair[1][i] * t))
            .collect();
    }
    points[0]
}

/// Where a point comes to lie in a window of 8×8 pixels.
fn window([x, y, z]: [f64; 3]) -> [f64; 3] {
    [(x + 1.0) * 4.0, (y + 1.0) * 4.0, (z + 1.0) / 2.0]
}

fn close(found: &[f64], expected: &[f64]) {
    let far = found.iter().zip(expected).any(|(a, b)| (a - b).abs() > 1e-5);
    assert!(!far, "{found:?} is not {expected:?}");
}

const CURVE: [[f32; 3]; 4] =
    [[-0.9, -0.5, 0.0], [-0.3, 0.8, 0.25], [0.4, -0.7, 0.5], [0.9, 0.6, -0.5]];

#[test]
fn a_curve_is_its_polynomial() {
    let mut c = context(8, 8);
    let curve = CURVE.map(|point| point.map(f64::from));
    c.map1f(GL_MAP1_VERTEX_3, 2.0, 4.0, 3, 4, CURVE.as_flattened());
    c.enable(GL_MAP1_VERTEX_3);
    c.map_grid1f(10, 2.0, 4.0);
    let found = points(&mut c, |c| c.eval_mesh1(GL_POINT, 0, 10));
    assert_eq!(found.len(), 11);
    for (i, found) in found.iter().enumerate() {
        close(&found[..3], &window(casteljau(&curve, i as f64 / 10.0)));
    }
    // One by one, in every type, and by number.
    let found = points(&mut c, |c| {
        c.begin(GL_POINTS);
        c.eval_coord1f(2.5);
        c.eval_coord1d(2.5);
        c.eval_coord1fv(&[2.5]);
        c.eval_coord1dv(&[2.5]);
        c.end();
        c.map_grid1d(4, 2.0, 3.0);
        c.begin(GL_POINTS);
        c.eval_point1(2);
        c.end();
    });
    assert_eq!(found.len(), 5);
    for found in found {
        close(&found[..3], &window(casteljau(&curve, 0.25)));
    }
}

#[test]
fn a_surface_is_a_curve_of_curves() {
    let mut c = context(8, 8);
    // 3 by 2 points, the second parameter's apart by 5 numbers, the first's by 11.
    let mut numbers = [0.0_f64; 33];
    let mut surface = [[[0.0; 3]; 2]; 3];
    for (i, row) in surface.iter_mut().enumerate() {
        for (j, point) in row.iter_mut().enumerate() {
            *point = [i as f64 * 0.4 - 0.4, j as f64 * 0.6 - 0.3, (i * j) as f64 * 0.25];
            numbers[i * 11 + j * 5..][..3].copy_from_slice(point);
        }
    }
    c.map2d(GL_MAP2_VERTEX_3, 0.0, 1.0, 11, 3, -1.0, 1.0, 5, 2, &numbers);
    c.enable(GL_MAP2_VERTEX_3);
    let (u, v) = (0.3, 0.5);
    let expected = window(casteljau(&surface.map(|row| casteljau(&row, (v + 1.0) / 2.0)), u));
    let found = points(&mut c, |c| {
        c.begin(GL_POINTS);
        c.eval_coord2f(u as f32, v as f32);
        c.eval_coord2d(u, v);
        c.eval_coord2fv(&[u as f32, v as f32]);
        c.eval_coord2dv(&[u, v]);
        c.end();
    });
    assert_eq!(found.len(), 4);
    found.iter().for_each(|found| close(&found[..3], &expected));
    c.map_grid2f(4, 0.0, 1.0, 2, -1.0, 1.0);
    assert_eq!(points(&mut c, |c| c.eval_mesh2(GL_POINT, 0, 4, 0, 2)).len(), 15);
    let mut counts = [0; 2];
    for (mode, count) in [GL_LINE, GL_FILL].into_iter().zip(&mut counts) {
        c.feedback_buffer(1 << 12, GL_2D, DataOut::Null);
        c.render_mode(GL_FEEDBACK);
        c.eval_mesh2(mode, 0, 4, 0, 2);
        *count = c.render_mode(GL_RENDER);
    }
    // 3 rows of 4 lines and 5 columns of 2, of 5 numbers each; 8 quads of 10 numbers.
    assert_eq!(counts, [(3 * 4 + 5 * 2) * 5, 8 * 10]);
    fine(&mut c);
}

#[test]
fn attributes_are_evaluated_and_current_values_stay() {
    let mut c = context(8, 8);
    c.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 2, &[0.0, 0.0, 0.0, 0.5, 0.0, 0.0]);
    c.map1f(GL_MAP1_COLOR_4, 0.0, 1.0, 4, 2, &[1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0]);
    c.enable(GL_MAP1_VERTEX_3);
    c.enable(GL_MAP1_COLOR_4);
    c.color_3f(0.0, 0.0, 1.0);
    let found = points(&mut c, |c| {
        c.begin(GL_POINTS);
        c.eval_coord1f(0.25);
        c.vertex_2f(0.0, 0.0);
        c.end();
    });
    close(&found[0][3..], &[0.75, 0.25, 0.0, 1.0]);
    close(&found[1][3..], &[0.0, 0.0, 1.0, 1.0]);
    let mut color = [0.0; 4];
    c.get_floatv(GL_CURRENT_COLOR, &mut color);
    assert_eq!(color, [0.0, 0.0, 1.0, 1.0]);
    // Lists evaluate when they are called.
    c.new_list(1, GL_COMPILE);
    c.begin(GL_POINTS);
    c.eval_coord1f(0.25);
    c.end();
    c.end_list();
    let listed = points(&mut c, |c| c.call_list(1));
    assert_eq!(listed[0], found[0]);
}

#[test]
fn normals_follow_the_surface() {
    let mut c = context(8, 8);
    // The plane z = x: its normal is (-1, 0, 1) / √2.
    let plane = [-0.5, -0.5, -0.5, -0.5, 0.5, -0.5, 0.5, -0.5, 0.5, 0.5, 0.5, 0.5];
    c.map2f(GL_MAP2_VERTEX_3, 0.0, 1.0, 6, 2, 0.0, 1.0, 3, 2, &plane);
    c.enable(GL_MAP2_VERTEX_3);
    c.enable(GL_AUTO_NORMAL);
    c.enable(GL_LIGHTING);
    c.enable(GL_LIGHT0);
    c.lightfv(GL_LIGHT0, GL_POSITION, &[0.0, 0.0, 1.0, 0.0]);
    c.lightfv(GL_LIGHT0, GL_DIFFUSE, &[1.0; 4]);
    c.materialfv(GL_FRONT, GL_AMBIENT, &[0.0; 4]);
    c.materialfv(GL_FRONT, GL_DIFFUSE, &[1.0; 4]);
    let found = points(&mut c, |c| {
        c.begin(GL_POINTS);
        c.eval_coord2f(0.5, 0.5);
        c.end();
    });
    close(&found[0][3..6], &[std::f64::consts::FRAC_1_SQRT_2; 3]);
}

#[test]
fn maps_and_grids_can_be_read_and_grids_come_back() {
    let mut c = context(8, 8);
    c.map1f(GL_MAP1_VERTEX_3, 2.0, 4.0, 3, 4, CURVE.as_flattened());
    let mut numbers = [0.0_f32; 12];
    c.get_mapfv(GL_MAP1_VERTEX_3, GL_COEFF, (&mut numbers).arg());
    assert_eq!(numbers, CURVE.as_flattened());
    let (mut order, mut domain) = ([0], [0.0_f64; 2]);
    c.get_mapiv(GL_MAP1_VERTEX_3, GL_ORDER, (&mut order).arg());
    c.get_mapdv(GL_MAP1_VERTEX_3, GL_DOMAIN, (&mut domain).arg());
    assert_eq!((order, domain), ([4], [2.0, 4.0]));
    c.push_attrib(GL_EVAL_BIT);
    c.map_grid1f(7, 0.0, 2.0);
    c.enable(GL_MAP1_INDEX);
    c.pop_attrib();
    let mut segments = [0];
    c.get_integerv(GL_MAP1_GRID_SEGMENTS, &mut segments);
    assert_eq!(segments, [1]);
    assert!(!c.is_enabled(GL_MAP1_INDEX));
    fine(&mut c);
}
