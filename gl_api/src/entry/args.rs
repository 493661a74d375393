//! What a parameter of an entry point accepts: what C would convert implicitly, and slices where C
//! has pointers.

pub(crate) mod conversions;

/// Something that can be passed where an entry point expects a `T`.
pub trait Arg<T> {
    /// The conversion.
    fn arg(self) -> T;
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
