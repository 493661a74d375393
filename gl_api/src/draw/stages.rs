//! Chooses the shaders of a draw, with their textures and uniform words: the program in use, assembly programs, or the
//! fixed function for each stage that they lack.

use crate::assembly::{Position, Target};
use crate::base::clamp::Clamp;
use crate::base::error::{Result, invalid_operation};
use crate::base::inverse::inverse;
use crate::context::Context;
use crate::context::recorder::fixed_function::StageKeys;
use crate::context::recorder::stages::{
    Reads, Sides, Stages, Textures, VariantKey, VertexVariantKey, internal,
};
use crate::context::watched_pixel::DrawNote;
use crate::draw::alpha_test::alpha_test;
use crate::draw::assembly_stage::assembled;
use crate::draw::no_effect;
use crate::draw::state_words::put_bindings;
use crate::draw::textures::{Reader, plan, program_textures};
use crate::draw::validate::runnable;
use crate::generate::fixed::clamp::clamp_fragment_colors;
use crate::generate::fixed::fragment::{FragmentKey, add_alpha_test, set_shade_model};
use crate::generate::fixed::rewrite::{add_clip_planes, add_coverage, add_two_sides};
use crate::generate::fixed::vertex::VertexKey;
use crate::generate::fixed::{cached, word};
use crate::glsl::{ComparisonResult, SamplerSlot};
use crate::objects::programs::Linked;
use crate::objects::target::TextureTarget;
use crate::state::enable::Flag;
use glam::DMat4;
use rasterizer::driver::{Antialiasing, ShaderModule, VertexBinding};
use rasterizer::ir::{Interpolation, Output, Stage};
use std::sync::Arc;

/// The stages of programs, and what they read.
#[derive(Default)]
struct Programs {
    vertex: Option<ShaderModule>,
    geometry: Option<ShaderModule>,
    fragment: Option<ShaderModule>,
    samplers: Vec<SamplerSlot>,
    words: Vec<u32>,
    /// The interpolation of colours that the shaders declare.
    color_interpolation: [Option<Interpolation>; 2],
    /// Where positions come from, by stage, if that is an assembly program.
    assembly: [Option<Position>; 2],
}

impl Programs {
    /// The program in use, and assembly programs for the stages that it lacks.
    fn new(context: &mut Context) -> Result<Self> {
        let mut programs = Self { words: context.recorder.empty_words(), ..Self::default() };
        if let Some(linked) = context.executable() {
            if let Err(problem) = runnable(linked) {
                return invalid_operation("GL 2.1, section 2.15.4", problem);
            }
            let program = &linked.program;
            put_words(context, &mut programs.words, linked);
            let clamp = crate::draw::color_clamp::of_vertices(context);
            programs.vertex = linked.vertex_of(clamp).clone();
            programs.geometry = linked.geometry_of(clamp).clone();
            programs.fragment = linked.fragment.clone();
            programs.samplers.clone_from(&program.samplers);
            programs.color_interpolation = program.color_interpolation;
        }
        let (words, samplers) = (&mut programs.words, &mut programs.samplers);
        if let Some(found) = assembled(context, Target::Vertex, words, samplers)? {
            programs.vertex = Some(found.module);
            programs.assembly[0] = Some(found.position);
        }
        if let Some(found) = assembled(context, Target::Fragment, words, samplers)? {
            programs.fragment = Some(found.module);
            programs.assembly[1] = Some(found.position);
            programs.color_interpolation = [None; 2];
        }
        Ok(programs)
    }

    /// The first word of the fixed function, which lies behind those of programs.
    fn base(&self) -> u32 {
        self.words.len() as u32
    }

    fn textures(
        &self,
        context: &mut Context,
        stage: Stage,
        module: &ShaderModule,
    ) -> Result<Textures> {
        program_textures(context, stage, module, &self.samplers, &self.words)
    }
}

