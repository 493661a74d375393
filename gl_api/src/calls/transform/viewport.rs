//! The viewport transformation: GL 2.1, section 2.11.1.

use crate::base::convert::unit;
use crate::base::error::{Result, not_negative};
use crate::base::limits;
use crate::base::types::*;
use crate::context::Context;
use crate::state::clip::{CLIP_DEPTH, CLIP_ORIGIN};
use crate::state::viewport::Viewport;
use rasterizer::driver::ClipControl;

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
    let set = |state: &mut Viewport| {
        state.x = x.clamp(-2 * limit, 2 * limit) as f32;
        state.y = y.clamp(-2 * limit, 2 * limit) as f32;
        state.width = width.min(limit) as f32;
        state.height = height.min(limit) as f32;
    };
    context.change_plain(|state| &mut state.viewport, |viewports| viewports.change_all(set));
    Ok(())
}

pub(crate) fn depth_range(context: &mut Context, near: GLclampd, far: GLclampd) -> Result<()> {
    let set = |state: &mut Viewport| state.depth = [unit(near), unit(far)];
    context.change_plain(|state| &mut state.viewport, |viewports| viewports.change_all(set));
    Ok(())
}

pub(crate) fn depth_rangef(context: &mut Context, near: GLclampf, far: GLclampf) -> Result<()> {
    depth_range(context, near.into(), far.into())
}

pub(crate) fn clip_control(context: &mut Context, origin: GLenum, depth: GLenum) -> Result<()> {
    context.state.clip.control = ClipControl {
        origin: CLIP_ORIGIN.decode("origin", origin)?,
        depth: CLIP_DEPTH.decode("depth", depth)?,
    };
    Ok(())
}
