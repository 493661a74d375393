//! The mirror: client memory that has the default framebuffer's picture after `glFlush` and `glFinish`.

use super::Context;
use std::fmt::Debug;

/// Memory that is a copy of the default framebuffer.
pub trait SurfaceMirror: Debug + Send + Sync {
    /// Copies the picture; everything recorded has been carried out.
    fn update(&self, context: &Context);
}

/// Whether a mirror has the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Copied {
    /// It has the last one.
    Yes,
    /// There may be a newer one.
    No,
}

/// The mirror of a context.
#[derive(Debug)]
pub(crate) struct Mirror {
    pub surface: Box<dyn SurfaceMirror>,
    pub copied: Copied,
}

impl Context {
    /// Sets the mirror, which gets the next picture, or removes it.
    pub(crate) fn set_mirror(&mut self, surface: Option<Box<dyn SurfaceMirror>>) {
        self.mirror = surface.map(|surface| Mirror { surface, copied: Copied::Yes });
    }

    /// Replaces how the mirror copies, if there is a mirror.
    pub(crate) fn replace_mirror(&mut self, surface: Box<dyn SurfaceMirror>) {
        if let Some(mirror) = &mut self.mirror {
            mirror.surface = surface;
        }
    }

    /// Notes that a picture was drawn that the mirror does not have yet.
    pub(crate) fn outdate_mirror(&mut self) {
        if let Some(mirror) = &mut self.mirror {
            mirror.copied = Copied::No;
        }
    }
}
