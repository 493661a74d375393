//! Shaders to a program (GL 2.1 section 2.15, GLSL 1.30 section 4.3): matches the interfaces of the
//! stages, assigns locations and uniform words, and lowers both stages.

mod blocks;
mod cull_distances;
mod geometry;
mod globals;
mod layer_viewport;
mod locations;
mod packing;
mod per_vertex;
mod pipeline;
mod stage;
mod std140;
mod transform_feedback;
mod uniform_locations;
mod uniforms;
mod varying_locations;
mod varyings;

use crate::hir::Unit;
use crate::interface::MAX_TEXTURE_IMAGE_UNITS;
use crate::language::{Version, stage_name};
use crate::lower::{Binding, StageToLower, Words, lower_stage};
use crate::program::{Bindings, Captured, Linked, Program, SamplerSlot, Separable};
use crate::text::diagnostics::{Diagnostic, Log};
pub use pipeline::link_pipeline;
use rasterizer::ir::Module;
use rasterizer::ir::Stage;
use stage::{BindingMap, StageUnits, stage_units};
use std::collections::BTreeSet;
use std::sync::Arc;

/// How strictly the stages must fit together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Matching {
    /// They are a whole program.
    Whole,
    /// They are a separable program: others may come before and after (ARB_separate_shader_objects, section 2.14.2).
    Part,
    /// They are those of a pipeline: what does not match between programs is undefined, here zero.
    Pipeline,
}

/// Links shaders into a program; without shaders, both stages are fixed function.
pub fn link(shaders: &[&Arc<Unit>], bindings: &Bindings) -> Linked {
    let matching = match bindings.separable {
        Separable::No => Matching::Whole,
        Separable::Yes => Matching::Part,
    };
    linked(shaders, bindings, matching)
}

fn linked(shaders: &[&Arc<Unit>], bindings: &Bindings, matching: Matching) -> Linked {
    let mut log = Log::default();
    let program = build(shaders, bindings, matching, &mut log);
    let program = program.filter(|_| !log.has_errors());
    Linked { program, log: log.render(None) }
}

fn build(
    shaders: &[&Arc<Unit>],
    bindings: &Bindings,
    matching: Matching,
    log: &mut Log,
) -> Option<Program> {
    check_versions(shaders, log);
    let units = globals::unify_globals(shaders.iter().map(|shader| Arc::clone(shader)));
    let vertex = stage_units(&units, Stage::Vertex, log);
    let geometry = stage_units(&units, Stage::Geometry, log);
    let fragment = stage_units(&units, Stage::Fragment, log);
    let interface = geometry
        .as_ref()
        .and_then(|geometry| geometry::interface(geometry, vertex.as_ref(), matching, log));
    per_vertex::check(vertex.as_ref(), geometry.as_ref(), matching, log);
    for stage in vertex.iter().chain(&geometry).chain(&fragment) {
        varying_locations::check(stage, log);
        cull_distances::check(stage, log);
    }
    if log.has_errors() {
        return None;
    }
    let mut in_vertex = BindingMap::new();
    let mut in_geometry = BindingMap::new();
    let mut in_fragment = BindingMap::new();
    let stages: Vec<&StageUnits<'_>> = vertex.iter().chain(&geometry).chain(&fragment).collect();
    let mut words = Words::default();
    let used_elements = uniforms::UsedElements::of(&stages);
    let uniforms = uniforms::uniforms(&stages, &used_elements, &mut words, log);
    let blocks = blocks::blocks(&stages, &mut words, log);
    for (name, word) in uniforms.words.iter().chain(&blocks.words) {
        in_vertex.insert(name.clone(), Binding::Uniform(*word));
        in_geometry.insert(name.clone(), Binding::Uniform(*word));
        in_fragment.insert(name.clone(), Binding::Uniform(*word));
    }
    let attributes = match &vertex {
        Some(vertex) => locations::attributes(vertex, bindings, &mut in_vertex, log),
        None => Vec::new(),
    };
    let vertex_numbers = vertex.as_ref().map_or_else(Vec::new, locations::vertex_numbers);
    if let Some(geometry) = &geometry {
        let stages = (vertex.as_ref(), Some(geometry));
        let next = varyings::varyings(stages, [&mut in_vertex, &mut in_geometry], matching, log);
        geometry::built_in(geometry, fragment.as_ref(), next, [&mut in_vertex, &mut in_geometry]);
    }
    // The last stage before the fragments.
    let (outputs, in_outputs) = match &geometry {
        Some(geometry) => (Some(geometry), &mut in_geometry),
        None => (vertex.as_ref(), &mut in_vertex),
    };
    let inputs = fragment.as_ref();
    let next = varyings::varyings((outputs, inputs), [in_outputs, &mut in_fragment], matching, log);
    let next = cull_distances::passed((outputs, inputs), [in_outputs, &mut in_fragment], next, log);
    let next = layer_viewport::passed((outputs, inputs), [in_outputs, &mut in_fragment], next);
    varyings::invariant_coordinates(vertex.as_ref(), inputs, log);
    let captured = transform_feedback::captured(outputs, &bindings.capture, next, in_outputs, log);
    let varyings = varyings::slots(inputs, &in_fragment);
    let color_interpolation = varyings::colors(outputs, inputs, matching, log);
    let targets = match &fragment {
        Some(fragment) => locations::targets(fragment, bindings, &mut in_fragment, log),
        None => Vec::new(),
    };
    if let (Some(vertex), None) = (&vertex, &geometry) {
        check_position(vertex, &captured, log);
    }
    if log.has_errors() {
        return None;
    }

    let builtin_uniforms = uniforms::builtins(&stages, &used_elements);
    let mut samplers = Vec::new();
    let mut lower =
        |stage: StageToLower, units: Option<&StageUnits<'_>>, locations: &BindingMap| {
            lowered(stage, units?, locations, &mut words, &mut samplers, log)
        };
    let vertex = lower(StageToLower::Vertex, vertex.as_ref(), &in_vertex);
    let geometry = interface.and_then(|interface| {
        lower(StageToLower::Geometry(interface), geometry.as_ref(), &in_geometry)
    });
    let fragment = lower(StageToLower::Fragment, fragment.as_ref(), &in_fragment);
    Some(Program {
        vertex,
        geometry,
        fragment,
        attributes,
        vertex_numbers,
        uniforms: uniforms.list,
        explicit_locations: uniforms.explicit,
        members: blocks.members,
        blocks: blocks.list,
        builtin_uniforms,
        outputs: targets,
        varyings,
        captured,
        buffer_mode: bindings.capture.mode,
        samplers,
        color_interpolation,
        state: words.state,
        words: words.next,
    })
}

