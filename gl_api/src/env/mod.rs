//! Texture units and their environments: GL 2.1, sections 2.7, 3.8.12 and 3.8.13.

pub(crate) mod combine;
pub(crate) mod texgen;

use crate::constants::*;
use crate::context::{Context, limits};
use crate::error::{Result, Table, invalid_enum, invalid_operation, must_be};
use crate::interface::{MAX_COMBINED_TEXTURE_IMAGE_UNITS, MAX_TEXTURE_UNITS};
use crate::object::bound::Bound;
use crate::query::table::{self, Value};
use crate::state::clamp;
use crate::state::params::{Params, parameter_calls, parameter_queries};
use crate::state::versioned::Versioned;
use crate::texture::TextureTarget;
use crate::types::*;
use combine::{Arguments, COMBINER_PARAMETER, Combiner, CombinerParameter};
use std::sync::Arc;
use texgen::Generate;

const SECTION: &str = "GL 2.1, section 3.8.13";

/// What a unit without combiners does with the colour that comes from the unit before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Standard {
    Replace,
    Modulate,
    Decal,
    Blend,
    Add,
}

/// What a unit does with the colour that comes from the unit before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    Standard(Standard),
    /// As the unit's combiners say.
    Combine(Arguments),
}

pub(crate) const MODE: Table<Mode> = Table {
    section: SECTION,
    rows: &[
        (GL_REPLACE, Mode::Standard(Standard::Replace)),
        (GL_MODULATE, Mode::Standard(Standard::Modulate)),
        (GL_DECAL, Mode::Standard(Standard::Decal)),
        (GL_BLEND, Mode::Standard(Standard::Blend)),
        (GL_ADD, Mode::Standard(Standard::Add)),
        (GL_COMBINE, Mode::Combine(Arguments::Two)),
        (GL_COMBINE4_NV, Mode::Combine(Arguments::Four)),
    ],
};

/// One texture unit.
#[derive(Clone, Debug)]
pub(crate) struct Unit {
    /// By [`TextureTarget`]; of several, the last in its list wins (section 3.8.15).
    pub enabled: [bool; TextureTarget::COUNT],
    /// Textures, by target.
    pub bound: [Bound; TextureTarget::COUNT],
    /// The sampler object, if any, whose state stands for the textures'.
    pub sampler: Bound,
    pub mode: Mode,
    pub color: [f32; 4],
    pub lod_bias: f32,
    /// Of colour and of alpha.
    pub combiners: [Combiner; 2],
    /// How s, t, r and q are generated.
    pub generate: [Generate; 4],
    /// Whether point sprites replace the coordinates (section 3.3).
    pub coord_replace: bool,
}

impl Unit {
    /// What is switched on: targets, and coordinates that are generated.
    pub fn switches(&self) -> ([bool; TextureTarget::COUNT], [bool; 4]) {
        (self.enabled, self.generate.each_ref().map(|generate| generate.enabled))
    }

    /// The reverse of [`Self::switches`].
    pub fn switch(&mut self, (enabled, generate): ([bool; TextureTarget::COUNT], [bool; 4])) {
        self.enabled = enabled;
        for (coord, enabled) in self.generate.iter_mut().zip(generate) {
            coord.enabled = enabled;
        }
    }
}

/// All units, and which one calls work on.
#[derive(Clone, Debug)]
pub(crate) struct Units {
    /// What `glPushAttrib` keeps shares them until one is changed ([`Self::unit_mut`]). Draws look at
    /// all of it only where it has changed.
    pub units: Versioned<Box<[Arc<Unit>; MAX_COMBINED_TEXTURE_IMAGE_UNITS as usize]>>,
    pub active: u8,
    pub client_active: u8,
}

impl Default for Units {
    fn default() -> Self {
        let unit = Unit {
            enabled: [false; TextureTarget::COUNT],
            bound: Default::default(),
            sampler: Bound::default(),
            mode: Mode::Standard(Standard::Modulate),
            color: [0.0; 4],
            lod_bias: 0.0,
            combiners: Combiner::initial(),
            generate: Generate::initial(),
            coord_replace: false,
        };
        let unit = Arc::new(unit);
        let units = Box::new(std::array::from_fn(|_| Arc::clone(&unit)));
        Self { units: Versioned::new(units), active: 0, client_active: 0 }
    }
}

impl Units {
    pub fn active(&self) -> &Unit {
        &self.units[usize::from(self.active)]
    }

    pub fn active_mut(&mut self) -> &mut Unit {
        self.unit_mut(self.active.into())
    }

    /// A unit, to be changed.
    pub fn unit_mut(&mut self, unit: usize) -> &mut Unit {
        Arc::make_mut(&mut self.units[unit])
    }

