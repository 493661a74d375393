//! Views: images that show texels of another image, some of its levels and layers, as another format of the same size
//! (`ARB_texture_view`).
//!
//! The texels are those of the image that was made first: what is written through a view goes there, and what a view is
//! asked for is taken from there. A level that a view shows as it is stored is shared, not copied; of others the view
//! keeps copies while nothing changes.

use super::LevelInfo;
use super::state::{State, Subresource, face_and_slice};
use parking_lot::Mutex;
use std::ops::Range;
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image as Texels, ImageError, Level, Shape};

/// What a view shows of an image.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ViewDesc {
    /// Its shape: [`Shape::D3`] for a volume alone.
    pub shape: Shape,
    /// Its format; texels take as many bytes as those of the image.
    pub format: Format,
    /// The levels of the image that are its levels.
    pub levels: Range<usize>,
    /// The layers of the image (faces of a cube, slices of a volume) that are its layers or faces; `0..1` where both are
    /// volumes.
    pub layers: Range<usize>,
}

/// A view.
#[derive(Debug)]
pub(super) struct View {
    pub desc: ViewDesc,
    built: Mutex<Built>,
}

/// The texels of a view, as they were when its image had this version.
#[derive(Debug, Default)]
struct Built {
    version: u64,
    texels: Option<Texels>,
    /// The same, for the next update: nobody else reads the level that it writes to.
    writable: Option<Texels>,
}

/// Layers of a level of the image, or slices of a volume.
struct LayerRange {
    layers: Range<usize>,
    level: usize,
}

/// Slices of a level that lie together.
struct SliceRun {
    face: usize,
    first: usize,
    count: usize,
}

impl View {
    pub fn new(desc: ViewDesc) -> Self {
        Self { desc, built: Mutex::new(Built::default()) }
    }

    /// The view of this view.
    pub fn narrowed(&self, desc: ViewDesc) -> ViewDesc {
        let within = |outer: &Range<usize>, inner: &Range<usize>| {
            let at = |index: usize| (outer.start + index).min(outer.end);
            at(inner.start)..at(inner.end)
        };
        let levels = within(&self.desc.levels, &desc.levels);
        ViewDesc { levels, layers: within(&self.desc.layers, &desc.layers), ..desc }
    }

    /// Where a slice of the view lies in the image, which has this shape, if the view shows it.
    pub fn stored(&self, shape: Shape, at: Subresource) -> Option<Subresource> {
        let ViewDesc { levels, layers, .. } = &self.desc;
        let level = levels.start + at.level;
        let (face, slice) = match self.desc.shape {
            Shape::D3 => (0, at.slice),
            Shape::D1
            | Shape::D2
            | Shape::Rect
            | Shape::Cube
            | Shape::D1Array
            | Shape::D2Array
            | Shape::CubeArray => {
                let layer = layers.start + at.face + at.slice;
                if !layers.contains(&layer) {
                    return None;
                }
                face_and_slice(shape, layer)
            }
        };
        levels.contains(&level).then_some(Subresource { face, slice, level })
    }

    /// What is known of a level, from what is known of the image's.
    pub fn info(&self, info: LevelInfo) -> LevelInfo {
        let [width, height, depth] = info.size;
        let depth = match self.desc.shape {
            Shape::D3 => depth,
            Shape::D1Array | Shape::D2Array | Shape::CubeArray => self.desc.layers.len() as u32,
            Shape::D1 | Shape::D2 | Shape::Rect | Shape::Cube => 1,
        };
        LevelInfo { format: self.desc.format, size: [width, height, depth], ..info }
    }

    /// The layers of the image that are a level of a face.
    fn layers(&self, state: &State, face: usize, level: usize) -> Option<LayerRange> {
        let ViewDesc { shape, levels, layers, .. } = &self.desc;
        let level = levels.start + level;
        let layers = match shape {
            Shape::D3 => 0..state.texels.level(0, level)?.depth as usize,
            Shape::Cube => layers.start + face..layers.start + face + 1,
            Shape::D1
            | Shape::D2
            | Shape::Rect
            | Shape::D1Array
            | Shape::D2Array
            | Shape::CubeArray => layers.clone(),
        };
        Some(LayerRange { layers, level })
    }

    /// The texels, of an image whose rows are up to date. A level for which there is no memory is missing.
    pub fn texels(&self, state: &State, version: u64) -> Texels {
        let mut built = self.built.lock();
        match &built.texels {
            Some(texels) if built.version == version => texels.clone(),
            Some(_) | None => {
                // What it kept is freed first.
                *built = Built::default();
                let texels = self.build(state);
                *built = Built { version, texels: Some(texels.clone()), writable: None };
                texels
            }
        }
    }

    fn build(&self, state: &State) -> Texels {
        let mut texels = Texels::new(self.desc.shape);
        for level in 0..self.desc.levels.len() {
            for face in 0..self.desc.shape.faces() {
                if let Some(built) = self.level(state, face, level) {
                    // The client says a shape that has such levels.
                    let _ = texels.set_shared(face, level, built);
                }
            }
        }
        texels
    }

