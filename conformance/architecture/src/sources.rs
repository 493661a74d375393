//! The modules of a crate, parsed.

use proc_macro2::{TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use syn::visit::Visit;
use thiserror::Error;

/// Sources that cannot be read.
#[derive(Debug, Error)]
pub enum ReadError {
    /// A file is missing or unreadable.
    #[error("{path}: {source}")]
    Io {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: std::io::Error,
    },
    /// A file is not Rust.
    #[error("{path}:{line}: {source}")]
    Syntax {
        /// The file.
        path: PathBuf,
        /// The line of the error.
        line: usize,
        /// The reason.
        source: syn::Error,
    },
}

/// A path as it is written: the segments and the line of the first.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Written {
    /// The names between `::`.
    pub segments: Vec<String>,
    /// Line, from 1.
    pub line: usize,
}

/// A name that a `use` brings into a module.
#[derive(Clone, Debug)]
pub struct Import {
    /// The name in this module; `*` for a glob.
    pub name: String,
    /// What it stands for.
    pub path: Written,
}

/// A module, which may be part of a file.
#[derive(Debug, Default)]
pub struct Module {
    /// The names from the crate's root to here.
    pub path: Vec<String>,
    /// Index of the file in [`Sources::files`].
    pub file: usize,
    /// Child modules: name to index in [`Sources::modules`].
    pub children: BTreeMap<String, usize>,
    /// Names of the items that are defined here.
    pub items: BTreeSet<String>,
    /// What its `use` declarations bring in.
    pub imports: Vec<Import>,
    /// Every path of more than one segment outside of `use`, also in the tokens of macro calls.
    pub paths: Vec<Written>,
    /// Calls of macros by a bare name, and the line.
    pub macro_calls: Vec<(String, usize)>,
    /// Method calls: name and line.
    pub calls: Vec<(String, usize)>,
    /// Inherent methods: the type's path, the method's name.
    pub methods: Vec<(Written, String)>,
    /// Methods of traits that are defined here.
    pub trait_methods: BTreeSet<String>,
}

/// All modules of a crate.
#[derive(Debug)]
pub struct Sources {
    /// The crate's name.
    pub name: String,
    /// Files relative to `src`, with `/` between folders.
    pub files: Vec<String>,
    /// The modules; the first is the crate's root.
    pub modules: Vec<Module>,
    /// Macros by name (`macro_rules!` has no path): the file that defines each.
    pub macros: BTreeMap<String, usize>,
}

impl Sources {
    /// Reads the crate in `folder`, from `src/lib.rs`.
    ///
    /// # Errors
    /// When a file is missing or does not parse.
    pub fn read(name: &str, folder: &Path) -> Result<Self, ReadError> {
        let mut sources = Self {
            name: name.to_owned(),
            files: Vec::new(),
            modules: Vec::new(),
            macros: BTreeMap::new(),
        };
        let src = folder.join("src");
        let root = src.join("lib.rs");
        sources.file(&src, &root, Vec::new(), &src)?;
        Ok(sources)
    }

    /// Reads a file as the module `path`; its child modules are looked up in `children`.
    fn file(
        &mut self,
        src: &Path,
        file: &Path,
        path: Vec<String>,
        children: &Path,
    ) -> Result<usize, ReadError> {
        let text = fs::read_to_string(file)
            .map_err(|source| ReadError::Io { path: file.to_owned(), source })?;
        let parsed = syn::parse_file(&text).map_err(|source| ReadError::Syntax {
            path: file.to_owned(),
            line: source.span().start().line,
            source,
        })?;
        let relative = file.strip_prefix(src).unwrap_or(file);
        let names: Vec<_> = relative.iter().map(|part| part.to_string_lossy()).collect();
        self.files.push(names.join("/"));
        let index = self.files.len() - 1;
        self.module(src, &parsed.items, path, index, children)
    }

