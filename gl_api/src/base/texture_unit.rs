//! Numbers of texture units from `GL_TEXTUREi`.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum};
use crate::base::types::*;
use crate::interface::MAX_TEXTURE_UNITS;

/// The number of the unit that `GL_TEXTUREi` names, which must be below `count`.
pub(crate) fn unit_below(section: &'static str, texture: GLenum, count: u8) -> Result<u8> {
    let refuse = |rule: String| invalid_enum(section, format!("texture = {rule}"));
    match texture.checked_sub(GL_TEXTURE0) {
        Some(unit) if unit < u32::from(count) => Ok(unit as u8),
        // Counted from there, as it was probably written: other values begin at GL_TEXTURE31 + 1.
        Some(unit @ ..256) => {
            refuse(format!("GL_TEXTURE0 + {unit} must be below GL_TEXTURE0 + {count}"))
        }
        Some(_) | None if texture < u32::from(count) => {
            refuse(format!("{texture} must be a name: GL_TEXTURE0 + {texture} is this unit's"))
        }
        Some(_) | None => {
            let last = count - 1;
            refuse(format!("{} must be GL_TEXTURE0 to GL_TEXTURE{last}", enum_name(texture)))
        }
    }
}

/// The set of texture coordinates that `GL_TEXTUREi` names.
pub(crate) fn texture_unit(section: &'static str, texture: GLenum) -> Result<u8> {
    unit_below(section, texture, MAX_TEXTURE_UNITS)
}
