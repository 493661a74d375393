//! What a crate offers: its public items with their signatures, by the paths that dependents use, `pub use` followed.
//!
//! Items that macros make are not among them: those of the table of entry points are in docs/entry-points.md.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use syn::spanned::Spanned;
use syn::{Attribute, Fields, ImplItem, Item, TraitItem, UseTree, Visibility};

#[derive(Default)]
struct Module {
    items: Vec<Item>,
    children: BTreeMap<String, usize>,
    parent: usize,
}

#[derive(Clone, Copy)]
enum Target<'a> {
    Module(usize),
    Item(&'a Item),
}

/// A name that a `use` brings in: what it stands for, and its name; `*` for a glob.
type Used = (Vec<String>, String);

#[derive(Default)]
struct Crate {
    modules: Vec<Module>,
    /// Public methods, and traits, by the name of their type.
    of_types: BTreeMap<String, BTreeSet<String>>,
}

/// The public items of the crate whose sources are in `src`, one a line.
///
/// # Errors
/// When a file cannot be read or parsed.
pub fn listing(src: &Path) -> Result<BTreeSet<String>, Box<dyn Error>> {
    let mut all = Crate::default();
    all.read(&src.join("lib.rs"), src.to_owned(), 0)?;
    let mut lines = BTreeSet::new();
    all.exports(0, "", &mut Vec::new(), &mut lines);
    Ok(lines)
}

impl Crate {
    fn read(
        &mut self,
        file: &Path,
        folder: PathBuf,
        parent: usize,
    ) -> Result<usize, Box<dyn Error>> {
        let text =
            fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
        let parsed = syn::parse_file(&text)?;
        self.module(parsed.items, &folder, parent)
    }

    fn module(
        &mut self,
        items: Vec<Item>,
        folder: &Path,
        parent: usize,
    ) -> Result<usize, Box<dyn Error>> {
        let index = self.modules.len();
        self.modules.push(Module { parent, ..Module::default() });
        let mut kept = Vec::new();
        for mut item in items {
            if hidden(attributes(&item)) {
                continue;
            }
            if let Item::Impl(block) = &item {
                self.methods(block);
            }
            if let Item::Mod(module) = &mut item {
                let name = module.ident.to_string();
                let below = folder.join(&name);
                let child = match module.content.take() {
                    Some((_, items)) => self.module(items, &below, index)?,
                    None => {
                        let beside = folder.join(format!("{name}.rs"));
                        let file = if beside.exists() { beside } else { below.join("mod.rs") };
                        self.read(&file, below, index)?
                    }
                };
                self.modules[index].children.insert(name, child);
            }
            kept.push(item);
        }
        self.modules[index].items = kept;
        Ok(index)
    }

    /// Takes note of what an `impl` gives its type.
    fn methods(&mut self, block: &syn::ItemImpl) {
        let syn::Type::Path(of) = &*block.self_ty else { return };
        let Some(name) = of.path.segments.last().map(|last| last.ident.to_string()) else { return };
        let lines = self.of_types.entry(name).or_default();
        if let Some((_, of_trait, _)) = &block.trait_ {
            lines.insert(format!("impl {}", source(of_trait)));
            return;
        }
        for item in &block.items {
            match item {
                ImplItem::Fn(method) if public(&method.vis) && !hidden(&method.attrs) => {
                    lines.insert(source(&method.sig));
                }
                ImplItem::Const(one) if public(&one.vis) && !hidden(&one.attrs) => {
                    lines.insert(format!("const {}: {}", one.ident, source(&one.ty)));
                }
                _ => {}
            }
        }
    }

