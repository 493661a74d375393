//! The part of an attachment that scissor and window leave.

use crate::context::Context;
use crate::state::enable::Flag;
use rasterizer::driver::{PassDesc, Rect};

/// The pixels that fragments reach: the attachments' area within the scissor rectangle.
pub(crate) fn drawn_area(context: &Context, pass: &PassDesc) -> Rect {
    let all = Rect { x: 0, y: 0, width: pass.width, height: pass.height };
    if !context.state.enables.has(Flag::ScissorTest) {
        return all;
    }
    let scissor = context.state.fragment.scissor;
    let region = crate::context::window::Region::new(
        scissor.x,
        scissor.y,
        scissor.width as usize,
        scissor.height as usize,
    );
    match region.within(pass.width, pass.height) {
        Some(visible) => Rect {
            x: visible.x as i32,
            y: visible.y as i32,
            width: visible.width as u32,
            height: visible.height as u32,
        },
        None => Rect { x: 0, y: 0, width: 0, height: 0 },
    }
}
