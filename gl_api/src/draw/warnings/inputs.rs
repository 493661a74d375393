//! Warnings of what a draw reads and nobody gave: attributes without an array, texture coordinates, and the program itself
//! where its last link failed.

use crate::base::types::GLuint;
use crate::context::Context;
use crate::context::recorder::elements::bit;
use crate::context::warnings::DrawWarning;
use crate::generate::fixed::fragment::FragmentKey;
use crate::interface::{ATTRIB_TEX_COORD, MAX_VERTEX_ATTRIBS};
use crate::objects::programs::{LinkStatus, ShaderOrProgram};
use crate::objects::target::TextureTarget;
use crate::state::enable::CLIENT_ARRAY;
use glam::DMat4;
use rasterizer::driver::{Topology, VertexBinding, VertexSource};
use rasterizer::ir::Stage;

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

/// Checks how the program in use was linked.
pub(crate) fn link(context: &mut Context) {
    let name = context.state.bindings.program.name();
    if let Some(ShaderOrProgram::Program(program)) = context.objects.shared.programs.get(name)
        && program.link == LinkStatus::Failed
    {
        not_linked(context, name);
    }
}

/// The attributes of the program in use that have neither an array nor a value of the client, bit by location.
pub(crate) fn unset_attributes(
    context: &Context,
    topology: Topology,
    vertices: &[VertexBinding],
) -> u64 {
    // Without any array, `arrays::none` warns.
    let is_array = |binding: &VertexBinding| matches!(binding.source, VertexSource::Array { .. });
    if !context.has_program() || topology == Topology::Points || !vertices.iter().any(is_array) {
        return 0;
    }
    let Some(linked) = context.executable() else { return 0 };
    let locations = linked.program.attributes.iter().map(|attribute| attribute.location);
    let is_unset = |location: &u8| {
        (*location < MAX_VERTEX_ATTRIBS
            || (ATTRIB_TEX_COORD..ATTRIB_TEX_COORD + 8).contains(location))
            && context.attributes_set >> location & 1 == 0
            && constant(vertices, *location) == Some(INITIAL)
    };
    locations.filter(is_unset).fold(0, |all, location| all | bit(location))
}

/// Warns of the first of `unset` ([`unset_attributes`]) that the pipeline last emitted reads: an attribute without an
/// influence on the picture needs no value.
pub(crate) fn without_arrays(context: &mut Context, unset: u64) {
    let read = unset & context.recorder.emitted.attributes;
    if read == 0 {
        return;
    }
    let name = context.program_of(Stage::Vertex);
    let location = read.trailing_zeros();
    if is_coordinate(context, location as u8) && every_texture_is_a_color(context) {
        return;
    }
    if context.is_first_warning(DrawWarning::MissingArray, name << 6 | location) {
        without_array(context, name, location as u8);
    }
}

/// Whether an attribute is one of texture coordinates, by its name.
fn is_coordinate(context: &Context, location: u8) -> bool {
    let Some(linked) = context.executable() else { return false };
    let mut attributes = linked.program.attributes.iter();
    attributes.find(|attribute| attribute.location == location).is_some_and(|attribute| {
        let name = attribute.name.to_ascii_lowercase();
        name.contains("tex") || name.contains("uv")
    })
}

/// Whether each texture that the program in use samples has one texel, wherever it is sampled: programs bind such a one for
/// what has no texture, and give no coordinates then.
fn every_texture_is_a_color(context: &Context) -> bool {
    let Some(linked) = context.executable() else { return false };
    let samplers = &linked.program.samplers;
    !samplers.is_empty()
        && samplers.iter().all(|sampler| {
            let unit = linked.words.get(sampler.word as usize).copied().unwrap_or(0) as usize;
            let target = TextureTarget::of_sampler(sampler.dim);
            let Some(unit) = context.state.units.units.get(unit) else { return false };
            let texture = context.objects.texture(target, &unit.bound[target as usize]);
            texture.image.level(0, 0).is_some_and(|level| level.size == [1; 3])
        })
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
fn without_array(context: &mut Context, name: GLuint, location: u8) {
    let linked = context.executable();
    let mut attributes = linked.iter().flat_map(|linked| &linked.program.attributes);
    let Some(attribute) = attributes.find(|attribute| attribute.location == location) else {
        return;
    };
    let attribute = attribute.name.clone();
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
