//! Types of the parameters for which C has pointers: memory of the client, an offset into a buffer object, or null.

use crate::base::client_memory::ClientPointer;
use crate::base::types::GLuint;

/// Where C has a `const void *`: memory, nothing, or an offset into the bound buffer object.
#[derive(Clone, Copy, Debug)]
pub enum Data<'a> {
    /// The client's memory, as bytes.
    Bytes(&'a [u8]),
    /// An offset into the bound buffer object.
    Offset(usize),
    /// Nothing; with a buffer object bound, offset 0.
    Null,
    /// A C pointer, which is any of these: the call decides.
    Client(ClientPointer<'a>),
}

/// [`Data`] once it is known whether a buffer object is bound.
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

/// Where C has an array of `const void *`.
#[derive(Clone, Debug)]
pub struct Pointers<'a>(pub Vec<Data<'a>>);

/// Where C has a `void *` that the call writes to.
#[derive(Debug)]
pub enum DataOut<'a> {
    /// The client's memory, as bytes.
    Bytes(&'a mut [u8]),
    /// An offset into the bound buffer object.
    Offset(usize),
    /// Nowhere.
    Null,
    /// A C pointer, which is any of these: the call decides.
    Client(ClientPointer<'a>),
}

/// [`DataOut`] once it is known whether a buffer object is bound.
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

/// Where C has an array of strings.
#[derive(Clone, Debug)]
pub struct Strings<'a>(pub Vec<&'a str>);

/// Where C has an array of strings that zeros end.
#[derive(Clone, Debug)]
pub struct Names<'a>(pub Vec<&'a str>);

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
        let capacity = match &self {
            Self::Bytes(bytes) => bytes.len().min(limit),
            Self::String(_) => limit,
            Self::Null => 0,
        };
        let mut end = text.len().min(capacity.saturating_sub(1));
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        match self {
            Self::Bytes(bytes) if capacity > 0 => {
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
