//! The calls of lines and of what all primitives have: culling, shading model, provoking vertex, hints (GL 2.1, sections
//! 2.14.1, 2.14.7, 3.4, 3.5.1 and 5.6).

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_value};
use crate::base::types::*;
use crate::context::Context;
use crate::state::multisample::Multisample;
use crate::state::points::Points;
use crate::state::polygon::Polygons;
use crate::state::raster::{
    FACE, FRONT_FACE, HINTS, PROVOKING, RasterState, SHADE_MODEL, positive,
};
use rasterizer::driver::{Cull, FrontFace, Provoking};
use rasterizer::ir::Interpolation;

impl Default for RasterState {
    fn default() -> Self {
        Self {
            cull: Cull::Back,
            front_face: FrontFace::Ccw,
            shade_model: Interpolation::Smooth,
            provoking: Provoking::Last,
            line_width: 1.0,
            stipple_factor: 1,
            stipple_pattern: !0,
            points: Points::default(),
            polygons: Polygons::default(),
            multisample: Multisample::default(),
            hints: [GL_DONT_CARE; HINTS.rows.len()],
        }
    }
}

const HINT_MODE: Table<GLenum> = Table {
    section: "GL 2.1, section 5.6",
    rows: &[(GL_FASTEST, GL_FASTEST), (GL_NICEST, GL_NICEST), (GL_DONT_CARE, GL_DONT_CARE)],
};

pub(crate) fn cull_face(context: &mut Context, mode: GLenum) -> Result<()> {
    let mode = FACE.decode("mode", mode)?;
    context.set_plain(|state| &mut state.raster.cull, mode);
    Ok(())
}

pub(crate) fn front_face(context: &mut Context, mode: GLenum) -> Result<()> {
    let mode = FRONT_FACE.decode("mode", mode)?;
    context.set_plain(|state| &mut state.raster.front_face, mode);
    Ok(())
}

pub(crate) fn shade_model(context: &mut Context, mode: GLenum) -> Result<()> {
    let mode = SHADE_MODEL.decode("mode", mode)?;
    context.set_plain(|state| &mut state.raster.shade_model, mode);
    Ok(())
}

pub(crate) fn provoking_vertex(context: &mut Context, mode: GLenum) -> Result<()> {
    context.state.raster.provoking = PROVOKING.decode("mode", mode)?;
    Ok(())
}

pub(crate) fn line_width(context: &mut Context, width: GLfloat) -> Result<()> {
    let width = positive("GL 2.1, section 3.4", "width", width)?;
    if width > 1.0 && !context.profile.has_wide_lines() {
        let rule = format!(
            "width = {width} must be at most 1: forward-compatible contexts have no wide lines; draw triangles"
        );
        return invalid_value("GL 3.3, appendix E.2.1", rule);
    }
    context.set_plain(|state| &mut state.raster.line_width, width);
    Ok(())
}

pub(crate) fn line_stipple(context: &mut Context, factor: GLint, pattern: GLushort) -> Result<()> {
    let raster = &mut context.state.raster;
    raster.stipple_factor = factor.clamp(1, 256) as u16;
    raster.stipple_pattern = pattern;
    Ok(())
}

pub(crate) fn hint(context: &mut Context, target: GLenum, mode: GLenum) -> Result<()> {
    let index = HINTS.decode("target", target)?;
    context.state.raster.hints[index] = HINT_MODE.decode("mode", mode)?;
    // No draw depends on a hint.
    context.state_changes.no_change();
    Ok(())
}
