//! The crates that a registry is to have: complete metadata, and everything that building them needs in their packages.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The libraries, by folder, in the order in which they are published.
const LIBRARIES: [(&str, &str); 6] = [
    ("texunit", "texunit"),
    ("rasterizer", "rasterizer"),
    ("gl_api/glsl", "detgl-glsl"),
    ("gl_api", "gl_api"),
    ("gl_api/capi", "capi"),
    ("gl_api/golden", "detgl-golden"),
];

/// What a manifest's package has to say. A registry refuses a package without description or licence.
const REQUIRED: [&str; 9] = [
    "name",
    "version",
    "edition",
    "rust-version",
    "license",
    "description",
    "readme",
    "keywords",
    "categories",
];

/// The most keywords and categories that a registry takes.
const MOST: usize = 5;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The lines of a table of a manifest.
fn table<'a>(manifest: &'a str, name: &str) -> Vec<(&'a str, &'a str)> {
    let header = format!("[{name}]");
    let lines = manifest.lines().skip_while(|line| line.trim() != header).skip(1);
    let lines = lines.take_while(|line| !line.starts_with('['));
    lines
        .filter_map(|line| line.split_once('='))
        .map(|(key, value)| (key.trim(), value.trim()))
        .collect()
}

/// What is wrong with the manifest of a library, whose page is `readme`.
fn complaints(manifest: &str, name: &str, readme: &str) -> Vec<String> {
    let package = table(manifest, "package");
    let value = |key: &str| {
        let inherited = format!("{key}.workspace");
        package.iter().find(|(own, _)| *own == key || *own == inherited).map(|(_, value)| *value)
    };
    let mut found: Vec<_> = REQUIRED
        .iter()
        .filter(|key| value(key).is_none_or(|value| value.trim_matches(['"', '[', ']']).is_empty()))
        .map(|key| format!("{name}: [package] has no {key}"))
        .collect();
    if value("name") != Some(format!("\"{name}\"").as_str()) {
        found.push(format!("{name}: [package] calls it {:?}", value("name")));
    }
    if value("publish").is_some() {
        found.push(format!("{name}: publish keeps it from registries"));
    }
    for key in ["keywords", "categories"] {
        let count = value(key).map_or(0, |list| list.split(',').count());
        if count > MOST {
            found.push(format!("{name}: {count} {key}; a registry takes {MOST}"));
        }
    }
    if table(manifest, "package.metadata.docs.rs").is_empty() {
        found.push(format!("{name}: no [package.metadata.docs.rs]"));
    }
    if !readme.starts_with(&format!("# {name}\n")) {
        found.push(format!("{name}: README.md does not begin with its name"));
    }
    found
}

/// The dependencies by path that name no version: without one, no package can be made.
fn unversioned(manifest: &str, section: &str) -> Vec<String> {
    table(manifest, section)
        .into_iter()
        .filter(|(_, value)| value.contains("path =") && !value.contains("version ="))
        .map(|(key, _)| format!("[{section}] {key} has a path and no version"))
        .collect()
}

#[test]
fn manifests_are_complete() -> Result<(), Box<dyn Error>> {
    let workspace = fs::read_to_string(root().join("Cargo.toml"))?;
    let mut found = unversioned(&workspace, "workspace.dependencies");
    let version = table(&workspace, "workspace.package");
    let version = version.iter().find(|(key, _)| *key == "version").map_or("", |(_, value)| value);
    for (key, value) in table(&workspace, "workspace.dependencies") {
        if value.contains("path =") && !value.contains(&format!("version = {version}")) {
            found.push(format!("[workspace.dependencies] {key}: not of version {version}"));
        }
    }
    for (folder, name) in LIBRARIES {
        let folder = root().join(folder);
        let manifest = fs::read_to_string(folder.join("Cargo.toml"))?;
        let readme = fs::read_to_string(folder.join("README.md")).unwrap_or_default();
        found.extend(complaints(&manifest, name, &readme));
        found.extend(unversioned(&manifest, "dependencies"));
        // A package has what lies in its folder; both licences ask for their text.
        for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
            let text = fs::read(root().join(licence))?;
            if fs::read(folder.join(licence)).ok() != Some(text) {
                found.push(format!("{name}: {licence} is not that of the workspace"));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
    Ok(())
}

#[test]
fn what_is_missing_is_noticed() {
    let complete = "[package]\nname = \"a\"\nversion.workspace = true\nedition.workspace = true\n\
        rust-version.workspace = true\nlicense.workspace = true\ndescription = \"a thing\"\nreadme = \"README.md\"\n\
        keywords = [\"a\"]\ncategories = [\"b\"]\n\n[package.metadata.docs.rs]\nall-features = true\n";
    assert_eq!(complaints(complete, "a", "# a\n"), [""; 0]);
    for key in REQUIRED {
        let lines = complete.lines().filter(|line| !line.starts_with(key));
        let without: String = lines.map(|line| format!("{line}\n")).collect();
        let found = complaints(&without, "a", "# a\n");
        assert!(found.contains(&format!("a: [package] has no {key}")), "{key}: {found:?}");
    }
    let empty = complete.replace("\"a thing\"", "\"\"");
    assert_eq!(complaints(&empty, "a", "# a\n"), ["a: [package] has no description"]);
    let kept = complete.replace("readme", "publish = false\nreadme");
    assert_eq!(complaints(&kept, "a", "# a\n"), ["a: publish keeps it from registries"]);
    let many = complete.replace("[\"a\"]", "[\"a\", \"b\", \"c\", \"d\", \"e\", \"f\"]");
    assert_eq!(complaints(&many, "a", "# a\n"), ["a: 6 keywords; a registry takes 5"]);
    assert_eq!(complaints(complete, "a", "# b\n"), ["a: README.md does not begin with its name"]);
    let undocumented = complete.replace("docs.rs", "other");
    assert_eq!(complaints(&undocumented, "a", "# a\n"), ["a: no [package.metadata.docs.rs]"]);
    assert_eq!(
        unversioned("[dependencies]\nb = { path = \"../b\" }\nc = \"1\"\n", "dependencies"),
        ["[dependencies] b has a path and no version"],
    );
}

/// `cargo package` makes all six, from files of this folder alone.
#[test]
fn packages_are_made() -> Result<(), Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let mut command = Command::new(env!("CARGO"));
    command.args(["package", "--no-verify", "--allow-dirty", "--offline", "--target-dir"]);
    command.arg(folder.path()).current_dir(root());
    for (_, name) in LIBRARIES {
        command.args(["-p", name]);
    }
    let output = command.output()?;
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for (_, name) in LIBRARIES {
        let file = format!("package/{name}-{}.crate", env!("CARGO_PKG_VERSION"));
        // A registry takes 10 MB.
        let size = fs::metadata(folder.path().join(&file))?.len();
        assert!((1000..10_000_000).contains(&size), "{file} has {size} bytes");
    }
    Ok(())
}
