//! Availability: versions, profiles, extensions and stages that have something.

use super::{Extension, Version};
use rasterizer::ir::Stage;

/// A profile of desktop GLSL, from 1.40 on. Up to 1.30 there is one language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// Without what GLSL 1.40 has left to `GL_ARB_compatibility`.
    Core,
    /// With everything.
    Compatibility,
}

/// Which profiles of desktop GLSL have something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profiles {
    /// Both.
    All,
    /// The compatibility profile alone.
    Compatibility,
}

/// The versions of GLSL ES that have something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EsVersions {
    /// None.
    None,
    /// 1.00, and no longer 3.00.
    Only100,
    /// 3.00, and not yet 1.00.
    From300,
    /// Both.
    All,
}

impl EsVersions {
    pub(super) fn has(self, version: Version) -> bool {
        match self {
            Self::None => false,
            Self::Only100 => version == Version::Es100,
            Self::From300 => version == Version::Es300,
            Self::All => version.is_es(),
        }
    }
}

/// Which versions, profiles and extensions have something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Availability {
    /// The first version of desktop GLSL that has it; `None` if none has.
    pub(super) desktop: Option<Version>,
    /// The profiles of desktop GLSL that have it.
    pub(super) profiles: Profiles,
    /// The versions of GLSL ES that have it.
    pub(super) es: EsVersions,
    /// The bits of the extensions each of which adds it.
    pub(super) extensions: u64,
    /// The versions of GLSL ES in which these add it; of desktop GLSL they do in all.
    pub(super) extended_es: EsVersions,
}

impl Availability {
    /// Every version of desktop GLSL, and of GLSL ES.
    pub const DESKTOP_AND_ES: Self = Self::DESKTOP.and_es(EsVersions::All);
    /// Every version of desktop GLSL, and GLSL ES 1.00.
    pub const DESKTOP_AND_ES_100: Self = Self::DESKTOP.and_es(EsVersions::Only100);
    /// Every version of desktop GLSL.
    pub const DESKTOP: Self = Self::from_version(Version::V110);
    /// From GLSL 1.20 on.
    pub const V120: Self = Self::from_version(Version::V120);
    /// From GLSL 1.30 on.
    pub const V130: Self = Self::from_version(Version::V130);
    /// From GLSL 1.40 on.
    pub const V140: Self = Self::from_version(Version::V140);
    /// From GLSL 1.50 on.
    pub const V150: Self = Self::from_version(Version::V150);
    /// From GLSL 3.30 on.
    pub const V330: Self = Self::from_version(Version::V330);
    /// GLSL ES alone.
    pub const ES: Self = Self { es: EsVersions::All, ..Self::NOWHERE };

    /// Integers: their types, operators and functions.
    pub const INTEGERS: Self = Self::V130.or(Extension::GpuShader4).and_es(EsVersions::From300);
    /// Uniform blocks and their layouts.
    pub const UNIFORM_BLOCKS: Self =
        Self::V140.or(Extension::UniformBufferObject).and_es(EsVersions::From300);
    /// The names of instances of blocks.
    pub const INSTANCE_NAMES: Self = Self::V150.and_es(EsVersions::From300);
    /// The layouts of `gl_FragCoord`.
    pub const FRAGMENT_COORD_CONVENTIONS: Self = Self::V150.or(Extension::FragmentCoordConventions);
    /// `layout(location = n)`.
    pub const EXPLICIT_LOCATIONS: Self = Self::V330
        .or(Extension::ExplicitAttribLocation)
        .or(Extension::SeparateShaderObjects)
        .and_es(EsVersions::From300);
    /// The layouts of `gl_FragDepth`.
    pub const CONSERVATIVE_DEPTH: Self =
        Self::extension(Extension::AmdConservativeDepth).or(Extension::ConservativeDepth);
    /// What GLSL 4.20 has relaxed: lists as initializers, qualifiers in any order, bindings.
    pub const RELAXED: Self = Self::extension(Extension::ShadingLanguage420Pack);
    /// Samplers of multisample textures.
    pub const MULTISAMPLE: Self = Self::V150.or(Extension::TextureMultisample);

    const fn from_version(version: Version) -> Self {
        Self { desktop: Some(version), ..Self::NOWHERE }
    }

    /// Neither version nor extension.
    const NOWHERE: Self = Self {
        desktop: None,
        profiles: Profiles::All,
        es: EsVersions::None,
        extensions: 0,
        extended_es: EsVersions::All,
    };

    /// Of GLSL ES, extensions add it in these versions alone.
    pub const fn extended_in(self, extended_es: EsVersions) -> Self {
        Self { extended_es, ..self }
    }

    /// An extension alone.
    pub const fn extension(extension: Extension) -> Self {
        Self { extensions: extension.bit(), ..Self::NOWHERE }
    }

    /// An extension too.
    pub const fn or(self, extension: Extension) -> Self {
        Self { extensions: self.extensions | extension.bit(), ..self }
    }

    /// These versions of GLSL ES too.
    pub const fn and_es(self, es: EsVersions) -> Self {
        Self { es, ..self }
    }

    /// From GLSL 1.40 on only in the compatibility profile.
    pub const fn in_compatibility(self) -> Self {
        Self { profiles: Profiles::Compatibility, ..self }
    }

    /// The extensions that add it.
    pub fn extensions(self) -> impl Iterator<Item = Extension> {
        let all = Extension::ALL.into_iter().map(|(extension, _)| extension);
        all.filter(move |extension| self.extensions & extension.bit() != 0)
    }
}

/// The stages that have a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stages {
    /// All.
    Any,
    /// The vertex stage.
    Vertex,
    /// The geometry stage.
    Geometry,
    /// The vertex and the geometry stage.
    Vertices,
    /// The fragment stage.
    Fragment,
}

impl Stages {
    /// Whether `stage` is among them.
    pub fn has(self, stage: Stage) -> bool {
        match self {
            Self::Any => true,
            Self::Vertex => stage == Stage::Vertex,
            Self::Geometry => stage == Stage::Geometry,
            Self::Vertices => stage != Stage::Fragment,
            Self::Fragment => stage == Stage::Fragment,
        }
    }
}

/// The name of a stage in messages.
pub fn stage_name(stage: Stage) -> &'static str {
    match stage {
        Stage::Vertex => "vertex",
        Stage::Geometry => "geometry",
        Stage::Fragment => "fragment",
    }
}
