//! Rasterization and multisampling: GL 2.1, tables 6.15 and 6.16.

use super::row::Read::*;
use super::row::{Row, doubles, rows, saturated};
use crate::base::constants::*;
use crate::state::points::ORIGIN;
use crate::state::polygon::POLYGON_MODE;
use crate::state::raster::{FACE, FRONT_FACE};

pub(super) const ROWS: &[Row] = rows! {
    GL_POINT_SIZE: Float(|c| c.state.raster.points.size);
    GL_POINT_SMOOTH: Enabled;
    GL_POINT_SPRITE: Enabled;
    GL_POINT_SIZE_MIN: Float(|c| c.state.raster.points.size_min);
    GL_POINT_SIZE_MAX: Float(|c| c.state.raster.points.size_max);
    GL_POINT_FADE_THRESHOLD_SIZE: Float(|c| c.state.raster.points.fade);
    GL_POINT_DISTANCE_ATTENUATION: Floats(|c| doubles(&c.state.raster.points.attenuation));
    GL_POINT_SPRITE_COORD_ORIGIN: Word(|c| ORIGIN.encode(c.state.raster.points.origin));

    GL_LINE_WIDTH: Float(|c| c.state.raster.line_width);
    GL_LINE_SMOOTH: Enabled;
    GL_LINE_STIPPLE: Enabled;
    GL_LINE_STIPPLE_REPEAT: Integer(|c| saturated(c.state.raster.stipple_factor));
    GL_LINE_STIPPLE_PATTERN: Integer(|c| saturated(c.state.raster.stipple_pattern));

    GL_CULL_FACE: Enabled;
    GL_CULL_FACE_MODE: Word(|c| FACE.encode(c.state.raster.cull));
    GL_FRONT_FACE: Word(|c| FRONT_FACE.encode(c.state.raster.front_face));
    GL_POLYGON_SMOOTH: Enabled;
    GL_POLYGON_MODE: Integers(|c| {
        c.state.raster.polygons.mode.map(|mode| POLYGON_MODE.encode(mode) as i32).to_vec()
    });
    GL_POLYGON_OFFSET_FACTOR: Float(|c| c.state.raster.polygons.offset_factor);
    GL_POLYGON_OFFSET_UNITS: Float(|c| c.state.raster.polygons.offset_units);
    GL_POLYGON_OFFSET_CLAMP: Float(|c| c.state.raster.polygons.offset_clamp);
    GL_POLYGON_OFFSET_POINT: Enabled;
    GL_POLYGON_OFFSET_LINE: Enabled;
    GL_POLYGON_OFFSET_FILL: Enabled;
    GL_POLYGON_STIPPLE: Enabled;
    GL_RASTERIZER_DISCARD: Enabled;

    GL_MULTISAMPLE: Enabled;
    GL_SAMPLE_ALPHA_TO_COVERAGE: Enabled;
    GL_SAMPLE_ALPHA_TO_ONE: Enabled;
    GL_SAMPLE_COVERAGE: Enabled;
    GL_SAMPLE_COVERAGE_VALUE: Float(|c| c.state.raster.multisample.value);
    GL_SAMPLE_COVERAGE_INVERT: Flag(|c| c.state.raster.multisample.invert);
    GL_SAMPLE_MASK: Enabled;
    GL_SAMPLE_SHADING_ARB: Enabled;
    GL_MIN_SAMPLE_SHADING_VALUE_ARB: Float(|c| c.state.raster.multisample.shaded);
};
