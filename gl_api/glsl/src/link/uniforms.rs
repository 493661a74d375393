//! The uniforms of a program: the active uniforms, their words, locations and initial values (GLSL
//! 1.30 section 4.3.5).

use super::stage::StageUnits;
use super::uniform_locations::UniformLocations;
use crate::ast::Precision;
use crate::builtins::variable::Builtin;
use crate::hir::{Storage, Variable};
use crate::language::{Version, stage_name};
use crate::limits::{MAX_UNIFORM_COMPONENTS, MAX_UNIFORM_WORDS};
use crate::lower::{self, Words};
use crate::program::{BuiltinUniform, Uniform};
use crate::text::diagnostics::{Diagnostic, Log};
use crate::types::Type;
use crate::work::Work;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// The uniforms of a program.
pub struct Uniforms {
    /// The uniforms, as GL lists them.
    pub list: Vec<Uniform>,
    /// The first word of each variable.
    pub words: BTreeMap<Arc<str>, u32>,
    /// The locations that `layout(location = n)` gives.
    pub explicit: Vec<Range<u32>>,
}

/// The uniforms that the stages reference. One with an initializer counts even if this shader does
/// not reference it: any shader of the program may have the initializer (GLSL 1.30 section 4.3.5).
pub fn uniforms(
    stages: &[&StageUnits<'_>],
    used_elements: &UsedElements<'_>,
    words: &mut Words,
    log: &mut Log,
) -> Uniforms {
    let mut all: Vec<(&Variable, Vec<u32>)> = Vec::new();
    let mut names: BTreeMap<&str, usize> = BTreeMap::new();
    let is_uniform =
        |variable: &&Variable| variable.storage == Storage::Uniform && variable.block.is_none();
    let named = stages.iter().flat_map(|stage| stage.used.iter().copied()).filter(is_uniform);
    let declared = || stages.iter().flat_map(|stage| stage.declared());
    let valued = declared().filter(|v| is_uniform(v) && v.init.is_some());
    for variable in named.chain(valued) {
        if !names.contains_key(&*variable.name) {
            names.insert(&variable.name, all.len());
            all.push((variable, initial(variable, &mut log.work)));
        }
    }
    let units = || stages.iter().flat_map(|stage| &stage.units);
    let is_es = units().all(|unit| unit.version.is_es());
    let is_es_300 = units().all(|unit| unit.version == Version::Es300);
    // The first declaration of each name.
    let mut first: BTreeMap<&str, usize> = BTreeMap::new();
    let every: Vec<&Variable> = declared().filter(is_uniform).collect();
    for (at, variable) in every.iter().enumerate() {
        let ty = &every[*first.entry(&variable.name).or_insert(at)].ty;
        if *ty != variable.ty {
            let message = format!(
                "uniform `{}` is {ty} in one shader and {} in another",
                variable.name, variable.ty
            );
            log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3.5"));
            continue;
        }
        let pair = [every[first[&*variable.name]], variable];
        let precisions = pair.map(|variable| variable.interface_qualifiers.precision);
        // Programs of GLSL ES 1.00 rely on other precisions where one shader does not use the uniform.
        let counts = is_es_300 || pair.iter().all(|variable| variable.references > 0);
        if let [Some(a), Some(b)] = precisions
            && a != b
            && is_es
            && counts
        {
            let (name, [a, b]) = (&variable.name, [a, b].map(Precision::word));
            let message = format!("uniform `{name}` is {a} in one shader and {b} in another");
            log.push(Diagnostic::link_error(message).rule("GLSL ES 3.00 section 4.3.5"));
            continue;
        }
        if is_es && counts && pair[0].ty.differs_in_precision(&pair[1].ty) {
            let name = &variable.name;
            let message =
                format!("members of uniform `{name}` have other precisions in another shader");
            log.push(Diagnostic::link_error(message).rule("GLSL ES 3.00 section 4.3.5"));
            continue;
        }
        let Some(&index) = names.get(&*variable.name) else { continue };
        let (known, value) = &mut all[index];
        let bound = [&**known, variable].map(|of| of.interface_qualifiers.bound());
        if let [Some(a), Some(b)] = bound
            && a != b
        {
            let message = format!("uniform `{}` has the bindings {a} and {b}", variable.name);
            log.push(Diagnostic::link_error(message).rule("ARB_shading_language_420pack"));
        } else if let [None, Some(_)] = bound {
            (*known, *value) = (variable, initial(variable, &mut log.work));
            continue;
        }
        let mine = initial(variable, &mut log.work);
        if known.init.is_none() && variable.init.is_some() {
            (*known, *value) = (variable, mine);
        } else if variable.init.is_some() && *value != mine {
            let message = format!("uniform `{}` has two initial values", variable.name);
            log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3.5"));
        }
    }
    if is_es {
        check_components(stages, used_elements, log);
    }
    let mut locations = UniformLocations::of(&every, log);
    let mut uniforms = Uniforms { list: Vec::new(), words: BTreeMap::new(), explicit: Vec::new() };
    for (variable, initial) in &all {
        let count = variable.ty.scalars();
        if words.next.saturating_add(count) > MAX_UNIFORM_WORDS {
            let message = format!("the uniforms have more than {MAX_UNIFORM_WORDS} components");
            log.push(Diagnostic::link_error(message));
            return uniforms;
        }
        uniforms.words.insert(variable.name.clone(), words.next);
        let mut leaves = Vec::new();
        add_leaves(&variable.name, &variable.ty, used_elements.get(variable), 0, &mut leaves);
        let mut explicit = locations.explicit(&variable.name);
        for Leaf { name, ty, array, at, scalars } in leaves {
            let Some(data_type) = ty.data_type() else {
                let message = format!("uniform `{name}`: {ty} is not supported by DetGL yet");
                log.push(Diagnostic::link_error(message));
                continue;
            };
            let word = words.next + at as u32;
            let initial = initial[at..at + scalars].to_vec();
            let count = array.unwrap_or(1);
            let location = match &mut explicit {
                Some(next) => std::mem::replace(next, *next + count),
                None => locations.free(count),
            };
            uniforms.list.push(Uniform { name, ty: data_type, array, location, word, initial });
        }
        words.next += count;
    }
    locations.check_end(log);
    uniforms.explicit = locations.into_ranges();
    uniforms
}

/// Reports a stage that uses more components than there are. Desktop GL takes more, as other drivers do.
fn check_components(stages: &[&StageUnits<'_>], used_elements: &UsedElements<'_>, log: &mut Log) {
    for stage in stages {
        let mut leaves = Vec::new();
        for variable in stage.with(|storage| storage == Storage::Uniform) {
            if variable.block.is_none() {
                add_leaves("", &variable.ty, used_elements.get(variable), 0, &mut leaves);
            }
        }
        let numbers = leaves.iter().filter(|leaf| !leaf.ty.has_sampler());
        let count = numbers.fold(0usize, |sum, leaf| sum.saturating_add(leaf.scalars));
        if count > MAX_UNIFORM_COMPONENTS as usize {
            let message = format!(
                "the {} shader uses {count} components of uniforms; a stage has {MAX_UNIFORM_COMPONENTS}",
                stage_name(stage.stage)
            );
            log.push(Diagnostic::link_error(message).rule("OpenGL ES 3.0 section 2.12.6"));
        }
    }
}

fn initial(variable: &Variable, work: &mut Work) -> Vec<u32> {
    if let Some(binding) = variable.interface_qualifiers.bound() {
        // The units of an array follow each other.
        return (0..variable.ty.scalars()).map(|at| binding.saturating_add(at)).collect();
    }
    let words = variable.init.as_ref().and_then(|init| lower::constant(init, &[], &[], work));
    words.unwrap_or_else(|| vec![0; variable.ty.scalars() as usize])
}

/// The built-in uniforms that the stages reference.
pub fn builtins(
    stages: &[&StageUnits<'_>],
    used_elements: &UsedElements<'_>,
) -> Vec<BuiltinUniform> {
    let is_state =
        |storage| matches!(storage, Storage::Builtin(Builtin::State(_) | Builtin::States(_)));
    let mut named: Vec<&Variable> = Vec::new();
    for variable in stages.iter().flat_map(|stage| stage.with(is_state)) {
        if !named.iter().any(|known| known.name == variable.name) {
            named.push(variable);
        }
    }
    let mut leaves = Vec::new();
    for variable in named {
        add_leaves(&variable.name, &variable.ty, used_elements.get(variable), 0, &mut leaves);
    }
    let listed = |leaf: Leaf<'_>| {
        let ty = leaf.ty.data_type()?;
        Some(BuiltinUniform { name: leaf.name, ty, array: leaf.array })
    };
    leaves.into_iter().filter_map(listed).collect()
}

/// A leaf of a variable, as GL lists it: no structure.
struct Leaf<'a> {
    name: String,
    /// Its type, or that of its elements.
    ty: &'a Type,
    array: Option<u32>,
    /// Its first scalar in the variable, and how many scalars it has.
    at: usize,
    scalars: usize,
}

/// By the name of an array: how many of its elements the shaders of a program reference.
pub struct UsedElements<'a>(BTreeMap<&'a str, u32>);