    /// What a path means in a module.
    fn find(
        &self,
        from: usize,
        path: &[String],
        seen: &mut Vec<(usize, String)>,
    ) -> Option<Target<'_>> {
        let (name, rest) = path.split_first()?;
        let next = match name.as_str() {
            "crate" => Some(0),
            "self" => Some(from),
            "super" => Some(self.modules[from].parent),
            _ => self.modules[from].children.get(name).copied(),
        };
        if let Some(next) = next {
            return if rest.is_empty() {
                Some(Target::Module(next))
            } else {
                self.find(next, rest, seen)
            };
        }
        if rest.is_empty() {
            let own = |item: &&Item| named(item).is_some_and(|own| own == *name);
            if let Some(item) = self.modules[from].items.iter().find(own) {
                return Some(Target::Item(item));
            }
        }
        // A circle of globs ends here.
        if seen.contains(&(from, name.clone())) {
            return None;
        }
        seen.push((from, name.clone()));
        for (mut path, own) in self.modules[from].items.iter().flat_map(uses) {
            if own == "*" {
                path.extend(self.find(from, &path.clone(), seen).map(|_| name.clone()));
            } else if own != *name {
                continue;
            }
            if path.first() == Some(name) && path.len() == 1 {
                continue;
            }
            path.extend(rest.iter().cloned());
            if let Some(found) = self.find(from, &path, seen) {
                return Some(found);
            }
        }
        None
    }

    /// Adds the public items of a module, as items of `path`.
    fn exports(
        &self,
        module: usize,
        path: &str,
        within: &mut Vec<usize>,
        lines: &mut BTreeSet<String>,
    ) {
        if within.contains(&module) {
            return;
        }
        within.push(module);
        for item in &self.modules[module].items {
            if !visibility(item).is_some_and(public) {
                continue;
            }
            if let Item::Mod(one) = item {
                let child = self.modules[module].children[&one.ident.to_string()];
                self.exports(child, &format!("{path}{}::", one.ident), within, lines);
            }
            for (used, name) in uses(item) {
                match (self.find(module, &used, &mut Vec::new()), name.as_str()) {
                    (Some(Target::Module(found)), "*") => self.exports(found, path, within, lines),
                    (Some(Target::Module(found)), name) => {
                        self.exports(found, &format!("{path}{name}::"), within, lines);
                    }
                    (Some(Target::Item(found)), name) => self.describe(found, path, name, lines),
                    (None, name) => {
                        lines.insert(format!("{path}{name} = {}", used.join("::")));
                    }
                }
            }
            if let Some(name) = named(item) {
                self.describe(item, path, &name, lines);
            }
        }
        within.pop();
    }

    /// Adds the lines of an item.
    fn describe(&self, item: &Item, path: &str, name: &str, lines: &mut BTreeSet<String>) {
        let at = format!("{path}{name}");
        let open = if attributes(item).iter().any(|one| one.path().is_ident("non_exhaustive")) {
            ", non_exhaustive"
        } else {
            ""
        };
        let mut line = |what: String| {
            lines.insert(format!("{at}: {what}"));
        };
        match item {
            Item::Fn(one) => line(source(&one.sig)),
            Item::Const(one) => line(format!("const {}", source(&one.ty))),
            Item::Static(one) => line(format!("static {}", source(&one.ty))),
            Item::Type(one) => line(format!("type {}", source(&one.ty))),
            Item::Struct(one) => {
                line(format!("struct{open}"));
                fields(&one.fields).into_iter().for_each(&mut line);
            }
            Item::Enum(one) => {
                line(format!("enum{open}"));
                for variant in &one.variants {
                    let of = match &variant.fields {
                        Fields::Unit => String::new(),
                        of @ (Fields::Named(_) | Fields::Unnamed(_)) => format!(" {}", source(of)),
                    };
                    line(format!("variant {}{of}", variant.ident));
                }
            }
            Item::Trait(one) => {
                line("trait".to_owned());
                for item in &one.items {
                    match item {
                        TraitItem::Fn(method) => line(source(&method.sig)),
                        TraitItem::Const(one) => {
                            line(format!("const {}: {}", one.ident, source(&one.ty)))
                        }
                        TraitItem::Type(one) => line(format!("type {}", one.ident)),
                        _ => {}
                    }
                }
            }
            _ => {}
        }
        if matches!(item, Item::Struct(_) | Item::Enum(_)) {
            let derived = attributes(item).iter().filter(|one| one.path().is_ident("derive"));
            derived.for_each(|one| line(source(&one.meta)));
            let own = named(item).and_then(|own| self.of_types.get(&own));
            own.into_iter().flatten().for_each(|text| line(text.clone()));
        }
    }
}

/// The public fields.
fn fields(all: &Fields) -> Vec<String> {
    let name = |at: usize, field: &syn::Field| {
        field.ident.as_ref().map_or(at.to_string(), ToString::to_string)
    };
    let open = all.iter().enumerate().filter(|(_, field)| public(&field.vis));
    open.map(|(at, field)| format!("field {}: {}", name(at, field), source(&field.ty))).collect()
}

/// The text of a part of the sources, on one line.
fn source(part: &impl Spanned) -> String {
    let text = part.span().source_text().unwrap_or_default();
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    let line = code.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ");
    line.replace("( ", "(").replace(", )", ")").replace(",)", ")")
}

fn public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// Not for dependents: of tests, or without documentation.
fn hidden(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|one| {
        let text = source(&one.meta);
        text == "cfg(test)" || text == "doc(hidden)"
    })
}

fn uses(item: &Item) -> Vec<Used> {
    let mut found = Vec::new();
    if let Item::Use(one) = item {
        flatten(&one.tree, &mut Vec::new(), &mut found);
    }
    found
}

fn flatten(tree: &UseTree, before: &mut Vec<String>, found: &mut Vec<Used>) {
    let with = |name: &syn::Ident| [before.as_slice(), &[name.to_string()]].concat();
    match tree {
        UseTree::Path(path) => {
            before.push(path.ident.to_string());
            flatten(&path.tree, before, found);
            before.pop();
        }
        UseTree::Name(name) if name.ident == "self" => {
            found.push((before.clone(), before.last().cloned().unwrap_or_default()));
        }
        UseTree::Name(name) => found.push((with(&name.ident), name.ident.to_string())),
        UseTree::Rename(name) => found.push((with(&name.ident), name.rename.to_string())),
        UseTree::Glob(_) => found.push((before.clone(), "*".to_owned())),
        UseTree::Group(group) => group.items.iter().for_each(|tree| flatten(tree, before, found)),
    }
}

/// The parts of an item that most kinds have.
macro_rules! part {
    ($item:expr, $one:ident => $part:expr) => {
        match $item {
            Item::Const($one) => Some($part),
            Item::Enum($one) => Some($part),
            Item::Static($one) => Some($part),
            Item::Struct($one) => Some($part),
            Item::Trait($one) => Some($part),
            Item::Type($one) => Some($part),
            _ => None,
        }
    };
}

fn visibility(item: &Item) -> Option<&Visibility> {
    match item {
        Item::Fn(one) => Some(&one.vis),
        Item::Mod(one) => Some(&one.vis),
        Item::Use(one) => Some(&one.vis),
        other => part!(other, one => &one.vis),
    }
}

fn named(item: &Item) -> Option<String> {
    match item {
        Item::Fn(one) => Some(one.sig.ident.to_string()),
        other => part!(other, one => one.ident.to_string()),
    }
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Fn(one) => &one.attrs,
        Item::Mod(one) => &one.attrs,
        Item::Use(one) => &one.attrs,
        Item::Impl(one) => &one.attrs,
        other => part!(other, one => one.attrs.as_slice()).unwrap_or_default(),
    }
}
