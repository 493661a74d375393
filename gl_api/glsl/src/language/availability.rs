//! In which versions, profiles and stages something is there.

use super::{Extension, Version};
use rasterizer::ir::Stage;

/// Which versions and extensions bring something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Since {
    pub(super) core: Option<Version>,
    pub(super) es: bool,
    /// The bits of the extensions of which any brings it.
    pub(super) extensions: u32,
}

impl Since {
    /// Every version.
    pub const ALWAYS: Self = Self { es: true, ..Self::V110 };
    /// Every version but that of OpenGL ES.
    pub const V110: Self = Self { core: Some(Version::V110), es: false, extensions: 0 };
    /// From GLSL 1.20 on.
    pub const V120: Self = Self { core: Some(Version::V120), ..Self::V110 };
    /// From GLSL 1.30 on.
    pub const V130: Self = Self { core: Some(Version::V130), ..Self::V110 };
    /// From GLSL 1.40 on.
    pub const V140: Self = Self { core: Some(Version::V140), ..Self::V110 };

    /// What brings uniform blocks and their layouts.
    pub const UNIFORM_BLOCKS: Self = Self::V140.or(Extension::UniformBufferObject);

    /// GLSL ES 1.00 alone.
    pub const ES: Self = Self { core: None, es: true, extensions: 0 };

    /// An extension alone.
    pub const fn only(extension: Extension) -> Self {
        Self { core: None, es: false, extensions: extension.bit() }
    }

    /// An extension too.
    pub const fn or(self, extension: Extension) -> Self {
        Self { extensions: self.extensions | extension.bit(), ..self }
    }

    pub(super) fn extensions(self) -> impl Iterator<Item = Extension> {
        let all = Extension::ALL.into_iter().map(|(extension, _)| extension);
        all.filter(move |extension| self.extensions & extension.bit() != 0)
    }

    /// GLSL ES 1.00 too.
    pub const fn and_es(self) -> Self {
        Self { es: true, ..self }
    }
}

/// What names are available to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stages {
    /// Both.
    Any,
    /// The vertex stage.
    Vertex,
    /// The fragment stage.
    Fragment,
}

impl Stages {
    /// Whether `stage` is among them.
    pub fn has(self, stage: Stage) -> bool {
        match self {
            Self::Any => true,
            Self::Vertex => stage == Stage::Vertex,
            Self::Fragment => stage == Stage::Fragment,
        }
    }
}

/// As messages name a stage.
pub fn stage_name(stage: Stage) -> &'static str {
    match stage {
        Stage::Vertex => "vertex",
        Stage::Fragment => "fragment",
    }
}
