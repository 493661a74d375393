//! Texture units and their environments: GL 2.1, sections 2.7, 3.8.12 and 3.8.13.

use crate::constants::*;
use crate::context::{Context, limits};
use crate::error::{Result, Table, invalid_operation};
use crate::interface::{MAX_COMBINED_TEXTURE_IMAGE_UNITS, MAX_TEXTURE_UNITS};
use crate::state::viewport::unit as clamp_unit;
use crate::texture::TextureTarget;
use crate::types::*;

const SECTION: &str = "GL 2.1, section 3.8.13";

/// What a unit does with the colour that comes from the unit before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Mode {
    Replace,
    Modulate,
    Decal,
    Blend,
    Add,
}

/// The modes that are implemented.
pub(crate) const MODE: Table<Mode> = Table {
    section: SECTION,
    rows: &[
        (GL_REPLACE, Mode::Replace),
        (GL_MODULATE, Mode::Modulate),
        (GL_DECAL, Mode::Decal),
        (GL_BLEND, Mode::Blend),
        (GL_ADD, Mode::Add),
    ],
};

/// One texture unit.
#[derive(Clone, Debug)]
pub(crate) struct Unit {
    /// By [`TextureTarget`]; of several, the last in its list wins (section 3.8.15).
    pub enabled: [bool; TextureTarget::COUNT],
    /// Texture names, by target.
    pub bound: [GLuint; TextureTarget::COUNT],
    /// The sampler object, whose state stands for the textures', or 0.
    pub sampler: GLuint,
    pub mode: Mode,
    pub color: [f32; 4],
    pub lod_bias: f32,
}

/// All units, and which one calls work on.
#[derive(Clone, Debug)]
pub(crate) struct Units {
    pub units: [Unit; MAX_COMBINED_TEXTURE_IMAGE_UNITS as usize],
    pub active: u8,
    pub client_active: u8,
}

impl Default for Units {
    fn default() -> Self {
        let unit = Unit {
            enabled: [false; TextureTarget::COUNT],
            bound: [0; TextureTarget::COUNT],
            sampler: 0,
            mode: Mode::Modulate,
            color: [0.0; 4],
            lod_bias: 0.0,
        };
        Self { units: std::array::from_fn(|_| unit.clone()), active: 0, client_active: 0 }
    }
}

impl Units {
    pub fn active(&self) -> &Unit {
        &self.units[usize::from(self.active)]
    }

    pub fn active_mut(&mut self) -> &mut Unit {
        &mut self.units[usize::from(self.active)]
    }

    /// The active unit as the number of a set of texture coordinates.
    ///
    /// # Errors
    /// `GL_INVALID_OPERATION` where the unit is for images alone (GL 2.1, section 2.11.2).
    pub fn active_coordinates(&self, section: &'static str) -> Result<usize> {
        if self.active < MAX_TEXTURE_UNITS {
            return Ok(self.active.into());
        }
        invalid_operation(
            section,
            format!(
                "the active unit GL_TEXTURE{} is for images alone: coordinates and matrices are of \
                 GL_TEXTURE0 to GL_TEXTURE{}",
                self.active,
                MAX_TEXTURE_UNITS - 1
            ),
        )
    }
}

/// What `glTexEnv` sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parameter {
    Mode,
    Color,
    LodBias,
    CoordReplace,
}

const ENV_PARAMETER: Table<Parameter> = Table {
    section: SECTION,
    rows: &[(GL_TEXTURE_ENV_MODE, Parameter::Mode), (GL_TEXTURE_ENV_COLOR, Parameter::Color)],
};

const FILTER_PARAMETER: Table<Parameter> =
    Table { section: "GL 2.1, section 3.8.8", rows: &[(GL_TEXTURE_LOD_BIAS, Parameter::LodBias)] };

const SPRITE_PARAMETER: Table<Parameter> =
    Table { section: "GL 2.1, section 3.3", rows: &[(GL_COORD_REPLACE, Parameter::CoordReplace)] };

fn parameter(target: GLenum, pname: GLenum) -> Result<Parameter> {
    const TARGET: Table<&Table<Parameter>> = Table {
        section: SECTION,
        rows: &[
            (GL_TEXTURE_ENV, &ENV_PARAMETER),
            (GL_TEXTURE_FILTER_CONTROL, &FILTER_PARAMETER),
            (GL_POINT_SPRITE, &SPRITE_PARAMETER),
        ],
    };
    TARGET.decode("target", target)?.decode("pname", pname)
}

impl PartialEq for Table<Parameter> {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.rows, other.rows)
    }
}

