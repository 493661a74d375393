//! Images: texels that can be sampled, and attachments that can be drawn to.
//!
//! An image has its texels in rows, to be sampled; while one of its levels is drawn to, that level
//! is in the attachment layout (`attachment`). The transition back happens when the texels are requested, not when a
//! pass ends, so that passes that follow each other do not pay for it.
//!
//! The rows of an image with several samples a pixel are what they are resolved to, and the samples
//! themselves are in the attachment layout alone; or every sample has rows of its own ([`MultisampleStorage`]), so
//! that they can be sampled one by one and several layers drawn to in turn.

mod attachment;
mod state;
mod stored;
mod view;

use crate::attachment::{RowSpan, RowWriter, StoreContext, Surface};
use crate::threads::ThreadPool;
pub(crate) use attachment::AttachmentInfo;
pub use attachment::{Attachment, PassDesc};
use parking_lot::RwLock;
use std::num::NonZeroU64;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use stored::Stored;
use texunit::format::Format;
use texunit::image::{Image as Texels, ImageError, Incomplete, Level, Levels};
use texunit::lanes::Isa;
use texunit::sampler::Sampler;
pub use view::ViewDesc;

/// An image of the driver. Cloning gives another handle to the same image.
#[derive(Clone, Debug)]
pub struct Image(Arc<Slot>);

/// What the handles of an image have in common: they follow it where it gets other storage.
#[derive(Debug)]
struct Slot {
    stored: RwLock<Stored>,
    /// Whether something else has ever had its storage too.
    shares: AtomicBool,
}

/// What the rows of an image with several samples a pixel hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MultisampleStorage {
    /// What the samples are resolved to.
    Resolved,
    /// The samples: each has a slice, those of a layer lie together. The shape is
    /// [`texunit::image::Shape::D2Array`].
    EachSample,
}

/// Format and size of a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LevelInfo {
    /// How its texels are stored.
    pub format: Format,
    /// Width, height, and depth or layers, without border.
    pub size: [u32; 3],
    /// Texels of border along each axis.
    pub border: [u32; 3],
    /// Samples of a pixel.
    pub samples: u8,
}

impl Image {
    fn of(stored: Stored) -> Self {
        Self(Arc::new(Slot { stored: RwLock::new(stored), shares: AtomicBool::new(false) }))
    }

    /// One whose storage something else has too.
    fn sharing(stored: Stored) -> Self {
        Self(Arc::new(Slot { stored: RwLock::new(stored), shares: AtomicBool::new(true) }))
    }

    /// An image with these texels.
    pub fn new(texels: Texels) -> Self {
        Self::with_samples(texels, 1)
    }

    /// An image of one level with several samples a pixel, each with these texels: as many as
    /// [`possible_samples`](crate::plan::possible_samples) says.
    pub fn with_samples(texels: Texels, samples: u8) -> Self {
        Self::of(Stored::with_samples(texels, samples))
    }

    /// A two-dimensional image of one level of zeros, which takes no memory until it is drawn to or its
    /// texels are asked for; samples as of [`Image::with_samples`].
    ///
    /// # Errors
    /// When it is too large.
    pub fn blank(format: Format, width: u32, height: u32, samples: u8) -> Result<Self, ImageError> {
        Ok(Self::of(Stored::blank(format, width, height, samples)?))
    }

    /// An image that shows texels of this one: it shares them. Their levels have no border.
    pub fn view(&self, desc: ViewDesc) -> Self {
        self.0.shares.store(true, Ordering::Release);
        Self::sharing(self.0.stored.read().view(desc))
    }

    /// Gives it the storage of another image: all handles of it show that from now on.
    pub fn share(&self, other: &Self) {
        // One lock after the other.
        let stored = other.stored_now();
        other.0.shares.store(true, Ordering::Release);
        self.0.shares.store(true, Ordering::Release);
        *self.0.stored.write() = stored;
    }

    /// Gives it storage of its own again, with the same texels: what shared its storage until now keeps that.
    pub fn separate(&self) {
        let mut stored = self.0.stored.write();
        *stored = stored.separate();
    }

    /// The same storage behind a handle that stays with it.
    pub(super) fn pinned(&self) -> Self {
        Self::sharing(self.stored_now())
    }

    fn stored_now(&self) -> Stored {
        self.0.stored.read().clone()
    }

    /// Counts the changes of texels that views share; `None` where nothing shares them.
    pub fn shared_version(&self) -> Option<NonZeroU64> {
        if !self.0.shares.load(Ordering::Acquire) {
            return None;
        }
        self.0.stored.read().shared_version()
    }

    /// How many samples a pixel has; 1 if it is no multisample image.
    pub fn samples(&self) -> u8 {
        self.0.stored.read().samples()
    }

    /// Its texels as they are after everything submitted so far. Shares them: later writes to the
    /// image copy. Of a multisample image, as its [`MultisampleStorage`] says.
    pub fn texels(&self) -> Texels {
        self.texels_with(&ThreadPool::CALLER_ONLY)
    }

    /// As [`Image::texels`], brought up to date by these ([`super::Device::texels`]).
    pub(super) fn texels_with(&self, thread_pool: &ThreadPool) -> Texels {
        self.0.stored.read().texels_with(thread_pool)
    }

    /// [`Image::texels`] for lookups that compare depths: of an image of one level that was drawn to, they may be gathered
    /// from the tiles of the attachment.
    pub(super) fn compared_texels_with(&self, isa: Isa, thread_pool: &ThreadPool) -> Texels {
        self.0.stored.read().compared_texels_with(isa, thread_pool)
    }

