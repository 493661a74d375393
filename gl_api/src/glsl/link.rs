//! Shaders to a program (GL 2.1 section 2.15, GLSL 1.30 section 4.3): the stages' interfaces are
//! matched, locations and uniform words given, and both stages lowered.

use super::check::recursive_call;
use super::diagnostics::{Diagnostic, Log};
use super::hir::{Function, Storage, Unit, Variable};
use super::limits::{MAX_DRAW_BUFFERS, MAX_UNIFORM_WORDS, MAX_VARYING_FLOATS, MAX_VERTEX_ATTRIBS};
use super::lower::{self, Binding, Words, lower_stage, varying_slots};
use super::types::Type;
use super::version::stage_name;
use super::{Attribute, Bindings, Linked, Program, SamplerSlot, Shader, Stage, Uniform};
use crate::interface::{MAX_TEXTURE_IMAGE_UNITS, VARYING_USER};
use rasterizer::ir::{Interpolation, Module};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

type Locations = BTreeMap<Arc<str>, Binding>;

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

/// Links shaders into a program.
pub fn link(shaders: &[&Shader], bindings: &Bindings) -> Linked {
    let mut log = Log::default();
    let program = build(shaders, bindings, &mut log);
    let program = program.filter(|_| !log.has_errors());
    Linked { program, log: log.render(None) }
}

fn build(shaders: &[&Shader], bindings: &Bindings, log: &mut Log) -> Option<Program> {
    if shaders.is_empty() {
        log.push(Diagnostic::link_error("there is no shader to link"));
    }
    let vertex = collect(shaders, Stage::Vertex, log);
    let fragment = collect(shaders, Stage::Fragment, log);
    if log.has_errors() {
        return None;
    }
    let mut in_vertex = Locations::new();
    let mut in_fragment = Locations::new();
    let stages: Vec<&StageUnits<'_>> = vertex.iter().chain(&fragment).collect();
    let mut words = Words::default();
    let uniforms = uniforms(&stages, &mut words, log);
    for (name, word) in &uniforms.words {
        in_vertex.insert(name.clone(), Binding::Uniform(*word));
        in_fragment.insert(name.clone(), Binding::Uniform(*word));
    }
    let attributes = match &vertex {
        Some(vertex) => attributes(vertex, bindings, &mut in_vertex, log),
        None => Vec::new(),
    };
    varyings(vertex.as_ref(), fragment.as_ref(), &mut in_vertex, &mut in_fragment, log);
    if let Some(fragment) = &fragment {
        targets(fragment, bindings, &mut in_fragment, log);
    }
    if let Some(vertex) = &vertex {
        let position = vertex.used.iter().any(|v| &*v.name == "gl_Position" && v.written);
        if !position {
            let message = "the vertex shader never writes gl_Position";
            log.push(Diagnostic::link_warning(message).rule("GLSL 1.30 section 7.1"));
        }
    }
    if log.has_errors() {
        return None;
    }

    let mut samplers = Vec::new();
    let mut lower = |stage: &Option<StageUnits<'_>>, locations: &Locations, words: &mut Words| {
        let stage = stage.as_ref()?;
        match lower_stage(stage.stage, &stage.units, &stage.reachable, locations, words.clone()) {
            Ok(lowered) => {
                *words = lowered.words;
                let slots = lowered.samplers.into_iter();
                let stage = stage.stage;
                let active: BTreeSet<u32> = slots.clone().map(|(_, word)| word).collect();
                if active.len() > usize::from(MAX_TEXTURE_IMAGE_UNITS) {
                    let message = format!(
                        "the {} shader uses {} samplers; a stage has {MAX_TEXTURE_IMAGE_UNITS} \
                         texture image units",
                        stage_name(stage),
                        active.len()
                    );
                    log.push(Diagnostic::link_error(message).rule("GL 2.1 section 2.15.3"));
                }
                samplers.extend(slots.map(|(slot, word)| SamplerSlot {
                    stage,
                    slot: slot.0,
                    word,
                }));
                Some(lowered.module)
            }
            Err(failure) => {
                let stage = stage_name(stage.stage);
                let message = format!("{stage} shader: {}", failure.0);
                log.push(Diagnostic::link_error(message));
                None
            }
        }
    };
    let vertex: Option<Module> = lower(&vertex, &in_vertex, &mut words);
    let fragment: Option<Module> = lower(&fragment, &in_fragment, &mut words);
    Some(Program {
        vertex,
        fragment,
        attributes,
        uniforms: uniforms.list,
        samplers,
        state: words.state,
        words: words.next,
    })
}

