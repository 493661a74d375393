//! Whether a crate's files keep to the order of its layers.

use crate::graph::Graph;
use std::collections::BTreeSet;
use std::fmt;

/// The largest circle of files that is allowed.
pub const LARGEST_CIRCLE: usize = 12;

/// A rule that the sources break. Files are relative to the workspace's root.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Violation {
    /// A file names something of a layer above its own.
    Upward {
        /// The file.
        from: String,
        /// The line of the first reference, from 1.
        line: usize,
        /// The file above.
        to: String,
        /// What is named.
        names: BTreeSet<String>,
    },
    /// A circle of too many files.
    Circle(Vec<String>),
    /// A layer that the page does not list.
    Unlisted(String),
    /// A layer that the page lists and the crate does not have.
    Absent(String),
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Upward { from, line, to, names } => {
                let names: Vec<&str> = names.iter().map(String::as_str).collect();
                write!(f, "{from}:{line} → {to}: {}", names.join(", "))
            }
            Self::Circle(files) => {
                let count = files.len();
                write!(f, "a circle of {count} files (at most {LARGEST_CIRCLE}): ")?;
                write!(f, "{}", files.join(", "))
            }
            Self::Unlisted(layer) => {
                write!(f, "{layer}: no row of ARCHITECTURE.md's table has this layer")
            }
            Self::Absent(layer) => write!(
                f,
                "{layer}: ARCHITECTURE.md has a row for it, and the crate has no such layer"
            ),
        }
    }
}

/// Compares a crate with the order of its layers, from below.
pub fn check(graph: &Graph, order: &[String]) -> Vec<Violation> {
    let mut violations = rows(graph, order);
    let rank = |file: usize| {
        graph.layer(file).and_then(|layer| order.iter().position(|listed| listed == layer))
    };
    for ((from, to), references) in &graph.edges {
        if let (Some(below), Some(above)) = (rank(*from), rank(*to))
            && below < above
        {
            violations.push(Violation::Upward {
                from: located(graph, &graph.files[*from].path),
                line: references.first().map_or(0, |reference| reference.line),
                to: located(graph, &graph.files[*to].path),
                names: references.iter().map(|reference| reference.name.clone()).collect(),
            });
        }
    }
    violations.extend(large_circles(graph));
    violations
}

/// The circles of more than [`LARGEST_CIRCLE`] files.
pub fn large_circles(graph: &Graph) -> Vec<Violation> {
    graph
        .file_circles()
        .into_iter()
        .filter(|circle| circle.len() > LARGEST_CIRCLE)
        .map(|circle| circle.into_iter().map(|file| located(graph, file)).collect())
        .map(Violation::Circle)
        .collect()
}

/// The layers without a row, and the rows without a layer.
fn rows(graph: &Graph, order: &[String]) -> Vec<Violation> {
    let layers = graph.layers();
    let listed: BTreeSet<&str> = order.iter().map(String::as_str).collect();
    let unlisted = layers.difference(&listed).map(|layer| located(graph, layer));
    let absent = listed.difference(&layers).map(|layer| located(graph, layer));
    unlisted.map(Violation::Unlisted).chain(absent.map(Violation::Absent)).collect()
}

/// A file or layer, from the workspace's root.
fn located(graph: &Graph, path: &str) -> String {
    format!("{}/src/{path}", graph.folder)
}
