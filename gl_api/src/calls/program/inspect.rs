//! Queries of programs: active uniforms and attributes, locations, parameters, logs (GL 2.1, sections 2.15.3 and 6.1.14).

use crate::base::args::TextOut;
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::program::data_type::gl_type;
use crate::calls::program::programs::program;
use crate::calls::program::similar_names;
use crate::calls::program::similar_names::NamedResource;
use crate::calls::program::varyings::BUFFER_MODE;
use crate::context::Context;
use crate::glsl::{DataType, FragmentOutput, Member, Program, Scalar, Separable};
use crate::interface::MAX_VERTEX_ATTRIBS;
use crate::objects::programs::{Linked, ProgramObject};
use crate::objects::shaders::{c_length, put_text};
use rasterizer::ir::{GeometryInput, GeometryOutput};

pub(super) const SECTION: &str = "GL 2.1, section 6.1.14";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Deleted,
    Linked,
    Validated,
    BinaryHint,
    BinaryLength,
    Separable,
    LogLength,
    AttachedShaders,
    ActiveAttributes,
    ActiveAttributeMaxLength,
    ActiveUniforms,
    ActiveUniformMaxLength,
    ActiveBlocks,
    ActiveBlockMaxLength,
    BufferMode,
    Captured,
    CapturedMaxLength,
    OfGeometry(GeometryProperty),
}

/// What is asked of the geometry stage (GL 3.2, section 6.1.16).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum GeometryProperty {
    VerticesOut,
    InputType,
    OutputType,
}

pub(crate) fn get_programiv(
    context: &mut Context,
    name: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    const PROPERTY: Table<Property> = Table {
        section: SECTION,
        rows: &[
            (GL_DELETE_STATUS, Property::Deleted),
            (GL_LINK_STATUS, Property::Linked),
            (GL_VALIDATE_STATUS, Property::Validated),
            (GL_INFO_LOG_LENGTH, Property::LogLength),
            (GL_ATTACHED_SHADERS, Property::AttachedShaders),
            (GL_ACTIVE_ATTRIBUTES, Property::ActiveAttributes),
            (GL_ACTIVE_ATTRIBUTE_MAX_LENGTH, Property::ActiveAttributeMaxLength),
            (GL_ACTIVE_UNIFORMS, Property::ActiveUniforms),
            (GL_ACTIVE_UNIFORM_MAX_LENGTH, Property::ActiveUniformMaxLength),
            (GL_ACTIVE_UNIFORM_BLOCKS, Property::ActiveBlocks),
            (GL_ACTIVE_UNIFORM_BLOCK_MAX_NAME_LENGTH, Property::ActiveBlockMaxLength),
            (GL_PROGRAM_BINARY_RETRIEVABLE_HINT, Property::BinaryHint),
            (GL_PROGRAM_BINARY_LENGTH, Property::BinaryLength),
            (GL_PROGRAM_SEPARABLE, Property::Separable),
            (GL_TRANSFORM_FEEDBACK_BUFFER_MODE, Property::BufferMode),
            (GL_TRANSFORM_FEEDBACK_VARYINGS, Property::Captured),
            (GL_TRANSFORM_FEEDBACK_VARYING_MAX_LENGTH, Property::CapturedMaxLength),
            (GL_GEOMETRY_VERTICES_OUT, Property::OfGeometry(GeometryProperty::VerticesOut)),
            (GL_GEOMETRY_INPUT_TYPE, Property::OfGeometry(GeometryProperty::InputType)),
            (GL_GEOMETRY_OUTPUT_TYPE, Property::OfGeometry(GeometryProperty::OutputType)),
        ],
    };
    let object = program(context, name)?;
    let property = PROPERTY.decode("pname", pname)?;
    let linked = object.linked().map(|linked| &linked.program);
    let captured = linked.map_or(&[][..], |linked| &linked.captured);
    let blocks = linked.map_or(&[][..], |linked| &linked.blocks);
    let value = match property {
        Property::Deleted => object.doomed.into(),
        Property::Linked => linked.is_some().into(),
        Property::Validated => object.validated.into(),
        Property::BinaryHint => object.binary_hint.into(),
        Property::BinaryLength => 0,
        Property::Separable => (object.separable == Separable::Yes).into(),
        Property::LogLength => c_length(&object.log),
        Property::AttachedShaders => object.attached.len() as GLint,
        Property::ActiveAttributes => {
            linked.map_or(0, |linked| active_attributes(linked).count()) as GLint
        }
        Property::ActiveAttributeMaxLength => {
            let names = linked.into_iter().flat_map(active_attributes);
            names.map(|(name, ..)| c_length(name)).max().unwrap_or(0)
        }
        Property::ActiveUniforms => active_uniforms(object).count() as GLint,
        Property::ActiveUniformMaxLength => {
            active_uniforms(object).map(|uniform| c_length(&uniform.listed())).max().unwrap_or(0)
        }
        Property::ActiveBlocks => blocks.len() as GLint,
        Property::ActiveBlockMaxLength => {
            blocks.iter().map(|block| c_length(&block.name)).max().unwrap_or(0)
        }
        Property::BufferMode => BUFFER_MODE
            .encode(linked.map_or_else(Default::default, |linked| linked.buffer_mode))
            as GLint,
        Property::Captured => captured.len() as GLint,
        Property::CapturedMaxLength => {
            captured.iter().map(|captured| c_length(&captured.name)).max().unwrap_or(0)
        }
        Property::OfGeometry(property) => of_geometry(object, name, property)?,
    };
    put(params, &[value])
}