/// The shaders of a stage, checked against each other; `None` if it has none.
fn collect<'a>(shaders: &[&'a Shader], stage: Stage, log: &mut Log) -> Option<StageUnits<'a>> {
    let name = stage_name(stage);
    let units: Vec<&Unit> =
        shaders.iter().map(|shader| &*shader.unit).filter(|unit| unit.stage == stage).collect();
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
        same_globals(&units, name, log);
    }
    let reachable = match lower::reachable(&units) {
        Ok(reachable) => reachable,
        Err(signature) => {
            let message = format!("{name} shader: `{signature}` is called and never defined");
            log.push(Diagnostic::link_error(message));
            return None;
        }
    };
    let mut order: Vec<(usize, u32)> = Vec::new();
    for (unit, function) in &reachable {
        order.extend(function.globals.iter().map(|&global| (*unit, global)));
    }
    order.sort_unstable();
    let mut used: Vec<&Variable> = Vec::new();
    let mut names: BTreeSet<&str> = BTreeSet::new();
    for (unit, global) in order {
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

/// Globals of the same name in several shaders of a stage are the same.
fn same_globals(units: &[&Unit], stage: &str, log: &mut Log) {
    let mut known: BTreeMap<&str, &Variable> = BTreeMap::new();
    for variable in units.iter().flat_map(|unit| &unit.globals) {
        let other = known.entry(&variable.name).or_insert(variable);
        if other.ty != variable.ty || other.storage != variable.storage {
            let message = format!(
                "`{}` is {} in one {stage} shader and {} in another",
                variable.name, other.ty, variable.ty
            );
            log.push(Diagnostic::link_error(message));
        }
    }
}

/// The uniforms of a program.
struct Uniforms {
    list: Vec<Uniform>,
    /// The first word of each variable.
    words: BTreeMap<Arc<str>, u32>,
}

fn uniforms(stages: &[&StageUnits<'_>], words: &mut Words, log: &mut Log) -> Uniforms {
    let mut all: Vec<(&Variable, Vec<u32>)> = Vec::new();
    let mut names: BTreeMap<&str, usize> = BTreeMap::new();
    for stage in stages {
        for variable in stage.with(|storage| storage == Storage::Uniform) {
            let initial = initial(variable);
            let Some(&index) = names.get(&*variable.name) else {
                names.insert(&variable.name, all.len());
                all.push((variable, initial));
                continue;
            };
            let (known, value) = &mut all[index];
            if known.ty != variable.ty {
                let message = format!(
                    "uniform `{}` is {} in the vertex stage and {} in the fragment stage",
                    variable.name, known.ty, variable.ty
                );
                log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3.5"));
            } else if known.init.is_none() {
                *value = initial;
            } else if variable.init.is_some() && *value != initial {
                let message = format!("uniform `{}` has two initial values", variable.name);
                log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3.5"));
            }
        }
    }
    let mut uniforms = Uniforms { list: Vec::new(), words: BTreeMap::new() };
    let mut location = 0;
    for (variable, initial) in &all {
        let count = variable.ty.scalars();
        if words.next.saturating_add(count) > MAX_UNIFORM_WORDS {
            let message = format!("the uniforms have more than {MAX_UNIFORM_WORDS} components");
            log.push(Diagnostic::link_error(message));
            return uniforms;
        }
        uniforms.words.insert(variable.name.clone(), words.next);
        let mut flat = Flat { list: &mut uniforms.list, location: &mut location, log };
        flat.add(&variable.name, &variable.ty, words.next, initial);
        words.next += count;
    }
    uniforms
}

fn initial(variable: &Variable) -> Vec<u32> {
    let words = variable.init.as_ref().and_then(|init| lower::constant(init, &[], &[]));
    words.unwrap_or_else(|| vec![0; variable.ty.scalars() as usize])
}

/// Takes structures apart into what GL lists.
struct Flat<'a> {
    list: &'a mut Vec<Uniform>,
    location: &'a mut u32,
    log: &'a mut Log,
}

impl Flat<'_> {
    fn add(&mut self, name: &str, ty: &Type, word: u32, initial: &[u32]) {
        let (element, array) = match ty {
            Type::Array(element, len) => (&**element, *len),
            other => (other, None),
        };
        if let Type::Struct(structure) = element {
            let size = structure.scalars as usize;
            for index in 0..array.unwrap_or(1) {
                let mut at = size * index as usize;
                for (field, ty) in &structure.fields {
                    let name = match array {
                        Some(_) => format!("{name}[{index}].{field}"),
                        None => format!("{name}.{field}"),
                    };
                    let count = ty.scalars() as usize;
                    self.add(&name, ty, word + at as u32, &initial[at..at + count]);
                    at += count;
                }
            }
            return;
        }
        let Some(data_type) = element.data_type() else {
            let message = format!("uniform `{name}`: {element} is not supported by DetGL yet");
            self.log.push(Diagnostic::link_error(message));
            return;
        };
        let location = *self.location;
        *self.location += array.unwrap_or(1);
        let (name, initial) = (name.to_owned(), initial.to_vec());
        self.list.push(Uniform { name, ty: data_type, array, location, word, initial });
    }
}

