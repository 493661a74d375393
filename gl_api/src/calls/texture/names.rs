//! The names, bindings and residence of textures, and the active unit: GL 2.1, sections 3.8.12 and 2.7.

use crate::base::constants::*;
use crate::base::convert::unit;
use crate::base::error::{Result, invalid_operation, invalid_value};
use crate::base::texture_unit::{texture_unit, unit_below};
use crate::base::types::*;
use crate::calls::framebuffer::attach::detach;
use crate::calls::texture::bound::bindable;
use crate::context::Context;
use crate::interface::MAX_COMBINED_TEXTURE_IMAGE_UNITS;
use crate::objects::bound::Bound;
use crate::objects::name_table::{Sweep, listed};
use crate::objects::target::TARGET;
use crate::objects::texture::Texture;

const SECTION: &str = "GL 2.1, section 3.8.12";

pub(crate) fn gen_textures(
    context: &mut Context,
    n: GLsizei,
    textures: &mut [GLuint],
) -> Result<()> {
    context.objects.shared.textures.reserve(SECTION, n, textures)
}

pub(crate) fn delete_textures(
    context: &mut Context,
    n: GLsizei,
    textures: &[GLuint],
) -> Result<()> {
    for &name in listed(SECTION, n, textures)?.iter().filter(|&&name| name != 0) {
        let gone = context.objects.shared.textures.hold(name);
        let units = &mut context.state.units;
        for at in 0..units.units.len() {
            if gone != Bound::default() && units.units[at].bound.contains(&gone) {
                units.unit_mut(at).bound.iter_mut().for_each(|bound| bound.forget(&gone));
            }
        }
        drop(gone);
        if let Some(image) =
            context.objects.shared.textures.get(name).map(|gone| gone.image.clone())
        {
            detach(context, &image);
        }
        context.objects.shared.textures.remove(name);
    }
    context.objects.shared.sweep(Sweep::Deleted);
    Ok(())
}

pub(crate) fn bind_texture(context: &mut Context, target: GLenum, texture: GLuint) -> Result<()> {
    let target = bindable(context.profile).decode("target", target)?;
    if context.profile.is_core() {
        context.objects.shared.textures.check_given("texture", texture, "glGenTextures")?;
    }
    if let Some(object) = context.objects.shared.textures.get(texture)
        && object.target != target
    {
        let (was, is) = (TARGET.encode(object.target), TARGET.encode(target));
        return invalid_operation(
            SECTION,
            format!(
                "texture {texture} was first bound to {}, it cannot be bound to {}",
                enum_name(was),
                enum_name(is)
            ),
        );
    }
    context.objects.shared.textures.create(texture, || {
        let mut texture = Texture::new(target);
        texture.state.sampler.depth_mode = context.profile.depth_mode();
        texture
    });
    let bound = context.objects.shared.textures.hold(texture);
    if context.state.units.active().bound[target as usize] == bound {
        context.state_changes.no_change();
        return Ok(());
    }
    context.leave_plain_state();
    context.state.units.active_mut().bound[target as usize] = bound;
    context.state_changes.bindings_only();
    Ok(())
}

pub(crate) fn is_texture(context: &mut Context, texture: GLuint) -> Result<bool> {
    Ok(context.objects.shared.textures.get(texture).is_some())
}

pub(crate) fn prioritize_textures(
    context: &mut Context,
    n: GLsizei,
    textures: &[GLuint],
    priorities: &[GLfloat],
) -> Result<()> {
    let n = listed(SECTION, n, textures)?.len();
    if priorities.len() < n {
        return invalid_operation(SECTION, format!("priorities has {} of {n}", priorities.len()));
    }
    for (&name, &priority) in textures.iter().zip(priorities).take(n) {
        if let Some(texture) = context.objects.shared.textures.get_mut(name) {
            texture.priority = unit(priority.into()) as f32;
        }
    }
    Ok(())
}

pub(crate) fn are_textures_resident(
    context: &mut Context,
    n: GLsizei,
    textures: &[GLuint],
    _: &mut [GLboolean],
) -> Result<bool> {
    for &name in listed(SECTION, n, textures)? {
        if context.objects.shared.textures.get(name).is_none() {
            return invalid_value(SECTION, format!("{name} is no texture"));
        }
    }
    Ok(true)
}

pub(crate) fn active_texture(context: &mut Context, texture: GLenum) -> Result<()> {
    let count = MAX_COMBINED_TEXTURE_IMAGE_UNITS;
    context.state.units.active = unit_below("GL 2.1, section 2.11.2", texture, count)?;
    context.state_changes.no_change();
    Ok(())
}

pub(crate) fn client_active_texture(context: &mut Context, texture: GLenum) -> Result<()> {
    context.state.units.client_active = texture_unit("GL 2.1, section 2.8", texture)?;
    Ok(())
}
