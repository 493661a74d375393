//! What a context gives to those that share its objects, and the extent of a call.

use crate::context::Context;
use crate::objects::shared::ShareGroup;
use rasterizer::driver::Device;
use std::sync::Arc;

/// What a new context needs to share the objects of another.
#[derive(Clone, Debug)]
pub(crate) struct ShareHandle {
    pub group: ShareGroup,
    pub device: Arc<Device>,
}

/// A running call. Its end, also by a panic, releases the objects of the share group.
pub(crate) struct CallScope<'a> {
    pub context: &'a mut Context,
}

impl Drop for CallScope<'_> {
    #[inline]
    fn drop(&mut self) {
        self.context.objects.shared.release();
    }
}
