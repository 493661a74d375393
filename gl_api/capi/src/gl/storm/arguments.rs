//! The C argument of each type of parameter: a number, or memory that ends where its length says.

use super::memory::{PAGE, Slot};
use super::random::Random;
use crate::param::{Param, TERMINATED};
use gl_api::{Data, DataOut, GLDEBUGPROC, Names, Pointers, Strings, TextOut};
use std::ffi::{c_char, c_void};
use std::ptr::{null, null_mut};

/// A parameter's C argument: a number, or memory.
pub(super) trait Argument<'a>: Param<'a> {
    /// Of what is no pointer.
    fn number(_: i64) -> Option<Self::Raw> {
        None
    }

    /// Of a pointer with so many elements, or [`TERMINATED`].
    fn memory(slot: Slot, length: usize, random: &Random) -> Self::Raw;
}

macro_rules! number_arguments {
    ($($ty:ty: $value:ident => $number:expr;)*) => { $(
        impl Argument<'_> for $ty {
            fn number($value: i64) -> Option<<$ty as Param<'static>>::Raw> {
                Some($number)
            }

            fn memory(_: Slot, _: usize, _: &Random) -> <$ty as Param<'static>>::Raw {
                unreachable!("a number")
            }
        }
    )* };
}

number_arguments! {
    i8: value => value as i8;
    u8: value => value as u8;
    i16: value => value as i16;
    u16: value => value as u16;
    i32: value => value as i32;
    u32: value => value as u32;
    i64: value => value;
    u64: value => value as u64;
    isize: value => value as isize;
    usize: value => value as usize;
    f32: value => value as f32 / 4.0;
    f64: value => value as f64 / 4.0;
    bool: value => (value & 1) as u8;
    *const c_void: _value => null();
    *mut c_void: _value => null_mut();
    GLDEBUGPROC: _value => None;
}

impl<'a, T: Copy + 'static> Argument<'a> for &'a [T] {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const T {
        slot.last(length.saturating_mul(size_of::<T>()), random).cast_const().cast()
    }
}

impl<'a, T: Copy + 'static> Argument<'a> for &'a mut [T] {
    fn memory(slot: Slot, length: usize, random: &Random) -> *mut T {
        slot.last(length.saturating_mul(size_of::<T>()), random).cast()
    }
}

impl<'a> Argument<'a> for TextOut<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *mut c_char {
        slot.last(length, random).cast()
    }
}

/// Text that ends where memory ends: with a zero, if its length is not said.
pub(super) fn text(slot: Slot, length: usize, random: &Random) -> *const c_char {
    let (length, zero) = if length == TERMINATED { (63, 1) } else { (length.min(PAGE), 0) };
    let start = slot.last(length + zero, random);
    // SAFETY: within the page.
    unsafe {
        for at in 0..length {
            *start.add(at) = b'u';
        }
        if zero == 1 {
            *start.add(length) = 0;
        }
    }
    start.cast_const().cast()
}

impl<'a> Argument<'a> for &'a str {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const c_char {
        text(slot, length, random)
    }
}

/// Pointers to one text, which a zero ends.
pub(super) fn texts(slot: Slot, length: usize, random: &Random) -> *const *const c_char {
    thread_local! { static TEXT: Slot = Slot::new(); }
    let text = text(TEXT.with(|slot| *slot), TERMINATED, random);
    let count = length.min(PAGE / size_of::<usize>());
    let start = slot.last(count * size_of::<usize>(), random).cast::<*const c_char>();
    for at in 0..count {
        // SAFETY: within the page.
        unsafe { start.add(at).write_unaligned(text) };
    }
    start.cast_const()
}

impl<'a> Argument<'a> for Strings<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const *const c_char {
        texts(slot, length, random)
    }
}

impl<'a> Argument<'a> for Names<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const *const c_char {
        texts(slot, length, random)
    }
}

impl<'a> Argument<'a> for Pointers<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const *const c_void {
        texts(slot, length, random).cast()
    }
}

impl<'a> Argument<'a> for Data<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const c_void {
        if length == TERMINATED { null() } else { slot.last(length, random).cast_const().cast() }
    }
}

impl<'a> Argument<'a> for DataOut<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *mut c_void {
        if length == TERMINATED { null_mut() } else { slot.last(length, random).cast() }
    }
}
