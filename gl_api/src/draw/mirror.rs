//! When the mirror, client memory that has the default framebuffer's picture, gets a new one.

use crate::context::Context;
use crate::context::mirror::Copied;
use crate::context::sharing::CallScope;
use crate::draw::warnings::visibility;

impl Context {
    /// Copies the picture for the client; everything recorded has been carried out.
    pub(crate) fn show_mirror(&mut self) {
        if let Some(mut mirror) = self.mirror.take() {
            mirror.surface.update(self);
            mirror.copied = Copied::Yes;
            self.mirror = Some(mirror);
            visibility::picture(self);
        }
    }

    /// Submits everything and removes the mirror, as the context is current no more. A picture that the client has
    /// already is not copied again: it may have freed the memory.
    pub(crate) fn end_mirror(&mut self) {
        let scope = CallScope { context: self };
        crate::draw::pass::submit_unlocked(scope.context);
        drop(scope);
        if let Some(mirror) = self.mirror.take().filter(|mirror| mirror.copied == Copied::No) {
            mirror.surface.update(self);
        }
    }
}
