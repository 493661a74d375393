//! The versions and profiles of the language that a context offers.

use super::{Extension, Profile, Version};

/// What the shaders of a context may be written in. Every context takes GLSL ES 1.00 (ARB_ES2_compatibility).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ContextLanguage {
    /// GL 3.1 with `GL_ARB_compatibility`: GLSL 1.10 to 1.40.
    #[default]
    Compatibility31,
    /// The compatibility profile of GL 3.3: GLSL 1.10 to 3.30 in both profiles.
    Compatibility33,
    /// The core profile of GL 3.3: GLSL 1.40 to 3.30 in the core profile. Shaders of earlier versions have no
    /// profile; they are accepted, as Mesa accepts them.
    Core33,
    /// OpenGL ES 3.0: GLSL ES 1.00 and 3.00.
    Es30,
}

impl ContextLanguage {
    /// Whether it offers a version.
    pub fn has(self, version: Version) -> bool {
        match (self, version) {
            (_, Version::Es100) => true,
            (Self::Compatibility31, _) => version <= Version::V140,
            (Self::Compatibility33 | Self::Core33, _) => true,
            (Self::Es30, _) => version.is_es(),
        }
    }

    /// Whether it offers a profile.
    pub fn has_profile(self, profile: Profile) -> bool {
        match (self, profile) {
            (_, Profile::Core) => true,
            (Self::Compatibility31 | Self::Compatibility33, Profile::Compatibility) => true,
            (Self::Core33 | Self::Es30, Profile::Compatibility) => false,
        }
    }

    /// The profile of a shader whose `#version` names none: GLSL 1.50 section 3.3 says core; the
    /// versions before have no profiles, and 1.40 has what the context has.
    pub fn default_profile(self, version: Version) -> Profile {
        match version {
            Version::V110 | Version::Es100 | Version::V120 | Version::V130 => {
                Profile::Compatibility
            }
            Version::V140 => match self {
                Self::Compatibility31 | Self::Compatibility33 => Profile::Compatibility,
                Self::Core33 | Self::Es30 => Profile::Core,
            },
            Version::V150 | Version::V330 | Version::Es300 => Profile::Core,
        }
    }

    /// The version of a shader without `#version`.
    pub fn default_version(self) -> Version {
        match self {
            Self::Compatibility31 | Self::Compatibility33 | Self::Core33 => Version::V110,
            Self::Es30 => Version::Es100,
        }
    }

    /// Whether shaders of a version can enable an extension.
    pub fn has_extension(self, extension: Extension, version: Version) -> bool {
        let fits =
            extension != Extension::Compatibility || self.has_profile(Profile::Compatibility);
        fits && extension.is_in(version)
    }

    /// The versions, as messages list them.
    pub fn versions(self) -> String {
        let desktop = Version::ALL.into_iter().filter(|v| !v.is_es() && self.has(*v));
        let numbers: Vec<String> = desktop.map(|version| version.number().to_string()).collect();
        let numbers = numbers.join(", ");
        match (numbers.is_empty(), self.has(Version::Es300)) {
            (true, _) => "100 and 300 es (GLSL ES)".to_owned(),
            (false, true) => format!("{numbers}, 100 (GLSL ES) and 300 es"),
            (false, false) => format!("{numbers} and 100 (GLSL ES)"),
        }
    }
}
