//! Client memory that shows the default framebuffer: it has the picture after `glFlush` and `glFinish`.

use super::Context;
use crate::context::sharing::Turn;
use crate::draw::hints::sight;
use std::fmt::Debug;

/// Memory that is a copy of the default framebuffer.
pub trait SurfaceMirror: Debug + Send + Sync {
    /// Copies the picture; everything recorded has been carried out.
    fn update(&self, context: &Context);
}

/// Whether a mirror has the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Copied {
    /// It has the last one.
    Yes,
    /// There may be a newer one.
    No,
}

/// The mirror of a context.
#[derive(Debug)]
pub(crate) struct Mirror {
    surface: Box<dyn SurfaceMirror>,
    copied: Copied,
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

    /// Copies the picture for the client; everything recorded has been carried out.
    pub(crate) fn show_mirror(&mut self) {
        if let Some(mut mirror) = self.mirror.take() {
            mirror.surface.update(self);
            mirror.copied = Copied::Yes;
            self.mirror = Some(mirror);
            sight::picture(self);
        }
    }

    /// Takes note that the client's memory has another picture than was just drawn.
    pub(crate) fn outdate_mirror(&mut self) {
        if let Some(mirror) = &mut self.mirror {
            mirror.copied = Copied::No;
        }
    }

    /// Draws everything and forgets the client's memory, as it is current no more. What the client has seen already is
    /// not copied again: it may have freed memory that it is done with.
    pub(crate) fn end_mirror(&mut self) {
        let turn = Turn::begin(self);
        crate::draw::submit(turn.context);
        drop(turn);
        if let Some(mirror) = self.mirror.take().filter(|mirror| mirror.copied == Copied::No) {
            mirror.surface.update(self);
        }
    }
}
