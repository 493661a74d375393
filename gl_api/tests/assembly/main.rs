//! Assembly programs: what they compute, what they read, how they stand beside other stages, and
//! what does not load.

mod instructions;
mod objects;
mod stages;
mod state;
mod texts;

use gl_api::*;

/// What vertices and fragments do with a result in texture coordinates.
const PASS: &str = "!!ARBfp1.0\nMOV result.color, fragment.texcoord[0];\nEND\n";

fn context() -> Context {
    let desc = ContextDesc { width: 4, height: 4, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    // Numbers beyond [0, 1] come back as they are.
    c.gen_framebuffers(1, &mut [0]);
    c.gen_renderbuffers(1, &mut [0]);
    c.bind_renderbuffer(GL_RENDERBUFFER, 1);
    c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA32F, 4, 4);
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 1);
    assert_eq!(c.get_error(), GL_NO_ERROR);
    c
}

/// Loads a text into the program of its target and enables that.
#[track_caller]
fn load(c: &mut Context, text: &str) {
    let target =
        if text.starts_with("!!ARBvp") { GL_VERTEX_PROGRAM_ARB } else { GL_FRAGMENT_PROGRAM_ARB };
    c.program_string(target, GL_PROGRAM_FORMAT_ASCII_ARB, text.len() as GLsizei, text);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}\n{text}", c.messages());
    c.enable(target);
}

/// The first pixel of a rectangle over everything.
#[track_caller]
fn drawn(c: &mut Context) -> [f32; 4] {
    c.rectf(-1.0, -1.0, 1.0, 1.0);
    pixel(c)
}

#[track_caller]
fn pixel(c: &mut Context) -> [f32; 4] {
    let mut pixel = [f32::NAN; 4];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, (&mut pixel).arg());
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    pixel
}

/// Whether numbers are the same up to a few units in the last place.
fn near(a: [f32; 4], b: [f32; 4]) -> bool {
    a.iter().zip(b).all(|(a, b)| *a == b || (a - b).abs() <= 4e-6 * b.abs())
}
