//! Rust's arguments as C takes them, and C's results.

use gl_api::{Data, DataOut, GLDEBUGPROC, Names, Pointers, Strings, TextOut};
use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char, c_void};
use std::ptr::{null, null_mut};

/// A type of a parameter.
pub(super) trait Passed<'a>: Sized {
    /// C's type.
    type Raw: Copy;
    /// What lives as long as the call.
    type Held;
    /// Takes the argument of this name.
    fn hold(self, name: &str) -> Self::Held;
    /// C's argument.
    fn raw(held: &mut Self::Held) -> Self::Raw;
    /// After the call.
    fn finish(_: Self::Held) {}
}

macro_rules! plain {
    ($($ty:ty),*) => { $(
        impl Passed<'_> for $ty {
            type Raw = $ty;
            type Held = $ty;

            fn hold(self, _: &str) -> $ty {
                self
            }

            fn raw(held: &mut $ty) -> $ty {
                *held
            }
        }
    )* };
}

plain!(i8, u8, i16, u16, i32, u32, i64, u64, isize, usize, f32, f64);
plain!(*const c_void, *mut c_void, GLDEBUGPROC);

impl Passed<'_> for bool {
    type Raw = u8;
    type Held = u8;

    fn hold(self, _: &str) -> u8 {
        self.into()
    }

    fn raw(held: &mut u8) -> u8 {
        *held
    }
}

impl<'a, T: Copy> Passed<'a> for &'a [T] {
    type Raw = *const T;
    type Held = Self;

    fn hold(self, _: &str) -> Self {
        self
    }

    fn raw(held: &mut Self) -> *const T {
        if held.is_empty() { null() } else { held.as_ptr() }
    }
}

impl<'a, T: Copy> Passed<'a> for &'a mut [T] {
    type Raw = *mut T;
    type Held = Self;

    fn hold(self, _: &str) -> Self {
        self
    }

    fn raw(held: &mut Self) -> *mut T {
        if held.is_empty() { null_mut() } else { held.as_mut_ptr() }
    }
}

impl<'a> Passed<'a> for Data<'a> {
    type Raw = *const c_void;
    type Held = *const c_void;

    fn hold(self, name: &str) -> *const c_void {
        match self {
            // DetGL copies arrays of vertices when the call says where they are; C reads them when it draws.
            Data::Bytes(bytes) if name == "pointer" => bytes.to_vec().leak().as_ptr().cast(),
            Data::Bytes(bytes) => bytes.as_ptr().cast(),
            Data::Offset(offset) => std::ptr::without_provenance(offset),
            Data::Null | Data::Client(_) => null(),
        }
    }

    fn raw(held: &mut *const c_void) -> *const c_void {
        *held
    }
}

/// Words of the memory that is kept for feedback and selection.
const KEPT: usize = 1 << 16;

thread_local! {
    static WORDS: RefCell<&'static mut [u32]> = const { RefCell::new(&mut []) };
}

/// What feedback or selection has written.
pub(super) fn kept_words() -> Vec<u32> {
    WORDS.with_borrow(|words| words.to_vec())
}

fn keep_words() -> *mut c_void {
    WORDS.with_borrow_mut(|words| {
        if words.is_empty() {
            *words = vec![0; KEPT].leak();
        }
        words.as_mut_ptr().cast()
    })
}

impl<'a> Passed<'a> for DataOut<'a> {
    type Raw = *mut c_void;
    type Held = *mut c_void;

    fn hold(self, name: &str) -> *mut c_void {
        match self {
            DataOut::Bytes(bytes) => bytes.as_mut_ptr().cast(),
            DataOut::Offset(offset) => std::ptr::without_provenance_mut(offset),
            // Of `glFeedbackBuffer` and `glSelectBuffer`, where DetGL has memory of its own.
            DataOut::Null if name == "buffer" => keep_words(),
            DataOut::Null | DataOut::Client(_) => null_mut(),
        }
    }

    fn raw(held: &mut *mut c_void) -> *mut c_void {
        *held
    }
}

/// A nul-terminated copy, cut at the first nul.
fn nul_terminated(text: &str) -> CString {
    let text = text.split('\0').next().unwrap_or_default();
    CString::new(text).unwrap_or_default()
}

impl<'a> Passed<'a> for &'a str {
    type Raw = *const c_char;
    type Held = CString;

    fn hold(self, _: &str) -> CString {
        nul_terminated(self)
    }

    fn raw(held: &mut CString) -> *const c_char {
        held.as_ptr()
    }
}

