//! Drawing to several samples a pixel, resolved by a blit (GL 2.1, sections 3.2.1 and 4.1.3).

use super::{bytes, context, framebuffer, rectangle};
use gl_api::*;

/// A framebuffer of 4×4 pixels with four samples, cleared to black, bound.
fn multisampled(c: &mut Context) -> GLuint {
    let object = framebuffer(c);
    let mut name = [0];
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, GL_RGBA8, 4, 4);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name[0]);
    c.disable(GL_CULL_FACE);
    c.clear_color(0.0, 0.0, 0.0, 0.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    object
}

/// The lower row of what the samples resolve to, red only.
fn resolved(c: &mut Context, object: GLuint) -> Vec<u8> {
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
    c.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    let row = bytes(c, [0, 0, 4, 1], GL_RGBA, 4);
    c.bind_framebuffer(GL_FRAMEBUFFER, object);
    row.chunks(4).map(|texel| texel[0]).collect()
}

/// Fills the part of the target left of `x` pixels with white of this alpha.
fn fill(c: &mut Context, x: f32, alpha: f32) {
    let right = x / 2.0 - 1.0;
    c.clear(GL_COLOR_BUFFER_BIT);
    c.color_4f(1.0, 1.0, 1.0, alpha);
    rectangle(c, [-1.0, -1.0, right, 1.0], 0.0);
}

#[test]
fn edges_cover_the_samples_left_of_them() {
    let mut c = context(4, 4);
    let object = multisampled(&mut c);
    let mut value = [0];
    c.get_integerv(GL_SAMPLES, &mut value);
    assert_eq!(value, [4]);
    c.get_integerv(GL_SAMPLE_BUFFERS, &mut value);
    assert_eq!(value, [1]);
    for (x, second) in [(1.0, 0), (1.25, 64), (1.5, 128), (1.75, 191), (2.0, 255)] {
        fill(&mut c, x, 1.0);
        assert_eq!(resolved(&mut c, object), [255, second, 0, 0], "{x}");
    }
    c.disable(GL_MULTISAMPLE);
    for (x, second) in [(1.25, 0), (1.75, 255)] {
        fill(&mut c, x, 1.0);
        assert_eq!(resolved(&mut c, object), [255, second, 0, 0], "{x}");
    }
}

#[test]
fn alpha_and_the_coverage_value_choose_samples() {
    let mut c = context(4, 4);
    let object = multisampled(&mut c);
    c.enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    for (alpha, red) in [(0.0, 0), (0.25, 64), (0.5, 128), (0.75, 191), (1.0, 255)] {
        fill(&mut c, 4.0, alpha);
        assert_eq!(resolved(&mut c, object), [red; 4], "{alpha}");
    }
    c.disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    c.sample_coverage(0.25, true);
    fill(&mut c, 4.0, 0.5);
    assert_eq!(resolved(&mut c, object), [255; 4]);
    c.enable(GL_SAMPLE_COVERAGE);
    fill(&mut c, 4.0, 0.5);
    assert_eq!(resolved(&mut c, object), [191; 4]);
    c.disable(GL_MULTISAMPLE);
    fill(&mut c, 4.0, 0.5);
    assert_eq!(resolved(&mut c, object), [255; 4]);
}

#[test]
fn the_state_of_samples_is_kept_and_answered() {
    let mut c = context(4, 4);
    let mut value = [0.0];
    c.get_floatv(GL_SAMPLE_COVERAGE_VALUE, &mut value);
    assert_eq!(value, [1.0]);
    c.push_attrib(GL_MULTISAMPLE_BIT);
    c.enable(GL_SAMPLE_ALPHA_TO_ONE);
    c.sample_coverage(7.0, false);
    c.get_floatv(GL_SAMPLE_COVERAGE_VALUE, &mut value);
    assert_eq!(value, [1.0]);
    c.sample_coverage(0.5, true);
    c.get_floatv(GL_SAMPLE_COVERAGE_VALUE, &mut value);
    assert_eq!(value, [0.5]);
    c.get_floatv(GL_SAMPLE_COVERAGE_INVERT, &mut value);
    assert_eq!(value, [1.0]);
    assert!(c.is_enabled(GL_SAMPLE_ALPHA_TO_ONE));
    c.pop_attrib();
    c.get_floatv(GL_SAMPLE_COVERAGE_INVERT, &mut value);
    assert_eq!(value, [0.0]);
    assert!(!c.is_enabled(GL_SAMPLE_ALPHA_TO_ONE));
    assert_eq!(c.get_error(), GL_NO_ERROR);
}
