//! The files that have the keyword `unsafe`.

use crate::error::ReadError;
use proc_macro2::{TokenStream, TokenTree};
use std::fs;
use std::path::Path;

/// The files under `folder` with the keyword `unsafe` (blocks, functions, implementations, attributes, and the bodies
/// of macros; not comments and strings), relative to `root`, each with the line of the first one.
///
/// # Errors
/// When a file cannot be read, or is not Rust.
pub fn unsafe_files(root: &Path, folder: &Path) -> Result<Vec<(String, usize)>, ReadError> {
    let io = |source| ReadError::Io { path: folder.to_owned(), source };
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).map_err(io)? {
        let path = entry.map_err(io)?.path();
        if path.is_dir() {
            found.extend(unsafe_files(root, &path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&path)
                .map_err(|source| ReadError::Io { path: path.clone(), source })?;
            let tokens: TokenStream = text.parse().map_err(|error| ReadError::Syntax {
                path: path.clone(),
                source: syn::Error::from(error),
            })?;
            let relative = path.strip_prefix(root).unwrap_or(&path);
            found.extend(first(tokens).map(|line| (relative.display().to_string(), line)));
        }
    }
    found.sort();
    Ok(found)
}

/// The line of the first `unsafe`.
fn first(tokens: TokenStream) -> Option<usize> {
    tokens.into_iter().find_map(|token| match token {
        TokenTree::Ident(ident) if ident == "unsafe" => Some(ident.span().start().line),
        TokenTree::Group(group) => first(group.stream()),
        TokenTree::Ident(_) | TokenTree::Punct(_) | TokenTree::Literal(_) => None,
    })
}
