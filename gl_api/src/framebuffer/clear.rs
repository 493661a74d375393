//! `glClear`: GL 2.1, section 4.2.3.

use super::complete::draw_pass;
use crate::constants::*;
use crate::context::Context;
use crate::draw;
use crate::error::{Result, invalid_value};
use crate::state::enable::Flag;
use crate::types::*;
use rasterizer::driver::{ClearValue, Command, DepthWrite, PassDesc, Rect};

/// The pixels that fragments reach: the attachments' area within the scissor rectangle.
fn clear_area(context: &Context, pass: &PassDesc) -> Rect {
    let all = Rect { x: 0, y: 0, width: pass.width, height: pass.height };
    if !context.state.enables.has(Flag::ScissorTest) {
        return all;
    }
    let scissor = context.state.fragment.scissor;
    let region =
        super::Region::new(scissor.x, scissor.y, scissor.width as usize, scissor.height as usize);
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

pub(crate) fn clear(context: &mut Context, mask: GLbitfield) -> Result<()> {
    let known =
        GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT;
    if mask & !known != 0 {
        return invalid_value(
            "GL 2.1, section 4.2.3",
            format!("mask = {mask:#x} has bits that name no buffer: {:#x}", mask & !known),
        );
    }
    let pass = draw_pass(context)?;
    let area = clear_area(context, &pass);
    if area.width == 0 || area.height == 0 {
        return Ok(());
    }
    let mut clears = Vec::new();
    if mask & GL_COLOR_BUFFER_BIT != 0 && context.state.fragment.color_mask.contains(&true) {
        for (target, color) in pass.colors.iter().enumerate() {
            if color.is_some() {
                let value = context.state.clear.color;
                let mask = context.state.fragment.color_mask;
                clears.push(ClearValue::Color { target: target as u8, value, mask });
            }
        }
    }
    if mask & GL_DEPTH_BUFFER_BIT != 0
        && pass.depth.is_some()
        && context.state.fragment.depth_write == DepthWrite::On
    {
        clears.push(ClearValue::Depth(context.state.clear.depth as f32));
    }
    if !clears.is_empty() {
        draw::begin_pass(context, pass);
        for value in clears {
            context.recorder.push(Command::Clear { value, area });
        }
    }
    Ok(())
}
