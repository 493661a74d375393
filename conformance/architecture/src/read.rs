//! Reads the files of a crate.

use crate::cfg::is_test;
use crate::error::ReadError;
use crate::manifest;
use crate::sources::{File, Import, MacroDefinition, Method, Module, Sources, Written};
use crate::tokens::{self, Mention};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use syn::visit::{self, Visit};

/// Reads the crate in `folder`, which is relative to `root`, from its `src/lib.rs`.
///
/// # Errors
/// When a file is missing or does not parse.
pub fn read_crate(root: &Path, folder: &str) -> Result<Sources, ReadError> {
    let mut sources = Sources {
        name: manifest::member(root, folder)?.name.replace('-', "_"),
        folder: folder.to_owned(),
        files: Vec::new(),
        modules: Vec::new(),
        macros: BTreeMap::new(),
    };
    let src = root.join(folder).join("src");
    let mut reader = Reader {
        sources: &mut sources,
        src: src.clone(),
        module: 0,
        directories: Directories { named: src.clone(), children: src.clone() },
        item_macros: Vec::new(),
        error: None,
    };
    reader.file(&src.join("lib.rs"), None, None);
    let Reader { item_macros, error, .. } = reader;
    match error {
        Some(error) => Err(error),
        None => {
            add_generated(&mut sources, &item_macros);
            Ok(sources)
        }
    }
}

/// Adds the names that macros define to the modules that call them. `names` of a call are those in its tokens, and the
/// macro's own: one macro may be handed to another.
fn add_generated(sources: &mut Sources, calls: &[ItemMacro]) {
    for call in calls {
        let definitions = call.names.iter().filter_map(|name| sources.macros.get(name)).flatten();
        let defined: BTreeSet<String> =
            definitions.flat_map(|definition| definition.defines.iter().cloned()).collect();
        let generated = &mut sources.modules[call.module].generated;
        generated.extend(call.names.iter().cloned());
        generated.extend(defined);
    }
}

/// A macro call in place of an item.
struct ItemMacro {
    module: usize,
    names: BTreeSet<String>,
}

/// Where the files of child modules are.
#[derive(Clone)]
struct Directories {
    /// What `#[path]` is relative to.
    named: PathBuf,
    /// Where `mod name;` is looked up.
    children: PathBuf,
}

/// Visits the items of one scope.
struct Reader<'a> {
    sources: &'a mut Sources,
    src: PathBuf,
    /// The scope that is visited, an index in [`Sources::modules`].
    module: usize,
    directories: Directories,
    item_macros: Vec<ItemMacro>,
    /// The first error; nothing is read after it.
    error: Option<ReadError>,
}

