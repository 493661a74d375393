//! What an entry point answers when it refuses a call, and the tables that convert enums at the
//! door.

use crate::constants::*;
use crate::types::GLenum;
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
    /// What `glGetError` answers.
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

/// A refused call: the flag, the rule that was broken, and where the rule stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GlError {
    /// The flag.
    pub code: ErrorCode,
    /// Which argument or state, and what it must be.
    pub rule: String,
    /// The section of the specification.
    pub section: &'static str,
}

impl fmt::Display for GlError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({}); {}", self.rule, self.section, enum_name(self.code.to_gl()))
    }
}

/// What the implementation of an entry point answers.
pub type Result<T, E = GlError> = std::result::Result<T, E>;

/// A refusal with `GL_INVALID_ENUM`.
pub fn invalid_enum<T>(section: &'static str, rule: impl Into<String>) -> Result<T> {
    Err(GlError { code: ErrorCode::InvalidEnum, rule: rule.into(), section })
}

/// A refusal with `GL_INVALID_VALUE`.
pub fn invalid_value<T>(section: &'static str, rule: impl Into<String>) -> Result<T> {
    Err(GlError { code: ErrorCode::InvalidValue, rule: rule.into(), section })
}

/// A refusal with `GL_INVALID_OPERATION`.
pub fn invalid_operation<T>(section: &'static str, rule: impl Into<String>) -> Result<T> {
    Err(GlError { code: ErrorCode::InvalidOperation, rule: rule.into(), section })
}

/// A size or count as `usize`; negative is `GL_INVALID_VALUE`.
pub fn not_negative(section: &'static str, argument: &str, value: i64) -> Result<usize> {
    match usize::try_from(value) {
        Ok(size) => Ok(size),
        Err(_) => invalid_value(section, format!("{argument} = {value} must not be negative")),
    }
}

/// The values that a parameter takes, and what they mean inside.
pub struct Table<T: 'static> {
    /// Where the specification lists them.
    pub section: &'static str,
    /// GL's value and ours.
    pub rows: &'static [(GLenum, T)],
}

impl<T: Copy + PartialEq> Table<T> {
    /// What `value` means; `argument` names it in the message.
    ///
    /// # Errors
    /// `GL_INVALID_ENUM`, listing what is possible.
    pub fn decode(&self, argument: &str, value: GLenum) -> Result<T> {
        match self.get(value) {
            Some(meaning) => Ok(meaning),
            None => invalid_enum(
                self.section,
                format!("{argument} = {} must be {}", enum_name(value), self.list()),
            ),
        }
    }

    /// What `value` means, if it is in the table.
    pub fn get(&self, value: GLenum) -> Option<T> {
        self.rows.iter().find(|row| row.0 == value).map(|row| row.1)
    }

    /// GL's value for what `get` and `decode` answer; the first row where several mean the same.
    pub fn encode(&self, meaning: T) -> GLenum {
        self.rows.iter().find(|row| row.1 == meaning).map_or(GL_NONE, |row| row.0)
    }

    /// `A, B or C`.
    pub fn list(&self) -> String {
        let names: Vec<String> = self.rows.iter().map(|row| enum_name(row.0)).collect();
        match names.split_last() {
            Some((last, [])) => last.clone(),
            Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
            None => String::new(),
        }
    }
}
