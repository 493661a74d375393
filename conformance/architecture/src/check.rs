//! Whether a crate's files keep to the order of its layers.

use crate::graph::{Graph, layer_of};
use std::collections::BTreeSet;
use std::fmt;

/// The largest circle of files inside a layer.
pub const LARGEST_CIRCLE: usize = 12;

/// A rule that the sources break.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Violation {
    /// A file names something of a layer above its own.
    Upward {
        /// The crate, the file under its `src`, and the line.
        at: String,
        /// The file under `src` that is above.
        to: String,
        /// What is named.
        names: Vec<String>,
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
            Self::Upward { at, to, names } => {
                write!(f, "{at} → {to}: {}", names.join(", "))
            }
            Self::Circle(files) => {
                write!(
                    f,
                    "a circle of {} files (at most {LARGEST_CIRCLE}): {}",
                    files.len(),
                    files.join(", ")
                )
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
    let mut violations = Vec::new();
    let layers: BTreeSet<&str> =
        graph.files.iter().filter(|file| *file != "lib.rs").map(|file| layer_of(file)).collect();
    let named = |layer: &str| format!("{}/src/{layer}", graph.name);
    let unlisted = layers.iter().filter(|layer| !order.iter().any(|known| known == *layer));
    violations.extend(unlisted.map(|layer| Violation::Unlisted(named(layer))));
    let absent = order.iter().filter(|layer| !layers.contains(layer.as_str()));
    violations.extend(absent.map(|layer| Violation::Absent(named(layer))));
    let rank = |file: usize| order.iter().position(|layer| layer == layer_of(&graph.files[file]));
    for ((from, to), references) in &graph.edges {
        if let (Some(below), Some(above)) = (rank(*from), rank(*to))
            && below < above
        {
            let line = references.first().map_or(0, |reference| reference.line);
            let names: BTreeSet<_> =
                references.iter().map(|reference| reference.name.clone()).collect();
            violations.push(Violation::Upward {
                at: format!("{}/src/{}:{line}", graph.name, graph.files[*from]),
                to: graph.files[*to].clone(),
                names: names.into_iter().collect(),
            });
        }
    }
    let circles = graph.file_circles().into_iter().filter(|circle| circle.len() > LARGEST_CIRCLE);
    violations.extend(circles.map(Violation::Circle));
    violations
}