impl Reader<'_> {
    /// Reads a file as a module. `children` is where its child modules are, its own directory if `None`.
    fn file(&mut self, path: &Path, parent: Option<(usize, &str)>, children: Option<PathBuf>) {
        let text = match fs::read_to_string(path) {
            Ok(text) => text,
            Err(source) => return self.fail(ReadError::Io { path: path.to_owned(), source }),
        };
        let parsed = match syn::parse_file(&text) {
            Ok(parsed) => parsed,
            Err(source) => return self.fail(ReadError::Syntax { path: path.to_owned(), source }),
        };
        if is_test(&parsed.attrs) {
            return;
        }
        let relative = path.strip_prefix(&self.src).unwrap_or(path);
        let names: Vec<_> = relative.iter().map(|name| name.to_string_lossy()).collect();
        let layer = parent.map(|(parent, name)| {
            let above = self.sources.modules[parent].file;
            self.sources.files[above].layer.clone().unwrap_or_else(|| name.to_owned())
        });
        self.sources.files.push(File { path: names.join("/"), layer });
        let own = path.parent().unwrap_or(path).to_owned();
        let children = children.unwrap_or_else(|| own.clone());
        let file = self.sources.files.len() - 1;
        self.scope(
            Module { file, parent: parent.map(|(parent, _)| parent), ..Module::default() },
            parent.map(|(_, name)| name),
            Directories { named: own, children },
            |reader| parsed.items.iter().for_each(|item| reader.visit_item(item)),
        );
    }

    /// Visits what is inside of `module`, a child `name` of the current scope.
    fn scope(
        &mut self,
        module: Module,
        name: Option<&str>,
        directories: Directories,
        visit: impl FnOnce(&mut Self),
    ) {
        let index = self.sources.modules.len();
        self.sources.modules.push(module);
        if let Some(name) = name {
            self.current().children.insert(name.to_owned(), index);
        }
        let outer = std::mem::replace(&mut self.module, index);
        let outer_directories = std::mem::replace(&mut self.directories, directories);
        visit(self);
        self.module = outer;
        self.directories = outer_directories;
    }

    fn current(&mut self) -> &mut Module {
        &mut self.sources.modules[self.module]
    }

    fn fail(&mut self, error: ReadError) {
        self.error.get_or_insert(error);
    }

    fn import(&mut self, prefix: &[String], tree: &syn::UseTree) {
        let with = |name: &syn::Ident| {
            let mut segments = prefix.to_vec();
            if name != "self" || segments.is_empty() {
                segments.push(name.to_string());
            }
            Written { segments, line: name.span().start().line }
        };
        match tree {
            syn::UseTree::Path(path) => self.import(&with(&path.ident).segments, &path.tree),
            syn::UseTree::Name(name) => {
                let path = with(&name.ident);
                let name = path.segments.last().cloned().unwrap_or_default();
                self.current().imports.push(Import { name, path });
            }
            syn::UseTree::Rename(rename) => {
                let path = with(&rename.ident);
                self.current().imports.push(Import { name: rename.rename.to_string(), path });
            }
            syn::UseTree::Glob(glob) => {
                let line = glob.star_token.spans[0].start().line;
                let path = Written { segments: prefix.to_vec(), line };
                self.current().imports.push(Import { name: "*".to_owned(), path });
            }
            syn::UseTree::Group(group) => {
                group.items.iter().for_each(|tree| self.import(prefix, tree));
            }
        }
    }

    fn tokens(&mut self, tokens: proc_macro2::TokenStream) {
        let module = self.current();
        tokens::mentions(tokens, &mut |mention| match mention {
            Mention::Path(path) => module.paths.push(path),
            Mention::Macro(name, line) => module.macro_calls.push((name, line)),
            Mention::Method(name, line) => module.calls.push((name, line)),
        });
    }

    fn define(&mut self, name: &syn::Ident) {
        let name = name.to_string();
        self.current().items.insert(name);
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item(&mut self, item: &'ast syn::Item) {
        if self.error.is_some() || is_test(attributes(item)) {
            return;
        }
        match item {
            syn::Item::Const(item) => self.define(&item.ident),
            syn::Item::Enum(item) => self.define(&item.ident),
            syn::Item::Fn(item) => self.define(&item.sig.ident),
            syn::Item::Static(item) => self.define(&item.ident),
            syn::Item::Struct(item) => self.define(&item.ident),
            syn::Item::Trait(item) => self.define(&item.ident),
            syn::Item::Type(item) => self.define(&item.ident),
            syn::Item::Union(item) => self.define(&item.ident),
            _ => {}
        }
        visit::visit_item(self, item);
    }

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        let name = item.ident.to_string();
        let children = self.directories.children.join(&name);
        if let Some((_, items)) = &item.content {
            let inline = Module {
                file: self.sources.modules[self.module].file,
                parent: Some(self.module),
                ..Module::default()
            };
            let directories = Directories { named: children.clone(), children };
            self.scope(inline, Some(&name), directories, |reader| {
                items.iter().for_each(|item| reader.visit_item(item));
            });
        } else if let Some(given) = path_attribute(&item.attrs) {
            // A file with a given path has its child modules beside it, as `mod.rs` has.
            self.file(&self.directories.named.join(given), Some((self.module, &name)), None);
        } else {
            let flat = self.directories.children.join(format!("{name}.rs"));
            let file = if flat.exists() { flat } else { children.join("mod.rs") };
            self.file(&file, Some((self.module, &name)), Some(children));
        }
    }

    fn visit_item_macro(&mut self, item: &'ast syn::ItemMacro) {
        if let Some(name) = &item.ident {
            self.define(name);
            let defines = tokens::defined(item.mac.tokens.clone());
            let definition = MacroDefinition { module: self.module, defines };
            self.sources.macros.entry(name.to_string()).or_default().push(definition);
            self.tokens(item.mac.tokens.clone());
        } else {
            let mut names = tokens::names(item.mac.tokens.clone());
            names.extend(item.mac.path.segments.last().map(|last| last.ident.to_string()));
            self.item_macros.push(ItemMacro { module: self.module, names });
            self.visit_macro(&item.mac);
        }
    }

    fn visit_item_trait(&mut self, item: &'ast syn::ItemTrait) {
        for inner in &item.items {
            if let syn::TraitItem::Fn(method) = inner {
                let name = method.sig.ident.to_string();
                self.current().trait_methods.insert(name);
            }
        }
        visit::visit_item_trait(self, item);
    }

    fn visit_item_impl(&mut self, block: &'ast syn::ItemImpl) {
        if let (None, syn::Type::Path(of)) = (&block.trait_, &*block.self_ty) {
            for inner in &block.items {
                if let syn::ImplItem::Fn(method) = inner
                    && !is_test(&method.attrs)
                {
                    let method =
                        Method { of: written(&of.path), name: method.sig.ident.to_string() };
                    self.current().methods.push(method);
                }
            }
        }
        visit::visit_item_impl(self, block);
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        // `use ::name` is another crate.
        if item.leading_colon.is_none() {
            self.import(&[], &item.tree);
        }
    }

    fn visit_impl_item_fn(&mut self, method: &'ast syn::ImplItemFn) {
        if !is_test(&method.attrs) {
            visit::visit_impl_item_fn(self, method);
        }
    }

    fn visit_local(&mut self, local: &'ast syn::Local) {
        if !is_test(&local.attrs) {
            visit::visit_local(self, local);
        }
    }

    fn visit_block(&mut self, block: &'ast syn::Block) {
        let has_items = block.stmts.iter().any(|statement| matches!(statement, syn::Stmt::Item(_)));
        if !has_items {
            return visit::visit_block(self, block);
        }
        let around = &self.sources.modules[self.module];
        let inner = Module {
            file: around.file,
            parent: around.parent,
            enclosing: Some(self.module),
            ..Module::default()
        };
        let directories = self.directories.clone();
        self.scope(inner, None, directories, |reader| visit::visit_block(reader, block));
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            let path = written(path);
            self.current().paths.push(path);
        }
        visit::visit_path(self, path);
    }

    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        let name = call.method.to_string();
        self.current().calls.push((name, call.method.span().start().line));
        visit::visit_expr_method_call(self, call);
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        let path = written(&call.path);
        match path.segments.as_slice() {
            [name] => self.current().macro_calls.push((name.clone(), path.line)),
            _ => self.current().paths.push(path),
        }
        self.tokens(call.tokens.clone());
    }

    // `pub(in path)` and attributes name nothing that the code needs.
    fn visit_visibility(&mut self, _: &'ast syn::Visibility) {}

    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}
}

