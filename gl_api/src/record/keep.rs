//! Arguments that outlive their call: how each type of parameter is kept in a list, and lent to the
//! call again.

use crate::base::args::{Data, DataOut, Located, Names, Pointers, Strings, TextOut};
use crate::context::sharing::SharedObjectsGuard;
use crate::context::{Context, GLDEBUGPROC};
use crate::record::pixels;
use std::convert::Infallible;
use std::marker::PhantomData;

/// A parameter that can be kept.
pub(crate) trait Keep {
    /// What is kept.
    type Kept: Send + Sync + 'static;

    /// A copy of what the argument says or points to, or `None` where the call answers something
    /// through it, and so is not compiled. `integers` are all arguments of the call `name`.
    fn keep(&self, context: &mut Context, name: &str, integers: &[i64]) -> Option<Self::Kept>;

    /// The argument as a number; 0 for pointers.
    fn integer(&self) -> i64 {
        0
    }
}

/// What was kept, as an argument again.
pub(crate) trait Lend {
    /// The type of the parameter.
    type Lent<'a>
    where
        Self: 'a;

    /// The argument.
    fn lend(&self) -> Self::Lent<'_>;
}

macro_rules! numbers {
    ($($ty:ty),*) => { $(
        impl Keep for $ty {
            type Kept = $ty;

            fn keep(&self, _: &mut Context, _: &str, _: &[i64]) -> Option<$ty> {
                Some(*self)
            }

            fn integer(&self) -> i64 {
                *self as i64
            }
        }

        impl Lend for $ty {
            type Lent<'a> = $ty;

            fn lend(&self) -> $ty {
                *self
            }
        }
    )* };
}

numbers!(i8, u8, i16, u16, i32, u32, i64, u64, isize, usize, f32, f64, bool);

impl<T: Copy + Send + Sync + 'static> Keep for &[T] {
    type Kept = Vec<T>;

    fn keep(&self, _: &mut Context, _: &str, _: &[i64]) -> Option<Vec<T>> {
        Some(self.to_vec())
    }
}

impl<T: Copy + Send + Sync + 'static> Lend for Vec<T> {
    type Lent<'a> = &'a [T];

    fn lend(&self) -> &[T] {
        self
    }
}

impl Keep for &str {
    type Kept = String;

    fn keep(&self, _: &mut Context, _: &str, _: &[i64]) -> Option<String> {
        Some((*self).to_owned())
    }
}

impl Lend for String {
    type Lent<'a> = &'a str;

    fn lend(&self) -> &str {
        self
    }
}

/// Memory that a call reads.
#[derive(Debug)]
pub(crate) enum KeptData {
    Bytes(Vec<u8>),
    Offset(usize),
    Null,
}

impl Keep for Data<'_> {
    type Kept = KeptData;

    fn keep(&self, context: &mut Context, name: &str, integers: &[i64]) -> Option<KeptData> {
        // The pixels may lie in a buffer, which may be the group's.
        let context = &*SharedObjectsGuard::lock(context).context;
        Some(match pixels::bytes(context, name, integers, *self) {
            Some(bytes) => KeptData::Bytes(bytes),
            None => match self.locate(0, 0) {
                Located::Bytes(bytes) => KeptData::Bytes(bytes.to_vec()),
                Located::Offset(offset) => KeptData::Offset(offset),
                Located::Null => KeptData::Null,
            },
        })
    }
}

impl Lend for KeptData {
    type Lent<'a> = Data<'a>;

    fn lend(&self) -> Data<'_> {
        match self {
            Self::Bytes(bytes) => Data::Bytes(bytes),
            Self::Offset(offset) => Data::Offset(*offset),
            Self::Null => Data::Null,
        }
    }
}

/// For parameters through which a call answers: such a call is not compiled, and no value of this
/// type exists.
#[derive(Debug)]
pub(crate) struct Never<T>(Infallible, PhantomData<fn() -> T>);

macro_rules! answers {
    ($([$($generic:tt)*] $ty:ty, $mark:ty => $lent:ty;)*) => { $(
        impl<$($generic)*> Keep for $ty {
            type Kept = Never<$mark>;

            fn keep(&self, _: &mut Context, _: &str, _: &[i64]) -> Option<Never<$mark>> {
                None
            }
        }

        impl<$($generic)*> Lend for Never<$mark> {
            type Lent<'a> = $lent;

            fn lend(&self) -> Self::Lent<'_> {
                match self.0 {}
            }
        }
    )* };
}

answers! {
    [T: 'static] &mut [T], [T; 1] => &'a mut [T];
    // Pointers that a call keeps are the client's own.
    [T: 'static] *const T, *const T => *const T;
    [T: 'static] *mut T, *mut T => *mut T;
    [] GLDEBUGPROC, GLDEBUGPROC => GLDEBUGPROC;
    [] DataOut<'_>, DataOut<'static> => DataOut<'a>;
    // Draws of arrays record themselves.
    [] Pointers<'_>, Pointers<'static> => Pointers<'a>;
    // The source of a shader is taken at once.
    [] Strings<'_>, Strings<'static> => Strings<'a>;
    // What a program captures, too.
    [] Names<'_>, Names<'static> => Names<'a>;
    [] TextOut<'_>, TextOut<'static> => TextOut<'a>;
}
