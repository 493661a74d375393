//! The versions of the language, its extensions, and what either brings.

mod availability;
mod extension;
mod version;

pub use availability::{Since, Stages, stage_name};
pub use extension::{Behaviour, Extension};
pub use version::Version;

/// A version with extensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Language {
    /// The version.
    pub version: Version,
    enabled: u32,
    warned: u32,
}

impl From<Version> for Language {
    /// A version as it begins: rectangles are the one extension that is there unasked, as
    /// `GL_ARB_texture_rectangle` says.
    fn from(version: Version) -> Self {
        let rectangles = Extension::TextureRectangle;
        let enabled = if rectangles.is_in(version) { rectangles.bit() } else { 0 };
        Self { version, enabled, warned: 0 }
    }
}

impl Language {
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
    }

    /// Whether an extension is enabled.
    pub fn enabled(self, extension: Extension) -> bool {
        self.enabled & extension.bit() != 0
    }

    /// Whether what came so is here.
    pub fn has(self, since: Since) -> bool {
        self.has_core(since) || since.extensions & self.enabled != 0
    }

    /// The extension that what came so is here by, if uses of it are to be reported.
    pub fn warns(self, since: Since) -> Option<Extension> {
        let enabled = since.extensions & self.enabled;
        if self.has_core(since) || enabled & !self.warned != 0 {
            return None;
        }
        since.extensions().find(|extension| self.warned & extension.bit() != 0)
    }

    fn has_core(self, since: Since) -> bool {
        match (self.version, since.core) {
            (Version::Es100, _) => since.es,
            (Version::V110 | Version::V120 | Version::V130 | Version::V140, Some(core)) => {
                self.version >= core
            }
            (Version::V110 | Version::V120 | Version::V130 | Version::V140, None) => false,
        }
    }

    /// What to write to have what came so, if anything helps.
    pub fn advice(self, since: Since) -> Option<String> {
        if self.has_core(since) {
            return None;
        }
        let extensions = since.extensions().filter(|extension| extension.is_in(self.version));
        let extensions = extensions.map(|known| format!("`#extension {} : enable`", known.name()));
        let core = since.core.filter(|core| *core > self.version || self.version == Version::Es100);
        let core = core.map(|core| format!("`#version {}`", core.number()));
        let ways: Vec<String> = core.into_iter().chain(extensions).collect();
        (!ways.is_empty()).then(|| format!("write {} first", ways.join(" or ")))
    }
}
