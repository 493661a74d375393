//! `gl_CullDistance` between the stages (ARB_cull_distance).

use super::stage::{BindingMap, StageUnits};
use crate::builtins::variable::Builtin;
use crate::hir::{Storage, Variable};
use crate::language::stage_name;
use crate::limits::MAX_CULL_DISTANCES;
use crate::lower::Binding;
use crate::text::diagnostics::{Diagnostic, Log};
use crate::types::Type;

/// The elements of a variable of a stage, if it uses or declares the variable.
fn elements(stage: &StageUnits<'_>, builtin: Builtin) -> u32 {
    let length = |variable: &Variable| {
        if let Type::Array(_, len) = variable.ty { len.unwrap_or(0) } else { 0 }
    };
    let is_one = |variable: &&Variable| {
        variable.storage == Storage::Builtin(builtin)
            && (variable.references > 0 || variable.redeclared)
    };
    stage.declared().filter(is_one).map(length).max().unwrap_or(0)
}

/// Checks how many clip and cull distances a stage has together.
pub fn check(stage: &StageUnits<'_>, log: &mut Log) {
    let [clip, cull] = [Builtin::ClipDistance, Builtin::CullDistance].map(|of| elements(stage, of));
    if cull > 0 && clip + cull > MAX_CULL_DISTANCES.into() {
        let message = format!(
            "the {} shader has {clip} clip distances and {cull} cull distances; \
             gl_MaxCombinedClipAndCullDistances is {MAX_CULL_DISTANCES}",
            stage_name(stage.stage)
        );
        log.push(Diagnostic::link_error(message).rule("ARB_cull_distance"));
    }
}

/// Gives the distances slots from `next` on if the fragment stage reads them; the first slot after them.
pub fn passed(
    (writer, reader): (Option<&StageUnits<'_>>, Option<&StageUnits<'_>>),
    [in_writer, in_reader]: [&mut BindingMap; 2],
    next: u16,
    log: &mut Log,
) -> u16 {
    let count = |stage: Option<&StageUnits<'_>>| {
        stage.map_or(0, |stage| elements(stage, Builtin::CullDistance))
    };
    let (written, read) = (count(writer), count(reader));
    if written == 0 || read == 0 {
        return next;
    }
    let is_sized = |stage: Option<&StageUnits<'_>>| {
        let mut declared = stage.into_iter().flat_map(|stage| stage.declared());
        declared.any(|variable| &*variable.name == "gl_CullDistance" && variable.redeclared)
    };
    if written != read && is_sized(writer) && is_sized(reader) {
        let message = format!(
            "`gl_CullDistance` has {read} elements in the fragment shader and {written} in the stage before"
        );
        log.push(Diagnostic::link_error(message).rule("ARB_cull_distance"));
    }
    in_writer.insert("gl_CullDistance".into(), Binding::Varying(Some(next)));
    in_reader.insert("gl_CullDistance".into(), Binding::Varying(Some(next)));
    next + written.max(read) as u16
}
