//! How wide text tables are.

use comfy_table::{Cell, CellAlignment, ColumnConstraint, ContentArrangement, Table, presets};

/// Columns of a terminal that a table fits into.
pub const NARROW: u16 = 100;

/// How a table is laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// In [`NARROW`] columns: texts wrap.
    Narrow,
    /// As wide as it is, with every column.
    Wide,
}

impl Layout {
    /// An empty table with these headings, whose first column does not wrap.
    pub(crate) fn table<'a>(self, headings: impl IntoIterator<Item = &'a str>) -> Table {
        let mut table = Table::new();
        table.load_preset(presets::UTF8_BORDERS_ONLY).set_header(headings);
        match self {
            Self::Narrow => {
                table.set_content_arrangement(ContentArrangement::Dynamic).set_width(NARROW);
                for column in table.column_iter_mut() {
                    column.set_padding((0, 1));
                }
            }
            Self::Wide => {
                table.set_content_arrangement(ContentArrangement::Disabled);
            }
        }
        if let Some(first) = table.column_mut(0) {
            first.set_constraint(ColumnConstraint::ContentWidth);
        }
        table
    }
}

/// A right-aligned cell.
pub(crate) fn right(text: String) -> Cell {
    Cell::new(text).set_alignment(CellAlignment::Right)
}

/// A number in three digits.
pub(crate) fn short(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        value if !value.is_finite() => value.to_string(),
        value if (100.0..100_000.0).contains(&value.abs()) => format!("{value:.0}"),
        value if (10.0..100.0).contains(&value.abs()) => format!("{value:.1}"),
        value if (0.01..10.0).contains(&value.abs()) => format!("{value:.2}"),
        value => format!("{value:.1e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let table = [
            (0.0, "0"),
            (0.25, "0.25"),
            (12.34, "12.3"),
            (4321.0, "4321"),
            (1.5e-7, "1.5e-7"),
            (2.5e9, "2.5e9"),
            (f64::INFINITY, "inf"),
        ];
        for (value, expected) in table {
            assert_eq!(short(value), expected);
        }
    }

    #[test]
    fn a_narrow_table_fits() {
        let mut table = Layout::Narrow.table(["name", "what"]);
        table.add_row(["a-name-that-stays-whole", &"words and more words ".repeat(20)]);
        let text = table.to_string();
        assert!(text.lines().all(|line| line.chars().count() <= NARROW.into()), "{text}");
        assert!(text.contains("a-name-that-stays-whole"), "{text}");
        let mut table = Layout::Wide.table(["name", "what"]);
        table.add_row(["a", &"words ".repeat(40)]);
        assert!(table.to_string().lines().any(|line| line.chars().count() > 200));
    }
}
