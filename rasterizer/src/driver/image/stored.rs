//! What an image has: storage, which views and other images may have too, and how its texels are reached.

use super::state::{Attached, Blank, State, Subresource, TypedSubresource, face_and_slice};
use super::view::{View, ViewDesc};
use super::{AttachmentInfo, LevelInfo, MultisampleStorage};
use crate::attachment::{RowSpan, RowWriter, Slices, StoreContext, Surface};
use crate::plan::possible_samples;
use crate::sizes::MAX_SAMPLES;
use crate::threads::ThreadPool;
use parking_lot::Mutex;
use std::borrow::Cow;
use std::num::NonZeroU64;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use texunit::format::Format;
use texunit::image::{Image as Texels, ImageError, Incomplete, Level, Levels, MAX_LEVELS, Shape};
use texunit::lanes::{FloatEnv, Isa};
use texunit::sampler::Sampler;

/// What an image has: storage, all of it or what a view shows.
#[derive(Clone, Debug)]
pub(super) struct Stored {
    storage: Arc<Storage>,
    view: Option<Arc<View>>,
}

/// What the handles of an image, and its views, have in common.
#[derive(Debug)]
struct Storage {
    state: Mutex<State>,
    /// Counts the changes of its texels since there are views of them; before, 0.
    version: AtomicU64,
}

impl Storage {
    fn version(&self) -> u64 {
        self.version.load(Ordering::Acquire)
    }

    /// Notes a change.
    fn changed(&self) {
        if self.version() != 0 {
            self.version.fetch_add(1, Ordering::AcqRel);
        }
    }
}

impl Stored {
    /// An image of one level with several samples a pixel, each with these texels: as many as
    /// [`possible_samples`] says.
    pub fn with_samples(texels: Texels, samples: u8) -> Self {
        let (samples, storage) = (possible_samples(samples), MultisampleStorage::Resolved);
        Self::of(State { texels, blank: None, samples, storage, attached: None })
    }

