//! How long objects live that were deleted: GL 3.1, section 2.9 and appendix D.1. A name goes at once, and
//! so do the bindings of the context that deletes; what other contexts have bound, and containers that
//! are not bound, goes on with the object.

#[path = "../common/cpu_time.rs"]
mod cpu_time;
#[path = "../common/shading.rs"]
mod shading;

mod contexts;
mod kinds;
mod names;
mod programs;
mod vertex_arrays;

use gl_api::*;

const SIZE: u32 = 4;

fn desc() -> ContextDesc {
    ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() }
}

fn context() -> Context {
    Context::new(desc()).expect("a device")
}

/// A context that shares the objects of another.
fn sharing(c: &mut Context) -> Context {
    c.new_shared(desc()).expect("a context")
}

/// Nothing was refused.
#[track_caller]
fn fine(c: &mut Context) {
    let messages = c.messages();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{messages:?}");
}

/// What a number of state is.
#[track_caller]
fn integer(c: &mut Context, pname: GLenum) -> GLuint {
    let mut value = [0];
    c.get_integerv(pname, &mut value);
    fine(c);
    value[0] as GLuint
}

/// The colour that a draw gives all pixels.
#[track_caller]
fn color_of(c: &mut Context, draw: impl FnOnce(&mut Context)) -> [u8; 4] {
    c.clear_color(0.0, 0.0, 0.0, 0.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    draw(c);
    let mut pixels = [[0; 4]; (SIZE * SIZE) as usize];
    let size = SIZE as GLsizei;
    let out = DataOut::Bytes(pixels.as_flattened_mut());
    c.read_pixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, out);
    assert_eq!(pixels, [pixels[0]; (SIZE * SIZE) as usize]);
    fine(c);
    pixels[0]
}

/// The corners of the window.
const CORNERS: [f32; 8] = [-1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0];

/// Draws the whole window with immediate mode.
fn quad(c: &mut Context) {
    c.begin(GL_QUADS);
    for corner in CORNERS.chunks(2) {
        c.vertex_2f(corner[0], corner[1]);
    }
    c.end();
}
