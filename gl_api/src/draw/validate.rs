//! Whether a program can run with the texture units that its samplers name (GL 2.1, section 2.15.4).

use crate::base::error::Result;
use crate::glsl::{Dim, SamplerSlot};
use crate::interface::MAX_COMBINED_TEXTURE_IMAGE_UNITS;
use crate::objects::programs::Linked;
use rasterizer::ir::{Stage, TextureDecl};

/// Checks the units that the samplers name.
///
/// # Errors
/// The rule that is broken, and what to do.
pub(crate) fn runnable(linked: &Linked) -> Result<(), String> {
    if linked.geometry.is_some() && linked.vertex.is_none() {
        return Err("there is a geometry stage and no vertex stage: attach a vertex shader".into());
    }
    let limit = usize::from(MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    // A sampler that is compared in two ways has two slots.
    let slots = &linked.program.samplers;
    let is_first = |(at, slot): &(usize, &SamplerSlot)| {
        let is_same = |other: &SamplerSlot| (other.stage, other.word) == (slot.stage, slot.word);
        !slots[..*at].iter().any(is_same)
    };
    let samplers = slots.iter().enumerate().filter(is_first).count();
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
    // Samplers are few: a list is searched.
    let mut seen: Vec<(u32, (TextureDecl, Dim), u32)> = Vec::new();
    for slot in &linked.program.samplers {
        let (Some(decl), Some(&unit)) =
            (declared(linked, slot), linked.words.get(slot.word as usize))
        else {
            continue;
        };
        let Some(&(_, other, word)) = seen.iter().find(|(of, ..)| *of == unit) else {
            seen.push((unit, decl, slot.word));
            continue;
        };
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

/// The declaration of a sampler in its stage, and its dimensions.
fn declared(linked: &Linked, slot: &SamplerSlot) -> Option<(TextureDecl, Dim)> {
    let module = match slot.stage {
        Stage::Vertex => linked.vertex.as_ref(),
        Stage::Geometry => linked.geometry.as_ref(),
        Stage::Fragment => linked.fragment.as_ref(),
    };
    Some((*module?.module().textures.get(slot.slot as usize)?, slot.dim))
}
