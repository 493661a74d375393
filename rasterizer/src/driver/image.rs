//! Images: texels that can be sampled, and attachments that can be drawn to.
//!
//! An image has its texels in rows, to be sampled; while one of its levels is drawn to, that level
//! is in the attachment layout (`attachment`). The transition back happens when the texels are requested, not when a
//! pass ends, so that passes that follow each other do not pay for it.
//!
//! The rows of an image with several samples a pixel are what they are resolved to, and the samples
//! themselves are in the attachment layout alone; or every sample has rows of its own ([`MultisampleStorage`]), so
//! that they can be sampled one by one and several layers drawn to in turn.

use crate::attachment::{RowSpan, RowWriter, Slices, StoreContext, Surface};
use crate::plan::possible_samples;
use crate::sizes::MAX_SAMPLES;
use crate::threads::ThreadPool;
use parking_lot::Mutex;
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image as Texels, ImageError, Incomplete, Level, Levels, Shape};
use texunit::lanes::{FloatEnv, Isa};
use texunit::sampler::Sampler;

/// An image of the driver. Cloning gives another handle to the same image.
#[derive(Clone, Debug)]
pub struct Image(Arc<Mutex<State>>);

#[derive(Debug)]
struct State {
    texels: Texels,
    /// The only level of an image of zeros whose rows have not been requested.
    blank: Option<Blank>,
    samples: u8,
    storage: MultisampleStorage,
    attached: Option<Attached>,
}

/// What the rows of an image with several samples a pixel hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MultisampleStorage {
    /// What the samples are resolved to.
    Resolved,
    /// The samples: each has a slice, those of a layer lie together. The shape is
    /// [`Shape::D2Array`].
    EachSample,
}

/// A level that is all zeros.
#[derive(Clone, Copy, Debug)]
struct Blank {
    format: Format,
    width: u32,
    height: u32,
}

#[derive(Debug)]
struct Attached {
    at: Subresource,
    surface: Surface,
    /// That of the device that has drawn it.
    isa: Isa,
    /// Whether the rows of the level are older than the surface.
    drawn: bool,
}

/// A slice of a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Subresource {
    face: usize,
    slice: usize,
    level: usize,
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

/// The size and kind of what is attached.
pub(crate) struct AttachmentInfo {
    pub format: Format,
    pub width: u32,
    pub height: u32,
    pub samples: u8,
}

/// Which face of an image of a shape an attachment's number names, and which slice.
fn face_and_slice(shape: Shape, number: u16) -> (usize, usize) {
    match shape {
        Shape::Cube => (number.into(), 0),
        Shape::D1
        | Shape::D2
        | Shape::D3
        | Shape::Rect
        | Shape::D1Array
        | Shape::D2Array
        | Shape::CubeArray => (0, number.into()),
    }
}

impl State {
    /// The slice, face and level that an attachment names.
    fn subresource(&self, face: u16, level: u8) -> Subresource {
        let (face, slice) = face_and_slice(self.texels.shape(), face);
        Subresource { face, slice, level: level.into() }
    }

    /// The slices of the level where its samples are.
    fn slices(&self, at: Subresource) -> Slices {
        match self.storage {
            MultisampleStorage::Resolved => Slices::One(at.slice),
            MultisampleStorage::EachSample => Slices::Each(at.slice * usize::from(self.samples)),
        }
    }

