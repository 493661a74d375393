//! Every file that a page names exists.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// Folders that are not sources.
const SKIPPED: &[&str] = &["target", ".git", "gallery", "conformance-report"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// All files and folders below `folder`, as paths from the root with `/` between names.
fn tree(folder: &Path, prefix: &str, found: &mut Vec<String>) -> Result<(), Box<dyn Error>> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if SKIPPED.contains(&name.as_str()) {
            continue;
        }
        let path = format!("{prefix}/{name}");
        if entry.file_type()?.is_dir() {
            tree(&entry.path(), &path, found)?;
        }
        found.push(path);
    }
    Ok(())
}

/// The pages that name sources: those of the root but the changelog, which names files of the past, and of `docs`.
fn pages() -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let root = root();
    let mut pages: Vec<PathBuf> = ["ARCHITECTURE.md", "README.md", "DETERMINISM.md"]
        .iter()
        .map(|name| root.join(name))
        .collect();
    for entry in fs::read_dir(root.join("docs"))? {
        let path = entry?.path();
        if path.is_file() {
            pages.push(path);
        }
    }
    Ok(pages)
}

/// The source files that a text names between backquotes; patterns and what follows `::` left out.
fn named(text: &str) -> Vec<&str> {
    let quoted = text.split('`').skip(1).step_by(2);
    let files = quoted.map(|name| name.split("::").next().unwrap_or(name));
    files
        .filter(|name| {
            name.contains('/') && [".rs", ".md", ".toml"].iter().any(|end| name.ends_with(end))
        })
        .filter(|name| !name.contains(['<', '{', '*', ' ', '$', '=']))
        .collect()
}

/// What the links of a page lead to, other pages of the web left out.
fn links(text: &str) -> Vec<&str> {
    let targets = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    targets.filter(|target| !target.starts_with("http") && !target.starts_with('#')).collect()
}

#[test]
fn files_that_pages_name_exist() -> Result<(), Box<dyn Error>> {
    let mut files = Vec::new();
    tree(&root(), "", &mut files)?;
    let mut missing = Vec::new();
    let mut checked = 0;
    for page in pages()? {
        let text = fs::read_to_string(&page)?;
        for name in named(&text) {
            checked += 1;
            let end = format!("/{}", name.trim_start_matches('/'));
            // Pages name files from a crate's `src` on.
            if !files.iter().any(|file| file.ends_with(&end)) {
                missing.push(format!("{}: `{name}`", page.display()));
            }
        }
        let folder = page.parent().unwrap_or(&page);
        for target in links(&text) {
            checked += 1;
            let path = target.split('#').next().unwrap_or(target);
            if !folder.join(path).exists() {
                missing.push(format!("{}: link to {target}", page.display()));
            }
        }
    }
    assert!(checked > 100, "only {checked} names were found");
    assert!(missing.is_empty(), "\n{}\n", missing.join("\n"));
    Ok(())
}

#[test]
fn a_missing_file_is_noticed() {
    assert_eq!(named("`a/b.rs` and `c.rs::f`, `x/y.rs::g`, `z/<w>.rs`"), ["a/b.rs", "x/y.rs"]);
    assert_eq!(links("[a](docs/a.md) [b](https://b) [c](#d)"), ["docs/a.md"]);
}
