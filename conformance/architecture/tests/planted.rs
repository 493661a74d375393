//! Crates with one mistake each: all are found, and a crate without any passes.

use architecture::{Graph, Violation, against_chain, check, manifest, read_crate, unsafe_files};
use std::collections::BTreeSet;
use std::error::Error;
use std::fs;
use tempfile::TempDir;

type Outcome = Result<(), Box<dyn Error>>;

/// The layers of the planted crates, from below.
const ORDER: &[&str] = &["base", "middle", "top"];

/// A crate without mistakes: re-exports, renames, globs, and tests that look upward.
const CLEAN: &[(&str, &str)] = &[
    ("src/lib.rs", "pub mod base;\nmod middle;\npub mod top;\npub use top::Top;\n"),
    (
        "src/base/mod.rs",
        "mod shape;\npub use shape::Shape as Form;\npub(in crate::base) fn inside() {}\n\
         #[cfg(test)]\nmod tests {\n    use crate::top::Top;\n}\n",
    ),
    (
        "src/base/shape.rs",
        "pub struct Shape;\nimpl Shape {\n    pub fn area(&self) -> u32 { 0 }\n}\n",
    ),
    ("src/middle.rs", "use crate::base::*;\npub fn half(form: &Form) -> u32 { form.area() }\n"),
    (
        "src/top.rs",
        "pub struct Top;\npub fn run(form: &crate::base::Form) {\n    use crate::middle::half as part;\n    \
         assert_eq!(part(form), 0);\n}\n",
    ),
];

/// The clean crate with some files in place of its own, or in addition.
fn planted(files: &[(&str, &str)]) -> Result<TempDir, Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let manifest = ("Cargo.toml", "[package]\nname = \"planted\"\n");
    for (file, text) in std::iter::once(&manifest).chain(CLEAN).chain(files) {
        let path = folder.path().join("planted").join(file);
        fs::create_dir_all(path.parent().ok_or("a file has a folder")?)?;
        fs::write(path, text)?;
    }
    Ok(folder)
}

fn graph(files: &[(&str, &str)]) -> Result<Graph, Box<dyn Error>> {
    Ok(Graph::of(&read_crate(planted(files)?.path(), "planted")?))
}

fn violations(files: &[(&str, &str)], order: &[&str]) -> Result<Vec<Violation>, Box<dyn Error>> {
    Ok(check(&graph(files)?, &owned(order)))
}

fn owned(order: &[&str]) -> Vec<String> {
    order.iter().map(|layer| (*layer).to_owned()).collect()
}

/// Holds the one violation of `files` against what it prints.
fn assert_prints(files: &[(&str, &str)], expected: &str) -> Outcome {
    let found: Vec<String> = violations(files, ORDER)?.iter().map(ToString::to_string).collect();
    assert_eq!(found, [expected]);
    Ok(())
}

#[test]
fn a_clean_crate_passes() -> Outcome {
    assert_eq!(violations(&[], ORDER)?, []);
    Ok(())
}

#[test]
fn references_lead_through_re_exports_globs_and_renames() -> Outcome {
    let graph = graph(&[])?;
    let name = |file: usize| graph.files[file].path.as_str();
    let edges: BTreeSet<_> = graph.edges.keys().map(|(a, b)| (name(*a), name(*b))).collect();
    let expected = [
        ("base/mod.rs", "base/shape.rs"),
        ("middle.rs", "base/mod.rs"),
        ("middle.rs", "base/shape.rs"),
        ("top.rs", "base/shape.rs"),
        ("top.rs", "middle.rs"),
    ];
    assert_eq!(edges, BTreeSet::from(expected));
    Ok(())
}

#[test]
fn an_upward_import_is_found() -> Outcome {
    let middle = ("src/middle.rs", "\npub use crate::top::{self, Top as Last};\n");
    assert_prints(&[middle], "planted/src/middle.rs:2 → planted/src/top.rs: crate::top::Top")
}