    fn module(
        &mut self,
        src: &Path,
        items: &[syn::Item],
        path: Vec<String>,
        file: usize,
        children: &Path,
    ) -> Result<usize, ReadError> {
        let index = self.modules.len();
        self.modules.push(Module { path: path.clone(), file, ..Module::default() });
        let mut reader = Reader::default();
        for item in items.iter().filter(|item| !is_test(attributes(item))) {
            if let syn::Item::Mod(module) = item {
                let name = module.ident.to_string();
                let mut inner = path.clone();
                inner.push(name.clone());
                let child = match &module.content {
                    Some((_, items)) => {
                        self.module(src, items, inner, file, &children.join(&name))?
                    }
                    None => {
                        let (file, folder) = module_file(module, children, &name);
                        self.file(src, &file, inner, &folder)?
                    }
                };
                self.modules[index].children.insert(name, child);
                continue;
            }
            if let syn::Item::Macro(definition) = item
                && let Some(ident) = &definition.ident
            {
                self.macros.insert(ident.to_string(), file);
            }
            reader.visit_item(item);
        }
        let module = &mut self.modules[index];
        module.items = reader.items;
        module.imports = reader.imports;
        module.paths = reader.paths;
        module.macro_calls = reader.macro_calls;
        module.calls = reader.calls;
        module.methods = reader.methods;
        module.trait_methods = reader.trait_methods;
        Ok(index)
    }
}

/// The file of `mod name;`, and the folder of its children.
fn module_file(module: &syn::ItemMod, children: &Path, name: &str) -> (PathBuf, PathBuf) {
    let given = module.attrs.iter().find_map(|attribute| match &attribute.meta {
        syn::Meta::NameValue(pair) if pair.path.is_ident("path") => match &pair.value {
            syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
            _ => None,
        },
        _ => None,
    });
    let folder = children.join(name);
    match given {
        Some(given) => (children.join(given), folder),
        None => {
            let flat = children.join(format!("{name}.rs"));
            let file = if flat.exists() { flat } else { folder.join("mod.rs") };
            (file, folder)
        }
    }
}

/// The attributes of an item.
fn attributes(item: &syn::Item) -> &[syn::Attribute] {
    match item {
        syn::Item::Const(item) => &item.attrs,
        syn::Item::Enum(item) => &item.attrs,
        syn::Item::Fn(item) => &item.attrs,
        syn::Item::Impl(item) => &item.attrs,
        syn::Item::Macro(item) => &item.attrs,
        syn::Item::Mod(item) => &item.attrs,
        syn::Item::Static(item) => &item.attrs,
        syn::Item::Struct(item) => &item.attrs,
        syn::Item::Trait(item) => &item.attrs,
        syn::Item::Type(item) => &item.attrs,
        syn::Item::Union(item) => &item.attrs,
        syn::Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// Whether an attribute is `#[cfg(test)]`, alone or as part of an `any(…)` or `all(…)`.
fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        syn::Meta::List(list) if list.path.is_ident("cfg") => has_word(&list.tokens, "test"),
        _ => false,
    })
}

fn has_word(tokens: &TokenStream, word: &str) -> bool {
    tokens.clone().into_iter().any(|token| match token {
        TokenTree::Ident(ident) => ident == word,
        // `not(test)` is the program itself.
        TokenTree::Group(group) => {
            !tokens.to_string().contains("not") && has_word(&group.stream(), word)
        }
        TokenTree::Punct(_) | TokenTree::Literal(_) => false,
    })
}

/// Collects what a module contains.
#[derive(Default)]
struct Reader {
    items: BTreeSet<String>,
    imports: Vec<Import>,
    paths: Vec<Written>,
    macro_calls: Vec<(String, usize)>,
    calls: Vec<(String, usize)>,
    methods: Vec<(Written, String)>,
    trait_methods: BTreeSet<String>,
}

