//! What the viewport and its depths mean to the driver.

use crate::context::Context;
use crate::state::enable::Flag;
use rasterizer::driver::DepthClip;

/// What the near and the far plane do (`ARB_depth_clamp`).
pub(crate) fn depth_clip(context: &Context) -> DepthClip {
    if context.state.enables.has(Flag::DepthClamp) { DepthClip::Clamp } else { DepthClip::Cut }
}
