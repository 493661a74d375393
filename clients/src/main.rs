//! Plain GL 2 clients draw into one picture: `speedy2d` a drawing, `egui` a window over it. The
//! functions of the crate `gl` read the picture.
//!
//! `cargo run --release --manifest-path clients/Cargo.toml -- picture.png`; `cargo test` compares
//! the picture with `picture.png`, bit by bit.

mod panel;
mod sketch;

use gl_api::{Context, ContextDesc};
use std::error::Error;

/// Width and height in pixels.
const SIZE: [u32; 2] = [480, 320];

/// Draws the picture: rows of RGBA bytes, the highest first.
fn draw() -> Result<image::RgbaImage, Box<dyn Error>> {
    let [width, height] = SIZE;
    let _current =
        Context::new(ContextDesc { width, height, ..Default::default() })?.make_current();
    sketch::draw(SIZE)?;
    panel::draw(SIZE)?;
    let mut pixels = vec![0_u8; width as usize * height as usize * 4];
    gl::load_with(detgl::get_proc_address);
    // SAFETY: the addresses are those of the functions of these names, on the current context; there
    // is room for as many pixels as are read.
    let error = unsafe {
        let (width, height) = (width as i32, height as i32);
        let out = pixels.as_mut_ptr().cast();
        gl::BindFramebuffer(gl::FRAMEBUFFER, 0);
        gl::PixelStorei(gl::PACK_ALIGNMENT, 1);
        gl::ReadPixels(0, 0, width, height, gl::RGBA, gl::UNSIGNED_BYTE, out);
        gl::GetError()
    };
    assert_eq!(error, gl::NO_ERROR, "a client left a GL error; DETGL_DEBUG=1 says which");
    pixels.iter_mut().skip(3).step_by(4).for_each(|alpha| *alpha = 255);
    detgl_clients::picture(SIZE, pixels)
}

fn main() -> Result<(), Box<dyn Error>> {
    detgl_clients::save(&draw()?, "clients.png")
}

#[cfg(test)]
mod tests {
    #[test]
    fn both_clients_draw_the_same_bits_as_ever() {
        let golden = image::load_from_memory(include_bytes!("../picture.png"));
        let picture = super::draw().expect("both clients draw");
        assert!(picture == golden.expect("a picture").into_rgba8());
    }
}