    /// Where point sprites replace the coordinates: bit by unit.
    pub fn coord_replace(&self) -> u32 {
        let bits = (0..).zip(self.units.iter());
        bits.fold(0, |bits, (at, unit)| bits | u32::from(unit.coord_replace) << at)
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
    Combiner(CombinerParameter),
    LodBias,
    CoordReplace,
}

/// What is set besides combiners.
const ENV_PARAMETER: Table<Parameter> = Table {
    section: SECTION,
    rows: &[(GL_TEXTURE_ENV_MODE, Parameter::Mode), (GL_TEXTURE_ENV_COLOR, Parameter::Color)],
};

const FILTER_PARAMETER: Table<Parameter> =
    Table { section: "GL 2.1, section 3.8.8", rows: &[(GL_TEXTURE_LOD_BIAS, Parameter::LodBias)] };

const SPRITE_PARAMETER: Table<Parameter> =
    Table { section: "GL 2.1, section 3.3", rows: &[(GL_COORD_REPLACE, Parameter::CoordReplace)] };

/// What a call is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Target {
    Environment,
    FilterControl,
    PointSprite,
}

const TARGET: Table<Target> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_ENV, Target::Environment),
        (GL_TEXTURE_FILTER_CONTROL, Target::FilterControl),
        (GL_POINT_SPRITE, Target::PointSprite),
    ],
};

fn parameter(target: GLenum, pname: GLenum) -> Result<Parameter> {
    match TARGET.decode("target", target)? {
        Target::Environment => match COMBINER_PARAMETER.get(pname) {
            Some(parameter) => Ok(Parameter::Combiner(parameter)),
            None => ENV_PARAMETER.decode("pname", pname).or_else(|_| {
                let choices = [ENV_PARAMETER.values(), COMBINER_PARAMETER.values()].concat();
                let rule = format!("pname = {} {}", enum_name(pname), must_be(pname, &choices));
                invalid_enum(SECTION, rule)
            }),
        },
        Target::FilterControl => FILTER_PARAMETER.decode("pname", pname),
        Target::PointSprite => SPRITE_PARAMETER.decode("pname", pname),
    }
}

fn set_env(context: &mut Context, target: GLenum, pname: GLenum, params: &Params) -> Result<()> {
    let parameter = parameter(target, pname)?;
    params.need(SECTION, pname, if parameter == Parameter::Color { 4 } else { 1 })?;
    let unit = context.state.units.active();
    let before = (unit.mode, unit.color, unit.combiners, unit.lod_bias, unit.coord_replace);
    let mut now = before;
    let (mode, color, combiners, bias, coord_replace) = &mut now;
    match parameter {
        Parameter::Mode => *mode = MODE.decode("param", params.symbol())?,
        Parameter::Color => *color = params.color(),
        Parameter::Combiner(parameter) => combine::set(combiners, parameter, params.number())?,
        Parameter::LodBias => *bias = lod_bias(params.number()),
        Parameter::CoordReplace => *coord_replace = params.truth(),
    }
    if now == before {
        context.changes.nothing();
        return Ok(());
    }
    let unit = context.state.units.active_mut();
    (unit.mode, unit.color, unit.combiners, unit.lod_bias, unit.coord_replace) = now;
    Ok(())
}

parameter_calls!(set_env(target, pname): tex_envf, tex_envi, tex_envfv, tex_enviv);

fn get_env(context: &Context, target: GLenum, pname: GLenum) -> Result<Value> {
    let unit = context.state.units.active();
    match parameter(target, pname)? {
        Parameter::Mode => table::symbol(MODE.encode(unit.mode)),
        Parameter::Color => table::unit(&clamp::of_fragments(context).color(unit.color)),
        Parameter::Combiner(parameter) => combine::get(&unit.combiners, parameter),
        Parameter::LodBias => table::float(unit.lod_bias),
        Parameter::CoordReplace => table::flag(unit.coord_replace),
    }
}

parameter_queries!(get_env(target, pname): get_tex_envfv, get_tex_enviv);

/// A number as a named constant; what cannot be one gives a constant that no table has.
pub(crate) fn symbol(value: f32) -> GLenum {
    if value >= 0.0 && value.trunc() == value { value as GLenum } else { GLenum::MAX }
}

/// A level-of-detail bias within the limits; NaN counts as 0.
pub(crate) fn lod_bias(value: f32) -> f32 {
    let limit = limits::MAX_TEXTURE_LOD_BIAS;
    if value.is_nan() { 0.0 } else { value.clamp(-limit, limit) }
}

/// A signed integer as a colour component (GL 2.1, table 2.9).
pub(crate) fn signed_to_unit(value: i32) -> f32 {
    ((2.0 * f64::from(value) + 1.0) / f64::from(u32::MAX)) as f32
}

/// A colour component as a signed integer (GL 2.1, table 4.9).
pub(crate) fn unit_to_signed(value: f32) -> i32 {
    ((f64::from(u32::MAX) * f64::from(value) - 1.0) / 2.0).round_ties_even() as i32
}
