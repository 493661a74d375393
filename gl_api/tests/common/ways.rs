//! How calls follow one another: draws that wait for others must be as those that are carried out alone.

use gl_api::*;

/// How calls follow one another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// Everything is done before the next.
    Apart,
    Together,
}

impl Way {
    /// To be called after each call.
    pub fn go_on(self, c: &mut Context) {
        match self {
            Self::Apart => c.finish(),
            Self::Together => {}
        }
    }
}

/// The pixels of a square window, as bytes.
pub fn picture(c: &mut Context, side: u32) -> Vec<u8> {
    let mut picture = vec![0; (side * side * 4) as usize];
    let size = side as GLsizei;
    c.read_pixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut picture));
    picture
}
