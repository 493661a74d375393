//! What can be passed where an entry point expects an argument.

use super::{Arg, Null, Offset};
use crate::base::args::{Data, DataOut, Names, Pointers, Strings, TextOut};
use crate::context::GLDEBUGPROC;
use bytemuck::{NoUninit, Pod};

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
