//! Warnings for names that a program does not have but are similar to one that it has: `glGetUniformLocation` answers -1
//! for them, and a program that goes on sets nothing.
//!
//! Programs also ask for uniforms that nothing uses, and ask all their programs for the same names, with good reason. So
//! only a name that no shader declares at all, at a small edit distance from one that is declared, gets a warning.

use crate::base::types::GLuint;
use crate::context::Context;
use crate::context::warnings::DrawWarning;
use crate::glsl::spelling::edit_distance;
use crate::interface::MAX_VERTEX_ATTRIBS;
use crate::objects::programs::ShaderOrProgram;

/// Whose location was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NamedResource {
    Uniform,
    /// A uniform by its index, not its location.
    UniformIndex,
    Attribute,
}

/// Says once that a name may be misspelt.
#[cold]
#[inline(never)]
pub(crate) fn not_found(context: &mut Context, program: GLuint, of: NamedResource, asked: &str) {
    let (warning, call, what) = match of {
        NamedResource::Uniform => (DrawWarning::NoUniform, "glGetUniformLocation", "uniform"),
        NamedResource::UniformIndex => (DrawWarning::NoUniform, "glGetUniformIndices", "uniform"),
        NamedResource::Attribute => (DrawWarning::NoAttribute, "glGetAttribLocation", "attribute"),
    };
    // Asked for in each frame, it is looked at once.
    let subject = asked.bytes().fold(program, |hash, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193).rotate_left(5)
    });
    if !context.is_first_warning(warning, subject) || is_declared(context, asked) {
        return;
    }
    let Some(near) = nearest(context, program, of, asked) else { return };
    let answer = match of {
        NamedResource::Uniform | NamedResource::Attribute => "-1",
        NamedResource::UniformIndex => "GL_INVALID_INDEX",
    };
    context.debug.warn(format!(
        "{call}: {answer}, as program {program} has no active {what} \"{asked}\"; did you mean \"{near}\"?"
    ));
}

/// Whether any shader declares a name: it is another program's, or not active because nothing uses it.
fn is_declared(context: &Context, asked: &str) -> bool {
    let base = asked.split(['[', '.']).next().unwrap_or(asked);
    context.objects.shared.programs.values().any(|object| match object {
        ShaderOrProgram::Shader(shader) => {
            shader.compiled.as_ref().is_some_and(|compiled| compiled.declares(base))
        }
        // Shaders may be deleted once they are linked.
        ShaderOrProgram::Program(program) => program.executable.as_ref().is_some_and(|linked| {
            let program = &linked.program;
            program.members.iter().any(|member| member.name == asked)
                || program.uniforms.iter().any(|uniform| uniform.name == asked)
                || program.attributes.iter().any(|attribute| attribute.name == asked)
        }),
    })
}

/// The name that was meant, perhaps. Others differ in their numbers alone: elements that there may be.
fn nearest(context: &Context, program: GLuint, of: NamedResource, asked: &str) -> Option<String> {
    let slips = match asked.len() {
        ..4 => return None,
        4..8 => 1,
        8.. => 2,
    };
    let program = &context.objects.shared.linked_program(program)?.program;
    let uniforms = program.uniforms.iter().map(|uniform| &uniform.name);
    let attributes = program.attributes.iter();
    let generic = attributes.filter(|attribute| attribute.location < MAX_VERTEX_ATTRIBS);
    let generic = generic.map(|attribute| &attribute.name);
    let is_near = |name: &&String| {
        let letters = |text: &str| -> String {
            text.chars().filter(|letter| !letter.is_ascii_digit()).collect()
        };
        let near = name.eq_ignore_ascii_case(asked) || edit_distance(asked, name, slips).is_some();
        near && letters(name) != letters(asked)
    };
    let mut names: Vec<&String> = match of {
        NamedResource::Uniform | NamedResource::UniformIndex => uniforms.collect(),
        NamedResource::Attribute => generic.collect(),
    };
    names.retain(is_near);
    names.into_iter().min_by_key(|name| edit_distance(asked, name, slips)).cloned()
}
