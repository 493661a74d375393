//! Pixel transfer: the scale and bias that every pixel passes on its way in and out (GL 2.1,
//! sections 3.6.3 and 3.6.5).

use super::client::Numbers;
use crate::constants::*;
use crate::context::Context;
use crate::error::{Result, Table, invalid_value};
use crate::types::*;

const SECTION: &str = "GL 2.1, section 3.6.3";

/// A number times a scale, plus a bias.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Linear {
    pub scale: f32,
    pub bias: f32,
}

impl Linear {
    const IDENTITY: Self = Self { scale: 1.0, bias: 0.0 };

    #[inline]
    fn apply(self, value: f64) -> f64 {
        value * f64::from(self.scale) + f64::from(self.bias)
    }
}

/// The state of `glPixelTransfer`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Transfer {
    /// Red, green, blue, alpha, depth.
    pub linear: [Linear; 5],
}

impl Default for Transfer {
    fn default() -> Self {
        Self { linear: [Linear::IDENTITY; 5] }
    }
}

/// What pixels are of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Color,
    Depth,
}

impl Transfer {
    /// What is done to R, G, B, A of pixels of this kind. Integers pass as they are
    /// (`EXT_texture_integer`), stencil too.
    pub fn of(&self, kind: Kind, numbers: Numbers) -> [Linear; 4] {
        let [r, g, b, a, depth] = self.linear;
        let same = Linear::IDENTITY;
        match (numbers, kind) {
            (Numbers::Integer, _) => [same; 4],
            (Numbers::Fixed | Numbers::SignedNormalized, Kind::Color) => [r, g, b, a],
            (Numbers::Fixed | Numbers::SignedNormalized, Kind::Depth) => [depth, same, same, same],
        }
    }
}

/// Whether pixels pass as they are.
pub(crate) fn is_identity(linear: &[Linear; 4]) -> bool {
    linear.iter().all(|&linear| linear == Linear::IDENTITY)
}

/// Scales and biases R, G, B, A.
#[inline]
pub(crate) fn apply(linear: &[Linear; 4], rgba: [f64; 4]) -> [f64; 4] {
    [0, 1, 2, 3].map(|i| linear[i].apply(rgba[i]))
}

/// A parameter: which number, and which part of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parameter {
    Scale(u8),
    Bias(u8),
}

/// What `glPixelTransfer` takes. Look-up tables and index arithmetic are not there.
pub(crate) const PARAMETER: Table<Parameter> = Table {
    section: "GL 2.1, table 3.2",
    rows: &[
        (GL_RED_SCALE, Parameter::Scale(0)),
        (GL_GREEN_SCALE, Parameter::Scale(1)),
        (GL_BLUE_SCALE, Parameter::Scale(2)),
        (GL_ALPHA_SCALE, Parameter::Scale(3)),
        (GL_DEPTH_SCALE, Parameter::Scale(4)),
        (GL_RED_BIAS, Parameter::Bias(0)),
        (GL_GREEN_BIAS, Parameter::Bias(1)),
        (GL_BLUE_BIAS, Parameter::Bias(2)),
        (GL_ALPHA_BIAS, Parameter::Bias(3)),
        (GL_DEPTH_BIAS, Parameter::Bias(4)),
    ],
};

impl Transfer {
    /// The value of a parameter.
    pub fn get(&self, parameter: Parameter) -> f32 {
        match parameter {
            Parameter::Scale(which) => self.linear[usize::from(which)].scale,
            Parameter::Bias(which) => self.linear[usize::from(which)].bias,
        }
    }
}

pub(crate) fn pixel_transferf(context: &mut Context, pname: GLenum, param: GLfloat) -> Result<()> {
    let parameter = PARAMETER.decode("pname", pname)?;
    if param.is_nan() {
        return invalid_value(SECTION, format!("{} must be a number", enum_name(pname)));
    }
    let linear = &mut context.state.transfer.linear;
    match parameter {
        Parameter::Scale(which) => linear[usize::from(which)].scale = param,
        Parameter::Bias(which) => linear[usize::from(which)].bias = param,
    }
    Ok(())
}

pub(crate) fn pixel_transferi(context: &mut Context, pname: GLenum, param: GLint) -> Result<()> {
    pixel_transferf(context, pname, param as GLfloat)
}
