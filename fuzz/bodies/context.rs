//! A small context for random calls, and the check that it works after them.

use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc};
use std::sync::Arc;
use texunit::lanes::Isa;

/// A small context of a profile, with a short time limit for shaders.
pub fn context_of(api: Api) -> Context {
    let desc = DeviceDesc { budget: 20_000, ..DeviceDesc::new(Isa::best(), 2) };
    let device = Some(Arc::new(Device::new(desc).expect("threads start")));
    Context::new(ContextDesc { api, width: 40, height: 30, device, ..ContextDesc::default() })
        .expect("a small context")
}

/// Draws a white square over everything and reads it back.
pub fn still_works(c: &mut Context) {
    c.end();
    c.use_program(0);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    c.draw_buffer(GL_BACK);
    c.read_buffer(GL_BACK);
    c.color_mask(true, true, true, true);
    c.disable(GL_SCISSOR_TEST);
    c.clear_color(1.0, 1.0, 1.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    for (pname, value) in [
        (GL_PACK_ALIGNMENT, 1),
        (GL_PACK_ROW_LENGTH, 0),
        (GL_PACK_SKIP_ROWS, 0),
        (GL_PACK_SKIP_PIXELS, 0),
    ] {
        c.pixel_storei(pname, value);
    }
    while c.get_error() != GL_NO_ERROR {}
    let mut out = [0_u8; 40 * 30 * 4];
    c.read_pixels(0, 0, 40, 30, GL_RGBA, GL_UNSIGNED_BYTE, (&mut out).arg());
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    assert!(out.iter().all(|&b| b == 255));
}
