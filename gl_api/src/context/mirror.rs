//! Client memory that shows the default framebuffer: it has the picture after `glFlush` and `glFinish`.

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
    /// Shows the default framebuffer in a client's memory from the next picture on, or no longer.
    pub(crate) fn set_mirror(&mut self, surface: Option<Box<dyn SurfaceMirror>>) {
        self.mirror = surface.map(|surface| Mirror { surface, copied: Copied::Yes });
    }

    /// Has the mirror take the next copy in another way, if there is a mirror.
    pub(crate) fn replace_mirror(&mut self, surface: Box<dyn SurfaceMirror>) {
        if let Some(mirror) = &mut self.mirror {
            mirror.surface = surface;
        }
    }

    /// Takes note that the client's memory has another picture than was just drawn.
    pub(crate) fn outdate_mirror(&mut self) {
        if let Some(mirror) = &mut self.mirror {
            mirror.copied = Copied::No;
        }
    }
}
