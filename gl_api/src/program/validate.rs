//! Whether a program could run: GL 2.1, section 2.15.4.

use crate::context::Context;
use crate::error::Result;
use crate::glsl::{Dim, SamplerSlot};
use crate::interface::MAX_COMBINED_TEXTURE_IMAGE_UNITS;
use crate::object::programs::{Linked, program};
use crate::types::*;
use rasterizer::ir::{Stage, TextureDecl};
use std::collections::{BTreeMap, BTreeSet};

pub(crate) fn validate_program(context: &mut Context, name: GLuint) -> Result<()> {
    let object = program(context, name)?;
    let problem = match object.linked() {
        None => Err(format!("program {name} is not linked: call glLinkProgram")),
        Some(linked) => runnable(linked),
    };
    object.validated = problem.is_ok();
    object.log = problem.err().map_or_else(String::new, |problem| format!("error: {problem}\n"));
    Ok(())
}

/// What stands against a draw with the values that the samplers have.
///
/// # Errors
/// What is wrong and what to do.
pub(crate) fn runnable(linked: &Linked) -> Result<(), String> {
    let limit = usize::from(MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    // A sampler that is compared in two ways has two slots.
    let slots = linked.program.samplers.iter();
    let samplers = slots.map(|slot| (slot.stage as u8, slot.word)).collect::<BTreeSet<_>>().len();
    if samplers > limit {
        return Err(format!(
            "the stages sample {samplers} textures together; GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS \
             is {limit}"
        ));
    }
    one_type_per_unit(linked)
}

/// Samplers of different types must name different units (GL 2.1, section 2.15.3).
fn one_type_per_unit(linked: &Linked) -> Result<(), String> {
    let mut seen: BTreeMap<u32, ((TextureDecl, Dim), u32)> = BTreeMap::new();
    for slot in &linked.program.samplers {
        let (Some(decl), Some(&unit)) =
            (declared(linked, slot), linked.words.get(slot.word as usize))
        else {
            continue;
        };
        let &mut (other, word) = seen.entry(unit).or_insert((decl, slot.word));
        if other != decl {
            return Err(format!(
                "samplers of different types,{} and{}, both name texture unit {unit}: set each to \
                 a unit of its own with glUniform1i",
                linked.quoted_name(word),
                linked.quoted_name(slot.word)
            ));
        }
    }
    Ok(())
}

/// What a stage says of a texture that it samples, and what textures that means.
fn declared(linked: &Linked, slot: &SamplerSlot) -> Option<(TextureDecl, Dim)> {
    let module = match slot.stage {
        Stage::Vertex => linked.vertex.as_ref(),
        Stage::Fragment => linked.fragment.as_ref(),
    };
    Some((*module?.module().textures.get(slot.slot as usize)?, slot.dim))
}
