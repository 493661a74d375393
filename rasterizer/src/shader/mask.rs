//! Sets of lanes as words 0 or `!0`, with a summary that lets most of the work be skipped.

use super::inst::When;
use texunit::lanes::{LANES, U32s};

/// What is known of a mask without looking at its lanes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Extent {
    /// No lane; the words may hold anything.
    #[default]
    Empty,
    /// At least one lane, not all of the run's.
    Partial,
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
            let missing = union(&mut self.lanes, &from.lanes, start);
            self.extent = if missing == 0 { Extent::Whole } else { Extent::Partial };
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
        let (held, failed) = any_held_and_failed(&self.lanes, condition);
        if held == 0 {
            std::mem::swap(self, rest);
        } else if failed != 0 {
            partition(&mut self.lanes, &mut rest.lanes, condition, 0, 0);
            self.extent = Extent::Partial;
            rest.extent = Extent::Partial;
        }
    }

    /// Moves the lanes that the condition sends to `to`.
    #[inline(always)]
    pub fn leave_if(&mut self, condition: &U32s, when: When, to: &mut Self, start: &U32s) {
        if self.is_empty() {
            return;
        }
        let (held, failed) = any_held_and_failed(&self.lanes, condition);
        let (leave, stay, flip) = match when {
            When::Holds => (held, failed, !0),
            When::Fails => (failed, held, 0),
        };
        if stay == 0 {
            to.take(self, start);
        } else if leave != 0 {
            let keep = if to.is_empty() { 0 } else { !0 };
            partition(&mut self.lanes, &mut to.lanes, condition, keep, flip);
            self.extent = Extent::Partial;
            to.extent = Extent::Partial;
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

// Functions of their own, so that the compiler sees that what they write is not what they read.

/// Adds the lanes of `from`; not 0 when lanes of `start` are still missing.
#[inline(always)]
fn union(lanes: &mut U32s, from: &U32s, start: &U32s) -> u32 {
    let mut missing = 0;
    for lane in 0..LANES {
        let all = lanes[lane] | from[lane];
        lanes[lane] = all;
        missing |= all ^ start[lane];
    }
    missing
}

/// Not 0 where lanes meet the condition, and where they do not.
#[inline(always)]
fn any_held_and_failed(lanes: &U32s, condition: &U32s) -> (u32, u32) {
    let (mut held, mut failed) = (0, 0);
    for lane in 0..LANES {
        held |= lanes[lane] & condition[lane];
        failed |= lanes[lane] & !condition[lane];
    }
    (held, failed)
}

/// Keeps the lanes where `condition ^ flip` holds; the others go to `rest`, beside what `keep`
/// leaves of it.
#[inline(always)]
fn partition(lanes: &mut U32s, rest: &mut U32s, condition: &U32s, keep: u32, flip: u32) {
    for lane in 0..LANES {
        let stays = condition[lane] ^ flip;
        rest[lane] = (rest[lane] & keep) | (lanes[lane] & !stays);
        lanes[lane] &= stays;
    }
}

/// The words of `new` where the mask is set, else those of `old`.
#[inline(always)]
pub(super) fn blend(out: &mut U32s, mask: &U32s, new: &U32s, old: &U32s) {
    for lane in 0..LANES {
        out[lane] = (new[lane] & mask[lane]) | (old[lane] & !mask[lane]);
    }
}
