//! The attribute stacks: `glPushAttrib` and `glPushClientAttrib`, GL 2.1, section 6.1.17 and the
//! attribute groups of tables 6.5 to 6.37.

use super::enable::{Enables, Flag};
use super::versioned::Versioned;
use super::{State, clamp, clip, fog, fragment, light, material, pixel_store, raster, viewport};
use crate::constants::*;
use crate::context::Context;
use crate::draw::arrays::Arrays;
use crate::env::Units;
use crate::error::{ErrorCode, GlError, Result};
use crate::evaluate::EvaluatorState;
use crate::framebuffer::buffers::{self, Selection};
use crate::object::bound::Bound;
use crate::pixels::position::RasterPosition;
use crate::state::matrix::MatrixMode;
use crate::texture::TextureTarget;
use crate::texture::sampler::SamplerState;
use crate::texture::transfer::Transfer;
use crate::types::*;

const SECTION: &str = "GL 2.1, section 6.1.17";

/// Each of the stacks holds so many groups (table 6.35).
pub(crate) const MAX_ATTRIB_STACK_DEPTH: usize = 16;

/// What of the context's state a push keeps; the parts that are small are kept whatever the mask.
#[derive(Clone, Debug)]
struct Server {
    mask: GLbitfield,
    current: [[f32; 4]; super::LOCATIONS],
    enables: Enables,
    lights: Versioned<light::Lights>,
    materials: Versioned<material::Materials>,
    fog: fog::FogState,
    clip: clip::ClipPlanes,
    raster: raster::RasterState,
    fragment: fragment::FragmentState,
    clear: fragment::ClearState,
    clamp: clamp::ClampState,
    transfer: Transfer,
    pixel_zoom: [f32; 2],
    raster_position: RasterPosition,
    viewport: viewport::ViewportState,
    evaluators: EvaluatorState,
    matrix_mode: MatrixMode,
    list_base: GLuint,
    selection: Option<Selection>,
    /// Of `GL_TEXTURE_BIT` and `GL_ENABLE_BIT`.
    units: Option<Box<Units>>,
    /// Of `GL_TEXTURE_BIT`.
    textures: Vec<Parameters>,
}

/// The parameters of a texture that is bound.
#[derive(Clone, Debug)]
struct Parameters {
    target: TextureTarget,
    bound: Bound,
    state: SamplerState,
    generate_mipmap: bool,
    priority: f32,
}

/// What of the client's state a push keeps.
#[derive(Clone, Debug)]
struct Client {
    mask: GLbitfield,
    pack: pixel_store::PixelStore,
    unpack: pixel_store::PixelStore,
    pixel_buffers: [Bound; 2],
    arrays: Arrays,
    array_buffers: [Bound; 2],
    vertex_array: GLuint,
    /// Whether primitives are restarted, and by which index.
    restart: (bool, GLuint),
    client_active: u8,
}

/// Both stacks.
#[derive(Debug, Default)]
pub(crate) struct AttribStacks {
    server: Vec<Server>,
    client: Vec<Client>,
}

impl AttribStacks {
    /// How many groups are on the stack of the context's state, and of the client's.
    pub fn depths(&self) -> [usize; 2] {
        [self.server.len(), self.client.len()]
    }
}

/// The flags of each group; `GL_ENABLE_BIT` has all of them.
const FLAGS: &[(GLbitfield, &[Flag])] = &[
    (
        GL_COLOR_BUFFER_BIT,
        &[
            Flag::AlphaTest,
            Flag::Blend,
            Flag::ColorLogicOp,
            Flag::Dither,
            Flag::FramebufferSrgb,
            Flag::IndexLogicOp,
        ],
    ),
    (GL_DEPTH_BUFFER_BIT, &[Flag::DepthTest]),
    (GL_EVAL_BIT, &[Flag::AutoNormal]),
    (GL_FOG_BIT, &[Flag::Fog, Flag::ColorSum]),
    (GL_LIGHTING_BIT, &[Flag::ColorMaterial, Flag::Lighting]),
    (GL_LINE_BIT, &[Flag::LineSmooth, Flag::LineStipple]),
    (
        GL_MULTISAMPLE_BIT,
        &[
            Flag::Multisample,
            Flag::SampleAlphaToCoverage,
            Flag::SampleAlphaToOne,
            Flag::SampleCoverage,
            Flag::SampleMask,
        ],
    ),
    (GL_POINT_BIT, &[Flag::PointSmooth, Flag::PointSprite]),
    (
        GL_POLYGON_BIT,
        &[
            Flag::CullFace,
            Flag::PolygonOffsetFill,
            Flag::PolygonOffsetLine,
            Flag::PolygonOffsetPoint,
            Flag::PolygonSmooth,
            Flag::PolygonStipple,
        ],
    ),
    (GL_SCISSOR_BIT, &[Flag::ScissorTest]),
    (GL_STENCIL_BUFFER_BIT, &[Flag::StencilTest, Flag::StencilTestTwoSide]),
    (GL_TRANSFORM_BIT, &[Flag::DepthClamp, Flag::Normalize, Flag::RescaleNormal]),
    (
        GL_ENABLE_BIT,
        &[
            Flag::FragmentProgram,
            Flag::RasterizerDiscard,
            Flag::SeamlessCubeMaps,
            Flag::VertexProgram,
            Flag::VertexProgramPointSize,
            Flag::VertexProgramTwoSide,
        ],
    ),
];

