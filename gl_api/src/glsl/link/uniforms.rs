//! The uniforms of a program: which there are, their words, locations and initial values
//! (GLSL 1.30 section 4.3.5).

use super::StageUnits;
use crate::glsl::Uniform;
use crate::glsl::diagnostics::{Diagnostic, Log};
use crate::glsl::hir::{Storage, Variable};
use crate::glsl::limits::MAX_UNIFORM_WORDS;
use crate::glsl::lower::{self, Words};
use crate::glsl::types::Type;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The uniforms of a program.
pub struct Uniforms {
    /// What GL lists.
    pub list: Vec<Uniform>,
    /// The first word of each variable.
    pub words: BTreeMap<Arc<str>, u32>,
}

/// The uniforms that the stages name. One with an initializer counts even if nothing names it here:
/// any shader of the program may bring the value (GLSL 1.30 section 4.3.5).
pub fn uniforms(stages: &[&StageUnits<'_>], words: &mut Words, log: &mut Log) -> Uniforms {
    let mut all: Vec<(&Variable, Vec<u32>)> = Vec::new();
    let mut names: BTreeMap<&str, usize> = BTreeMap::new();
    let is_uniform = |storage| storage == Storage::Uniform;
    let named = stages.iter().flat_map(|stage| stage.with(is_uniform));
    let declared = || stages.iter().flat_map(|stage| stage.declared());
    let valued = declared().filter(|v| is_uniform(v.storage) && v.init.is_some());
    for variable in named.chain(valued) {
        if !names.contains_key(&*variable.name) {
            names.insert(&variable.name, all.len());
            all.push((variable, initial(variable)));
        }
    }
    let mut types: BTreeMap<&str, &Type> = BTreeMap::new();
    for variable in declared().filter(|variable| is_uniform(variable.storage)) {
        let ty = *types.entry(&variable.name).or_insert(&variable.ty);
        if *ty != variable.ty {
            let message = format!(
                "uniform `{}` is {ty} in one shader and {} in another",
                variable.name, variable.ty
            );
            log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3.5"));
            continue;
        }
        let Some(&index) = names.get(&*variable.name) else { continue };
        let (known, value) = &mut all[index];
        let mine = initial(variable);
        if known.init.is_none() && variable.init.is_some() {
            (*known, *value) = (variable, mine);
        } else if variable.init.is_some() && *value != mine {
            let message = format!("uniform `{}` has two initial values", variable.name);
            log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3.5"));
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
