//! The locations of what passes between stages (ARB_separate_shader_objects, sections 4.3.8.1 and 4.3.8.2).

use super::stage::StageUnits;
use crate::hir::{Storage, Variable};
use crate::language::stage_name;
use crate::limits::MAX_STAGE_COMPONENTS;
use crate::text::diagnostics::{Diagnostic, Log};
use crate::types::Type;
use rasterizer::ir::Stage;

const RULE: &str = "ARB_separate_shader_objects, section 4.3.8";

/// How many locations there are.
const LIMIT: u32 = MAX_STAGE_COMPONENTS as u32 / 4;

/// Checks that no two inputs of a stage, nor two outputs, share a location, and that all are below the limit.
pub fn check(stage: &StageUnits<'_>, log: &mut Log) {
    let per_vertex = stage.stage == Stage::Geometry;
    check_one(stage, ("inputs", per_vertex), |storage| matches!(storage, Storage::Input(_)), log);
    check_one(stage, ("outputs", false), |storage| matches!(storage, Storage::Output(_)), log);
}

fn check_one(
    stage: &StageUnits<'_>,
    (what, per_vertex): (&str, bool),
    is_one: impl Fn(Storage) -> bool,
    log: &mut Log,
) {
    let mut owners: [Option<&Variable>; LIMIT as usize] = [None; LIMIT as usize];
    for variable in stage.with(is_one) {
        let Some(first) = variable.interface_qualifiers.location else { continue };
        let ty = match &variable.ty {
            Type::Array(element, _) if per_vertex => element,
            ty => ty,
        };
        let (name, end) = (variable.public_name(), first.saturating_add(ty.locations()));
        if end > LIMIT {
            let message = format!(
                "`{name}` has the locations {first} to {} of the {} shader, which has {LIMIT}",
                end - 1,
                stage_name(stage.stage)
            );
            log.push(Diagnostic::link_error(message).rule(RULE));
            continue;
        }
        for (location, owner) in (0..end).zip(&mut owners).skip(first as usize) {
            if let Some(other) = owner.replace(variable) {
                let other = other.public_name();
                let message = format!(
                    "the {what} `{other}` and `{name}` of the {} shader both have location {location}",
                    stage_name(stage.stage)
                );
                log.push(Diagnostic::link_error(message).rule(RULE));
                break;
            }
        }
    }
}
