//! The attribute stack: `glPushAttrib`, GL 2.1, section 6.1.17 and the attribute groups of tables 6.5
//! to 6.37. The client's is [`super::client_attrib`].

use crate::base::constants::*;
use crate::base::error::{ErrorCode, Result};
use crate::base::types::*;
use crate::context::Context;
use crate::context::pending_primitives::PendingPrimitives;
use crate::draw::pending_primitives::draw_pending;
use crate::objects::target::TextureTarget;
use crate::pixel::transfer::Transfer;
use crate::record::attrib_changes::{is_plain, restore_current};
use crate::state::attrib::{
    MAX_ATTRIB_STACK_DEPTH, Parameters, ServerAttribs, Switches, stack_error,
};
use crate::state::enable::{Flag, Flags};
use crate::state::texture_units::Units;
use crate::state::{State, fragment, raster};
use std::sync::Arc;

/// The flags of each group; `GL_ENABLE_BIT` has all of them.
const FLAGS: &[(GLbitfield, Flags)] = &[
    (
        GL_COLOR_BUFFER_BIT,
        Flags::of(&[
            Flag::AlphaTest,
            Flag::Blend,
            Flag::ColorLogicOp,
            Flag::Dither,
            Flag::FramebufferSrgb,
            Flag::IndexLogicOp,
        ]),
    ),
    (GL_DEPTH_BUFFER_BIT, Flags::of(&[Flag::DepthTest])),
    (GL_EVAL_BIT, Flags::of(&[Flag::AutoNormal])),
    (GL_FOG_BIT, Flags::of(&[Flag::Fog, Flag::ColorSum])),
    (GL_LIGHTING_BIT, Flags::of(&[Flag::ColorMaterial, Flag::Lighting])),
    (GL_LINE_BIT, Flags::of(&[Flag::LineSmooth, Flag::LineStipple])),
    (
        GL_MULTISAMPLE_BIT,
        Flags::of(&[
            Flag::Multisample,
            Flag::SampleAlphaToCoverage,
            Flag::SampleAlphaToOne,
            Flag::SampleCoverage,
            Flag::SampleMask,
            Flag::SampleShading,
        ]),
    ),
    (GL_POINT_BIT, Flags::of(&[Flag::PointSmooth, Flag::PointSprite])),
    (
        GL_POLYGON_BIT,
        Flags::of(&[
            Flag::CullFace,
            Flag::PolygonOffsetFill,
            Flag::PolygonOffsetLine,
            Flag::PolygonOffsetPoint,
            Flag::PolygonSmooth,
            Flag::PolygonStipple,
        ]),
    ),
    (GL_SCISSOR_BIT, Flags::of(&[Flag::ScissorTest])),
    (GL_STENCIL_BUFFER_BIT, Flags::of(&[Flag::StencilTest, Flag::StencilTestTwoSide])),
    (GL_TRANSFORM_BIT, Flags::of(&[Flag::DepthClamp, Flag::Normalize, Flag::RescaleNormal])),
    (
        GL_ENABLE_BIT,
        Flags::of(&[
            Flag::FragmentProgram,
            Flag::RasterizerDiscard,
            Flag::SeamlessCubeMaps,
            Flag::VertexProgram,
            Flag::VertexProgramPointSize,
            Flag::VertexProgramTwoSide,
        ]),
    ),
];

/// Keeps the parameters of all textures that are bound.
fn keep_textures(context: &Context, textures: &mut Vec<Parameters>) {
    let units = &context.state.units.units;
    for (at, unit) in units.iter().enumerate() {
        // Units that nobody has changed are one.
        if at > 0 && Arc::ptr_eq(unit, &units[at - 1]) {
            continue;
        }
        for target in TextureTarget::ALL {
            let bound = &unit.bound[target as usize];
            if textures.iter().all(|known| (known.target, &known.bound) != (target, bound)) {
                let texture = context.objects.texture(target, bound);
                textures.push(Parameters {
                    target,
                    bound: bound.clone(),
                    state: texture.state.clone(),
                    generate_mipmap: texture.generate_mipmap,
                    priority: texture.priority,
                });
            }
        }
    }
}

