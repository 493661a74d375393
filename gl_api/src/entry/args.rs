//! What a parameter of an entry point accepts: what C would convert implicitly, and slices where C
//! has pointers.

use crate::abi::memory::ClientPointer;
use crate::context::GLDEBUGPROC;
use crate::types::GLuint;
use bytemuck::{NoUninit, Pod};

/// Something that can be passed where an entry point expects a `T`.
pub trait Arg<T> {
    /// The conversion.
    fn arg(self) -> T;
}

macro_rules! numbers {
    ($($from:ty),* => $to:tt) => {
        $(impl Arg<$to> for $from {
            #[inline]
            fn arg(self) -> $to {
                self as $to
            }
        })*
        impl Arg<$to> for bool {
            #[inline]
            fn arg(self) -> $to {
                u8::from(self) as $to
            }
        }
    };
    ($($to:tt),*) => {
        $(numbers!(i8, u8, i16, u16, i32, u32, i64, u64, isize, usize, f32, f64 => $to);)*
    };
}

// Out-of-range floats saturate, where C leaves the result open; integers wrap, as in C.
numbers!(i8, u8, i16, u16, i32, u32, i64, u64, isize, usize, f32, f64);

macro_rules! truth {
    ($($from:ty),*) => {
        $(impl Arg<bool> for $from {
            #[inline]
            fn arg(self) -> bool {
                self != (0 as $from)
            }
        })*
    };
}

truth!(i8, u8, i16, u16, i32, u32, i64, u64, isize, usize, f32, f64);

impl Arg<bool> for bool {
    #[inline]
    fn arg(self) -> bool {
        self
    }
}

/// C's null pointer, where a call needs no data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Null;

/// C's null pointer, where a call needs no data.
pub const NULL: Null = Null;

/// A byte offset into the bound buffer object, where C casts it to a pointer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Offset(pub usize);

/// A byte offset into the bound buffer object, as the macro of that name in C.
#[allow(non_snake_case, reason = "C's name")]
pub fn BUFFER_OFFSET(bytes: impl Arg<usize>) -> Offset {
    Offset(bytes.arg())
}

/// Where C has a `const void *`: memory, nothing, or an offset into the bound buffer object.
#[derive(Clone, Copy, Debug)]
pub enum Data<'a> {
    /// The client's memory, as bytes.
    Bytes(&'a [u8]),
    /// An offset into the bound buffer object.
    Offset(usize),
    /// Nothing; with a buffer object bound, offset 0.
    Null,
    /// A pointer of C's: any of these, as the call finds.
    Client(ClientPointer<'a>),
}

/// [`Data`], as a call sees it that knows whether a buffer object is bound.
pub(crate) enum Located<'a> {
    /// The client's memory.
    Bytes(&'a [u8]),
    /// An offset into the bound buffer object.
    Offset(usize),
    /// Nothing; with a buffer object bound, offset 0.
    Null,
}

impl<'a> Data<'a> {
    /// What this is for a call that reads `needed` bytes; `buffer` is the bound buffer object's
    /// name, or 0. A pointer of C's then is an offset, or memory of that length.
    pub(crate) fn locate(self, buffer: GLuint, needed: usize) -> Located<'a> {
        match self {
            Self::Bytes(bytes) => Located::Bytes(bytes),
            Self::Offset(offset) => Located::Offset(offset),
            Self::Null => Located::Null,
            Self::Client(pointer) if buffer != 0 => Located::Offset(pointer.offset()),
            Self::Client(pointer) if pointer.is_null() => Located::Null,
            Self::Client(pointer) => Located::Bytes(pointer.bytes(needed)),
        }
    }
}

impl<'a> Arg<Data<'a>> for Data<'a> {
    fn arg(self) -> Data<'a> {
        self
    }
}

impl<'a, T: NoUninit> Arg<Data<'a>> for &'a [T] {
    fn arg(self) -> Data<'a> {
        Data::Bytes(bytemuck::cast_slice(self))
    }
}

