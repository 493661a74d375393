//! A small context for random calls, and the check that it works after them.

use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc};
use std::sync::Arc;
use texunit::lanes::Isa;

const WIDTH: u32 = 40;
const HEIGHT: u32 = 30;

/// A device whose shaders are stopped soon.
pub fn device(isa: Isa) -> DeviceDesc {
    DeviceDesc { budget: 20_000, ..DeviceDesc::new(isa, 2) }
}

/// A small context of a profile on a device of its own.
pub fn context_on(api: Api, desc: DeviceDesc) -> Context {
    let device = Some(Arc::new(Device::new(desc).expect("threads start")));
    Context::new(ContextDesc {
        api,
        width: WIDTH,
        height: HEIGHT,
        device,
        ..ContextDesc::default()
    })
    .expect("a small context")
}

/// A small context of a profile, with a short time limit for shaders.
pub fn context_of(api: Api) -> Context {
    context_on(api, device(Isa::best()))
}

/// The default framebuffer's picture. What was open between calls is not any more.
pub fn picture(c: &mut Context) -> Vec<u8> {
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    c.bind_buffer(GL_PIXEL_PACK_BUFFER, 0);
    c.read_buffer(GL_BACK);
    for (pname, value) in [
        (GL_PACK_ALIGNMENT, 1),
        (GL_PACK_ROW_LENGTH, 0),
        (GL_PACK_SKIP_ROWS, 0),
        (GL_PACK_SKIP_PIXELS, 0),
        (GL_PACK_SWAP_BYTES, 0),
    ] {
        c.pixel_storei(pname, value);
    }
    for transfer in [GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE] {
        c.pixel_transferf(transfer, 1.0);
    }
    for transfer in [GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_MAP_COLOR] {
        c.pixel_transferf(transfer, 0.0);
    }
    while c.get_error() != GL_NO_ERROR {}
    let mut out = vec![0_u8; (WIDTH * HEIGHT * 4) as usize];
    let [width, height] = [WIDTH, HEIGHT].map(|side| side as GLsizei);
    c.read_pixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut out));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    out
}

/// Draws white over everything and reads it back.
pub fn still_works(c: &mut Context) {
    c.end();
    c.use_program(0);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    c.draw_buffer(GL_BACK);
    // OpenGL ES has no other call.
    c.draw_buffers(1, &[GL_BACK]);
    c.disable(GL_FRAMEBUFFER_SRGB);
    c.color_mask(true, true, true, true);
    c.disable(GL_SCISSOR_TEST);
    c.disable(GL_RASTERIZER_DISCARD);
    c.clear_color(1.0, 1.0, 1.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    let messages = c.messages();
    let picture = picture(c);
    assert!(picture.iter().all(|&byte| byte == 255), "{:?}\n{messages:?}", &picture[..16]);
}
