//! C's arguments and results, and what the methods of [`Context`](gl_api::Context) take and give.

mod text;

use crate::memory;
use gl_api::{ClientPointer, Data, DataOut, GLDEBUGPROC, Pointers};
use std::collections::BTreeMap;
use std::ffi::{CString, c_void};
use std::mem::MaybeUninit;
use std::sync::{Mutex, PoisonError};

/// What says how long the memory behind a pointer is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Counted {
    /// It is no pointer, or the call itself knows.
    No,
    /// A rule of [`lengths`](crate::lengths).
    Elements,
    /// A final zero, or an argument that is not negative.
    Text,
}

/// The arguments of a call.
pub(crate) struct Arguments<'a> {
    /// As numbers, and of pointers the address.
    pub numbers: &'a [isize],
    /// How many bytes each pointer stands for, if the call writes to one of several.
    pub extents: &'a [usize],
}

impl Arguments<'_> {
    /// Whether memory that the call writes to, from an address on, is another argument's too.
    #[inline(never)]
    fn overlap(&self, address: usize, bytes: usize) -> bool {
        let overlapping = self.numbers.iter().zip(self.extents).filter(|&(&other, &length)| {
            let other = other as usize;
            length > 0
                && address < other.saturating_add(length)
                && other < address.saturating_add(bytes)
        });
        overlapping.count() > 1
    }
}

/// Whether a call writes to the memory of one of several pointers, of these sizes of an element.
pub(crate) const fn writes_one_of_several(pointers: &[(usize, bool)]) -> bool {
    let (mut count, mut written, mut at) = (0, false, 0);
    while at < pointers.len() {
        count += (pointers[at].0 > 0) as usize;
        written |= pointers[at].1;
        at += 1;
    }
    written && count > 1
}

/// What `element` gives, `length` times; nothing if there is no memory for so many.
fn collect<T>(length: usize, element: impl FnMut(usize) -> T) -> Vec<T> {
    let mut all = Vec::new();
    if all.try_reserve_exact(length).is_ok() {
        all.extend((0..length).map(element));
    }
    all
}

/// Of text: it ends with a zero.
pub(crate) const TERMINATED: usize = usize::MAX;

/// A parameter's type: C's, what is held of it during the call, and ours.
pub(crate) trait Param<'a>: Sized {
    /// C's type.
    type Raw: Copy;
    /// What lives as long as the call.
    type Held: 'static;
    /// Whether C's pointer needs a length from [`lengths`](crate::lengths).
    const COUNTED: Counted = Counted::No;
    /// Bytes of an element of what C's pointer points to while the call runs; 0 of what is no pointer or was copied.
    const ELEMENT: usize = 0;
    /// Whether the call writes to these elements.
    const WRITTEN: bool = false;

    /// The argument as a number, for the lengths of others; of pointers the address.
    fn number(raw: Self::Raw) -> isize;

    /// Takes C's argument: `length` elements if it is a pointer; `call` has all arguments.
    ///
    /// # Safety
    /// A pointer that is not null has `length` elements, or ends with a zero if it is a string.
    unsafe fn hold(raw: Self::Raw, length: usize, call: &Arguments<'_>) -> Self::Held;

    /// The argument for the method.
    fn lend(held: &'a mut Self::Held) -> Self;
}

macro_rules! numbers {
    ($($ty:ty),*: $raw:pat => $number:expr) => { $(
        impl Param<'_> for $ty {
            type Raw = $ty;
            type Held = $ty;

            fn number($raw: $ty) -> isize {
                $number
            }

            unsafe fn hold(raw: $ty, _: usize, _: &Arguments<'_>) -> $ty {
                raw
            }

            fn lend(held: &mut $ty) -> $ty {
                *held
            }
        }
    )* };
}

numbers!(i8, u8, i16, u16, i32, u32, i64, u64, usize: raw => raw as isize);
numbers!(isize: raw => raw);
// No length depends on them, and the floating-point state is still the host's.
numbers!(f32, f64: _ => 0);

