//! The crates of the workspace, read from the files `Cargo.toml`.

use crate::error::ReadError;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A crate of the workspace.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Member {
    /// Its folder, relative to the workspace's root, with `/` between names.
    pub folder: String,
    /// The package's name, as sources have it.
    pub name: String,
    /// The names under `[dependencies]`, of the workspace and from elsewhere.
    pub dependencies: BTreeSet<String>,
}

/// The crates of the workspace whose root is `root`, in the order of `members`.
///
/// # Errors
/// When a `Cargo.toml` is missing.
pub fn members(root: &Path) -> Result<Vec<Member>, ReadError> {
    let manifest = read(&root.join("Cargo.toml"))?;
    let list = manifest
        .split_once("members = [")
        .and_then(|(_, rest)| rest.split_once(']'))
        .map_or("", |(list, _)| list);
    list.split(',')
        .map(|folder| folder.trim().trim_matches('"'))
        .filter(|folder| !folder.is_empty())
        .map(|folder| member(root, folder))
        .collect()
}

/// The crate in `folder`, which is relative to `root`.
///
/// # Errors
/// When its `Cargo.toml` is missing.
pub fn member(root: &Path, folder: &str) -> Result<Member, ReadError> {
    let manifest = read(&root.join(folder).join("Cargo.toml"))?;
    let mut section = "";
    let mut name = String::new();
    let mut dependencies = BTreeSet::new();
    for line in manifest.lines().map(str::trim) {
        if let Some(header) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            section = header;
            // `[dependencies.name]`
            dependencies.extend(header.strip_prefix("dependencies.").map(str::to_owned));
        } else if let Some((key, value)) = line.split_once('=') {
            let key = key.split('.').next().unwrap_or(key).trim();
            match section {
                "package" if key == "name" => name = source_name(value).to_owned(),
                "dependencies" if !key.starts_with('#') => {
                    dependencies.insert(key.to_owned());
                }
                _ => {}
            }
        }
    }
    Ok(Member { folder: folder.to_owned(), name, dependencies })
}

/// What sources call a package: those whose own name the registry has for another crate begin with `detgl-`.
fn source_name(value: &str) -> &str {
    let name = value.trim().trim_matches('"');
    name.strip_prefix("detgl-").unwrap_or(name)
}

fn read(path: &Path) -> Result<String, ReadError> {
    fs::read_to_string(path).map_err(|source| ReadError::Io { path: path.to_owned(), source })
}
