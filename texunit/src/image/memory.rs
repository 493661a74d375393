//! The bytes of a level, which know whether anybody has written to them.
//!
//! Memory that the system gives is zero, and none of its pages is there before somebody writes to it. Who reads a
//! page that is not there has the system put in one that all share, and take it away again when it is written:
//! then every processor is told, page by page. A texture that is made to be drawn to must not be read for that.

use std::ops::{Deref, DerefMut};

/// Bytes.
#[derive(Debug)]
pub struct Memory {
    bytes: Vec<u8>,
    /// Whether nobody has asked to write.
    is_blank: bool,
}

impl Memory {
    /// So many zeros, or none where there is no memory for them.
    pub(super) fn zeroed(bytes: usize) -> Option<Self> {
        zeroed(bytes).map(|bytes| Self { bytes, is_blank: true })
    }

    /// Whether it is known that all bytes are zero: nobody has asked to write any.
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

/// So many zeros, or none where there is no memory for them. The system gives memory that is zero
/// and no page of it is touched, as filling it would: images are often written whole right after.
pub fn zeroed(bytes: usize) -> Option<Vec<u8>> {
    // `vec!` ends the program where there is no memory, so that is asked first.
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
