//! Queries of uniform blocks and of the uniforms in them, and `glUniformBlockBinding`: `ARB_uniform_buffer_object`,
//! section 2.15.3.

use crate::base::args::{Names, TextOut};
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::base::limits::MAX_UNIFORM_BUFFER_BINDINGS;
use crate::base::query_value::{destination, put};
use crate::base::types::*;
use crate::calls::program::data_type::gl_type;
use crate::calls::program::inspect::{Active, active_uniforms, first_member};
use crate::calls::program::programs::program;
use crate::calls::program::similar_names;
use crate::calls::program::similar_names::NamedResource;
use crate::context::Context;
use crate::glsl::{MatrixOrder, Stage, UniformBlock};
use crate::objects::programs::ProgramObject;
use crate::objects::shaders::{c_length, put_text};
use crate::state::uniform_buffers::SECTION;

pub(crate) fn get_uniform_indices(
    context: &mut Context,
    name: GLuint,
    uniform_count: GLsizei,
    uniform_names: Names<'_>,
    uniform_indices: &mut [GLuint],
) -> Result<()> {
    let object = program(context, name)?;
    let count = not_negative(SECTION, "uniformCount", uniform_count.into())?;
    let Some(names) = uniform_names.0.get(..count) else {
        let has = uniform_names.0.len();
        let message = format!("uniformCount = {count}, but there are {has} names");
        return invalid_operation(SECTION, message);
    };
    let index = |name: &str| {
        let is = |uniform: Active<'_>| uniform.name == name || uniform.listed() == name;
        let found = active_uniforms(object).position(is);
        found.map_or(GL_INVALID_INDEX, |index| index as GLuint)
    };
    let indices = destination(uniform_indices, count)?;
    for (out, name) in indices.iter_mut().zip(names) {
        *out = index(name);
    }
    let missing = indices.iter().zip(names).filter(|(index, _)| **index == GL_INVALID_INDEX);
    let missing: Vec<&str> = missing.map(|(_, asked)| *asked).collect();
    for asked in missing {
        similar_names::not_found(context, name, NamedResource::UniformIndex, asked);
    }
    Ok(())
}

/// What `glGetActiveUniformsiv` answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum OfUniform {
    Type,
    Size,
    NameLength,
    BlockIndex,
    Offset,
    ArrayStride,
    MatrixStride,
    IsRowMajor,
}

impl OfUniform {
    const TABLE: Table<Self> = Table {
        section: SECTION,
        rows: &[
            (GL_UNIFORM_TYPE, Self::Type),
            (GL_UNIFORM_SIZE, Self::Size),
            (GL_UNIFORM_NAME_LENGTH, Self::NameLength),
            (GL_UNIFORM_BLOCK_INDEX, Self::BlockIndex),
            (GL_UNIFORM_OFFSET, Self::Offset),
            (GL_UNIFORM_ARRAY_STRIDE, Self::ArrayStride),
            (GL_UNIFORM_MATRIX_STRIDE, Self::MatrixStride),
            (GL_UNIFORM_IS_ROW_MAJOR, Self::IsRowMajor),
        ],
    };

    /// Of a uniform of no block offset and strides are -1.
    fn of(self, uniform: &Active<'_>) -> GLint {
        let or_minus_one = |value: Option<u32>| value.map_or(-1, |value| value as GLint);
        let member = uniform.member;
        match self {
            Self::Type => gl_type(uniform.ty) as GLint,
            Self::Size => uniform.array.unwrap_or(1) as GLint,
            Self::NameLength => c_length(&uniform.listed()),
            Self::BlockIndex => or_minus_one(member.map(|member| member.block)),
            Self::Offset => or_minus_one(member.map(|member| member.offset)),
            Self::ArrayStride => or_minus_one(member.map(|member| member.array_stride)),
            Self::MatrixStride => or_minus_one(member.map(|member| member.matrix_stride)),
            Self::IsRowMajor => {
                GLint::from(member.is_some_and(|member| member.order == MatrixOrder::Rows))
            }
        }
    }
}

fn no_uniform<T>(object: &ProgramObject, what: &str, index: GLuint) -> Result<T> {
    let count = active_uniforms(object).count();
    invalid_value(SECTION, format!("{what} = {index} must be below GL_ACTIVE_UNIFORMS, {count}"))
}

pub(crate) fn get_active_uniformsiv(
    context: &mut Context,
    name: GLuint,
    uniform_count: GLsizei,
    uniform_indices: &[GLuint],
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let object = program(context, name)?;
    let count = not_negative(SECTION, "uniformCount", uniform_count.into())?;
    let Some(indices) = uniform_indices.get(..count) else {
        let has = uniform_indices.len();
        let message = format!("uniformCount = {count}, but there are {has} indices");
        return invalid_operation(SECTION, message);
    };
    let property = OfUniform::TABLE.decode("pname", pname)?;
    let uniforms: Vec<Active<'_>> = active_uniforms(object).collect();
    let is_missing = |index: &GLuint| uniforms.get(*index as usize).is_none();
    if let Some(at) = indices.iter().position(is_missing) {
        return no_uniform(object, &format!("uniformIndices[{at}]"), indices[at]);
    }
    for (out, &index) in destination(params, count)?.iter_mut().zip(indices) {
        *out = property.of(&uniforms[index as usize]);
    }
    Ok(())
}

pub(crate) fn get_active_uniform_name(
    context: &mut Context,
    name: GLuint,
    uniform_index: GLuint,
    buf_size: GLsizei,
    length: &mut [GLsizei],
    uniform_name: TextOut<'_>,
) -> Result<()> {
    let object = program(context, name)?;
    match active_uniforms(object).nth(uniform_index as usize) {
        Some(uniform) => put_text(&uniform.listed(), buf_size, length, uniform_name),
        None => no_uniform(object, "uniformIndex", uniform_index),
    }
}

