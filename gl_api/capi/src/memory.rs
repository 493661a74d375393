//! The memory behind C's pointers, for calls that know how much of it a pointer stands for.

use gl_api::{ClientMemory, ClientPointer};

/// The memory of this process.
#[derive(Debug)]
struct ProcessMemory;

impl ClientMemory for ProcessMemory {
    fn bytes<'a>(&self, address: usize, length: usize) -> &'a [u8] {
        // SAFETY: promised to `pointer`, which alone gives this away; needs no alignment.
        unsafe { bytes(std::ptr::with_exposed_provenance(address), length) }
    }

    fn bytes_mut<'a>(&self, address: usize, length: usize) -> &'a mut [u8] {
        // SAFETY: promised to `pointer`, which alone gives this away; needs no alignment.
        unsafe { bytes_mut(std::ptr::with_exposed_provenance_mut(address), length) }
    }
}

/// A pointer of C's as calls of GL take it.
///
/// # Safety
/// During the call, and where GL keeps the pointer until it is replaced, there are as many bytes at `address` as the
/// call asks for, and nothing else writes to them while they are borrowed.
pub(crate) unsafe fn pointer(address: *const u8) -> ClientPointer<'static> {
    ClientPointer::new(address.expose_provenance(), &ProcessMemory)
}

/// `length` bytes; none for the null pointer, and for more than there can be.
///
/// # Safety
/// A pointer that is not null has so many bytes, which nothing writes to during `'a`.
pub(crate) unsafe fn bytes<'a>(address: *const u8, length: usize) -> &'a [u8] {
    if address.is_null() || isize::try_from(length).is_err() {
        return &[];
    }
    // SAFETY: promised by the caller; not null, and the length fits.
    unsafe { std::slice::from_raw_parts(address, length) }
}

/// `length` bytes to write to; none for the null pointer, and for more than there can be.
///
/// # Safety
/// A pointer that is not null has so many bytes, which nothing else reads or writes during `'a`.
pub(crate) unsafe fn bytes_mut<'a>(address: *mut u8, length: usize) -> &'a mut [u8] {
    if address.is_null() || isize::try_from(length).is_err() {
        return &mut [];
    }
    // SAFETY: promised by the caller; not null, and the length fits.
    unsafe { std::slice::from_raw_parts_mut(address, length) }
}
