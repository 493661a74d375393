//! Generates from the Khronos registry `lengths.rs`: how many elements each pointer parameter of a GL command has; and
//! `egl.rs`: EGL's constants. Says how the shared library is linked.

use gl_generator::{Api, Fallbacks, Profile, Registry};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let directory = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    let write = |file: &str, text: String| {
        std::fs::write(Path::new(&directory).join(file), text).expect("OUT_DIR is writable");
    };
    write("lengths.rs", lengths(&String::from_utf8_lossy(khronos_api::GL_XML)));
    write("egl.rs", egl_constants(&String::from_utf8_lossy(khronos_api::EGL_XML)));
    if links_elf() {
        link_as_elf(Path::new(&directory));
    }
}

/// Whether the library is linked as Linux's are; Windows' and Apple's linkers have other options.
fn links_elf() -> bool {
    let target = |key: &str| std::env::var(format!("CARGO_CFG_TARGET_{key}")).unwrap_or_default();
    target("FAMILY") == "unix" && target("VENDOR") != "apple"
}

/// What the linker is asked for.
fn link_as_elf(directory: &Path) {
    // Threads that wait in the library would crash if it were unloaded beneath them.
    println!("cargo:rustc-cdylib-link-arg=-Wl,-z,nodelete");
    // Whatever path it is loaded by, it is loaded once: it has one current context.
    println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libdetgl.so");
    // Names of its own are its own, whatever else the process has under them.
    println!("cargo:rustc-cdylib-link-arg=-Wl,-Bsymbolic");
    // The workspace's `strip` does not reach a package that has a setting of its own.
    if std::env::var("PROFILE").is_ok_and(|profile| profile == "release")
        && std::env::var("DEBUG").is_ok_and(|debug| debug == "false")
    {
        println!("cargo:rustc-cdylib-link-arg=-Wl,-s");
        fold_identical_code(directory);
    }
    link_unwinder();
}

/// Has the linker keep functions of the same instructions once, if it is one that can: many entry points, and many
/// instances of generic functions, differ in types alone. No function's address is compared with another's.
fn fold_identical_code(directory: &Path) {
    const FOLD: &str = "-Wl,--icf=all";
    let variable = |name: &str| std::env::var(name).unwrap_or_default();
    let source = directory.join("empty.rs");
    std::fs::write(&source, "").expect("OUT_DIR is writable");
    let mut rustc = std::process::Command::new(variable("RUSTC"));
    rustc.args(["--crate-type=cdylib", "--target", &variable("TARGET"), "-C"]);
    rustc.arg(format!("link-arg={FOLD}")).arg("-o").arg(directory.join("empty.so")).arg(source);
    let flags = variable("CARGO_ENCODED_RUSTFLAGS");
    rustc.args(flags.split('\u{1f}').filter(|flag| !flag.is_empty()));
    let linker = variable("RUSTC_LINKER");
    if !linker.is_empty() {
        rustc.args(["-C", &format!("linker={linker}")]);
    }
    if rustc.output().is_ok_and(|output| output.status.success()) {
        println!("cargo:rustc-cdylib-link-arg={FOLD}");
    }
}

/// Puts the unwinder into the library, where there is one to put in: else it needs libgcc_s.so.1.
fn link_unwinder() {
    let variable = |name: &str| std::env::var(name).unwrap_or_default();
    // Others bring their own.
    if variable("CARGO_CFG_TARGET_ENV") != "gnu" {
        return;
    }
    let compiler = match variable("RUSTC_LINKER") {
        named if !named.is_empty() => named,
        _ if variable("HOST") == variable("TARGET") => "cc".to_owned(),
        // `cc` has this machine's, which is another's.
        _ => return,
    };
    let name = "libgcc_eh.a";
    let found =
        std::process::Command::new(compiler).arg(format!("-print-file-name={name}")).output();
    let Some(path) = found.ok().and_then(|output| String::from_utf8(output.stdout).ok()) else {
        return;
    };
    // A compiler that does not have it answers the name alone.
    if let Some(folder) = Path::new(path.trim()).parent().filter(|folder| folder.is_absolute()) {
        println!("cargo:rustc-link-search=native={}", folder.display());
        println!("cargo:rustc-link-lib=static:-bundle=gcc_eh");
    }
}

/// An attribute of an XML element that is on one line.
fn attribute<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    let start = line.find(&format!(" {name}=\""))? + name.len() + 3;
    Some(&line[start..start + line[start..].find('"')?])
}

