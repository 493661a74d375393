//! C's names for the types of GL 2.1, table 2.2.

/// A named constant.
pub type GLenum = u32;
/// Bits.
pub type GLbitfield = u32;
/// What a pointer without a type points to.
pub type GLvoid = std::ffi::c_void;
/// A truth value in memory: 0 or 1. Parameters and results are `bool`.
pub type GLboolean = u8;
/// 8 bits, signed.
pub type GLbyte = i8;
/// 8 bits.
pub type GLubyte = u8;
/// 16 bits, signed.
pub type GLshort = i16;
/// 16 bits.
pub type GLushort = u16;
/// 32 bits, signed.
pub type GLint = i32;
/// 32 bits.
pub type GLuint = u32;
/// A size; negative ones are errors.
pub type GLsizei = i32;
/// Single precision.
pub type GLfloat = f32;
/// Single precision, clamped to [0, 1].
pub type GLclampf = f32;
/// Double precision.
pub type GLdouble = f64;
/// Double precision, clamped to [0, 1].
pub type GLclampd = f64;
/// A character of a text.
pub type GLchar = std::ffi::c_char;
/// A fence.
pub type GLsync = *mut GLvoid;
/// An EGL image.
pub type GLeglImageOES = *mut GLvoid;
/// 64 bits, signed.
pub type GLint64 = i64;
/// 64 bits.
pub type GLuint64 = u64;
/// A place in a buffer object.
pub type GLintptr = isize;
/// A size of a buffer object.
pub type GLsizeiptr = isize;