    /// What the level is, if it exists; it may have fewer slices.
    fn info(&self, at: Subresource) -> Option<LevelInfo> {
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

    /// Brings the rows up to date. Those of a blank level are not there if there is no memory.
    fn resolve(&mut self, thread_pool: &ThreadPool) {
        if let Some(Blank { format, width, height }) = self.blank.take()
            && let Ok(level) = Level::new(format, width, height)
        {
            // A level fits an image that has none.
            let _ = self.texels.set_level(0, 0, level);
        }
        let slices = self.attached.as_ref().map(|attached| self.slices(attached.at));
        let attached = self.attached.as_mut().filter(|attached| attached.drawn);
        if let (Some(attached), Some(slices)) = (attached, slices) {
            let Subresource { face, level, .. } = attached.at;
            if let Some(level) = self.texels.level_mut(face, level) {
                let context = StoreContext { isa: attached.isa, thread_pool };
                attached.surface.store_changed(level, slices, context);
            }
            attached.drawn = false;
        }
    }

    /// Texels that are gathered from the tiles of the attachment; `None` where the rows are up to date, or such lookups
    /// do not pay.
    fn texels_of_tiles(&self, isa: Isa) -> Option<Texels> {
        let attached = self.attached.as_ref().filter(|attached| attached.drawn)?;
        let base = Subresource { face: 0, slice: 0, level: 0 };
        let has_more = self.texels.level(0, 1).is_some();
        if self.texels.shape() != Shape::D2 || attached.at != base || has_more {
            return None;
        }
        let mut texels = Texels::new(Shape::D2);
        texels.set_level(0, 0, attached.surface.level_of_tiles(isa)?).ok()?;
        Some(texels)
    }

    /// The surface of what an attachment names: a copy of it, or made from its rows.
    fn surface(&mut self, at: Subresource) -> Option<Surface> {
        if let Some(attached) = self.attached.as_ref().filter(|attached| attached.at == at) {
            return Some(attached.surface.clone());
        }
        self.resolve(&ThreadPool::CALLER_ONLY);
        let level = self.texels.level(at.face, at.level)?;
        Some(Surface::from_level(level, self.slices(at), self.samples, &ThreadPool::CALLER_ONLY))
    }
}

impl Image {
    /// An image with these texels.
    pub fn new(texels: Texels) -> Self {
        Self::with_samples(texels, 1)
    }

    /// An image of one level with several samples a pixel, each with these texels: as many as
    /// [`possible_samples`] says.
    pub fn with_samples(texels: Texels, samples: u8) -> Self {
        let (samples, storage) = (possible_samples(samples), MultisampleStorage::Resolved);
        Self::of(State { texels, blank: None, samples, storage, attached: None })
    }

    /// A two-dimensional image of one level of zeros, which takes no memory until it is drawn to or its
    /// texels are asked for; samples as of [`Image::with_samples`].
    ///
    /// # Errors
    /// When it is too large.
    pub fn blank(format: Format, width: u32, height: u32, samples: u8) -> Result<Self, ImageError> {
        if Level::required_bytes(format, width, height, 1).is_none() {
            return Err(ImageError::TooLarge { width, height, depth: 1 });
        }
        let (texels, blank) = (Texels::new(Shape::D2), Some(Blank { format, width, height }));
        let (samples, storage) = (possible_samples(samples), MultisampleStorage::Resolved);
        Ok(Self::of(State { texels, blank, samples, storage, attached: None }))
    }

    fn of(state: State) -> Self {
        Self(Arc::new(Mutex::new(state)))
    }

    /// How many samples a pixel has; 1 if it is no multisample image.
    pub fn samples(&self) -> u8 {
        self.0.lock().samples
    }

    /// Its texels as they are after everything submitted so far. Shares them: later writes to the
    /// image copy. Of a multisample image, as its [`MultisampleStorage`] says.
    pub fn texels(&self) -> Texels {
        self.texels_with(&ThreadPool::CALLER_ONLY)
    }

    /// As [`Image::texels`], brought up to date by these ([`super::Device::texels`]).
    pub(super) fn texels_with(&self, thread_pool: &ThreadPool) -> Texels {
        let _float_env = FloatEnv::enter();
        let mut state = self.0.lock();
        state.resolve(thread_pool);
        state.texels.clone()
    }

    /// [`Image::texels`] for lookups that compare depths: of an image of one level that was drawn to, they may be gathered
    /// from the tiles of the attachment.
    pub(super) fn compared_texels_with(&self, isa: Isa, thread_pool: &ThreadPool) -> Texels {
        if let Some(texels) = self.0.lock().texels_of_tiles(isa) {
            return texels;
        }
        self.texels_with(thread_pool)
    }