impl Param<'_> for bool {
    type Raw = u8;
    type Held = bool;

    fn number(raw: u8) -> isize {
        raw.into()
    }

    unsafe fn hold(raw: u8, _: usize, _: &Arguments<'_>) -> bool {
        raw != 0
    }

    fn lend(held: &mut bool) -> bool {
        *held
    }
}

/// What is passed on as it is.
macro_rules! opaque {
    ($($ty:ty: $raw:ident => $number:expr;)*) => { $(
        impl Param<'_> for $ty {
            type Raw = $ty;
            type Held = $ty;

            fn number($raw: $ty) -> isize {
                $number
            }

            unsafe fn hold(raw: $ty, _: usize, _: &Arguments<'_>) -> $ty {
                raw
            }

            fn lend(held: &mut $ty) -> $ty {
                *held
            }
        }
    )* };
}

opaque! {
    *const c_void: raw => raw.addr() as isize;
    *mut c_void: raw => raw.addr() as isize;
    GLDEBUGPROC: _raw => 0;
}

/// Elements that are read; a copy of them where C's pointer is misaligned.
pub(crate) struct Elements<T> {
    pointer: *const T,
    length: usize,
    copy: Vec<T>,
}

impl<'a, T: Copy + 'static> Param<'a> for &'a [T] {
    type Raw = *const T;
    type Held = Elements<T>;
    const COUNTED: Counted = Counted::Elements;
    const ELEMENT: usize = size_of::<T>();

    fn number(raw: *const T) -> isize {
        // `Strings` makes a pointer of it again.
        raw.expose_provenance() as isize
    }

    unsafe fn hold(raw: *const T, length: usize, _: &Arguments<'_>) -> Elements<T> {
        // No memory has more.
        let most = isize::MAX as usize / size_of::<T>().max(1);
        let length = if raw.is_null() { 0 } else { length.min(most) };
        let copied = if raw.is_aligned() { 0 } else { length };
        // SAFETY: promised by the caller; such a read needs no alignment.
        let copy = collect(copied, |at| unsafe { raw.add(at).read_unaligned() });
        Elements { pointer: raw, length, copy }
    }

    fn lend(held: &'a mut Elements<T>) -> &'a [T] {
        if held.length == 0 || !held.pointer.is_aligned() {
            return &held.copy;
        }
        // SAFETY: promised to `hold`; aligned and not null.
        unsafe { std::slice::from_raw_parts(held.pointer, held.length) }
    }
}

/// Elements that are written; by way of a copy where C's pointer is misaligned, or another one of the call points
/// to the same memory, which C allows.
pub(crate) struct ElementsMut<T: Copy> {
    pointer: *mut T,
    length: usize,
    /// C need not have written to it before.
    copy: Vec<MaybeUninit<T>>,
}

impl<T: Copy> Drop for ElementsMut<T> {
    fn drop(&mut self) {
        for (at, &value) in self.copy.iter().enumerate() {
            // SAFETY: promised to `hold`; such a write needs no alignment.
            unsafe { self.pointer.cast::<MaybeUninit<T>>().add(at).write_unaligned(value) };
        }
    }
}

impl<'a, T: Copy + 'static> Param<'a> for &'a mut [T] {
    type Raw = *mut T;
    type Held = ElementsMut<T>;
    const COUNTED: Counted = Counted::Elements;
    const ELEMENT: usize = size_of::<T>();
    const WRITTEN: bool = true;

    fn number(raw: *mut T) -> isize {
        raw.addr() as isize
    }

