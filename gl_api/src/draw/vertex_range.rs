//! The range of vertices that a draw reads, and what it takes of its arrays: a buffer object whole, or a copy of the
//! range.
//!
//! Copies are taken of a C program's memory, which is valid only during the call, and of buffer objects that are
//! written between draws: a recorded draw that held such a buffer whole would make each write copy all of it. Where
//! indices lie far scattered, vertices are copied one by one.

use crate::base::client_memory::ClientPointer;
use crate::base::error::{ErrorCode, GlError, Result};
use crate::base::limits;
use crate::base::types::GLint;
use crate::context::Context;
use crate::draw::array_names::mapped;
use crate::objects::arrays::{Array, Source};
use rasterizer::driver::{Buffer, IndexType, VertexSource};
use rasterizer::ir::{Expr, Input};
use std::ops::Range;

/// The vertices and instances that a draw reads.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VertexRange<'a> {
    pub first: u32,
    pub last: u32,
    pub instances: u32,
    /// The element of the first instance, of arrays with a divisor (`ARB_base_instance`).
    pub base_instance: u32,
    /// The vertices, where they are copied one by one: the copy of an array has them in this order.
    pub scattered: Option<&'a [u32]>,
}

impl VertexRange<'_> {
    /// The smallest range that has both.
    pub fn union(self, other: Self) -> Self {
        let (first, last) = (self.first.min(other.first), self.last.max(other.last));
        Self { first, last, ..self }
    }

    /// Whether `count` vertices lie so densely in the range that it may be copied whole.
    pub fn is_dense(self, count: usize) -> bool {
        (self.last - self.first) as usize / 4 <= count + 64
    }

    /// The element of an array that its number 0 is in this draw.
    fn base(self, array: &Array) -> usize {
        if array.divisor == 0 { 0 } else { self.base_instance as usize }
    }

    /// The elements of an array: one with a divisor has one for every so many instances.
    fn elements(self, array: &Array) -> (usize, usize) {
        let base = self.base(array);
        match self.instances.saturating_sub(1).checked_div(array.divisor) {
            Some(last) => (base, base + last as usize),
            None => (self.first as usize, self.last as usize),
        }
    }

    /// The bytes of its elements of an array, and the number of the first.
    fn bytes(self, array: &Array, offset: usize) -> Option<(Range<usize>, u32)> {
        let (first, last) = self.elements(array);
        let at = |element: usize| element.checked_mul(array.step)?.checked_add(offset);
        let number = (first - self.base(array)) as u32;
        Some((at(first)?..at(last)?.checked_add(array.size())?, number))
    }
}

/// Whether a draw has to know which vertices it reads, as it copies them from some array.
pub(crate) fn needs_vertex_range(context: &Context) -> bool {
    let arrays = &context.state.arrays.by_location;
    arrays.iter().filter(|array| array.enabled).any(|array| match &array.source {
        Source::Client(_) => false,
        Source::Pointer(_) => true,
        Source::Object { buffer, .. } => {
            let object = context.objects.shared.buffers.bound(buffer);
            object.is_some_and(|object| object.is_rewritten(&context.recorder))
        }
    })
}

/// The number of vertices, and of instances, that all enabled arrays have.
pub(crate) fn array_limits(context: &Context) -> [u32; 2] {
    let mut all = [u32::MAX; 2];
    let arrays = &context.state.arrays.by_location;
    for array in arrays.iter().filter(|array| array.enabled) {
        let bytes = match &array.source {
            Source::Client(buffer) => buffer.bytes().len(),
            Source::Pointer(_) => limits::MAX_BUFFER_SIZE,
            Source::Object { buffer, offset } => {
                let object = context.objects.shared.buffers.bound(buffer);
                object.map_or(0, |object| object.buffer().bytes().len()).saturating_sub(*offset)
            }
        };
        let elements = bytes.checked_sub(array.size()).map_or(0, |rest| {
            // All elements are the same one.
            rest.checked_div(array.step).map_or(usize::MAX, |last| last + 1)
        });
        let elements = u32::try_from(elements).unwrap_or(u32::MAX);
        let (axis, each) = if array.divisor == 0 { (0, 1) } else { (1, array.divisor) };
        all[axis] = all[axis].min(elements.saturating_mul(each));
    }
    all
}

