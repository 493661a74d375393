//! How varyings are packed into rows of four components (GLSL ES 1.00 appendix A, section 7). What fits by this rule
//! must link; here all else is refused, so that a program that links on one machine links on others.

use crate::types::Type;

/// A variable in the grid.
#[derive(Clone, Copy)]
struct Item {
    /// How many columns it takes, 1 to 4.
    columns: u8,
    /// How many rows.
    rows: u32,
}

/// Whether variables of these types fit into so many rows.
pub fn fit(types: &[&Type], rows: u32) -> bool {
    let mut items = Vec::new();
    for ty in types {
        add(ty, 1, &mut items);
    }
    // The widest first, and of one width the longest.
    items.sort_by_key(|item| std::cmp::Reverse((item.columns, item.rows)));
    let total = |columns: u8| {
        let all = items.iter().filter(|item| item.columns == columns);
        all.fold(0u32, |sum, item| sum.saturating_add(item.rows))
    };
    let whole = total(4);
    let wide = whole.saturating_add(total(3));
    let Some(below) = rows.checked_sub(wide) else { return false };
    // Pairs stand in the first two columns from above, then in the last two from below.
    let mut pairs = [0u32; 2];
    for item in items.iter().filter(|item| item.columns == 2) {
        let Some(half) = pairs.iter_mut().find(|half| **half + item.rows <= below) else {
            return false;
        };
        *half += item.rows;
    }
    let [left, right] = pairs;
    // The free rows of each column, which follow each other.
    let mut free = [below - left, below - left, below - right, rows - whole - right];
    for item in items.iter().filter(|item| item.columns == 1) {
        let fits = free.iter_mut().filter(|free| **free >= item.rows);
        let Some(column) = fits.min_by_key(|free| **free) else { return false };
        *column -= item.rows;
    }
    true
}

/// The items of `count` variables of a type: the elements of an array follow each other, and so do the columns of a
/// matrix; a `mat2` takes whole rows.
fn add(ty: &Type, count: u32, items: &mut Vec<Item>) {
    let item = |columns, rows: u32| Item { columns, rows: rows.saturating_mul(count) };
    match ty {
        Type::Vector(_, size) => items.push(item(*size, 1)),
        Type::Matrix(2, 2) => items.push(item(4, 2)),
        Type::Matrix(columns, rows) => items.push(item(*rows, u32::from(*columns))),
        Type::Array(element, len) => add(element, count.saturating_mul(len.unwrap_or(1)), items),
        Type::Struct(structure) => {
            structure.fields.iter().for_each(|(_, field)| add(field, count, items));
        }
        Type::Sampler(_) | Type::Void | Type::Error => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::types::{FLOAT, vec};

    #[test]
    fn what_fits() {
        let array = |ty: Type, len| Type::Array(Box::new(ty), Some(len));
        let (mat2, mat3) = (Type::Matrix(2, 2), Type::Matrix(3, 3));
        // The example of the appendix.
        let example = [
            vec(4),
            mat3.clone(),
            mat3,
            array(vec(2), 6),
            array(vec(2), 4),
            vec(2),
            array(FLOAT, 3),
            array(FLOAT, 2),
            FLOAT,
        ];
        let rows: &[(&[Type], u32, bool)] = &[
            (&example, 16, true),
            (&[array(vec(4), 8)], 8, true),
            (&[array(vec(4), 9)], 8, false),
            (&[array(vec(3), 8), array(FLOAT, 8)], 8, true),
            (&[array(vec(3), 9)], 8, false),
            (&[array(vec(3), 8), vec(2)], 8, false),
            (&[array(vec(2), 8), array(vec(2), 8)], 8, true),
            (&[array(vec(2), 8), array(FLOAT, 8), array(FLOAT, 8)], 8, true),
            (&[array(vec(2), 8), array(FLOAT, 9)], 8, false),
            (&[mat2.clone(), mat2.clone()], 4, true),
            (&[mat2.clone(), mat2], 3, false),
        ];
        for (types, rows, expected) in rows {
            let all: Vec<&Type> = types.iter().collect();
            assert_eq!(fit(&all, *rows), *expected, "{types:?} in {rows} rows");
        }
    }
}
