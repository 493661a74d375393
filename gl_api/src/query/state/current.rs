//! Current values and associated data: GL 2.1, table 6.5.

use super::row::Read::*;
use super::row::{Row, doubles, rows};
use crate::base::constants::*;
use crate::context::Context;
use crate::interface::*;

fn at(context: &Context, location: u8) -> &[f32; 4] {
    &context.state.current[usize::from(location)]
}

pub(super) const ROWS: &[Row] = rows! {
    GL_CURRENT_COLOR: Fractions(|c| doubles(at(c, ATTRIB_COLOR)));
    GL_CURRENT_SECONDARY_COLOR: Fractions(|c| doubles(at(c, ATTRIB_SECONDARY_COLOR)));
    // Colour index mode: kept and answered, without effect.
    GL_CURRENT_INDEX: Float(|c| at(c, ATTRIB_INDEX)[0]);
    GL_CURRENT_NORMAL: Fractions(|c| doubles(&at(c, ATTRIB_NORMAL)[..3]));
    GL_CURRENT_FOG_COORD: Float(|c| at(c, ATTRIB_FOG_COORD)[0]);
    GL_EDGE_FLAG: Flag(|c| at(c, ATTRIB_EDGE_FLAG)[0] != 0.0);
    GL_CURRENT_TEXTURE_COORDS: UnitFloats(|c| {
        let unit = c.state.units.active_coordinates("GL 2.1, section 2.7")?;
        Ok(doubles(at(c, ATTRIB_TEX_COORD + unit as u8)))
    });

    GL_CURRENT_RASTER_POSITION: Floats(|c| c.state.raster_position.window.to_vec());
    GL_CURRENT_RASTER_POSITION_VALID: Flag(|c| c.state.raster_position.valid);
    GL_CURRENT_RASTER_DISTANCE: Float(|c| c.state.raster_position.distance);
    GL_CURRENT_RASTER_COLOR: Fractions(|c| doubles(&c.state.raster_position.color));
    GL_CURRENT_RASTER_SECONDARY_COLOR:
        Fractions(|c| doubles(&c.state.raster_position.secondary_color));
    GL_CURRENT_RASTER_INDEX: Float(|c| c.state.raster_position.index);
    GL_CURRENT_RASTER_TEXTURE_COORDS: UnitFloats(|c| {
        let unit = c.state.units.active_coordinates("GL 2.1, section 2.13")?;
        Ok(doubles(&c.state.raster_position.tex_coords[unit]))
    });
};
