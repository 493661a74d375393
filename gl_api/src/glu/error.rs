//! GLU's own error codes, the words for them and for GL's, and GLU's version.

use crate::base::constants::*;
use crate::base::types::GLenum;

/// What a GLU function answers for an enumerant it does not know.
pub const GLU_INVALID_ENUM: GLenum = 100_900;
/// What a GLU function answers for a size out of range, or a pixel slice that is too short.
pub const GLU_INVALID_VALUE: GLenum = 100_901;
/// What a GLU function answers when there is not enough memory.
pub const GLU_OUT_OF_MEMORY: GLenum = 100_902;
/// What a GLU function answers for a format and type that do not go together.
pub const GLU_INVALID_OPERATION: GLenum = 100_904;

/// The name of GLU's version for [`gluGetString`].
pub const GLU_VERSION: GLenum = 100_800;
/// The name of GLU's extensions for [`gluGetString`].
pub const GLU_EXTENSIONS: GLenum = 100_801;

/// What there is of GLU; `None` for a name that is neither [`GLU_VERSION`] nor [`GLU_EXTENSIONS`].
pub fn gluGetString(name: GLenum) -> Option<&'static str> {
    match name {
        GLU_VERSION => Some("1.3"),
        GLU_EXTENSIONS => Some(""),
        _ => None,
    }
}

/// Whether a list of extensions, as `glGetString` gives it, has one of this name.
pub fn gluCheckExtension(name: &str, list: &str) -> bool {
    list.split_ascii_whitespace().any(|other| other == name)
}

/// The words for an error code of GL or GLU; `None` for a number that is no error code.
pub fn gluErrorString(error: GLenum) -> Option<&'static str> {
    Some(match error {
        GL_NO_ERROR => "no error",
        GL_INVALID_ENUM => "invalid enumerant",
        GL_INVALID_VALUE => "invalid value",
        GL_INVALID_OPERATION => "invalid operation",
        GL_STACK_OVERFLOW => "stack overflow",
        GL_STACK_UNDERFLOW => "stack underflow",
        GL_OUT_OF_MEMORY => "out of memory",
        GL_INVALID_FRAMEBUFFER_OPERATION => "invalid framebuffer operation",
        GL_TABLE_TOO_LARGE => "table too large",
        GLU_INVALID_ENUM => "invalid enumerant",
        GLU_INVALID_VALUE => "invalid value",
        GLU_OUT_OF_MEMORY => "out of memory",
        GLU_INVALID_OPERATION => "invalid operation",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_of_both_libraries_have_words_and_others_have_none() {
        for (code, words) in [
            (0, Some("no error")),
            (0x0500, Some("invalid enumerant")),
            (0x0506, Some("invalid framebuffer operation")),
            (100_901, Some("invalid value")),
            (666, None),
        ] {
            assert_eq!(gluErrorString(code), words);
        }
    }
}
