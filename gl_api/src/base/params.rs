//! Parameter values of calls such as `glLightfv` and `glLighti`, independent of the C type: as numbers, as colour
//! components (GL 2.1, table 2.9), or as named constants.

use crate::base::constants::enum_name;
use crate::base::convert::{signed_to_unit, symbol};
use crate::base::error::{Result, invalid_enum, invalid_operation, invalid_value};
use crate::base::types::*;

/// Whether a call passes one value, or points to several (its name ends in `v`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Scalar,
    Vector,
}

/// Up to four parameter values of a call.
#[derive(Clone, Debug)]
pub(crate) struct Params {
    form: Form,
    len: usize,
    plain: [f64; 4],
    /// As colour components: integers are fractions.
    color: [f32; 4],
}

/// A C type that parameter values have.
pub(crate) trait Number: Copy {
    /// As it is.
    fn plain(self) -> f64;
    /// As a colour component.
    fn color(self) -> f32;
}

impl Number for GLint {
    fn plain(self) -> f64 {
        self.into()
    }

    fn color(self) -> f32 {
        signed_to_unit(self)
    }
}

impl Number for GLfloat {
    fn plain(self) -> f64 {
        self.into()
    }

    fn color(self) -> f32 {
        self
    }
}

impl Number for GLdouble {
    fn plain(self) -> f64 {
        self
    }

    fn color(self) -> f32 {
        self as f32
    }
}

impl Params {
    /// The value of a call without `v`.
    pub fn scalar<T: Number>(value: T) -> Self {
        Self { form: Form::Scalar, ..Self::vector(&[value]) }
    }

    /// The values of a call with `v`; only the first four count.
    pub fn vector<T: Number>(values: &[T]) -> Self {
        let mut params =
            Self { form: Form::Vector, len: values.len().min(4), plain: [0.0; 4], color: [0.0; 4] };
        for (at, value) in values.iter().take(4).enumerate() {
            params.plain[at] = value.plain();
            params.color[at] = value.color();
        }
        params
    }

    /// Checks that there are `count` values.
    ///
    /// # Errors
    /// `GL_INVALID_ENUM` for a call without `v`, `GL_INVALID_OPERATION` for a slice too short.
    pub fn need(&self, section: &'static str, pname: GLenum, count: usize) -> Result<()> {
        match self.form {
            Form::Scalar if count > 1 => {
                let name = enum_name(pname);
                let rule =
                    format!("pname = {name} has {count} values: use the call that ends in v");
                invalid_enum(section, rule)
            }
            Form::Vector if self.len < count => {
                let name = enum_name(pname);
                let rule = format!("params has {} of {count} values of {name}", self.len);
                invalid_operation(section, rule)
            }
            Form::Scalar | Form::Vector => Ok(()),
        }
    }

    /// Four colour components.
    pub fn color(&self) -> [f32; 4] {
        self.color
    }

    /// Four numbers.
    pub fn point(&self) -> [f64; 4] {
        self.plain
    }

    /// The first number.
    pub fn number(&self) -> f32 {
        self.plain[0] as f32
    }

    /// The first number as a named constant; a number that is none gives a value that no table has.
    pub fn symbol(&self) -> GLenum {
        symbol(self.number())
    }

    /// The first number as a boolean.
    pub fn truth(&self) -> bool {
        self.plain[0] != 0.0
    }
}

/// A number that must not be negative.
///
/// # Errors
/// `GL_INVALID_VALUE`.
pub(crate) fn at_least_zero(section: &'static str, pname: GLenum, value: f32) -> Result<f32> {
    if value >= 0.0 {
        return Ok(value);
    }
    invalid_value(section, format!("{} = {value} must not be negative", enum_name(pname)))
}
