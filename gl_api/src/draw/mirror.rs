//! When the client's memory that shows the default framebuffer gets a new picture.

use crate::context::Context;
use crate::context::mirror::Copied;
use crate::context::sharing::Turn;
use crate::draw::hints::sight;

impl Context {
    /// Copies the picture for the client; everything recorded has been carried out.
    pub(crate) fn show_mirror(&mut self) {
        if let Some(mut mirror) = self.mirror.take() {
            mirror.surface.update(self);
            mirror.copied = Copied::Yes;
            self.mirror = Some(mirror);
            sight::picture(self);
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