    /// Whether it can be sampled with a sampler, and from which levels.
    ///
    /// # Errors
    /// Why it cannot.
    pub fn completeness(&self, sampler: &Sampler) -> Result<Levels, Incomplete> {
        let mut state = self.0.lock();
        if state.blank.is_some() {
            state.resolve(&ThreadPool::CALLER_ONLY);
        }
        state.texels.completeness(sampler)
    }

    /// Whether texels of [`super::Device::compared_texels`] read the tiles, which a pass that draws to the image would
    /// copy.
    pub fn has_readers_of_tiles(&self) -> bool {
        let state = self.0.lock();
        state.attached.as_ref().is_some_and(|attached| attached.surface.has_readers())
    }

    /// What is known of a level without looking at its texels, if it exists.
    pub fn level(&self, face: usize, level: usize) -> Option<LevelInfo> {
        self.0.lock().info(Subresource { face, slice: 0, level })
    }

    /// Changes its texels. Draws that were recorded earlier keep what they saw.
    pub fn update<R>(&self, change: impl FnOnce(&mut Texels) -> R) -> R {
        let _float_env = FloatEnv::enter();
        let mut state = self.0.lock();
        state.resolve(&ThreadPool::CALLER_ONLY);
        state.attached = None;
        change(&mut state.texels)
    }

    /// Replaces its texels; `storage` says what they are for this number of samples.
    pub fn replace(&self, texels: Texels, samples: u8, storage: MultisampleStorage) {
        let samples = possible_samples(samples);
        *self.0.lock() = State { texels, blank: None, samples, storage, attached: None };
    }

    /// What an attachment names with one sample a pixel, which several are resolved to: a level, and
    /// which slice of it ([`super::Device::resolved`]).
    pub(super) fn resolved_with(
        &self,
        face: u16,
        level: u8,
        context: StoreContext<'_>,
    ) -> Option<(Arc<Level>, usize)> {
        let mut state = self.0.lock();
        let at = state.subresource(face, level);
        if state.storage == MultisampleStorage::Resolved {
            state.resolve(context.thread_pool);
            return Some((Arc::clone(state.texels.level(at.face, at.level)?), at.slice));
        }
        let surface = state.surface(at)?;
        let mut level = Level::new(surface.format, surface.width, surface.height).ok()?;
        surface.store(&mut level, Slices::One(0), context);
        Some((Arc::new(level), 0))
    }

    /// Writes a region of what an attachment names into the rows of a client ([`super::Device::read`]). The rows of the
    /// image are not brought up to date.
    pub(super) fn read_with(
        &self,
        (face, level): (u16, u8),
        span: RowSpan,
        rows: &mut [&mut [u8]],
        writer: RowWriter<'_>,
        context: StoreContext<'_>,
    ) {
        let state = self.0.lock();
        let at = state.subresource(face, level);
        let drawn = state.attached.as_ref().filter(|attached| attached.drawn && attached.at == at);
        if let Some(Attached { surface, .. }) = drawn {
            return surface.read(span, rows, writer, context);
        }
        drop(state);
        let Some((level, slice)) = self.resolved_with(face, level, context) else { return };
        for (y, row) in (span.y as usize..).zip(rows) {
            writer.row(level.row_span([span.x as usize, y, slice], span.width as usize), row);
        }
    }

    /// The samples of what an attachment names, each a slice.
    pub fn each_sample(&self, face: u16, level: u8) -> Option<Level> {
        let _float_env = FloatEnv::enter();
        let mut state = self.0.lock();
        let at = state.subresource(face, level);
        let surface = state.surface(at)?;
        let size = [surface.width, surface.height, surface.samples.into()];
        let mut level = Level::with_size(surface.format, size, [0; 3]).ok()?;
        // Nothing is resolved.
        surface.store(
            &mut level,
            Slices::Each(0),
            StoreContext { isa: Isa::BASELINE, thread_pool: &ThreadPool::CALLER_ONLY },
        );
        Some(level)
    }

