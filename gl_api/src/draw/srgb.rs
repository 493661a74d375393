//! Framebuffers: what is drawn to and read from (GL 2.1, chapter 4; framebuffer objects).

use crate::context::Context;
use crate::state::enable::Flag;
use rasterizer::driver::SrgbWrite;

/// What is written to attachments of an sRGB format.
pub(crate) fn srgb_write(context: &Context) -> SrgbWrite {
    if context.state.enables.has(Flag::FramebufferSrgb) {
        SrgbWrite::Encode
    } else {
        SrgbWrite::AsIs
    }
}
