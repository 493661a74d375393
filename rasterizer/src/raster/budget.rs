//! How long the shaders of a draw may run.
//!
//! The first [`FREE_OPERATIONS`] of each batch are free, so that no draw is stopped for being large, unless it asks for
//! more than any scene has. What a batch runs beyond them is charged to the budget of its draw. Tiles run in waves of a
//! fixed size; what is left of the budget is divided among the tiles of a wave that the draw touches, so that what a
//! tile draws depends on no other tile of the wave, and hence on no thread. A draw that has used up its share in a tile
//! is stopped there, and everywhere from the next wave on.
//!
//! A draw that is stopped takes what is left of the frame's budget: later draws in the tile, and all from the next wave
//! on, have [`FREE_WHERE_NOTHING_IS_LEFT`] for a batch and nothing else.

/// The operations of a batch that are not charged to its draw: additions of 64 lanes. Twice what a pixel of an
/// irradiance map takes whose shader sums 16,000 lookups of a cube map, as programs with image-based light do.
pub const FREE_OPERATIONS: u64 = 1 << 24;

/// The operations of a batch that are not charged, where stopped draws have used up the budget of the frame.
pub const FREE_WHERE_NOTHING_IS_LEFT: u64 = 1 << 15;

/// What a batch may run without a charge, of a budget of which `spent` is gone.
pub fn free_operations(budget: u64, spent: u64) -> u64 {
    if spent > 0 && spent >= budget { FREE_WHERE_NOTHING_IS_LEFT } else { FREE_OPERATIONS }
}

/// The tiles of the first wave: few, so that draws that do not end anywhere are found soon.
pub const FIRST_WAVE: usize = 4;
/// The tiles of each other wave.
pub const WAVE: usize = 64;

/// The budget of a draw in the current wave.
#[derive(Clone, Copy, Debug)]
pub struct DrawBudget {
    /// That of the frame.
    frame: u64,
    /// What is left for it and the later waves.
    pub left: u64,
    /// The share of a tile.
    pub share: u64,
    /// What each batch may run without a charge.
    free: u64,
    /// What loops have run since it was last taken, free or not.
    pub looped: u64,
    /// Whether the rest of the draw is left out.
    pub is_stopped: bool,
}

impl DrawBudget {
    /// The budget before the first wave.
    pub fn new(left: u64) -> Self {
        let (frame, free) = (left, FREE_OPERATIONS);
        Self { frame, left, share: 0, free, looped: 0, is_stopped: false }
    }

    /// The budget of a draw of which each operation of a loop is charged.
    pub fn without_free(left: u64) -> Self {
        Self { free: 0, ..Self::new(left) }
    }

    /// Divides what is left among the tiles of a wave that the draw touches. A small draw does not get more for a tile
    /// than one that covers the first wave: a tile is one thread's.
    pub fn divide(&mut self, tiles: usize) {
        self.share = self.left / tiles.max(FIRST_WAVE) as u64;
    }

    /// Leaves no more than what other draws, which have spent so much, left of the frame's budget.
    pub fn share_frame(&mut self, spent: u64) {
        self.left = self.left.min(self.frame.saturating_sub(spent));
        self.free = self.free.min(free_operations(self.frame, spent));
    }

    /// That of its frame.
    pub fn frame(&self) -> u64 {
        self.frame
    }

    /// Deducts what a tile has run.
    pub fn deduct(&mut self, charge: &Charge) {
        self.left = self.left.saturating_sub(charge.operations);
        self.looped = self.looped.saturating_add(charge.looped);
        self.is_stopped |= charge.is_stopped;
    }
}

/// What the loops of a draw have run in a tile.
#[derive(Clone, Copy, Debug)]
pub struct Charge {
    /// The draw.
    pub draw: usize,
    /// The operations beyond what is free.
    pub operations: u64,
    /// All operations of loops.
    pub looped: u64,
    /// Whether they exceed the share of the tile.
    pub is_stopped: bool,
}

/// The budget of the current draw in the current tile.
#[derive(Debug, Default)]
pub struct TileBudget {
    share: u64,
    free: u64,
    used: u64,
    looped: u64,
    is_stopped: bool,
    /// Whether a draw was stopped in the tile.
    has_stopped: bool,
}

