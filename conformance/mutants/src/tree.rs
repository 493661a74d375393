//! The copy of the workspace.

use crate::choice::Mutant;
use crate::error::MutantsError;
use crate::rewrite::{Rewritten, rewrite};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

const SWITCH: &str = include_str!("../templates/switch.rs");
const RUNNER: &str = include_str!("../templates/runner.rs");

/// The crates that have mistakes, by folder, and the way from there to the root.
const CRATES: [(&str, &str); 3] = [("texunit", ".."), ("rasterizer", ".."), ("gl_api", "..")];

/// Folders and files of the workspace that the copy does without.
const LEFT_OUT: [&str; 7] =
    [".git", ".ci", "target", "clients", "python", "package", "conformance-report"];

/// Writes a file if it does not have this text, so that cargo builds what has changed.
fn write(path: &Path, text: &[u8]) -> Result<(), MutantsError> {
    if fs::read(path).is_ok_and(|old| old == text) {
        return Ok(());
    }
    if let Some(parent) = path.parent() {
        fs::create_dir_all(parent).map_err(MutantsError::io(parent))?;
    }
    fs::write(path, text).map_err(MutantsError::io(path))
}

fn copy(from: &Path, to: &Path, skip: &dyn Fn(&Path) -> bool) -> Result<(), MutantsError> {
    for entry in fs::read_dir(from).map_err(MutantsError::io(from))? {
        let entry = entry.map_err(MutantsError::io(from))?;
        let (path, name) = (entry.path(), entry.file_name());
        if skip(&path) || LEFT_OUT.iter().any(|left_out| name == *left_out) {
            continue;
        }
        if path.is_dir() {
            copy(&path, &to.join(&name), skip)?;
        } else {
            let bytes = fs::read(&path).map_err(MutantsError::io(&path))?;
            write(&to.join(&name), &bytes)?;
        }
    }
    Ok(())
}

fn read(path: &Path) -> Result<String, MutantsError> {
    fs::read_to_string(path).map_err(MutantsError::io(path))
}

/// Makes or refreshes the copy of the workspace in `root`, with these mistakes; the rewritten files by their paths.
///
/// # Errors
/// When a file cannot be read or written.
pub fn plant(
    root: &Path,
    copy_root: &Path,
    mutants: &[&Mutant],
) -> Result<BTreeMap<String, Rewritten>, MutantsError> {
    let mut by_file: BTreeMap<&str, Vec<&Mutant>> = BTreeMap::new();
    for &mutant in mutants {
        by_file.entry(&mutant.file).or_default().push(mutant);
    }
    let mut rewritten = BTreeMap::new();
    for (file, mutants) in by_file {
        let planted = rewrite(&read(&root.join(file))?, &mutants);
        write(&copy_root.join(file), planted.text.as_bytes())?;
        rewritten.insert(file.to_owned(), planted);
    }
    // These are written below, in another form.
    let manifests: Vec<_> =
        CRATES.iter().map(|(folder, _)| root.join(folder).join("Cargo.toml")).collect();
    let skip = |path: &Path| {
        let own = path.strip_prefix(root).ok().and_then(Path::to_str);
        own.is_some_and(|own| {
            rewritten.contains_key(own) || own == "Cargo.toml" || own == "Cargo.lock"
        }) || manifests.iter().any(|manifest| manifest == path)
            || copy_root.starts_with(path)
    };
    copy(root, copy_root, &skip)?;
    for (folder, up) in CRATES {
        let manifest = read(&root.join(folder).join("Cargo.toml"))?;
        let dependency =
            format!("[dependencies]\nmutant_switch = {{ path = \"{up}/mutant_switch\" }}\n");
        let manifest = manifest.replacen("[dependencies]\n", &dependency, 1);
        write(&copy_root.join(folder).join("Cargo.toml"), manifest.as_bytes())?;
    }
    let manifest = read(&root.join("Cargo.toml"))?
        .replacen("members = [", "members = [\"mutant_switch\", \"mutant_runner\",", 1)
        // The mistakes of a crate are compiled on all processors.
        .replace("codegen-units = 1\n", "");
    write(&copy_root.join("Cargo.toml"), manifest.as_bytes())?;
    let lock = copy_root.join("Cargo.lock");
    if !lock.exists() {
        write(&lock, read(&root.join("Cargo.lock"))?.as_bytes())?;
    }
    let package = |name: &str, dependencies: &str| {
        format!(
            "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = false\n\n\
            [dependencies]\n{dependencies}"
        )
    };
    let switch = copy_root.join("mutant_switch");
    write(&switch.join("Cargo.toml"), package("mutant_switch", "").as_bytes())?;
    write(&switch.join("src/lib.rs"), SWITCH.as_bytes())?;
    let runner = copy_root.join("mutant_runner");
    let dependencies = "conformance = { path = \"../conformance\" }\nexamples = { path = \"../examples\" }\n\
        gl_api.workspace = true\nmutant_switch = { path = \"../mutant_switch\" }\n";
    write(&runner.join("Cargo.toml"), package("mutant_runner", dependencies).as_bytes())?;
    write(&runner.join("src/main.rs"), RUNNER.as_bytes())?;
    Ok(rewritten)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cargo reads the manifest of every member, whatever is built.
    #[test]
    fn the_copy_has_all_members_of_the_workspace() {
        let manifest = include_str!("../../../Cargo.toml");
        let (_, members) = manifest.split_once("members = [").expect("a workspace");
        let (members, _) = members.split_once(']').expect("a list");
        let members: Vec<&str> = members.split('"').skip(1).step_by(2).collect();
        assert!(members.contains(&"texunit"), "{members:?}");
        for member in members {
            let mut folders = member.split('/');
            assert!(!folders.any(|folder| LEFT_OUT.contains(&folder)), "{member} is left out");
        }
    }
}
