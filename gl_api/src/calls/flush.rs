//! `glFlush` and `glFinish`: GL 2.1, section 5.5; `glTextureBarrierNV`.

use crate::base::error::Result;
use crate::context::Context;
use crate::context::said::Hint;
use crate::objects::Sweep;

pub(crate) fn flush(context: &mut Context) -> Result<()> {
    crate::draw::submit(context);
    // Another context may have been the last that held something.
    context.objects.sweep(Sweep::Flushed);
    context.show_mirror();
    Ok(())
}

/// What was drawn can be looked up from the next draw on (`NV_texture_barrier`).
pub(crate) fn texture_barrier_nv(context: &mut Context) -> Result<()> {
    crate::draw::submit(context);
    // Who calls this knows that a texture is drawn to and looked up.
    context.is_news(Hint::FeedbackLoop, 0);
    Ok(())
}

pub(crate) fn finish(context: &mut Context) -> Result<()> {
    flush(context)
}
