//! Warnings of what a draw reads and nobody gave: attributes without an array, texture coordinates, and the program itself
//! where its last link failed.

use crate::base::types::GLuint;
use crate::context::Context;
use crate::context::warnings::DrawWarning;
use crate::generate::fixed::fragment::FragmentKey;
use crate::interface::{ATTRIB_TEX_COORD, MAX_VERTEX_ATTRIBS};
use crate::objects::programs::{LinkStatus, ShaderOrProgram};
use crate::objects::target::TextureTarget;
use crate::state::enable::CLIENT_ARRAY;
use glam::DMat4;
use rasterizer::driver::{Topology, VertexBinding, VertexSource};

/// What generic attributes and texture coordinates are at first (GL 2.1, section 2.7).
const INITIAL: [f32; 4] = [0.0, 0.0, 0.0, 1.0];

/// The value of an attribute, if it is the same at all vertices.
fn constant(vertices: &[VertexBinding], location: u8) -> Option<[f32; 4]> {
    let found = vertices.iter().find(|binding| binding.location == location)?;
    match found.source {
        VertexSource::Constant(value) => Some(value),
        VertexSource::Array { .. } => None,
    }
}

/// Checks the attributes of the program in use, and how it was linked.
pub(crate) fn program(context: &mut Context, topology: Topology, vertices: &[VertexBinding]) {
    let name = context.state.bindings.program.name();
    if name == 0 {
        return;
    }
    if let Some(ShaderOrProgram::Program(program)) = context.objects.shared.programs.get(name)
        && program.link == LinkStatus::Failed
    {
        not_linked(context, name);
    }
    // Without any array, `arrays::none` warns.
    let is_array = |binding: &VertexBinding| matches!(binding.source, VertexSource::Array { .. });
    if topology == Topology::Points || !vertices.iter().any(is_array) {
        return;
    }
    let Some(linked) = context.objects.shared.linked_program(name) else { return };
    let never_set = context.attributes_set;
    let missing = linked.program.attributes.iter().position(|attribute| {
        let generic = attribute.location < MAX_VERTEX_ATTRIBS;
        (generic || (ATTRIB_TEX_COORD..ATTRIB_TEX_COORD + 8).contains(&attribute.location))
            && never_set >> attribute.location & 1 == 0
            && constant(vertices, attribute.location) == Some(INITIAL)
    });
    if let Some(missing) = missing {
        let location = linked.program.attributes[missing].location;
        if context.is_first_warning(DrawWarning::MissingArray, name << 6 | u32::from(location)) {
            without_array(context, name, missing);
        }
    }
}

#[cold]
#[inline(never)]
fn not_linked(context: &mut Context, name: GLuint) {
    if context.is_first_warning(DrawWarning::FailedLink, name) {
        context.debug.warn(format!(
            "draw: program {name} is in use, but its last glLinkProgram failed, so what it was before is drawn: see \
             glGetProgramInfoLog (GL 2.1, section 2.15.2)"
        ));
    }
}

#[cold]
#[inline(never)]
fn without_array(context: &mut Context, name: GLuint, missing: usize) {
    let linked = context.objects.shared.linked_program(name);
    let Some(attribute) = linked.and_then(|linked| linked.program.attributes.get(missing)) else {
        return;
    };
    let (attribute, location) = (attribute.name.clone(), attribute.location);
    let fix = match CLIENT_ARRAY.rows.iter().find(|row| row.1 == location) {
        Some((array, _)) => {
            format!("glEnableClientState({})", crate::base::constants::enum_name(*array))
        }
        None if location >= MAX_VERTEX_ATTRIBS => {
            "glTexCoordPointer and glEnableClientState(GL_TEXTURE_COORD_ARRAY)".to_owned()
        }
        None => format!(
            "glEnableVertexAttribArray({location}), or glVertexAttrib4f({location}, ...) if one value is meant"
        ),
    };
    context.debug.warn(format!(
        "draw: program {name} reads the attribute \"{attribute}\", whose array is not enabled and whose value was never \
         set, so it is (0, 0, 0, 1) at all vertices: call {fix} (GL 2.1, section 2.8)"
    ));
}

/// Checks the texture coordinates of a draw of the fixed function.
pub(crate) fn texture_coordinates(
    context: &mut Context,
    topology: Topology,
    vertices: &[VertexBinding],
    fragment: &FragmentKey,
) {
    if topology == Topology::Points {
        return;
    }
    let missing = fragment.units.iter().find(|unit| {
        let place = usize::from(unit.unit);
        constant(vertices, ATTRIB_TEX_COORD + unit.unit) == Some(INITIAL)
            && context.recorder.unit_summary.generated[place].iter().all(Option::is_none)
            && context.state.matrices.texture[place].top == DMat4::IDENTITY
    });
    if let Some(unit) = missing {
        let (unit, target) = (unit.unit, TextureTarget::of(unit.shape));
        without_coordinates(context, unit, target);
    }
}

#[cold]
#[inline(never)]
fn without_coordinates(context: &mut Context, unit: u8, target: TextureTarget) {
    let bound = &context.state.units.units[usize::from(unit)].bound[target as usize];
    let name = bound.name();
    // A texture of one texel is a colour.
    let level = context.objects.texture(target, bound).image.level(0, 0);
    if level.is_some_and(|level| level.size == [1; 3])
        || !context.is_first_warning(DrawWarning::NoTexCoord, unit.into())
    {
        return;
    }
    let fix = match unit {
        0 => "glTexCoord2f before each glVertex, or glEnableClientState(GL_TEXTURE_COORD_ARRAY)"
            .to_owned(),
        _ => format!(
            "glMultiTexCoord2f(GL_TEXTURE{unit}, ...) before each glVertex, or \
             glClientActiveTexture(GL_TEXTURE{unit}) and glEnableClientState(GL_TEXTURE_COORD_ARRAY)"
        ),
    };
    context.debug.warn(format!(
        "draw: texture {name} is sampled by unit {unit}, but no texture coordinate was given, so every vertex has (0, 0) \
         and all fragments the same texel: call {fix} (GL 2.1, section 2.7)"
    ));
}