    /// Whether it can be sampled with a sampler, and from which levels.
    ///
    /// # Errors
    /// Why it cannot.
    pub fn completeness(&self, sampler: &Sampler) -> Result<Levels, Incomplete> {
        self.0.stored.read().completeness(sampler)
    }

    /// Whether texels of [`super::Device::compared_texels`] read the tiles, which a pass that draws to the image would
    /// copy.
    pub fn has_readers_of_tiles(&self) -> bool {
        self.0.stored.read().has_readers_of_tiles()
    }

    /// What is known of a level without looking at its texels, if it exists.
    pub fn level(&self, face: usize, level: usize) -> Option<LevelInfo> {
        self.0.stored.read().level(face, level)
    }

    /// Whether all texels are those that it was made with, without data: nothing that was submitted has drawn to them, and
    /// nothing was written.
    pub fn is_untouched(&self) -> bool {
        self.0.stored.read().is_untouched()
    }

    /// Changes its texels. Draws that were recorded earlier keep what they saw.
    pub fn update<R>(&self, change: impl FnOnce(&mut Texels) -> R) -> R {
        self.0.stored.read().update(change)
    }

    /// Takes the memory that an [`Image::update`] of a level of a face, or of the face of a layer, needs, which writes to it
    /// by [`Texels::level_mut`]: until the texels are requested again it cannot fail then.
    ///
    /// # Errors
    /// If there is none; nothing has changed then.
    pub fn prepare_update(&self, face: u16, level: u8) -> Result<(), ImageError> {
        self.0.stored.read().prepare_update(face, level)
    }

    /// Replaces its texels; `storage` says what they are for this number of samples.
    pub fn replace(&self, texels: Texels, samples: u8, storage: MultisampleStorage) {
        self.0.stored.read().replace(texels, samples, storage);
    }

    /// What an attachment names with one sample a pixel, which several are resolved to: a level, and
    /// which slice of it ([`super::Device::resolved`]).
    ///
    /// # Errors
    /// If it does not exist, or there is no memory for it.
    pub(super) fn resolved_with(
        &self,
        face: u16,
        level: u8,
        context: StoreContext<'_>,
    ) -> Result<(Arc<Level>, usize), ImageError> {
        self.0.stored.read().resolved_with(face, level, context)
    }

    /// Writes a region of what an attachment names into the rows of a client ([`super::Device::read`]). The rows of the
    /// image are not brought up to date.
    pub(super) fn read_with(
        &self,
        at: (u16, u8),
        span: RowSpan,
        rows: &mut [&mut [u8]],
        writer: RowWriter<'_>,
        context: StoreContext<'_>,
    ) {
        self.0.stored.read().read_with(at, span, rows, writer, context);
    }

    /// The samples of what an attachment names, each a slice.
    ///
    /// # Errors
    /// If it does not exist, or there is no memory for them.
    pub fn each_sample(&self, face: u16, level: u8) -> Result<Level, ImageError> {
        self.0.stored.read().each_sample(face, level)
    }

    /// Puts other samples in place of those of what an attachment names
    /// ([`super::Device::set_each_sample`]).
    pub(super) fn set_each_sample(&self, face: u16, level: u8, samples: &Level, isa: Isa) {
        self.0.stored.read().set_each_sample(face, level, samples, isa);
    }

    /// Whether both handles name the same image, or the same view.
    pub fn is_same_image(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// Whether they are the same image, or have the same storage.
    pub fn shares_texels(&self, other: &Self) -> bool {
        if self.is_same_image(other) {
            return true;
        }
        let is_possible = |image: &Self| image.0.shares.load(Ordering::Acquire);
        // One lock after the other.
        is_possible(self) && is_possible(other) && {
            let stored = self.stored_now();
            stored.shares_texels(&other.0.stored.read())
        }
    }

    /// Format and size of what an attachment names, if it exists.
    pub(crate) fn attachment(&self, face: u16, level: u8) -> Option<AttachmentInfo> {
        self.0.stored.read().attachment(face, level)
    }

    /// Takes a slice of a level out in the attachment layout; `None` if it does not exist.
    pub(crate) fn attach(&self, face: u16, level: u8, thread_pool: &ThreadPool) -> Option<Surface> {
        self.0.stored.read().attach(face, level, thread_pool)
    }

    /// Puts back what [`Image::attach`] took, drawn to by a device of this instruction set.
    pub(crate) fn detach(&self, face: u16, level: u8, surface: Surface, isa: Isa) {
        self.0.stored.read().detach(face, level, surface, isa);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use texunit::image::Shape;

    /// As where another context specifies a level while a pass draws to it.
    #[test]
    fn a_surface_of_a_level_that_was_replaced_is_dropped() {
        let image = Image::blank(Format::Rgba8, 8, 8, 1).expect("small");
        let surface = image.attach(0, 0, &ThreadPool::CALLER_ONLY).expect("it exists");
        let mut texels = Texels::new(Shape::D2);
        texels.set_level(0, 0, Level::new(Format::Rgb8, 8, 8).expect("small")).expect("it fits");
        image.replace(texels, 1, MultisampleStorage::Resolved);
        image.detach(0, 0, surface, Isa::BASELINE);
        let format = image.texels().level(0, 0).map(|level| level.format);
        assert_eq!(format, Some(Format::Rgb8));
    }
}
