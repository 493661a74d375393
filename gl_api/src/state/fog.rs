//! Fog: GL 2.1, section 3.10.

use super::clamp;
use super::params::{Params, at_least_zero, parameter_calls};
use crate::constants::*;
use crate::context::Context;
use crate::error::{Result, Table};
use crate::query::table::{Value, float, symbol, unit};
use crate::types::*;

const SECTION: &str = "GL 2.1, section 3.10";

/// How the factor falls with the distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum FogMode {
    Linear,
    Exp,
    Exp2,
}

pub(crate) const FOG_MODE: Table<FogMode> = Table {
    section: SECTION,
    rows: &[(GL_EXP, FogMode::Exp), (GL_EXP2, FogMode::Exp2), (GL_LINEAR, FogMode::Linear)],
};

/// Where the distance comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum FogSource {
    /// The distance from the eye's plane, `|z|` in eye coordinates.
    Depth,
    /// `glFogCoord`.
    Coordinate,
}

pub(crate) const FOG_SOURCE: Table<FogSource> = Table {
    section: SECTION,
    rows: &[(GL_FRAGMENT_DEPTH, FogSource::Depth), (GL_FOG_COORD, FogSource::Coordinate)],
};

/// What `glFog` sets.
#[derive(Clone, Debug)]
pub(crate) struct FogState {
    pub mode: FogMode,
    pub density: f32,
    pub start: f32,
    pub end: f32,
    /// Of colour index mode; kept, not used.
    pub index: f32,
    pub color: [f32; 4],
    pub source: FogSource,
}

impl Default for FogState {
    fn default() -> Self {
        Self {
            mode: FogMode::Exp,
            density: 1.0,
            start: 0.0,
            end: 1.0,
            index: 0.0,
            color: [0.0; 4],
            source: FogSource::Depth,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parameter {
    Mode,
    Density,
    Start,
    End,
    Index,
    Color,
    Source,
}

const PARAMETER: Table<Parameter> = Table {
    section: SECTION,
    rows: &[
        (GL_FOG_MODE, Parameter::Mode),
        (GL_FOG_DENSITY, Parameter::Density),
        (GL_FOG_START, Parameter::Start),
        (GL_FOG_END, Parameter::End),
        (GL_FOG_INDEX, Parameter::Index),
        (GL_FOG_COLOR, Parameter::Color),
        (GL_FOG_COORD_SRC, Parameter::Source),
    ],
};

fn set_fog(context: &mut Context, pname: GLenum, params: &Params) -> Result<()> {
    let parameter = PARAMETER.decode("pname", pname)?;
    params.need(SECTION, pname, if parameter == Parameter::Color { 4 } else { 1 })?;
    let fog = &mut context.state.fog;
    match parameter {
        Parameter::Mode => fog.mode = FOG_MODE.decode("param", params.symbol())?,
        Parameter::Density => fog.density = at_least_zero(SECTION, pname, params.number())?,
        Parameter::Start => fog.start = params.number(),
        Parameter::End => fog.end = params.number(),
        Parameter::Index => fog.index = params.number(),
        Parameter::Color => fog.color = params.color(),
        Parameter::Source => fog.source = FOG_SOURCE.decode("param", params.symbol())?,
    }
    Ok(())
}

parameter_calls!(set_fog(pname): fogf, fogi, fogfv, fogiv);

/// What `glGet` answers.
pub(crate) fn state_value(context: &Context, pname: GLenum) -> Option<Result<Value>> {
    let fog = &context.state.fog;
    Some(match PARAMETER.get(pname)? {
        Parameter::Mode => symbol(FOG_MODE.encode(fog.mode)),
        Parameter::Density => float(fog.density),
        Parameter::Start => float(fog.start),
        Parameter::End => float(fog.end),
        Parameter::Index => float(fog.index),
        Parameter::Color => unit(&clamp::of_fragments(context).color(fog.color)),
        Parameter::Source => symbol(FOG_SOURCE.encode(fog.source)),
    })
}
