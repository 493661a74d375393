//! Framebuffer objects without attachments (`ARB_framebuffer_no_attachments`): what they are complete with, and that draws
//! to them have fragments.

use super::{ALL, context, fine, framebuffer, rectangle, renderbuffer};
use gl_api::*;

const FB: GLenum = GL_FRAMEBUFFER;

fn parameter(c: &mut Context, pname: GLenum) -> GLint {
    let mut value = [-7];
    c.get_framebuffer_parameteriv(FB, pname, &mut value);
    fine(c);
    value[0]
}

/// The samples that pass in a rectangle that fills the viewport.
fn passed(c: &mut Context) -> GLuint {
    c.begin_query(GL_SAMPLES_PASSED, 1);
    rectangle(c, ALL, 0.0);
    c.end_query(GL_SAMPLES_PASSED);
    let mut samples = [0];
    c.get_query_objectuiv(1, GL_QUERY_RESULT, &mut samples);
    fine(c);
    samples[0]
}

#[test]
fn sizes_make_them_complete_and_fragments_are_counted() {
    let mut c = context(4, 4);
    framebuffer(&mut c);
    for pname in [
        GL_FRAMEBUFFER_DEFAULT_WIDTH,
        GL_FRAMEBUFFER_DEFAULT_HEIGHT,
        GL_FRAMEBUFFER_DEFAULT_LAYERS,
        GL_FRAMEBUFFER_DEFAULT_SAMPLES,
        GL_FRAMEBUFFER_DEFAULT_FIXED_SAMPLE_LOCATIONS,
    ] {
        assert_eq!(parameter(&mut c, pname), 0);
    }
    c.framebuffer_parameteri(FB, GL_FRAMEBUFFER_DEFAULT_WIDTH, 30);
    assert_eq!(c.check_framebuffer_status(FB), GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
    c.messages();
    c.framebuffer_parameteri(FB, GL_FRAMEBUFFER_DEFAULT_HEIGHT, 7);
    assert_eq!(c.check_framebuffer_status(FB), GL_FRAMEBUFFER_COMPLETE);
    c.viewport(0, 0, 100, 100);
    assert_eq!(passed(&mut c), 30 * 7);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    // Samples count each; three become four.
    c.framebuffer_parameteri(FB, GL_FRAMEBUFFER_DEFAULT_SAMPLES, 3);
    c.framebuffer_parameteri(FB, GL_FRAMEBUFFER_DEFAULT_FIXED_SAMPLE_LOCATIONS, 5);
    assert_eq!(parameter(&mut c, GL_FRAMEBUFFER_DEFAULT_SAMPLES), 3);
    assert_eq!(parameter(&mut c, GL_FRAMEBUFFER_DEFAULT_FIXED_SAMPLE_LOCATIONS), 1);
    assert_eq!(parameter(&mut c, GL_SAMPLES), 4);
    assert_eq!(parameter(&mut c, GL_SAMPLE_BUFFERS), 1);
    assert_eq!(passed(&mut c), 4 * 30 * 7);
    // What is attached has sizes of its own.
    renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, GL_RGBA8, 2, 3);
    assert_eq!(parameter(&mut c, GL_SAMPLES), 0);
    assert_eq!(passed(&mut c), 2 * 3);
    assert_eq!(parameter(&mut c, GL_FRAMEBUFFER_DEFAULT_WIDTH), 30);
    fine(&mut c);
}

/// Also where samples are attached, and none of them is drawn to.
#[test]
fn samples_that_are_not_drawn_to_are_counted() {
    let mut c = context(4, 4);
    framebuffer(&mut c);
    c.bind_renderbuffer(GL_RENDERBUFFER, 9);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, GL_RGBA8, 5, 5);
    c.framebuffer_renderbuffer(FB, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 9);
    c.viewport(0, 0, 5, 5);
    assert_eq!(passed(&mut c), 100);
    c.draw_buffer(GL_NONE);
    assert_eq!(passed(&mut c), 100);
}

#[test]
fn the_default_framebuffer_answers_what_it_has() {
    let mut c = context(4, 4);
    for (pname, want) in [
        (GL_DOUBLEBUFFER, 0),
        (GL_STEREO, 0),
        (GL_SAMPLES, 0),
        (GL_SAMPLE_BUFFERS, 0),
        (GL_IMPLEMENTATION_COLOR_READ_FORMAT, GL_RGBA as i32),
        (GL_IMPLEMENTATION_COLOR_READ_TYPE, GL_UNSIGNED_BYTE as i32),
    ] {
        assert_eq!(parameter(&mut c, pname), want);
    }
    for (pname, least) in [
        (GL_MAX_FRAMEBUFFER_WIDTH, 1024),
        (GL_MAX_FRAMEBUFFER_HEIGHT, 1024),
        (GL_MAX_FRAMEBUFFER_LAYERS, 256),
        (GL_MAX_FRAMEBUFFER_SAMPLES, 4),
    ] {
        let mut value = [0];
        c.get_integerv(pname, &mut value);
        assert!(value[0] >= least, "{value:?}");
    }
    fine(&mut c);
}
