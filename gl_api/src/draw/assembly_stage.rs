//! Assembly programs (`ARB_vertex_program`, `ARB_fragment_program`) as stages of a draw, for which the program in use has no
//! stage of its own. Their uniform words lie behind those of the program.

use crate::assembly::{Position, Target};
use crate::base::error::Result;
use crate::context::Context;
use crate::draw::assembly_words::{put_rows, running};
use crate::draw::state_words::put_bindings;
use crate::glsl::SamplerSlot;
use rasterizer::driver::ShaderModule;
use rasterizer::ir::Expr;

/// When there are this many relocated modules, all are dropped.
const MAX_RELOCATED: usize = 64;

/// The stage of an assembly program, whose words lie behind those of other programs.
pub(crate) struct Assembled {
    pub module: ShaderModule,
    pub position: Position,
}

/// The assembly program that runs as a stage, if one does; its words and samplers are added.
pub(crate) fn assembled(
    context: &mut Context,
    target: Target,
    words: &mut Vec<u32>,
    samplers: &mut Vec<SamplerSlot>,
) -> Result<Option<Assembled>> {
    let Some(loaded) = running(context, target) else { return Ok(None) };
    let linked = &loaded.linked;
    let module = match target {
        Target::Vertex => linked.vertex_of(crate::draw::color_clamp::of_vertices(context)),
        Target::Fragment => &linked.fragment,
    };
    let Some(module) = module.clone() else { return Ok(None) };
    let first = words.len() as u32;
    words.extend_from_slice(&linked.words);
    let own = &mut words[first as usize..];
    put_bindings(context, own, &linked.program.state);
    put_rows(context, target, &loaded, own);
    let moved = linked.program.samplers.iter();
    samplers.extend(moved.map(|slot| SamplerSlot { word: slot.word + first, ..*slot }));
    let position = loaded.position;
    Ok(Some(Assembled { module: relocated(context, module, first)?, position }))
}

/// A module whose uniform words begin at `first`.
fn relocated(context: &mut Context, module: ShaderModule, first: u32) -> Result<ShaderModule> {
    if first == 0 {
        return Ok(module);
    }
    let moved = &mut context.recorder.moved;
    if let Some((.., known)) = moved.iter().find(|(of, by, _)| *by == first && *of == module) {
        return Ok(known.clone());
    }
    if moved.len() >= MAX_RELOCATED {
        moved.clear();
    }
    let mut farther = module.module().clone();
    for value in &mut farther.values {
        if let Expr::Uniform { word, .. } | Expr::UniformAt { base: word, .. } = value {
            *word += first;
        }
    }
    farther.uniform_words += first;
    let farther = ShaderModule::new(farther)
        .map_err(|error| crate::context::recorder::stages::internal(&error))?;
    moved.push((module, first, farther.clone()));
    Ok(farther)
}