pub(crate) fn push_attrib(context: &mut Context, mask: GLbitfield) -> Result<()> {
    if context.attribs.server.len() >= MAX_ATTRIB_STACK_DEPTH {
        return stack_error(
            ErrorCode::StackOverflow,
            format!("the stack has {MAX_ATTRIB_STACK_DEPTH} groups: glPopAttrib is missing"),
        );
    }
    let mut saved = context.attribs.spare.pop().unwrap_or_default();
    saved.keep(context, mask);
    context.attribs.server.push(saved);
    context.state_changes.no_change();
    Ok(())
}

impl ServerAttribs {
    /// Keeps the groups of a mask; there are none in it yet.
    fn keep(&mut self, context: &Context, mask: GLbitfield) {
        let has = |bits| mask & bits != 0;
        let state = &context.state;
        self.mask = mask;
        self.enables = state.enables.clone();
        self.clamp = state.clamp;
        self.matrix_mode = state.matrices.mode;
        self.list_base = context.lists.base();
        self.pixel_zoom = state.pixel_zoom;
        self.units_version = state.units.units.version();
        self.current = has(GL_CURRENT_BIT).then(|| (state.current, state.raster_position.clone()));
        self.lighting =
            has(GL_LIGHTING_BIT).then(|| (state.lights.clone(), state.materials.clone()));
        self.fog = has(GL_FOG_BIT).then(|| state.fog.clone());
        self.clip = has(GL_TRANSFORM_BIT).then(|| state.clip.clone());
        self.raster = has(RASTER_BITS).then(|| state.raster.clone());
        self.fragment = has(FRAGMENT_BITS).then(|| state.fragment.clone());
        self.clear = has(CLEAR_BITS).then(|| state.clear.clone());
        self.transfer = has(GL_PIXEL_MODE_BIT).then_some(state.transfer);
        self.viewport = has(GL_VIEWPORT_BIT).then(|| state.viewport.clone());
        self.evaluators = has(GL_EVAL_BIT).then_some(state.evaluators);
        self.selection = has(GL_COLOR_BUFFER_BIT | GL_PIXEL_MODE_BIT)
            .then(|| crate::calls::framebuffer::buffers::selected(context));
        self.switches = has(GL_ENABLE_BIT).then(|| Switches::of(state));
        self.coord_replace = has(GL_POINT_BIT).then(|| state.units.coord_replace());
        if has(GL_TEXTURE_BIT) {
            self.units = Some(state.units.clone());
            keep_textures(context, &mut self.textures);
        }
    }
}

/// The groups that have part of [`raster::RasterState`].
const RASTER_BITS: GLbitfield = GL_LIGHTING_BIT
    | GL_HINT_BIT
    | GL_LINE_BIT
    | GL_POLYGON_STIPPLE_BIT
    | GL_POLYGON_BIT
    | GL_MULTISAMPLE_BIT
    | GL_POINT_BIT;
/// The groups that have part of [`fragment::FragmentState`].
const FRAGMENT_BITS: GLbitfield =
    GL_SCISSOR_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_COLOR_BUFFER_BIT;
/// The groups that have part of [`fragment::ClearState`].
const CLEAR_BITS: GLbitfield =
    GL_DEPTH_BUFFER_BIT | GL_ACCUM_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_COLOR_BUFFER_BIT;