fn written(path: &syn::Path) -> Written {
    let segments: Vec<_> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
    let line = path.segments.first().map_or(0, |segment| segment.ident.span().start().line);
    Written { segments, line }
}

/// The file of `#[path = "file"] mod name;`.
fn path_attribute(attributes: &[syn::Attribute]) -> Option<String> {
    attributes.iter().find_map(|attribute| match &attribute.meta {
        syn::Meta::NameValue(pair) if pair.path.is_ident("path") => match &pair.value {
            syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
            _ => None,
        },
        _ => None,
    })
}

/// The attributes of an item.
fn attributes(item: &syn::Item) -> &[syn::Attribute] {
    match item {
        syn::Item::Const(item) => &item.attrs,
        syn::Item::Enum(item) => &item.attrs,
        syn::Item::ExternCrate(item) => &item.attrs,
        syn::Item::Fn(item) => &item.attrs,
        syn::Item::ForeignMod(item) => &item.attrs,
        syn::Item::Impl(item) => &item.attrs,
        syn::Item::Macro(item) => &item.attrs,
        syn::Item::Mod(item) => &item.attrs,
        syn::Item::Static(item) => &item.attrs,
        syn::Item::Struct(item) => &item.attrs,
        syn::Item::Trait(item) => &item.attrs,
        syn::Item::TraitAlias(item) => &item.attrs,
        syn::Item::Type(item) => &item.attrs,
        syn::Item::Union(item) => &item.attrs,
        syn::Item::Use(item) => &item.attrs,
        _ => &[],
    }
}