impl TileBudget {
    /// Begins a tile.
    pub fn begin_tile(&mut self) {
        *self = Self::default();
    }

    /// Begins a draw.
    pub fn begin(&mut self, draw: &DrawBudget) {
        let DrawBudget { share, free, is_stopped, .. } = *draw;
        let has_stopped = self.has_stopped;
        let (share, free) = match has_stopped {
            true => (0, free.min(FREE_WHERE_NOTHING_IS_LEFT)),
            false => (share, free),
        };
        *self = Self { share, free, used: 0, looped: 0, is_stopped, has_stopped };
    }

    /// Whether the rest of the draw is left out in this tile.
    pub fn is_stopped(&self) -> bool {
        self.is_stopped
    }

    /// What the next batch may run.
    pub fn of_batch(&self) -> u64 {
        self.free.saturating_add(self.share - self.used)
    }

    /// A batch has left this of [`Self::of_batch`].
    pub fn batch_left(&mut self, left: u64) {
        self.looped = self.looped.saturating_add(self.of_batch() - left);
        self.used += (self.share - self.used).saturating_sub(left);
    }

    /// A batch has run over [`Self::of_batch`].
    pub fn stop(&mut self) {
        self.looped = self.looped.saturating_add(self.of_batch());
        (self.used, self.is_stopped) = (self.share, true);
        self.has_stopped = true;
    }

    /// What is charged to the draw, if anything is.
    pub fn charge(&self, draw: usize) -> Option<Charge> {
        let Self { used: operations, looped, is_stopped, .. } = *self;
        (looped > 0 || is_stopped).then_some(Charge { draw, operations, looped, is_stopped })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_batch_is_charged_for_what_is_not_free() {
        let mut draw = DrawBudget::new(40 * FREE_OPERATIONS);
        draw.divide(3);
        let mut tile = TileBudget::default();
        tile.begin(&draw);
        assert_eq!(tile.of_batch(), 11 * FREE_OPERATIONS);
        // A batch of 1, 3 and 8 times what is free.
        tile.batch_left(10 * FREE_OPERATIONS);
        let charge = tile.charge(5).expect("it has run");
        assert_eq!((charge.operations, charge.looped), (0, FREE_OPERATIONS));
        tile.batch_left(8 * FREE_OPERATIONS);
        assert_eq!(tile.of_batch(), 9 * FREE_OPERATIONS);
        tile.batch_left(FREE_OPERATIONS);
        assert_eq!(tile.of_batch(), 2 * FREE_OPERATIONS);
        tile.stop();
        let charge = tile.charge(5).expect("it is stopped");
        assert_eq!((charge.draw, charge.operations), (5, 10 * FREE_OPERATIONS));
        assert_eq!(charge.looped, 14 * FREE_OPERATIONS);
        draw.deduct(&charge);
        assert!(draw.is_stopped && draw.left == 30 * FREE_OPERATIONS);
        assert_eq!(draw.looped, 14 * FREE_OPERATIONS);
    }

    #[test]
    fn after_a_stopped_draw_a_batch_has_little() {
        let mut draw = DrawBudget::new(80 * FREE_OPERATIONS);
        draw.divide(8);
        let mut tile = TileBudget::default();
        tile.begin_tile();
        tile.begin(&draw);
        tile.stop();
        tile.begin(&draw);
        assert_eq!((tile.of_batch(), tile.is_stopped()), (FREE_WHERE_NOTHING_IS_LEFT, false));
        tile.begin_tile();
        tile.begin(&draw);
        assert_eq!(tile.of_batch(), 11 * FREE_OPERATIONS);
        // In the next wave.
        draw.share_frame(draw.frame());
        draw.divide(8);
        tile.begin(&draw);
        assert_eq!(tile.of_batch(), FREE_WHERE_NOTHING_IS_LEFT);
        // However little draws have.
        assert_eq!(free_operations(0, 0), FREE_OPERATIONS);
        assert_eq!(free_operations(0, 1), FREE_WHERE_NOTHING_IS_LEFT);
        assert_eq!(free_operations(100, 99), FREE_OPERATIONS);
    }
}