/// Sets a parameter from its first number, or from all four where it is a colour.
fn set(context: &mut Context, parameter: Parameter, first: f32, color: [f32; 4]) -> Result<()> {
    let unit = context.state.units.active_mut();
    match parameter {
        Parameter::Mode => unit.mode = MODE.decode("param", symbol(first))?,
        Parameter::Color => unit.color = color.map(|c| clamp_unit(c.into()) as f32),
        Parameter::LodBias => unit.lod_bias = lod_bias(first),
        Parameter::CoordReplace => {
            let on = COORD_REPLACE.decode("param", symbol(first))?;
            let bit = 1 << context.state.units.active;
            let replace = &mut context.state.raster.points.coord_replace;
            *replace = if on { *replace | bit } else { *replace & !bit };
        }
    }
    Ok(())
}

/// Whether a unit's coordinates are replaced, as a number.
const COORD_REPLACE: Table<bool> = Table {
    section: "GL 2.1, section 3.3",
    rows: &[(GL_FALSE as GLenum, false), (GL_TRUE as GLenum, true)],
};

fn coord_replace(context: &Context) -> bool {
    context.state.raster.points.coord_replace >> context.state.units.active & 1 == 1
}

/// A number as a named constant; what cannot be one gives a constant that no table has.
pub(crate) fn symbol(value: f32) -> GLenum {
    if value >= 0.0 && value.trunc() == value { value as GLenum } else { GLenum::MAX }
}

/// A level-of-detail bias within the limits; NaN counts as 0.
pub(crate) fn lod_bias(value: f32) -> f32 {
    let limit = limits::MAX_TEXTURE_LOD_BIAS;
    if value.is_nan() { 0.0 } else { value.clamp(-limit, limit) }
}

fn set_scalar(context: &mut Context, target: GLenum, pname: GLenum, param: f32) -> Result<()> {
    match parameter(target, pname)? {
        Parameter::Color => crate::error::invalid_enum(
            SECTION,
            "pname = GL_TEXTURE_ENV_COLOR has four components: use glTexEnvfv or glTexEnviv",
        ),
        single @ (Parameter::Mode | Parameter::LodBias | Parameter::CoordReplace) => {
            set(context, single, param, [0.0; 4])
        }
    }
}

fn set_vector(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    values: &[f32],
    colors: &[f32],
) -> Result<()> {
    let parameter = parameter(target, pname)?;
    let needed = if parameter == Parameter::Color { 4 } else { 1 };
    if values.len() < needed {
        return invalid_operation(
            SECTION,
            format!("params has {} of {needed} values of {}", values.len(), enum_name(pname)),
        );
    }
    set(context, parameter, values[0], colors.first_chunk().copied().unwrap_or_default())
}

pub(crate) fn tex_envi(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    param: GLint,
) -> Result<()> {
    set_scalar(context, target, pname, param as f32)
}

pub(crate) fn tex_envf(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    param: GLfloat,
) -> Result<()> {
    set_scalar(context, target, pname, param)
}

pub(crate) fn tex_enviv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &[GLint],
) -> Result<()> {
    let values: Vec<f32> = params.iter().map(|&value| value as f32).collect();
    let colors: Vec<f32> = params.iter().map(|&value| signed_to_unit(value)).collect();
    set_vector(context, target, pname, &values, &colors)
}

pub(crate) fn tex_envfv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &[GLfloat],
) -> Result<()> {
    set_vector(context, target, pname, params, params)
}

/// A signed integer as a colour component (GL 2.1, table 2.9).
pub(crate) fn signed_to_unit(value: i32) -> f32 {
    ((2.0 * f64::from(value) + 1.0) / f64::from(u32::MAX)) as f32
}

/// A colour component as a signed integer (GL 2.1, table 4.9).
pub(crate) fn unit_to_signed(value: f32) -> i32 {
    ((f64::from(u32::MAX) * f64::from(value) - 1.0) / 2.0).round_ties_even() as i32
}

pub(crate) fn get_tex_enviv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let unit = context.state.units.active();
    match parameter(target, pname)? {
        Parameter::Mode => crate::query::put(params, &[MODE.encode(unit.mode) as GLint]),
        Parameter::Color => crate::query::put(params, &unit.color.map(unit_to_signed)),
        Parameter::LodBias => crate::query::put(params, &[unit.lod_bias.round() as GLint]),
        Parameter::CoordReplace => crate::query::put(params, &[coord_replace(context).into()]),
    }
}

pub(crate) fn get_tex_envfv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    let unit = context.state.units.active();
    match parameter(target, pname)? {
        Parameter::Mode => crate::query::put(params, &[MODE.encode(unit.mode) as GLfloat]),
        Parameter::Color => crate::query::put(params, &unit.color),
        Parameter::LodBias => crate::query::put(params, &[unit.lod_bias]),
        Parameter::CoordReplace => {
            crate::query::put(params, &[u8::from(coord_replace(context)).into()])
        }
    }
}
