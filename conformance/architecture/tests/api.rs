//! The public items of the libraries are those of the files in docs/api: what dependents use does not change unnoticed.

use architecture::api::listing;
use std::collections::BTreeSet;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// The libraries, and their folders.
const LIBRARIES: [(&str, &str); 6] = [
    ("texunit", "texunit"),
    ("rasterizer", "rasterizer"),
    ("glsl", "gl_api/glsl"),
    ("gl_api", "gl_api"),
    ("capi", "gl_api/capi"),
    ("golden", "gl_api/golden"),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn public_items_are_those_of_the_files() -> Result<(), Box<dyn Error>> {
    let folder = root().join("docs/api");
    let mut differences = Vec::new();
    for (name, source) in LIBRARIES {
        let now = listing(&root().join(source).join("src"))?;
        let file = folder.join(format!("{name}.txt"));
        if std::env::var_os("DETGL_BLESS").is_some() {
            let lines: String = now.iter().map(|line| format!("{line}\n")).collect();
            fs::create_dir_all(&folder)?;
            fs::write(&file, lines)?;
        }
        let text = fs::read_to_string(&file).unwrap_or_default();
        let before: BTreeSet<_> = text.lines().map(str::to_owned).collect();
        differences.extend(before.difference(&now).map(|line| format!("{name}: gone: {line}")));
        differences.extend(now.difference(&before).map(|line| format!("{name}: new: {line}")));
    }
    assert!(
        differences.is_empty(),
        "{}\nif that is meant: DETGL_BLESS=1 cargo test -p architecture --test api",
        differences.join("\n")
    );
    Ok(())
}

#[test]
fn re_exports_are_followed_and_private_items_left_out() -> Result<(), Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text);
    write(
        "lib.rs",
        "mod inner;\npub mod open { pub use crate::inner::*; pub fn f(a: u32,\n b: u32) {} }\n\
         pub use inner::{Filter as TexelFilter, deep::Deep};\npub use bytemuck::Pod;\n#[doc(hidden)] pub mod host { pub fn g() {} }\n",
    )?;
    write(
        "inner.rs",
        "#[non_exhaustive] #[derive(Clone)] pub enum Filter { A, B(u8) }\nimpl Filter { pub fn new() -> Self { Self::A } fn own() {} }\n\
         impl Default for Filter { fn default() -> Self { Self::A } }\npub(crate) struct Closed;\n\
         pub(crate) mod deep { pub struct Deep { pub x: f32, y: f32 } }\n#[cfg(test)] mod tests { pub fn t() {} }\n",
    )?;
    let filter = |at: &str| {
        [
            "derive(Clone)",
            "enum, non_exhaustive",
            "fn new() -> Self",
            "impl Default",
            "variant A",
            "variant B (u8)",
        ]
        .map(|what| format!("{at}: {what}"))
    };
    let mut wanted: BTreeSet<String> =
        filter("TexelFilter").into_iter().chain(filter("open::Filter")).collect();
    let others = [
        "Deep: field x: f32",
        "Deep: struct",
        "Pod = bytemuck::Pod",
        "open::f: fn f(a: u32, b: u32)",
    ];
    wanted.extend(others.map(str::to_owned));
    assert_eq!(listing(folder.path())?, wanted);
    Ok(())
}
