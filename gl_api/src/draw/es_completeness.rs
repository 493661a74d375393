//! What OpenGL ES asks of attached images besides (3.0, sections 4.4.4 and 4.4.4.1).

use crate::base::constants::*;
use crate::context::Context;
use crate::draw::completeness::{Aspect, attached_format};
use crate::objects::framebuffers::{Attached, Source};
use crate::objects::target::TextureTarget;
use crate::objects::texture::Texture;
use crate::pixel::es_texels;
use crate::pixel::formats::format_name;
use texunit::image::Shape;

/// Why an image cannot be at a point, if so.
pub(crate) fn unsuitable(context: &Context, attached: &Attached, aspect: Aspect) -> Option<String> {
    let Source::Texture { name, target, level, .. } = attached.source else { return None };
    let texture = context.objects.shared.textures.get(name)?;
    if !texture.image.is_same_image(&attached.image) {
        return None;
    }
    if aspect == Aspect::Color {
        let internal = *texture.requested.get(usize::from(target.face))?.get(level)?;
        let stored = attached_format(attached)?;
        if !es_texels::is_drawn_to(internal, stored) {
            let [internal, stored] = [enum_name(internal), format_name(stored)];
            return Some(format!(
                "OpenGL ES draws nothing to images of {internal} that are stored as {stored} (3.0, table 3.13)"
            ));
        }
    }
    level_out_of_pyramid(texture, level)
        .map(|reason| format!("texture {name}, level {level}: {reason}"))
}

/// Why a level is none of the levels that are sampled, or why those do not fit each other; of immutable storage, all do.
fn level_out_of_pyramid(texture: &Texture, level: usize) -> Option<String> {
    let sampler = &texture.state.sampler;
    let base = sampler.base_level as usize;
    if texture.immutable.is_some() || level == base {
        return None;
    }
    let shape = texture.target.shape();
    let first = texture.image.level(0, base);
    let largest: u32 = first
        .map_or(0, |info| info.size[..shape.axes()].iter().fold(0, |most, side| most.max(*side)));
    let smallest = base + largest.checked_ilog2().unwrap_or(0) as usize;
    let last = smallest.min(sampler.max_level as usize);
    if !(base..=last).contains(&level) {
        return Some(format!(
            "it must be one of levels {base} (GL_TEXTURE_BASE_LEVEL) to {last} that are sampled \
             (OpenGL ES 3.0, section 4.4.4.1)"
        ));
    }
    let faces = if texture.target == TextureTarget::Cube { 6 } else { 1 };
    (0..faces).find_map(|face| missing_level(texture, shape, face, base..=last))
}

/// The first level of a face that does not follow from the base level.
fn missing_level(
    texture: &Texture,
    shape: Shape,
    face: usize,
    levels: std::ops::RangeInclusive<usize>,
) -> Option<String> {
    let first = texture.image.level(0, *levels.start())?;
    let mut expected = first.size;
    levels.into_iter().find_map(|level| {
        let found = texture.image.level(face, level);
        let fits = found.is_some_and(|info| (info.format, info.size) == (first.format, expected));
        expected = shape.halved(expected);
        (!fits).then(|| {
            format!(
                "level {level} is missing or does not fit the base level, so the texture is not \
                 mipmap complete (OpenGL ES 3.0, section 4.4.4.1)"
            )
        })
    })
}
