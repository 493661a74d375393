//! Shaders to a program (GL 2.1 section 2.15, GLSL 1.30 section 4.3): the stages' interfaces are
//! matched, locations and uniform words given, and both stages lowered.

mod blocks;
mod globals;
mod locations;
mod std140;
mod transform_feedback;
mod uniforms;
mod varyings;

use crate::hir::recursive_call;
use crate::hir::{Function, Storage, Unit, Variable};
use crate::interface::MAX_TEXTURE_IMAGE_UNITS;
use crate::language::{Version, stage_name};
use crate::lower::{self, Binding, Words, lower_stage};
use crate::program::{Bindings, Captured, Linked, Program, SamplerSlot};
use crate::text::diagnostics::{Diagnostic, Log};
use rasterizer::ir::Module;
use rasterizer::ir::Stage;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

type BindingMap = BTreeMap<Arc<str>, Binding>;

/// The shaders of one stage.
struct StageUnits<'a> {
    stage: Stage,
    units: Vec<&'a Unit>,
    /// What `main` reaches.
    reachable: Vec<(usize, &'a Function)>,
    /// The globals it names, each once by name, in order.
    used: Vec<&'a Variable>,
}

impl<'a> StageUnits<'a> {
    /// Every global of the stage.
    fn declared(&self) -> impl Iterator<Item = &'a Variable> {
        self.units.iter().flat_map(|unit| unit.globals.iter())
    }

    fn with(&self, test: impl Fn(Storage) -> bool) -> Vec<&'a Variable> {
        self.used.iter().copied().filter(|variable| test(variable.storage)).collect()
    }
}

/// Links shaders into a program; of none, the program leaves everything to the fixed function.
pub fn link(shaders: &[&Arc<Unit>], bindings: &Bindings) -> Linked {
    let mut log = Log::default();
    let program = build(shaders, bindings, &mut log);
    let program = program.filter(|_| !log.has_errors());
    Linked { program, log: log.render(None) }
}

fn build(shaders: &[&Arc<Unit>], bindings: &Bindings, log: &mut Log) -> Option<Program> {
    let units = globals::unify_globals(shaders.iter().map(|shader| Arc::clone(shader)));
    let vertex = stage_units(&units, Stage::Vertex, log);
    let fragment = stage_units(&units, Stage::Fragment, log);
    if log.has_errors() {
        return None;
    }
    let mut in_vertex = BindingMap::new();
    let mut in_fragment = BindingMap::new();
    let stages: Vec<&StageUnits<'_>> = vertex.iter().chain(&fragment).collect();
    let mut words = Words::default();
    let used_elements = uniforms::UsedElements::of(&stages);
    let uniforms = uniforms::uniforms(&stages, &used_elements, &mut words, log);
    let blocks = blocks::blocks(&stages, &mut words, log);
    for (name, word) in uniforms.words.iter().chain(&blocks.words) {
        in_vertex.insert(name.clone(), Binding::Uniform(*word));
        in_fragment.insert(name.clone(), Binding::Uniform(*word));
    }
    let attributes = match &vertex {
        Some(vertex) => locations::attributes(vertex, bindings, &mut in_vertex, log),
        None => Vec::new(),
    };
    let (outputs, inputs) = (vertex.as_ref(), fragment.as_ref());
    let next = varyings::varyings(outputs, inputs, &mut in_vertex, &mut in_fragment, log);
    let captured =
        transform_feedback::captured(outputs, &bindings.capture, next, &mut in_vertex, log);
    let varyings = varyings::slots(inputs, &in_fragment);
    let color_interpolation = varyings::colors(outputs, inputs, log);
    let targets = match &fragment {
        Some(fragment) => locations::targets(fragment, bindings, &mut in_fragment, log),
        None => Vec::new(),
    };
    if let Some(vertex) = &vertex {
        check_position(vertex, &captured, log);
    }
    if log.has_errors() {
        return None;
    }

    let builtin_uniforms = uniforms::builtins(&stages, &used_elements);
    let mut samplers = Vec::new();
    let mut lower = |stage: Option<&StageUnits<'_>>, locations: &BindingMap| {
        lowered(stage?, locations, &mut words, &mut samplers, log)
    };
    let vertex = lower(vertex.as_ref(), &in_vertex);
    let fragment = lower(fragment.as_ref(), &in_fragment);
    Some(Program {
        vertex,
        fragment,
        attributes,
        uniforms: uniforms.list,
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

/// The vertex stage writes the position.
fn check_position(vertex: &StageUnits<'_>, captured: &[Captured], log: &mut Log) {
    if vertex.used.iter().any(|v| &*v.name == "gl_Position" && v.written) {
        return;
    }
    let message = "the vertex shader never writes gl_Position";
    // What is seen is undefined in GLSL ES and from 1.40 on; those between forbid it.
    let is_legal = vertex
        .units
        .iter()
        .all(|unit| unit.version == Version::Es100 || unit.version >= Version::V140);
    let rule = "GLSL 1.30 section 7.1";
    if !is_legal {
        log.push(Diagnostic::link_error(message).rule(rule));
    } else if captured.is_empty() {
        // What is captured need not be seen.
        log.push(Diagnostic::link_warning(message).rule(rule));
    }
}

/// The module of a stage; its words and samplers come to those that there are.
fn lowered(
    of: &StageUnits<'_>,
    locations: &BindingMap,
    words: &mut Words,
    samplers: &mut Vec<SamplerSlot>,
    log: &mut Log,
) -> Option<Module> {
    let stage = of.stage;
    match lower_stage(stage, &of.units, &of.reachable, locations, words.clone()) {
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

/// The shaders of a stage, checked against each other; `None` if it has none.
fn stage_units<'a>(units: &'a [Arc<Unit>], stage: Stage, log: &mut Log) -> Option<StageUnits<'a>> {
    let name = stage_name(stage);
    let units: Vec<&Unit> =
        units.iter().map(|unit| &**unit).filter(|unit| unit.stage == stage).collect();
    if units.is_empty() {
        return None;
    }
    let mut bodies: BTreeSet<String> = BTreeSet::new();
    for function in units.iter().flat_map(|unit| &unit.functions) {
        if function.body.is_some() {
            let signature = function.signature();
            if !bodies.insert(signature) {
                let signature = function.signature();
                let message = format!("`{signature}` is defined in two {name} shaders");
                log.push(Diagnostic::link_error(message));
            }
        }
    }
    if !bodies.contains("main()") {
        let message = format!("no {name} shader has a function `main`");
        log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 6.1"));
        return None;
    }
    if units.len() > 1 {
        if let Some((name, _)) = recursive_call(&merged(&units)) {
            let message = format!("`{name}` calls itself, directly or through others");
            log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 6.1"));
            return None;
        }
        globals::same_globals(&units, name, log);
    }
    let reachable = lower::reachable(&units);
    let mut used: Vec<&Variable> = Vec::new();
    let mut names: BTreeSet<&str> = BTreeSet::new();
    for (unit, global) in lower::named_globals(&units, &reachable) {
        let variable = &units[unit].globals[global as usize];
        if names.insert(&variable.name) {
            used.push(variable);
        }
    }
    Some(StageUnits { stage, units, reachable, used })
}

/// The functions of several units as those of one.
fn merged(units: &[&Unit]) -> Vec<Function> {
    let mut all: Vec<Function> = Vec::new();
    for unit in units {
        let first = all.len() as u32;
        for function in &unit.functions {
            let mut function = function.clone();
            function.calls.iter_mut().for_each(|(call, _)| *call += first);
            all.push(function);
        }
    }
    all
}
