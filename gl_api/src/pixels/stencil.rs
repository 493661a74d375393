//! Stencils, with depths or without, which go to the buffer without being tested: only scissor and
//! write masks count (GL 2.1, section 4.3.1; `EXT_packed_depth_stencil`).

use super::zoom::Zoomed;
use crate::context::Context;
use crate::error::Result;
use crate::framebuffer::blit::edit;
use crate::framebuffer::clear::drawn_area;
use crate::framebuffer::complete::draw_pass;
use crate::framebuffer::format_of;
use crate::texture::transfer::Transfer;
use crate::texture::{convert, texel};
use rasterizer::driver::DepthWrite;
use texunit::format::Format;

/// Changes every texel of the depth buffer that a rectangle at the raster position covers.
fn each_texel(
    context: &mut Context,
    size: [usize; 2],
    change: impl Fn(Format, &mut [u8], usize, usize),
) -> Result<()> {
    let pass = draw_pass(context)?;
    let area = drawn_area(context, &pass);
    let (Some(depth), true) = (pass.depth, context.state.raster_position.valid) else {
        return Ok(());
    };
    let Some(zoomed) = Zoomed::new(context, size, area) else { return Ok(()) };
    edit(context, &depth, |level, first, _| {
        let (format, size, row_bytes) = (level.format, level.format.bytes(), level.row_bytes());
        for (y, &row) in (zoomed.origin[1] as usize..).zip(&zoomed.rows) {
            let start = first + y * row_bytes + zoomed.origin[0] as usize * size;
            let texels = level.texels[start..].chunks_exact_mut(size);
            for (texel, &column) in texels.zip(&zoomed.columns) {
                change(format, texel, column, row);
            }
        }
    });
    Ok(())
}

/// A stencil through the write mask of front faces.
fn put(format: Format, texel: &mut [u8], value: u8, mask: u8) {
    let old = texel::stencil_of(format, texel);
    texel::put_stencil(format, texel, value & mask | old & !mask);
}

fn write_mask(context: &Context) -> u8 {
    context.state.fragment.stencil.active().write_mask as u8
}

/// Draws a rectangle of stencils.
pub(super) fn draw(
    context: &mut Context,
    size: [usize; 2],
    stencil: impl Fn(usize, usize) -> u8,
) -> Result<()> {
    let mask = write_mask(context);
    each_texel(context, size, |format, texel, x, y| put(format, texel, stencil(x, y), mask))
}

/// Draws a rectangle of depths and stencils, texels of [`Format::D32FS8`].
pub(super) fn draw_with_depth(
    context: &mut Context,
    size: [usize; 2],
    texels: &[u8],
) -> Result<()> {
    let Some(to) = draw_pass(context)?.depth.as_ref().and_then(format_of) else { return Ok(()) };
    let (mask, isa) = (write_mask(context), context.recorder.isa());
    let texels = convert::transcode(isa, Format::D32FS8, texels, to, &Transfer::default());
    let writes_depth = context.state.fragment.depth_write == DepthWrite::On;
    each_texel(context, size, |format, texel, x, y| {
        let source = &texels[(y * size[0] + x) * to.bytes()..][..to.bytes()];
        if writes_depth {
            texel::copy_depth(format, source, texel);
        }
        put(format, texel, texel::stencil_of(format, source), mask);
    })
}