    /// Puts other samples in place of those of what an attachment names
    /// ([`super::Device::set_each_sample`]).
    pub(super) fn set_each_sample(&self, face: u16, level: u8, samples: &Level, isa: Isa) {
        let count = samples.depth.min(MAX_SAMPLES as u32) as u8;
        let mut surface =
            Surface::from_level(samples, Slices::Each(0), count, &ThreadPool::CALLER_ONLY);
        surface.change_all();
        let mut state = self.0.lock();
        let at = state.subresource(face, level);
        // What it replaces need not be brought to its rows.
        state.attached.take_if(|attached| attached.at == at);
        drop(state);
        self.detach(face, level, surface, isa);
    }

    /// Whether both handles name the same image.
    pub fn is_same_image(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// Format and size of what an attachment names, if it exists.
    pub(crate) fn attachment(&self, face: u16, level: u8) -> Option<AttachmentInfo> {
        let state = self.0.lock();
        let at = state.subresource(face, level);
        let LevelInfo { format, size: [width, height, slices], samples, .. } = state.info(at)?;
        (at.slice < slices as usize).then_some(AttachmentInfo { format, width, height, samples })
    }

    /// Takes a slice of a level out in the attachment layout; `None` if it does not exist.
    pub(crate) fn attach(&self, face: u16, level: u8, thread_pool: &ThreadPool) -> Option<Surface> {
        let mut state = self.0.lock();
        let at = state.subresource(face, level);
        if let Some(attached) = state.attached.take_if(|attached| attached.at == at) {
            return Some(attached.surface);
        }
        let (samples, slices) = (state.samples, state.slices(at));
        if let Some(Blank { format, width, height }) = state.blank {
            return state.info(at).map(|_| Surface::zeros(format, width, height, samples));
        }
        state.resolve(&ThreadPool::CALLER_ONLY);
        state.attached = None;
        let level = state.texels.level(at.face, at.level)?;
        Some(Surface::from_level(level, slices, samples, thread_pool))
    }

    /// Puts back what [`Image::attach`] took, drawn to by a device of this instruction set.
    pub(crate) fn detach(&self, face: u16, level: u8, surface: Surface, isa: Isa) {
        let mut state = self.0.lock();
        // Another level of the same image may have been drawn to in the same pass.
        if state.attached.is_some() {
            state.resolve(&ThreadPool::CALLER_ONLY);
        }
        let at = state.subresource(face, level);
        // Another context may have given the level another format or size meanwhile.
        let is_of = |info: LevelInfo| {
            let LevelInfo { format, size: [width, height, _], samples, .. } = info;
            (format, width, height, samples)
                == (surface.format, surface.width, surface.height, surface.samples)
        };
        if state.info(at).is_some_and(is_of) {
            state.attached = Some(Attached { at, surface, isa, drawn: true });
        }
    }
}

/// One slice of one level of an image, to be drawn to.
#[derive(Clone, Debug)]
pub struct Attachment {
    /// The image.
    pub image: Image,
    /// Which face of a cube, slice of a volume, or layer of an array (of cubes: which of all
    /// faces); else 0.
    pub face: u16,
    /// Which level; it must exist.
    pub level: u8,
}

impl Attachment {
    /// Pixels across and up, if it exists.
    pub fn size(&self) -> Option<[u32; 2]> {
        let info = self.image.attachment(self.face, self.level)?;
        Some([info.width, info.height])
    }

    /// Which face it names, if its image is of this shape, and which slice.
    pub fn face_and_slice(&self, shape: Shape) -> (usize, usize) {
        face_and_slice(shape, self.face)
    }
}

/// What a pass draws to. All attachments are at least `width` × `height` and have the same number
/// of samples.
#[derive(Clone, Debug)]
pub struct PassDesc {
    /// Colour attachments by index, of any format but depths, compressed ones and shared exponents.
    pub colors: Vec<Option<Attachment>>,
    /// Depth attachment: D16, D24, D32F, or D24S8, D32FS8, which are the stencil attachment too.
    pub depth: Option<Attachment>,
    /// Pixels across.
    pub width: u32,
    /// Pixels up.
    pub height: u32,
    /// How many layers there are: [`Attachment::face`] is the number of the first, which the others follow. Draws go to
    /// the first, but where a geometry program says another; clears go to all.
    pub layers: u16,
}

#[cfg(test)]
mod tests {
    use super::*;

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
