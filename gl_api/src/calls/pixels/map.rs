//! `glPixelMap` and `glGetPixelMap`: GL 2.1, sections 3.6.3 and 6.1.3, table 3.3.

use crate::base::args::{Data, DataOut};
use crate::base::constants::*;
use crate::base::convert::unit;
use crate::base::error::{Result, Table, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::calls::pixels::memory::{source, write_bytes};
use crate::context::Context;
use crate::pixel::map::{MAX_PIXEL_MAP_TABLE, PixelMap, PixelMapName};

const SECTION: &str = "GL 2.1, section 3.6.3";

const NAME: Table<PixelMapName> = Table {
    section: "GL 2.1, table 3.3",
    rows: &[
        (GL_PIXEL_MAP_I_TO_I, PixelMapName::IToI),
        (GL_PIXEL_MAP_S_TO_S, PixelMapName::SToS),
        (GL_PIXEL_MAP_I_TO_R, PixelMapName::IToR),
        (GL_PIXEL_MAP_I_TO_G, PixelMapName::IToG),
        (GL_PIXEL_MAP_I_TO_B, PixelMapName::IToB),
        (GL_PIXEL_MAP_I_TO_A, PixelMapName::IToA),
        (GL_PIXEL_MAP_R_TO_R, PixelMapName::RToR),
        (GL_PIXEL_MAP_G_TO_G, PixelMapName::GToG),
        (GL_PIXEL_MAP_B_TO_B, PixelMapName::BToB),
        (GL_PIXEL_MAP_A_TO_A, PixelMapName::AToA),
    ],
};

/// How a call has the entries: bytes of each, from bytes to a number, and back.
struct Entry {
    bytes: usize,
    /// What stands for 1 in tables of colours.
    one: f64,
    read: fn(&[u8]) -> f64,
    write: fn(f64, &mut [u8]),
}

const FLOATS: Entry = Entry {
    bytes: 4,
    one: 1.0,
    read: |b| f32::from_ne_bytes([b[0], b[1], b[2], b[3]]).into(),
    write: |value, out| out.copy_from_slice(&(value as f32).to_ne_bytes()),
};
const UINTS: Entry = Entry {
    bytes: 4,
    one: u32::MAX as f64,
    read: |b| u32::from_ne_bytes([b[0], b[1], b[2], b[3]]).into(),
    write: |value, out| out.copy_from_slice(&(value.round_ties_even() as u32).to_ne_bytes()),
};
const USHORTS: Entry = Entry {
    bytes: 2,
    one: u16::MAX as f64,
    read: |b| u16::from_ne_bytes([b[0], b[1]]).into(),
    write: |value, out| out.copy_from_slice(&(value.round_ties_even() as u16).to_ne_bytes()),
};

fn set(
    context: &mut Context,
    map: GLenum,
    mapsize: GLsizei,
    entry: &Entry,
    values: Data<'_>,
) -> Result<()> {
    let name = NAME.decode("map", map)?;
    let size = usize::try_from(mapsize).unwrap_or(0);
    if !(1..=MAX_PIXEL_MAP_TABLE).contains(&size) {
        return invalid_value(
            SECTION,
            format!("mapsize = {mapsize} must be 1 to {MAX_PIXEL_MAP_TABLE}"),
        );
    }
    if name.is_indexed() && !size.is_power_of_two() {
        return invalid_value(
            SECTION,
            format!("mapsize = {mapsize} of {} must be a power of two", enum_name(map)),
        );
    }
    let needed = size * entry.bytes;
    let Some(source) = source(context, values, needed)? else {
        return invalid_operation(SECTION, "values must not be NULL");
    };
    let Some(bytes) = source.bytes().get(..needed) else {
        return invalid_operation(
            SECTION,
            format!("mapsize = {size} entries take {needed} bytes: values has fewer"),
        );
    };
    let mut table = PixelMap { size: size as u16, ..PixelMap::default() };
    for (to, bytes) in table.entries.iter_mut().zip(bytes.chunks_exact(entry.bytes)) {
        let value = (entry.read)(bytes);
        *to = if name.has_indices() { value } else { unit(value / entry.one) } as f32;
    }
    context.state.transfer.maps.0[name as usize] = table;
    Ok(())
}

fn get(context: &mut Context, map: GLenum, entry: &Entry, values: DataOut<'_>) -> Result<()> {
    let name = NAME.decode("map", map)?;
    let table = *context.state.transfer.maps.map(name);
    let scale = if name.has_indices() { 1.0 } else { entry.one };
    write_bytes(context, values, table.entries().len() * entry.bytes, |out| {
        for (out, value) in out.chunks_exact_mut(entry.bytes).zip(table.entries()) {
            (entry.write)(f64::from(*value) * scale, out);
        }
    })
}

pub(crate) fn pixel_mapfv(
    context: &mut Context,
    map: GLenum,
    mapsize: GLsizei,
    values: Data<'_>,
) -> Result<()> {
    set(context, map, mapsize, &FLOATS, values)
}

pub(crate) fn pixel_mapuiv(
    context: &mut Context,
    map: GLenum,
    mapsize: GLsizei,
    values: Data<'_>,
) -> Result<()> {
    set(context, map, mapsize, &UINTS, values)
}

pub(crate) fn pixel_mapusv(
    context: &mut Context,
    map: GLenum,
    mapsize: GLsizei,
    values: Data<'_>,
) -> Result<()> {
    set(context, map, mapsize, &USHORTS, values)
}

pub(crate) fn get_pixel_mapfv(
    context: &mut Context,
    map: GLenum,
    values: DataOut<'_>,
) -> Result<()> {
    get(context, map, &FLOATS, values)
}

pub(crate) fn get_pixel_mapuiv(
    context: &mut Context,
    map: GLenum,
    values: DataOut<'_>,
) -> Result<()> {
    get(context, map, &UINTS, values)
}

pub(crate) fn get_pixel_mapusv(
    context: &mut Context,
    map: GLenum,
    values: DataOut<'_>,
) -> Result<()> {
    get(context, map, &USHORTS, values)
}
