//! Which assembly programs a draw runs, and the uniform words of their parameters.

use crate::assembly::layout::Row;
use crate::assembly::lower::stage;
use crate::assembly::program::Target;
use crate::base::constants::enum_name;
use crate::base::error::{Result, invalid_operation};
use crate::context::Context;
use crate::objects::assemblies::{Assembly, AssemblyExecutable, TARGET};
use crate::state::enable::Flag;
use rasterizer::ir::Stage;
use std::sync::Arc;

/// Whether the program in use has a stage: it comes before assembly programs.
fn in_use_has(context: &Context, target: Target) -> bool {
    context.executable().is_some_and(|linked| match stage(target) {
        Stage::Vertex => linked.vertex.is_some(),
        Stage::Fragment => linked.fragment.is_some(),
        // No assembly program is of this stage.
        Stage::Geometry => false,
    })
}

/// The assembly program that is enabled for a stage which the program in use lacks.
fn enabled(context: &Context, target: Target) -> Option<&Assembly> {
    let flag = match target {
        Target::Vertex => Flag::VertexProgram,
        Target::Fragment => Flag::FragmentProgram,
    };
    let runs = context.state.enables.has(flag) && !in_use_has(context, target);
    let bound = &context.state.assembly.bound[target as usize];
    runs.then(|| context.objects.assembly(target, bound))
}

/// The assembly program that runs as a stage.
pub(crate) fn running(context: &Context, target: Target) -> Option<Arc<AssemblyExecutable>> {
    enabled(context, target)?.loaded.clone()
}

/// Whether vertices go through a program, an assembly program or another.
pub(crate) fn has_vertex_program(context: &Context) -> bool {
    in_use_has(context, Target::Vertex) || enabled(context, Target::Vertex).is_some()
}

/// Whether a program makes the colours of fragments.
pub(crate) fn has_fragment_program(context: &Context) -> bool {
    in_use_has(context, Target::Fragment) || enabled(context, Target::Fragment).is_some()
}

/// Checks that what is enabled was loaded.
///
/// # Errors
/// `GL_INVALID_OPERATION` for a program without a text.
pub(crate) fn check(context: &Context) -> Result<()> {
    for target in [Target::Vertex, Target::Fragment] {
        if enabled(context, target).is_some_and(|program| program.loaded.is_none()) {
            let name = context.state.assembly.bound[target as usize].name();
            let cap = enum_name(TARGET.encode(target));
            return invalid_operation(
                target.section(),
                format!(
                    "{cap} is enabled, but no text was loaded into program {name} that is \
                     bound there: see glProgramStringARB"
                ),
            );
        }
    }
    Ok(())
}

/// Fills in what a program's words take from its parameters and from the state, which is there
/// already.
pub(crate) fn put_rows(
    context: &Context,
    target: Target,
    loaded: &AssemblyExecutable,
    words: &mut [u32],
) {
    let state = &context.state.assembly;
    let env = &state.env[target as usize];
    let local = &context.objects.assembly(target, &state.bound[target as usize]).local;
    for (first, row) in &loaded.rows {
        let from = |all: &[[f32; 4]], number: u16| {
            let values = all.get(usize::from(number)).copied().unwrap_or_default();
            values.map(|value| Some(value.to_bits()))
        };
        let values = match row {
            Row::Env(number) => from(env, *number),
            Row::Local(number) => from(local, *number),
            Row::Words(places) => places.map(|place| words.get(place? as usize).copied()),
        };
        for (word, value) in words.iter_mut().skip(*first as usize).zip(values) {
            *word = value.unwrap_or(*word);
        }
    }
}
