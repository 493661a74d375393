//! The block `gl_PerVertex` between stages: if a shader redeclares it, all that use it do, and alike
//! (GLSL 4.10 section 7.1, which says what 1.50 means).

use super::Matching;
use super::stage::StageUnits;
use crate::builtins::variable::PER_VERTEX;
use crate::hir::Unit;
use crate::text::diagnostics::{Diagnostic, Log};
use std::collections::BTreeSet;
use std::sync::Arc;

/// What a shader has of one interface: its redeclaration, and whether it uses a member.
struct Use<'a> {
    declared: &'a Option<BTreeSet<Arc<str>>>,
    is_used: bool,
}

fn is_used(unit: &Unit, prefix: &str) -> bool {
    unit.globals.iter().any(|global| {
        let member = global.name.strip_prefix(prefix);
        global.references > 0 && member.is_some_and(|member| PER_VERTEX.contains(&member))
    })
}

/// Checks the outputs of the vertex stage with the inputs of the geometry stage, and the outputs of
/// the geometry stage.
pub fn check(
    vertex: Option<&StageUnits<'_>>,
    geometry: Option<&StageUnits<'_>>,
    matching: Matching,
    log: &mut Log,
) {
    if matching == Matching::Pipeline {
        return;
    }
    let written = |unit: &Unit| is_used(unit, "");
    let mut passed: Vec<Use<'_>> = Vec::new();
    let [vertex, geometry] =
        [vertex, geometry].map(|stage| stage.map_or(&[][..], |stage| &stage.units));
    for unit in vertex {
        passed.push(Use { declared: &unit.per_vertex.outputs, is_used: written(unit) });
    }
    for unit in geometry {
        let is_used = is_used(unit, "gl_in.");
        passed.push(Use { declared: &unit.per_vertex.inputs, is_used });
    }
    let made = geometry
        .iter()
        .map(|unit| Use { declared: &unit.per_vertex.outputs, is_used: written(unit) });
    let is_without = |unit: &Use<'_>| unit.is_used && unit.declared.is_none();
    let has_both = !vertex.is_empty() && !geometry.is_empty();
    if matching == Matching::Part && has_both && passed.iter().any(is_without) {
        let message = "a stage of a separable program uses members of `gl_PerVertex` that pass to another one, and \
                       does not redeclare that block";
        let problem = Diagnostic::link_error(message);
        log.push(problem.rule("ARB_separate_shader_objects, section 2.14.PPO"));
    }
    for interface in [passed, made.collect()] {
        let Some(first) = interface.iter().find_map(|unit| unit.declared.as_ref()) else {
            continue;
        };
        let fits = |unit: &Use<'_>| match unit.declared {
            Some(declared) => declared == first,
            None => !unit.is_used,
        };
        if !interface.iter().all(fits) {
            let message = "`gl_PerVertex` is redeclared in one shader, and not, or with other \
                           members, in another that uses it";
            log.push(Diagnostic::link_error(message).rule("GLSL 4.10 section 7.1"));
        }
    }
}