/// EGL's constants, those of extensions too.
fn egl_constants(xml: &str) -> String {
    let extensions = xml
        .lines()
        .filter(|line| line.trim_start().starts_with("<extension "))
        .filter(|line| {
            attribute(line, "supported")
                .is_some_and(|supported| supported.split('|').any(|api| api == "egl"))
        })
        .filter_map(|line| attribute(line, "name"));
    let extensions: Vec<&str> = extensions.collect();
    let registry = Registry::new(Api::Egl, (1, 5), Profile::Core, Fallbacks::All, extensions);
    let mut text = String::new();
    let unique: BTreeMap<_, _> = registry.enums.iter().map(|item| (&item.ident, item)).collect();
    let mut names: BTreeMap<i64, String> = BTreeMap::new();
    for item in unique.into_values() {
        let ty = match item.ty.as_ref() {
            "&'static str" => continue,
            // Handles: all of them are 0, or cast from -1.
            _ if item.value.contains(" as ") => continue,
            "GLuint64" | "EGLuint64KHR" | "EGLTime" | "EGLTimeKHR" => "u64",
            _ => "i32",
        };
        let name = format!("EGL_{}", item.ident.strip_prefix('_').unwrap_or(&item.ident));
        writeln!(text, "/// `{name}`, {}.\npub const {name}: {ty} = {};", item.value, item.value)
            .expect("a String takes everything");
        // Several extensions may have the same value: the shortest name has no suffix.
        let value = item.value.strip_prefix("0x").and_then(|hex| i64::from_str_radix(hex, 16).ok());
        if let Some(value) = value.filter(|value| NAMED.contains(value)) {
            let shortest = names.entry(value).or_insert_with(|| name.clone());
            if name.len() < shortest.len() {
                *shortest = name;
            }
        }
    }
    text.push_str("/// Names of values, in order.\npub(super) const NAMES: &[(i32, &str)] = &[\n");
    for (value, name) in names {
        writeln!(text, "    ({value:#x}, {name:?}),").expect("a String takes everything");
    }
    text.push_str("];\n");
    text
}

/// The values of EGL that are enumerants, not bits.
const NAMED: std::ops::RangeInclusive<i64> = 0x3000..=0x3fff;

/// The `len` attributes of every command's parameters, by name of the command.
fn lengths(xml: &str) -> String {
    let name = |line: &str| -> Option<String> {
        let start = line.find("<name>")? + "<name>".len();
        Some(line[start..start + line[start..].find("</name>")?].to_owned())
    };
    let mut commands: BTreeMap<String, Vec<(String, String)>> = BTreeMap::new();
    let mut current = String::new();
    for line in xml.lines().map(str::trim_start) {
        if line.starts_with("<proto") {
            current = name(line).expect("a prototype has a name");
            commands.insert(current.clone(), Vec::new());
        } else if line.starts_with("<param") {
            let length = attribute(line, "len").unwrap_or_default().to_owned();
            let parameter = name(line).expect("a parameter has a name");
            commands.get_mut(&current).expect("after its prototype").push((parameter, length));
        }
    }
    let mut text =
        String::from("/// What the registry says of each command's parameters, by name.\n");
    writeln!(text, "static LENGTHS: [(&str, &[Length]); {}] = [", commands.len())
        .expect("a String takes everything");
    for (command, parameters) in &commands {
        let place = |name: &str| parameters.iter().position(|(other, _)| other == name);
        let rows: Vec<String> =
            parameters.iter().map(|(_, length)| self::length(length, place)).collect();
        writeln!(text, "    ({command:?}, &[{}]),", rows.join(", "))
            .expect("a String takes everything");
    }
    text.push_str("];\n");
    text
}

/// A `len` attribute as a value of `Length`; `place` finds a parameter.
fn length(text: &str, place: impl Fn(&str) -> Option<usize>) -> String {
    if text.is_empty() {
        return "Length::Unsaid".into();
    }
    if let Ok(count) = text.parse::<usize>() {
        return format!("Length::Fixed({count})");
    }
    let (name, factor) = text.split_once('*').unwrap_or((text, "1"));
    if let Some(argument) = place(name) {
        return format!("Length::Times({argument}, {factor})");
    }
    let inside = text.strip_prefix("COMPSIZE(").and_then(|rest| rest.strip_suffix(')'));
    let arguments: Vec<String> = inside
        .unwrap_or_default()
        .split(',')
        .filter_map(|name| place(name).map(|at| at.to_string()))
        .collect();
    format!("Length::Formula({text:?}, &[{}])", arguments.join(", "))
}
