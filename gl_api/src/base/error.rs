//! GL errors with the rule that was broken, and tables that convert GL's enums to internal types.

use crate::base::constants::*;
use crate::base::types::GLenum;
use crate::glsl::spelling::edit_distance;
use std::fmt;

/// The error flags of GL 2.1, table 2.3, and of framebuffer objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorCode {
    /// `GL_INVALID_ENUM`.
    InvalidEnum,
    /// `GL_INVALID_VALUE`.
    InvalidValue,
    /// `GL_INVALID_OPERATION`.
    InvalidOperation,
    /// `GL_STACK_OVERFLOW`.
    StackOverflow,
    /// `GL_STACK_UNDERFLOW`.
    StackUnderflow,
    /// `GL_OUT_OF_MEMORY`.
    OutOfMemory,
    /// `GL_INVALID_FRAMEBUFFER_OPERATION`.
    InvalidFramebufferOperation,
}

impl ErrorCode {
    /// The value that `glGetError` returns.
    pub fn to_gl(self) -> GLenum {
        match self {
            Self::InvalidEnum => GL_INVALID_ENUM,
            Self::InvalidValue => GL_INVALID_VALUE,
            Self::InvalidOperation => GL_INVALID_OPERATION,
            Self::StackOverflow => GL_STACK_OVERFLOW,
            Self::StackUnderflow => GL_STACK_UNDERFLOW,
            Self::OutOfMemory => GL_OUT_OF_MEMORY,
            Self::InvalidFramebufferOperation => GL_INVALID_FRAMEBUFFER_OPERATION,
        }
    }
}

/// A GL error: the flag, the rule that was broken, and its section. It is no larger than a pointer, as nearly every
/// function returns one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GlError(Box<Refusal>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct Refusal {
    code: ErrorCode,
    rule: String,
    section: &'static str,
}

impl GlError {
    /// An error: `rule` names the argument or state and what it must be; `section` is that of the specification.
    #[cold]
    #[inline(never)]
    pub fn new(code: ErrorCode, section: &'static str, rule: impl Into<String>) -> Self {
        Self(Box::new(Refusal { code, rule: rule.into(), section }))
    }

    /// The flag.
    pub fn code(&self) -> ErrorCode {
        self.0.code
    }
}

impl fmt::Display for GlError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Refusal { code, rule, section } = &*self.0;
        write!(f, "{rule} ({section}); {}", enum_name(code.to_gl()))
    }
}

/// The result of the implementation of an entry point.
pub type Result<T, E = GlError> = std::result::Result<T, E>;

/// `GL_INVALID_ENUM`.
pub fn invalid_enum<T>(section: &'static str, rule: impl Into<String>) -> Result<T> {
    Err(GlError::new(ErrorCode::InvalidEnum, section, rule))
}

/// `GL_INVALID_VALUE`.
pub fn invalid_value<T>(section: &'static str, rule: impl Into<String>) -> Result<T> {
    Err(GlError::new(ErrorCode::InvalidValue, section, rule))
}

/// `GL_INVALID_OPERATION`.
pub fn invalid_operation<T>(section: &'static str, rule: impl Into<String>) -> Result<T> {
    Err(GlError::new(ErrorCode::InvalidOperation, section, rule))
}

/// A size or count as `usize`; negative is `GL_INVALID_VALUE`.
pub fn not_negative(section: &'static str, argument: &str, value: i64) -> Result<usize> {
    match usize::try_from(value) {
        Ok(size) => Ok(size),
        Err(_) => invalid_value(section, format!("{argument} = {value} must not be negative")),
    }
}

/// The GL values that a parameter takes, and the internal value of each.
pub struct Table<T: 'static> {
    /// Where the specification lists them.
    pub section: &'static str,
    /// GL's value and the internal value.
    pub rows: &'static [(GLenum, T)],
}

impl<T: Copy + PartialEq> Table<T> {
    /// The internal value of `value`; `argument` names it in the message.
    ///
    /// # Errors
    /// `GL_INVALID_ENUM`, listing what is possible.
    pub fn decode(&self, argument: &str, value: GLenum) -> Result<T> {
        match self.get(value) {
            Some(meaning) => Ok(meaning),
            None => Err(not_a_choice(self.section, argument, value, &self.values())),
        }
    }

    /// The internal value of `value`, if it is in the table.
    pub fn get(&self, value: GLenum) -> Option<T> {
        self.rows.iter().find(|row| row.0 == value).map(|row| row.1)
    }

    /// GL's value of an internal value: that of the first such row.
    pub fn encode(&self, meaning: T) -> GLenum {
        self.rows.iter().find(|row| row.1 == meaning).map_or(GL_NONE, |row| row.0)
    }

    /// GL's values, in order.
    pub fn values(&self) -> Vec<GLenum> {
        self.rows.iter().map(|row| row.0).collect()
    }

    /// `A, B or C`.
    pub fn list(&self) -> String {
        list(&self.values())
    }
}

/// The error for a value that is none of the choices.
#[cold]
#[inline(never)]
pub(crate) fn not_a_choice(
    section: &'static str,
    argument: &str,
    value: GLenum,
    choices: &[GLenum],
) -> GlError {
    let rule = format!("{argument} = {} {}", enum_name(value), must_be(value, choices));
    GlError::new(ErrorCode::InvalidEnum, section, rule)
}

/// `A, B or C`.
pub fn list(choices: &[GLenum]) -> String {
    let names: Vec<String> = choices.iter().map(|&value| choice_name(value, choices)).collect();
    match names.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
        None => String::new(),
    }
}

/// The name of one of several values. Small values have several names ([`enum_name`]); the other choices tell which.
fn choice_name(value: GLenum, choices: &[GLenum]) -> String {
    let among = |other| choices.contains(&other);
    let name = match value {
        GL_POINTS if among(GL_TRIANGLES) => "GL_POINTS",
        GL_LINES if among(GL_TRIANGLES) => "GL_LINES",
        GL_TRIANGLES => "GL_TRIANGLES",
        GL_FALSE if among(GL_FIXED_ONLY) => "GL_FALSE",
        GL_TRUE if among(GL_FIXED_ONLY) => "GL_TRUE",
        GL_NONE if among(GL_COMPARE_R_TO_TEXTURE) => "GL_NONE",
        GL_ZERO => "GL_ZERO",
        GL_ONE => "GL_ONE",
        _ => return enum_name(value),
    };
    name.to_owned()
}

/// `must be A, B or C`, for a `value` that is none of the choices; of many choices, those with the most similar names.
pub fn must_be(value: GLenum, choices: &[GLenum]) -> String {
    /// Longer lists are cut: nobody reads them.
    const LISTED: usize = 20;
    const SHOWN: usize = 5;
    if choices.len() <= LISTED {
        return format!("must be {}", list(choices));
    }
    let name = enum_name(value);
    let names: Vec<String> = choices.iter().map(|&choice| choice_name(choice, choices)).collect();
    let mut near: Vec<(usize, &str)> = names
        .iter()
        .filter_map(|other| Some((edit_distance(&name, other, name.len() / 3)?, other.as_str())))
        .collect();
    near.sort_by_key(|&(distance, _)| distance);
    let near: Vec<&str> = near.into_iter().map(|(_, other)| other).take(SHOWN).collect();
    let count = names.len();
    match near.is_empty() {
        false => format!("must be one of {count} values; near in name: {}", near.join(", ")),
        true => format!("must be one of {count} values, such as {}", names[..SHOWN].join(", ")),
    }
}
