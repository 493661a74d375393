//! Generates `constants.rs` from the Khronos registry: every `GL_*` constant, the names of the
//! values for messages, and the name and arity of every command.

use gl_generator::{Api, Enum, Fallbacks, Profile, Registry};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let xml = String::from_utf8_lossy(khronos_api::GL_XML);
    let registry =
        Registry::new(Api::Gl, (4, 6), Profile::Compatibility, Fallbacks::All, extensions(&xml));

    let mut text = String::new();
    constants(&registry, &mut text);
    names(&registry, &mut text);
    commands(&registry, &mut text);
    let directory = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    std::fs::write(Path::new(&directory).join("constants.rs"), text).expect("OUT_DIR is writable");
}

/// The names of all extensions of desktop GL.
fn extensions(xml: &str) -> Vec<&str> {
    let attribute = |line: &'_ str, name: &str| -> Option<(usize, usize)> {
        let start = line.find(&format!("{name}=\""))? + name.len() + 2;
        Some((start, start + line[start..].find('"')?))
    };
    xml.lines()
        .filter(|line| line.trim_start().starts_with("<extension "))
        .filter(|line| {
            attribute(line, "supported")
                .is_some_and(|(start, end)| line[start..end].split('|').any(|api| api == "gl"))
        })
        .filter_map(|line| attribute(line, "name").map(|(start, end)| &line[start..end]))
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

/// Names by value, sorted: one for each value. Where values collide, the name without a vendor's
/// suffix wins, then the shorter one, then the first.
fn names(registry: &Registry, text: &mut String) {
    let mut best: BTreeMap<u32, String> = BTreeMap::new();
    for item in &registry.enums {
        let Some(value) = item.value.strip_prefix("0x") else { continue };
        let Ok(value) = u32::from_str_radix(value, 16) else { continue };
        let name = c_name(item);
        let rank = |name: &str| {
            let suffix = name.rsplit('_').next().unwrap_or_default();
            let vendor = ["ARB", "EXT", "NV", "ATI", "AMD", "SGIX", "SGIS", "OES", "APPLE"];
            (vendor.contains(&suffix), name.len(), name.to_owned())
        };
        if best.get(&value).is_none_or(|old| rank(&name) < rank(old)) {
            best.insert(value, name);
        }
    }
    text.push_str("/// Every value and its name, by value.\n");
    writeln!(text, "pub(crate) static NAMES: [(u32, &str); {}] = [", best.len())
        .expect("a String takes everything");
    for (value, name) in best {
        writeln!(text, "    ({value:#06x}, {name:?}),").expect("a String takes everything");
    }
    text.push_str("];\n");
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
