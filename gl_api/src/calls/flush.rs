//! `glFlush` and `glFinish`: GL 2.1, section 5.5; `glTextureBarrier`.

use crate::base::error::Result;
use crate::context::Context;
use crate::context::warnings::DrawWarning;
use crate::objects::name_table::Sweep;

pub(crate) fn flush(context: &mut Context) -> Result<()> {
    crate::draw::pass::submit_unlocked(context);
    // Another context may have been the last that held something.
    context.objects.shared.sweep(Sweep::Flushed);
    context.show_mirror();
    Ok(())
}

/// What was drawn can be looked up from the next draw on (`ARB_texture_barrier`, `NV_texture_barrier`).
pub(crate) fn texture_barrier(context: &mut Context) -> Result<()> {
    crate::draw::pass::submit(context);
    // Who calls this knows that a texture is drawn to and looked up.
    context.is_first_warning(DrawWarning::FeedbackLoop, 0);
    Ok(())
}

pub(crate) fn finish(context: &mut Context) -> Result<()> {
    flush(context)?;
    crate::draw::pass::end_of_frame(context);
    Ok(())
}
