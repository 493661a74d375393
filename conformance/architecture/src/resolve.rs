//! From a path as it is written to the items that it names.

use crate::sources::Sources;
use std::collections::BTreeSet;

/// What a path names.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Target {
    /// A module of the crate, an index in [`Sources::modules`].
    Module(usize),
    /// An item: the module that defines it, and its name.
    Item(usize, String),
}

/// Follows `segments`, written in the scope `from`, through imports and re-exports. What stands behind an item (a
/// variant, a method) is not looked at. Nothing is found of what another crate defines, nor of local names; a function
/// and a module of one name are both found.
pub fn resolve(sources: &Sources, from: usize, segments: &[String]) -> BTreeSet<Target> {
    let find = |names| Resolver { sources, names, visited: BTreeSet::new() }.follow(from, segments);
    let found = find(Names::Written);
    if found.is_empty() { find(Names::Generated) } else { found }
}

/// The names of items that are looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Names {
    /// Those that the sources define.
    Written,
    /// Those that a macro call may define, too.
    Generated,
}

/// Where in a path a name is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Position {
    /// Before a `::`: what it names is a module or a type.
    Before,
    /// At the end.
    Last,
}

struct Resolver<'a> {
    sources: &'a Sources,
    names: Names,
    /// The names that are being looked up: two modules may import everything of each other.
    visited: BTreeSet<(usize, String, Position)>,
}

impl Resolver<'_> {
    fn follow(&mut self, from: usize, segments: &[String]) -> BTreeSet<Target> {
        let Some((mut module, rest)) = self.root(from, segments) else { return BTreeSet::new() };
        let Some((last, before)) = rest.split_last() else {
            return BTreeSet::from([Target::Module(module)]);
        };
        for name in before {
            let found = self.lookup(module, name, Position::Before);
            let inner = found.iter().find_map(|target| match target {
                Target::Module(inner) => Some(*inner),
                Target::Item(..) => None,
            });
            match inner {
                Some(inner) => module = inner,
                None => return found,
            }
        }
        self.lookup(module, last, Position::Last)
    }

    /// The module where a path begins, and the segments that are not `crate`, `self` or `super`. `None` for a `super`
    /// of the crate's root.
    fn root<'s>(&self, from: usize, segments: &'s [String]) -> Option<(usize, &'s [String])> {
        let (first, tail) = segments.split_first()?;
        let mut rest = tail;
        let mut module = match first.as_str() {
            "crate" => 0,
            "self" => self.around(from),
            "super" => self.sources.modules[self.around(from)].parent?,
            // `extern crate self as name`.
            name if *name == self.sources.name && !self.has_child(from, name) => 0,
            _ => return Some((from, segments)),
        };
        while let Some((first, tail)) = rest.split_first()
            && first == "super"
        {
            module = self.sources.modules[module].parent?;
            rest = tail;
        }
        Some((module, rest))
    }

    /// The module of a scope: a block's is the one around its function.
    fn around(&self, mut scope: usize) -> usize {
        while let Some(enclosing) = self.sources.modules[scope].enclosing {
            scope = enclosing;
        }
        scope
    }

    fn has_child(&self, scope: usize, name: &str) -> bool {
        self.sources.modules[self.around(scope)].children.contains_key(name)
    }

    /// What `name` is in a scope: its items, its children, its imports by name, and only then what globs bring in
    /// and what macro calls may have made.
    fn lookup(&mut self, scope: usize, name: &str, position: Position) -> BTreeSet<Target> {
        let key = (scope, name.to_owned(), position);
        if !self.visited.insert(key.clone()) {
            return BTreeSet::new();
        }
        let mut found = self.named(scope, name, position);
        if found.is_empty() {
            found = self.globbed(scope, name, position);
        }
        let module = &self.sources.modules[scope];
        if found.is_empty() && self.names == Names::Generated && module.generated.contains(name) {
            found.insert(Target::Item(scope, name.to_owned()));
        }
        if found.is_empty()
            && let Some(enclosing) = module.enclosing
        {
            found = self.lookup(enclosing, name, position);
        }
        self.visited.remove(&key);
        found
    }

    fn named(&mut self, scope: usize, name: &str, position: Position) -> BTreeSet<Target> {
        let module = &self.sources.modules[scope];
        let mut found: BTreeSet<Target> =
            module.children.get(name).map(|child| Target::Module(*child)).into_iter().collect();
        if position == Position::Before && !found.is_empty() {
            return found;
        }
        if module.items.contains(name) {
            found.insert(Target::Item(scope, name.to_owned()));
        }
        for import in module.imports.iter().filter(|import| import.name == name) {
            found.extend(self.follow(scope, &import.path.segments));
        }
        found
    }

    fn globbed(&mut self, scope: usize, name: &str, position: Position) -> BTreeSet<Target> {
        let mut found = BTreeSet::new();
        for import in self.sources.modules[scope].imports.iter().filter(|import| import.name == "*")
        {
            for target in self.follow(scope, &import.path.segments) {
                // A glob of an enum (an item) has only variants, and naming the enum is reference enough.
                if let Target::Module(inner) = target {
                    found.extend(self.lookup(inner, name, position));
                }
            }
        }
        found
    }
}
