//! From a path as it is written to the file that defines what it names.

use crate::sources::Sources;
use std::collections::BTreeSet;

/// What a path names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// A module of the crate.
    Module(usize),
    /// An item: the module that defines it, and its name.
    Item(usize, String),
}

/// Follows `segments`, written in module `from`, through imports and re-exports. `None` for what another crate
/// defines, or a local name.
pub fn resolve(sources: &Sources, from: usize, segments: &[String]) -> Option<Target> {
    let mut visited = BTreeSet::new();
    follow(sources, from, segments, &mut visited)
}

type Visited = BTreeSet<(usize, String)>;

fn follow(
    sources: &Sources,
    from: usize,
    segments: &[String],
    visited: &mut Visited,
) -> Option<Target> {
    let mut module = from;
    let mut rest = segments;
    let mut is_rooted = false;
    while let Some((first, tail)) = rest.split_first() {
        match first.as_str() {
            "crate" | "$crate" => module = 0,
            "self" => {}
            "super" => module = parent(sources, module)?,
            name if name == sources.name
                && !is_rooted
                && !sources.modules[module].children.contains_key(name) =>
            {
                module = 0;
            }
            _ => break,
        }
        is_rooted = true;
        rest = tail;
    }
    while let Some((first, tail)) = rest.split_first() {
        match lookup(sources, module, first, visited)? {
            Target::Module(inner) => module = inner,
            item @ Target::Item(..) => return Some(item),
        }
        rest = tail;
    }
    Some(Target::Module(module))
}

fn parent(sources: &Sources, module: usize) -> Option<usize> {
    let path = &sources.modules[module].path;
    let (_, above) = path.split_last()?;
    sources.modules.iter().position(|candidate| candidate.path == above)
}

/// A name in the scope of a module: its items, its children, its imports.
fn lookup(sources: &Sources, module: usize, name: &str, visited: &mut Visited) -> Option<Target> {
    if !visited.insert((module, name.to_owned())) {
        return None;
    }
    let scope = &sources.modules[module];
    let found = if scope.items.contains(name) {
        Some(Target::Item(module, name.to_owned()))
    } else if let Some(child) = scope.children.get(name) {
        Some(Target::Module(*child))
    } else {
        let named = scope.imports.iter().filter(|import| import.name == name);
        let globs = scope.imports.iter().filter(|import| import.name == "*");
        named
            .filter_map(|import| follow(sources, module, &import.path.segments, visited))
            .next()
            .or_else(|| {
                globs.into_iter().find_map(|import| {
                    match follow(sources, module, &import.path.segments, visited)? {
                        Target::Module(inner) => lookup(sources, inner, name, visited),
                        // An enum's variants.
                        Target::Item(..) => None,
                    }
                })
            })
    };
    visited.remove(&(module, name.to_owned()));
    found
}
