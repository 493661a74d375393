//! Circles in a graph: strongly connected components (Tarjan, "Depth-first search and linear graph algorithms", 1972).

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// The circles of more than one node, largest first.
pub fn circles<N: Ord + Clone>(edges: &BTreeSet<(N, N)>) -> Vec<Vec<N>> {
    let mut targets: BTreeMap<&N, Vec<&N>> = BTreeMap::new();
    for (from, to) in edges {
        targets.entry(from).or_default().push(to);
        targets.entry(to).or_default();
    }
    let mut search = Search {
        targets: &targets,
        index: BTreeMap::new(),
        low: BTreeMap::new(),
        stack: Vec::new(),
        found: Vec::new(),
    };
    for node in targets.keys() {
        if !search.index.contains_key(node) {
            search.visit(node);
        }
    }
    let mut circles = search.found;
    circles.sort_by_key(|circle| Reverse(circle.len()));
    circles
}

/// The state of Tarjan's search.
struct Search<'a, N> {
    targets: &'a BTreeMap<&'a N, Vec<&'a N>>,
    /// The number of each node that was visited, in the order of visits.
    index: BTreeMap<&'a N, usize>,
    /// The lowest number that is reached from a node and still on the stack.
    low: BTreeMap<&'a N, usize>,
    stack: Vec<&'a N>,
    found: Vec<Vec<N>>,
}

impl<'a, N: Ord + Clone> Search<'a, N> {
    fn visit(&mut self, node: &'a N) {
        let number = self.index.len();
        self.index.insert(node, number);
        self.low.insert(node, number);
        self.stack.push(node);
        for next in &self.targets[node] {
            if !self.index.contains_key(next) {
                self.visit(next);
                self.low.insert(node, self.low[node].min(self.low[next]));
            } else if self.stack.contains(next) {
                self.low.insert(node, self.low[node].min(self.index[next]));
            }
        }
        if self.low[node] == self.index[node] {
            let at = self.stack.iter().position(|other| *other == node).unwrap_or(0);
            let mut circle: Vec<N> = self.stack.split_off(at).into_iter().cloned().collect();
            circle.sort();
            if circle.len() > 1 {
                self.found.push(circle);
            }
        }
    }
}
