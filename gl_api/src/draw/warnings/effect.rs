//! Warnings of programs that cannot draw anything but black: what their modules say of themselves
//! ([`rasterizer::ir::Effect`]).

use crate::base::types::GLuint;
use crate::context::Context;
use crate::context::warnings::DrawWarning;
use rasterizer::driver::{PipelineDesc, ShaderModule};
use rasterizer::ir::{Effect, Stage};

/// Checks the stages of a draw.
pub(crate) fn check(context: &mut Context, desc: &PipelineDesc) {
    let fragment = desc.fragment.effect();
    let emits = desc.geometry.as_ref().is_none_or(|stage| !stage.effect().draws_nothing);
    if fragment.draws_nothing || !emits || fragment.is_not_a_number {
        useless(context, fragment, emits);
    }
    if fragment.factors.iter().all(|factors| !factors.words().is_empty()) {
        unset_factor(context, desc);
    }
}

#[cold]
#[inline(never)]
fn useless(context: &mut Context, fragment: &Effect, emits: bool) {
    let stage = if emits { Stage::Fragment } else { Stage::Geometry };
    let program = context.program_of(stage);
    // What vertices are captured for is not seen.
    if program == 0
        || context.transform_feedback.is_active()
        || !context.is_first_warning(DrawWarning::Useless, program << 1 | GLuint::from(emits))
    {
        return;
    }
    let text = match (emits, fragment.draws_nothing) {
        (false, _) => format!(
            "draw: the geometry stage of program {program} calls EmitVertex() nowhere, so nothing is drawn: call it for \
             each vertex, then EndPrimitive() (GLSL 1.50, section 8.10)"
        ),
        (true, true) => format!(
            "draw: the fragment stage of program {program} discards every fragment, whatever its inputs are, so nothing is \
             drawn: discard under a condition (GLSL 1.20, section 6.4)"
        ),
        (true, false) => format!(
            "draw: the colour of the fragment stage of program {program} is NaN everywhere, which is written as 0: look \
             for a division by zero, sqrt or log of a negative number, or normalize of a zero vector (GLSL 1.20, \
             section 4.1.4)"
        ),
    };
    context.debug.warn(text);
}

/// Warns of a colour that is multiplied by a uniform that is 0 because nobody ever set it.
#[inline(never)]
fn unset_factor(context: &mut Context, desc: &PipelineDesc) {
    let blends = desc.colors.first().is_some_and(|color| color.blend.is_some());
    // The uniforms of pipelines are those of their programs.
    if blends || context.state.bindings.program.name() == 0 {
        return;
    }
    let Some(linked) = context.executable() else { return };
    let is_its_stage = |stage: &ShaderModule| *stage == desc.fragment;
    if !linked.fragment.as_ref().is_some_and(is_its_stage) {
        return;
    }
    let uniform_of = |word: u32| {
        linked.program.uniforms.iter().find(|uniform| {
            let words = uniform.ty.words() * uniform.array.unwrap_or(1);
            (uniform.word..uniform.word + words).contains(&word)
        })
    };
    let unset = |word: &u32| {
        let value = linked.words.get(*word as usize)?;
        let uniform = uniform_of(*word).filter(|_| value << 1 == 0)?;
        (!linked.is_set(uniform.location)).then_some(uniform)
    };
    let factors = &desc.fragment.effect().factors;
    let found = factors.each_ref().map(|factors| factors.words().iter().find_map(unset));
    let [Some(uniform), Some(_), Some(_)] = found else { return };
    let (location, name) = (uniform.location, uniform.name.clone());
    let program = context.program_of(Stage::Fragment);
    if context.is_first_warning(DrawWarning::ZeroUniform, program) {
        context.debug.warn(format!(
            "draw: the fragment stage of program {program} multiplies its colour by the uniform \"{name}\", which was \
             never set and is 0, so all is black: call glUniform* with location {location} (glGetUniformLocation) while \
             the program is in use (GL 2.1, section 2.15.3)"
        ));
    }
}
