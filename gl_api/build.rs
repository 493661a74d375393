//! Generates `constants.rs` from the Khronos registry: every `GL_*` constant, the names of the
//! values for messages, and the name and arity of every command. `availability.rs`: which versions and
//! extensions of which API have a command, or an enum of OpenGL or of an implemented extension.

#[path = "build/availability.rs"]
mod availability;

use gl_generator::{Api, Enum, Fallbacks, Profile, Registry};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;

/// Where the extensions are listed that DetGL has.
const CLAIMED: &str = "src/query/extensions.rs";

/// Of two implemented names of a value, those that commands take as an argument more often.
const PREFERRED: [&str; 1] = ["GL_DOT3_RGBA_EXT"];

/// Where those of OpenGL ES are.
const CLAIMED_ES: &str = "src/base/es_extensions.rs";

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=build");
    println!("cargo:rerun-if-changed={CLAIMED}");
    println!("cargo:rerun-if-changed={CLAIMED_ES}");
    let xml = String::from_utf8_lossy(khronos_api::GL_XML);
    let of = |api: Api, version, extensions: Vec<&str>| {
        Registry::new(api, version, Profile::Compatibility, Fallbacks::All, extensions)
    };
    let mut registry = of(Api::Gl, (4, 6), extensions(&xml, "gl"));

    let claimed = read(CLAIMED);
    let claimed = quoted(&claimed);
    let known = extensions(&xml, "gl").into_iter().filter(|name| claimed.contains(name));
    let mut implemented = of(Api::Gl, (3, 3), known.collect());
    let claimed_es = read(CLAIMED_ES);
    let claimed_es = quoted(&claimed_es);
    let known = extensions(&xml, "gles2").into_iter().filter(|name| claimed_es.contains(name));
    let es = of(Api::Gles2, (3, 0), known.collect());
    for registry in [&mut registry, &mut implemented] {
        registry.enums.extend(es.enums.iter().cloned());
    }
    registry.cmds.extend(es.cmds.iter().cloned());

    let mut text = String::new();
    constants(&registry, &mut text);
    let later = of(Api::Gl, (4, 6), Vec::new());
    names(&registry, &implemented, &later, &mut text);
    commands(&registry, &mut text);
    let directory = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    let write = |file: &str, text: String| {
        std::fs::write(Path::new(&directory).join(file), text).expect("OUT_DIR is writable");
    };
    write("constants.rs", text);
    let enums = implemented.enums.iter().chain(&later.enums);
    let enums = enums.map(|value| value.ident.as_str()).collect();
    write("availability.rs", availability::tables(&xml, &enums, &claimed_es));
}

/// A file of this package.
fn read(path: &str) -> String {
    std::fs::read_to_string(path).expect("it is in this package")
}

/// What stands between quotes.
fn quoted(text: &str) -> Vec<&str> {
    text.split('"').skip(1).step_by(2).collect()
}

/// An attribute of an XML element that is on one line.
fn attribute<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    let start = line.find(&format!(" {name}=\""))? + name.len() + 3;
    Some(&line[start..start + line[start..].find('"')?])
}

/// The names of all extensions of an API, as the registry calls it.
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
fn c_name(item: &Enum) -> String {
    format!("GL_{}", item.ident.strip_prefix('_').unwrap_or(&item.ident))
}

fn constants(registry: &Registry, text: &mut String) {
    // Where an extension of another API reuses a name, the later and larger value is GL's.
    let unique: BTreeMap<_, _> = registry.enums.iter().map(|item| (&item.ident, item)).collect();
    for item in unique.into_values() {
        let ty = match item.ty.as_ref() {
            "GLuint64" => "u64",
            "&'static str" => continue,
            _ if item.value.starts_with('-') => "i32",
            _ => "u32",
        };
        let name = c_name(item);
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
    for name in implemented.enums.iter().map(c_name) {
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
        let rare = !PREFERRED.contains(&name);
        (foreign, rare, bit, place, name.len(), name.to_owned())
    };
    let later: BTreeSet<String> = later.enums.iter().map(c_name).collect();
    for item in &registry.enums {
        let Some(value) = item.value.strip_prefix("0x") else { continue };
        let Ok(value) = u32::from_str_radix(value, 16) else { continue };
        let name = c_name(item);
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
