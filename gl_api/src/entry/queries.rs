//! State queries: GL 2.1, chapter 6; and the end of commands: section 5.5.

use crate::query::{extensions, flush, get};
use crate::types::*;

entry_points! {
    QUERIES;
    Outside in extensions {
        /// Vendor, renderer, version, extensions; empty for other names.
        get_string: glGetString (name: GLenum) -> &'static str;
        /// The name of an extension.
        get_stringi: glGetStringi (name: GLenum, index: GLuint) -> &'static str;
    }
    Outside in get {
        /// The first error since the last call, or `GL_NO_ERROR`.
        get_error: glGetError () -> GLenum;
        /// Reads state as truth values.
        get_booleanv: glGetBooleanv (pname: GLenum, params: &'a mut [GLboolean]);
        /// Reads state as integers.
        get_integerv: glGetIntegerv (pname: GLenum, params: &'a mut [GLint]);
        /// Reads state as single precision.
        get_floatv: glGetFloatv (pname: GLenum, params: &'a mut [GLfloat]);
        /// Reads state as double precision.
        get_doublev: glGetDoublev (pname: GLenum, params: &'a mut [GLdouble]);
    }
    Outside in flush {
        /// Carries out what was recorded.
        flush: glFlush ();
        /// Carries out what was recorded and waits for it.
        finish: glFinish ();
    }
}