/// Chooses the stages.
pub(crate) fn choose(
    context: &mut Context,
    vertices: &[VertexBinding],
    antialiasing: Antialiasing,
) -> Result<Stages> {
    crate::draw::program_pipeline::sync(context);
    crate::draw::uniform_blocks::refresh(context)?;
    crate::draw::fixed_function::keys::update_unit_summary(context);
    let clamp = crate::draw::color_clamp::of_fragments(context);
    let programs = Programs::new(context)?;
    let vertex_textures = match &programs.vertex {
        Some(module) => programs.textures(context, Stage::Vertex, module)?,
        None => Arc::clone(&context.recorder.no_textures),
    };
    let geometry_textures = match &programs.geometry {
        Some(module) => programs.textures(context, Stage::Geometry, module)?,
        None => Arc::clone(&context.recorder.no_textures),
    };
    let fragment = FragmentStage::new(context, &programs, vertices, antialiasing, clamp)?;
    let vertex = VertexStage::new(context, &programs, vertices)?;
    let Programs { samplers, mut words, assembly, geometry, .. } = programs;
    let note = context.watched.is_some().then(|| match (&fragment.key, assembly[1]) {
        (Some(key), _) => DrawNote::of_fixed(context, key),
        (None, Some(_)) => DrawNote::of_assembly(context, &samplers, &words),
        (None, None) => DrawNote::of_program(context, &fragment.module, &words),
    });
    let stages = [&vertex.module, &fragment.module].into_iter().chain(&geometry);
    let needed = stages.map(|stage| stage.module().uniform_words).max().unwrap_or(0);
    let keys = StageKeys {
        vertex: vertex.key,
        fragment: fragment.key,
        clip_planes: vertex.clip_planes,
        clip_space: vertex.clip_space,
        clamp,
        needed,
    };
    crate::draw::fixed_function::words::append(context, &mut words, &keys);
    // The words of assembly programs and their clip space cannot be made again by the keys alone.
    let keys = (assembly == [None; 2]).then_some(keys);
    let fragment_textures = fragment.textures;
    let reads = Reads { words, vertex_textures, geometry_textures, fragment_textures, keys, note };
    Ok(Stages { vertex: vertex.module, geometry, fragment: fragment.module, reads })
}

/// Writes the words of the program in use: its uniforms, and the state that it reads.
fn put_words(context: &Context, words: &mut Vec<u32>, linked: &Linked) {
    words.clone_from(&linked.words);
    words.resize(linked.program.words as usize, 0);
    put_bindings(context, words, &linked.program.state);
}

/// The words of a draw with the stages of the draw before; `None` where samplers have changed.
pub(crate) fn words(context: &mut Context, keys: &StageKeys) -> Option<Vec<u32>> {
    let mut words = context.recorder.empty_words();
    crate::draw::program_pipeline::sync(context);
    // What is wrong with a buffer is said where the draw is decided anew.
    crate::draw::uniform_blocks::refresh(context).ok()?;
    if let Some(linked) = context.executable() {
        put_words(context, &mut words, linked);
        let emitted = context.recorder.emitted.words.as_deref()?;
        let is_same =
            |slot: &SamplerSlot| words.get(slot.word as usize) == emitted.get(slot.word as usize);
        if !linked.program.samplers.iter().all(is_same) {
            return None;
        }
    }
    crate::draw::fixed_function::words::append(context, &mut words, keys);
    Some(words)
}

/// The textures of a draw with the pipeline of the draw before, by stage of its program; `None` where one cannot be read.
pub(crate) fn textures(context: &mut Context, words: &[u32]) -> Option<[Textures; 3]> {
    let desc = context.recorder.emitted.pipeline.as_ref()?;
    let (vertex, fragment) = (Some(desc.vertex.clone()), Some(desc.fragment.clone()));
    let geometry = desc.geometry.clone();
    let samplers = context.executable()?.program.samplers.clone();
    let mut of_stage = |stage: Stage, module: Option<ShaderModule>| match module {
        Some(module) if !module.module().textures.is_empty() => {
            program_textures(context, stage, &module, &samplers, words).ok()
        }
        Some(_) | None => Some(Arc::clone(&context.recorder.no_textures)),
    };
    Some([
        of_stage(Stage::Vertex, vertex)?,
        of_stage(Stage::Geometry, geometry)?,
        of_stage(Stage::Fragment, fragment)?,
    ])
}

/// The fragment stage.
struct FragmentStage {
    module: ShaderModule,
    textures: Textures,
    /// The key, where it is the fixed function's.
    key: Option<FragmentKey>,
}

impl FragmentStage {
    /// The stage of a program, or the fixed function's. `vertices` are the fixed-function vertex stage's, where it
    /// runs.
    fn new(
        context: &mut Context,
        programs: &Programs,
        vertices: &[VertexBinding],
        antialiasing: Antialiasing,
        clamp: Clamp,
    ) -> Result<Self> {
        context.recorder.is_opaque = false;
        let two_sided = match programs.vertex {
            Some(_) => {
                context.state.enables.has(Flag::VertexProgramTwoSide)
                    && no_effect::shows_back_faces(context)
            }
            None => no_effect::lights_two_sides(context),
        };
        if let Some(module) = &programs.fragment {
            let textures = programs.textures(context, Stage::Fragment, module)?;
            let alpha = alpha_test(context);
            let key = VariantKey {
                alpha: alpha.map(|compare| (compare, programs.base() + word::ALPHA_REF)),
                shade_model: context.state.raster.shade_model,
                sides: if two_sided { Sides::Two } else { Sides::One },
                // Formats with values in [0, 1] clamp when they are written.
                clamp: if crate::draw::color_clamp::draws_fractions(context) {
                    Clamp::Off
                } else {
                    clamp
                },
                color_interpolation: programs.color_interpolation,
                antialiasing,
                module: module.clone(),
            };
            return Ok(Self {
                module: program_fragment(context, key, clamp)?,
                textures,
                key: None,
            });
        }
        let own = programs.vertex.is_none().then_some(vertices);
        let key =
            crate::draw::fixed_function::keys::fragment_key(context, own, programs.base(), clamp);
        let textures = if key.units.is_empty() {
            Arc::clone(&context.recorder.no_textures)
        } else {
            let plans = key.units.iter().map(|unit| {
                let target = TextureTarget::of(unit.shape);
                let (result, reader) = (ComparisonResult::DepthTextureMode, Reader::FixedFunction);
                Some(plan(context, unit.unit, target, result, reader))
            });
            plans.collect()
        };
        let key = FragmentKey { two_sided: key.two_sided || two_sided, antialiasing, ..key };
        let module = context.recorder.fixed.fragment(&key).map_err(|error| internal(&error))?;
        Ok(Self { module, textures, key: Some(key) })
    }
}

