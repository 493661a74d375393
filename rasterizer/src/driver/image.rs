//! Images: texels that can be sampled, and attachments that can be drawn to.
//!
//! An image has its texels in rows, to be sampled; while one of its levels is drawn to, that level
//! is in the attachment layout ([`crate::target`]). The transition back happens when somebody asks
//! for the texels, not when a pass ends, so that passes that follow each other do not pay for it.

use crate::target::Surface;
use parking_lot::Mutex;
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::Image as Texels;

/// An image of the driver. Cloning gives another handle to the same image.
#[derive(Clone, Debug)]
pub struct Image(Arc<Mutex<State>>);

#[derive(Debug)]
struct State {
    texels: Texels,
    attached: Option<Attached>,
}

#[derive(Debug)]
struct Attached {
    face: u8,
    level: u8,
    surface: Surface,
    /// Whether the rows of the level are older than the surface.
    drawn: bool,
}

impl State {
    /// Brings the rows up to date.
    fn resolve(&mut self) {
        if let Some(attached) = self.attached.as_mut().filter(|attached| attached.drawn) {
            if let Some(level) = self.texels.level_mut(attached.face.into(), attached.level.into())
            {
                attached.surface.store(level);
            }
            attached.drawn = false;
        }
    }
}

impl Image {
    /// An image with these texels.
    pub fn new(texels: Texels) -> Self {
        Self(Arc::new(Mutex::new(State { texels, attached: None })))
    }

    /// Its texels as they are after everything submitted so far. Shares them: later writes to the
    /// image copy.
    pub fn texels(&self) -> Texels {
        let mut state = self.0.lock();
        state.resolve();
        state.texels.clone()
    }

    /// Changes its texels. Draws that were recorded earlier keep what they saw.
    pub fn update<R>(&self, change: impl FnOnce(&mut Texels) -> R) -> R {
        let mut state = self.0.lock();
        state.resolve();
        state.attached = None;
        change(&mut state.texels)
    }

    /// Whether both handles name the same image.
    pub fn same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// Format, width and height of a level, if it exists.
    pub(crate) fn extent(&self, face: u8, level: u8) -> Option<(Format, u32, u32)> {
        let state = self.0.lock();
        let level = state.texels.level(face.into(), level.into())?;
        Some((level.format, level.width, level.height))
    }

    /// Takes a level out in the attachment layout; `None` if it does not exist.
    pub(crate) fn attach(&self, face: u8, level: u8) -> Option<Surface> {
        let mut state = self.0.lock();
        if let Some(attached) = state.attached.take_if(|a| (a.face, a.level) == (face, level)) {
            return Some(attached.surface);
        }
        state.resolve();
        state.attached = None;
        state.texels.level(face.into(), level.into()).map(|level| Surface::from_level(level))
    }

    /// Puts back what [`Image::attach`] took, drawn to.
    pub(crate) fn detach(&self, face: u8, level: u8, surface: Surface) {
        let mut state = self.0.lock();
        // Another level of the same image may have been drawn to in the same pass.
        state.resolve();
        state.attached = Some(Attached { face, level, surface, drawn: true });
    }
}

/// One face of one level of an image, to be drawn to.
#[derive(Clone, Debug)]
pub struct Attachment {
    /// The image.
    pub image: Image,
    /// 0 for a 2D image, 0 to 5 for a cube.
    pub face: u8,
    /// Which level; it must exist.
    pub level: u8,
}

/// What a pass draws to. All attachments are at least `width` × `height`.
#[derive(Clone, Debug)]
pub struct PassDesc {
    /// Colour attachments by index; formats Rgba8, Rgb8, R8, L8 … (every 8-bit colour format).
    pub colors: Vec<Option<Attachment>>,
    /// Depth attachment: D16, D24 or D32F.
    pub depth: Option<Attachment>,
    /// Pixels across.
    pub width: u32,
    /// Pixels up.
    pub height: u32,
}
