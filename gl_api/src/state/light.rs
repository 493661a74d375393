//! Lights and the lighting model: GL 2.1, section 2.14.1, table 2.10.

use crate::base::angle::sin_cos_degrees;
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum};
use crate::base::types::*;
use crate::interface::MAX_LIGHTS;
use glam::{DVec3, DVec4};

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

impl Light {
    /// Whether all that is set of it is equal to the bit.
    pub fn is_set_as(&self, other: &Self) -> bool {
        let Self {
            ambient,
            diffuse,
            specular,
            position,
            spot_direction,
            spot_exponent,
            spot_cutoff,
            attenuation,
            derived: _,
        } = self;
        let bits = |color: &[f32; 4]| color.map(f32::to_bits);
        let [constant, linear, quadratic] = *attenuation;
        let rest = bits(&[constant, linear, quadratic, *spot_exponent]);
        let [constant, linear, quadratic] = other.attenuation;
        bits(ambient) == bits(&other.ambient)
            && bits(diffuse) == bits(&other.diffuse)
            && bits(specular) == bits(&other.specular)
            && position.to_array().map(f64::to_bits) == other.position.to_array().map(f64::to_bits)
            && spot_direction.to_array().map(f64::to_bits)
                == other.spot_direction.to_array().map(f64::to_bits)
            && rest == bits(&[constant, linear, quadratic, other.spot_exponent])
            && spot_cutoff.to_bits() == other.spot_cutoff.to_bits()
    }
}

/// Values that draws derive from a light's state.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Derived {
    /// The position, or the unit vector toward a light at infinity.
    pub position: DVec3,
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
    pub(crate) fn new(position: DVec4, spot_direction: DVec3, spot_cutoff: f32) -> Self {
        let toward = position.truncate().normalize_or_zero();
        let local = position.w != 0.0;
        Self {
            position: if local { position.truncate() / position.w } else { toward },
            half: (toward + DVec3::Z).normalize_or_zero(),
            spot_axis: spot_direction.normalize_or_zero(),
            cos_cutoff: sin_cos_degrees(spot_cutoff.into()).1,
        }
    }
}

/// The colour to which the specular term is added.
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

/// A light's number.
pub(crate) fn index(light: GLenum) -> Result<usize> {
    match light.checked_sub(GL_LIGHT0) {
        Some(index) if index < MAX_LIGHTS.into() => Ok(index as usize),
        _ => invalid_enum(
            SECTION,
            format!("light = {} must be GL_LIGHT0 to GL_LIGHT{}", enum_name(light), MAX_LIGHTS - 1),
        ),
    }
}