/// Texts, and pointers to them.
pub(super) struct Texts {
    _texts: Vec<CString>,
    pointers: Vec<*const c_char>,
}

impl Texts {
    fn new(texts: &[&str]) -> Self {
        let texts: Vec<CString> = texts.iter().map(|text| nul_terminated(text)).collect();
        let pointers = texts.iter().map(|text| text.as_ptr()).collect();
        Self { _texts: texts, pointers }
    }
}

macro_rules! texts {
    ($($ty:ident),*) => { $(
        impl<'a> Passed<'a> for $ty<'a> {
            type Raw = *const *const c_char;
            type Held = Texts;

            fn hold(self, _: &str) -> Texts {
                Texts::new(&self.0)
            }

            fn raw(held: &mut Texts) -> *const *const c_char {
                held.pointers.as_ptr()
            }
        }
    )* };
}

texts!(Strings, Names);

impl<'a> Passed<'a> for Pointers<'a> {
    type Raw = *const *const c_void;
    type Held = Vec<*const c_void>;

    fn hold(self, _: &str) -> Vec<*const c_void> {
        self.0.into_iter().map(|data| data.hold("")).collect()
    }

    fn raw(held: &mut Vec<*const c_void>) -> *const *const c_void {
        held.as_ptr()
    }
}

/// Bytes of a text that replaces a string.
const LONGEST_TEXT: usize = 1 << 20;

/// Memory for a text, and the string that it replaces.
pub(super) struct Text<'a> {
    out: TextOut<'a>,
    memory: Vec<u8>,
}

impl<'a> Passed<'a> for TextOut<'a> {
    type Raw = *mut c_char;
    type Held = Text<'a>;

    fn hold(self, _: &str) -> Text<'a> {
        let length = match &self {
            TextOut::String(_) => LONGEST_TEXT,
            TextOut::Bytes(_) | TextOut::Null => 0,
        };
        Text { out: self, memory: vec![0; length] }
    }

    fn raw(held: &mut Text<'a>) -> *mut c_char {
        match &mut held.out {
            TextOut::Bytes(bytes) => bytes.as_mut_ptr().cast(),
            TextOut::String(_) => held.memory.as_mut_ptr().cast(),
            TextOut::Null => null_mut(),
        }
    }

    fn finish(held: Text<'a>) {
        if let (TextOut::String(string), Ok(text)) =
            (held.out, CStr::from_bytes_until_nul(&held.memory))
        {
            *string = text.to_string_lossy().into_owned();
        }
    }
}

/// A type of a result.
pub(super) trait Answer {
    /// C's type.
    type Raw;
    /// The conversion.
    fn of(raw: Self::Raw) -> Self;
    /// What there is where the library has no such function.
    fn none() -> Self;
}

macro_rules! answers {
    ($($ty:ty: $none:expr;)*) => { $(
        impl Answer for $ty {
            type Raw = $ty;

            fn of(raw: $ty) -> $ty {
                raw
            }

            fn none() -> $ty {
                $none
            }
        }
    )* };
}

answers! {
    (): ();
    u32: 0;
    i32: -1;
    *mut c_void: null_mut();
}

impl Answer for bool {
    type Raw = u8;

    fn of(raw: u8) -> bool {
        raw != 0
    }

    fn none() -> bool {
        false
    }
}

impl Answer for &'static str {
    type Raw = *const c_char;

    fn of(raw: *const c_char) -> &'static str {
        if raw.is_null() {
            return "";
        }
        // SAFETY: GL's strings end with a zero and live as long as the library.
        unsafe { CStr::from_ptr(raw) }.to_str().unwrap_or_default()
    }

    fn none() -> &'static str {
        ""
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments_of_c() {
        assert_eq!(<bool as Passed>::raw(&mut true.hold("")), 1);
        let mut none = [0u32; 0].as_slice().hold("");
        assert!(<&[u32] as Passed>::raw(&mut none).is_null());
        let mut texts = Strings(vec!["one", "two\0three"]).hold("");
        assert_eq!(texts._texts[1].to_bytes(), b"two");
        assert!(!<Strings as Passed>::raw(&mut texts).is_null());
        let mut string = String::new();
        let mut held = TextOut::String(&mut string).hold("");
        held.memory[0] = b'x';
        assert!(!<TextOut as Passed>::raw(&mut held).is_null());
        <TextOut as Passed>::finish(held);
        assert_eq!(string, "x");
        assert_eq!(Data::Offset(12).hold("").addr(), 12);
    }
}
