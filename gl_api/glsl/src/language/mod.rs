//! Versions and extensions of the language, and what is available in them.

mod availability;
mod context;
mod extension;
mod version;

use availability::Profiles;
pub use availability::{Availability, EsVersions, Profile, Stages, stage_name};
pub use context::ContextLanguage;
pub use extension::{Behaviour, Extension};
pub use version::Version;

/// A version with extensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Language {
    /// The version.
    pub version: Version,
    /// The profile, from GLSL 1.40 on.
    profile: Profile,
    enabled: u64,
    warned: u64,
}

impl From<Version> for Language {
    /// A version as a context of the compatibility profile takes it.
    fn from(version: Version) -> Self {
        Self::new(version, ContextLanguage::Compatibility33.default_profile(version))
    }
}

impl Language {
    /// A version without `#extension`: of the extensions only `GL_ARB_texture_rectangle` is enabled
    /// by default, as its specification says.
    pub fn new(version: Version, profile: Profile) -> Self {
        let rectangles = Extension::TextureRectangle;
        let enabled = if rectangles.is_in(version) { rectangles.bit() } else { 0 };
        Self { version, profile, enabled, warned: 0 }
    }

    /// The profile.
    pub fn profile(self) -> Profile {
        self.profile
    }

    /// Applies an `#extension`.
    pub fn set(&mut self, extension: Extension, behaviour: Behaviour) {
        let bit = extension.bit();
        self.enabled &= !bit;
        self.warned &= !bit;
        match behaviour {
            Behaviour::Enable => self.enabled |= bit,
            Behaviour::Warn => {
                self.enabled |= bit;
                self.warned |= bit;
            }
            Behaviour::Disable => {}
        }
        if extension == Extension::Compatibility && self.enabled(extension) {
            self.profile = Profile::Compatibility;
        }
    }

    /// Whether an extension is enabled.
    pub fn enabled(self, extension: Extension) -> bool {
        self.enabled & extension.bit() != 0
    }

    /// Whether the shader has it.
    pub fn has(self, availability: Availability) -> bool {
        self.has_core(availability) || self.enabled_of(availability) != 0
    }

    /// The enabled extensions that add it in this version.
    fn enabled_of(self, availability: Availability) -> u64 {
        let counts = !self.version.is_es() || availability.extended_es.has(self.version);
        if counts { availability.extensions & self.enabled } else { 0 }
    }

    /// The extension that adds it, if `#extension … : warn` asks for a warning of each use.
    pub fn warns(self, availability: Availability) -> Option<Extension> {
        let enabled = self.enabled_of(availability);
        if self.has_core(availability) || enabled & !self.warned != 0 {
            return None;
        }
        availability.extensions().find(|extension| self.warned & extension.bit() != 0)
    }

    /// Whether the version and profile have it without an extension.
    fn has_core(self, availability: Availability) -> bool {
        match self.version {
            Version::Es100 | Version::Es300 => availability.es.has(self.version),
            Version::V110
            | Version::V120
            | Version::V130
            | Version::V140
            | Version::V150
            | Version::V330 => {
                let removed = self.version >= Version::V140
                    && self.profile == Profile::Core
                    && availability.profiles == Profiles::Compatibility;
                availability.desktop.is_some_and(|first| self.version >= first) && !removed
            }
        }
    }

    /// Advice: the directives that make it available; `None` if none does.
    pub fn advice(self, availability: Availability) -> Option<String> {
        if self.has_core(availability) {
            return None;
        }
        let extensions =
            availability.extensions().filter(|extension| extension.is_in(self.version));
        let extensions = extensions.map(|known| format!("`#extension {} : enable`", known.name()));
        let is_es = self.version.is_es();
        let desktop = availability.desktop.filter(|core| is_es || *core > self.version);
        let desktop = desktop.map(|core| format!("`#version {}`", core.number()));
        let in_es_300 = self.version == Version::Es100 && availability.es.has(Version::Es300);
        let core = if in_es_300 { Some("`#version 300 es`".to_owned()) } else { desktop };
        let directives: Vec<String> = core.into_iter().chain(extensions).collect();
        (!directives.is_empty()).then(|| format!("write {} first", directives.join(" or ")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_core_profile_is_without_what_only_compatibility_has() {
        let compatibility = Language::from(Version::V140);
        let core = Language { profile: Profile::Core, ..compatibility };
        let removed = Availability::DESKTOP.in_compatibility();
        assert!(compatibility.has(removed) && !core.has(removed));
        assert!(core.has(Availability::DESKTOP));
        let older = Language { profile: Profile::Core, ..Language::from(Version::V130) };
        assert!(older.has(removed));
    }
}
