//! Lights and the lighting model: GL 2.1, section 2.14.1, table 2.10.

use super::params::{Params, at_least_zero, parameter_calls, parameter_queries};
use crate::constants::*;
use crate::context::Context;
use crate::error::{Result, Table, invalid_enum, invalid_value};
use crate::glu::angle::sin_cos_degrees;
use crate::interface::MAX_LIGHTS;
use crate::query::table::{Value, flag, float, symbol, unit};
use crate::types::*;
use glam::{DMat3, DVec3, DVec4};

const SECTION: &str = "GL 2.1, section 2.14.1";

/// A light, in eye coordinates.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Light {
    pub ambient: [f32; 4],
    pub diffuse: [f32; 4],
    pub specular: [f32; 4],
    pub position: DVec4,
    pub spot_direction: DVec3,
    pub spot_exponent: f32,
    /// In degrees: 0 to 90, or 180.
    pub spot_cutoff: f32,
    /// Constant, linear, quadratic.
    pub attenuation: [f32; 3],
    pub derived: Derived,
}

/// What a draw needs of a light and no draw changes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Derived {
    /// Where the light is, or the unit vector toward it if it is infinitely far.
    pub place: DVec3,
    /// The unit vector between that toward the light and (0, 0, 1).
    pub half: DVec3,
    /// The spot's direction, of length one.
    pub spot_axis: DVec3,
    /// The cosine of the cutoff.
    pub cos_cutoff: f64,
}

impl Light {
    fn new(index: u8) -> Self {
        let color = if index == 0 { [1.0; 4] } else { [0.0, 0.0, 0.0, 1.0] };
        let (position, spot_direction) = (DVec4::Z, DVec3::NEG_Z);
        Self {
            ambient: [0.0, 0.0, 0.0, 1.0],
            diffuse: color,
            specular: color,
            position,
            spot_direction,
            spot_exponent: 0.0,
            spot_cutoff: 180.0,
            attenuation: [1.0, 0.0, 0.0],
            derived: Derived::new(position, spot_direction, 180.0),
        }
    }

    /// Whether its position is a point, not a direction.
    pub fn is_local(&self) -> bool {
        self.position.w != 0.0
    }
}

impl Derived {
    fn new(position: DVec4, spot_direction: DVec3, spot_cutoff: f32) -> Self {
        let toward = position.truncate().normalize_or_zero();
        let local = position.w != 0.0;
        Self {
            place: if local { position.truncate() / position.w } else { toward },
            half: (toward + DVec3::Z).normalize_or_zero(),
            spot_axis: spot_direction.normalize_or_zero(),
            cos_cutoff: sin_cos_degrees(spot_cutoff.into()).1,
        }
    }
}

/// Where the specular term goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ColorControl {
    /// Into the primary colour.
    Single,
    /// Into the secondary colour.
    Separate,
}

pub(crate) const COLOR_CONTROL: Table<ColorControl> = Table {
    section: SECTION,
    rows: &[
        (GL_SINGLE_COLOR, ColorControl::Single),
        (GL_SEPARATE_SPECULAR_COLOR, ColorControl::Separate),
    ],
};

/// The lighting model.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LightModel {
    pub ambient: [f32; 4],
    pub local_viewer: bool,
    pub two_side: bool,
    pub color_control: ColorControl,
}

/// All lights.
#[derive(Clone, Debug)]
pub(crate) struct Lights {
    pub lights: [Light; MAX_LIGHTS as usize],
    /// Bit by light.
    pub enabled: u8,
    pub model: LightModel,
}

impl Default for Lights {
    fn default() -> Self {
        Self {
            lights: std::array::from_fn(|index| Light::new(index as u8)),
            enabled: 0,
            model: LightModel {
                ambient: [0.2, 0.2, 0.2, 1.0],
                local_viewer: false,
                two_side: false,
                color_control: ColorControl::Single,
            },
        }
    }
}

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

/// A light's number.
fn index(light: GLenum) -> Result<usize> {
    match light.checked_sub(GL_LIGHT0) {
        Some(index) if index < MAX_LIGHTS.into() => Ok(index as usize),
        _ => invalid_enum(
            SECTION,
            format!("light = {} must be GL_LIGHT0 to GL_LIGHT{}", enum_name(light), MAX_LIGHTS - 1),
        ),
    }
}

fn set_light(context: &mut Context, light: GLenum, pname: GLenum, params: &Params) -> Result<()> {
    let index = index(light)?;
    let parameter = PARAMETER.decode("pname", pname)?;
    params.need(SECTION, pname, parameter.count())?;
    let modelview = context.state.matrices.modelview.top;
    let light = &mut context.state.lights.lights[index];
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
    light.derived = Derived::new(light.position, light.spot_direction, light.spot_cutoff);
    Ok(())
}

parameter_calls!(set_light(light, pname): lightf, lighti, lightfv, lightiv);

fn get_light(context: &Context, light: GLenum, pname: GLenum) -> Result<Value> {
    let light = &context.state.lights.lights[index(light)?];
    match PARAMETER.decode("pname", pname)? {
        Parameter::Ambient => unit(&light.ambient),
        Parameter::Diffuse => unit(&light.diffuse),
        Parameter::Specular => unit(&light.specular),
        Parameter::Position => Ok(Value::Floats(light.position.to_array().to_vec())),
        Parameter::SpotDirection => Ok(Value::Floats(light.spot_direction.to_array().to_vec())),
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

/// What `glGet` answers.
pub(crate) fn state_value(context: &Context, pname: GLenum) -> Option<Result<Value>> {
    let model = &context.state.lights.model;
    Some(match MODEL_PARAMETER.get(pname)? {
        ModelParameter::Ambient => unit(&model.ambient),
        ModelParameter::LocalViewer => flag(model.local_viewer),
        ModelParameter::TwoSide => flag(model.two_side),
        ModelParameter::ColorControl => symbol(COLOR_CONTROL.encode(model.color_control)),
    })
}