#[test]
fn an_upward_import_through_a_re_export_of_the_root_is_found() -> Outcome {
    let middle = ("src/middle.rs", "use crate::Top;\n");
    assert_prints(&[middle], "planted/src/middle.rs:1 → planted/src/top.rs: crate::Top")
}

#[test]
fn an_upward_path_in_a_function_is_found() -> Outcome {
    let middle =
        ("src/middle.rs", "pub fn half() {\n    use super::top as up;\n    let _ = up::Top;\n}\n");
    assert_prints(&[middle], "planted/src/middle.rs:3 → planted/src/top.rs: up::Top")
}

#[test]
fn upward_paths_in_macros_are_found() -> Outcome {
    let middle = (
        "src/middle.rs",
        "macro_rules! top {\n    () => { $crate::top::Top };\n}\npub(crate) use top;\n",
    );
    assert_prints(&[middle], "planted/src/middle.rs:2 → planted/src/top.rs: crate::top::Top")
}

#[test]
fn an_upward_call_of_a_macro_is_found() -> Outcome {
    let middle = ("src/middle.rs", "pub fn half() {\n    crate::top::make!();\n}\n");
    let top = (
        "src/top.rs",
        "macro_rules! make {\n    () => {};\n}\npub(crate) use make;\npub struct Top;\n",
    );
    assert_prints(&[middle, top], "planted/src/middle.rs:2 → planted/src/top.rs: crate::top::make")
}

#[test]
fn items_that_a_macro_makes_are_found() -> Outcome {
    let middle = ("src/middle.rs", "use crate::top::{Made, Named};\n");
    let top = (
        "src/top.rs",
        "macro_rules! make {\n    ($name:ident) => { pub struct $name; pub struct Made; };\n}\n\
         make!(Named);\npub struct Top;\n",
    );
    assert_prints(
        &[middle, top],
        "planted/src/middle.rs:1 → planted/src/top.rs: crate::top::Made, crate::top::Named",
    )
}

#[test]
fn upward_method_calls_are_found() -> Outcome {
    let middle = (
        "src/middle.rs",
        "use crate::base::Form;\npub fn half(form: &Form) -> u32 {\n    form.shown() + Form::shown(form)\n}\n",
    );
    let top = (
        "src/top.rs",
        "use crate::base::Form;\npub struct Top;\nimpl Form {\n    pub fn shown(&self) -> u32 { 1 }\n}\n",
    );
    assert_prints(
        &[middle, top],
        "planted/src/middle.rs:3 → planted/src/top.rs: .shown(), Form::shown",
    )
}

#[test]
fn methods_of_two_types_are_not_followed() -> Outcome {
    let middle =
        ("src/middle.rs", "pub fn half(form: &crate::base::Form) -> u32 { form.shown() }\n");
    let top = (
        "src/top.rs",
        "use crate::base::Form;\npub struct Top;\nimpl Form {\n    pub fn shown(&self) -> u32 { 1 }\n}\n\
         impl Top {\n    pub fn shown(&self) -> u32 { 1 }\n}\n",
    );
    assert_eq!(violations(&[middle, top], ORDER)?, []);
    Ok(())
}

#[test]
fn other_crates_and_inline_modules_are_told_apart() -> Outcome {
    // A crate `top` of the same name as a layer is named by `::top` everywhere, and by `top` outside of the root.
    let middle = (
        "src/middle.rs",
        "use ::top::Top;\nuse other::top::Top as Second;\n\
         pub mod top {\n    pub struct Top;\n    pub fn new() -> Top { self::Top }\n}\n\
         pub fn half() -> top::Top { top::new() }\n",
    );
    assert_eq!(violations(&[middle], ORDER)?, []);
    let middle = ("src/middle.rs", "mod inner {\n    use super::super::top::Top;\n}\n");
    assert_prints(&[middle], "planted/src/middle.rs:2 → planted/src/top.rs: super::super::top::Top")
}

