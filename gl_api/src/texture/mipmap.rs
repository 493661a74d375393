//! Making mipmaps: `glGenerateMipmap` (`EXT_framebuffer_object`, section 3.8.8) and
//! `GL_GENERATE_MIPMAP` (GL 2.1, section 3.8.8).

use super::{TARGET, Texture, TextureTarget, bound, bound_mut};
use crate::constants::*;
use crate::context::{Context, limits};
use crate::error::{Result, invalid_enum, invalid_operation};
use crate::types::*;

const SECTION: &str = "EXT_framebuffer_object, section 3.8.8";

/// Makes the levels above the base from it.
fn generate(texture: &mut Texture) -> Result<()> {
    let (base, max) = (texture.state.sampler.base_level, texture.state.sampler.max_level);
    let max = max.min(limits::MAX_TEXTURE_LEVELS as u32 - 1);
    texture
        .image
        .update(|image| image.generate_mipmaps(base, max))
        .map_err(|error| super::storage_error(SECTION, &error))?;
    let base = base as usize;
    for levels in &mut texture.requested {
        if let Some(&format) = levels.get(base) {
            levels[base..].fill(format);
        }
    }
    texture.changed();
    Ok(())
}

/// With `GL_GENERATE_MIPMAP` set, a new base level brings new mipmaps.
pub(super) fn base_level_changed(texture: &mut Texture, level: usize) -> Result<()> {
    let base = texture.state.sampler.base_level as usize;
    let image = texture.image.texels();
    let whole = (0..image.shape().faces()).all(|face| image.level(face, base).is_some());
    if texture.generate_mipmap && level == base && whole { generate(texture) } else { Ok(()) }
}

pub(crate) fn generate_mipmap(context: &mut Context, target: GLenum) -> Result<()> {
    let target = TARGET.decode("target", target)?;
    if target == TextureTarget::Rect {
        return invalid_enum(SECTION, "target = GL_TEXTURE_RECTANGLE has no mipmaps");
    }
    let image = bound(context, target).image.clone();
    crate::draw::settle(context, &image);
    let texture = bound_mut(context, target);
    let base = texture.state.sampler.base_level as usize;
    let texels = texture.image.texels();
    let mut sizes = Vec::new();
    for face in 0..texels.shape().faces() {
        let Some(level) = texels.level(face, base) else {
            return invalid_operation(
                SECTION,
                format!(
                    "face {face} has no image at level {base}, {}",
                    enum_name(GL_TEXTURE_BASE_LEVEL)
                ),
            );
        };
        sizes.push((level.width, level.height, level.format));
    }
    if sizes.iter().any(|size| *size != sizes[0]) {
        return invalid_operation(SECTION, "the faces of the cube map differ in size or format");
    }
    generate(texture)
}
