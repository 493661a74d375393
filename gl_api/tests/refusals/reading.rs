//! What reading from framebuffers refuses where there is nothing to read.

use super::framebuffers::{framebuffer, renderbuffer};
use gl_api::*;

/// The preparation, the call, the error flag that it must set, and words that its message must have.
type Case = (fn(&mut Context), fn(&mut Context), GLenum, &'static str);

const C0: GLenum = GL_COLOR_ATTACHMENT0;

/// Reads a pixel of a format.
fn pixel(c: &mut Context, format: GLenum) {
    c.read_pixels(0, 0, 1, 1, format, GL_FLOAT, DataOut::Bytes(&mut [0; 16]));
}

const CASES: &[Case] = &[
    (
        |c| {
            framebuffer(c);
            renderbuffer(c, C0 + 2, GL_RGBA8, 2, 2);
            c.read_buffer(C0 + 1);
        },
        |c| pixel(c, GL_RGBA),
        GL_INVALID_OPERATION,
        "framebuffer 1 reads GL_COLOR_ATTACHMENT1, where nothing is attached: call \
         glReadBuffer(GL_COLOR_ATTACHMENT2)",
    ),
    (
        |c| {
            framebuffer(c);
            renderbuffer(c, C0, GL_RGBA8, 2, 2);
            c.read_buffer(GL_NONE);
        },
        |c| pixel(c, GL_RGBA),
        GL_INVALID_OPERATION,
        "framebuffer 1 reads GL_NONE: call glReadBuffer(GL_COLOR_ATTACHMENT0)",
    ),
    (
        |c| c.read_buffer(GL_NONE),
        |c| pixel(c, GL_RGBA),
        GL_INVALID_OPERATION,
        "reads GL_NONE: call glReadBuffer(GL_BACK)",
    ),
    (
        |c| {
            framebuffer(c);
            renderbuffer(c, C0, GL_RGBA8, 2, 2);
        },
        |c| pixel(c, GL_DEPTH_COMPONENT),
        GL_INVALID_OPERATION,
        "framebuffer 1, which is read from, has nothing attached to GL_DEPTH_ATTACHMENT",
    ),
];

/// Runs the rows.
pub fn run() {
    for (row, (prepare, call, flag, words)) in CASES.iter().enumerate() {
        let mut c = super::context();
        prepare(&mut c);
        super::row(&mut c, format!("reading {row}"), call, *flag, words);
    }
}
