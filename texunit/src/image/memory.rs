//! The bytes of a level: rows, with a flag whether they were ever written, or texels that are stored elsewhere (in the
//! tiles of an attachment) and gathered from there.
//!
//! The system hands out zeroed memory without pages. A read of an untouched page maps the shared zero page; the first
//! write then replaces it, and interrupts every processor to flush its TLB, page by page. So blank levels are not read.

use crate::lanes::{Simd, U32s};
use std::collections::TryReserveError;
use std::fmt::Debug;
use std::ops::{Deref, DerefMut};
use std::sync::{Arc, OnceLock};

/// The texels of a level of four bytes a texel, without border, that are stored otherwise than in rows.
pub trait TexelSource: Debug + Send + Sync {
    /// The words at these byte offsets in the rows of the level; each is that of a texel, but for the stencil beside a depth,
    /// which no lookup reads.
    fn gather(&self, offsets: &U32s) -> U32s;
    /// The rows, and [`super::PADDING`] bytes.
    fn rows(&self) -> Vec<u8>;
}

/// The bytes of a level.
#[derive(Debug)]
pub struct Memory(Store);

#[derive(Debug)]
enum Store {
    Rows {
        bytes: Vec<u8>,
        /// Whether the bytes were never borrowed for writing.
        is_blank: bool,
    },
    Elsewhere {
        source: Arc<dyn TexelSource>,
        /// From when something other than a gather reads them.
        rows: OnceLock<Vec<u8>>,
    },
}

impl Memory {
    /// Zeroed memory; `None` if the allocation fails.
    pub(super) fn zeroed(bytes: usize) -> Option<Self> {
        zeroed(bytes).map(|bytes| Self(Store::Rows { bytes, is_blank: true }))
    }

    /// Texels that are stored elsewhere.
    pub(super) fn elsewhere(source: Arc<dyn TexelSource>) -> Self {
        Self(Store::Elsewhere { source, rows: OnceLock::new() })
    }

    /// A copy; `None` if there is no memory for it.
    pub(super) fn copied(&self) -> Option<Self> {
        match &self.0 {
            Store::Rows { bytes, is_blank: true } => Self::zeroed(bytes.len()),
            Store::Rows { bytes, is_blank: false } => {
                let bytes = copied(bytes).ok()?;
                Some(Self(Store::Rows { bytes, is_blank: false }))
            }
            Store::Elsewhere { .. } => Some(self.clone()),
        }
    }

    /// Whether all bytes are known to be zero: they were never borrowed for writing.
    pub fn is_blank(&self) -> bool {
        matches!(self.0, Store::Rows { is_blank: true, .. })
    }

    /// [`Simd::gather`] at byte offsets of texels.
    #[inline(always)]
    pub(crate) fn gather<S: Simd>(&self, offsets: &U32s) -> U32s {
        match &self.0 {
            Store::Rows { bytes, .. } => S::gather(bytes, offsets),
            Store::Elsewhere { source, .. } => source.gather(offsets),
        }
    }

    /// [`Simd::gather_pairs`] at byte offsets of texels: of texels of four bytes, each with the next one.
    #[inline(always)]
    pub(crate) fn gather_pairs<S: Simd>(&self, offsets: &U32s) -> [U32s; 2] {
        match &self.0 {
            Store::Rows { bytes, .. } => S::gather_pairs(bytes, offsets),
            Store::Elsewhere { source, .. } => pairs(&**source, offsets),
        }
    }

    /// [`Simd::gather_quads`] at byte offsets of texels.
    #[inline(always)]
    pub(crate) fn gather_quads<S: Simd>(&self, offsets: &U32s, row: u32, out: &mut [U32s; 4]) {
        match &self.0 {
            Store::Rows { bytes, .. } => S::gather_quads(bytes, offsets, row, out),
            Store::Elsewhere { source, .. } => quads(&**source, offsets, row, out),
        }
    }
}

/// The words at these byte offsets, and those four bytes further.
#[cold]
#[inline(never)]
fn pairs(source: &dyn TexelSource, offsets: &U32s) -> [U32s; 2] {
    [source.gather(offsets), source.gather(&further(offsets, 4))]
}

#[cold]
#[inline(never)]
fn quads(source: &dyn TexelSource, offsets: &U32s, row: u32, [a, b, c, d]: &mut [U32s; 4]) {
    [*a, *b] = pairs(source, offsets);
    [*c, *d] = pairs(source, &further(offsets, row));
}

fn further(offsets: &U32s, by: u32) -> U32s {
    U32s::from_fn(|lane| offsets[lane].wrapping_add(by))
}

impl Deref for Memory {
    type Target = [u8];
    #[inline(always)]
    fn deref(&self) -> &[u8] {
        match &self.0 {
            Store::Rows { bytes, .. } => bytes,
            Store::Elsewhere { source, rows } => rows.get_or_init(|| source.rows()),
        }
    }
}

impl DerefMut for Memory {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [u8] {
        if let Store::Elsewhere { .. } = &self.0 {
            self.0 = Store::Rows { bytes: self.to_vec(), is_blank: false };
        }
        match &mut self.0 {
            Store::Rows { bytes, is_blank } => {
                *is_blank = false;
                bytes
            }
            Store::Elsewhere { .. } => &mut [],
        }
    }
}

impl Clone for Memory {
    fn clone(&self) -> Self {
        Self(match &self.0 {
            Store::Rows { bytes, is_blank: true } => {
                Store::Rows { bytes: vec![0; bytes.len()], is_blank: true }
            }
            Store::Rows { bytes, is_blank: false } => {
                Store::Rows { bytes: bytes.clone(), is_blank: false }
            }
            Store::Elsewhere { source, .. } => {
                Store::Elsewhere { source: Arc::clone(source), rows: OnceLock::new() }
            }
        })
    }
}

impl PartialEq for Memory {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl Eq for Memory {}

/// Zeroed memory; `None` if the allocation fails. Pages are not touched: images are often written whole right after.
pub fn zeroed(bytes: usize) -> Option<Vec<u8>> {
    // `vec!` aborts if the allocation fails.
    bytemuck::allocation::try_zeroed_slice_box(bytes).ok().map(Vec::from)
}

/// A copy.
///
/// # Errors
/// If the allocation fails.
pub fn copied<T: Copy>(from: &[T]) -> Result<Vec<T>, TryReserveError> {
    let mut to = Vec::new();
    to.try_reserve_exact(from.len())?;
    to.extend_from_slice(from);
    Ok(to)
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
