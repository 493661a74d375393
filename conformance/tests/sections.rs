//! `docs/conformance.md` names every check, and no other.

use conformance::chapters::checks;
use std::collections::BTreeSet;

const PAGE: &str = include_str!("../../docs/conformance.md");

/// The cells of the rows of the tables of sections, without their headings.
fn rows() -> Vec<Vec<&'static str>> {
    PAGE.lines()
        .take_while(|line| *line != "## Mistakes in the driver")
        .filter(|line| line.starts_with("| ") && !line.starts_with("| section"))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect()
}

/// The checks that a row names.
fn named(row: &[&'static str]) -> Vec<&'static str> {
    let cell = row.last().copied().unwrap_or_default();
    if cell.starts_with("*none*") {
        return Vec::new();
    }
    cell.split(',').map(|name| name.trim().trim_matches('`')).collect()
}

#[test]
fn the_page_names_every_check_and_no_other() {
    let known: BTreeSet<&str> = checks().map(|check| check.name).collect();
    let named: BTreeSet<&str> = rows().iter().flat_map(|row| named(row)).collect();
    let unknown: Vec<&&str> = named.difference(&known).collect();
    let unnamed: Vec<&&str> = known.difference(&named).collect();
    assert!(unknown.is_empty(), "docs/conformance.md names checks that do not exist: {unknown:?}");
    assert!(unnamed.is_empty(), "docs/conformance.md has no section for {unnamed:?}");
}

#[test]
fn every_row_has_checks_or_says_that_there_are_none() {
    let rows = rows();
    assert!(rows.len() > 100, "{} rows", rows.len());
    for row in rows {
        assert_eq!(row.len(), 3, "{row:?}");
        let empty = named(&row).is_empty();
        assert!(empty == row[2].starts_with("*none*"), "{row:?}");
    }
}

#[test]
fn names_of_checks_are_distinct() {
    let mut seen = BTreeSet::new();
    for check in checks() {
        assert!(seen.insert(check.name), "two checks are called {}", check.name);
    }
}