    unsafe fn hold(raw: *mut T, length: usize, call: &Arguments<'_>) -> ElementsMut<T> {
        // No memory has more.
        let most = isize::MAX as usize / size_of::<T>().max(1);
        let length = if raw.is_null() { 0 } else { length.min(most) };
        let direct = raw.is_aligned() && !call.overlap(raw.addr(), length * size_of::<T>());
        let from = raw.cast::<MaybeUninit<T>>();
        if direct {
            return ElementsMut { pointer: raw, length, copy: Vec::new() };
        }
        // SAFETY: promised by the caller; such a read needs no alignment.
        let copy = collect(length, |at| unsafe { from.add(at).read_unaligned() });
        ElementsMut { pointer: raw, length: copy.len(), copy }
    }

    fn lend(held: &'a mut ElementsMut<T>) -> &'a mut [T] {
        let from = match (held.length, held.copy.as_mut_ptr()) {
            (0, _) => return &mut [],
            (_, _) if held.copy.is_empty() => held.pointer,
            (_, copy) => copy.cast(),
        };
        // SAFETY: promised to `hold`, or the copy; aligned and not null.
        unsafe { std::slice::from_raw_parts_mut(from, held.length) }
    }
}

impl<'a> Param<'a> for Data<'a> {
    type Raw = *const c_void;
    type Held = ClientPointer<'static>;

    fn number(raw: *const c_void) -> isize {
        raw.addr() as isize
    }

    unsafe fn hold(raw: *const c_void, _: usize, _: &Arguments<'_>) -> ClientPointer<'static> {
        // SAFETY: promised by the caller.
        unsafe { memory::pointer(raw.cast()) }
    }

    fn lend(held: &'a mut ClientPointer<'static>) -> Self {
        Data::Client(*held)
    }
}

impl<'a> Param<'a> for DataOut<'a> {
    type Raw = *mut c_void;
    type Held = ClientPointer<'static>;

    fn number(raw: *mut c_void) -> isize {
        raw.addr() as isize
    }

    unsafe fn hold(raw: *mut c_void, _: usize, _: &Arguments<'_>) -> ClientPointer<'static> {
        // SAFETY: promised by the caller.
        unsafe { memory::pointer(raw.cast_const().cast()) }
    }

    fn lend(held: &'a mut ClientPointer<'static>) -> Self {
        DataOut::Client(*held)
    }
}

impl<'a> Param<'a> for Pointers<'a> {
    type Raw = *const *const c_void;
    type Held = Vec<ClientPointer<'static>>;
    const COUNTED: Counted = Counted::Elements;

    fn number(raw: *const *const c_void) -> isize {
        raw.addr() as isize
    }

    unsafe fn hold(
        raw: *const *const c_void,
        length: usize,
        _: &Arguments<'_>,
    ) -> Vec<ClientPointer<'static>> {
        let length = if raw.is_null() { 0 } else { length };
        // SAFETY: promised by the caller: `length` pointers, to what the call reads.
        collect(length, |at| unsafe { memory::pointer(raw.add(at).read_unaligned().cast()) })
    }

    fn lend(held: &'a mut Vec<ClientPointer<'static>>) -> Self {
        Pointers(held.iter().map(|&pointer| Data::Client(pointer)).collect())
    }
}

/// A result's type: ours and C's.
pub(crate) trait Return {
    /// C's type.
    type Raw;
    /// The conversion.
    fn to_c(self) -> Self::Raw;
}

macro_rules! results {
    ($($ty:ty),*) => { $(
        impl Return for $ty {
            type Raw = $ty;

            fn to_c(self) -> $ty {
                self
            }
        }
    )* };
}

results!((), u32, i32, *mut c_void);

impl Return for bool {
    type Raw = u8;

    fn to_c(self) -> u8 {
        self.into()
    }
}

/// Text that C gets to keep: made once for each different one. Empty text is the null pointer.
impl Return for &'static str {
    type Raw = *const u8;

    fn to_c(self) -> *const u8 {
        static KEPT: Mutex<BTreeMap<&str, CString>> = Mutex::new(BTreeMap::new());
        if self.is_empty() {
            return std::ptr::null();
        }
        let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
        kept.entry(self).or_insert_with(|| CString::new(self).unwrap_or_default()).as_ptr().cast()
    }
}