#[test]
fn code_that_builds_without_test_counts() -> Outcome {
    let middle = (
        "src/middle.rs",
        "#[cfg(any(test, feature = \"x\"))]\npub fn half() -> crate::top::Top { todo!() }\n",
    );
    assert_prints(&[middle], "planted/src/middle.rs:2 → planted/src/top.rs: crate::top::Top")
}

#[test]
fn files_with_a_given_path_belong_to_their_module() -> Outcome {
    let middle = ("src/middle.rs", "#[path = \"../elsewhere/part.rs\"]\nmod part;\n");
    let part = ("elsewhere/part.rs", "use crate::top::Top;\n");
    assert_prints(
        &[middle, part],
        "planted/src/../elsewhere/part.rs:1 → planted/src/top.rs: crate::top::Top",
    )
}

#[test]
fn a_circle_of_thirteen_files_is_found() -> Outcome {
    let circle = |count: usize| -> Vec<(String, String)> {
        let modules: String = (0..count).map(|file| format!("pub mod f{file};\n")).collect();
        let files = (0..count).map(|file| {
            let text = format!("pub fn f() {{ super::f{}::f() }}\n", (file + 1) % count);
            (format!("src/top/f{file}.rs"), text)
        });
        let lib = ("src/lib.rs".to_owned(), "mod base;\nmod middle;\nmod top;\n".to_owned());
        [lib, ("src/top/mod.rs".to_owned(), modules + "pub struct Top;\n")]
            .into_iter()
            .chain(files)
            .collect()
    };
    for (count, expected) in [(12, 0), (13, 1)] {
        let files = circle(count);
        let files: Vec<_> =
            files.iter().map(|(file, text)| (file.as_str(), text.as_str())).collect();
        let folder = planted(&files)?;
        fs::remove_file(folder.path().join("planted/src/top.rs"))?;
        let graph = Graph::of(&read_crate(folder.path(), "planted")?);
        let found = check(&graph, &owned(ORDER));
        assert_eq!(found.len(), expected, "{found:?}");
        let is_circle = |violation: &Violation| matches!(violation, Violation::Circle(_));
        assert!(found.iter().all(is_circle), "{found:?}");
    }
    Ok(())
}

#[test]
fn unlisted_and_absent_layers_are_found() -> Outcome {
    assert_eq!(
        violations(&[], &["base", "middle", "roof"])?,
        [
            Violation::Unlisted("planted/src/top".to_owned()),
            Violation::Absent("planted/src/roof".to_owned()),
        ]
    );
    Ok(())
}

#[test]
fn a_dependency_against_the_chain_is_found() -> Outcome {
    let folder = tempfile::tempdir()?;
    let manifests = [
        ("low", "[package]\nname = \"low\"\n[dependencies]\nhigh.workspace = true\n"),
        ("high", "[package]\nname = \"high\"\n[dependencies]\nlow = { path = \"../low\" }\n"),
    ];
    fs::write(folder.path().join("Cargo.toml"), "[workspace]\nmembers = [\"low\", \"high\"]\n")?;
    for (name, text) in manifests {
        fs::create_dir(folder.path().join(name))?;
        fs::write(folder.path().join(name).join("Cargo.toml"), text)?;
    }
    let chain = [vec!["low".to_owned()], vec!["high".to_owned()]];
    assert_eq!(
        against_chain(&manifest::members(folder.path())?, &chain),
        ["low/Cargo.toml → high: against the chain of crates"]
    );
    Ok(())
}

#[test]
fn unsafe_is_found_in_code_only() -> Outcome {
    let folder = planted(&[
        ("src/middle.rs", "// unsafe\nconst A: &str = \"unsafe\";\n"),
        ("src/top.rs", "macro_rules! a {\n    () => { unsafe {} };\n}\n"),
    ])?;
    assert_eq!(
        unsafe_files(folder.path(), &folder.path().join("planted/src"))?,
        [("planted/src/top.rs".to_owned(), 2)]
    );
    Ok(())
}
