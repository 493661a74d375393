//! Making mipmaps: `glGenerateMipmap` (`EXT_framebuffer_object`, section 3.8.8) and
//! `GL_GENERATE_MIPMAP` (GL 2.1, section 3.8.8).

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum, invalid_operation};
use crate::base::limits;
use crate::base::types::*;
use crate::calls::texture::bound::{ChosenTexture, bindable};
use crate::context::Context;
use crate::objects::egl_images::Specified;
use crate::objects::target::TextureTarget;
use crate::objects::texture::Texture;
use crate::pixel::es_texels;
use texunit::image::ImageError;
use texunit::lanes::Isa;
use texunit::sampler::Sampler;

const SECTION: &str = "EXT_framebuffer_object, section 3.8.8";

/// The faces whose levels are made.
#[derive(Clone, Copy)]
enum Faces {
    All,
    One(usize),
}

/// Makes the levels above the base from it.
fn generate(isa: Isa, texture: &mut Texture, faces: Faces) -> Result<()> {
    let Sampler { base_level: base, max_level: max, .. } = texture.sampler();
    let max = max.min(limits::MAX_TEXTURE_LEVELS as u32 - 1);
    if !has_all_levels(texture, base as usize, max as usize) {
        texture.specify(Specified::All);
    }
    let made = texture.image.update(|image| match faces {
        Faces::All => image.generate_mipmaps(isa, base, max),
        Faces::One(face) => image.generate_face_mipmaps(isa, face, base, max),
    });
    made.map_err(|error| crate::pixel::storage_error::storage_error(SECTION, &error))?;
    let base = base as usize;
    for (face, levels) in texture.requested.iter_mut().enumerate() {
        let made = match faces {
            Faces::All => true,
            Faces::One(one) => one == face,
        };
        if let (true, Some(&format)) = (made, levels.get(base)) {
            levels[base..].fill(format);
        }
    }
    texture.texels_changed();
    Ok(())
}

/// Whether the levels that are made exist already: then only their texels change (`EGL_KHR_gl_image`).
fn has_all_levels(texture: &Texture, base: usize, max: usize) -> bool {
    let shape = texture.target.shape();
    (0..shape.faces()).all(|face| {
        let Some(first) = texture.image.level(face, base) else { return false };
        let largest = first.size[..shape.axes()].iter().fold(1, |most, side| most.max(*side));
        let last = max.min(base + largest.ilog2() as usize);
        let mut size = first.size;
        (base..=last).all(|level| {
            let found = texture.image.level(face, level);
            let is_there =
                found.is_some_and(|info| (info.size, info.format) == (size, first.format));
            size = shape.halved(size);
            is_there
        })
    })
}

/// With `GL_GENERATE_MIPMAP` set, a new base level of a face brings new mipmaps, if its texels
/// have any.
pub(crate) fn base_level_changed(
    isa: Isa,
    texture: &mut Texture,
    face: usize,
    level: usize,
) -> Result<()> {
    let base = texture.sampler().base_level as usize;
    let image = texture.image.texels();
    let has_mean = image.level(face, level).is_some_and(|level| level.format.has_mean());
    if texture.generate_mipmap && level == base && has_mean {
        generate(isa, texture, Faces::One(face))
    } else {
        Ok(())
    }
}

pub(crate) fn generate_mipmap(context: &mut Context, target: GLenum) -> Result<()> {
    let texture = ChosenTexture::bound(context, mipmapped(context, target)?);
    generate_all(context, &texture)
}

/// Makes the levels of a texture from its base level.
pub(crate) fn generate_all(context: &mut Context, texture: &ChosenTexture) -> Result<()> {
    if texture.target.levels() == 1 {
        return texture.wrong_target(SECTION, "has no mipmaps");
    }
    let is_es = context.profile.is_es();
    let image = texture.get(context).image.clone();
    crate::draw::pass::submit_draws_to(context, &image);
    let isa = context.recorder.isa();
    let texture = texture.get_mut(context);
    let base = texture.sampler().base_level as usize;
    let texels = texture.image.texels();
    if is_es
        && !es_texels::has_mipmaps(texture.requested[0][base.min(limits::MAX_TEXTURE_LEVELS - 1)])
    {
        let internal = enum_name(texture.requested[0][base.min(limits::MAX_TEXTURE_LEVELS - 1)]);
        return invalid_operation(
            "OpenGL ES 3.0, section 3.8.10.5",
            format!(
                "the base level is of {internal}: mipmaps are made of unsized formats, and of those that are drawn \
                 to and filtered"
            ),
        );
    }
    let mut kinds = Vec::new();
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
        if !level.format.has_mean() {
            let error = ImageError::NoMean { format: level.format };
            return Err(crate::pixel::storage_error::storage_error(SECTION, &error));
        }
        kinds.push((level.size(), level.border, level.format));
    }
    if kinds.iter().any(|kind| *kind != kinds[0]) {
        return invalid_operation(SECTION, "the faces of the cube map differ in size or format");
    }
    generate(isa, texture, Faces::All)
}

/// A target whose textures have several levels.
fn mipmapped(context: &Context, target: GLenum) -> Result<TextureTarget> {
    match bindable(context.profile).decode("target", target)? {
        TextureTarget::External => invalid_enum(
            "OES_EGL_image_external, section 3.7.1",
            "target = GL_TEXTURE_EXTERNAL_OES, whose textures have one level",
        ),
        target => Ok(target),
    }
}
