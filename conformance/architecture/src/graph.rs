//! The references between the files of a crate.

use crate::resolve::{Target, resolve};
use crate::sources::Sources;
use std::collections::{BTreeMap, BTreeSet};

/// Where a file names something of another.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Reference {
    /// Line, from 1.
    pub line: usize,
    /// What is named there.
    pub name: String,
}

/// The references between files: `(from, to)` by index in [`Graph::files`].
#[derive(Debug)]
pub struct Graph {
    /// The crate's name.
    pub name: String,
    /// Files relative to `src`.
    pub files: Vec<String>,
    /// Why a file needs another.
    pub edges: BTreeMap<(usize, usize), BTreeSet<Reference>>,
}

/// The layer of a file: its first folder, or its own name without `.rs`.
pub fn layer_of(file: &str) -> &str {
    file.split('/').next().map_or(file, |first| first.strip_suffix(".rs").unwrap_or(first))
}

impl Graph {
    /// The graph of a crate. The crate's root (`lib.rs`) only lists and re-exports, and is left out.
    pub fn of(sources: &Sources) -> Self {
        let mut edges: BTreeMap<(usize, usize), BTreeSet<Reference>> = BTreeMap::new();
        let mut add = |from: usize, to: usize, line: usize, name: String| {
            let is_root = |file: usize| sources.files[file] == "lib.rs";
            if from != to && !is_root(from) && !is_root(to) {
                edges.entry((from, to)).or_default().insert(Reference { line, name });
            }
        };
        for (index, module) in sources.modules.iter().enumerate() {
            let imported = module.imports.iter().map(|import| &import.path);
            for path in imported.chain(&module.paths) {
                let target = resolve(sources, index, &path.segments);
                if let Some(Target::Item(to, _)) = target {
                    let to = sources.modules[to].file;
                    add(module.file, to, path.line, path.segments.join("::"));
                }
            }
            for (name, line) in &module.macro_calls {
                if let Some(to) = sources.macros.get(name) {
                    add(module.file, *to, *line, format!("{name}!"));
                }
            }
        }
        let extensions = extensions(sources);
        for module in &sources.modules {
            for (name, line) in &module.calls {
                if let Some(to) = extensions.get(name.as_str()) {
                    add(module.file, *to, *line, format!(".{name}()"));
                }
            }
        }
        Self { name: sources.name.clone(), files: sources.files.clone(), edges }
    }

    /// The circles of more than one node among `nodes`, largest first: strongly connected components (Tarjan 1972).
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
            search.visit(node);
        }
        let mut circles = search.found;
        circles.sort_by_key(|circle| std::cmp::Reverse(circle.len()));
        circles
    }

    /// The references between layers.
    pub fn layer_edges(&self) -> BTreeSet<(String, String)> {
        self.edges
            .keys()
            .map(|(from, to)| (layer_of(&self.files[*from]), layer_of(&self.files[*to])))
            .filter(|(from, to)| from != to)
            .map(|(from, to)| (from.to_owned(), to.to_owned()))
            .collect()
    }

    /// The circles of files, within layers or across them.
    pub fn file_circles(&self) -> Vec<Vec<String>> {
        let name = |index: usize| self.files[index].clone();
        Self::circles(&self.edges.keys().map(|(from, to)| (name(*from), name(*to))).collect())
    }
}

/// Methods that one file alone defines, outside of the layer of their type, under a name that no other type and no
/// trait of the crate has.
fn extensions(sources: &Sources) -> BTreeMap<&str, usize> {
    let mut definitions: BTreeMap<&str, Vec<Option<usize>>> = BTreeMap::new();
    for (index, module) in sources.modules.iter().enumerate() {
        for (of, method) in &module.methods {
            let home = match resolve(sources, index, &of.segments) {
                Some(Target::Item(to, _)) => Some(sources.modules[to].file),
                _ => None,
            };
            let is_outside = home.is_some_and(|home| {
                layer_of(&sources.files[home]) != layer_of(&sources.files[module.file])
            });
            definitions.entry(method).or_default().push(is_outside.then_some(module.file));
        }
        for method in &module.trait_methods {
            definitions.entry(method).or_default().push(None);
        }
    }
    definitions
        .into_iter()
        .filter_map(|(name, files)| match files.as_slice() {
            [Some(file)] => Some((name, *file)),
            _ => None,
        })
        .collect()
}

/// The state of Tarjan's search.
struct Search<'a, N> {
    targets: &'a BTreeMap<&'a N, Vec<&'a N>>,
    index: BTreeMap<&'a N, usize>,
    low: BTreeMap<&'a N, usize>,
    stack: Vec<&'a N>,
    found: Vec<Vec<N>>,
}

impl<'a, N: Ord + Clone> Search<'a, N> {
    fn visit(&mut self, node: &'a N) {
        if self.index.contains_key(node) {
            return;
        }
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
            let circle: Vec<N> = self.stack.split_off(at).into_iter().cloned().collect();
            if circle.len() > 1 {
                self.found.push(circle);
            }
        }
    }
}