impl<'a> UsedElements<'a> {
    /// Counts the elements of all arrays that the stages declare.
    pub fn of(stages: &[&StageUnits<'a>]) -> Self {
        let mut used_elements = BTreeMap::new();
        for variable in stages.iter().flat_map(|stage| stage.declared()) {
            if variable.references > 0 && matches!(variable.ty, Type::Array(..)) {
                let all = variable.used_elements().unwrap_or(u32::MAX);
                let most = used_elements.entry(&*variable.name).or_insert(all);
                *most = all.max(*most);
            }
        }
        Self(used_elements)
    }

    fn get(&self, variable: &Variable) -> u32 {
        self.0.get(&*variable.name).copied().unwrap_or(u32::MAX)
    }
}

/// Adds the leaves of a variable; at most `used` elements of its outermost array.
fn add_leaves<'a>(name: &str, ty: &'a Type, reach: u32, at: usize, leaves: &mut Vec<Leaf<'a>>) {
    let (element, array) = match ty {
        Type::Array(element, len) => (&**element, len.map(|len| len.min(reach))),
        other => (other, None),
    };
    let each = element.scalars() as usize;
    let count = array.unwrap_or(1);
    let nth = |index: u32| match array {
        Some(_) => format!("{name}[{index}]"),
        None => name.to_owned(),
    };
    match element {
        Type::Struct(structure) => {
            let mut at = at;
            for index in 0..count {
                for (field, ty) in &structure.fields {
                    let name = format!("{}.{field}", nth(index));
                    add_leaves(&name, ty, u32::MAX, at, leaves);
                    at += ty.scalars() as usize;
                }
            }
        }
        Type::Array(..) => {
            for index in 0..count {
                add_leaves(&nth(index), element, u32::MAX, at + index as usize * each, leaves);
            }
        }
        Type::Void | Type::Vector(..) | Type::Matrix(..) | Type::Sampler(_) | Type::Error => {
            let (name, scalars) = (name.to_owned(), each * count as usize);
            leaves.push(Leaf { name, ty: element, array, at, scalars });
        }
    }
}