/// A copy of a C program's vertices from the first to the last of a draw, and the number of the first. Memory before
/// them is not read, as it may not be there.
fn snapshot(
    array: &Array,
    pointer: ClientPointer<'_>,
    vertex_range: VertexRange<'_>,
) -> Result<(Buffer, u32)> {
    let place =
        vertex_range.bytes(array, 0).filter(|(bytes, _)| bytes.end <= limits::MAX_BUFFER_SIZE);
    let Some((bytes, first)) = place else {
        let (_, last) = vertex_range.elements(array);
        return Err(GlError::new(
            ErrorCode::OutOfMemory,
            "GL 2.1, section 2.8",
            format!("vertex {last} lies more than {} bytes on", limits::MAX_BUFFER_SIZE),
        ));
    };
    Ok((Buffer::new(pointer.bytes_from(bytes.start, bytes.len()).to_vec()), first))
}

/// A copy of a range of a buffer, if that has it and it is at most a quarter.
pub(crate) fn small_range(buffer: &Buffer, range: Range<usize>) -> Option<Buffer> {
    let bytes = buffer.bytes();
    let part = bytes.get(range).filter(|part| part.len() <= bytes.len() / 4)?;
    Some(Buffer::new(part.to_vec()))
}

/// The vertices of a draw by index, in the order of the indices, where they lie so far scattered that they are copied
/// one by one; not where something reads their numbers.
pub(crate) fn scattered_vertices(
    context: &Context,
    bytes: &[u8],
    (ty, base_vertex): (IndexType, GLint),
    vertex_range: VertexRange<'_>,
) -> Option<Vec<u32>> {
    if vertex_range.is_dense(bytes.len() / ty.size())
        || context.compiling.is_some()
        || context.watched.is_some()
        || vertex_range.last >= array_limits(context)[0]
        || reads_vertex_id(context)
    {
        return None;
    }
    let indices = bytes.chunks_exact(ty.size()).map(IndexType::index);
    Some(indices.map(|index| index.wrapping_add_signed(base_vertex)).collect())
}

/// Whether the program in use reads `gl_VertexID`.
fn reads_vertex_id(context: &Context) -> bool {
    let linked = context.executable();
    let values =
        linked.and_then(|linked| linked.vertex.as_ref()).map(|stage| &stage.module().values);
    values.into_iter().flatten().any(|value| matches!(value, Expr::Input(Input::VertexId)))
}

/// A copy of vertices of an array, in the order of `vertices`.
fn gathered(context: &Context, array: &Array, vertices: &[u32]) -> Buffer {
    let size = array.size();
    let mut bytes = Vec::with_capacity(vertices.len() * size);
    let (memory, offset) = match &array.source {
        Source::Client(buffer) => (buffer.bytes(), 0),
        Source::Pointer(_) => (&[][..], 0),
        Source::Object { buffer, offset } => {
            let object = context.objects.shared.buffers.bound(buffer);
            (object.map_or(&[][..], |object| object.buffer().bytes()), *offset)
        }
    };
    for &vertex in vertices {
        let at = vertex as usize * array.step + offset;
        bytes.extend_from_slice(match &array.source {
            Source::Client(_) | Source::Object { .. } => {
                memory.get(at..at + size).unwrap_or_default()
            }
            Source::Pointer(pointer) => pointer.bytes_from(at, size),
        });
    }
    Buffer::new(bytes)
}

/// The array of a location as the driver reads it, for a draw of a range of vertices.
pub(crate) fn vertex_source(
    context: &Context,
    location: usize,
    vertex_range: VertexRange<'_>,
) -> Result<VertexSource> {
    let array = &context.state.arrays.by_location[location];
    let scattered = vertex_range.scattered.filter(|_| array.divisor == 0);
    // Far beyond every buffer where it overflows.
    let base = vertex_range.base(array).saturating_mul(array.step);
    let (buffer, first, offset) = match (&array.source, scattered) {
        (_, Some(vertices)) => (gathered(context, array, vertices), 0, 0),
        (Source::Client(buffer), None) => (buffer.clone(), 0, base),
        (Source::Pointer(pointer), None) => {
            let (buffer, first) = snapshot(array, *pointer, vertex_range)?;
            (buffer, first, 0)
        }
        (Source::Object { buffer, offset }, None) => {
            match context.objects.shared.buffers.bound(buffer) {
                Some(object) if object.is_mapped_alone() => return mapped(buffer.name(), location),
                Some(object) => {
                    let place = vertex_range.bytes(array, *offset);
                    let part = place.filter(|_| object.is_rewritten(&context.recorder));
                    let part = part.and_then(|(bytes, first)| {
                        Some((small_range(object.buffer(), bytes)?, first, 0))
                    });
                    part.unwrap_or_else(|| {
                        (object.buffer().clone(), 0, offset.saturating_add(base))
                    })
                }
                None => (Buffer::default(), 0, *offset),
            }
        }
    };
    Ok(VertexSource::Array {
        buffer,
        first,
        offset,
        stride: if scattered.is_some() { array.size() } else { array.step },
        ty: array.ty,
        components: array.components,
        format: array.format,
        divisor: array.divisor,
    })
}

