//! Which versions and extensions of which API have a command, an enum or an internal format; of commands and enums,
//! by the Khronos registry.

use std::cmp::Ordering;
use std::fmt;

/// A family of versions, as the registry tells them apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Api {
    /// OpenGL, with everything that later versions deprecate: 1.0 and later.
    Compatibility,
    /// The core profile of OpenGL: 3.2 and later. Of what it leaves out, earlier versions are asked as `Compatibility`.
    Core,
    /// OpenGL ES 1.0 and 1.1.
    Es1,
    /// OpenGL ES 2.0 and later.
    Es2,
}

/// A version of an API.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Version {
    /// Before the point.
    pub major: u8,
    /// After it.
    pub minor: u8,
}

impl Version {
    /// `major.minor`.
    pub const fn new(major: u8, minor: u8) -> Self {
        Self { major, minor }
    }

    /// Whether it is later than another.
    pub const fn is_after(self, other: Self) -> bool {
        self.major > other.major || self.major == other.major && self.minor > other.minor
    }
}

impl fmt::Display for Version {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.major, self.minor)
    }
}

/// The versions of the core profile that have a command or a format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct CoreVersions {
    /// The first.
    pub from: Version,
    /// The first without it again.
    pub removed_in: Option<Version>,
}

/// An extension that adds a command or a format, and the APIs to which it adds it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Extension {
    /// With `GL_`.
    pub name: &'static str,
    /// The APIs.
    pub apis: &'static [Api],
}

/// Which versions and extensions of each API have a command or a format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Availability {
    /// The first version of OpenGL that has it.
    pub compatibility: Option<Version>,
    /// The versions of the core profile.
    pub core: Option<CoreVersions>,
    /// The first version of OpenGL ES 1.
    pub es1: Option<Version>,
    /// The first version of OpenGL ES from 2.0 on.
    pub es2: Option<Version>,
    /// The extensions, in the registry's order.
    pub extensions: &'static [Extension],
}

impl Availability {
    /// Whether a version of an API has it without an extension.
    pub const fn is_in(&self, api: Api, version: Version) -> bool {
        let from = match api {
            Api::Compatibility => self.compatibility,
            Api::Core => match self.core {
                Some(CoreVersions { removed_in: Some(end), .. }) if !end.is_after(version) => None,
                Some(CoreVersions { from, .. }) => Some(from),
                None => None,
            },
            Api::Es1 => self.es1,
            Api::Es2 => self.es2,
        };
        match from {
            Some(from) => !from.is_after(version),
            None => false,
        }
    }

    /// The extensions that add it to an API.
    pub fn extensions_of(&self, api: Api) -> impl Iterator<Item = &'static str> {
        let of_api = self.extensions.iter().filter(move |extension| extension.apis.contains(&api));
        of_api.map(|extension| extension.name)
    }
}

include!(concat!(env!("OUT_DIR"), "/availability.rs"));

/// Every command of the registry, by name.
pub fn registry() -> impl Iterator<Item = (&'static str, &'static Availability)> {
    COMMANDS.iter().map(|(name, availability)| (*name, availability))
}

/// The availability of the command of that name; `None` if the registry has none.
pub const fn of(name: &str) -> Option<Availability> {
    find(&COMMANDS, name)
}

/// Where there is an enum of that name, with `GL_`; `None` if no version of OpenGL and no implemented
/// extension has it. An enum with several uses is there from the version of the first of them.
pub const fn of_enum(name: &str) -> Option<Availability> {
    find(&ENUMS, name)
}

/// Whether a list in order has a name, by bisection.
pub(super) const fn has_name(names: &[&str], name: &str) -> bool {
    let (mut low, mut high) = (0, names.len());
    while low < high {
        let middle = usize::midpoint(low, high);
        match order(names[middle].as_bytes(), name.as_bytes()) {
            Ordering::Less => low = middle + 1,
            Ordering::Greater => high = middle,
            Ordering::Equal => return true,
        }
    }
    false
}

/// The row of that name, by bisection.
const fn find(rows: &[(&str, Availability)], name: &str) -> Option<Availability> {
    let (mut low, mut high) = (0, rows.len());
    while low < high {
        let middle = usize::midpoint(low, high);
        match order(rows[middle].0.as_bytes(), name.as_bytes()) {
            Ordering::Less => low = middle + 1,
            Ordering::Greater => high = middle,
            Ordering::Equal => return Some(rows[middle].1),
        }
    }
    None
}

/// As `Ord` for slices, which is not `const`.
const fn order(a: &[u8], b: &[u8]) -> Ordering {
    let mut at = 0;
    while at < a.len() && at < b.len() {
        if a[at] != b[at] {
            return if a[at] < b[at] { Ordering::Less } else { Ordering::Greater };
        }
        at += 1;
    }
    if a.len() < b.len() {
        Ordering::Less
    } else if a.len() > b.len() {
        Ordering::Greater
    } else {
        Ordering::Equal
    }
}