/// Gives attributes their locations: first those that were bound, then the others in order.
fn attributes(
    vertex: &StageUnits<'_>,
    bindings: &Bindings,
    locations: &mut Locations,
    log: &mut Log,
) -> Vec<Attribute> {
    let used = vertex.with(|storage| storage == Storage::Attribute);
    let columns = |variable: &Variable| variable.ty.columns().unwrap_or(1);
    let mut taken = [false; MAX_VERTEX_ATTRIBS as usize];
    let mut found: Vec<Option<u8>> = Vec::new();
    for variable in &used {
        let bound = bindings.attributes.get(&*variable.name).copied();
        found.push(bound);
        if let Some(first) = bound {
            let end = usize::from(first) + usize::from(columns(variable));
            match taken.get_mut(usize::from(first)..end) {
                Some(range) => range.fill(true),
                None => {
                    let message = format!(
                        "attribute `{}` is bound to location {first} and does not fit below {}",
                        variable.name, MAX_VERTEX_ATTRIBS
                    );
                    log.push(Diagnostic::link_error(message).rule("GL 2.1 section 2.15.3"));
                }
            }
        }
    }
    let mut attributes = Vec::new();
    for (variable, bound) in used.iter().zip(found) {
        let count = usize::from(columns(variable));
        let location = bound.or_else(|| {
            let free = taken.windows(count).position(|range| !range.contains(&true))?;
            taken[free..free + count].fill(true);
            Some(free as u8)
        });
        let Some(location) = location else {
            let message = format!(
                "attribute `{}` finds no location: there are {MAX_VERTEX_ATTRIBS}",
                variable.name
            );
            log.push(Diagnostic::link_error(message).rule("GL 2.1 section 2.15.3"));
            continue;
        };
        locations.insert(variable.name.clone(), Binding::Attribute(location));
        if let Some(ty) = variable.ty.data_type() {
            attributes.push(Attribute { name: variable.name.to_string(), ty, location });
        }
    }
    attributes
}

