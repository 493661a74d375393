//! The modules of a crate, parsed.

use std::collections::{BTreeMap, BTreeSet};

/// A path as it is written.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Written {
    /// The names between `::`. Never empty.
    pub segments: Vec<String>,
    /// Line of the first segment, from 1.
    pub line: usize,
}

/// A name that a `use` brings into a module.
#[derive(Clone, Debug)]
pub struct Import {
    /// The name in this module; `*` for a glob, `_` for none.
    pub name: String,
    /// What it stands for.
    pub path: Written,
}

/// A method outside of traits.
#[derive(Clone, Debug)]
pub struct Method {
    /// The type of its `impl` block.
    pub of: Written,
    /// The method's name.
    pub name: String,
}

/// A source file.
#[derive(Clone, Debug)]
pub struct File {
    /// Path relative to `src`, with `/` between names.
    pub path: String,
    /// The layer: the module at the crate's root that the file belongs to. `None` for the root itself.
    pub layer: Option<String>,
}

/// A scope for names: a module, or a block of a function body that has items or imports of its own.
#[derive(Debug, Default)]
pub struct Module {
    /// Index of the file in [`Sources::files`].
    pub file: usize,
    /// The module that `super` names. `None` at the crate's root.
    pub parent: Option<usize>,
    /// The scope around a block. `None` for modules, where names from outside are not in scope.
    pub enclosing: Option<usize>,
    /// Child modules: name to index in [`Sources::modules`].
    pub children: BTreeMap<String, usize>,
    /// Names of the items that are defined here.
    pub items: BTreeSet<String>,
    /// Names that may be those of items that a macro call makes here.
    pub generated: BTreeSet<String>,
    /// What its `use` declarations bring in.
    pub imports: Vec<Import>,
    /// Every path outside of `use`; in the tokens of macros, those of more than one segment.
    pub paths: Vec<Written>,
    /// Calls of macros by a bare name, and the line.
    pub macro_calls: Vec<(String, usize)>,
    /// Method calls: name and line.
    pub calls: Vec<(String, usize)>,
    /// Methods outside of traits.
    pub methods: Vec<Method>,
    /// Methods of the traits that are defined here.
    pub trait_methods: BTreeSet<String>,
}

/// A `macro_rules!`, which has no path unless a `use` gives it one.
#[derive(Debug)]
pub struct MacroDefinition {
    /// Index of its module in [`Sources::modules`].
    pub module: usize,
    /// The names that its expansion may define, apart from those that it is given.
    pub defines: BTreeSet<String>,
}

/// All modules of a crate.
#[derive(Debug)]
pub struct Sources {
    /// The crate's name.
    pub name: String,
    /// The crate's folder, relative to the workspace's root.
    pub folder: String,
    /// The files; the first is `lib.rs`.
    pub files: Vec<File>,
    /// The scopes; the first is the crate's root.
    pub modules: Vec<Module>,
    /// Macros by name.
    pub macros: BTreeMap<String, Vec<MacroDefinition>>,
}
