//! Text that C gives, and memory for text that it is given.

use super::{Arguments, Counted, Param, TERMINATED, collect};
use crate::memory;
use gl_api::{Names, Strings, TextOut, with_current};
use std::borrow::Cow;
use std::ffi::{CStr, c_char};

/// What stands for a byte that is no UTF-8, so that lengths stay.
#[derive(Clone, Copy)]
enum Replacement {
    /// A question mark, for eyes.
    QuestionMark,
    /// The control character SUB, which no shading language has outside of comments, as the byte itself.
    Substitute,
}

impl Replacement {
    fn character(self) -> char {
        match self {
            Self::QuestionMark => '?',
            Self::Substitute => '\u{1a}',
        }
    }
}

/// Text of C's; empty if there is no memory for it.
fn utf8(bytes: &[u8], replacement: Replacement) -> String {
    let mut text = String::new();
    if text.try_reserve_exact(bytes.len()).is_err() {
        return text;
    }
    match std::str::from_utf8(bytes) {
        Ok(valid) => text.push_str(valid),
        Err(_) => {
            let shown = |&b: &u8| match b.is_ascii() {
                true => char::from(b),
                false => replacement.character(),
            };
            text.extend(bytes.iter().map(shown));
        }
    }
    text
}

/// `length` bytes of C's, or [`TERMINATED`]; nothing for the null pointer.
///
/// # Safety
/// A pointer that is not null has that length.
unsafe fn text(raw: *const c_char, length: usize, replacement: Replacement) -> Cow<'static, str> {
    if raw.is_null() {
        return Cow::Borrowed("");
    }
    // SAFETY: promised by the caller.
    let bytes = unsafe {
        if length == TERMINATED {
            CStr::from_ptr(raw).to_bytes()
        } else {
            memory::bytes(raw.cast(), length)
        }
    };
    Cow::Owned(utf8(bytes, replacement))
}

impl<'a> Param<'a> for &'a str {
    type Raw = *const c_char;
    type Held = Cow<'static, str>;
    const COUNTED: Counted = Counted::Text;

    fn number(raw: *const c_char) -> isize {
        raw.addr() as isize
    }

    unsafe fn hold(raw: *const c_char, length: usize, _: &Arguments<'_>) -> Cow<'static, str> {
        // SAFETY: promised by the caller.
        unsafe { text(raw, length, Replacement::QuestionMark) }
    }

    fn lend(held: &'a mut Cow<'static, str>) -> &'a str {
        held
    }
}

/// `glShaderSource` alone has this type: its last argument is the array of lengths.
impl<'a> Param<'a> for Strings<'a> {
    type Raw = *const *const c_char;
    type Held = Vec<Cow<'static, str>>;
    const COUNTED: Counted = Counted::Elements;

    fn number(raw: *const *const c_char) -> isize {
        raw.addr() as isize
    }

    unsafe fn hold(
        raw: *const *const c_char,
        length: usize,
        call: &Arguments<'_>,
    ) -> Vec<Cow<'static, str>> {
        // Of a name that is no shader's the strings are not looked at.
        let arguments = call.numbers;
        let shader = arguments.first().map_or(0, |&name| name as u32);
        if raw.is_null() || with_current(|context| context.is_shader(shader)) != Some(true) {
            return Vec::new();
        }
        let lengths = arguments.last().map_or(0, |&lengths| lengths as usize);
        let lengths = std::ptr::with_exposed_provenance::<i32>(lengths);
        collect(length, |at| {
            // SAFETY: promised by the caller: `length` pointers, and as many lengths if any.
            let (text, length) = unsafe {
                let length = if lengths.is_null() { -1 } else { lengths.add(at).read_unaligned() };
                (raw.add(at).read_unaligned(), length)
            };
            // SAFETY: so many bytes, or a negative length, which says that a zero ends it.
            unsafe {
                let length = usize::try_from(length).unwrap_or(TERMINATED);
                self::text(text, length, Replacement::Substitute)
            }
        })
    }

    fn lend(held: &'a mut Vec<Cow<'static, str>>) -> Self {
        Strings(held.iter().map(AsRef::as_ref).collect())
    }
}

/// `glTransformFeedbackVaryings`, `glGetUniformIndices` and `glCreateShaderProgramv` have this type.
impl<'a> Param<'a> for Names<'a> {
    type Raw = *const *const c_char;
    type Held = Vec<Cow<'static, str>>;
    const COUNTED: Counted = Counted::Elements;

    fn number(raw: *const *const c_char) -> isize {
        raw.addr() as isize
    }

    unsafe fn hold(
        raw: *const *const c_char,
        length: usize,
        call: &Arguments<'_>,
    ) -> Vec<Cow<'static, str>> {
        // Of a name that is no program's, or of no stage, the strings are not looked at.
        let is_looked_at = match *call.numbers {
            [stage, _, _] => {
                let stages = [
                    gl_api::GL_VERTEX_SHADER,
                    gl_api::GL_GEOMETRY_SHADER,
                    gl_api::GL_FRAGMENT_SHADER,
                ];
                stages.contains(&(stage as u32))
            }
            [program, ..] => {
                with_current(|context| context.is_program(program as u32)) == Some(true)
            }
            [] => false,
        };
        if raw.is_null() || !is_looked_at {
            return Vec::new();
        }
        // SAFETY: promised by the caller: `length` pointers to texts that zeros end.
        collect(length, |at| unsafe {
            text(raw.add(at).read_unaligned(), TERMINATED, Replacement::QuestionMark)
        })
    }

    fn lend(held: &'a mut Vec<Cow<'static, str>>) -> Self {
        Names(held.iter().map(AsRef::as_ref).collect())
    }
}

impl<'a> Param<'a> for TextOut<'a> {
    type Raw = *mut c_char;
    type Held = (*mut c_char, usize);
    const COUNTED: Counted = Counted::Elements;
    const ELEMENT: usize = 1;

    fn number(raw: *mut c_char) -> isize {
        raw.addr() as isize
    }

    unsafe fn hold(raw: *mut c_char, length: usize, _: &Arguments<'_>) -> (*mut c_char, usize) {
        (raw, length)
    }

    fn lend(&mut (raw, length): &'a mut (*mut c_char, usize)) -> Self {
        if raw.is_null() {
            return TextOut::Null;
        }
        // SAFETY: promised to `hold`.
        TextOut::Bytes(unsafe { memory::bytes_mut(raw.cast(), length) })
    }
}