impl Reader {
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
                self.imports.push(Import { name, path });
            }
            syn::UseTree::Rename(rename) => {
                self.imports
                    .push(Import { name: rename.rename.to_string(), path: with(&rename.ident) });
            }
            syn::UseTree::Glob(glob) => {
                let line = glob.star_token.spans[0].start().line;
                let path = Written { segments: prefix.to_vec(), line };
                self.imports.push(Import { name: "*".to_owned(), path });
            }
            syn::UseTree::Group(group) => {
                for tree in &group.items {
                    self.import(prefix, tree);
                }
            }
        }
    }

    /// Paths and method calls in the tokens of a macro call or definition.
    fn tokens(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let is_colon =
            |at: usize| matches!(tokens.get(at), Some(TokenTree::Punct(p)) if p.as_char() == ':');
        let mut at = 0;
        while at < tokens.len() {
            match &tokens[at] {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(first) => {
                    let line = first.span().start().line;
                    let mut segments = vec![first.to_string()];
                    while is_colon(at + 1) && is_colon(at + 2) {
                        let Some(TokenTree::Ident(next)) = tokens.get(at + 3) else { break };
                        segments.push(next.to_string());
                        at += 3;
                    }
                    let is_call = at > 0
                        && segments.len() == 1
                        && matches!(&tokens[at - 1], TokenTree::Punct(p) if p.as_char() == '.')
                        && matches!(tokens.get(at + 1), Some(TokenTree::Group(_)));
                    let is_macro = segments.len() == 1
                        && matches!(tokens.get(at + 1), Some(TokenTree::Punct(p)) if p.as_char() == '!')
                        && matches!(tokens.get(at + 2), Some(TokenTree::Group(_)));
                    if is_call {
                        self.calls.push((segments.remove(0), line));
                    } else if is_macro {
                        self.macro_calls.push((segments.remove(0), line));
                    } else if segments.len() > 1 {
                        self.paths.push(Written { segments, line });
                    }
                }
                TokenTree::Punct(_) | TokenTree::Literal(_) => {}
            }
            at += 1;
        }
    }
}

fn written(path: &syn::Path) -> Written {
    let segments: Vec<_> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
    let line = path.segments.first().map_or(0, |segment| segment.ident.span().start().line);
    Written { segments, line }
}

impl<'ast> Visit<'ast> for Reader {
    fn visit_item(&mut self, item: &'ast syn::Item) {
        if is_test(attributes(item)) {
            return;
        }
        let name = match item {
            syn::Item::Const(item) => Some(&item.ident),
            syn::Item::Enum(item) => Some(&item.ident),
            syn::Item::Fn(item) => Some(&item.sig.ident),
            syn::Item::Macro(item) => item.ident.as_ref(),
            syn::Item::Static(item) => Some(&item.ident),
            syn::Item::Struct(item) => Some(&item.ident),
            syn::Item::Trait(item) => Some(&item.ident),
            syn::Item::Type(item) => Some(&item.ident),
            syn::Item::Union(item) => Some(&item.ident),
            _ => None,
        };
        self.items.extend(name.map(ToString::to_string));
        if let syn::Item::Trait(item) = item {
            for inner in &item.items {
                if let syn::TraitItem::Fn(method) = inner {
                    self.trait_methods.insert(method.sig.ident.to_string());
                }
            }
        }
        if let syn::Item::Impl(block) = item
            && block.trait_.is_none()
            && let syn::Type::Path(of) = &*block.self_ty
        {
            for inner in &block.items {
                if let syn::ImplItem::Fn(method) = inner {
                    self.methods.push((written(&of.path), method.sig.ident.to_string()));
                }
            }
        }
        syn::visit::visit_item(self, item);
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.import(&[], &item.tree);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.paths.push(written(path));
        syn::visit::visit_path(self, path);
    }

    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        self.calls.push((call.method.to_string(), call.method.span().start().line));
        syn::visit::visit_expr_method_call(self, call);
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        let path = written(&call.path);
        match path.segments.as_slice() {
            [name] => self.macro_calls.push((name.clone(), path.line)),
            _ => self.paths.push(path),
        }
        self.tokens(call.tokens.clone());
    }
}
