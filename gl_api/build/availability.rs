//! Which versions and extensions of which API have a command or an enum: the registry's features and extensions,
//! read line by line.

use super::{attribute, extensions};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

type Version = (u8, u8);

/// What is found of a command or an enum.
#[derive(Default)]
struct Found<'a> {
    compatibility: Option<Version>,
    core: Option<(Version, Option<Version>)>,
    es1: Option<Version>,
    es2: Option<Version>,
    /// Names, and the APIs as the registry calls them.
    extensions: Vec<(&'a str, Vec<&'a str>)>,
}

/// What the lines are inside of.
enum Group<'a> {
    /// A version of `gl`, `gles1` or `gles2`.
    Feature(&'a str, Version),
    /// An extension, and the APIs that it is for.
    Extension(&'a str, Vec<&'a str>),
    /// Another API's version.
    Other,
}

/// What a block says of the commands and enums in it.
#[derive(Clone, Copy)]
enum Block<'a> {
    /// They are there, in one API or profile or in all.
    Require { api: Option<&'a str>, profile: Option<&'a str> },
    /// They are no longer there.
    Remove,
}

/// The tables, in Rust: of all commands, and of the enums of these names, which have `GL_` in front in the table; and of
/// what OpenGL ES has by version or by one of its claimed extensions.
pub fn tables(xml: &str, enums_wanted: &BTreeSet<&str>, claimed_es: &[&str]) -> String {
    let mut commands: BTreeMap<&str, Found<'_>> = BTreeMap::new();
    let mut enums: BTreeMap<&str, Found<'_>> = BTreeMap::new();
    let mut values: BTreeMap<&str, u32> = BTreeMap::new();
    let (mut group, mut block) = (Group::Other, Block::Remove);
    for line in xml.lines().map(str::trim_start) {
        let named = |name| attribute(line, name);
        if line.starts_with("<proto") {
            if let Some(name) = prototype(line) {
                commands.entry(name).or_default();
            }
        } else if line.starts_with("<feature ") {
            group = match (named("api"), named("number").and_then(version)) {
                (Some(api @ ("gl" | "gles1" | "gles2")), Some(version)) => {
                    Group::Feature(api, version)
                }
                (_, _) => Group::Other,
            };
        } else if line.starts_with("<extension ") {
            let apis = named("supported").unwrap_or_default().split('|').collect();
            group = Group::Extension(named("name").expect("an extension has a name"), apis);
        } else if line.starts_with("<require") {
            block = Block::Require { api: named("api"), profile: named("profile") };
        } else if line.starts_with("<remove") {
            block = Block::Remove;
        } else if line.starts_with("<command ")
            && let Some(found) = named("name").and_then(|name| commands.get_mut(name))
        {
            found.note(&group, block);
        } else if line.starts_with("<enum ")
            && let Some(name) = named("name")
            && name.strip_prefix("GL_").is_some_and(|name| enums_wanted.contains(name))
        {
            // Outside of features and extensions it is the enum's definition.
            let value = named("value").and_then(|value| value.strip_prefix("0x"));
            if let Some(value) = value.and_then(|value| u32::from_str_radix(value, 16).ok()) {
                values.insert(name, value);
            }
            enums.entry(name).or_default().note(&group, block);
        }
    }
    let found = commands;
    let commands = text("/// What the registry says of its commands, by name.", "COMMANDS", &found);
    let of_es: Vec<&str> = found
        .iter()
        .filter(|(_, found)| found.is_in_es(claimed_es))
        .map(|(name, _)| *name)
        .collect();
    let removed = removed_values(&enums, &values)
        + &extensions_of_core(xml)
        + &values_outside_es(&enums, &values, claimed_es)
        + &format!(
            "/// The commands that OpenGL ES 3.0 has, or an implemented extension of it, in order.\n\
             pub static COMMANDS_OF_ES: [&str; {}] = {of_es:?};\n",
            of_es.len()
        );
    commands
        + &text("/// What the registry says of its enums, by name.", "ENUMS", &enums)
        + &removed
}

/// The names of the extensions that are for the core profile.
fn extensions_of_core(xml: &str) -> String {
    let names = extensions(xml, "glcore");
    format!(
        "/// The extensions that the registry has for the core profile.\n\
         pub static EXTENSIONS_OF_CORE: [&str; {}] = {names:?};\n",
        names.len()
    )
}

/// Enums of `EXT_framebuffer_sRGB`, which core contexts list beside the registry's extensions: programs by `glium` ask.
const KEPT_IN_CORE: [&str; 1] = ["GL_FRAMEBUFFER_SRGB_CAPABLE_EXT"];

/// The values that no use in the core profile of 3.3 has, of any of their names.
fn removed_values(enums: &BTreeMap<&str, Found<'_>>, values: &BTreeMap<&str, u32>) -> String {
    let kept = KEPT_IN_CORE.map(|name| values.get(name).copied());
    let mut removed = without_use(enums, values, |found| found.is_in_core());
    removed.retain(|value| !kept.contains(&Some(*value)));
    format!(
        "/// The values of enums that only the compatibility profile of OpenGL 3.3 has, in order.\n\
         pub static REMOVED_VALUES: [u32; {}] = {removed:?};\n",
        removed.len()
    )
}

/// The values that no use in OpenGL ES 3.0 has.
fn values_outside_es(
    enums: &BTreeMap<&str, Found<'_>>,
    values: &BTreeMap<&str, u32>,
    claimed: &[&str],
) -> String {
    let outside = without_use(enums, values, |found| found.is_in_es(claimed));
    format!(
        "/// The values of enums that OpenGL has and OpenGL ES 3.0 has not, in order.\n\
         pub static VALUES_OUTSIDE_ES: [u32; {}] = {outside:?};\n",
        outside.len()
    )
}