#[cfg(test)]
mod tests {
    use crate::base::args::Data;
    use crate::base::constants::*;
    use crate::context::{Context, ContextDesc};
    use rasterizer::driver::Command;

    /// Where the bytes of the first buffer are.
    fn place(c: &Context) -> *const u8 {
        c.objects.shared.buffers.get(1).expect("a buffer").buffer().bytes().as_ptr()
    }

    fn draw_and_write(c: &mut Context) {
        c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, Data::Bytes(&[7, 8, 9]));
        c.buffer_sub_data(GL_ARRAY_BUFFER, 0, 4, Data::Bytes(&[1; 4]));
        c.draw_arrays(GL_TRIANGLES, 3, 3);
        c.map_buffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
        c.unmap_buffer(GL_ARRAY_BUFFER);
    }

    #[test]
    fn a_buffer_is_copied_once_and_then_draws_take_parts() {
        let mut c = Context::new(ContextDesc::default()).expect("a device");
        c.bind_buffer(GL_ARRAY_BUFFER, 1);
        c.buffer_data(GL_ARRAY_BUFFER, 1 << 16, Data::Null, GL_STREAM_DRAW);
        c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
        c.enable_client_state(GL_VERTEX_ARRAY);
        let first = place(&c);
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        c.buffer_sub_data(GL_ARRAY_BUFFER, 0, 4, Data::Bytes(&[1; 4]));
        let copy = place(&c);
        assert_ne!(copy, first);
        for _ in 0..3 {
            draw_and_write(&mut c);
            assert_eq!(place(&c), copy);
        }
        // What is no longer written is read where it is.
        (0..2000).for_each(|_| c.draw_arrays(GL_TRIANGLES, 3, 3));
        c.buffer_sub_data(GL_ARRAY_BUFFER, 0, 4, Data::Bytes(&[1; 4]));
        assert_ne!(place(&c), copy);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    }

    /// How many bytes of arrays the last draw has.
    fn bytes(c: &Context) -> usize {
        let binds = c.recorder.commands.commands.iter().rev().find_map(|command| match command {
            Command::BindVertices(vertices) => Some(vertices),
            _ => None,
        });
        let buffers = binds.expect("a draw").iter().filter_map(|vertex| vertex.source.buffer());
        buffers.map(|buffer| buffer.bytes().len()).sum()
    }

    #[test]
    fn vertices_that_lie_far_apart_are_taken_one_by_one() {
        let mut c = Context::new(ContextDesc::default()).expect("a device");
        c.bind_buffer(GL_ARRAY_BUFFER, 1);
        c.buffer_data(GL_ARRAY_BUFFER, 800_000, Data::Null, GL_STREAM_DRAW);
        c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
        c.enable_client_state(GL_VERTEX_ARRAY);
        let draw = |c: &mut Context, indices: &[u32]| {
            let (count, indices) = (indices.len() as i32, bytemuck::cast_slice(indices));
            c.draw_elements(GL_TRIANGLES, count, GL_UNSIGNED_INT, Data::Bytes(indices));
            bytes(c)
        };
        assert_eq!(draw(&mut c, &[5, 99_999, 7]), 800_000);
        c.buffer_sub_data(GL_ARRAY_BUFFER, 0, 4, Data::Bytes(&[1; 4]));
        assert_eq!(draw(&mut c, &[5, 99_999, 7]), 3 * 8);
        // What lies between a few is taken as well.
        assert_eq!(draw(&mut c, &[5, 9, 7]), 5 * 8);
        // What is mapped is refused as ever.
        c.map_buffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
        draw(&mut c, &[5, 99_999, 7]);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION);
        let _ = c.messages();
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    }
}
