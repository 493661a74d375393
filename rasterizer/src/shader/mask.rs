//! Sets of lanes as words 0 or `!0`, with a summary that lets most of the work be skipped.

use texunit::lanes::{LANES, U32s};

/// What is known of a mask without looking at its lanes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Extent {
    /// No lane; the words may hold anything.
    #[default]
    Empty,
    /// At least one lane, not all of the run's.
    Part,
    /// Every lane that the run began with.
    Whole,
}

/// A set of lanes of a run.
#[derive(Debug, Default)]
pub(super) struct Mask {
    pub lanes: Box<U32s>,
    pub extent: Extent,
}

impl Mask {
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.extent == Extent::Empty
    }

    #[inline(always)]
    pub fn clear(&mut self) {
        self.extent = Extent::Empty;
    }

    /// Moves every lane of `from` here. `start` is the mask that the run began with.
    #[inline(always)]
    pub fn take(&mut self, from: &mut Self, start: &U32s) {
        if self.is_empty() {
            std::mem::swap(self, from);
        } else if !from.is_empty() {
            let mut missing = 0;
            for lane in 0..LANES {
                self.lanes[lane] |= from.lanes[lane];
                missing |= self.lanes[lane] ^ start[lane];
            }
            self.extent = if missing == 0 { Extent::Whole } else { Extent::Part };
        }
        from.clear();
    }

    /// Keeps the lanes where the condition holds and moves the others to `rest`.
    #[inline(always)]
    pub fn split(&mut self, condition: &U32s, rest: &mut Self) {
        rest.clear();
        if self.is_empty() {
            return;
        }
        let (mut held, mut failed) = (0, 0);
        for lane in 0..LANES {
            held |= self.lanes[lane] & condition[lane];
            failed |= self.lanes[lane] & !condition[lane];
        }
        if held == 0 {
            std::mem::swap(self, rest);
        } else if failed != 0 {
            for lane in 0..LANES {
                rest.lanes[lane] = self.lanes[lane] & !condition[lane];
                self.lanes[lane] &= condition[lane];
            }
            self.extent = Extent::Part;
            rest.extent = Extent::Part;
        }
    }

    /// The lanes as bits.
    pub fn bits(&self) -> u64 {
        if self.is_empty() {
            return 0;
        }
        (0..LANES).fold(0, |bits, lane| bits | u64::from(self.lanes[lane] & 1) << lane)
    }

    /// The lanes whose bits are set, as the whole of a run.
    pub fn whole(&mut self, bits: u64) {
        *self.lanes = U32s::from_fn(|lane| 0u32.wrapping_sub((bits >> lane) as u32 & 1));
        self.extent = if bits == 0 { Extent::Empty } else { Extent::Whole };
    }
}
