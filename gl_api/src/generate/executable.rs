//! Linked programs and assembly programs to the driver's shader modules.

use crate::assembly::Loaded;
use crate::generate::fixed::clamp::{clamp_emitted_colors, clamp_vertex_colors};
use crate::glsl;
use crate::objects::assemblies::AssemblyExecutable;
use crate::objects::blocks::BlockState;
use crate::objects::programs::{LinkSources, Linked};
use rasterizer::driver::ShaderModule;
use rasterizer::ir::{Expr, Input, IrError, Module};
use std::sync::Arc;

/// The attributes that a vertex stage reads, bit by location.
fn read_attributes(module: &Module) -> u64 {
    let mut read = 0;
    for value in &module.values {
        if let Expr::Input(Input::Attribute { location, .. }) = value {
            read |= 1 << location;
        }
    }
    read
}

/// The executable of a linked program.
pub(crate) fn executable(
    mut program: glsl::Program,
    sources: Arc<LinkSources>,
) -> Result<Linked, IrError> {
    let module = |module: &Option<Module>| module.clone().map(ShaderModule::new).transpose();
    // Of two stages before the rasterizer, the last one's colours are clamped.
    let unclamped = (program.vertex.clone(), program.geometry.clone());
    let clamps_vertex =
        program.geometry.is_none() && program.vertex.as_mut().is_some_and(clamp_vertex_colors);
    let clamps_geometry = program.geometry.as_mut().is_some_and(clamp_emitted_colors);
    let (vertex, fragment) = (module(&program.vertex)?, module(&program.fragment)?);
    let geometry = module(&program.geometry)?;
    let unclamped_vertex = if clamps_vertex { module(&unclamped.0)? } else { vertex.clone() };
    let unclamped_geometry = if clamps_geometry { module(&unclamped.1)? } else { geometry.clone() };
    let mut words = vec![0; program.words as usize];
    for uniform in &program.uniforms {
        let place = words.get_mut(uniform.word as usize..).unwrap_or_default();
        for (word, initial) in place.iter_mut().zip(&uniform.initial) {
            *word = *initial;
        }
    }
    let blocks = BlockState::of(&program);
    let attributes = vertex.as_ref().map_or(0, |vertex| read_attributes(vertex.module()));
    Ok(Linked {
        sources,
        program,
        vertex,
        unclamped_vertex,
        geometry,
        unclamped_geometry,
        fragment,
        attributes,
        words,
        blocks,
        set: 0,
    })
}

/// The executable of an assembly program.
///
/// # Errors
/// When its module has more values than the IR can name.
pub(crate) fn assembly_executable(loaded: Loaded) -> Result<AssemblyExecutable, IrError> {
    let Loaded { program, initial, rows, counts, position } = loaded;
    let mut linked = executable(program, Arc::default())?;
    linked.words = initial;
    Ok(AssemblyExecutable { linked, rows, counts, position })
}
