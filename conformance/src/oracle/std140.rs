//! The std140 layout of uniform blocks (GL 3.1, section 2.11.4: standard uniform block layout, rules 1 to 10).

use crate::mutation::{Mutation, Variant};

/// The order of a matrix in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GLSL's names")]
pub enum Order {
    ColumnMajor,
    RowMajor,
}

/// The type of a member, in numbers of floats.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Type {
    /// A scalar or vector of so many components.
    Vector(usize),
    /// Columns and rows.
    Matrix(usize, usize),
    /// Elements.
    Array(Box<Self>, usize),
    /// Members, `m0` and so on.
    Struct(Vec<Self>),
}

/// A scalar of a member: what GLSL calls it, and the word of the buffer that has it.
pub type Leaf = (String, usize);

/// Alignment and size in words.
type Space = [usize; 2];

fn up(size: usize, alignment: usize) -> usize {
    size.next_multiple_of(alignment)
}

impl Type {
    fn space(&self, order: Order, variant: Variant) -> Space {
        let whole = if variant.has(Mutation::ArraysTight) { 1 } else { 4 };
        match self {
            // Rules 1 to 3.
            Self::Vector(3) if variant.has(Mutation::ThreeAlignedAsTwo) => [2, 3],
            Self::Vector(3) => [4, 3],
            Self::Vector(size) => [*size, *size],
            // Rules 5 and 7: an array of columns or of rows.
            Self::Matrix(columns, rows) => {
                let row_major = order == Order::RowMajor && !variant.has(Mutation::RowMajorIgnored);
                let (size, count) = if row_major { (*columns, *rows) } else { (*rows, *columns) };
                Self::Array(Box::new(Self::Vector(size)), count).space(order, variant)
            }
            // Rules 4, 6, 8 and 10.
            Self::Array(element, count) => {
                let [alignment, size] = element.space(order, variant);
                let alignment = up(alignment, whole);
                [alignment, up(size, alignment) * count]
            }
            // Rule 9.
            Self::Struct(members) => {
                let spaces = members.iter().map(|member| member.space(order, variant));
                let most = spaces.clone().map(|[alignment, _]| alignment).max().unwrap_or(1);
                let alignment = up(most, 4);
                let end = spaces.fold(0, |end, [alignment, size]| up(end, alignment) + size);
                let padded = !variant.has(Mutation::StructUnpadded);
                [alignment, if padded { up(end, alignment) } else { end }]
            }
        }
    }

    fn leaves(&self, name: &str, at: usize, order: Order, variant: Variant, out: &mut Vec<Leaf>) {
        match self {
            Self::Vector(1) => out.push((name.to_owned(), at)),
            Self::Vector(size) => {
                out.extend((0..*size).map(|i| (format!("{name}[{i}]"), at + i)));
            }
            Self::Matrix(columns, rows) => {
                let row_major = order == Order::RowMajor && !variant.has(Mutation::RowMajorIgnored);
                let line = Self::Vector(if row_major { *columns } else { *rows });
                let [_, stride] = Self::Array(Box::new(line), 1).space(order, variant);
                for column in 0..*columns {
                    for row in 0..*rows {
                        let place =
                            if row_major { row * stride + column } else { column * stride + row };
                        out.push((format!("{name}[{column}][{row}]"), at + place));
                    }
                }
            }
            Self::Array(element, count) => {
                let [_, stride] = Self::Array(element.clone(), 1).space(order, variant);
                for i in 0..*count {
                    element.leaves(&format!("{name}[{i}]"), at + i * stride, order, variant, out);
                }
            }
            Self::Struct(members) => {
                let mut end = 0;
                for (i, member) in members.iter().enumerate() {
                    let [alignment, size] = member.space(order, variant);
                    let place = up(end, alignment);
                    member.leaves(&format!("{name}.m{i}"), at + place, order, variant, out);
                    end = place + size;
                }
            }
        }
    }
}

/// Every scalar of a block's members, `b0` and so on, and the block's size in words.
pub fn leaves(members: &[(Type, Order)], variant: Variant) -> (Vec<Leaf>, usize) {
    let (mut out, mut end) = (Vec::new(), 0);
    for (i, (member, order)) in members.iter().enumerate() {
        let [alignment, size] = member.space(*order, variant);
        let place = up(end, alignment);
        member.leaves(&format!("b{i}"), place, *order, variant, &mut out);
        end = place + size;
    }
    (out, up(end, 4))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of ARB_uniform_buffer_object: a, b, c, f { d, e }, g, h[2], i, with offsets in bytes
    /// 0, 8, 16, 32 and 40, 48, 64 and 80, 96.
    #[test]
    fn the_example_of_the_specification() {
        let vector = |size| (Type::Vector(size), Order::ColumnMajor);
        let members = [
            vector(1),
            vector(2),
            vector(3),
            (Type::Struct(vec![Type::Vector(1), Type::Vector(2)]), Order::ColumnMajor),
            vector(1),
            (Type::Array(Box::new(Type::Vector(1)), 2), Order::ColumnMajor),
            (Type::Matrix(2, 3), Order::ColumnMajor),
        ];
        let (leaves, words) = leaves(&members, Variant::CORRECT);
        let at = |name: &str| leaves.iter().find(|leaf| leaf.0 == name).map(|leaf| 4 * leaf.1);
        let table = [
            ("b0", 0),
            ("b1[0]", 8),
            ("b2[2]", 24),
            ("b3.m0", 32),
            ("b3.m1[0]", 40),
            ("b4", 48),
            ("b5[1]", 80),
            ("b6[1][0]", 112),
        ];
        for (name, offset) in table {
            assert_eq!(at(name), Some(offset), "{name}");
        }
        assert_eq!(words, 32);
    }

    #[test]
    fn rows_are_vectors_of_columns() {
        let members = [(Type::Matrix(2, 3), Order::RowMajor)];
        let (leaves, words) = leaves(&members, Variant::CORRECT);
        assert_eq!(leaves[1], ("b0[0][1]".to_owned(), 4));
        assert_eq!(leaves[3], ("b0[1][0]".to_owned(), 1));
        assert_eq!(words, 12);
    }
}
