//! A pointer of a C program: only the call that takes it knows how much memory it stands for, and
//! whether it is a pointer at all or an offset into a buffer object.

use std::marker::PhantomData;

/// Where C has a pointer to bytes of the client's.
#[derive(Clone, Copy, Debug)]
pub struct ClientPointer<'a> {
    address: *mut u8,
    _memory: PhantomData<&'a u8>,
}

// SAFETY: it is only an address; whoever made it vouched for the memory wherever it is read.
unsafe impl Send for ClientPointer<'_> {}
// SAFETY: as above; it is read through shared references only while no call writes through it.
unsafe impl Sync for ClientPointer<'_> {}

impl<'a> ClientPointer<'a> {
    /// # Safety
    /// For `'a`, and where GL keeps the pointer until it is replaced, there are as many bytes at
    /// `address` as are asked for, and nothing else writes to them while they are borrowed.
    pub(crate) unsafe fn new(address: *const u8) -> Self {
        Self { address: address.cast_mut(), _memory: PhantomData }
    }

    /// The address as a number: an offset, where a buffer object is bound.
    pub(crate) fn offset(self) -> usize {
        self.address.addr()
    }

    /// The address, to give it back to the client.
    pub(crate) fn address(self) -> *mut u8 {
        self.address
    }

    /// Whether it is C's null pointer.
    pub(crate) fn is_null(self) -> bool {
        self.address.is_null()
    }

    /// `length` bytes, which the caller of the C function has promised to be there.
    pub(crate) fn bytes(self, length: usize) -> &'a [u8] {
        self.bytes_from(0, length)
    }

    /// `length` bytes from byte `from` on; none for the null pointer.
    pub(crate) fn bytes_from(self, from: usize, length: usize) -> &'a [u8] {
        if self.is_null() || isize::try_from(length).is_err() {
            return &[];
        }
        // SAFETY: promised to `new`; not null, no alignment is needed, and the length fits.
        unsafe { std::slice::from_raw_parts(self.address.wrapping_add(from), length) }
    }

    /// `length` bytes to write to.
    pub(crate) fn bytes_mut(self, length: usize) -> &'a mut [u8] {
        if self.is_null() || isize::try_from(length).is_err() {
            return &mut [];
        }
        // SAFETY: promised to `new`; not null, no alignment is needed, and the length fits.
        unsafe { std::slice::from_raw_parts_mut(self.address, length) }
    }

    /// The pointer, or offset, `bytes` further on.
    pub(crate) fn forward(self, bytes: usize) -> Self {
        Self { address: self.address.wrapping_add(bytes), ..self }
    }

    /// The same pointer until it is replaced: GL reads arrays when it draws.
    pub(crate) fn kept(self) -> ClientPointer<'static> {
        ClientPointer { address: self.address, _memory: PhantomData }
    }
}
