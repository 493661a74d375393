//! `GL_DEPTH_CLAMP`: the near and the far plane cut nothing, and depths are held between those of both
//! (`ARB_depth_clamp`).

use super::{context, fine, pixel};
use gl_api::*;

/// A window of 4×4 pixels with depths from 0.25 at the near plane to 0.75 at the far one, cleared to
/// 0.5, in which everything passes and is written.
fn prepared() -> Context {
    let mut c = context(4, 4);
    c.depth_range(0.25, 0.75);
    c.clear_depth(0.5);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    c.enable(GL_DEPTH_TEST);
    c.depth_func(GL_ALWAYS);
    c
}

/// The depth of a pixel.
fn depth(c: &mut Context, x: i32, y: i32) -> f32 {
    let mut bytes = [0; 4];
    c.read_pixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, DataOut::Bytes(&mut bytes));
    fine(c);
    f32::from_le_bytes(bytes)
}

fn near(found: f32, wanted: f32) {
    assert!((found - wanted).abs() < 1e-4, "{found} is not {wanted}");
}

/// A primitive of this kind over the whole window (lines and points over its pixel 1, 1), at depths z.
fn draw(c: &mut Context, mode: GLenum, [left, right]: [f32; 2]) {
    let corners: &[[f32; 3]] = match mode {
        GL_POINTS => &[[-0.25, -0.25, left]],
        GL_LINES => &[[-1.0, -0.25, left], [1.0, -0.25, right]],
        _ => &[[-1.0, -1.0, left], [1.0, -1.0, right], [1.0, 1.0, right], [-1.0, 1.0, left]],
    };
    c.begin(mode);
    for corner in corners {
        c.vertex_3fv(corner);
    }
    c.end();
}

#[test]
fn everything_is_held_between_the_planes() {
    for mode in [GL_POINTS, GL_LINES, GL_QUADS, GL_TRIANGLE_FAN, GL_POLYGON] {
        for (z, clamped) in [(-3.0, 0.25), (3.0, 0.75), (-1.5, 0.25), (0.5, 0.625)] {
            let mut c = prepared();
            draw(&mut c, mode, [z; 2]);
            // Without, what lies beyond is cut away.
            near(depth(&mut c, 1, 1), if z == 0.5 { 0.625 } else { 0.5 });
            c.enable(GL_DEPTH_CLAMP);
            draw(&mut c, mode, [z; 2]);
            near(depth(&mut c, 1, 1), clamped);
            assert_eq!(pixel(&mut c, 1, 1), [255; 4]);
            c.disable(GL_DEPTH_CLAMP);
            c.clear(GL_DEPTH_BUFFER_BIT);
            draw(&mut c, mode, [z; 2]);
            near(depth(&mut c, 1, 1), if z == 0.5 { 0.625 } else { 0.5 });
        }
    }
}

#[test]
fn a_slope_goes_on_up_to_the_planes() {
    // From -3 to 3 over four pixels: -2.25, -0.75, 0.75, 2.25.
    for reversed in [false, true] {
        let mut c = prepared();
        c.enable(GL_DEPTH_CLAMP);
        if reversed {
            c.depth_range(0.75, 0.25);
        }
        draw(&mut c, GL_QUADS, [-3.0, 3.0]);
        for (x, wanted) in (0..).zip([0.25, 0.3125, 0.6875, 0.75]) {
            near(depth(&mut c, x, 2), if reversed { 1.0 - wanted } else { wanted });
        }
    }
    // What is clamped is what is tested.
    let mut c = prepared();
    c.enable(GL_DEPTH_CLAMP);
    c.depth_func(GL_LESS);
    draw(&mut c, GL_QUADS, [3.0; 2]);
    assert_eq!(pixel(&mut c, 1, 1), [0; 4]);
    c.depth_func(GL_GREATER);
    draw(&mut c, GL_QUADS, [3.0; 2]);
    assert_eq!(pixel(&mut c, 1, 1), [255; 4]);
}

#[test]
fn raster_positions_selection_and_feedback_follow() {
    let mut c = prepared();
    c.raster_pos_3f(0.0, 0.0, 2.0);
    let mut valid = [9];
    c.get_integerv(GL_CURRENT_RASTER_POSITION_VALID, &mut valid);
    assert_eq!(valid, [0]);
    c.enable(GL_DEPTH_CLAMP);
    c.raster_pos_3f(0.0, 0.0, 2.0);
    let mut position = [0.0; 4];
    c.get_floatv(GL_CURRENT_RASTER_POSITION, &mut position);
    assert_eq!(position, [2.0, 2.0, 0.75, 1.0]);
    c.feedback_buffer(64, GL_3D, DataOut::Null);
    c.render_mode(GL_FEEDBACK);
    draw(&mut c, GL_LINES, [-3.0, 0.0]);
    c.render_mode(GL_RENDER);
    let line = GL_LINE_RESET_TOKEN as f32;
    assert_eq!(c.feedback(), [line, 0.0, 1.5, 0.25, 4.0, 1.5, 0.5]);
    fine(&mut c);
}
