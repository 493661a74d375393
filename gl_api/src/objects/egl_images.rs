//! EGL images (EGL 1.5, section 3.9): images that textures and renderbuffers of several share groups have in common, by
//! handle.
//!
//! An image is made from a level of a texture or from a renderbuffer, its *source*; `glEGLImageTargetTexture2DOES` makes
//! it the storage of others, its *targets*. All of them are its *siblings*. One that is specified anew gets storage of
//! its own, and is a sibling no more.

use crate::base::types::*;
use parking_lot::Mutex;
use rasterizer::driver::Image;
use std::collections::BTreeMap;
use std::sync::{Arc, Weak};

/// An EGL image. It lives as long as its handle or a target.
#[derive(Debug)]
pub(crate) struct EglImage {
    /// A view of what the source has. Nothing gives this handle other storage.
    pub image: Image,
    /// The internal format of the source.
    pub internal: GLenum,
}

/// A slice of a level of a source; all 0 of a renderbuffer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct SourceLevel {
    pub face: usize,
    pub level: usize,
    pub slice: usize,
}

/// Which levels of an object a call specifies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Specified {
    All,
    One { face: usize, level: usize },
}

impl Specified {
    fn has(self, source: SourceLevel) -> bool {
        match self {
            Self::All => true,
            Self::One { face, level } => (face, level) == (source.face, source.level),
        }
    }
}

/// The EGL images that an object is a sibling of.
#[derive(Clone, Debug, Default)]
pub(crate) struct Siblings {
    /// That of which it is a target.
    shown: Option<Arc<EglImage>>,
    /// Those that were made from it.
    made: Vec<(SourceLevel, Weak<EglImage>)>,
}

impl Siblings {
    /// Whether a level is a sibling of an image already, so that no other is made from it.
    pub fn has(&self, level: SourceLevel) -> bool {
        let is_alive = |image: &Weak<EglImage>| image.strong_count() > 0;
        self.shown.is_some() || self.made.iter().any(|(of, image)| *of == level && is_alive(image))
    }

    /// Notes an image that was made from a level.
    pub fn made(&mut self, level: SourceLevel, image: &Arc<EglImage>) {
        self.made.retain(|(_, image)| image.strong_count() > 0);
        self.made.push((level, Arc::downgrade(image)));
    }

    /// To be called before levels of the object with this storage are specified: it gets storage of its own, if an EGL
    /// image shows them.
    pub fn specify(&mut self, storage: &Image, levels: Specified) {
        self.made.retain(|(_, image)| image.strong_count() > 0);
        let is_shown = self.shown.is_some() || self.made.iter().any(|(of, _)| levels.has(*of));
        if is_shown {
            storage.separate();
            *self = Self::default();
        }
    }

    /// Makes the object with this storage a target.
    pub fn show(&mut self, storage: &Image, image: Arc<EglImage>) {
        storage.share(&image.image);
        *self = Self { shown: Some(image), made: Vec::new() };
    }
}

/// The images that have a handle.
#[derive(Debug)]
struct Handles {
    next: usize,
    images: BTreeMap<usize, Arc<EglImage>>,
}

/// No handle is used twice, and none is an address.
static HANDLES: Mutex<Handles> = Mutex::new(Handles { next: 0x18, images: BTreeMap::new() });

/// Gives an image a handle.
pub(crate) fn publish(image: Arc<EglImage>) -> usize {
    let mut handles = HANDLES.lock();
    let handle = handles.next;
    handles.next += 0x10;
    handles.images.insert(handle, image);
    handle
}

/// The image of a handle.
pub(crate) fn find(handle: usize) -> Option<Arc<EglImage>> {
    HANDLES.lock().images.get(&handle).cloned()
}

/// Takes a handle back. The image stays with its targets.
pub(crate) fn withdraw(handle: usize) {
    let gone = HANDLES.lock().images.remove(&handle);
    // Its memory is freed after the lock.
    drop(gone);
}
