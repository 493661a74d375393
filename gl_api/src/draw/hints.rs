//! Warnings for a draw whose picture may not be what was meant: the usual reasons of a black one.

use crate::assembly::running::has_fragment_program;
use crate::constants::*;
use crate::context::Context;
use crate::interface::MAX_COMBINED_TEXTURE_IMAGE_UNITS;
use crate::state::enable::CAPABILITY;
use crate::texture::{TARGET, TextureTarget};

/// A texture that is sampled but incomplete: the unit is as if switched off, a shader reads black.
pub(super) fn incomplete(context: &mut Context, unit: u8, target: TextureTarget, reason: &str) {
    let name = context.state.units.units[usize::from(unit)].bound[target as usize];
    context.debug.warn(format!(
        "draw: texture {name} on {} of unit {unit} is incomplete: {reason} (GL 2.1, section 3.8.10)",
        enum_name(TARGET.encode(target))
    ));
}

/// A sampler uniform whose unit has nothing for it.
pub(super) fn sampler(context: &mut Context, unit: u8, target: TextureTarget, word: u32) {
    let bound = context.state.units.units[usize::from(unit)].bound;
    let name = bound[target as usize];
    let state = super::stages::sampler(context, unit, target);
    let reason = context.objects.texture(target, name).incomplete_reason(&state);
    let Some(reason) = reason else { return };
    let uniform = uniform_name(context, word);
    let other = TextureTarget::ALL.into_iter().find(|other| bound[*other as usize] != 0);
    if let (0, Some(other)) = (name, other) {
        context.debug.warn(format!(
            "draw: sampler{uniform} samples {} of unit {unit}, where nothing is bound; texture {} \
             is bound to {} there",
            enum_name(TARGET.encode(target)),
            bound[other as usize],
            enum_name(TARGET.encode(other))
        ));
        return;
    }
    context.debug.warn(format!(
        "draw: sampler{uniform} reads black, as texture {name} on {} of unit {unit} is incomplete: \
         {reason} (GL 2.1, section 3.8.10)",
        enum_name(TARGET.encode(target))
    ));
}

/// The uniform of the program in use that has this word, quoted, after a space.
fn uniform_name(context: &Context, word: u32) -> String {
    let program = context.objects.linked_program(context.state.bindings.program);
    program.map_or_else(String::new, |linked| linked.quoted_name(word))
}

/// Textures are bound, but no unit is switched on and no program is in use.
pub(super) fn nothing_enabled(context: &mut Context) {
    if context.state.bindings.program != 0 || has_fragment_program(context) {
        return;
    }
    let units = &context.state.units.units;
    if units.iter().any(|unit| unit.enabled.contains(&true)) {
        return;
    }
    let bound = units.iter().zip(0..MAX_COMBINED_TEXTURE_IMAGE_UNITS).find_map(|(unit, number)| {
        // Those that cannot be switched on are for shaders alone.
        let target = TextureTarget::ALL.into_iter().find(|&target| {
            unit.bound[target as usize] != 0 && CAPABILITY.get(TARGET.encode(target)).is_some()
        })?;
        Some((number, target, unit.bound[target as usize]))
    });
    if let Some((unit, target, name)) = bound {
        let target = enum_name(TARGET.encode(target));
        context.debug.warn(format!(
            "draw: texture {name} is bound to {target} of unit {unit}, but texturing is off: call \
             glEnable({target})"
        ));
    }
}
