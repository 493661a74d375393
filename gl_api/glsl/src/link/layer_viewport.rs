//! `gl_Layer` and `gl_ViewportIndex` between the stages (ARB_fragment_layer_viewport): the fragment stage reads what the
//! stage before wrote, whether such a layer or viewport exists or not, and 0 if that writes none.

use super::stage::{BindingMap, StageUnits};
use crate::builtins::variable::Builtin;
use crate::hir::{Storage, Variable};
use crate::lower::Binding;

/// Slots of an integer.
const SLOTS: u16 = 2;

fn used<'a>(stage: Option<&StageUnits<'a>>, builtin: Builtin) -> Vec<&'a Variable> {
    stage.map_or_else(Vec::new, |stage| stage.with(|of| of == Storage::Builtin(builtin)))
}

/// Gives them slots from `next` on if both stages have them; the first slot after them.
pub fn passed(
    (writer, reader): (Option<&StageUnits<'_>>, Option<&StageUnits<'_>>),
    [in_writer, in_reader]: [&mut BindingMap; 2],
    mut next: u16,
) -> u16 {
    for builtin in [Builtin::Layer, Builtin::ViewportIndex] {
        let is_written = used(writer, builtin).iter().any(|variable| variable.written);
        if let (true, Some(read)) = (is_written, used(reader, builtin).first()) {
            in_writer.insert(read.name.clone(), Binding::Varying(Some(next)));
            in_reader.insert(read.name.clone(), Binding::Varying(Some(next)));
            next += SLOTS;
        }
    }
    next
}
