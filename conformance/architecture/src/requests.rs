//! Requests: checked calls, whose application cannot fail but for memory.

use crate::error::ReadError;
use std::fs;
use std::path::Path;

/// The requests (types whose name ends in `Request`) under `folder` with a method `apply` that returns a `Result`: file
/// relative to `root`, and type.
///
/// # Errors
/// When a file cannot be read, or is not Rust.
pub fn fallible_requests(root: &Path, folder: &Path) -> Result<Vec<(String, String)>, ReadError> {
    let mut found = Vec::new();
    each_source(root, folder, &mut |path, source| {
        for item in &source.items {
            if let syn::Item::Impl(block) = item
                && let Some(name) = last_name(&block.self_ty)
                && name.ends_with("Request")
            {
                let applies = |item: &syn::ImplItem| {
                    matches!(item, syn::ImplItem::Fn(method)
                        if method.sig.ident == "apply" && returns_result(&method.sig))
                };
                if block.items.iter().any(applies) {
                    found.push((path.to_owned(), name));
                }
            }
        }
    })?;
    found.sort();
    Ok(found)
}

/// Whether a function returns a `Result`.
pub(crate) fn returns_result(signature: &syn::Signature) -> bool {
    match &signature.output {
        syn::ReturnType::Type(_, ty) => last_name(ty).is_some_and(|name| name == "Result"),
        syn::ReturnType::Default => false,
    }
}

/// The last name of a type's path.
fn last_name(ty: &syn::Type) -> Option<String> {
    match ty {
        syn::Type::Path(path) => path.path.segments.last().map(|last| last.ident.to_string()),
        _ => None,
    }
}

/// Calls `visit` with each file under `folder`, and its path relative to `root`.
///
/// # Errors
/// When a file cannot be read, or is not Rust.
pub(crate) fn each_source(
    root: &Path,
    folder: &Path,
    visit: &mut impl FnMut(&str, &syn::File),
) -> Result<(), ReadError> {
    let io = |source| ReadError::Io { path: folder.to_owned(), source };
    for entry in fs::read_dir(folder).map_err(io)? {
        let path = entry.map_err(io)?.path();
        if path.is_dir() {
            each_source(root, &path, visit)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&path)
                .map_err(|source| ReadError::Io { path: path.clone(), source })?;
            let file = syn::parse_file(&text)
                .map_err(|source| ReadError::Syntax { path: path.clone(), source })?;
            visit(&path.strip_prefix(root).unwrap_or(&path).display().to_string(), &file);
        }
    }
    Ok(())
}
