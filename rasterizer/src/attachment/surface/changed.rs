//! Stores only the tiles that changed, so that reading a few pixels after a small draw is cheap.

use super::{Level, RowSpan, Slices, StoreContext, Surface, WORTH_THREADS};
use crate::sizes::TILE;

impl Surface {
    /// Takes all tiles for changed.
    pub fn change_all(&mut self) {
        self.changed.fill(true);
    }

    /// Writes the tiles that have changed since they were last the level's back into its slices.
    pub fn store_changed(&mut self, level: &mut Level, slices: Slices, context: StoreContext<'_>) {
        let changed: Vec<usize> =
            (0..self.changed.len()).filter(|&tile| self.changed[tile]).collect();
        if changed.len() >= WORTH_THREADS.min(self.tiles.len()) {
            self.store(level, slices, context);
        } else {
            for tile in changed {
                let across = self.tiles_across();
                let [x, y] = [tile as u32 % across, tile as u32 / across].map(|at| at * TILE);
                let span = RowSpan { x, y, width: TILE.min(self.width - x) };
                self.store_rows(span, TILE.min(self.height - y), level, slices, context);
            }
        }
        self.changed.fill(false);
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
                    surface.tiles[tile] = target.planes;
                }
                let context =
                    StoreContext { isa: Isa::best(), thread_pool: &ThreadPool::CALLER_ONLY };
                let mut all = level.clone();
                surface.store(&mut all, slices, context);
                surface.store_changed(&mut level, slices, context);
                assert!(level.texels == all.texels, "{format:?} of {samples} samples, {slices:?}");
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
