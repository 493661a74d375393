//! The bytes of a level, with a flag whether they were ever written.
//!
//! The system hands out zeroed memory without pages. A read of an untouched page maps the shared zero page; the first
//! write then replaces it, and interrupts every processor to flush its TLB, page by page. So blank levels are not read.

use std::ops::{Deref, DerefMut};

/// Bytes.
#[derive(Debug)]
pub struct Memory {
    bytes: Vec<u8>,
    /// Whether the bytes were never borrowed for writing.
    is_blank: bool,
}

impl Memory {
    /// Zeroed memory; `None` if the allocation fails.
    pub(super) fn zeroed(bytes: usize) -> Option<Self> {
        zeroed(bytes).map(|bytes| Self { bytes, is_blank: true })
    }

    /// Whether all bytes are known to be zero: they were never borrowed for writing.
    pub fn is_blank(&self) -> bool {
        self.is_blank
    }
}

impl Deref for Memory {
    type Target = [u8];
    #[inline(always)]
    fn deref(&self) -> &[u8] {
        &self.bytes
    }
}

impl DerefMut for Memory {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [u8] {
        self.is_blank = false;
        &mut self.bytes
    }
}

impl Clone for Memory {
    fn clone(&self) -> Self {
        let bytes = if self.is_blank { vec![0; self.bytes.len()] } else { self.bytes.clone() };
        Self { bytes, is_blank: self.is_blank }
    }
}

impl PartialEq for Memory {
    fn eq(&self, other: &Self) -> bool {
        self.bytes == other.bytes
    }
}

impl Eq for Memory {}

/// Zeroed memory; `None` if the allocation fails. Pages are not touched: images are often written whole right after.
pub fn zeroed(bytes: usize) -> Option<Vec<u8>> {
    // `vec!` aborts if the allocation fails, so reserve first.
    Vec::<u8>::new().try_reserve_exact(bytes).ok()?;
    Some(vec![0; bytes])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_never_written_is_blank_and_so_is_its_copy() {
        let mut memory = Memory::zeroed(5).unwrap();
        assert!(memory.is_blank() && memory.clone().is_blank());
        assert_eq!(*memory, [0; 5]);
        memory[2] = 7;
        assert!(!memory.is_blank());
        assert_eq!(*memory.clone(), [0, 0, 7, 0, 0]);
        memory[2] = 0;
        assert!(!memory.is_blank());
        assert_eq!(memory, Memory::zeroed(5).unwrap());
    }
}
