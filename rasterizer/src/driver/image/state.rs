//! The state behind the handles of an image, and where in it things lie.

use super::{LevelInfo, MultisampleStorage};
use crate::attachment::{Slices, StoreContext, Surface};
use crate::threads::ThreadPool;
use texunit::format::Format;
use texunit::image::{Image as Texels, ImageError, Level, Shape};
use texunit::lanes::Isa;

#[derive(Debug)]
pub(super) struct State {
    pub texels: Texels,
    /// The only level of an image of zeros whose rows have not been requested.
    pub blank: Option<Blank>,
    pub samples: u8,
    pub storage: MultisampleStorage,
    pub attached: Option<Attached>,
}

/// A level that is all zeros.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blank {
    pub format: Format,
    pub width: u32,
    pub height: u32,
}

#[derive(Debug)]
pub(super) struct Attached {
    pub at: Subresource,
    pub surface: Surface,
    /// That of the device that has drawn it.
    pub isa: Isa,
    /// Whether the rows of the level are older than the surface.
    pub drawn: bool,
}

/// A slice of a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Subresource {
    pub face: usize,
    pub slice: usize,
    pub level: usize,
}

impl Subresource {
    /// That it does not exist.
    pub fn missing(self) -> ImageError {
        ImageError::Missing { face: self.face, level: self.level }
    }
}

/// A slice of a level as it is drawn to: the format that its texels are taken for, that of the image or of a view, and its
/// samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TypedSubresource {
    pub at: Subresource,
    pub format: Format,
    /// Samples of a pixel.
    pub samples: u8,
}

impl TypedSubresource {
    /// Whether it is what is attached.
    pub fn is_of(self, attached: &Attached) -> bool {
        let Surface { format, samples, .. } = attached.surface;
        (attached.at, format, samples) == (self.at, self.format, self.samples)
    }
}

/// The face and the slice of a layer of an image of a shape.
pub(super) fn face_and_slice(shape: Shape, layer: usize) -> (usize, usize) {
    match shape {
        Shape::Cube => (layer, 0),
        Shape::D1
        | Shape::D2
        | Shape::D3
        | Shape::Rect
        | Shape::D1Array
        | Shape::D2Array
        | Shape::CubeArray => (0, layer),
    }
}

impl State {
    /// The slices of the level where its samples are.
    pub fn slices(&self, at: Subresource) -> Slices {
        match self.storage {
            MultisampleStorage::Resolved => Slices::One(at.slice),
            MultisampleStorage::EachSample => Slices::Each(at.slice * usize::from(self.samples)),
        }
    }

    /// How many slices a layer has.
    pub fn slices_of_a_layer(&self) -> usize {
        match self.storage {
            MultisampleStorage::Resolved => 1,
            MultisampleStorage::EachSample => self.samples.into(),
        }
    }

    /// What the level is, if it exists; it may have fewer slices.
    pub fn info(&self, at: Subresource) -> Option<LevelInfo> {
        let samples = self.samples;
        match self.blank {
            Some(Blank { format, width, height }) => {
                let is_it = (at.face, at.level) == (0, 0);
                let (size, border) = ([width, height, 1], [0; 3]);
                is_it.then_some(LevelInfo { format, size, border, samples })
            }
            None => {
                let level = self.texels.level(at.face, at.level)?;
                let (mut size, border, format) = (level.size(), level.border, level.format);
                if self.storage == MultisampleStorage::EachSample {
                    size[2] /= u32::from(samples);
                }
                Some(LevelInfo { format, size, border, samples })
            }
        }
    }

    /// Brings the rows up to date.
    ///
    /// # Errors
    /// If there is no memory for rows that were never requested, or that somebody else still reads; nothing has changed
    /// then.
    pub fn resolve(&mut self, thread_pool: &ThreadPool) -> Result<(), ImageError> {
        if let Some(Blank { format, width, height }) = self.blank {
            self.texels.set_level(0, 0, Level::new(format, width, height)?)?;
            self.blank = None;
        }
        let slices = self.attached.as_ref().map(|attached| self.slices(attached.at));
        let attached = self.attached.as_mut().filter(|attached| attached.drawn);
        if let (Some(attached), Some(slices)) = (attached, slices) {
            let Subresource { face, level, .. } = attached.at;
            self.texels.unshare(face, level)?;
            if let Some(level) = self.texels.level_mut(face, level) {
                let context = StoreContext { isa: attached.isa, thread_pool };
                attached.surface.store_changed(level, slices, context);
            }
            attached.drawn = false;
        }
        Ok(())
    }

    /// Texels that are gathered from the tiles of the attachment; `None` where the rows are up to date, or such lookups
    /// do not pay.
    pub fn texels_of_tiles(&self, isa: Isa) -> Option<Texels> {
        let attached = self.attached.as_ref().filter(|attached| attached.drawn)?;
        let base = Subresource { face: 0, slice: 0, level: 0 };
        let has_more = self.texels.level(0, 1).is_some();
        if self.texels.shape() != Shape::D2 || attached.at != base || has_more {
            return None;
        }
        if self.info(base)?.format != attached.surface.format {
            return None;
        }
        let mut texels = Texels::new(Shape::D2);
        texels.set_level(0, 0, attached.surface.level_of_tiles(isa)?).ok()?;
        Some(texels)
    }

    /// The surface of a slice, if it exists: a copy of it, or made from its rows.
    ///
    /// # Errors
    /// If there is no memory for its rows.
    pub fn surface(&mut self, stored: TypedSubresource) -> Result<Option<Surface>, ImageError> {
        if let Some(attached) = self.attached.as_ref().filter(|attached| stored.is_of(attached)) {
            return Ok(Some(attached.surface.clone()));
        }
        self.resolve(&ThreadPool::CALLER_ONLY)?;
        Ok(self.loaded(stored, &ThreadPool::CALLER_ONLY))
    }

    /// A slice in the attachment layout, from its rows.
    pub fn loaded(&self, stored: TypedSubresource, thread_pool: &ThreadPool) -> Option<Surface> {
        let TypedSubresource { at, format, samples } = stored;
        let level = self.texels.level(at.face, at.level)?;
        Some(Surface::from_level_as(format, level, self.slices(at), samples, thread_pool))
    }
}