impl<'a, T: NoUninit, const N: usize> Arg<Data<'a>> for &'a [T; N] {
    fn arg(self) -> Data<'a> {
        self.as_slice().arg()
    }
}

impl<'a, T: NoUninit> Arg<Data<'a>> for &'a Vec<T> {
    fn arg(self) -> Data<'a> {
        self.as_slice().arg()
    }
}

impl<'a, T: NoUninit> Arg<Data<'a>> for &'a Box<[T]> {
    fn arg(self) -> Data<'a> {
        (**self).arg()
    }
}

impl<'a> Arg<Data<'a>> for Null {
    fn arg(self) -> Data<'a> {
        Data::Null
    }
}

impl<'a> Arg<Data<'a>> for Offset {
    fn arg(self) -> Data<'a> {
        Data::Offset(self.0)
    }
}

impl<'a> Arg<Data<'a>> for i32 {
    fn arg(self) -> Data<'a> {
        Data::Offset(Arg::<usize>::arg(self))
    }
}

impl<'a> Arg<Data<'a>> for usize {
    fn arg(self) -> Data<'a> {
        Data::Offset(self)
    }
}

/// Where C has an array of `const void *`.
#[derive(Clone, Debug)]
pub struct Pointers<'a>(pub Vec<Data<'a>>);

impl<'a> Arg<Pointers<'a>> for Pointers<'a> {
    fn arg(self) -> Self {
        self
    }
}

impl<'a, T: Copy + Arg<Data<'a>>> Arg<Pointers<'a>> for &[T] {
    fn arg(self) -> Pointers<'a> {
        Pointers(self.iter().map(|&pointer| pointer.arg()).collect())
    }
}

impl<'a, T: Copy + Arg<Data<'a>>, const N: usize> Arg<Pointers<'a>> for &[T; N] {
    fn arg(self) -> Pointers<'a> {
        self.as_slice().arg()
    }
}

/// Where C has a `void *` that the call writes to.
#[derive(Debug)]
pub enum DataOut<'a> {
    /// The client's memory, as bytes.
    Bytes(&'a mut [u8]),
    /// An offset into the bound buffer object.
    Offset(usize),
    /// Nowhere.
    Null,
    /// A pointer of C's: any of these, as the call finds.
    Client(ClientPointer<'a>),
}

/// [`DataOut`], as a call sees it that knows whether a buffer object is bound.
pub(crate) enum LocatedOut<'a> {
    /// The client's memory.
    Bytes(&'a mut [u8]),
    /// An offset into the bound buffer object.
    Offset(usize),
    /// Nowhere.
    Null,
}

impl<'a> DataOut<'a> {
    /// What this is for a call that writes `needed` bytes; as [`Data::locate`].
    pub(crate) fn locate(self, buffer: GLuint, needed: usize) -> LocatedOut<'a> {
        match self {
            Self::Bytes(bytes) => LocatedOut::Bytes(bytes),
            Self::Offset(offset) => LocatedOut::Offset(offset),
            Self::Null => LocatedOut::Null,
            Self::Client(pointer) if buffer != 0 => LocatedOut::Offset(pointer.offset()),
            Self::Client(pointer) if pointer.is_null() => LocatedOut::Null,
            Self::Client(pointer) => LocatedOut::Bytes(pointer.bytes_mut(needed)),
        }
    }
}

impl<'a> Arg<DataOut<'a>> for DataOut<'a> {
    fn arg(self) -> DataOut<'a> {
        self
    }
}

impl<'a, T: Pod> Arg<DataOut<'a>> for &'a mut [T] {
    fn arg(self) -> DataOut<'a> {
        DataOut::Bytes(bytemuck::cast_slice_mut(self))
    }
}

impl<'a, T: Pod, const N: usize> Arg<DataOut<'a>> for &'a mut [T; N] {
    fn arg(self) -> DataOut<'a> {
        self.as_mut_slice().arg()
    }
}

impl<'a, T: Pod> Arg<DataOut<'a>> for &'a mut Vec<T> {
    fn arg(self) -> DataOut<'a> {
        self.as_mut_slice().arg()
    }
}