pub(crate) fn pop_attrib(context: &mut Context) -> Result<()> {
    let Some(mut saved) = context.attribs.server.pop() else {
        return stack_error(
            ErrorCode::StackUnderflow,
            "the stack is empty: glPushAttrib is missing".into(),
        );
    };
    if !is_plain(context, &saved) {
        context.leave_plain_state();
    } else if saved.mask & !(GL_LIST_BIT | GL_CURRENT_BIT) != 0
        && matches!(context.pending, Some(PendingPrimitives::Bitmaps(_)))
    {
        // Bitmaps that wait depend on all else.
        draw_pending(context);
    }
    let mut flags = Flags::default();
    for &(bit, of_group) in FLAGS {
        if saved.mask & (bit | GL_ENABLE_BIT) != 0 {
            flags = flags.with(of_group);
        }
    }
    context.state.enables.copy_from(flags, &saved.enables);
    if let Some((current, raster_position)) = saved.current.take() {
        restore_current(context, &current);
        context.state.raster_position = raster_position;
    }
    restore_textures(context, &mut saved.textures);
    if saved.mask & GL_LIST_BIT != 0 {
        context.lists.set_base(saved.list_base);
    }
    if let Some(selection) = saved.selection.take() {
        let now = crate::calls::framebuffer::buffers::selected(context);
        if saved.mask & GL_COLOR_BUFFER_BIT != 0 && selection.draw != now.draw {
            crate::calls::framebuffer::buffers::draw_again(context, &selection);
        }
        if saved.mask & GL_PIXEL_MODE_BIT != 0 && selection.read != now.read {
            crate::calls::framebuffer::buffers::read_again(context, &selection);
        }
    }
    restore(&mut context.state, &mut saved);
    context.attribs.spare.push(saved);
    Ok(())
}

/// Puts the groups of plain state back.
fn restore(state: &mut State, saved: &mut ServerAttribs) {
    let mask = saved.mask;
    let has = |bit| mask & bit != 0;
    if let Some(switches) = saved.switches.take() {
        restore_switches(state, &switches, saved.units_version);
    }
    restore_units(&mut state.units, saved);
    if let Some((lights, materials)) = saved.lighting.take() {
        state.lights = lights;
        state.materials = materials;
    }
    if has(GL_LIGHTING_BIT | GL_ENABLE_BIT) {
        state.clamp.vertex = saved.clamp.vertex;
    }
    if has(GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT) {
        state.clamp.fragment = saved.clamp.fragment;
        state.clamp.read = saved.clamp.read;
    }
    if let Some(evaluators) = saved.evaluators.take() {
        state.evaluators = evaluators;
    }
    if let Some(fog) = saved.fog.take() {
        state.fog = fog;
    }
    if let Some(clip) = saved.clip.take() {
        state.clip = clip;
        state.matrices.mode = saved.matrix_mode;
    }
    if let Some(viewport) = saved.viewport.take() {
        state.viewport = viewport;
    }
    if let Some(transfer) = saved.transfer.take() {
        // The maps are of no group (GL 2.1, section 6.2).
        state.transfer = Transfer { maps: state.transfer.maps, ..transfer };
        state.pixel_zoom = saved.pixel_zoom;
    }
    if let Some(raster) = saved.raster.take() {
        restore_raster(&mut state.raster, raster, mask);
    }
    if let Some(fragment) = saved.fragment.take() {
        restore_fragments(&mut state.fragment, fragment, mask);
    }
    if let Some(clear) = saved.clear.take() {
        restore_clear(&mut state.clear, &clear, mask);
    }
}

/// Of `GL_ENABLE_BIT`: what is not among the flags. What is as it was keeps its version.
fn restore_switches(state: &mut State, saved: &Switches, units_version: u64) {
    if state.lights.enabled != saved.lights {
        state.lights.enabled = saved.lights;
    }
    state.evaluators.take_enabled(&saved.evaluators);
    state.clip.enabled = saved.clip;
    state.fragment.scissor_tests = saved.scissor_tests;
    let buffers = &mut state.fragment.buffers;
    for (buffer, &saved) in saved.blend.iter().enumerate() {
        if buffers[buffer].blend != saved {
            buffers.change(buffer..buffer + 1, |state| state.blend = saved);
        }
    }
    if state.units.units.version() != units_version {
        for (unit, saved) in saved.units.iter().enumerate() {
            if state.units.units[unit].switches() != *saved {
                state.units.unit_mut(unit).switch(*saved);
            }
        }
    }
}

