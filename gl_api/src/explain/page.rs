//! Lines of text with the section of the specification beside them.

use std::fmt::Write;

/// Where the second column begins.
const COLUMN: usize = 96;

/// A page of text.
#[derive(Debug, Default)]
pub struct Page {
    text: String,
}

impl Page {
    /// A line, indented by `depth` steps, with the section of its formula.
    pub fn line(&mut self, depth: usize, text: &str, section: &str) {
        let indent = "  ".repeat(depth);
        let line = format!("{indent}{text}");
        let line = if section.is_empty() {
            line
        } else {
            format!("{line:<width$}  {section}", width = COLUMN)
        };
        let _ = writeln!(self.text, "{}", line.trim_end());
    }

    /// An empty line.
    pub fn gap(&mut self) {
        self.text.push('\n');
    }

    /// A table: each column as wide as its widest cell, numbers to the left.
    pub fn table(&mut self, depth: usize, rows: &[Vec<String>]) {
        let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
        let width = |column: usize| {
            let cells = rows.iter().filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..columns).map(width).collect();
        for row in rows {
            let cells = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}"));
            self.line(depth, &cells.collect::<Vec<_>>().join("  "), "");
        }
    }

    /// The text of the page.
    pub fn text(self) -> String {
        self.text
    }
}

/// A number as short as it can be without losing a bit.
pub fn number(value: f32) -> String {
    let size = value.abs();
    if value == 0.0 || (1e-4..1e7).contains(&size) || !value.is_finite() {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// Several numbers in parentheses.
pub fn numbers(values: &[f32]) -> String {
    let values: Vec<String> = values.iter().map(|&value| number(value)).collect();
    format!("({})", values.join(", "))
}
