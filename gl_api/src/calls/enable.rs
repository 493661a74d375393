//! `glEnable`, `glDisable`, `glEnableClientState` and `glDisableClientState`.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum};
use crate::base::types::*;
use crate::calls::lighting::material::keep_tracked;
use crate::context::Context;
use crate::context::debug::Output;
use crate::interface::ATTRIB_TEX_COORD;
use crate::objects::target::TARGET;
use crate::state::draw_buffers::ALL_BUFFERS;
use crate::state::enable::{CAPABILITY, CLIENT_ARRAY, Capability, Flag, Switch};
use crate::state::evaluators::MAP;
use crate::state::fragment::MORE_SCISSOR_TESTS;

/// A capability of any kind that contexts of the profile have.
pub(crate) fn capability(context: &Context, cap: GLenum) -> Result<Capability> {
    let capability = capability_of_opengl(cap)?;
    match capability {
        Capability::Texture(_) if !context.profile.is_compatibility() => {
            let rule = format!(
                "cap = {}: without a fixed function, shaders sample what is bound, without glEnable",
                enum_name(cap)
            );
            invalid_enum("GL 3.3, appendix E.2.2", rule)
        }
        // By what it is: GL_LIGHT0 has the value of GL_COLOR_BUFFER_BIT, which every profile has.
        Capability::TexGen(_) | Capability::Light(_) | Capability::Map(_)
            if !context.profile.is_compatibility() =>
        {
            let rule = format!("cap = {cap:#06x} is of the fixed function, which shaders replace");
            invalid_enum("GL 3.3, appendix E.2.2", rule)
        }
        Capability::Flag(_)
        | Capability::Texture(_)
        | Capability::TexGen(_)
        | Capability::Light(_)
        | Capability::Map(_)
        | Capability::ClipPlane(_)
        | Capability::DebugOutput => Ok(capability),
    }
}

fn capability_of_opengl(cap: GLenum) -> Result<Capability> {
    if let Some(map) = MAP.get(cap) {
        return Ok(Capability::Map(map));
    }
    if CAPABILITY.get(cap).is_none() && TARGET.get(cap).is_some() {
        let rule = format!(
            "cap = {}: a texture of this target is sampled by shaders alone, which need no glEnable",
            enum_name(cap)
        );
        return invalid_enum(CAPABILITY.section, rule);
    }
    CAPABILITY.decode("cap", cap)
}

/// Sets or clears a bit.
fn set_bit(bits: &mut u8, bit: u8, on: bool) {
    *bits = *bits & !(1 << bit) | u8::from(on) << bit;
}

/// Whether a capability that draws depend on is what it is to be. Blending has a switch for each buffer, and
/// what tracks the colour takes it when it is switched on.
fn is_already(context: &Context, capability: Capability, to: Switch) -> bool {
    let on = to == Switch::On;
    match capability {
        Capability::Flag(Flag::ColorMaterial) => false,
        Capability::Flag(Flag::Blend) => {
            context.state.enables.has(Flag::Blend) == on
                && context.state.fragment.buffers.all_blend(on)
        }
        Capability::Flag(Flag::ScissorTest) => {
            let all = if on { MORE_SCISSOR_TESTS } else { 0 };
            let first = context.state.enables.has(Flag::ScissorTest);
            first == on && context.state.fragment.scissor_tests == all
        }
        Capability::Flag(flag) => context.state.enables.has(flag) == on,
        Capability::Texture(target) => {
            context.state.units.active().enabled[target as usize] == on
                && context.state.units.active_coordinates("GL 2.1, section 3.8.16").is_ok()
        }
        Capability::Light(light) => (context.state.lights.enabled >> light & 1 == 1) == on,
        Capability::ClipPlane(plane) => (context.state.clip.enabled >> plane & 1 == 1) == on,
        Capability::TexGen(_) | Capability::Map(_) | Capability::DebugOutput => false,
    }
}

