//! The references between the files of a crate.

use crate::circles::circles;
use crate::methods::{self, extensions};
use crate::resolve::{Target, resolve};
use crate::sources::{File, Sources, Written};
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
    /// The crate's folder, relative to the workspace's root.
    pub folder: String,
    /// The files. Those without a layer have no references.
    pub files: Vec<File>,
    /// Why a file needs another.
    pub edges: BTreeMap<(usize, usize), BTreeSet<Reference>>,
}

impl Graph {
    /// The graph of a crate.
    pub fn of(sources: &Sources) -> Self {
        let mut edges = Edges { files: &sources.files, found: BTreeMap::new() };
        for scope in 0..sources.modules.len() {
            paths(sources, scope, &mut edges);
            macros(sources, scope, &mut edges);
        }
        calls(sources, &mut edges);
        let edges = edges.found;
        Self { folder: sources.folder.clone(), files: sources.files.clone(), edges }
    }

    /// The layers, by name.
    pub fn layers(&self) -> BTreeSet<&str> {
        self.files.iter().filter_map(|file| file.layer.as_deref()).collect()
    }

    /// The references between layers.
    pub fn layer_edges(&self) -> BTreeSet<(&str, &str)> {
        self.edges
            .keys()
            .filter_map(|(from, to)| Some((self.layer(*from)?, self.layer(*to)?)))
            .filter(|(from, to)| from != to)
            .collect()
    }

    /// The circles of layers, largest first.
    pub fn layer_circles(&self) -> Vec<Vec<&str>> {
        circles(&self.layer_edges())
    }

    /// The circles of files, within layers or across them, largest first.
    pub fn file_circles(&self) -> Vec<Vec<&str>> {
        let path = |file: usize| self.files[file].path.as_str();
        circles(&self.edges.keys().map(|(from, to)| (path(*from), path(*to))).collect())
    }

    /// The layer of a file.
    pub fn layer(&self, file: usize) -> Option<&str> {
        self.files[file].layer.as_deref()
    }
}

struct Edges<'a> {
    files: &'a [File],
    found: BTreeMap<(usize, usize), BTreeSet<Reference>>,
}

impl Edges<'_> {
    fn add(&mut self, from: usize, to: usize, line: usize, name: String) {
        let has_layer = |file: usize| self.files[file].layer.is_some();
        if from != to && has_layer(from) && has_layer(to) {
            self.found.entry((from, to)).or_default().insert(Reference { line, name });
        }
    }
}

fn paths(sources: &Sources, scope: usize, edges: &mut Edges<'_>) {
    let module = &sources.modules[scope];
    let mut add = |path: &Written, target: &Target| {
        let (Target::Item(to, _) | Target::Module(to)) = target;
        edges.add(module.file, sources.modules[*to].file, path.line, path.segments.join("::"));
    };
    for path in &module.paths {
        resolve(sources, scope, &path.segments)
            .iter()
            .filter(|target| matches!(target, Target::Item(..)))
            .for_each(|target| add(path, target));
    }
    for import in &module.imports {
        for target in resolve(sources, scope, &import.path.segments) {
            match target {
                Target::Item(..) => add(&import.path, &target),
                // A module that is only named by its name stands in other paths, which count; a glob of it
                // may be what gives the tokens of a macro their names.
                Target::Module(_) if import.name == "*" => add(&import.path, &target),
                Target::Module(_) => {}
            }
        }
    }
}

/// `name!(…)`: the definition of this file or of the nearest module around, otherwise what an import names, otherwise
/// the only one of that name.
fn macros(sources: &Sources, scope: usize, edges: &mut Edges<'_>) {
    let module = &sources.modules[scope];
    for (name, line) in &module.macro_calls {
        let Some(definitions) = sources.macros.get(name) else { continue };
        let file_of = |module: usize| sources.modules[module].file;
        let is_own = definitions.iter().any(|macro_| file_of(macro_.module) == module.file);
        if is_own {
            continue;
        }
        let mut around = sources.modules[scope].parent;
        let mut nearest = None;
        while let Some(outer) = around
            && nearest.is_none()
        {
            nearest = definitions.iter().find(|macro_| macro_.module == outer).map(|_| outer);
            around = sources.modules[outer].parent;
        }
        let imported = || match methods::item(resolve(sources, scope, std::slice::from_ref(name))) {
            Some(Target::Item(to, _)) => Some(to),
            Some(Target::Module(_)) | None => None,
        };
        let only = || match definitions.as_slice() {
            [only] => Some(only.module),
            _ => None,
        };
        if let Some(to) = nearest.or_else(imported).or_else(only) {
            edges.add(module.file, file_of(to), *line, format!("{name}!"));
        }
    }
}

/// Methods that another layer adds to a type: `value.method()`, `Type::method(value)`, `Self::method(value)`.
fn calls(sources: &Sources, edges: &mut Edges<'_>) {
    let extensions = extensions(sources);
    for (scope, module) in sources.modules.iter().enumerate() {
        for (name, line) in &module.calls {
            if let Some(extension) = extensions.get(name.as_str()) {
                edges.add(module.file, extension.file, *line, format!(".{name}()"));
            }
        }
        for path in &module.paths {
            if let [of @ .., name] = path.segments.as_slice()
                && let Some(extension) = extensions.get(name.as_str())
                && (*of == ["Self"] || resolve(sources, scope, of).contains(&extension.of))
            {
                edges.add(module.file, extension.file, path.line, path.segments.join("::"));
            }
        }
    }
}
