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
    /// As a pointer call gave it; 0 is tightly packed.
    pub stride: usize,
    /// Bytes from one element to the next; 0 where all are the same one (`ARB_vertex_attrib_binding`).
    pub step: usize,
    pub source: Source,
    /// 0 for an element a vertex, else one for so many instances.
    pub divisor: u32,
    /// The count of `EXT_vertex_array`; kept, not used.
    pub count: usize,
}

/// The binding point that a generic attribute reads, and where its first byte lies in an element
/// (`ARB_vertex_attrib_binding`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct AttributeBinding {
    pub binding: u8,
    pub relative_offset: usize,
}

/// A binding point of generic attributes: a range of a buffer object, or nothing.
#[derive(Clone, Debug)]
pub(crate) struct VertexBufferBinding {
    pub buffer: Bound,
    pub offset: usize,
    pub stride: usize,
    pub divisor: u32,
}

/// How many generic attributes and binding points of them there are.
const GENERICS: usize = MAX_VERTEX_ATTRIBS as usize;

/// The arrays by attribute location.
#[derive(Clone, Debug)]
pub(crate) struct Arrays {
    /// What draws read. Of generic attributes, that follows from their bindings, but for memory of the client.
    pub by_location: [Array; LOCATIONS],
    /// By generic attribute.
    pub attributes: [AttributeBinding; GENERICS],
    /// By binding point.
    pub bindings: [VertexBufferBinding; GENERICS],
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
                step: 16,
                source: Source::Client(Buffer::default()),
                divisor: 0,
                count: 0,
            }),
            attributes: std::array::from_fn(|location| AttributeBinding {
                binding: location as u8,
                relative_offset: 0,
            }),
            bindings: std::array::from_fn(|_| VertexBufferBinding {
                buffer: Bound::default(),
                offset: 0,
                stride: 16,
                divisor: 0,
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
        for binding in &mut self.bindings {
            binding.buffer.forget(gone);
        }
    }

    /// Gives the attributes of a binding point what is bound to it.
    pub fn binding_changed(&mut self, binding: u8) {
        for location in 0..GENERICS {
            if self.attributes[location].binding == binding {
                self.attribute_changed(location);
            }
        }
    }

    /// Gives a generic attribute what is bound to its binding point.
    pub fn attribute_changed(&mut self, location: usize) {
        let AttributeBinding { binding, relative_offset } = self.attributes[location];
        let VertexBufferBinding { buffer, offset, stride, divisor } =
            &self.bindings[usize::from(binding)];
        let array = &mut self.by_location[location];
        array.source = match buffer.name() {
            0 => Source::Client(Buffer::default()),
            _ => Source::Object {
                buffer: buffer.clone(),
                offset: offset.saturating_add(relative_offset),
            },
        };
        (array.step, array.divisor) = (*stride, *divisor);
    }

    /// What a pointer call does to the bindings: the attribute has the binding point of its own number
    /// (`ARB_vertex_attrib_binding`, section 2.8).
    pub fn pointer_given(&mut self, location: usize) {
        let Some(attribute) = self.attributes.get_mut(location) else { return };
        *attribute = AttributeBinding { binding: location as u8, relative_offset: 0 };
        let array = &mut self.by_location[location];
        let binding = &mut self.bindings[location];
        (binding.buffer, binding.offset) = match &array.source {
            Source::Object { buffer, offset } => (buffer.clone(), *offset),
            Source::Client(_) | Source::Pointer(_) => (Bound::default(), 0),
        };
        binding.stride = array.step;
        array.divisor = binding.divisor;
        // Other attributes may have its binding point.
        for other in 0..GENERICS {
            if other != location && usize::from(self.attributes[other].binding) == location {
                self.attribute_changed(other);
            }
        }
    }
}

impl Array {
    /// The size as it was given.
    pub fn given_size(&self) -> GLenum {
        if self.format == VertexFormat::NormalizedBgra { GL_BGRA } else { self.components.into() }
    }

    /// Bytes of a vertex.
    pub(crate) fn size(&self) -> usize {
        self.ty.bytes(self.components)
    }
}

/// Types of words that hold four components (`ARB_vertex_type_2_10_10_10_rev`).
pub(crate) const PACKED: Table<VertexType> =
    Table { section: "ARB_vertex_type_2_10_10_10_rev, section 2.7", rows: ALL_TYPES.split_at(2).0 };

/// Types of words that generic attributes are set by (`ARB_vertex_type_10f_11f_11f_rev`).
pub(crate) const PACKED_GENERIC: Table<VertexType> = Table {
    section: "ARB_vertex_type_10f_11f_11f_rev, section 2.7",
    rows: &[
        (GL_INT_2_10_10_10_REV, VertexType::I1010102),
        (GL_UNSIGNED_INT_2_10_10_10_REV, VertexType::U1010102),
        (GL_UNSIGNED_INT_10F_11F_11F_REV, VertexType::F111110),
    ],
};

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
    (GL_UNSIGNED_INT_10F_11F_11F_REV, VertexType::F111110),
];
/// Types of generic attributes.
pub(crate) const ANY_TYPE: Table<VertexType> =
    Table { section: "GL 3.0, table 2.5, and ARB_ES2_compatibility", rows: ALL_TYPES };

/// Those of OpenGL ES.
pub(crate) const ES_TYPE: Table<VertexType> =
    Table { section: "OpenGL ES 3.0, table 2.2", rows: ALL_TYPES.split_at(12).0 };

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
    pub arrays: Box<Arrays>,
    pub element_array_buffer: Bound,
}
