//! `glIndexMask` and `glClearIndex`: kept and answered, without effect, as every framebuffer here has
//! colours of red, green, blue and alpha (GL 2.1, section 4.2.2).

use crate::base::error::Result;
use crate::base::types::*;
use crate::context::Context;

pub(crate) fn index_mask(context: &mut Context, mask: GLuint) -> Result<()> {
    context.state.fragment.index_mask = mask;
    Ok(())
}

pub(crate) fn clear_index(context: &mut Context, c: GLfloat) -> Result<()> {
    context.state.clear.index = c;
    Ok(())
}
