//! `glLight` and `glLightModel`: GL 2.1, section 2.14.1, table 2.10.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_value};
use crate::base::params::{Params, at_least_zero};
use crate::base::query_value::{QueryValue, float, unit};
use crate::base::types::*;
use crate::calls::parameter_forms::{parameter_calls, parameter_queries};
use crate::context::Context;
use crate::state::light::{COLOR_CONTROL, Derived, index};
use glam::{DMat3, DVec4};

const SECTION: &str = "GL 2.1, section 2.14.1";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parameter {
    Ambient,
    Diffuse,
    Specular,
    Position,
    SpotDirection,
    SpotExponent,
    SpotCutoff,
    Attenuation(usize),
}

const PARAMETER: Table<Parameter> = Table {
    section: SECTION,
    rows: &[
        (GL_AMBIENT, Parameter::Ambient),
        (GL_DIFFUSE, Parameter::Diffuse),
        (GL_SPECULAR, Parameter::Specular),
        (GL_POSITION, Parameter::Position),
        (GL_SPOT_DIRECTION, Parameter::SpotDirection),
        (GL_SPOT_EXPONENT, Parameter::SpotExponent),
        (GL_SPOT_CUTOFF, Parameter::SpotCutoff),
        (GL_CONSTANT_ATTENUATION, Parameter::Attenuation(0)),
        (GL_LINEAR_ATTENUATION, Parameter::Attenuation(1)),
        (GL_QUADRATIC_ATTENUATION, Parameter::Attenuation(2)),
    ],
};

impl Parameter {
    fn count(self) -> usize {
        match self {
            Self::Ambient | Self::Diffuse | Self::Specular | Self::Position => 4,
            Self::SpotDirection => 3,
            Self::SpotExponent | Self::SpotCutoff | Self::Attenuation(_) => 1,
        }
    }
}

fn set_light(context: &mut Context, light: GLenum, pname: GLenum, params: &Params) -> Result<()> {
    let index = index(light)?;
    let parameter = PARAMETER.decode("pname", pname)?;
    params.need(SECTION, pname, parameter.count())?;
    let modelview = context.state.matrices.modelview.top;
    let mut light = context.state.lights.lights[index].clone();
    let value = params.number();
    match parameter {
        Parameter::Ambient => light.ambient = params.color(),
        Parameter::Diffuse => light.diffuse = params.color(),
        Parameter::Specular => light.specular = params.color(),
        Parameter::Position => light.position = modelview * DVec4::from(params.point()),
        Parameter::SpotDirection => {
            let direction = DVec4::from(params.point()).truncate();
            light.spot_direction = DMat3::from_mat4(modelview) * direction;
        }
        Parameter::SpotExponent => {
            if !(0.0..=128.0).contains(&value) {
                return invalid_value(
                    SECTION,
                    format!("GL_SPOT_EXPONENT = {value} must be 0 to 128"),
                );
            }
            light.spot_exponent = value;
        }
        Parameter::SpotCutoff => {
            if !(0.0..=90.0).contains(&value) && value != 180.0 {
                return invalid_value(
                    SECTION,
                    format!("GL_SPOT_CUTOFF = {value} must be 0 to 90, or 180"),
                );
            }
            light.spot_cutoff = value;
        }
        Parameter::Attenuation(term) => {
            light.attenuation[term] = at_least_zero(SECTION, pname, value)?;
        }
    }
    let now = &context.state.lights.lights[index];
    if light.is_set_as(now) {
        context.state_changes.no_change();
    } else {
        context.leave_plain_state();
        light.derived = Derived::new(light.position, light.spot_direction, light.spot_cutoff);
        context.state.lights.lights[index] = light;
    }
    Ok(())
}

parameter_calls!(set_light(light, pname): lightf, lighti, lightfv, lightiv);

fn get_light(context: &Context, light: GLenum, pname: GLenum) -> Result<QueryValue> {
    let light = &context.state.lights.lights[index(light)?];
    match PARAMETER.decode("pname", pname)? {
        Parameter::Ambient => unit(&light.ambient),
        Parameter::Diffuse => unit(&light.diffuse),
        Parameter::Specular => unit(&light.specular),
        Parameter::Position => Ok(QueryValue::Floats(light.position.to_array().to_vec())),
        Parameter::SpotDirection => {
            Ok(QueryValue::Floats(light.spot_direction.to_array().to_vec()))
        }
        Parameter::SpotExponent => float(light.spot_exponent),
        Parameter::SpotCutoff => float(light.spot_cutoff),
        Parameter::Attenuation(term) => float(light.attenuation[term]),
    }
}

parameter_queries!(get_light(light, pname): get_lightfv, get_lightiv);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ModelParameter {
    Ambient,
    LocalViewer,
    TwoSide,
    ColorControl,
}

const MODEL_PARAMETER: Table<ModelParameter> = Table {
    section: SECTION,
    rows: &[
        (GL_LIGHT_MODEL_AMBIENT, ModelParameter::Ambient),
        (GL_LIGHT_MODEL_LOCAL_VIEWER, ModelParameter::LocalViewer),
        (GL_LIGHT_MODEL_TWO_SIDE, ModelParameter::TwoSide),
        (GL_LIGHT_MODEL_COLOR_CONTROL, ModelParameter::ColorControl),
    ],
};

fn set_model(context: &mut Context, pname: GLenum, params: &Params) -> Result<()> {
    let parameter = MODEL_PARAMETER.decode("pname", pname)?;
    params.need(SECTION, pname, if parameter == ModelParameter::Ambient { 4 } else { 1 })?;
    let model = &mut context.state.lights.model;
    match parameter {
        ModelParameter::Ambient => model.ambient = params.color(),
        ModelParameter::LocalViewer => model.local_viewer = params.truth(),
        ModelParameter::TwoSide => model.two_side = params.truth(),
        ModelParameter::ColorControl => {
            model.color_control = COLOR_CONTROL.decode("param", params.symbol())?;
        }
    }
    Ok(())
}

parameter_calls!(set_model(pname): light_modelf, light_modeli, light_modelfv, light_modeliv);