/// The values of which no name has a use. Values below 0x100 have too many uses.
fn without_use(
    enums: &BTreeMap<&str, Found<'_>>,
    values: &BTreeMap<&str, u32>,
    has_use: impl Fn(&Found<'_>) -> bool,
) -> Vec<u32> {
    let mut used: BTreeMap<u32, bool> = BTreeMap::new();
    for (name, found) in enums {
        if let Some(value) = values.get(name).filter(|value| **value >= 0x100) {
            *used.entry(*value).or_default() |= has_use(found);
        }
    }
    used.iter().filter(|(_, used)| !**used).map(|(value, _)| *value).collect()
}

/// The name in a line `<proto>void <name>glAccum</name></proto>`.
fn prototype(line: &str) -> Option<&str> {
    let start = line.find("<name>")? + "<name>".len();
    Some(&line[start..start + line[start..].find("</name>")?])
}

/// `major.minor`.
fn version(text: &str) -> Option<Version> {
    let (major, minor) = text.split_once('.')?;
    Some((major.parse().ok()?, minor.parse().ok()?))
}

impl<'a> Found<'a> {
    /// Whether any version of the core profile has it, or an extension adds it to that.
    fn is_in_core(&self) -> bool {
        let by_version =
            self.core.is_some_and(|(_, removed)| removed.is_none_or(|end| end > (3, 3)));
        by_version || self.extensions.iter().any(|(_, apis)| apis.contains(&"glcore"))
    }

    /// Whether OpenGL ES 3.0 has it, or an extension of it that is claimed.
    fn is_in_es(&self, claimed: &[&str]) -> bool {
        self.es2.is_some_and(|from| from <= (3, 0))
            || self
                .extensions
                .iter()
                .any(|(name, apis)| apis.contains(&"gles2") && claimed.contains(name))
    }

    fn note(&mut self, group: &Group<'a>, block: Block<'a>) {
        match (group, block) {
            (Group::Feature("gl", version), Block::Require { profile, .. }) => {
                if profile != Some("core") {
                    self.compatibility.get_or_insert(*version);
                }
                if profile != Some("compatibility") {
                    self.core = match self.core {
                        Some((from, None)) => Some((from, None)),
                        // New, or there again.
                        None | Some((_, Some(_))) => Some((*version, None)),
                    };
                }
            }
            // All of them are the core profile's.
            (Group::Feature("gl", version), Block::Remove) => {
                self.core = self.core.map(|(from, _)| (from, Some(*version)));
            }
            (Group::Feature(api, version), Block::Require { .. }) => {
                let first = if *api == "gles1" { &mut self.es1 } else { &mut self.es2 };
                first.get_or_insert(*version);
            }
            (Group::Extension(name, apis), Block::Require { api, profile }) => {
                let of_block = |other: &&str| {
                    let profile_fits = match profile {
                        Some("core") => *other != "gl",
                        Some("compatibility") => *other != "glcore",
                        Some(_) | None => true,
                    };
                    profile_fits && api.is_none_or(|api| api == other.trim_end_matches("core"))
                };
                let apis = apis.iter().copied().filter(of_block);
                match self.extensions.iter_mut().find(|(other, _)| other == name) {
                    Some((_, known)) => {
                        for api in apis {
                            if !known.contains(&api) {
                                known.push(api);
                            }
                        }
                    }
                    None => self.extensions.push((name, apis.collect())),
                }
            }
            (Group::Feature(..) | Group::Extension(..), Block::Remove) | (Group::Other, _) => {}
        }
    }
}

fn text(doc: &str, table: &str, rows: &BTreeMap<&str, Found<'_>>) -> String {
    let mut text = format!("{doc}\n");
    let version = |(major, minor): Version| format!("Version::new({major}, {minor})");
    let optional = |found: Option<Version>| match found {
        Some(found) => format!("Some({})", version(found)),
        None => "None".into(),
    };
    writeln!(text, "static {table}: [(&str, Availability); {}] = [", rows.len())
        .expect("a String takes everything");
    for (name, found) in rows {
        let core = match found.core {
            Some((from, end)) => {
                let (from, end) = (version(from), optional(end));
                format!("Some(CoreVersions {{ from: {from}, removed_in: {end} }})")
            }
            None => "None".into(),
        };
        let extensions = found.extensions.iter().filter_map(|(name, apis)| {
            let apis: Vec<&str> = apis.iter().filter_map(|api| variant(api)).collect();
            let apis = apis.join(", ");
            (!apis.is_empty()).then(|| format!("Extension {{ name: {name:?}, apis: &[{apis}] }}"))
        });
        let extensions: Vec<String> = extensions.collect();
        writeln!(
            text,
            "    ({name:?}, Availability {{ compatibility: {}, core: {core}, es1: {}, es2: {}, extensions: &[{}] }}),",
            optional(found.compatibility),
            optional(found.es1),
            optional(found.es2),
            extensions.join(", "),
        )
        .expect("a String takes everything");
    }
    text.push_str("];\n");
    text
}

/// The variant of `Api` for the registry's name; `None` for safety-critical and for disabled extensions.
fn variant(api: &str) -> Option<&'static str> {
    match api {
        "gl" => Some("Api::Compatibility"),
        "glcore" => Some("Api::Core"),
        "gles1" => Some("Api::Es1"),
        "gles2" => Some("Api::Es2"),
        _ => None,
    }
}
