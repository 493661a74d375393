//! The uniform words of uniform blocks, unpacked from their buffers (`ARB_uniform_buffer_object`, section 2.15.3.1.1).

use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::context::Context;
use crate::glsl::{DataType, MatrixOrder, Member, Scalar, UniformBlock};
use crate::objects::buffers::{BufferObject, BufferRange};
use crate::objects::programs::{Linked, ShaderOrProgram};
use crate::state::uniform_buffers::SECTION;
use rasterizer::driver::Buffer;
use rasterizer::ir::TRUE;

/// Brings the words of the uniform blocks of the program in use up to date.
///
/// # Errors
/// `GL_INVALID_OPERATION` if a buffer that it reads is mapped.
pub(crate) fn refresh(context: &mut Context) -> Result<()> {
    let objects = &mut *context.objects.shared;
    let program = match context.state.bindings.program.name() {
        0 => context.objects.pipelines.executable_mut(),
        name => match objects.programs.get_mut(name) {
            Some(ShaderOrProgram::Program(program)) => program.executable.as_mut(),
            Some(ShaderOrProgram::Shader(_)) | None => None,
        },
    };
    let Some(Linked { program, blocks, words, .. }) = program else { return Ok(()) };
    let none = BufferRange::default();
    for (block, state) in program.blocks.iter().zip(blocks) {
        let Some(word) = block.word else { continue };
        let bound = context.uniform_buffers.buffers.get(state.binding as usize);
        let range = bound.unwrap_or(&none);
        let object = objects.buffers.bound(&range.buffer);
        if object.is_some_and(BufferObject::is_mapped_alone) {
            return invalid_operation(
                SECTION,
                format!(
                    "buffer {}, which the uniform block \"{}\" is read from, is mapped: call \
                     glUnmapBuffer",
                    range.buffer.name(),
                    block.name
                ),
            );
        }
        let buffer = object.map(BufferObject::buffer);
        if state.is_of(range, buffer) {
            continue;
        }
        state.source = Some((range.offset, range.size, buffer.map(Buffer::version)));
        let bytes = buffer.map_or(&[][..], Buffer::bytes);
        let bytes = bytes.get(range.offset..).unwrap_or_default();
        let bytes = &bytes[..range.size.unwrap_or(bytes.len()).min(bytes.len())];
        if bytes.len() < block.bytes as usize {
            context.debug.warn(too_small(block, state.binding, range, bytes.len()));
        }
        let members = block.members.start as usize..block.members.end as usize;
        let words = words.get_mut(word as usize..).unwrap_or_default();
        for member in program.members.get(members).unwrap_or_default() {
            unpack(member, bytes, words);
        }
    }
    Ok(())
}

/// A block that has no buffer, or one of fewer bytes than it has itself.
#[cold]
#[inline(never)]
fn too_small(block: &UniformBlock, binding: GLuint, range: &BufferRange, bytes: usize) -> String {
    let (name, needs, buffer) = (&block.name, block.bytes, range.buffer.name());
    if buffer == 0 {
        return format!(
            "draw: the uniform block \"{name}\" has no buffer: call \
             glBindBufferBase(GL_UNIFORM_BUFFER, {binding}, buffer) (GL 3.1, section 2.11.4)"
        );
    }
    format!(
        "draw: the uniform block \"{name}\" needs {needs} bytes, and buffer {buffer}, bound to index \
         {binding} of GL_UNIFORM_BUFFER, has {bytes}: the others read as 0; give it more with \
         glBufferData (GL 3.1, section 2.11.4)"
    )
}

/// Writes the words of a member.
fn unpack(member: &Member, bytes: &[u8], words: &mut [u32]) {
    // Rows and columns as they lie in the buffer: how many, of how many numbers.
    let (vectors, numbers, truth) = match member.ty {
        DataType::Vector(scalar, size) => (1, size, scalar == Scalar::Bool),
        DataType::Matrix(columns, rows) => match member.order {
            MatrixOrder::Columns => (columns, rows, false),
            MatrixOrder::Rows => (rows, columns, false),
        },
        DataType::Sampler(_) => return,
    };
    let (vectors, numbers) = (usize::from(vectors), usize::from(numbers));
    let all = words.get_mut(member.word as usize..).unwrap_or_default();
    let elements = all.chunks_exact_mut(vectors * numbers);
    for (index, element) in elements.take(member.array.unwrap_or(1) as usize).enumerate() {
        let first = member.offset as usize + index * member.array_stride as usize;
        for vector in 0..vectors {
            let first = first + vector * member.matrix_stride as usize;
            for number in 0..numbers {
                let word = read(bytes, first + number * 4);
                let at = match member.order {
                    MatrixOrder::Columns => vector * numbers + number,
                    MatrixOrder::Rows => number * vectors + vector,
                };
                element[at] = if truth && word != 0 { TRUE } else { word };
            }
        }
    }
}

/// The word at a byte; what lies past the end is 0.
fn read(bytes: &[u8], at: usize) -> u32 {
    let word = bytes.get(at..).and_then(|rest| rest.first_chunk());
    word.map_or(0, |word| u32::from_le_bytes(*word))
}
