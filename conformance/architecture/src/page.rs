//! The order of layers, as ARCHITECTURE.md prints it.

use std::collections::BTreeMap;
use std::ops::Range;

/// The tables of the page: crate name to its layers, from below. A table begins with a row whose first cell is
/// ``layer of `crate` ``, and each of its rows names one layer in its first cell.
pub fn orders(page: &str) -> BTreeMap<String, Vec<String>> {
    let mut orders: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut current: Option<String> = None;
    for line in page.lines() {
        let Some(cell) = line.strip_prefix("| ").and_then(|row| row.split(" | ").next()) else {
            if !line.starts_with("|-") {
                current = None;
            }
            continue;
        };
        if let Some(name) = cell.strip_prefix("layer of ").and_then(quoted) {
            current = Some(name.to_owned());
            orders.insert(name.to_owned(), Vec::new());
        } else if let Some(name) = &current
            && let Some(layer) = quoted(cell)
        {
            orders.entry(name.clone()).or_default().push(layer.to_owned());
        }
    }
    orders
}

/// The text of a cell between backquotes.
fn quoted(cell: &str) -> Option<&str> {
    let range: Range<usize> = cell.find('`')? + 1..cell.rfind('`')?;
    cell.get(range)
}
