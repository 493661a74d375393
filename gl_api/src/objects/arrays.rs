//! Vertex arrays (GL 2.1, section 2.8) and vertex array objects (`ARB_vertex_array_object`).
//!
//! A Rust slice cannot be kept, so it is copied by the pointer call: later writes to it are not seen. Buffer objects,
//! and pointers of C programs, are read when the draw is made.

use crate::base::client_memory::ClientPointer;
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_value};
use crate::base::limits::LOCATIONS;
use crate::base::types::*;
use crate::interface::MAX_VERTEX_ATTRIBS;
use crate::interface::*;
use crate::objects::bound::Bound;
use rasterizer::driver::{Buffer, VertexFormat, VertexType};

/// The memory of an array.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    /// A copy of the client's memory.
    Client(Buffer),
    /// The memory of a C program, not null.
    Pointer(ClientPointer<'static>),
    /// A buffer object, from a byte on.
    Object { buffer: Bound, offset: usize },
}

/// One attribute's array.
#[derive(Clone, Debug)]
pub(crate) struct Array {
    pub enabled: bool,
    pub components: u8,
    pub ty: VertexType,
    pub format: VertexFormat,
    /// As it was given; 0 is tightly packed.
    pub stride: usize,
    pub source: Source,
    /// 0 for an element a vertex, else one for so many instances.
    pub divisor: u32,
    /// The count of `EXT_vertex_array`; kept, not used.
    pub count: usize,
}

/// The arrays by attribute location.
#[derive(Clone, Debug)]
pub(crate) struct Arrays {
    pub by_location: [Array; LOCATIONS],
}

impl Default for Arrays {
    fn default() -> Self {
        Self {
            by_location: std::array::from_fn(|location| Array {
                enabled: false,
                components: if location == usize::from(ATTRIB_SECONDARY_COLOR) { 3 } else { 4 },
                ty: VertexType::F32,
                format: VertexFormat::Plain,
                stride: 0,
                source: Source::Client(Buffer::default()),
                divisor: 0,
                count: 0,
            }),
        }
    }
}

impl Arrays {
    /// Empties arrays in a deleted buffer object.
    pub fn forget_buffer(&mut self, gone: &Bound) {
        for array in &mut self.by_location {
            if matches!(&array.source, Source::Object { buffer, .. } if buffer == gone) {
                array.source = Source::Client(Buffer::default());
            }
        }
    }
}

impl Array {
    /// The size as it was given.
    pub fn given_size(&self) -> GLenum {
        if self.format == VertexFormat::NormalizedBgra { GL_BGRA } else { self.components.into() }
    }

    /// Bytes from one vertex to the next.
    pub(crate) fn step(&self) -> usize {
        if self.stride > 0 { self.stride } else { self.size() }
    }

    /// Bytes of a vertex.
    pub(crate) fn size(&self) -> usize {
        self.ty.bytes(self.components)
    }
}

/// Types of words that hold four components (`ARB_vertex_type_2_10_10_10_rev`).
pub(crate) const PACKED: Table<VertexType> =
    Table { section: "ARB_vertex_type_2_10_10_10_rev, section 2.7", rows: ALL_TYPES.split_at(2).0 };

pub(crate) const ALL_TYPES: &[(GLenum, VertexType)] = &[
    (GL_INT_2_10_10_10_REV, VertexType::I1010102),
    (GL_UNSIGNED_INT_2_10_10_10_REV, VertexType::U1010102),
    (GL_SHORT, VertexType::I16),
    (GL_INT, VertexType::I32),
    (GL_FLOAT, VertexType::F32),
    (GL_DOUBLE, VertexType::F64),
    (GL_HALF_FLOAT, VertexType::F16),
    (GL_BYTE, VertexType::I8),
    (GL_UNSIGNED_BYTE, VertexType::U8),
    (GL_UNSIGNED_SHORT, VertexType::U16),
    (GL_UNSIGNED_INT, VertexType::U32),
    (GL_FIXED, VertexType::Fixed),
];
/// Types of generic attributes.
pub(crate) const ANY_TYPE: Table<VertexType> =
    Table { section: "GL 3.0, table 2.5, and ARB_ES2_compatibility", rows: ALL_TYPES };

/// A generic attribute's location.
pub(crate) fn generic(index: GLuint) -> Result<u8> {
    match u8::try_from(index) {
        Ok(index) if index < MAX_VERTEX_ATTRIBS => Ok(index),
        _ => no_attribute(index),
    }
}

/// The error for a generic attribute that does not exist.
#[cold]
#[inline(never)]
pub(crate) fn no_attribute<T>(index: GLuint) -> Result<T> {
    const SECTION: &str = "GL 2.1, section 2.8";
    if index == GLuint::MAX {
        return invalid_value(
            SECTION,
            "index = -1 is what glGetAttribLocation answers where the program has no such attribute: \
             it is misspelt, or nothing uses it",
        );
    }
    let rule = format!("index = {index} must be below GL_MAX_VERTEX_ATTRIBS, {MAX_VERTEX_ATTRIBS}");
    invalid_value(SECTION, rule)
}

/// What a vertex array object holds while it is not bound.
#[derive(Clone, Debug, Default)]
pub(crate) struct VertexArray {
    pub arrays: Arrays,
    pub element_array_buffer: Bound,
}