/// Shaders of GLSL ES go together with those of their own version (GLSL ES 3.00 section 1.5).
fn check_versions(shaders: &[&Arc<Unit>], log: &mut Log) {
    let mut versions = shaders.iter().map(|unit| unit.version);
    let Some(first) = versions.next() else { return };
    let other = versions.find(|other| *other != first && (first.is_es() || other.is_es()));
    if let Some(other) = other {
        let (first, other) = (first.title(), other.title());
        let message = format!("one shader is in {first} and one in {other}");
        let problem = Diagnostic::link_error(message).rule("GLSL ES 3.00 section 1.5");
        log.push(problem.help("begin all of them with the same `#version`"));
    }
}

/// The vertex stage must write the position.
fn check_position(vertex: &StageUnits<'_>, captured: &[Captured], log: &mut Log) {
    if vertex.used.iter().any(|v| &*v.name == "gl_Position" && v.written) {
        return;
    }
    let message = "the vertex shader never writes gl_Position";
    // Without it the position is undefined in GLSL ES and from 1.40 on; the versions between forbid
    // it.
    let is_legal = vertex
        .units
        .iter()
        .all(|unit| unit.version == Version::Es100 || unit.version >= Version::V140);
    let rule = "GLSL 1.30 section 7.1";
    if !is_legal {
        log.push(Diagnostic::link_error(message).rule(rule));
    } else if captured.is_empty() {
        // A program that only captures needs no position.
        log.push(Diagnostic::link_warning(message).rule(rule));
    }
}

/// The module of a stage; its words and samplers are appended to those of the program.
fn lowered(
    to_lower: StageToLower,
    of: &StageUnits<'_>,
    locations: &BindingMap,
    words: &mut Words,
    samplers: &mut Vec<SamplerSlot>,
    log: &mut Log,
) -> Option<Module> {
    let stage = of.stage;
    let mut work = log.work;
    let result =
        lower_stage(to_lower, &of.units, &of.reachable, locations, words.clone(), &mut work);
    log.work = work;
    match result {
        Ok(lowered) => {
            *words = lowered.words;
            let slots = lowered.samplers.into_iter();
            let active: BTreeSet<u32> = slots.clone().map(|(_, word, ..)| word).collect();
            if active.len() > usize::from(MAX_TEXTURE_IMAGE_UNITS) {
                let message = format!(
                    "the {} shader uses {} samplers; a stage has {MAX_TEXTURE_IMAGE_UNITS} \
                     texture image units",
                    stage_name(stage),
                    active.len()
                );
                log.push(Diagnostic::link_error(message).rule("GL 2.1 section 2.15.3"));
            }
            samplers.extend(slots.map(|(slot, word, dim, result)| SamplerSlot {
                stage,
                slot: slot.0,
                word,
                dim,
                result,
            }));
            Some(lowered.module)
        }
        Err(failure) => {
            let message = format!("{} shader: {}", stage_name(stage), failure.0);
            log.push(Diagnostic::link_error(message));
            None
        }
    }
}
