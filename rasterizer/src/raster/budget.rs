//! How long the shaders of a draw may run.
//!
//! The first [`FREE_OPERATIONS`] of each batch are free, so that no draw is stopped for being large, unless it asks for
//! more than any scene has. What a batch runs beyond them is charged to the budget of its draw. Tiles run in waves of a
//! fixed size; what is left of the budget is divided among the tiles of a wave that the draw touches, so that what a
//! tile draws depends on no other tile of the wave, and hence on no thread. A draw that has used up its share in a tile
//! is stopped there, and everywhere from the next wave on.

/// The operations of a batch that are not charged to its draw: additions of 64 lanes.
pub const FREE_OPERATIONS: u64 = 1 << 21;

/// The tiles of the first wave: few, so that draws that do not end anywhere are found soon.
pub const FIRST_WAVE: usize = 8;
/// The tiles of each other wave.
pub const WAVE: usize = 64;

/// The budget of a draw in the current wave.
#[derive(Clone, Copy, Debug)]
pub struct DrawBudget {
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
        Self { left, share: 0, free: FREE_OPERATIONS, looped: 0, is_stopped: false }
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
}

impl TileBudget {
    /// Begins a draw.
    pub fn begin(&mut self, draw: &DrawBudget) {
        let DrawBudget { share, free, is_stopped, .. } = *draw;
        *self = Self { share, free, used: 0, looped: 0, is_stopped };
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
        let mut draw = DrawBudget::new(80 * FREE_OPERATIONS);
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
        assert!(draw.is_stopped && draw.left == 70 * FREE_OPERATIONS);
        assert_eq!(draw.looped, 14 * FREE_OPERATIONS);
    }
}
