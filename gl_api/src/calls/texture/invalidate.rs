//! `glInvalidateTexImage` and `glInvalidateTexSubImage` (`ARB_invalidate_subdata`, section 3.9.X): texels that may be
//! forgotten. They are kept, so that what is read of them is the same on every machine.

use crate::base::error::{Result, invalid_value};
use crate::base::types::*;
use crate::calls::texture::stored_level::check_box;
use crate::context::Context;
use crate::objects::target::{TextureTarget, checked_level};

const SECTION: &str = "ARB_invalidate_subdata, section 3.9.X";

/// The target of a texture, and the level.
fn checked(context: &Context, texture: GLuint, level: GLint) -> Result<(TextureTarget, usize)> {
    match context.objects.shared.textures.get(texture).filter(|_| texture != 0) {
        Some(found) => Ok((found.target, checked_level(SECTION, found.target, level)?)),
        None => invalid_value(SECTION, format!("texture = {texture} is no texture")),
    }
}

pub(crate) fn invalidate_tex_image(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
) -> Result<()> {
    checked(context, texture, level).map(|_| ())
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn invalidate_tex_sub_image(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    zoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
) -> Result<()> {
    let (target, level) = checked(context, texture, level)?;
    let found = context.objects.shared.textures.get(texture);
    let info = found.and_then(|texture| texture.image.level(0, level));
    let (mut sides, border) = info.map_or(([0; 3], [0; 3]), |info| (info.size, info.border));
    if target == TextureTarget::Cube {
        sides[2] = 6;
    }
    let at = target.level_box([xoffset, yoffset, zoffset]);
    let size = target.level_box([width, height, depth]);
    check_box([at, size], sides, border).or_else(|rule| invalid_value(SECTION, rule))
}
