//! Offsets of the members of a uniform block: ARB_uniform_buffer_object, section 2.15.3.1.2. Every
//! layout is laid out like this.

use crate::types::{MatrixOrder, Type};

/// The base alignment of a `vec4`, to which all but short vectors are rounded up.
const VEC4: u32 = 16;

/// The base alignment of a type, in bytes (rules 1 to 10).
pub fn alignment(ty: &Type) -> u32 {
    match ty {
        Type::Vector(_, 1) => 4,
        Type::Vector(_, 2) => 8,
        Type::Vector(..)
        | Type::Matrix(..)
        | Type::Array(..)
        | Type::Struct(_)
        | Type::Sampler(_)
        | Type::Void
        | Type::Error => VEC4,
    }
}

/// The bytes of a type, with the padding at the end of arrays and structures.
pub fn size(ty: &Type, order: MatrixOrder) -> u32 {
    match ty {
        Type::Vector(_, size) => u32::from(*size) * 4,
        Type::Matrix(columns, rows) => match order {
            MatrixOrder::Columns => u32::from(*columns) * VEC4,
            MatrixOrder::Rows => u32::from(*rows) * VEC4,
        },
        Type::Array(element, len) => stride(element, order).saturating_mul(len.unwrap_or(0)),
        Type::Struct(structure) => {
            let end = structure.fields.iter().fold(0, |end, (_, field)| {
                aligned_offset(end, field).saturating_add(size(field, order))
            });
            padded(end)
        }
        Type::Sampler(_) | Type::Void | Type::Error => 0,
    }
}

/// Bytes from an element of an array to the next (rules 4, 6, 8 and 10).
pub fn stride(element: &Type, order: MatrixOrder) -> u32 {
    padded(size(element, order))
}

/// Bytes from a column or a row of a matrix to the next (rules 5 and 7); 0 of other types.
pub fn matrix_stride(ty: &Type) -> u32 {
    if matches!(ty, Type::Matrix(..)) { VEC4 } else { 0 }
}

/// The offset of a member after `end` bytes: `end`, rounded up to the base alignment of its type.
pub fn aligned_offset(end: u32, ty: &Type) -> u32 {
    end.checked_next_multiple_of(alignment(ty)).unwrap_or(u32::MAX)
}

/// Rounded up to the base alignment of a `vec4`.
pub fn padded(end: u32) -> u32 {
    end.checked_next_multiple_of(VEC4).unwrap_or(u32::MAX)
}
