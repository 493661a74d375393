//! The results as a table and as JSON.

use super::entry::Entry;
use crate::window::Program;
use comfy_table::presets::UTF8_FULL_CONDENSED;
use comfy_table::{Cell, CellAlignment, ContentArrangement, Table};
use gl_api::explain::Explanation;
use serde_json::{Value, json};

/// A table with a row for each picture.
pub fn table(entries: &[Entry]) -> Table {
    let mut table = Table::new();
    table.load_preset(UTF8_FULL_CONDENSED);
    table.set_content_arrangement(ContentArrangement::Dynamic).set_width(100);
    table.set_header(["picture", "lecture", "size", "GL ms", "painting ms", "checksum", "errors"]);
    for Entry { program, rendered, .. } in entries {
        let number = |value: String| Cell::new(value).set_alignment(CellAlignment::Right);
        table.add_row([
            Cell::new(program.name),
            Cell::new(program.lecture),
            number(format!("{}×{}", rendered.picture.width, rendered.picture.height)),
            number(rendered.time.as_millis().to_string()),
            number(rendered.painting.as_millis().to_string()),
            Cell::new(format!("{:016x}", rendered.picture.checksum())),
            number(rendered.errors.len().to_string()),
        ]);
    }
    table
}

/// An object for each picture; times in milliseconds.
pub fn json(entries: &[Entry]) -> Value {
    let object = |Entry { program, rendered, plans, explained: _ }: &Entry| {
        json!({
            "name": program.name,
            "lecture": program.lecture,
            "width": rendered.picture.width,
            "height": rendered.picture.height,
            "gl_ms": rendered.time.as_secs_f64() * 1e3,
            "painting_ms": rendered.painting.as_secs_f64() * 1e3,
            "checksum": format!("{:016x}", rendered.picture.checksum()),
            "errors": rendered.errors,
            "plans": plans,
        })
    };
    entries.iter().map(object).collect()
}

/// The explanation of a pixel: its value and the lines of text.
pub fn explanation(program: &Program, [x, y]: [usize; 2], explanation: &Explanation) -> Value {
    json!({
        "name": program.name,
        "x": x,
        "y": y,
        "value": explanation.value,
        "lines": explanation.to_string().lines().collect::<Vec<_>>(),
    })
}
