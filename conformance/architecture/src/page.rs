//! What ARCHITECTURE.md prints: the order of layers, and the chain of crates.

use std::collections::BTreeMap;

/// The tables of the page: crate name to its layers, from below. A table begins with a row whose first cell is
/// ``layer of `crate` ``, and each of its rows has one layer in its first cell, between backquotes.
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

/// The chain of crates, the first text of the page between backquotes that has a `←`. Each link is a name or
/// `{name, name}`; crates depend on links before their own.
pub fn chain(page: &str) -> Vec<Vec<String>> {
    page.split('`')
        .skip(1)
        .step_by(2)
        .find(|text| text.contains('←'))
        .map(|text| text.split('←').map(link).collect())
        .unwrap_or_default()
}

fn link(text: &str) -> Vec<String> {
    text.trim().trim_matches(['{', '}']).split(',').map(|name| name.trim().to_owned()).collect()
}

/// The text of a cell between backquotes.
fn quoted(cell: &str) -> Option<&str> {
    cell.get(cell.find('`')? + 1..cell.rfind('`')?)
}

#[cfg(test)]
mod tests {
    use super::{chain, orders};

    #[test]
    fn tables_and_the_chain_are_read() {
        let page = "\
            | layer of `a` | is |\n|---|---|\n| `low` | `x` |\n| `high` | y |\n\n| `no` | layer |\n\
            text\n| layer of `b` | is |\n|---|---|\n| `one` | z |\n\n`a ←\n{b, c} ← d`";
        let orders = orders(page);
        assert_eq!(orders["a"], ["low", "high"]);
        assert_eq!(orders["b"], ["one"]);
        assert_eq!(chain(page), [vec!["a"], vec!["b", "c"], vec!["d"]]);
    }
}
