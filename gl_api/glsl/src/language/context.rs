//! The versions and profiles of the language that a context offers.

use super::{Extension, Profile, Version};

/// What the shaders of a context may be written in. Every context takes GLSL ES 1.00
/// (ARB_ES2_compatibility).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ContextLanguage {
    /// GL 3.1 with `GL_ARB_compatibility`: GLSL 1.10 to 1.40.
    #[default]
    Compatibility31,
    /// The compatibility profile of GL 3.3: GLSL 1.10 to 3.30 in both profiles.
    Compatibility33,
    /// The core profile of GL 3.3: GLSL 1.40 to 3.30 in the core profile.
    Core33,
}

impl ContextLanguage {
    /// Whether it offers a version.
    pub fn has(self, version: Version) -> bool {
        if version == Version::Es100 {
            return true;
        }
        match self {
            Self::Compatibility31 => version <= Version::V140,
            Self::Compatibility33 => true,
            Self::Core33 => version >= Version::V140,
        }
    }

    /// Whether it offers a profile.
    pub fn has_profile(self, profile: Profile) -> bool {
        match (self, profile) {
            (_, Profile::Core) => true,
            (Self::Compatibility31 | Self::Compatibility33, Profile::Compatibility) => true,
            (Self::Core33, Profile::Compatibility) => false,
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
                Self::Core33 => Profile::Core,
            },
            Version::V150 | Version::V330 => Profile::Core,
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
        let desktop = Version::ALL.into_iter().filter(|v| *v != Version::Es100 && self.has(*v));
        let numbers: Vec<String> = desktop.map(|version| version.number().to_string()).collect();
        format!("{} and 100 (GLSL ES)", numbers.join(", "))
    }
}
