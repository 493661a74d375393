//! Conversions of numbers between GL's types (GL 2.1, table 2.9).

use crate::base::limits;
use crate::base::types::*;

/// A number as a named constant; a number that is none gives a value that no table has.
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
pub(crate) fn unit_to_signed(value: f64) -> i32 {
    ((f64::from(u32::MAX) * value - 1.0) / 2.0).round_ties_even() as i32
}

/// Clamped to [0, 1]; NaN gives 0.
pub(crate) fn unit(value: f64) -> f64 {
    if value > 0.0 { value.min(1.0) } else { 0.0 }
}
