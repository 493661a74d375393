//! Bytes for vertices and indices, shared with the draws that read them, copied only when written
//! meanwhile.

use std::collections::TryReserveError;
use std::sync::{Arc, Weak};
use texunit::image::copied;

/// Bytes that draws read. Cloning shares them.
#[derive(Clone, Debug, Default)]
pub struct Buffer(Arc<Vec<u8>>);

impl Buffer {
    /// A buffer that holds these bytes.
    pub fn new(bytes: Vec<u8>) -> Self {
        Self(Arc::new(bytes))
    }

    /// The bytes.
    pub fn bytes(&self) -> &[u8] {
        &self.0
    }

    /// Whether its bytes are shared with another handle, such as a recorded draw.
    pub fn is_shared(&self) -> bool {
        Arc::strong_count(&self.0) > 1
    }

    /// The number of bytes that only this handle holds.
    pub fn own_bytes(&self) -> usize {
        if self.is_shared() { 0 } else { self.0.len() }
    }

    /// The version of its bytes, which differs after a write.
    pub fn version(&self) -> Version {
        Version(Arc::downgrade(&self.0))
    }

    /// Copies its bytes if they are shared, so that [`Self::bytes_mut`] needs no memory.
    ///
    /// # Errors
    /// If there is no memory for the copy.
    pub fn unshare(&mut self) -> Result<(), TryReserveError> {
        if self.is_shared() {
            self.0 = Arc::new(copied(&self.0)?);
        }
        Ok(())
    }

    /// Its bytes for writing. Draws recorded earlier keep the bytes as they were.
    pub fn bytes_mut(&mut self) -> &mut Vec<u8> {
        Arc::make_mut(&mut self.0)
    }
}

/// A weak reference to the bytes of a [`Buffer`]. A write moves the bytes to another allocation, as
/// [`Arc::make_mut`] does while weak references exist.
#[derive(Clone, Debug, Default)]
pub struct Version(Weak<Vec<u8>>);

impl Version {
    /// Whether the buffer has not been written to since.
    pub fn is_of(&self, buffer: &Buffer) -> bool {
        std::ptr::eq(self.0.as_ptr(), Arc::as_ptr(&buffer.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_version_is_that_of_the_bytes_until_somebody_writes() {
        let mut buffer = Buffer::new(vec![1, 2]);
        let first = buffer.version();
        assert!(first.is_of(&buffer) && first.is_of(&buffer.clone()));
        assert!(!first.is_of(&Buffer::new(vec![1, 2])));
        assert!(!Version::default().is_of(&buffer));
        // Alone, the bytes move; shared, they are copied.
        buffer.bytes_mut()[0] = 3;
        assert!(!first.is_of(&buffer) && !buffer.is_shared());
        let (second, other) = (buffer.version(), buffer.clone());
        buffer.bytes_mut()[0] = 4;
        assert!(second.is_of(&other) && !second.is_of(&buffer));
        assert_eq!((buffer.bytes(), other.bytes()), (&[4, 2][..], &[3, 2][..]));
    }
}
