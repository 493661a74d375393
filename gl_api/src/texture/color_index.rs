//! Pixels that are colour indices: shifted, offset and looked up, which makes colours of them
//! before anything else happens (GL 2.1, section 3.6.4: conversion to RGBA).

use super::client::Pixel;
use super::convert;
use super::layout::{Extent, Layout};
use super::memory;
use crate::constants::*;
use crate::context::Context;
use crate::entry::Data;
use crate::error::{Result, not_negative};
use crate::pixels::bitmap::Bits;
use crate::state::pixel_store::PixelStore;
use crate::texture::transfer::Transfer;
use crate::types::*;
use texunit::format::Format;

const SECTION: &str = "GL 2.1, section 3.6.4";

/// The indices of a rectangle or volume, or `None` for a null pointer.
fn indices(
    context: &Context,
    size: [usize; 3],
    extent: Extent,
    ty: GLenum,
    data: Data<'_>,
) -> Result<Option<Vec<f32>>> {
    let [width, height, depth] = size;
    if ty == GL_BITMAP {
        let bits = Bits::new(&context.state.unpack, width, height)?;
        let Some(source) = memory::source(context, data, bits.needed())? else { return Ok(None) };
        let bytes = bits.checked(source.bytes(), [width, height])?;
        let rows = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let index = |(x, y)| f32::from(u8::from(bits.at(bytes, x, y)));
        return Ok(Some(rows.map(index).collect()));
    }
    // A stencil is laid out as a colour index is: one number as it is.
    let pixel = Pixel::new(GL_STENCIL_INDEX, ty)?;
    let layout = Layout::new(&context.state.unpack, pixel, size, extent)?;
    let Some(source) = memory::pixel_source(context, &layout, data)? else { return Ok(None) };
    let mut texels = super::sub::room(Format::R32F, [width, height, depth])?;
    let as_they_are = Transfer::default();
    convert::unpack(&layout, source.bytes(), Format::R32F, &as_they_are, &mut texels);
    Ok(Some(texels.as_chunks::<4>().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect()))
}

/// Runs a call with colours in the place of indices: as `GL_RGBA` and `GL_FLOAT`, which lie without
/// gaps and pass as they are.
///
/// # Errors
/// Those of the call, and where the indices are not all there.
pub(crate) fn with_colors(
    context: &mut Context,
    size: [GLsizei; 3],
    extent: Extent,
    ty: GLenum,
    data: Data<'_>,
    call: impl FnOnce(&mut Context, Data<'_>) -> Result<()>,
) -> Result<()> {
    let [width, height, depth] = size;
    let size = [
        not_negative(SECTION, "width", width.into())?,
        not_negative(SECTION, "height", height.into())?,
        not_negative(SECTION, "depth", depth.into())?,
    ];
    let Some(indices) = indices(context, size, extent, ty, data)? else {
        return call(context, Data::Null);
    };
    let transfer = context.state.transfer;
    let colors: Vec<[f32; 4]> =
        indices.into_iter().map(|index| transfer.color_of_index(index.into())).collect();
    let state = &mut context.state;
    let unpack = std::mem::take(&mut state.unpack);
    let transfer = std::mem::take(&mut state.transfer);
    let buffer = std::mem::take(&mut state.bindings.pixel_unpack_buffer);
    state.unpack = PixelStore { alignment: 4, ..PixelStore::default() };
    let result = call(context, Data::Bytes(bytemuck::cast_slice(&colors)));
    context.state.unpack = unpack;
    context.state.transfer = transfer;
    context.state.bindings.pixel_unpack_buffer = buffer;
    result
}