/// The groups of texture units: the sprites' coordinates are of the points' group, the units' other
/// state of the textures'.
fn restore_units(now: &mut Units, saved: &mut ServerAttribs) {
    let units = saved.units.take();
    if now.units.version() == saved.units_version {
        now.active = units.map_or(now.active, |units| units.active);
        return;
    }
    let replace = saved.coord_replace.unwrap_or_else(|| now.coord_replace());
    if let Some(mut units) = units {
        for at in 0..units.units.len() {
            if !Arc::ptr_eq(&units.units[at], &now.units[at]) {
                let (saved, now) = (units.unit_mut(at), &now.units[at]);
                // What was deleted meanwhile stays deleted: name 0 is bound in its place.
                for (saved, now) in saved.bound.iter_mut().zip(&now.bound) {
                    *saved = std::mem::take(saved).restored(now);
                }
                saved.sampler = std::mem::take(&mut saved.sampler).restored(&now.sampler);
            }
        }
        units.client_active = now.client_active;
        *now = units;
    }
    for at in 0..now.units.len() {
        let replace = replace >> at & 1 == 1;
        if now.units[at].coord_replace != replace {
            now.unit_mut(at).coord_replace = replace;
        }
    }
}

/// The groups of rasterization.
fn restore_raster(now: &mut raster::RasterState, saved: raster::RasterState, mask: GLbitfield) {
    let has = |bit| mask & bit != 0;
    if has(GL_LIGHTING_BIT) {
        now.shade_model = saved.shade_model;
        now.provoking = saved.provoking;
    }
    if has(GL_HINT_BIT) {
        now.hints = saved.hints;
    }
    if has(GL_LINE_BIT) {
        now.line_width = saved.line_width;
        now.stipple_factor = saved.stipple_factor;
        now.stipple_pattern = saved.stipple_pattern;
    }
    if has(GL_POLYGON_STIPPLE_BIT) {
        now.polygons.stipple = saved.polygons.stipple;
    }
    if has(GL_POLYGON_BIT) {
        let stipple = now.polygons.stipple;
        now.cull = saved.cull;
        now.front_face = saved.front_face;
        now.polygons = saved.polygons;
        now.polygons.stipple = stipple;
    }
    if has(GL_MULTISAMPLE_BIT) {
        now.multisample = saved.multisample;
    }
    if has(GL_POINT_BIT) {
        now.points = saved.points;
    }
}

/// The groups of what is done to fragments.
fn restore_fragments(
    now: &mut fragment::FragmentState,
    saved: fragment::FragmentState,
    mask: GLbitfield,
) {
    let has = |bit| mask & bit != 0;
    if has(GL_SCISSOR_BIT) {
        now.scissor = saved.scissor;
        now.scissor_tests = saved.scissor_tests;
    }
    if has(GL_DEPTH_BUFFER_BIT) {
        now.depth_func = saved.depth_func;
        now.depth_write = saved.depth_write;
    }
    if has(GL_STENCIL_BUFFER_BIT) {
        now.stencil = saved.stencil;
    }
    if has(GL_COLOR_BUFFER_BIT) {
        now.alpha_func = saved.alpha_func;
        now.alpha_ref = saved.alpha_ref;
        now.blend_color = saved.blend_color;
        now.logic_op = saved.logic_op;
        now.buffers = saved.buffers;
        now.index_mask = saved.index_mask;
    }
}

/// What each buffer is cleared to.
fn restore_clear(now: &mut fragment::ClearState, saved: &fragment::ClearState, mask: GLbitfield) {
    let has = |bit| mask & bit != 0;
    if has(GL_DEPTH_BUFFER_BIT) {
        now.depth = saved.depth;
    }
    if has(GL_ACCUM_BUFFER_BIT) {
        now.accumulation = saved.accumulation;
    }
    if has(GL_STENCIL_BUFFER_BIT) {
        now.stencil = saved.stencil;
    }
    if has(GL_COLOR_BUFFER_BIT) {
        now.color = saved.color;
        now.index = saved.index;
    }
}

/// Puts the parameters of the textures back that were bound.
fn restore_textures(context: &mut Context, saved: &mut Vec<Parameters>) {
    for saved in saved.drain(..) {
        let texture = context.objects.texture_mut(saved.target, &saved.bound);
        texture.state = saved.state;
        texture.generate_mipmap = saved.generate_mipmap;
        texture.priority = saved.priority;
    }
}