/// The blocks of a program; it has none unless it is linked.
fn blocks(object: &ProgramObject) -> &[UniformBlock] {
    object.linked().map_or(&[], |linked| &linked.program.blocks)
}

/// Answers `GL_INVALID_INDEX` after an error too.
pub(crate) fn get_uniform_block_index(
    context: &mut Context,
    name: GLuint,
    uniform_block_name: &str,
) -> Result<GLuint> {
    match program(context, name) {
        Ok(object) => {
            let found = blocks(object).iter().position(|block| block.name == uniform_block_name);
            Ok(found.map_or(GL_INVALID_INDEX, |index| index as GLuint))
        }
        Err(error) => {
            context.refuse("glGetUniformBlockIndex", error);
            Ok(GL_INVALID_INDEX)
        }
    }
}

/// A block of a program.
fn block(object: &ProgramObject, index: GLuint) -> Result<&UniformBlock> {
    let blocks = blocks(object);
    match blocks.get(index as usize) {
        Some(block) => Ok(block),
        None if index == GL_INVALID_INDEX => invalid_value(
            SECTION,
            "uniformBlockIndex = GL_INVALID_INDEX is what glGetUniformBlockIndex answers where the \
             program has no such block: its name is misspelt, or nothing uses it",
        ),
        None => invalid_value(
            SECTION,
            format!(
                "uniformBlockIndex = {index} must be below GL_ACTIVE_UNIFORM_BLOCKS, {}",
                blocks.len()
            ),
        ),
    }
}

/// What `glGetActiveUniformBlockiv` answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum OfBlock {
    Binding,
    DataSize,
    NameLength,
    ActiveUniforms,
    ActiveUniformIndices,
    ReferencedBy(Stage),
}

impl OfBlock {
    const TABLE: Table<Self> = Table {
        section: SECTION,
        rows: &[
            (GL_UNIFORM_BLOCK_BINDING, Self::Binding),
            (GL_UNIFORM_BLOCK_DATA_SIZE, Self::DataSize),
            (GL_UNIFORM_BLOCK_NAME_LENGTH, Self::NameLength),
            (GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS, Self::ActiveUniforms),
            (GL_UNIFORM_BLOCK_ACTIVE_UNIFORM_INDICES, Self::ActiveUniformIndices),
            (GL_UNIFORM_BLOCK_REFERENCED_BY_VERTEX_SHADER, Self::ReferencedBy(Stage::Vertex)),
            (GL_UNIFORM_BLOCK_REFERENCED_BY_GEOMETRY_SHADER, Self::ReferencedBy(Stage::Geometry)),
            (GL_UNIFORM_BLOCK_REFERENCED_BY_FRAGMENT_SHADER, Self::ReferencedBy(Stage::Fragment)),
        ],
    };
}

/// What `glGetActiveUniformBlockiv` answers, however many numbers it is.
pub(crate) fn block_values(
    context: &mut Context,
    name: GLuint,
    index: GLuint,
    pname: GLenum,
) -> Result<Vec<GLint>> {
    let object = program(context, name)?;
    let block = block(object, index)?;
    let value = match OfBlock::TABLE.decode("pname", pname)? {
        OfBlock::Binding => {
            let state = object.linked().and_then(|linked| linked.blocks.get(index as usize));
            state.map_or(0, |state| state.binding as GLint)
        }
        OfBlock::DataSize => block.bytes as GLint,
        OfBlock::NameLength => c_length(&block.name),
        OfBlock::ActiveUniforms => block.members.len() as GLint,
        OfBlock::ActiveUniformIndices => {
            let first = first_member(object) as GLint;
            return Ok(block.members.clone().map(|member| first + member as GLint).collect());
        }
        OfBlock::ReferencedBy(stage) => GLint::from(block.stages.contains(&stage)),
    };
    Ok(vec![value])
}

pub(crate) fn get_active_uniform_blockiv(
    context: &mut Context,
    name: GLuint,
    uniform_block_index: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    put(params, &block_values(context, name, uniform_block_index, pname)?)
}

pub(crate) fn get_active_uniform_block_name(
    context: &mut Context,
    name: GLuint,
    uniform_block_index: GLuint,
    buf_size: GLsizei,
    length: &mut [GLsizei],
    uniform_block_name: TextOut<'_>,
) -> Result<()> {
    let object = program(context, name)?;
    put_text(&block(object, uniform_block_index)?.name, buf_size, length, uniform_block_name)
}

pub(crate) fn uniform_block_binding(
    context: &mut Context,
    name: GLuint,
    uniform_block_index: GLuint,
    uniform_block_binding: GLuint,
) -> Result<()> {
    let object = program(context, name)?;
    block(object, uniform_block_index)?;
    if uniform_block_binding as usize >= MAX_UNIFORM_BUFFER_BINDINGS {
        return invalid_value(
            SECTION,
            format!(
                "uniformBlockBinding = {uniform_block_binding} must be below \
                 GL_MAX_UNIFORM_BUFFER_BINDINGS, {MAX_UNIFORM_BUFFER_BINDINGS}"
            ),
        );
    }
    let blocks = object.executable.as_mut().map(|linked| &mut linked.blocks);
    if let Some(state) = blocks.and_then(|all| all.get_mut(uniform_block_index as usize)) {
        state.binding = uniform_block_binding;
    }
    Ok(())
}
