//! What `glPopAttrib` changes of what draws depend on: where that is plain state and current values, primitives that
//! wait go on waiting.

use crate::base::constants::*;
use crate::base::limits::LOCATIONS;
use crate::calls::vertex::immediate::set_current;
use crate::context::Context;
use crate::state::attrib::ServerAttribs;

/// Whether to put the groups back changes nothing that draws depend on but plain state and current values.
pub(crate) fn is_plain(context: &Context, saved: &ServerAttribs) -> bool {
    let state = &context.state;
    let has = |bits| saved.mask & bits != 0;
    let clamps = GL_LIGHTING_BIT | GL_ENABLE_BIT | GL_COLOR_BUFFER_BIT;
    let same_textures = || {
        saved.textures.iter().all(|saved| {
            let now = context.objects.texture(saved.target, &saved.bound);
            now.state == saved.state && now.generate_mipmap == saved.generate_mipmap
        })
    };
    let same_selection = saved.selection.as_ref().is_none_or(|saved| {
        let now = crate::calls::framebuffer::buffers::selected(context);
        saved.draw == now.draw && saved.read == now.read
    });
    let same_lighting = saved.lighting.as_ref().is_none_or(|(lights, materials)| {
        lights.version() == state.lights.version()
            && materials.version() == state.materials.version()
    });
    state.units.units.version() == saved.units_version
        && (!has(clamps) || state.clamp == saved.clamp)
        && same_lighting
        && same_selection
        && saved.fog.as_ref().is_none_or(|fog| *fog == state.fog)
        && saved.clip.as_ref().is_none_or(|clip| {
            clip.planes == state.clip.planes && clip.control == state.clip.control
        })
        && same_textures()
}

/// Puts current values back, each as a call that sets it does: those that are the same change nothing.
pub(crate) fn restore_current(context: &mut Context, saved: &[[f32; 4]; LOCATIONS]) {
    for (location, value) in saved.iter().enumerate() {
        set_current(context, location, *value);
    }
}
