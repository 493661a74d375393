//! Pointers of C programs. Only the call that takes one knows how many bytes it points to, and whether it is a pointer
//! or an offset into a buffer object.

use std::fmt::Debug;
use std::marker::PhantomData;

/// Access to the memory of a C program.
///
/// The implementation vouches for the pointers that are made with it: this crate never makes one, and has no `unsafe`.
pub trait ClientMemory: Debug + Sync {
    /// `length` bytes from `address` on, which is not null.
    fn bytes<'a>(&self, address: usize, length: usize) -> &'a [u8];

    /// The same bytes for writing; nothing else borrows them.
    fn bytes_mut<'a>(&self, address: usize, length: usize) -> &'a mut [u8];
}

/// Where C has a pointer to bytes of the client's.
#[derive(Clone, Copy, Debug)]
pub struct ClientPointer<'a> {
    address: usize,
    memory: &'static dyn ClientMemory,
    _bytes: PhantomData<&'a u8>,
}

impl<'a> ClientPointer<'a> {
    /// A pointer into `memory`, which is read and written where a call says so, and as long as GL keeps it.
    #[doc(hidden)]
    pub fn new(address: usize, memory: &'static dyn ClientMemory) -> Self {
        Self { address, memory, _bytes: PhantomData }
    }

    /// The address as a number: an offset, where a buffer object is bound.
    pub(crate) fn offset(self) -> usize {
        self.address
    }

    /// Whether it is C's null pointer.
    pub(crate) fn is_null(self) -> bool {
        self.address == 0
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
        self.memory.bytes(self.address.wrapping_add(from), length)
    }

    /// `length` bytes to write to.
    pub(crate) fn bytes_mut(self, length: usize) -> &'a mut [u8] {
        if self.is_null() || isize::try_from(length).is_err() {
            return &mut [];
        }
        self.memory.bytes_mut(self.address, length)
    }

    /// The pointer, or offset, `bytes` further on.
    pub(crate) fn forward(self, bytes: usize) -> Self {
        Self { address: self.address.wrapping_add(bytes), ..self }
    }

    /// The same pointer with no end of its lifetime: GL reads vertex arrays when it draws.
    pub(crate) fn kept(self) -> ClientPointer<'static> {
        ClientPointer { address: self.address, memory: self.memory, _bytes: PhantomData }
    }
}
