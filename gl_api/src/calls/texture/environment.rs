//! The calls of texture environments: `glTexEnv` and its queries (GL 2.1, section 3.8.13).

use crate::base::constants::*;
use crate::base::convert::lod_bias;
use crate::base::error::{Result, Table, invalid_enum, must_be};
use crate::base::params::Params;
use crate::base::query_value as table;
use crate::base::query_value::QueryValue;
use crate::base::types::*;
use crate::calls::parameter_forms::{parameter_calls, parameter_queries};
use crate::context::Context;
use crate::state::texture_units::MODE;
use crate::state::texture_units::combine::{COMBINER_PARAMETER, CombinerParameter};

const SECTION: &str = "GL 2.1, section 3.8.13";

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
        Parameter::Combiner(parameter) => {
            crate::state::texture_units::combine::set(combiners, parameter, params.number())?
        }
        Parameter::LodBias => *bias = lod_bias(params.number()),
        Parameter::CoordReplace => *coord_replace = params.truth(),
    }
    if now == before {
        context.state_changes.no_change();
        return Ok(());
    }
    context.leave_plain_state();
    let unit = context.state.units.active_mut();
    (unit.mode, unit.color, unit.combiners, unit.lod_bias, unit.coord_replace) = now;
    Ok(())
}

parameter_calls!(set_env(target, pname): tex_envf, tex_envi, tex_envfv, tex_enviv);

fn get_env(context: &Context, target: GLenum, pname: GLenum) -> Result<QueryValue> {
    let unit = context.state.units.active();
    match parameter(target, pname)? {
        Parameter::Mode => table::symbol(MODE.encode(unit.mode)),
        Parameter::Color => {
            table::unit(&crate::draw::color_clamp::of_fragments(context).color(unit.color))
        }
        Parameter::Combiner(parameter) => {
            crate::state::texture_units::combine::get(&unit.combiners, parameter)
        }
        Parameter::LodBias => table::float(unit.lod_bias),
        Parameter::CoordReplace => table::flag(unit.coord_replace),
    }
}

parameter_queries!(get_env(target, pname): get_tex_envfv, get_tex_enviv);