impl<'a> Arg<DataOut<'a>> for Offset {
    fn arg(self) -> DataOut<'a> {
        DataOut::Offset(self.0)
    }
}

impl<'a> Arg<DataOut<'a>> for Null {
    fn arg(self) -> DataOut<'a> {
        DataOut::Null
    }
}

/// Typed pointers: `$from` in the client's memory where C has a pointer to `$to`.
macro_rules! pointers {
    ($($from:ty as $to:ty),*) => { $(
        impl<'a> Arg<&'a [$to]> for &'a [$from] {
            fn arg(self) -> &'a [$to] {
                bytemuck::cast_slice(self)
            }
        }
        impl<'a> Arg<&'a [$to]> for &'a $from {
            fn arg(self) -> &'a [$to] {
                bytemuck::cast_slice(std::slice::from_ref(self))
            }
        }
        impl<'a> Arg<&'a [$to]> for &'a Vec<$from> {
            fn arg(self) -> &'a [$to] {
                bytemuck::cast_slice(self)
            }
        }
        impl<'a, const N: usize> Arg<&'a [$to]> for &'a [$from; N] {
            fn arg(self) -> &'a [$to] {
                bytemuck::cast_slice(self.as_slice())
            }
        }
        impl<'a, const N: usize> Arg<&'a [$to]> for &'a [[$from; N]] {
            fn arg(self) -> &'a [$to] {
                bytemuck::cast_slice(self)
            }
        }
        impl<'a, const N: usize, const M: usize> Arg<&'a [$to]> for &'a [[$from; N]; M] {
            fn arg(self) -> &'a [$to] {
                bytemuck::cast_slice(self.as_slice())
            }
        }
        impl<'a> Arg<&'a mut [$to]> for &'a mut [$from] {
            fn arg(self) -> &'a mut [$to] {
                bytemuck::cast_slice_mut(self)
            }
        }
        impl<'a> Arg<&'a mut [$to]> for &'a mut $from {
            fn arg(self) -> &'a mut [$to] {
                bytemuck::cast_slice_mut(std::slice::from_mut(self))
            }
        }
        impl<'a> Arg<&'a mut [$to]> for &'a mut Vec<$from> {
            fn arg(self) -> &'a mut [$to] {
                bytemuck::cast_slice_mut(self)
            }
        }
        impl<'a, const N: usize> Arg<&'a mut [$to]> for &'a mut [$from; N] {
            fn arg(self) -> &'a mut [$to] {
                bytemuck::cast_slice_mut(self.as_mut_slice())
            }
        }
        impl<'a, const N: usize, const M: usize> Arg<&'a mut [$to]> for &'a mut [[$from; N]; M] {
            fn arg(self) -> &'a mut [$to] {
                bytemuck::cast_slice_mut(self.as_mut_slice())
            }
        }
    )* };
}

pointers!(
    i8 as i8, u8 as u8, i16 as i16, u16 as u16, i32 as i32, u32 as i32, u32 as u32, i32 as u32,
    f32 as f32, f64 as f64
);

macro_rules! null_pointers {
    ($($to:ty),*) => { $(
        impl<'a> Arg<&'a [$to]> for Null {
            fn arg(self) -> &'a [$to] {
                &[]
            }
        }
        impl<'a> Arg<&'a mut [$to]> for Null {
            fn arg(self) -> &'a mut [$to] {
                &mut []
            }
        }
    )* };
}

null_pointers!(i8, u8, i16, u16, i32, u32, f32, f64);

impl<T> Arg<*const T> for *const T {
    fn arg(self) -> Self {
        self
    }
}

impl<T> Arg<*mut T> for *mut T {
    fn arg(self) -> Self {
        self
    }
}

impl Arg<GLDEBUGPROC> for GLDEBUGPROC {
    fn arg(self) -> Self {
        self
    }
}

impl<'a, T> Arg<&'a mut [*mut T]> for &'a mut *mut T {
    fn arg(self) -> &'a mut [*mut T] {
        std::slice::from_mut(self)
    }
}

