//! Colouring and lighting: GL 2.1, tables 6.12 to 6.14, and the clamping of colours (`ARB_color_buffer_float`).

use super::row::Read::*;
use super::row::{Row, doubles, rows};
use crate::base::constants::*;
use crate::calls::fragment::clamp::WHEN;
use crate::state::fog::{FOG_MODE, FOG_SOURCE};
use crate::state::light::COLOR_CONTROL;
use crate::state::material::{FACES, TRACKED};
use crate::state::raster::{PROVOKING, SHADE_MODEL};

pub(super) const ROWS: &[Row] = rows! {
    GL_FOG: Enabled;
    GL_FOG_MODE: Word(|c| FOG_MODE.encode(c.state.fog.mode));
    GL_FOG_DENSITY: Float(|c| c.state.fog.density);
    GL_FOG_START: Float(|c| c.state.fog.start);
    GL_FOG_END: Float(|c| c.state.fog.end);
    GL_FOG_INDEX: Float(|c| c.state.fog.index);
    GL_FOG_COLOR: Fractions(|c| {
        doubles(&crate::draw::color_clamp::of_fragments(c).color(c.state.fog.color))
    });
    GL_FOG_COORD_SRC: Word(|c| FOG_SOURCE.encode(c.state.fog.source));
    GL_COLOR_SUM: Enabled;
    GL_SHADE_MODEL: Word(|c| SHADE_MODEL.encode(c.state.raster.shade_model));
    GL_PROVOKING_VERTEX: Word(|c| PROVOKING.encode(c.state.raster.provoking));
    GL_QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION: Flag(|_| true);
    GL_CLAMP_VERTEX_COLOR: Word(|c| WHEN.encode(c.state.clamp.vertex));

    GL_LIGHTING: Enabled;
    GL_COLOR_MATERIAL: Enabled;
    GL_COLOR_MATERIAL_FACE: Word(|c| FACES.encode(c.state.materials.faces));
    GL_COLOR_MATERIAL_PARAMETER: Word(|c| TRACKED.encode(c.state.materials.tracked));
    GL_LIGHT_MODEL_AMBIENT: Fractions(|c| doubles(&c.state.lights.model.ambient));
    GL_LIGHT_MODEL_LOCAL_VIEWER: Flag(|c| c.state.lights.model.local_viewer);
    GL_LIGHT_MODEL_TWO_SIDE: Flag(|c| c.state.lights.model.two_side);
    GL_LIGHT_MODEL_COLOR_CONTROL: Word(|c| COLOR_CONTROL.encode(c.state.lights.model.color_control));
    GL_LIGHT0: Enabled;
    GL_LIGHT1: Enabled;
    GL_LIGHT2: Enabled;
    GL_LIGHT3: Enabled;
    GL_LIGHT4: Enabled;
    GL_LIGHT5: Enabled;
    GL_LIGHT6: Enabled;
    GL_LIGHT7: Enabled;
};