fn switch(context: &mut Context, cap: GLenum, to: Switch) -> Result<()> {
    let on = to == Switch::On;
    let capability = capability(context, cap)?;
    if let Capability::Texture(_) = capability {
        let active = u32::from(context.state.units.active);
        context.units_switched |= 1u8.checked_shl(active).unwrap_or(0);
    }
    if is_already(context, capability, to) {
        context.state_changes.no_change();
        return Ok(());
    }
    match capability {
        Capability::Flag(Flag::ColorMaterial)
        | Capability::Texture(_)
        | Capability::TexGen(_)
        | Capability::Map(_)
        | Capability::DebugOutput => context.leave_plain_state(),
        Capability::Flag(_) | Capability::Light(_) | Capability::ClipPlane(_) => {}
    }
    match capability {
        Capability::Flag(flag) => {
            if flag == Flag::ColorMaterial {
                keep_tracked(context);
            }
            context.state.enables.set(flag, on);
            if flag == Flag::ScissorTest {
                let all = if on { MORE_SCISSOR_TESTS } else { 0 };
                context.state.fragment.scissor_tests = all;
            }
            if flag == Flag::Blend {
                context.state.fragment.buffers.change(ALL_BUFFERS, |buffer| buffer.blend = on);
            }
        }
        Capability::Texture(target) => {
            context.state.units.active_coordinates("GL 2.1, section 3.8.16")?;
            context.state.units.active_mut().enabled[target as usize] = on;
        }
        Capability::DebugOutput => {
            context.debug.output = if on { Output::On } else { Output::Off };
        }
        Capability::TexGen(coord) => {
            context.state.units.active_coordinates("GL 2.1, section 2.11.4")?;
            context.state.units.active_mut().generate[coord as usize].enabled = on;
        }
        Capability::Light(light) => set_bit(&mut context.state.lights.enabled, light, on),
        Capability::ClipPlane(plane) => set_bit(&mut context.state.clip.enabled, plane, on),
        Capability::Map(map) => context.state.evaluators.set(map, on),
    }
    Ok(())
}

/// GL 1.1's drivers switch the client's arrays by `glEnable` too, and programs came to rely on it.
pub(crate) fn enable(context: &mut Context, cap: GLenum) -> Result<()> {
    if CLIENT_ARRAY.get(cap).is_some() && context.profile.is_compatibility() {
        return switch_client(context, cap, Switch::On);
    }
    switch(context, cap, Switch::On)
}

pub(crate) fn disable(context: &mut Context, cap: GLenum) -> Result<()> {
    if CLIENT_ARRAY.get(cap).is_some() && context.profile.is_compatibility() {
        return switch_client(context, cap, Switch::Off);
    }
    switch(context, cap, Switch::Off)
}

/// The location with the client's active texture unit applied.
pub(crate) fn client_location(context: &Context, location: u8) -> usize {
    let unit = if location == ATTRIB_TEX_COORD { context.state.units.client_active } else { 0 };
    usize::from(location + unit)
}

fn switch_client(context: &mut Context, array: GLenum, to: Switch) -> Result<()> {
    let on = to == Switch::On;
    // NV_primitive_restart has it among the client's arrays.
    if array == GL_PRIMITIVE_RESTART_NV {
        context.state.enables.set(Flag::PrimitiveRestart, on);
        return Ok(());
    }
    let location = client_location(context, CLIENT_ARRAY.decode("array", array)?);
    if context.state.arrays.by_location[location].enabled == on {
        context.state_changes.no_change();
        return Ok(());
    }
    context.state.arrays.by_location[location].enabled = on;
    context.state_changes.values_only();
    Ok(())
}

pub(crate) fn enable_client_state(context: &mut Context, array: GLenum) -> Result<()> {
    switch_client(context, array, Switch::On)
}

pub(crate) fn disable_client_state(context: &mut Context, array: GLenum) -> Result<()> {
    switch_client(context, array, Switch::Off)
}
