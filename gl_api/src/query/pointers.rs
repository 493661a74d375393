//! `glGetPointerv`.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::context::Context;
use crate::query::arrays;
use crate::record::render_mode as modes;

/// `glGetPointerv`: GL 2.1, section 6.1.11, and `KHR_debug`.
pub(crate) fn get_pointerv(
    context: &mut Context,
    pname: GLenum,
    params: &mut [*mut GLvoid],
) -> Result<()> {
    let address = match pname {
        GL_DEBUG_CALLBACK_FUNCTION => context.debug.log.procedure(),
        GL_DEBUG_CALLBACK_USER_PARAM => context.debug.log.user(),
        _ => match arrays::pointer(context, pname).or_else(|| modes::pointer(context, pname)) {
            Some(address) => address,
            None => {
                return invalid_enum(
                    "GL 2.1, section 6.1.11",
                    format!("pname = {} names no pointer", enum_name(pname)),
                );
            }
        },
    };
    put(params, &[address as *mut GLvoid])
}
