//! What OpenGL ES 3.0 has of OpenGL: commands and values of enums, by the Khronos registry and the extensions that
//! are announced.

use super::availability::{COMMANDS_OF_ES, VALUES_OUTSIDE_ES, has_name};
use super::constants::*;
use super::core_profile::{Argument, enum_of, replacement};
use super::error::{ErrorCode, GlError};
use super::limits::MAX_COLOR_ATTACHMENTS;
use super::types::GLenum;

const SECTION: &str = "OpenGL ES 3.0";

/// Whether OpenGL ES has a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InEs {
    /// In version 3.0 or by an announced extension.
    There,
    /// Only OpenGL has it.
    Absent,
}

impl InEs {
    /// Of a command with these names.
    pub const fn of(names: &[&str]) -> Self {
        let mut at = 0;
        while at < names.len() {
            if has_name(&COMMANDS_OF_ES, names[at]) {
                return Self::There;
            }
            at += 1;
        }
        Self::Absent
    }
}

/// The first rule of OpenGL ES that a call breaks.
#[inline(never)]
pub fn check(command: &'static str, in_es: InEs, arguments: &[Argument]) -> Result<(), GlError> {
    if in_es == InEs::Absent {
        let rule = format!("is no command of OpenGL ES{}", replacement(command));
        return Err(GlError::new(ErrorCode::InvalidOperation, SECTION, rule));
    }
    arguments.iter().try_for_each(check_argument)
}

fn check_argument(argument: &Argument) -> Result<(), GlError> {
    let Argument { name, ty, value } = *argument;
    match (ty, name) {
        // Of glTexImage: numbers of components are no formats.
        ("GLint", "internalformat") if (1..=4).contains(&value) => {
            let rule = format!(
                "internalformat = {value}: OpenGL ES has no numbers of components; name a format, as GL_RGBA8"
            );
            return Err(GlError::new(ErrorCode::InvalidValue, SECTION, rule));
        }
        ("GLint", "border") if value != 0 => {
            let rule = format!("border = {value} must be 0: textures of OpenGL ES have no borders");
            return Err(GlError::new(ErrorCode::InvalidValue, SECTION, rule));
        }
        // Of glVertexAttribPointer: GL_BGRA is OpenGL's alone.
        ("GLint", "size") if value == i64::from(GL_BGRA) => {
            let rule = "size = GL_BGRA must be 1, 2, 3 or 4: OpenGL ES has no other order";
            return Err(GlError::new(ErrorCode::InvalidValue, SECTION, rule));
        }
        (_, _) => {}
    }
    // The names of attachments are known, there are fewer (section 4.4.2).
    let is_attachment = |symbol: i64| {
        symbol >= GL_COLOR_ATTACHMENT0.into() && symbol <= GL_COLOR_ATTACHMENT31.into()
    };
    if name == "attachment" && is_attachment(value) {
        let most = i64::from(GL_COLOR_ATTACHMENT0) + MAX_COLOR_ATTACHMENTS as i64 - 1;
        if value > most {
            let rule = format!(
                "attachment = {} must be GL_COLOR_ATTACHMENT0 to {}",
                enum_name(value as GLenum),
                MAX_COLOR_ATTACHMENTS - 1
            );
            return Err(GlError::new(ErrorCode::InvalidOperation, SECTION, rule));
        }
    }
    let Some((symbol, code)) = enum_of(argument) else { return Ok(()) };
    // The values of these modes are too small to be told apart from others.
    if name == "mode" && matches!(symbol, 7..=13) {
        let rule = format!("mode = {symbol:#06x} is none of OpenGL ES; draw triangles");
        return Err(GlError::new(code, SECTION, rule));
    }
    // GL_TEXTUREi has the values of other enums from 32 on; glActiveTexture knows how many there are.
    if name == "texture" {
        return Ok(());
    }
    if VALUES_OUTSIDE_ES.binary_search(&symbol).is_ok() {
        return Err(foreign_value(name, symbol, code));
    }
    Ok(())
}

/// The error for an argument whose value OpenGL ES does not have.
#[cold]
pub fn foreign_value(argument: &str, value: GLenum, code: ErrorCode) -> GlError {
    let name = enum_name(value);
    let instead = replacement(&name);
    GlError::new(code, SECTION, format!("{argument} = {name} is none of OpenGL ES{instead}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_there_as_the_registry_says() {
        let there = |name: &str| InEs::of(&[name]) == InEs::There;
        for name in ["glBindTexture", "glTexStorage2D", "glClearDepthf", "glMapBufferOES"] {
            assert!(there(name), "{name}");
        }
        for name in ["glBegin", "glClearDepth", "glPolygonMode", "glTexImage1D", "glMapBuffer"] {
            assert!(!there(name), "{name}");
        }
        assert_eq!(InEs::of(&["glMapBuffer", "glMapBufferOES"]), InEs::There);
    }

    #[test]
    fn values_are_foreign_that_only_opengl_has() {
        for value in [GL_TEXTURE_1D, GL_TEXTURE_RECTANGLE, GL_DOUBLE, GL_CLAMP, GL_MULTISAMPLE] {
            assert!(VALUES_OUTSIDE_ES.binary_search(&value).is_ok(), "{}", enum_name(value));
        }
        for value in [GL_TEXTURE_2D, GL_LUMINANCE, GL_FIXED, GL_RGB565, GL_BGRA, GL_DITHER] {
            assert!(VALUES_OUTSIDE_ES.binary_search(&value).is_err(), "{}", enum_name(value));
        }
    }

    #[test]
    fn the_message_says_what_takes_the_place() {
        let error = check("glRotatef", InEs::Absent, &[]).expect_err("it is none");
        assert!(error.to_string().contains("glUniformMatrix4fv"), "{error}");
    }
}