    fn level(&self, state: &State, face: usize, level: usize) -> Option<Arc<Level>> {
        let shown = self.layers(state, face, level)?;
        if let Some(level) = self.shared(state, &shown) {
            return Some(Arc::clone(level));
        }
        let runs = shown.runs(state);
        let first = state.texels.level(runs.first()?.face, shown.level)?;
        let depth = runs.iter().map(|run| run.count).sum::<usize>() as u32;
        let size = [first.width, first.height, depth];
        let mut level = Level::with_size(self.desc.format, size, [0; 3]).ok()?;
        let mut at = 0;
        for run in runs {
            let stored = state.texels.level(run.face, shown.level)?;
            let (slice, bytes) = (stored.slice_bytes(), run.count * stored.slice_bytes());
            if !stored.texels.is_blank() {
                let from = stored.texels.get(run.first * slice..run.first * slice + bytes)?;
                level.texels.get_mut(at..at + bytes)?.copy_from_slice(from);
            }
            at += bytes;
        }
        Some(Arc::new(level))
    }

    /// The level of the image, where it is what the view shows.
    fn shared<'a>(&self, state: &'a State, shown: &LayerRange) -> Option<&'a Arc<Level>> {
        let runs = shown.runs(state);
        let [run] = &runs[..] else { return None };
        let level = state.texels.level(run.face, shown.level)?;
        let is_all = run.first == 0 && run.count == level.depth as usize;
        (is_all && level.format == self.desc.format).then_some(level)
    }

    /// Takes the memory that an [`View::update`] of a level needs: a copy of it, and levels of the image that nobody else
    /// reads.
    pub fn prepare_update(
        &self,
        state: &mut State,
        version: u64,
        [face, level]: [usize; 2],
    ) -> Result<(), ImageError> {
        let mut texels = self.texels(state, version);
        let Some(shown) = self.layers(state, face, level) else { return Ok(()) };
        if self.shared(state, &shown).is_none() {
            for run in shown.runs(state) {
                state.texels.unshare(run.face, shown.level)?;
            }
        }
        if texels.level(face, level).is_none() {
            return Err(ImageError::Missing { face, level });
        }
        texels.unshare(face, level)?;
        self.built.lock().writable = Some(texels);
        Ok(())
    }

    /// Changes the texels, and those of the image with them.
    pub fn update<R>(
        &self,
        state: &mut State,
        version: u64,
        change: impl FnOnce(&mut Texels) -> R,
    ) -> R {
        let before = self.texels(state, version);
        let writable = self.built.lock().writable.take();
        let mut after = writable.unwrap_or_else(|| before.clone());
        let result = change(&mut after);
        for level in 0..self.desc.levels.len() {
            for face in 0..self.desc.shape.faces() {
                let changed = match (before.level(face, level), after.level(face, level)) {
                    (Some(before), Some(after)) => !Arc::ptr_eq(before, after),
                    (Some(_) | None, None) => false,
                    (None, Some(_)) => true,
                };
                if let (true, Some(texels)) = (changed, after.level(face, level)) {
                    self.write_back(state, (face, level), texels);
                }
            }
        }
        // They are made again when they are asked for, which shares what can be shared.
        *self.built.lock() = Built::default();
        result
    }

    /// Writes a level that has changed to the image.
    fn write_back(&self, state: &mut State, (face, level): (usize, usize), texels: &Arc<Level>) {
        let Some(shown) = self.layers(state, face, level) else { return };
        let runs = shown.runs(state);
        let shared =
            self.shared(state, &shown).is_some_and(|stored| stored.size() == texels.size());
        if let (true, Some(run)) = (shared, runs.first()) {
            // It has the size and the format of what it replaces.
            let _ = state.texels.set_shared(run.face, shown.level, Arc::clone(texels));
            return;
        }
        let mut at = 0;
        for run in runs {
            let Some(stored) = state.texels.level_mut(run.face, shown.level) else { return };
            let (slice, bytes) = (stored.slice_bytes(), run.count * stored.slice_bytes());
            let to = stored.texels.get_mut(run.first * slice..run.first * slice + bytes);
            if let (Some(to), Some(from)) = (to, texels.texels.get(at..at + bytes)) {
                to.copy_from_slice(from);
            }
            at += bytes;
        }
    }
}

impl LayerRange {
    /// Where its layers lie, in their order.
    fn runs(&self, state: &State) -> Vec<SliceRun> {
        let samples = state.slices_of_a_layer();
        let layers = self.layers.clone();
        if state.texels.shape() == Shape::Cube {
            return layers.map(|face| SliceRun { face, first: 0, count: 1 }).collect();
        }
        let (first, count) = (layers.start * samples, layers.len() * samples);
        vec![SliceRun { face: 0, first, count }]
    }
}
