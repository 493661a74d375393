//! The shaders of one stage, and the checks across them (GLSL 1.30 sections 4.3 and 6.1).

use super::globals;
use crate::hir::{Function, Storage, Unit, Variable, recursive_call};
use crate::language::stage_name;
use crate::lower::{self, Binding};
use crate::text::diagnostics::{Diagnostic, Log};
use rasterizer::ir::Stage;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What the linker assigned to the variables of a stage, by name.
pub type BindingMap = BTreeMap<Arc<str>, Binding>;

/// The shaders of one stage.
pub struct StageUnits<'a> {
    /// The stage.
    pub stage: Stage,
    /// The shaders.
    pub units: Vec<&'a Unit>,
    /// The functions that `main` reaches, and their units.
    pub reachable: Vec<(usize, &'a Function)>,
    /// The globals that these reference, each once by name, in order.
    pub used: Vec<&'a Variable>,
}

impl<'a> StageUnits<'a> {
    /// Every global of the stage.
    pub fn declared(&self) -> impl Iterator<Item = &'a Variable> {
        self.units.iter().flat_map(|unit| unit.globals.iter())
    }

    /// The referenced globals of some storage.
    pub fn with(&self, test: impl Fn(Storage) -> bool) -> Vec<&'a Variable> {
        self.used.iter().copied().filter(|variable| test(variable.storage)).collect()
    }
}

/// The shaders of a stage, checked against each other; `None` if it has none.
pub fn stage_units<'a>(
    units: &'a [Arc<Unit>],
    stage: Stage,
    log: &mut Log,
) -> Option<StageUnits<'a>> {
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
        globals::same_coordinates(&units, log);
        globals::same_depths(&units, log);
    }
    if stage == Stage::Geometry {
        globals::sized_inputs(&units, log);
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
