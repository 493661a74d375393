//! The arguments of calls in display lists: for each type of parameter, what a list records of it, and how that
//! becomes the argument again.

use crate::base::args::{Data, DataOut, Located, Names, Pointers, Strings, TextOut};
use crate::base::memory::copied;
use crate::context::sharing::CallScope;
use crate::context::{Context, GLDEBUGPROC};
use crate::record::list_memory;
use std::collections::TryReserveError;
use std::convert::Infallible;
use std::marker::PhantomData;

/// A type of parameter that lists record.
pub(crate) trait RecordArgument {
    /// What a list has of it.
    type Recorded: Send + Sync + 'static;

    /// A copy of what the argument says or points to. `integers` are all arguments of the call `name`.
    ///
    /// # Errors
    /// Why the call is not recorded.
    fn record(
        &self,
        context: &mut Context,
        name: &str,
        integers: &[i64],
    ) -> Result<Self::Recorded, NotRecorded>;

    /// The argument as a number; 0 for pointers, and for floats: no length depends on one, and converting one would
    /// compute in the host's floating-point state.
    fn integer(&self) -> i64 {
        0
    }
}

/// Why a call is not recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NotRecorded {
    /// It returns data to the client, and so is executed.
    ReturnsData,
    /// There is no memory for a copy of what it reads.
    NoMemory,
}

/// Records the arguments of a call, until one is not recorded.
pub(crate) fn record_all<T>(
    record: impl FnOnce() -> Result<T, NotRecorded>,
) -> Result<T, NotRecorded> {
    record()
}

impl From<TryReserveError> for NotRecorded {
    fn from(_: TryReserveError) -> Self {
        Self::NoMemory
    }
}

/// What a list has of an argument, which makes it again when the list is called.
pub(crate) trait RecordedArgument {
    /// The type of the parameter.
    type Argument<'a>
    where
        Self: 'a;

    /// The argument.
    fn argument(&self) -> Self::Argument<'_>;
}

macro_rules! numbers {
    ($($ty:ty),*; $integer:expr) => { $(
        impl RecordArgument for $ty {
            type Recorded = $ty;

            fn record(&self, _: &mut Context, _: &str, _: &[i64]) -> Result<$ty, NotRecorded> {
                Ok(*self)
            }

            fn integer(&self) -> i64 {
                let integer: fn(&$ty) -> i64 = $integer;
                integer(self)
            }
        }

        impl RecordedArgument for $ty {
            type Argument<'a> = $ty;

            fn argument(&self) -> $ty {
                *self
            }
        }
    )* };
}

numbers!(i8, u8, i16, u16, i32, u32, u64, isize, usize, bool; |value| *value as i64);
numbers!(i64; |value| *value);
numbers!(f32, f64; |_| 0);

impl<T: Copy + Send + Sync + 'static> RecordArgument for &[T] {
    type Recorded = Vec<T>;

    fn record(&self, _: &mut Context, _: &str, _: &[i64]) -> Result<Vec<T>, NotRecorded> {
        Ok(copied(self)?)
    }
}

impl<T: Copy + Send + Sync + 'static> RecordedArgument for Vec<T> {
    type Argument<'a> = &'a [T];

    fn argument(&self) -> &[T] {
        self
    }
}

impl RecordArgument for &str {
    type Recorded = String;

    fn record(&self, _: &mut Context, _: &str, _: &[i64]) -> Result<String, NotRecorded> {
        Ok((*self).to_owned())
    }
}

impl RecordedArgument for String {
    type Argument<'a> = &'a str;

    fn argument(&self) -> &str {
        self
    }
}

/// Memory that a call reads.
#[derive(Debug)]
pub(crate) enum RecordedData {
    Bytes(Vec<u8>),
    Offset(usize),
    Null,
}

impl RecordArgument for Data<'_> {
    type Recorded = RecordedData;

    fn record(
        &self,
        context: &mut Context,
        name: &str,
        integers: &[i64],
    ) -> Result<RecordedData, NotRecorded> {
        // The pixels may lie in a buffer of the group.
        let scope = CallScope { context };
        let context = &*scope.context;
        Ok(match list_memory::bytes(context, name, integers, *self)? {
            Some(bytes) => RecordedData::Bytes(bytes),
            None => match self.locate(0, 0) {
                Located::Bytes(bytes) => RecordedData::Bytes(copied(bytes)?),
                Located::Offset(offset) => RecordedData::Offset(offset),
                Located::Null => RecordedData::Null,
            },
        })
    }
}

impl RecordedArgument for RecordedData {
    type Argument<'a> = Data<'a>;

    fn argument(&self) -> Data<'_> {
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
pub(crate) struct Unrecordable<T>(Infallible, PhantomData<fn() -> T>);

macro_rules! answers {
    ($([$($generic:tt)*] $ty:ty, $mark:ty => $lent:ty;)*) => { $(
        impl<$($generic)*> RecordArgument for $ty {
            type Recorded = Unrecordable<$mark>;

            fn record(&self, _: &mut Context, _: &str, _: &[i64]) -> Result<Unrecordable<$mark>, NotRecorded> {
                Err(NotRecorded::ReturnsData)
            }
        }

        impl<$($generic)*> RecordedArgument for Unrecordable<$mark> {
            type Argument<'a> = $lent;

            fn argument(&self) -> Self::Argument<'_> {
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
