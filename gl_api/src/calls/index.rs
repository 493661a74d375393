//! Colour index mode's state: kept and answered, without effect, as every framebuffer here has
//! colours of red, green, blue and alpha (GL 2.1, section 4.2.2).

use crate::base::constants::*;
use crate::base::error::Result;
use crate::base::query_value::{QueryValue, flag, float, int, symbol};
use crate::base::types::*;
use crate::context::Context;
use crate::interface::ATTRIB_INDEX;

pub(crate) fn index_mask(context: &mut Context, mask: GLuint) -> Result<()> {
    context.state.fragment.index_mask = mask;
    Ok(())
}

pub(crate) fn clear_index(context: &mut Context, c: GLfloat) -> Result<()> {
    context.state.clear.index = c;
    Ok(())
}

/// What `glGet` reads.
pub(crate) fn state_value(context: &Context, pname: GLenum) -> Option<Result<QueryValue>> {
    Some(match pname {
        GL_CURRENT_INDEX => float(context.state.current[usize::from(ATTRIB_INDEX)][0]),
        // Raster positions take it along (GL 2.1, table 6.5).
        GL_CURRENT_RASTER_INDEX => float(context.state.raster_position.index),
        GL_INDEX_WRITEMASK => symbol(context.state.fragment.index_mask),
        GL_INDEX_CLEAR_VALUE => float(context.state.clear.index),
        GL_INDEX_BITS => int(0),
        GL_INDEX_MODE => flag(false),
        _ => return None,
    })
}
