//! Stores only the tiles whose rows in the level differ, so that reading a few pixels after a small draw is cheap, and
//! so is a large attachment of which each frame draws to a part: a tile that was cleared again, to what its rows hold
//! since the clear before, is not stored.

use super::{Level, Slices, StoreContext, Surface, WordPlane};
use crate::attachment::words::attachment_words;
use texunit::format::Format;

/// What the rows of a level hold of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum RowsOfTile {
    /// What the tile holds.
    Current,
    /// What it held before it was drawn to.
    Older,
    /// These words in every pixel, whatever the tile holds.
    Uniform([u32; 4]),
}

/// The words of every pixel and sample of a tile, where all are equal.
fn uniform_words(format: Format, tile: &[WordPlane]) -> Option<[u32; 4]> {
    let count = attachment_words(format);
    let mut words = [0; 4];
    for (at, plane) in tile.iter().enumerate() {
        let word = plane.cleared_word()?;
        match at.checked_sub(count) {
            None => words[at] = word,
            Some(_) if words[at % count] == word => {}
            Some(_) => return None,
        }
    }
    Some(words)
}

impl RowsOfTile {
    /// Those of a tile that was just stored, or loaded.
    pub fn after_storing(format: Format, tile: &[WordPlane]) -> Self {
        uniform_words(format, tile).map_or(Self::Current, Self::Uniform)
    }

    /// Notes that the tile is drawn to.
    pub fn change(&mut self) {
        match self {
            Self::Current => *self = Self::Older,
            Self::Older | Self::Uniform(_) => {}
        }
    }

    /// Whether they differ from what the tile holds.
    fn differ(self, format: Format, tile: &[WordPlane]) -> bool {
        match self {
            Self::Current => false,
            Self::Older => true,
            Self::Uniform(words) => uniform_words(format, tile) != Some(words),
        }
    }
}

impl Surface {
    /// Takes the rows of all tiles for older than these.
    pub fn change_all(&mut self) {
        self.rows.fill(RowsOfTile::Older);
    }

    /// Writes the tiles whose rows differ back into slices of the level.
    pub fn store_changed(&mut self, level: &mut Level, slices: Slices, context: StoreContext<'_>) {
        let pairs = self.rows.iter().zip(&*self.tiles);
        let differs: Vec<bool> = pairs.map(|(rows, tile)| rows.differ(self.format, tile)).collect();
        // Rows that are not written may have no memory yet.
        if !differs.contains(&true) {
            return;
        }
        self.store_tiles(&differs, level, slices, context);
        for ((rows, tile), differs) in self.rows.iter_mut().zip(&*self.tiles).zip(differs) {
            if differs {
                *rows = RowsOfTile::after_storing(self.format, tile);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attachment::plane::WordPlane;
    use crate::threads::ThreadPool;
    use texunit::format::Format;
    use texunit::lanes::{Isa, U32s};

    /// Storing tile by tile equals storing all of them.
    #[test]
    fn what_has_changed_is_stored_as_all_is() {
        for (format, samples) in [(Format::Rgba8, 1), (Format::R8, 4), (Format::Rgba32F, 4)] {
            for each in [false, true] {
                let slices = if each { Slices::Each(1) } else { Slices::One(2) };
                let mut level = Level::with_size(format, [150, 130, 5], [0; 3]).expect("small");
                let mut surface =
                    Surface::from_level(&level, slices, samples, &ThreadPool::CALLER_ONLY);
                for tile in [0, 4, 8] {
                    let mut target = surface.take(tile);
                    for (at, plane) in target.planes.iter_mut().enumerate() {
                        let word =
                            |block: usize, lane: usize| (block * 977 + lane * 31 + at * 7) as u32;
                        let block = |block| U32s::from_fn(|lane| word(block, lane) & 0xFF);
                        *plane = WordPlane::of((0..64).map(block).collect());
                    }
                    surface.put_back(tile, target.planes);
                }
                let context =
                    StoreContext { isa: Isa::best(), thread_pool: &ThreadPool::CALLER_ONLY };
                let mut all = level.clone();
                surface.store(&mut all, slices, context);
                surface.store_changed(&mut level, slices, context);
                assert!(level.texels == all.texels, "{format:?} of {samples} samples, {slices:?}");
                // A tile that is cleared to what its rows hold is not stored.
                let cleared = vec![WordPlane::cleared(0); surface.tiles[1].len()];
                surface.take(1);
                surface.put_back(1, cleared);
                // Nothing has changed since.
                let mut other = Level::with_size(format, [150, 130, 5], [0; 3]).expect("small");
                surface.store_changed(&mut other, slices, context);
                assert!(other.texels.iter().all(|byte| *byte == 0));
                surface.change_all();
                surface.store_changed(&mut other, slices, context);
                assert!(other.texels == all.texels);
            }
        }
    }
}