/// Matches what the vertex stage writes with what the fragment stage reads.
fn varyings(
    vertex: Option<&StageUnits<'_>>,
    fragment: Option<&StageUnits<'_>>,
    in_vertex: &mut Locations,
    in_fragment: &mut Locations,
    log: &mut Log,
) {
    let is_output = |storage| matches!(storage, Storage::Output(_));
    for variable in vertex.iter().flat_map(|stage| stage.declared()) {
        if is_output(variable.storage) {
            in_vertex.insert(variable.name.clone(), Binding::Varying(None));
        }
    }
    let Some(fragment) = fragment else { return };
    let (mut next, mut scalars) = (VARYING_USER, 0u32);
    for input in fragment.with(|storage| matches!(storage, Storage::Input(_))) {
        let name = &input.name;
        let output = vertex
            .and_then(|vertex| vertex.declared().find(|v| v.name == *name && is_output(v.storage)));
        let Some(output) = output else {
            let message =
                format!("the fragment shader reads `{name}`, which no vertex shader writes");
            log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3.6"));
            continue;
        };
        if output.ty != input.ty {
            let message = format!(
                "`{name}` is {} in the vertex shader and {} in the fragment shader",
                output.ty, input.ty
            );
            log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3.6"));
        } else if let (Storage::Output(a), Storage::Input(b)) = (output.storage, input.storage)
            && a != b
        {
            let word = |interpolation| match interpolation {
                Interpolation::Smooth => "smooth",
                Interpolation::NoPerspective => "noperspective",
                Interpolation::Flat => "flat",
            };
            let message = format!(
                "`{name}` is {} in the vertex shader and {} in the fragment shader",
                word(a),
                word(b)
            );
            log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3.7"));
        }
        scalars += input.ty.scalars();
        if scalars > u32::from(MAX_VARYING_FLOATS) {
            let message =
                format!("more than {MAX_VARYING_FLOATS} components pass between the stages");
            log.push(Diagnostic::link_error(message));
            return;
        }
        in_vertex.insert(name.clone(), Binding::Varying(Some(next)));
        in_fragment.insert(name.clone(), Binding::Varying(Some(next)));
        next += varying_slots(&input.ty.flat());
    }
}

/// Gives the outputs of the fragment stage their render targets.
fn targets(
    fragment: &StageUnits<'_>,
    bindings: &Bindings,
    locations: &mut Locations,
    log: &mut Log,
) {
    let outputs = fragment.with(|storage| storage == Storage::FragmentOutput);
    let builtin = ["gl_FragColor", "gl_FragData"];
    let old = fragment.used.iter().find(|v| v.written && builtin.contains(&&*v.name));
    if let (Some(old), Some(new)) = (old, outputs.first()) {
        let message = format!("both `{}` and the output `{}` are written", old.name, new.name);
        log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 7.2"));
    }
    let mut taken = [false; MAX_DRAW_BUFFERS as usize];
    let bound = |variable: &Variable| bindings.frag_data.get(&*variable.name).copied();
    for output in &outputs {
        let Some(target) = bound(output) else { continue };
        match taken.get_mut(usize::from(target)) {
            Some(taken) if !*taken => *taken = true,
            Some(_) => {
                let message = format!("two outputs are bound to colour {target}");
                log.push(Diagnostic::link_error(message));
            }
            None => {
                let message = format!(
                    "output `{}` is bound to colour {target}; there are {MAX_DRAW_BUFFERS}",
                    output.name
                );
                log.push(Diagnostic::link_error(message));
            }
        }
        locations.insert(output.name.clone(), Binding::Target(target));
    }
    for output in &outputs {
        if bound(output).is_some() {
            continue;
        }
        match taken.iter().position(|taken| !taken) {
            Some(free) => {
                taken[free] = true;
                locations.insert(output.name.clone(), Binding::Target(free as u8));
            }
            None => {
                let message = format!("more than {MAX_DRAW_BUFFERS} outputs");
                log.push(Diagnostic::link_error(message));
            }
        }
    }
}
