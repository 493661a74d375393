//! The viewport transformation: GL 2.1, section 2.11.1.

use super::enable::Flag;
use crate::context::{Context, limits};
use crate::error::{Result, not_negative};
use crate::types::*;
use rasterizer::driver::DepthClip;

/// Where in the window normalized device coordinates lie.
#[derive(Clone, Debug)]
pub(crate) struct ViewportState {
    pub x: i32,
    pub y: i32,
    pub width: i32,
    pub height: i32,
    /// Window depth of the near and far planes, 0 to 1.
    pub depth: [f64; 2],
}

impl ViewportState {
    pub fn new(width: u32, height: u32) -> Self {
        Self { x: 0, y: 0, width: width as i32, height: height as i32, depth: [0.0, 1.0] }
    }
}

/// Sizes beyond `GL_MAX_VIEWPORT_DIMS` are clamped to it, and places to twice that.
pub(crate) fn viewport(
    context: &mut Context,
    x: GLint,
    y: GLint,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    const SECTION: &str = "GL 2.1, section 2.11.1";
    not_negative(SECTION, "width", width.into())?;
    not_negative(SECTION, "height", height.into())?;
    let limit = limits::MAX_VIEWPORT_DIMS as i32;
    let state = &mut context.state.viewport;
    state.x = x.clamp(-2 * limit, 2 * limit);
    state.y = y.clamp(-2 * limit, 2 * limit);
    state.width = width.min(limit);
    state.height = height.min(limit);
    Ok(())
}

pub(crate) fn depth_range(context: &mut Context, near: GLclampd, far: GLclampd) -> Result<()> {
    context.state.viewport.depth = [unit(near), unit(far)];
    Ok(())
}

pub(crate) fn depth_rangef(context: &mut Context, near: GLclampf, far: GLclampf) -> Result<()> {
    depth_range(context, near.into(), far.into())
}

/// Clamped to [0, 1]; NaN gives 0.
pub(crate) fn unit(value: f64) -> f64 {
    if value > 0.0 { value.min(1.0) } else { 0.0 }
}

/// What the near and the far plane do (`ARB_depth_clamp`).
pub(crate) fn depth_clip(context: &Context) -> DepthClip {
    if context.state.enables.has(Flag::DepthClamp) { DepthClip::Clamp } else { DepthClip::Cut }
}

/// A depth between those of the near and the far plane.
pub(crate) fn within(depth: f64, [near, far]: [f64; 2]) -> f64 {
    depth.max(near.min(far)).min(near.max(far))
}
