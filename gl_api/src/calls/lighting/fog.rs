//! `glFog`: GL 2.1, section 3.10.

use crate::base::constants::*;
use crate::base::error::{Result, Table};
use crate::base::params::{Params, at_least_zero};
use crate::base::types::*;
use crate::calls::parameter_forms::parameter_calls;
use crate::context::Context;
use crate::state::fog::{FOG_MODE, FOG_SOURCE};

const SECTION: &str = "GL 2.1, section 3.10";

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
    let mut fog = context.state.fog.clone();
    match parameter {
        Parameter::Mode => fog.mode = FOG_MODE.decode("param", params.symbol())?,
        Parameter::Density => fog.density = at_least_zero(SECTION, pname, params.number())?,
        Parameter::Start => fog.start = params.number(),
        Parameter::End => fog.end = params.number(),
        Parameter::Index => fog.index = params.number(),
        Parameter::Color => fog.color = params.color(),
        Parameter::Source => fog.source = FOG_SOURCE.decode("param", params.symbol())?,
    }
    if fog == context.state.fog
        && fog.color.map(f32::to_bits) == context.state.fog.color.map(f32::to_bits)
    {
        context.state_changes.no_change();
    } else {
        context.leave_plain_state();
        context.state.fog = fog;
    }
    Ok(())
}

parameter_calls!(set_fog(pname): fogf, fogi, fogfv, fogiv);