    /// A two-dimensional image of one level of zeros, which takes no memory until it is drawn to or its
    /// texels are asked for; samples as of [`Stored::with_samples`].
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
        let storage = Storage { state: Mutex::new(state), version: AtomicU64::new(0) };
        Self { storage: Arc::new(storage), view: None }
    }

    /// An image that shows texels of this one: it shares them. Their levels have no border.
    pub fn view(&self, desc: ViewDesc) -> Self {
        let desc = match &self.view {
            Some(view) => view.narrowed(desc),
            None => desc,
        };
        self.storage.version.fetch_max(1, Ordering::AcqRel);
        Self { storage: Arc::clone(&self.storage), view: Some(Arc::new(View::new(desc))) }
    }

    /// Storage of its own with the same texels: those of one sample a pixel.
    pub fn separate(&self) -> Self {
        let _float_env = FloatEnv::enter();
        Self::with_samples(self.texels_with(&ThreadPool::CALLER_ONLY), 1)
    }

    /// Counts the changes of texels that views share; `None` where there are no views.
    pub fn shared_version(&self) -> Option<NonZeroU64> {
        NonZeroU64::new(self.storage.version())
    }

    /// Where a slice lies in what is stored, and what is known of its level, if it exists.
    fn find(&self, state: &State, at: Subresource) -> Option<(TypedSubresource, LevelInfo)> {
        match &self.view {
            Some(view) => {
                let stored = view.stored(state.texels.shape(), at)?;
                Some((stored, view.info(state.info(stored.at)?)))
            }
            None => {
                let info = state.info(at)?;
                Some((TypedSubresource { at, format: info.format }, info))
            }
        }
    }

    /// Where a slice lies in what is stored, if it exists.
    fn stored(&self, state: &State, at: Subresource) -> Option<TypedSubresource> {
        self.find(state, at).map(|(stored, _)| stored)
    }

    /// What an attachment's number names.
    fn named(&self, state: &State, number: u16, level: u8) -> Subresource {
        let shape = self.view.as_ref().map_or(state.texels.shape(), |view| view.desc.shape);
        let (face, slice) = face_and_slice(shape, number.into());
        Subresource { face, slice, level: level.into() }
    }

    /// What is known of a level.
    fn info(&self, state: &State, at: Subresource) -> Option<LevelInfo> {
        self.find(state, at).map(|(_, info)| info)
    }

    /// The texels, brought up to date; none where there is no memory for that.
    fn up_to_date<'a>(&self, state: &'a mut State, thread_pool: &ThreadPool) -> Cow<'a, Texels> {
        match state.resolve(thread_pool) {
            Ok(()) => self.rows(state),
            Err(_) => Cow::Owned(Texels::new(state.texels.shape())),
        }
    }

    /// The texels; the rows are up to date.
    fn rows<'a>(&self, state: &'a State) -> Cow<'a, Texels> {
        match &self.view {
            Some(view) => Cow::Owned(view.texels(state, self.storage.version())),
            None => Cow::Borrowed(&state.texels),
        }
    }

    /// How many samples a pixel has; 1 if it is no multisample image.
    pub fn samples(&self) -> u8 {
        self.storage.state.lock().samples
    }

    /// Its texels as they are after everything submitted so far, brought up to date by these threads.
    pub fn texels_with(&self, thread_pool: &ThreadPool) -> Texels {
        let _float_env = FloatEnv::enter();
        let mut state = self.storage.state.lock();
        self.up_to_date(&mut state, thread_pool).into_owned()
    }

    /// As [`Stored::texels_with`], for lookups that compare depths: of an image of one level that was drawn to, they may be gathered
    /// from the tiles of the attachment.
    pub fn compared_texels_with(&self, isa: Isa, thread_pool: &ThreadPool) -> Texels {
        if self.view.is_none()
            && let Some(texels) = self.storage.state.lock().texels_of_tiles(isa)
        {
            return texels;
        }
        self.texels_with(thread_pool)
    }

    /// Whether it can be sampled with a sampler, and from which levels.
    ///
    /// # Errors
    /// Why it cannot.
    pub fn completeness(&self, sampler: &Sampler) -> Result<Levels, Incomplete> {
        let mut state = self.storage.state.lock();
        if self.view.is_some() || state.blank.is_some() {
            return self.up_to_date(&mut state, &ThreadPool::CALLER_ONLY).completeness(sampler);
        }
        self.rows(&state).completeness(sampler)
    }

    /// Whether texels of [`crate::driver::Device::compared_texels`] read the tiles, which a pass that draws to the image would
    /// copy.
    pub fn has_readers_of_tiles(&self) -> bool {
        let state = self.storage.state.lock();
        state.attached.as_ref().is_some_and(|attached| attached.surface.has_readers())
    }

    /// What is known of a level without looking at its texels, if it exists.
    pub fn level(&self, face: usize, level: usize) -> Option<LevelInfo> {
        self.info(&self.storage.state.lock(), Subresource { face, slice: 0, level })
    }

    /// Whether all texels are those that it was made with, without data: nothing was drawn to them, and nothing written.
    /// A face that was drawn as it was, all zeros, cannot be told from one that was not: one level that differs is enough.
    pub fn is_untouched(&self) -> bool {
        let state = self.storage.state.lock();
        let faces = 0..state.texels.shape().faces();
        let mut levels = faces.flat_map(|face| {
            let level = |level: usize| state.texels.level(face, level);
            (0..MAX_LEVELS)
                .filter_map(level)
                .map(|level| level.texels.is_blank())
                .collect::<Vec<_>>()
        });
        state.attached.is_none() && (state.blank.is_some() || levels.all(|is_blank| is_blank))
    }

    /// Changes its texels. Draws that were recorded earlier keep what they saw.
    pub fn update<R>(&self, change: impl FnOnce(&mut Texels) -> R) -> R {
        let _float_env = FloatEnv::enter();
        let mut state = self.storage.state.lock();
        if state.resolve(&ThreadPool::CALLER_ONLY).is_err() {
            // A level that has no memory is not there.
            state.blank = None;
        }
        state.attached = None;
        let result = match &self.view {
            Some(view) => view.update(&mut state, self.storage.version(), change),
            None => change(&mut state.texels),
        };
        self.storage.changed();
        result
    }

    /// Takes the memory that an [`Stored::update`] of this level needs, which writes to it by
    /// [`Texels::level_mut`].
    ///
    /// # Errors
    /// If there is none; nothing has changed then.
    pub fn prepare_update(&self, face: u16, level: u8) -> Result<(), ImageError> {
        let _float_env = FloatEnv::enter();
        let mut state = self.storage.state.lock();
        state.resolve(&ThreadPool::CALLER_ONLY)?;
        let Subresource { face, level, .. } = self.named(&state, face, level);
        match &self.view {
            Some(view) => view.prepare_update(&mut state, self.storage.version(), [face, level]),
            None => state.texels.unshare(face, level),
        }
    }

    /// Replaces its texels; `storage` says what they are for this number of samples.
    pub fn replace(&self, texels: Texels, samples: u8, storage: MultisampleStorage) {
        let samples = possible_samples(samples);
        let mut state = self.storage.state.lock();
        *state = State { texels, blank: None, samples, storage, attached: None };
        self.storage.changed();
    }

    /// What an attachment names with one sample a pixel, which several are resolved to: a level, and
    /// which slice of it ([`crate::driver::Device::resolved`]).
    ///
    /// # Errors
    /// If it does not exist, or there is no memory for it.
    pub fn resolved_with(
        &self,
        face: u16,
        level: u8,
        context: StoreContext<'_>,
    ) -> Result<(Arc<Level>, usize), ImageError> {
        let mut state = self.storage.state.lock();
        let at = self.named(&state, face, level);
        if state.storage == MultisampleStorage::Resolved {
            state.resolve(context.thread_pool)?;
            let rows = self.rows(&state);
            let level = rows.level(at.face, at.level).ok_or_else(|| at.missing())?;
            return Ok((Arc::clone(level), at.slice));
        }
        let surface = self.surface(&mut state, at)?;
        let mut level = Level::new(surface.format, surface.width, surface.height)?;
        surface.store(&mut level, Slices::One(0), context);
        Ok((Arc::new(level), 0))
    }

    /// Writes a region of what an attachment names into the rows of a client ([`crate::driver::Device::read`]). The rows of the
    /// image are not brought up to date.
    pub fn read_with(
        &self,
        (face, level): (u16, u8),
        span: RowSpan,
        rows: &mut [&mut [u8]],
        writer: RowWriter<'_>,
        context: StoreContext<'_>,
    ) {
        let state = self.storage.state.lock();
        let stored = self.stored(&state, self.named(&state, face, level));
        let is_drawn = |of: &&Attached| of.drawn && stored.is_some_and(|stored| stored.is_of(of));
        let drawn = state.attached.as_ref().filter(is_drawn);
        if let Some(Attached { surface, .. }) = drawn {
            return surface.read(span, rows, writer, context);
        }
        drop(state);
        let Ok((level, slice)) = self.resolved_with(face, level, context) else { return };
        for (y, row) in (span.y as usize..).zip(rows) {
            writer.row(level.row_span([span.x as usize, y, slice], span.width as usize), row);
        }
    }

    /// The surface of a slice: a copy of it, or made from its rows.
    fn surface(&self, state: &mut State, at: Subresource) -> Result<Surface, ImageError> {
        let stored = self.stored(state, at).ok_or_else(|| at.missing())?;
        state.surface(stored)?.ok_or_else(|| at.missing())
    }

    /// The samples of what an attachment names, each a slice.
    ///
    /// # Errors
    /// If it does not exist, or there is no memory for them.
    pub fn each_sample(&self, face: u16, level: u8) -> Result<Level, ImageError> {
        let _float_env = FloatEnv::enter();
        let mut state = self.storage.state.lock();
        let at = self.named(&state, face, level);
        let surface = self.surface(&mut state, at)?;
        let size = [surface.width, surface.height, surface.samples.into()];
        let mut level = Level::with_size(surface.format, size, [0; 3])?;
        // Nothing is resolved.
        surface.store(
            &mut level,
            Slices::Each(0),
            StoreContext { isa: Isa::BASELINE, thread_pool: &ThreadPool::CALLER_ONLY },
        );
        Ok(level)
    }

    /// Puts other samples in place of those of what an attachment names
    /// ([`crate::driver::Device::set_each_sample`]).
    pub fn set_each_sample(&self, face: u16, level: u8, samples: &Level, isa: Isa) {
        let count = samples.depth.min(MAX_SAMPLES as u32) as u8;
        let mut surface =
            Surface::from_level(samples, Slices::Each(0), count, &ThreadPool::CALLER_ONLY);
        surface.change_all();
        let mut state = self.storage.state.lock();
        let stored = self.stored(&state, self.named(&state, face, level));
        // What it replaces need not be brought to its rows.
        state.attached.take_if(|attached| stored.is_some_and(|stored| stored.at == attached.at));
        drop(state);
        self.detach(face, level, surface, isa);
    }

    /// Whether they are the same image, or views of the same image.
    pub fn shares_texels(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.storage, &other.storage)
    }

    /// Format and size of what an attachment names, if it exists.
    pub fn attachment(&self, face: u16, level: u8) -> Option<AttachmentInfo> {
        let state = self.storage.state.lock();
        let at = self.named(&state, face, level);
        let info = self.info(&state, at)?;
        let LevelInfo { format, size: [width, height, slices], samples, .. } = info;
        (at.slice < slices as usize).then_some(AttachmentInfo { format, width, height, samples })
    }

    /// Takes a slice of a level out in the attachment layout; `None` if it does not exist.
    pub fn attach(&self, face: u16, level: u8, thread_pool: &ThreadPool) -> Option<Surface> {
        let mut state = self.storage.state.lock();
        let stored = self.stored(&state, self.named(&state, face, level))?;
        if let Some(attached) = state.attached.take_if(|attached| stored.is_of(attached)) {
            return Some(attached.surface);
        }
        if let Some(Blank { width, height, .. }) = state.blank {
            return Some(Surface::zeros(stored.format, width, height, state.samples));
        }
        state.resolve(&ThreadPool::CALLER_ONLY).ok()?;
        state.attached = None;
        state.loaded(stored, thread_pool)
    }

    /// Puts back what [`Stored::attach`] took, drawn to by a device of this instruction set.
    pub fn detach(&self, face: u16, level: u8, surface: Surface, isa: Isa) {
        let mut state = self.storage.state.lock();
        // Another level of the same image may have been drawn to in the same pass. What is drawn last is kept where there
        // is no memory for both.
        if state.attached.is_some() {
            let _ = state.resolve(&ThreadPool::CALLER_ONLY);
        }
        let at = self.named(&state, face, level);
        // Another context may have given the level another format or size meanwhile.
        let is_of = |(_, info): &(_, LevelInfo)| {
            let LevelInfo { format, size: [width, height, _], samples, .. } = *info;
            (format, width, height, samples)
                == (surface.format, surface.width, surface.height, surface.samples)
        };
        if let Some((stored, _)) = self.find(&state, at).filter(is_of) {
            state.attached = Some(Attached { at: stored.at, surface, isa, drawn: true });
            self.storage.changed();
        }
    }
}
