//! The texture that is bound to a target of the active unit.

use crate::context::Context;
pub(crate) use crate::objects::target::TextureTarget;
use crate::objects::texture::Texture;

/// The texture that is bound to a target of the active unit.
pub(crate) fn bound(context: &Context, target: TextureTarget) -> &Texture {
    let bound = &context.state.units.active().bound[target as usize];
    context.objects.texture(target, bound)
}

/// The texture that is bound to a target of the active unit, to be changed.
pub(crate) fn bound_mut(context: &mut Context, target: TextureTarget) -> &mut Texture {
    let bound = &context.state.units.active().bound[target as usize];
    context.objects.texture_mut(target, bound)
}
