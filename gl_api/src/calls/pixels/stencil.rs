//! Stencils, with depths or without, which go to the buffer without being tested: only scissor and
//! write masks count (GL 2.1, section 4.3.1; `EXT_packed_depth_stencil`).

use crate::base::error::Result;
use crate::calls::framebuffer::blit::update_attachment_texels;
use crate::context::Context;
use crate::context::window::format_of;
use crate::draw::completeness::draw_pass;
use crate::draw::pass::drawn_area;
use crate::draw::pixel_zoom::{CENTRE, Zoomed};
use crate::pixel::convert::Conversion;
use crate::pixel::scratch::scratch;
use crate::pixel::texel;
use rasterizer::driver::DepthWrite;
use texunit::format::Format;

/// The format of what is drawn to.
pub(crate) fn target(context: &Context) -> Result<Option<Format>> {
    Ok(draw_pass(context)?.depth.as_ref().and_then(format_of))
}

/// Draws a rectangle of texels of [`target`]'s format: their stencils through the write mask of front faces, and
/// their depths if `depth` says so.
pub(crate) fn draw(
    context: &mut Context,
    size: [usize; 2],
    texels: &[u8],
    depth: DepthWrite,
) -> Result<()> {
    let pass = draw_pass(context)?;
    let area = drawn_area(context, &pass);
    let (Some(to), true) = (pass.depth, context.state.raster_position.valid) else {
        return Ok(());
    };
    let Some(zoomed) = Zoomed::new(context, size, area, CENTRE) else { return Ok(()) };
    context.depth_stencil_copied();
    let mask = context.state.fragment.stencil.active().write_mask as u8;
    update_attachment_texels(context, &to, |level, first, _| {
        let (format, bytes, row_bytes) = (level.format, level.format.bytes(), level.row_bytes());
        for (y, &row) in (zoomed.origin[1] as usize..).zip(&zoomed.rows) {
            let from = &texels[row * size[0] * bytes..][..size[0] * bytes];
            let mut at = first + y * row_bytes + zoomed.origin[0] as usize * bytes;
            for run in zoomed.columns.chunk_by(|a, b| a + 1 == *b) {
                let used = run.len() * bytes;
                let out = &mut level.texels[at..at + used];
                texel::merge(format, depth, mask, &from[run[0] * bytes..][..used], out);
                at += used;
            }
        }
    })
}

/// Draws a rectangle of stencils, a byte each.
pub(crate) fn draw_stencils(
    context: &mut Context,
    size: [usize; 2],
    stencils: &[u8],
) -> Result<()> {
    let Some(to) = target(context)? else { return Ok(()) };
    let mut texels = scratch(to, [size[0], size[1], 1])?;
    Conversion::to_stencils(context.recorder.isa(), to).run(stencils, &mut texels);
    draw(context, size, &texels, DepthWrite::Off)
}
