//! The calls of polygons (mode, offset, stipple) and `glEdgeFlag`: GL 2.1, sections 2.6.2 and 3.5.

use crate::base::args::{Data, DataOut};
use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum, invalid_operation};
use crate::base::types::*;
use crate::calls::vertex::immediate::attribute;
use crate::context::Context;
use crate::context::immediate::Slot;
use crate::interface::ATTRIB_EDGE_FLAG;
use crate::pixel::store::PixelStore;
use crate::state::polygon::POLYGON_MODE;
use crate::state::raster::FACE;
use rasterizer::driver::Cull;

pub(crate) fn polygon_mode(context: &mut Context, face: GLenum, mode: GLenum) -> Result<()> {
    if context.profile.is_core() && face != GL_FRONT_AND_BACK {
        let rule = format!(
            "face = {} must be GL_FRONT_AND_BACK: separate modes were removed from core profiles",
            enum_name(face)
        );
        return invalid_enum("GL 3.3, appendix E.2.2", rule);
    }
    let face = FACE.decode("face", face)?;
    let mode = POLYGON_MODE.decode("mode", mode)?;
    let [front, back] = &mut context.state.raster.polygons.mode;
    match face {
        Cull::Front => *front = mode,
        Cull::Back => *back = mode,
        Cull::Both => (*front, *back) = (mode, mode),
        Cull::None => {}
    }
    Ok(())
}

pub(crate) fn polygon_offset(context: &mut Context, factor: GLfloat, units: GLfloat) -> Result<()> {
    polygon_offset_clamp(context, factor, units, 0.0)
}

/// `ARB_polygon_offset_clamp`: a clamp that is no number bounds nothing.
pub(crate) fn polygon_offset_clamp(
    context: &mut Context,
    factor: GLfloat,
    units: GLfloat,
    clamp: GLfloat,
) -> Result<()> {
    let polygons = &mut context.state.raster.polygons;
    (polygons.offset_factor, polygons.offset_units) = (factor, units);
    polygons.offset_clamp = clamp;
    Ok(())
}

const STIPPLE: &str = "GL 2.1, section 3.5.2";

/// Where pixel `x` of row `y` of a 32×32 bitmap lies: its byte, and its bit in it (GL 2.1, section
/// 3.6.4).
fn bit_of(store: &PixelStore, x: usize, y: usize) -> (usize, u32) {
    let per_row = if store.row_length > 0 { store.row_length } else { 32 };
    let stride = per_row.div_ceil(8).next_multiple_of(store.alignment);
    let x = store.skip_pixels + x;
    let bit = (x % 8) as u32;
    ((store.skip_rows + y) * stride + x / 8, if store.lsb_first { bit } else { 7 - bit })
}

pub(crate) fn polygon_stipple(context: &mut Context, mask: Data<'_>) -> Result<()> {
    let needed = bit_of(&context.state.unpack, 31, 31).0 + 1;
    let Some(source) = crate::calls::pixels::memory::source(context, mask, needed)? else {
        return invalid_operation(STIPPLE, "mask must be 32 rows of 32 bits, not NULL");
    };
    let (bytes, store) = (source.bytes(), &context.state.unpack);
    if bytes.len() < needed {
        return invalid_operation(
            STIPPLE,
            format!("mask has {} of {needed} bytes of 32 rows of 32 bits", bytes.len()),
        );
    }
    let mut rows = [0; 32];
    for (y, row) in rows.iter_mut().enumerate() {
        for x in 0..32 {
            let (byte, bit) = bit_of(store, x, y);
            *row |= u32::from(bytes[byte] >> bit & 1) << (31 - x);
        }
    }
    context.state.raster.polygons.stipple = rows;
    Ok(())
}

pub(crate) fn get_polygon_stipple(context: &mut Context, mask: DataOut<'_>) -> Result<()> {
    let rows = context.state.raster.polygons.stipple;
    let store = context.state.pack.clone();
    let needed = bit_of(&store, 31, 31).0 + 1;
    crate::calls::pixels::memory::write_bytes(context, mask, needed, |bytes| {
        for (y, row) in rows.into_iter().enumerate() {
            for x in 0..32 {
                let (byte, bit) = bit_of(&store, x, y);
                let on = (row >> (31 - x) & 1) as u8;
                bytes[byte] = bytes[byte] & !(1 << bit) | on << bit;
            }
        }
    })
}

pub(crate) fn edge_flag(context: &mut Context, flag: bool) -> Result<()> {
    let value = f32::from(u8::from(flag));
    attribute(context, Slot::Location(ATTRIB_EDGE_FLAG), [value, 0.0, 0.0, 1.0])
}

pub(crate) fn edge_flagv(context: &mut Context, flag: &[GLboolean]) -> Result<()> {
    match flag.first() {
        Some(&flag) => edge_flag(context, flag != 0),
        None => invalid_operation("GL 2.1, section 2.6.2", "flag has none of 1 value"),
    }
}
