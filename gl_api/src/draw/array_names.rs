//! Vertex arrays in messages: what a client calls them, where they lie, and what is wrong with them.

use crate::base::args::Data;
use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation};
use crate::base::limits;
use crate::base::types::*;
use crate::context::Context;
use crate::interface::{ATTRIB_TEX_COORD, ATTRIB_VERTEX, MAX_VERTEX_ATTRIBS};
use crate::objects::arrays::Source;
use crate::state::enable::CLIENT_ARRAY;

/// The location of the array that an attribute is read from: generic attribute 0 and the vertex array
/// stand in for each other (GL 2.1, section 2.8).
pub(crate) fn array_of(context: &Context, location: usize) -> usize {
    let vertex = usize::from(ATTRIB_VERTEX);
    match (location, context.state.arrays.by_location[0].enabled) {
        (0, false) => vertex,
        (at, true) if at == vertex => 0,
        (other, _) => other,
    }
}

/// What a client calls the array of a location.
fn array_name(location: usize) -> String {
    let location = location as u8;
    if location < MAX_VERTEX_ATTRIBS {
        return format!("array {location}");
    }
    if location >= ATTRIB_TEX_COORD {
        return format!("GL_TEXTURE_COORD_ARRAY of unit {}", location - ATTRIB_TEX_COORD);
    }
    enum_name(CLIENT_ARRAY.encode(location))
}

/// The size of the array behind an attribute, for a message that it is too short.
#[cold]
#[inline(never)]
pub(crate) fn extent(context: &Context, location: u8, bytes: usize) -> String {
    let location = array_of(context, location.into());
    let array = array_name(location);
    let source = &context.state.arrays.by_location[location].source;
    let name = if let Source::Object { buffer, .. } = source { buffer.name() } else { 0 };
    match source {
        Source::Object { offset, .. } if *offset > limits::MAX_BUFFER_SIZE => format!(
            "{array} reads buffer {name} from byte {offset} on, which looks like a pointer: buffer \
             {name} was bound to GL_ARRAY_BUFFER when it was set; call \
             glBindBuffer(GL_ARRAY_BUFFER, 0) before"
        ),
        Source::Object { offset, .. } => format!(
            "{array} reads buffer {name} (bound to GL_ARRAY_BUFFER when its pointer was set) from \
             byte {offset} on, which has {bytes} bytes"
        ),
        Source::Client(_) | Source::Pointer(_) if bytes == 0 => format!(
            "{array} has no memory: no buffer was bound to GL_ARRAY_BUFFER when its pointer was \
             set, and the pointer was NULL"
        ),
        Source::Client(_) | Source::Pointer(_) => format!("{array} has {bytes} bytes"),
    }
}

/// Refuses the client's memory where a vertex array object would have to keep its address
/// (`ARB_vertex_array_object`, section 2.10).
pub(crate) fn refuse_client_memory(context: &Context, pointer: &Data<'_>) -> Result<()> {
    let bindings = &context.state.bindings;
    let is_memory = match pointer {
        Data::Bytes(_) => true,
        Data::Client(pointer) => !pointer.is_null(),
        Data::Offset(_) | Data::Null => false,
    };
    if !is_memory || bindings.vertex_array == 0 || bindings.array_buffer.name() != 0 {
        return Ok(());
    }
    invalid_operation(
        "ARB_vertex_array_object, section 2.10",
        format!(
            "pointer is memory, but vertex array object {} is bound, which reads buffer objects \
             only: bind a buffer to GL_ARRAY_BUFFER, or call glBindVertexArray(0)",
            bindings.vertex_array
        ),
    )
}

/// Refuses to read an array whose buffer is mapped.
#[cold]
#[inline(never)]
pub(crate) fn mapped<T>(name: GLuint, location: usize) -> Result<T> {
    let array = array_name(location);
    invalid_operation(
        "GL 3.1, section 2.9",
        format!("{array} reads buffer {name}, which is mapped: call glUnmapBuffer"),
    )
}