impl<'a> Arg<&'a str> for &'a str {
    fn arg(self) -> &'a str {
        self
    }
}

impl<'a> Arg<&'a str> for &'a String {
    fn arg(self) -> &'a str {
        self
    }
}

/// Where C has an array of strings.
#[derive(Clone, Debug)]
pub struct Strings<'a>(pub Vec<&'a str>);

impl<'a> Arg<Strings<'a>> for &'a str {
    fn arg(self) -> Strings<'a> {
        Strings(vec![self])
    }
}

impl<'a> Arg<Strings<'a>> for &'a &'a str {
    fn arg(self) -> Strings<'a> {
        Strings(vec![self])
    }
}

impl<'a> Arg<Strings<'a>> for &'a String {
    fn arg(self) -> Strings<'a> {
        Strings(vec![self])
    }
}

impl<'a, T: AsRef<str>> Arg<Strings<'a>> for &'a [T] {
    fn arg(self) -> Strings<'a> {
        Strings(self.iter().map(AsRef::as_ref).collect())
    }
}

impl<'a, T: AsRef<str>, const N: usize> Arg<Strings<'a>> for &'a [T; N] {
    fn arg(self) -> Strings<'a> {
        self.as_slice().arg()
    }
}

impl<'a, T: AsRef<str>> Arg<Strings<'a>> for &'a Vec<T> {
    fn arg(self) -> Strings<'a> {
        self.as_slice().arg()
    }
}

/// Where C has an array of strings that zeros end.
#[derive(Clone, Debug)]
pub struct Names<'a>(pub Vec<&'a str>);

impl<'a, T: AsRef<str>> Arg<Names<'a>> for &'a [T] {
    fn arg(self) -> Names<'a> {
        Names(self.iter().map(AsRef::as_ref).collect())
    }
}

impl<'a, T: AsRef<str>, const N: usize> Arg<Names<'a>> for &'a [T; N] {
    fn arg(self) -> Names<'a> {
        self.as_slice().arg()
    }
}

/// Where C has a `char *` that the call writes text to.
#[derive(Debug)]
pub enum TextOut<'a> {
    /// The text and a zero byte, as much as fits.
    Bytes(&'a mut [u8]),
    /// The text replaces the string.
    String(&'a mut String),
    /// Nowhere.
    Null,
}

impl TextOut<'_> {
    /// Writes `text`, at most `limit` bytes with C's final zero; gives the length without it.
    pub(crate) fn write(self, text: &str, limit: usize) -> usize {
        let room = match &self {
            Self::Bytes(bytes) => bytes.len().min(limit),
            Self::String(_) => limit,
            Self::Null => 0,
        };
        let mut end = text.len().min(room.saturating_sub(1));
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        match self {
            Self::Bytes(bytes) if room > 0 => {
                bytes[..end].copy_from_slice(&text.as_bytes()[..end]);
                bytes[end] = 0;
            }
            Self::String(string) => {
                string.clear();
                string.push_str(&text[..end]);
            }
            Self::Bytes(_) | Self::Null => {}
        }
        end
    }
}

impl<'a> Arg<TextOut<'a>> for &'a mut [u8] {
    fn arg(self) -> TextOut<'a> {
        TextOut::Bytes(self)
    }
}

impl<'a, const N: usize> Arg<TextOut<'a>> for &'a mut [u8; N] {
    fn arg(self) -> TextOut<'a> {
        TextOut::Bytes(self)
    }
}

impl<'a> Arg<TextOut<'a>> for &'a mut Vec<u8> {
    fn arg(self) -> TextOut<'a> {
        TextOut::Bytes(self)
    }
}

impl<'a> Arg<TextOut<'a>> for &'a mut String {
    fn arg(self) -> TextOut<'a> {
        TextOut::String(self)
    }
}

impl<'a> Arg<TextOut<'a>> for Null {
    fn arg(self) -> TextOut<'a> {
        TextOut::Null
    }
}
