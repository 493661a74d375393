//! `glClipControl`: where y = -w is in the window, and the depths between the planes (`ARB_clip_control`).

use super::{context, fine, pixel};
use gl_api::*;

const WHITE: [u8; 4] = [255; 4];
const BLACK: [u8; 4] = [0, 0, 0, 255];

/// A window of 8×8 pixels with a depth buffer in which everything passes and is written.
fn prepared() -> Context {
    let mut c = context(8, 8);
    c.clear_color(0.0, 0.0, 0.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    c.enable(GL_DEPTH_TEST);
    c.depth_func(GL_ALWAYS);
    c
}

fn depth(c: &mut Context, x: i32, y: i32) -> f32 {
    let mut bytes = [0; 4];
    c.read_pixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, DataOut::Bytes(&mut bytes));
    fine(c);
    f32::from_le_bytes(bytes)
}

/// Counter-clockwise in clip coordinates, from y = -1 to `top`.
fn quad(c: &mut Context, top: f32, [left, right]: [f32; 2]) {
    c.begin(GL_QUADS);
    for (x, y, z) in [(-1.0, -1.0, left), (1.0, -1.0, right), (1.0, top, right), (-1.0, top, left)]
    {
        c.vertex_3f(x, y, z);
    }
    c.end();
}

#[test]
fn depths_from_zero_to_one_are_window_depths() {
    for [near, far] in [[0.0, 1.0], [0.25, 0.75], [1.0, 0.0]] {
        let mut c = prepared();
        c.depth_range(near, far);
        for z in [0.0, 0.25, 0.5, 1.0_f32] {
            let part = f64::from(z);
            for (mode, part) in
                [(GL_ZERO_TO_ONE, part), (GL_NEGATIVE_ONE_TO_ONE, (part + 1.0) / 2.0)]
            {
                c.clip_control(GL_LOWER_LEFT, mode);
                quad(&mut c, 1.0, [z; 2]);
                let wanted = near + part * (far - near);
                let found = depth(&mut c, 3, 3);
                // Half a step of 24 bits, and half a step of the `f32`.
                let error = (f64::from(found) - wanted).abs();
                assert!(error <= 1.0 / f64::from((1 << 24) - 1), "{found} {wanted}");
            }
        }
    }
}

#[test]
fn the_near_plane_is_at_zero() {
    // From z = -1 at the left to z = 1 at the right, in triangles, lines and points.
    let mut c = prepared();
    c.clip_control(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    quad(&mut c, 1.0, [-1.0, 1.0]);
    let row: Vec<bool> = (0..8).map(|x| pixel(&mut c, x, 3) == WHITE).collect();
    assert_eq!(row, [false, false, false, false, true, true, true, true]);
    assert!((depth(&mut c, 4, 3) - 0.125).abs() < 1e-6);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.begin(GL_LINES);
    c.vertex_3f(-1.0, 0.15, -1.0);
    c.vertex_3f(1.0, 0.15, 1.0);
    c.end();
    let row: Vec<bool> = (0..8).map(|x| pixel(&mut c, x, 4) == WHITE).collect();
    assert_eq!(row, [false, false, false, false, true, true, true, true]);
    c.clear(GL_COLOR_BUFFER_BIT);
    for (z, wanted) in [(-0.001, BLACK), (0.0, WHITE), (1.0, WHITE), (1.001, BLACK)] {
        c.clear(GL_COLOR_BUFFER_BIT);
        c.begin(GL_POINTS);
        c.vertex_3f(0.125, 0.125, z);
        c.end();
        assert_eq!(pixel(&mut c, 4, 4), wanted, "z = {z}");
    }
    // Wholly between -w and 0.
    c.clear(GL_COLOR_BUFFER_BIT);
    quad(&mut c, 1.0, [-0.5, -0.25]);
    assert_eq!(pixel(&mut c, 4, 4), BLACK);
    // Clamped, nothing is cut.
    c.enable(GL_DEPTH_CLAMP);
    quad(&mut c, 1.0, [-0.5, -0.25]);
    assert_eq!((pixel(&mut c, 4, 4), depth(&mut c, 4, 4)), (WHITE, 0.0));
    fine(&mut c);
}

#[test]
fn an_upper_origin_turns_the_picture_and_not_the_faces() {
    for (origin, lit) in [(GL_LOWER_LEFT, [0, 1, 2, 3]), (GL_UPPER_LEFT, [7, 6, 5, 4])] {
        for (face, drawn) in [(GL_BACK, true), (GL_FRONT, false)] {
            let mut c = prepared();
            c.enable(GL_CULL_FACE);
            c.cull_face(face);
            c.clip_control(origin, GL_NEGATIVE_ONE_TO_ONE);
            quad(&mut c, 0.0, [0.0; 2]);
            for y in 0..8 {
                let wanted = if drawn && lit.contains(&y) { WHITE } else { BLACK };
                assert_eq!(pixel(&mut c, 3, y), wanted, "{origin:#x} {face:#x} row {y}");
            }
            fine(&mut c);
        }
    }
}

#[test]
fn raster_positions_and_feedback_follow() {
    let mut c = prepared();
    c.clip_control(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    c.raster_pos_3f(0.5, 0.5, 0.25);
    let mut position = [0.0; 4];
    c.get_floatv(GL_CURRENT_RASTER_POSITION, &mut position);
    assert_eq!(position, [6.0, 2.0, 0.25, 1.0]);
    let mut valid = [0];
    for (z, wanted) in [(-0.5, 0), (0.0, 1), (1.0, 1), (1.5, 0)] {
        c.raster_pos_3f(0.0, 0.0, z);
        c.get_integerv(GL_CURRENT_RASTER_POSITION_VALID, &mut valid);
        assert_eq!(valid, [wanted], "z = {z}");
    }
    c.feedback_buffer(16, GL_3D, DataOut::Null);
    c.render_mode(GL_FEEDBACK);
    c.begin(GL_LINES);
    c.vertex_3f(-1.0, 0.5, -1.0);
    c.vertex_3f(1.0, 0.5, 1.0);
    c.end();
    assert_eq!(c.render_mode(GL_RENDER), 7);
    assert_eq!(c.feedback()[1..7], [4.0, 2.0, 0.0, 8.0, 2.0, 1.0]);
    fine(&mut c);
}
