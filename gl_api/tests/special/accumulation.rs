//! The accumulation buffer: GL 2.1, section 4.2.4.

use super::{context, fine, pixel};
use gl_api::*;

fn fill(c: &mut Context, [r, g, b]: [f32; 3]) {
    c.clear_color(r, g, b, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
}

#[test]
fn two_pictures_become_their_mean() {
    let mut c = context(4, 4);
    fill(&mut c, [1.0, 0.0, 0.2]);
    c.accum(GL_LOAD, 0.5);
    fill(&mut c, [0.0, 1.0, 0.2]);
    c.accum(GL_ACCUM, 0.5);
    c.accum(GL_RETURN, 1.0);
    assert_eq!(pixel(&mut c, 1, 2), [128, 128, 51, 255]);
    c.accum(GL_MULT, 2.0);
    c.accum(GL_ADD, -0.6);
    c.accum(GL_RETURN, 1.0);
    assert_eq!(pixel(&mut c, 3, 3), [102, 102, 0, 255], "clamped when it is given back");
}

#[test]
fn scissor_mask_and_clear_value_count() {
    let mut c = context(4, 4);
    c.clear_accum(0.5, -2.0, 0.25, 1.0);
    c.clear(GL_ACCUM_BUFFER_BIT);
    c.enable(GL_SCISSOR_TEST);
    c.scissor(0, 0, 2, 4);
    c.color_mask(true, true, false, true);
    c.accum(GL_RETURN, 1.0);
    assert_eq!(pixel(&mut c, 1, 1), [128, 0, 0, 255]);
    assert_eq!(pixel(&mut c, 2, 1), [0; 4]);
    let mut value = [0.0; 4];
    c.get_floatv(GL_ACCUM_CLEAR_VALUE, &mut value);
    assert_eq!(value, [0.5, -1.0, 0.25, 1.0]);
    fine(&mut c);
}
