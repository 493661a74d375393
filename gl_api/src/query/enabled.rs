//! `glIsEnabled`: GL 2.1, section 6.1.1. The names are those rows of [`crate::query::state`] that are read as
//! `Enabled`.

use crate::base::constants::*;
use crate::base::error::Result;
use crate::base::types::*;
use crate::calls::enable::{capability, client_location};
use crate::context::Context;
use crate::context::debug::Output;
use crate::state::enable::{CLIENT_ARRAY, Capability, Flag};

/// `glIsEnabled`.
pub(crate) fn is_enabled(context: &mut Context, cap: GLenum) -> Result<bool> {
    is_on(context, cap)
}

/// Whether a capability or a client array is on.
pub(crate) fn is_on(context: &Context, cap: GLenum) -> Result<bool> {
    if cap == GL_PRIMITIVE_RESTART_NV {
        return Ok(context.state.enables.has(Flag::PrimitiveRestart));
    }
    if let Some(location) = CLIENT_ARRAY.get(cap)
        && context.profile.is_compatibility()
    {
        return Ok(context.state.arrays.by_location[client_location(context, location)].enabled);
    }
    Ok(match capability(context, cap)? {
        Capability::Flag(flag) => context.state.enables.has(flag),
        Capability::Texture(target) => context.state.units.active().enabled[target as usize],
        Capability::DebugOutput => context.debug.output == Output::On,
        Capability::TexGen(coord) => {
            context.state.units.active_coordinates("GL 2.1, section 6.1.1")?;
            context.state.units.active().generate[coord as usize].enabled
        }
        Capability::Light(light) => context.state.lights.enabled >> light & 1 == 1,
        Capability::ClipPlane(plane) => context.state.clip.enabled >> plane & 1 == 1,
        Capability::Map(map) => context.state.evaluators.has(map),
    })
}
