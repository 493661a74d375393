//! Generates `constants.rs` from the Khronos registry: every `GL_*` constant, the names of the
//! values for messages, and the name and arity of every command. `lengths.rs`: how many elements
//! each pointer parameter has. `egl.rs`: EGL's constants.

use gl_generator::{Api, Enum, Fallbacks, Profile, Registry};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;

/// Where the extensions are listed that DetGL has.
const CLAIMED: &str = "src/query/extensions.rs";

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed={CLAIMED}");
    let xml = String::from_utf8_lossy(khronos_api::GL_XML);
    let registry = Registry::new(
        Api::Gl,
        (4, 6),
        Profile::Compatibility,
        Fallbacks::All,
        extensions(&xml, "gl"),
    );

    let claimed = std::fs::read_to_string(CLAIMED).expect("it is in this package");
    let claimed: Vec<&str> = claimed.split('"').skip(1).step_by(2).collect();
    let known = extensions(&xml, "gl").into_iter().filter(|name| claimed.contains(name));
    let known: Vec<&str> = known.collect();
    let implemented = Registry::new(Api::Gl, (3, 1), Profile::Compatibility, Fallbacks::All, known);

    let mut text = String::new();
    constants("GL", &registry, &mut text);
    let later = Registry::new(Api::Gl, (4, 6), Profile::Compatibility, Fallbacks::All, []);
    names(&registry, &implemented, &later, &mut text);
    commands(&registry, &mut text);
    let directory = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    let write = |file: &str, text: String| {
        std::fs::write(Path::new(&directory).join(file), text).expect("OUT_DIR is writable");
    };
    write("constants.rs", text);
    write("lengths.rs", lengths(&xml));

    let xml = String::from_utf8_lossy(khronos_api::EGL_XML);
    let registry =
        Registry::new(Api::Egl, (1, 5), Profile::Core, Fallbacks::All, extensions(&xml, "egl"));
    let mut text = String::new();
    constants("EGL", &registry, &mut text);
    write("egl.rs", text);
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

/// The names of all extensions of an API.
fn extensions<'a>(xml: &'a str, api: &str) -> Vec<&'a str> {
    xml.lines()
        .filter(|line| line.trim_start().starts_with("<extension "))
        .filter(|line| {
            attribute(line, "supported")
                .is_some_and(|supported| supported.split('|').any(|other| other == api))
        })
        .filter_map(|line| attribute(line, "name"))
        .collect()
}

/// The constant's name as C has it.
fn c_name(api: &str, item: &Enum) -> String {
    format!("{api}_{}", item.ident.strip_prefix('_').unwrap_or(&item.ident))
}

fn constants(api: &str, registry: &Registry, text: &mut String) {
    // Where an extension of another API reuses a name, the later and larger value is GL's.
    let unique: BTreeMap<_, _> = registry.enums.iter().map(|item| (&item.ident, item)).collect();
    for item in unique.into_values() {
        let ty = match item.ty.as_ref() {
            "GLuint64" => "u64",
            "&'static str" => continue,
            // Handles: all of them are 0, or cast from -1.
            _ if api == "EGL" && item.value.contains(" as ") => continue,
            "EGLuint64KHR" | "EGLTime" | "EGLTimeKHR" => "u64",
            _ if api == "EGL" => "i32",
            _ if item.value.starts_with('-') => "i32",
            _ => "u32",
        };
        let name = c_name(api, item);
        writeln!(text, "/// `{name}`, {}.\npub const {name}: {ty} = {};", item.value, item.value)
            .expect("a String takes everything");
    }
}

/// Names by value, sorted: one for each value that is implemented or belongs to a later version, without
/// its `GL_`, one after the other in one text, which takes no pointers that a loader would have to fill
/// in. What only some vendor has stays a number. Where values collide, what is implemented wins, which a
/// program may have meant; then what is no bit of a mask, which messages do not name; then the name
/// without a vendor's suffix, then the shorter one, then the first.
fn names(registry: &Registry, implemented: &Registry, later: &Registry, text: &mut String) {
    let mut best: BTreeMap<u32, String> = BTreeMap::new();
    let vendor = ["ARB", "EXT", "NV", "ATI", "AMD", "SGIX", "SGIS", "OES", "APPLE", "ANGLE"];
    let place = |name: &str| {
        let suffix = name.rsplit('_').next().unwrap_or_default();
        vendor.iter().position(|vendor| *vendor == suffix)
    };
    let mut ours: BTreeSet<String> = BTreeSet::new();
    for name in implemented.enums.iter().map(|item| c_name("GL", item)) {
        // Without the suffix too: so it is called where a later version took it up.
        if let (Some(_), Some((plain, _))) = (place(&name), name.rsplit_once('_')) {
            ours.insert(plain.to_owned());
        }
        ours.insert(name);
    }
    let rank = |name: &str| {
        let foreign = !ours.contains(name);
        let bit = name.split('_').any(|word| word == "BIT");
        // Nobody's first, then ARB's, then EXT's, then one vendor's.
        let place = place(name).map_or(0, |place| 1 + place.min(2));
        (foreign, bit, place, name.len(), name.to_owned())
    };
    let later: BTreeSet<String> = later.enums.iter().map(|item| c_name("GL", item)).collect();
    for item in &registry.enums {
        let Some(value) = item.value.strip_prefix("0x") else { continue };
        let Ok(value) = u32::from_str_radix(value, 16) else { continue };
        let name = c_name("GL", item);
        if !ours.contains(&name) && !later.contains(&name) {
            continue;
        }
        if best.get(&value).is_none_or(|old| rank(&name) < rank(old)) {
            best.insert(value, name);
        }
    }
    text.push_str("/// Every value and where its name begins in [`NAMES`], by value.\n");
    writeln!(text, "pub(crate) static VALUES: [(u32, u32); {}] = [", best.len())
        .expect("a String takes everything");
    let mut names = String::new();
    for (value, name) in best {
        writeln!(text, "    ({value:#06x}, {}),", names.len()).expect("a String takes everything");
        names.push_str(name.strip_prefix("GL_").unwrap_or(&name));
    }
    text.push_str("];\n/// The names of all values, in their order.\n");
    writeln!(text, "static NAMES: &str = {names:?};").expect("a String takes everything");
}

fn commands(registry: &Registry, text: &mut String) {
    text.push_str("/// Every command of the registry and how many parameters it has, by name.\n");
    writeln!(text, "pub static COMMANDS: [(&str, usize); {}] = [", registry.cmds.len())
        .expect("a String takes everything");
    let commands: BTreeMap<_, _> =
        registry.cmds.iter().map(|cmd| (&cmd.proto.ident, cmd.params.len())).collect();
    for (name, arity) in commands {
        writeln!(text, "    (\"gl{name}\", {arity}),").expect("a String takes everything");
    }
    text.push_str("];\n");
}

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
