//! The crates keep to what ARCHITECTURE.md prints: the order of layers, the chain of crates, where `unsafe` is.

use architecture::check::large_circles;
use architecture::manifest::{self, Member};
use architecture::{Graph, against_chain, check, page, read_crate, unsafe_files};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// Crates that have no table yet.
const PENDING: &[&str] = &[];

/// Crates that need no table, and why.
const WITHOUT_TABLE: &[(&str, &str)] = &[
    ("examples", "programs side by side, each of which is read alone"),
    ("architecture", "its documentation has the steps in their order"),
    ("fuzz-run", "one file, and what the fuzz targets run"),
    ("mutants", "its documentation has the steps in their order"),
];

/// Folders that may contain `unsafe`, and why.
const UNSAFE: &[(&str, &str)] = &[
    ("texunit/src/lanes", "instructions of the processor"),
    ("gl_api/capi/src", "the C ABI"),
    ("conformance/src/gl", "functions of another library, which checks call in DetGL's place"),
    (
        "conformance/src/peers/client",
        "a client of the C ABI, of drivers that are opened at run time",
    ),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn architecture_page() -> io::Result<String> {
    fs::read_to_string(root().join("ARCHITECTURE.md"))
}

fn members() -> Result<Vec<Member>, Box<dyn Error>> {
    let members = manifest::members(&root())?;
    assert!(members.iter().any(|member| member.name == "architecture"), "{members:?}");
    Ok(members)
}

/// Fails with all lines at once.
fn assert_none(violations: &[String]) {
    assert!(violations.is_empty(), "\n{}\n", violations.join("\n"));
}

#[test]
fn files_name_nothing_of_layers_above_their_own() -> Result<(), Box<dyn Error>> {
    let orders = page::orders(&architecture_page()?);
    let mut violations = Vec::new();
    for member in members()? {
        let graph = Graph::of(&read_crate(&root(), &member.folder)?);
        let is_listed = |list: &[(&str, &str)]| list.iter().any(|(name, _)| *name == member.name);
        let found = match orders.get(&member.name) {
            Some(order) => check(&graph, order),
            None if is_listed(WITHOUT_TABLE) => large_circles(&graph),
            None if PENDING.contains(&member.name.as_str()) => Vec::new(),
            None if graph.layers().len() > 1 => {
                violations
                    .push(format!("{}: ARCHITECTURE.md has no table of its layers", member.name));
                Vec::new()
            }
            None => large_circles(&graph),
        };
        violations.extend(found.iter().map(ToString::to_string));
    }
    assert_none(&violations);
    Ok(())
}

#[test]
fn tables_are_of_crates_of_the_workspace() -> Result<(), Box<dyn Error>> {
    let members = members()?;
    let orders = page::orders(&architecture_page()?);
    let unknown = orders.keys().filter(|name| !members.iter().any(|member| member.name == **name));
    assert_none(&unknown.map(|name| format!("{name}: no such crate")).collect::<Vec<_>>());
    Ok(())
}

#[test]
fn crates_depend_in_the_direction_of_the_chain() -> Result<(), Box<dyn Error>> {
    let chain = page::chain(&architecture_page()?);
    assert!(chain.len() > 1, "ARCHITECTURE.md has no chain of crates");
    assert_none(&against_chain(&members()?, &chain));
    Ok(())
}

#[test]
fn unsafe_code_is_in_the_lanes_and_the_c_abi() -> Result<(), Box<dyn Error>> {
    let mut violations = Vec::new();
    for member in members()? {
        for (file, line) in unsafe_files(&root(), &root().join(&member.folder).join("src"))? {
            if !UNSAFE.iter().any(|(folder, _)| Path::new(&file).starts_with(folder)) {
                violations.push(format!("{file}:{line}: `unsafe`"));
            }
        }
    }
    assert_none(&violations);
    Ok(())
}