fn of_geometry(object: &ProgramObject, name: GLuint, property: GeometryProperty) -> Result<GLint> {
    let Some(interface) = object.linked().and_then(Linked::geometry_interface) else {
        return invalid_operation(
            "GL 3.2, section 6.1.16",
            format!("program {name} is not linked with a geometry shader"),
        );
    };
    let value = match property {
        GeometryProperty::VerticesOut => interface.max_vertices,
        GeometryProperty::InputType => match interface.input {
            GeometryInput::Points => GL_POINTS,
            GeometryInput::Lines => GL_LINES,
            GeometryInput::LinesAdjacency => GL_LINES_ADJACENCY,
            GeometryInput::Triangles => GL_TRIANGLES,
            GeometryInput::TrianglesAdjacency => GL_TRIANGLES_ADJACENCY,
        },
        GeometryProperty::OutputType => match interface.output {
            GeometryOutput::Points => GL_POINTS,
            GeometryOutput::LineStrip => GL_LINE_STRIP,
            GeometryOutput::TriangleStrip => GL_TRIANGLE_STRIP,
        },
    };
    Ok(value as GLint)
}

/// A uniform as GL lists it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Active<'a> {
    pub name: &'a str,
    pub ty: DataType,
    /// The length of an array.
    pub array: Option<u32>,
    /// What it is in a uniform block.
    pub member: Option<&'a Member>,
}

impl Active<'_> {
    /// Its name as GL lists it: arrays end in `[0]`.
    pub fn listed(&self) -> String {
        if self.array.is_some() { format!("{}[0]", self.name) } else { self.name.to_owned() }
    }
}

/// The uniforms as GL lists them: the application's, members of blocks, then built-in state.
pub(crate) fn active_uniforms(object: &ProgramObject) -> impl Iterator<Item = Active<'_>> {
    let program = object.linked().map(|linked| &linked.program);
    program.into_iter().flat_map(|program| {
        let own = program.uniforms.iter();
        let builtin = program.builtin_uniforms.iter();
        let members = program.members.iter();
        let plain = |name, ty, array| Active { name, ty, array, member: None };
        own.map(move |uniform| plain(&uniform.name, uniform.ty, uniform.array))
            .chain(members.map(|member| Active {
                name: &member.name,
                ty: member.ty,
                array: member.array,
                member: Some(member),
            }))
            .chain(builtin.map(move |uniform| plain(&uniform.name, uniform.ty, uniform.array)))
    })
}

/// How many uniforms there are before the members of blocks.
pub(crate) fn first_member(object: &ProgramObject) -> usize {
    object.linked().map_or(0, |linked| linked.program.uniforms.len())
}

pub(crate) fn get_program_info_log(
    context: &mut Context,
    name: GLuint,
    max_length: GLsizei,
    length: &mut [GLsizei],
    info_log: TextOut<'_>,
) -> Result<()> {
    put_text(&program(context, name)?.log, max_length, length, info_log)
}

pub(crate) fn get_attached_shaders(
    context: &mut Context,
    name: GLuint,
    max_count: GLsizei,
    count: &mut [GLsizei],
    shaders: &mut [GLuint],
) -> Result<()> {
    let limit = not_negative(SECTION, "maxCount", max_count.into())?;
    let attached = &program(context, name)?.attached;
    let written = attached.len().min(limit).min(shaders.len());
    shaders[..written].copy_from_slice(&attached[..written]);
    if let Some(count) = count.first_mut() {
        *count = written as GLsizei;
    }
    Ok(())
}

/// A linked program.
pub(super) fn linked(context: &mut Context, name: GLuint) -> Result<&Linked> {
    match program(context, name)?.linked() {
        Some(linked) => Ok(linked),
        None => invalid_operation(SECTION, format!("program {name} is not linked")),
    }
}

