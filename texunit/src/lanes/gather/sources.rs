//! Gathers in which each lane reads from a slice of its own: faces and levels of a texture.

use super::U32s;
use crate::lanes::LANES;

/// How many slices [`Sources`] has room for.
const ROOM: usize = 128;

/// The slices that lanes read from, by number.
#[derive(Debug)]
pub struct Sources<'a>([&'a [u8]; ROOM]);

/// Where the bytes of each lane are.
pub(in crate::lanes) struct Addresses([*const u8; LANES]);

impl<'a> Sources<'a> {
    /// Numbers below this one are slices.
    pub const ROOM: usize = ROOM;

    /// Slices without bytes.
    #[inline(always)]
    pub fn empty() -> Self {
        Self([&[]; ROOM])
    }

    /// Sets a slice; numbers from [`Self::ROOM`] on have none.
    #[inline(always)]
    pub fn set(&mut self, number: usize, bytes: &'a [u8]) {
        if let Some(slice) = self.0.get_mut(number) {
            *slice = bytes;
        }
    }

    /// The address at each offset of the slice of this number.
    ///
    /// # Panics
    /// When `size` bytes and those that are `apart` further are not all inside the slice.
    #[inline(always)]
    pub(in crate::lanes) fn addresses(
        &self,
        numbers: &U32s,
        offsets: &U32s,
        (size, apart): (u32, Option<&U32s>),
    ) -> Addresses {
        let mut out = [std::ptr::null(); LANES];
        let mut is_inside = true;
        for lane in 0..LANES {
            let number = numbers[lane] as usize;
            let slice = self.0[number % ROOM];
            let further = match apart {
                Some(apart) => u64::from(apart[lane]),
                None => 0,
            };
            let end = u64::from(offsets[lane]) + further + u64::from(size);
            is_inside &= (end <= slice.len() as u64) & (number < ROOM);
            out[lane] = slice.as_ptr().wrapping_add(offsets[lane] as usize);
        }
        assert!(is_inside, "a gather outside its slice");
        Addresses(out)
    }
}

impl Addresses {
    /// The word at each address.
    ///
    /// # Safety
    /// Four bytes can be read there.
    #[inline(always)]
    pub(in crate::lanes) unsafe fn words(&self) -> U32s {
        let mut out = U32s::ZERO;
        for lane in 0..LANES {
            // SAFETY: the caller vouches for the bytes.
            out[lane] = u32::from_le(unsafe { self.0[lane].cast::<u32>().read_unaligned() });
        }
        out
    }

    /// The two words `further` bytes (one number for each lane, or none) after each address.
    ///
    /// # Safety
    /// Eight bytes can be read there.
    #[inline(always)]
    pub(in crate::lanes) unsafe fn pairs(&self, further: Option<&U32s>, out: [&mut U32s; 2]) {
        let [first, second] = out;
        for lane in 0..LANES {
            let further = match further {
                Some(further) => further[lane] as usize,
                None => 0,
            };
            // SAFETY: the caller vouches for the bytes.
            let pair =
                u64::from_le(unsafe { self.0[lane].add(further).cast::<u64>().read_unaligned() });
            first[lane] = pair as u32;
            second[lane] = (pair >> 32) as u32;
        }
    }
}