/// The vertex stage.
struct VertexStage {
    module: ShaderModule,
    /// The key, where it is the fixed function's.
    key: Option<VertexKey>,
    /// The user clip planes that cut what a program gives, bit by plane, and the space they are in.
    clip_planes: u8,
    clip_space: DMat4,
}

impl VertexStage {
    /// The stage of a program, or the fixed function's.
    fn new(context: &mut Context, programs: &Programs, vertices: &[VertexBinding]) -> Result<Self> {
        let (mut clip_planes, mut clip_space) = (0, DMat4::IDENTITY);
        let base = programs.base();
        let Some(module) = programs.vertex.clone() else {
            let key = crate::draw::fixed_function::keys::vertex_key(context, vertices, base);
            let module = context.recorder.fixed.vertex(&key).map_err(|error| internal(&error))?;
            return Ok(Self { module, key: Some(key), clip_planes, clip_space });
        };
        match programs.assembly[0] {
            // ARB_vertex_program, section 2.11: other positions are not cut.
            Some(Position::Computed) => {}
            Some(Position::Invariant) => {
                clip_planes = context.state.clip.enabled;
                if clip_planes != 0 {
                    clip_space = inverse(context.state.matrices.projection.top).transpose();
                }
            }
            // What a geometry shader emits is cut by the distances that it writes.
            None if programs.geometry.is_some() => {}
            None if !writes_clip_distances(&module) => clip_planes = context.state.clip.enabled,
            None => {}
        }
        let key = VertexVariantKey { module, planes: clip_planes, base };
        let module = program_vertex(context, key)?;
        Ok(Self { module, key: None, clip_planes, clip_space })
    }
}

/// Whether a vertex stage writes clip distances itself.
fn writes_clip_distances(module: &ShaderModule) -> bool {
    let mut outputs = module.module().outputs.iter();
    outputs.any(|(output, _)| matches!(output, Output::ClipDistance(_)))
}

/// A program's vertex stage with the state built in where it matters.
fn program_vertex(context: &mut Context, key: VertexVariantKey) -> Result<ShaderModule> {
    if key.planes == 0 {
        return Ok(key.module);
    }
    cached(&mut context.recorder.vertex_variants, &key, |key| {
        let module = key.module.module().clone();
        add_clip_planes(module, key.planes, key.base + word::CLIP_PLANES)
    })
    .map_err(|error| internal(&error))
}

/// A program's fragment stage with the state built in where it matters. The alpha test sees clamped
/// colours, if `clamp` says so, whatever the buffers are.
fn program_fragment(
    context: &mut Context,
    mut key: VariantKey,
    clamp: Clamp,
) -> Result<ShaderModule> {
    if key.alpha.is_some() {
        key.clamp = clamp;
    }
    let plain = key.shade_model == Interpolation::Smooth && key.alpha.is_none();
    let plain = plain && key.sides == Sides::One && key.antialiasing == Antialiasing::Aliased;
    if plain && key.clamp == Clamp::Off {
        return Ok(key.module);
    }
    cached(&mut context.recorder.variants, &key, |key| {
        let mut variant = key.module.module().clone();
        if key.sides == Sides::Two {
            add_two_sides(&mut variant);
        }
        if key.clamp == Clamp::On {
            clamp_fragment_colors(&mut variant);
        }
        if key.antialiasing == Antialiasing::Smooth {
            add_coverage(&mut variant);
        }
        if key.shade_model == Interpolation::Flat {
            set_shade_model(&mut variant, Interpolation::Flat, key.color_interpolation);
        }
        if let Some((compare, reference)) = key.alpha {
            add_alpha_test(&mut variant, compare, reference);
        }
        variant
    })
    .map_err(|error| internal(&error))
}