fn bound_textures(context: &Context) -> Vec<Parameters> {
    let mut textures: Vec<Parameters> = Vec::new();
    for unit in context.state.units.units.iter() {
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
    textures
}

fn stack_error<T>(code: ErrorCode, rule: String) -> Result<T> {
    Err(GlError { code, rule, section: SECTION })
}

pub(crate) fn push_attrib(context: &mut Context, mask: GLbitfield) -> Result<()> {
    if context.attribs.server.len() >= MAX_ATTRIB_STACK_DEPTH {
        return stack_error(
            ErrorCode::StackOverflow,
            format!("the stack has {MAX_ATTRIB_STACK_DEPTH} groups: glPopAttrib is missing"),
        );
    }
    let has = |bits| mask & bits != 0;
    let state = &context.state;
    let saved = Server {
        mask,
        current: state.current,
        enables: state.enables.clone(),
        lights: state.lights.clone(),
        materials: state.materials.clone(),
        fog: state.fog.clone(),
        clip: state.clip.clone(),
        raster: state.raster.clone(),
        fragment: state.fragment.clone(),
        clear: state.clear.clone(),
        clamp: state.clamp,
        transfer: state.transfer,
        pixel_zoom: state.pixel_zoom,
        raster_position: state.raster_position.clone(),
        viewport: state.viewport.clone(),
        evaluators: state.evaluators,
        matrix_mode: state.matrices.mode,
        list_base: context.lists.base(),
        selection: has(GL_COLOR_BUFFER_BIT | GL_PIXEL_MODE_BIT).then(|| buffers::selected(context)),
        units: has(GL_TEXTURE_BIT | GL_ENABLE_BIT | GL_POINT_BIT)
            .then(|| Box::new(state.units.clone())),
        textures: if has(GL_TEXTURE_BIT) { bound_textures(context) } else { Vec::new() },
    };
    context.attribs.server.push(saved);
    Ok(())
}

pub(crate) fn pop_attrib(context: &mut Context) -> Result<()> {
    let Some(saved) = context.attribs.server.pop() else {
        return stack_error(
            ErrorCode::StackUnderflow,
            "the stack is empty: glPushAttrib is missing".into(),
        );
    };
    for &(bit, flags) in FLAGS {
        if saved.mask & (bit | GL_ENABLE_BIT) != 0 {
            for &flag in flags {
                context.state.enables.set(flag, saved.enables.has(flag));
            }
        }
    }
    if saved.mask & GL_TEXTURE_BIT != 0 {
        restore_textures(context, &saved);
    }
    if saved.mask & GL_LIST_BIT != 0 {
        context.lists.set_base(saved.list_base);
    }
    if let Some(selection) = &saved.selection {
        if saved.mask & GL_COLOR_BUFFER_BIT != 0 {
            buffers::draw_again(context, selection);
        }
        if saved.mask & GL_PIXEL_MODE_BIT != 0 {
            buffers::read_again(context, selection);
        }
    }
    restore(&mut context.state, saved);
    Ok(())
}

/// Puts the groups of plain state back.
fn restore(state: &mut State, saved: Server) {
    let mask = saved.mask;
    let has = |bit| mask & bit != 0;
    if has(GL_ENABLE_BIT) {
        restore_enables(state, &saved);
    }
    if has(GL_CURRENT_BIT) {
        state.current = saved.current;
        state.raster_position = saved.raster_position;
    }
    if let Some(mut units) = saved.units {
        restore_units(&mut state.units, &mut units, mask);
    }
    if has(GL_LIGHTING_BIT) {
        state.lights = saved.lights;
        state.materials = saved.materials;
    }
    if has(GL_LIGHTING_BIT | GL_ENABLE_BIT) {
        state.clamp.vertex = saved.clamp.vertex;
    }
    if has(GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT) {
        state.clamp.fragment = saved.clamp.fragment;
        state.clamp.read = saved.clamp.read;
    }
    if has(GL_EVAL_BIT) {
        state.evaluators = saved.evaluators;
    }
    if has(GL_FOG_BIT) {
        state.fog = saved.fog;
    }
    if has(GL_TRANSFORM_BIT) {
        state.clip = saved.clip;
        state.matrices.mode = saved.matrix_mode;
    }
    if has(GL_VIEWPORT_BIT) {
        state.viewport = saved.viewport;
    }
    if has(GL_PIXEL_MODE_BIT) {
        // The maps are of no group (GL 2.1, section 6.2).
        state.transfer = Transfer { maps: state.transfer.maps, ..saved.transfer };
        state.pixel_zoom = saved.pixel_zoom;
    }
    restore_raster(&mut state.raster, saved.raster, mask);
    restore_fragments(&mut state.fragment, saved.fragment, mask);
    restore_clear(&mut state.clear, &saved.clear, mask);
}

/// Of `GL_ENABLE_BIT`: what is not among the flags.
fn restore_enables(state: &mut State, saved: &Server) {
    state.lights.enabled = saved.lights.enabled;
    state.evaluators.take_enabled(&saved.evaluators);
    state.clip.enabled = saved.clip.enabled;
    for (buffer, saved) in state.fragment.buffers.iter_mut().zip(&saved.fragment.buffers) {
        buffer.blend = saved.blend;
    }
    let units = saved.units.iter().flat_map(|units| units.units.iter());
    for (unit, saved) in state.units.units.iter_mut().zip(units) {
        unit.enabled = saved.enabled;
        for (generate, saved) in unit.generate.iter_mut().zip(&saved.generate) {
            generate.enabled = saved.enabled;
        }
    }
}

/// The groups of texture units: the sprites' coordinates are of the points' group, the units' other
/// state of the textures'.
fn restore_units(now: &mut Units, saved: &mut Units, mask: GLbitfield) {
    let points = mask & GL_POINT_BIT != 0;
    for (unit, saved) in now.units.iter_mut().zip(saved.units.iter_mut()) {
        let kept = if points { saved.coord_replace } else { unit.coord_replace };
        (unit.coord_replace, saved.coord_replace) = (kept, kept);
        // What was deleted meanwhile stays deleted: name 0 is bound in its place.
        for (now, saved) in unit.bound.iter().zip(&mut saved.bound) {
            *saved = std::mem::take(saved).restored(now);
        }
        saved.sampler = std::mem::take(&mut saved.sampler).restored(&unit.sampler);
    }
    if mask & GL_TEXTURE_BIT != 0 {
        saved.client_active = now.client_active;
        std::mem::swap(now, saved);
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
fn restore_textures(context: &mut Context, saved: &Server) {
    for saved in &saved.textures {
        let texture = context.objects.texture_mut(saved.target, &saved.bound);
        texture.state = saved.state.clone();
        texture.generate_mipmap = saved.generate_mipmap;
        texture.priority = saved.priority;
    }
}

pub(crate) fn push_client_attrib(context: &mut Context, mask: GLbitfield) -> Result<()> {
    if context.attribs.client.len() >= MAX_ATTRIB_STACK_DEPTH {
        return stack_error(
            ErrorCode::StackOverflow,
            format!("the stack has {MAX_ATTRIB_STACK_DEPTH} groups: glPopClientAttrib is missing"),
        );
    }
    let state = &context.state;
    let bindings = &state.bindings;
    context.attribs.client.push(Client {
        mask,
        pack: state.pack.clone(),
        unpack: state.unpack.clone(),
        pixel_buffers: [&bindings.pixel_pack_buffer, &bindings.pixel_unpack_buffer]
            .map(Bound::clone),
        arrays: state.arrays.clone(),
        array_buffers: [&bindings.array_buffer, &bindings.element_array_buffer].map(Bound::clone),
        vertex_array: bindings.vertex_array,
        restart: (state.enables.has(Flag::PrimitiveRestart), state.restart_index),
        client_active: state.units.client_active,
    });
    Ok(())
}

pub(crate) fn pop_client_attrib(context: &mut Context) -> Result<()> {
    let Some(saved) = context.attribs.client.pop() else {
        return stack_error(
            ErrorCode::StackUnderflow,
            "the stack is empty: glPushClientAttrib is missing".into(),
        );
    };
    if saved.mask & GL_CLIENT_PIXEL_STORE_BIT != 0 {
        context.state.pack = saved.pack;
        context.state.unpack = saved.unpack;
        let bindings = &mut context.state.bindings;
        let [pack, unpack] = saved.pixel_buffers;
        bindings.pixel_pack_buffer.restore(pack);
        bindings.pixel_unpack_buffer.restore(unpack);
    }
    if saved.mask & GL_CLIENT_VERTEX_ARRAY_BIT != 0 {
        let [array, element] = saved.array_buffers;
        // A vertex array object that was deleted meanwhile stays deleted (ARB_vertex_array_object,
        // section 2.10), and its arrays are no other object's.
        let name = saved.vertex_array;
        if name == 0 || context.objects.vertex_arrays.get(name).is_some() {
            crate::object::vertex_arrays::bind_vertex_array(context, name)?;
            context.state.arrays = saved.arrays;
            context.state.bindings.element_array_buffer.restore(element);
        }
        context.state.bindings.array_buffer.restore(array);
        let (restarts, index) = saved.restart;
        context.state.enables.set(Flag::PrimitiveRestart, restarts);
        context.state.restart_index = index;
        context.state.units.client_active = saved.client_active;
    }
    Ok(())
}