/// Writes what a uniform or attribute is.
fn put_variable(
    (name, ty, elements): (&str, DataType, u32),
    max_length: GLsizei,
    length: &mut [GLsizei],
    size: &mut [GLint],
    gl_ty: &mut [GLenum],
    out: TextOut<'_>,
) -> Result<()> {
    put_text(name, max_length, length, out)?;
    put(size, &[elements as GLint])?;
    put(gl_ty, &[gl_type(ty)])
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn get_active_uniform(
    context: &mut Context,
    name: GLuint,
    index: GLuint,
    max_length: GLsizei,
    length: &mut [GLsizei],
    size: &mut [GLint],
    ty: &mut [GLenum],
    out: TextOut<'_>,
) -> Result<()> {
    let object = program(context, name)?;
    let Some(uniform) = active_uniforms(object).nth(index as usize) else {
        let count = active_uniforms(object).count();
        return invalid_value(
            SECTION,
            format!("index = {index} must be below GL_ACTIVE_UNIFORMS, {count}"),
        );
    };
    let variable = (&*uniform.listed(), uniform.ty, uniform.array.unwrap_or(1));
    put_variable(variable, max_length, length, size, ty, out)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn get_active_attrib(
    context: &mut Context,
    name: GLuint,
    index: GLuint,
    max_length: GLsizei,
    length: &mut [GLsizei],
    size: &mut [GLint],
    ty: &mut [GLenum],
    out: TextOut<'_>,
) -> Result<()> {
    let object = program(context, name)?;
    let linked = object.linked().map(|linked| &linked.program);
    let mut attributes = linked.into_iter().flat_map(active_attributes);
    let Some(attribute) = attributes.nth(index as usize) else {
        let count = linked.map_or(0, |linked| active_attributes(linked).count());
        return invalid_value(
            SECTION,
            format!("index = {index} must be below GL_ACTIVE_ATTRIBUTES, {count}"),
        );
    };
    put_variable(attribute, max_length, length, size, ty, out)
}

/// Name, type and elements of what the vertex stage reads of each vertex.
fn active_attributes(program: &Program) -> impl Iterator<Item = (&str, DataType, u32)> {
    let int = DataType::Vector(Scalar::Int, 1);
    let attributes = program.attributes.iter();
    let attributes =
        attributes.map(|attribute| (&*attribute.name, attribute.ty, attribute.array.unwrap_or(1)));
    attributes.chain(program.vertex_numbers.iter().map(move |name| (&**name, int, 1)))
}

/// A name with an index at its end, taken apart: `a[2]` is `a` and 2.
pub(crate) fn indexed(name: &str) -> Option<(&str, u32)> {
    let (base, rest) = name.rsplit_once('[')?;
    let digits = rest.strip_suffix(']')?;
    let canonical = digits == "0" || !digits.starts_with('0');
    (canonical && digits.bytes().all(|byte| byte.is_ascii_digit()))
        .then_some((base, digits.parse().ok()?))
}

pub(crate) fn get_uniform_location(
    context: &mut Context,
    name: GLuint,
    uniform: &str,
) -> Result<GLint> {
    let uniforms = &linked(context, name)?.program.uniforms;
    let whole = uniforms.iter().find(|found| found.name == uniform).map(|found| found.location);
    let element = || {
        let (base, index) = indexed(uniform)?;
        let found = uniforms.iter().find(|found| found.name == base)?;
        (index < found.array?).then_some(found.location + index)
    };
    let location = whole.or_else(element);
    if location.is_none() {
        similar_names::not_found(context, name, NamedResource::Uniform, uniform);
    }
    Ok(location.map_or(-1, |location| location as GLint))
}

pub(crate) fn get_attrib_location(
    context: &mut Context,
    name: GLuint,
    attribute: &str,
) -> Result<GLint> {
    let attributes = &linked(context, name)?.program.attributes;
    let found = attributes
        .iter()
        .find(|found| found.name == attribute && found.location < MAX_VERTEX_ATTRIBS);
    let location = found.map(|found| found.location);
    if location.is_none() {
        similar_names::not_found(context, name, NamedResource::Attribute, attribute);
    }
    Ok(location.map_or(-1, GLint::from))
}

/// The output of the fragment stage of that name, if the program has it.
fn fragment_output<'a>(
    context: &'a mut Context,
    name: GLuint,
    output: &str,
) -> Result<Option<&'a FragmentOutput>> {
    let outputs = &linked(context, name)?.program.outputs;
    Ok(outputs.iter().find(|found| found.name == output))
}

pub(crate) fn get_frag_data_location(
    context: &mut Context,
    name: GLuint,
    output: &str,
) -> Result<GLint> {
    let found = fragment_output(context, name, output)?;
    Ok(found.map_or(-1, |found| found.color.into()))
}

pub(crate) fn get_frag_data_index(
    context: &mut Context,
    name: GLuint,
    output: &str,
) -> Result<GLint> {
    let found = fragment_output(context, name, output)?;
    Ok(found.map_or(-1, |found| found.index.into()))
}
