//! The sampler state of a unit and target.

use crate::context::Context;
use crate::objects::target::TextureTarget;
use crate::state::enable::Flag;
use texunit::sampler::{Border, DepthFilter, Sampler, Seamless};

/// The sampler state of a unit and target: that of the bound sampler object or else the texture's,
/// with the unit's bias.
pub(crate) fn sampler(context: &Context, unit: u8, target: TextureTarget) -> Sampler {
    let state = &context.state.units.units[usize::from(unit)];
    let texture = context.objects.texture(target, &state.bound[target as usize]);
    let own = texture.sampler();
    // Multisample textures ignore sampler objects.
    let object = context.objects.shared.samplers.bound(&state.sampler);
    let mut sampler = match object.filter(|_| !target.is_multisample()) {
        Some(object) => Sampler {
            base_level: own.base_level,
            max_level: own.max_level,
            depth_mode: own.depth_mode,
            swizzle: own.swizzle,
            ..object.sampler.clone()
        },
        None => own,
    };
    if context.state.enables.has(Flag::SeamlessCubeMaps) {
        sampler.seamless = Seamless::On;
    }
    // GL 3.1, section 3.8.8: border colours are clamped by format. The sample plan does it by what is stored.
    if texture.stores_fractions_as_floats() {
        let fractions =
            sampler.border.floats().map(|c| crate::base::convert::unit(c.into()) as f32);
        sampler.border = Border::Float(fractions);
    }
    if context.profile.is_es() && sampler.compare.is_none() && texture.is_of_sized_depth() {
        sampler.depth_filter = DepthFilter::Nearest;
    }
    sampler.lod_bias = crate::base::convert::lod_bias(sampler.lod_bias + state.lod_bias);
    sampler
}
