//! The versions of the language, its extensions, and what either brings.

use super::Stage;

/// A version that `#version` can ask for, by what it has: GLSL ES 1.00 comes after 1.10, of which
/// it is nearly a subset.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Version {
    /// GLSL 1.10, what a shader without `#version` is written in.
    V110,
    /// GLSL ES 1.00.
    Es100,
    /// GLSL 1.20.
    V120,
    /// GLSL 1.30.
    V130,
    /// GLSL 1.40 as contexts with `GL_ARB_compatibility` have it: with everything of 1.30.
    V140,
}

impl Version {
    /// Every version.
    pub const ALL: [Self; 5] = [Self::V110, Self::Es100, Self::V120, Self::V130, Self::V140];
    /// The newest, which stands in for those that there are not.
    pub const NEWEST: Self = Self::V140;

    /// The number that `#version` takes and `__VERSION__` gives.
    pub fn number(self) -> i32 {
        match self {
            Self::V110 => 110,
            Self::Es100 => 100,
            Self::V120 => 120,
            Self::V130 => 130,
            Self::V140 => 140,
        }
    }

    /// As the specification's title has it.
    pub fn title(self) -> &'static str {
        match self {
            Self::V110 => "GLSL 1.10",
            Self::Es100 => "GLSL ES 1.00",
            Self::V120 => "GLSL 1.20",
            Self::V130 => "GLSL 1.30",
            Self::V140 => "GLSL 1.40",
        }
    }
}

/// An extension that a shader can enable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extension {
    /// `GL_ARB_arrays_of_arrays`: arrays of more than one dimension.
    ArraysOfArrays,
    /// `GL_ARB_compatibility`: what GLSL 1.40 has left out, which is there with or without it.
    Compatibility,
    /// `GL_ARB_draw_buffers`: `gl_FragData`, which every version has.
    DrawBuffers,
    /// `GL_ARB_draw_instanced`: `gl_InstanceIDARB`.
    DrawInstanced,
    /// `GL_ARB_explicit_attrib_location`: `layout(location = n)`.
    ExplicitAttribLocation,
    /// `GL_ARB_fragment_coord_conventions`: `layout(...)` of `gl_FragCoord`.
    FragmentCoordConventions,
    /// `GL_ARB_shader_bit_encoding`: `floatBitsToInt` and its kin.
    ShaderBitEncoding,
    /// `GL_ARB_shader_stencil_export`: `gl_FragStencilRefARB`.
    ShaderStencilExport,
    /// `GL_ARB_shader_texture_lod`: explicit levels and gradients in both stages.
    ShaderTextureLod,
    /// `GL_ARB_texture_cube_map_array`: `samplerCubeArray`.
    TextureCubeMapArray,
    /// `GL_ARB_texture_gather`: `textureGather`.
    TextureGather,
    /// `GL_ARB_texture_multisample`: `sampler2DMS`.
    TextureMultisample,
    /// `GL_ARB_texture_query_lod`: `textureQueryLOD`.
    TextureQueryLod,
    /// `GL_ARB_texture_rectangle`: `sampler2DRect`.
    TextureRectangle,
    /// `GL_ARB_uniform_buffer_object`: uniform blocks.
    UniformBufferObject,
    /// `GL_EXT_gpu_shader4`, as far as it is what GLSL 1.30 has.
    GpuShader4,
    /// `GL_EXT_texture_array`: `sampler1DArray`, `sampler2DArray`.
    TextureArray,
    /// `GL_OES_standard_derivatives`: `dFdx`, `dFdy`, `fwidth` of GLSL ES.
    StandardDerivatives,
}

impl Extension {
    /// Every extension and its name.
    pub const ALL: [(Self, &'static str); 18] = [
        (Self::ArraysOfArrays, "GL_ARB_arrays_of_arrays"),
        (Self::Compatibility, "GL_ARB_compatibility"),
        (Self::DrawBuffers, "GL_ARB_draw_buffers"),
        (Self::DrawInstanced, "GL_ARB_draw_instanced"),
        (Self::ExplicitAttribLocation, "GL_ARB_explicit_attrib_location"),
        (Self::FragmentCoordConventions, "GL_ARB_fragment_coord_conventions"),
        (Self::ShaderBitEncoding, "GL_ARB_shader_bit_encoding"),
        (Self::ShaderStencilExport, "GL_ARB_shader_stencil_export"),
        (Self::ShaderTextureLod, "GL_ARB_shader_texture_lod"),
        (Self::TextureCubeMapArray, "GL_ARB_texture_cube_map_array"),
        (Self::TextureGather, "GL_ARB_texture_gather"),
        (Self::TextureMultisample, "GL_ARB_texture_multisample"),
        (Self::TextureQueryLod, "GL_ARB_texture_query_lod"),
        (Self::TextureRectangle, "GL_ARB_texture_rectangle"),
        (Self::UniformBufferObject, "GL_ARB_uniform_buffer_object"),
        (Self::GpuShader4, "GL_EXT_gpu_shader4"),
        (Self::TextureArray, "GL_EXT_texture_array"),
        (Self::StandardDerivatives, "GL_OES_standard_derivatives"),
    ];

    /// The extension of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|row| row.1 == name).map(|row| row.0)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|row| row.0 == self).map_or("", |row| row.1)
    }

    /// Whether shaders of a version can enable it.
    pub fn is_in(self, version: Version) -> bool {
        match self {
            Self::StandardDerivatives => version == Version::Es100,
            Self::Compatibility => version >= Version::V140,
            Self::ArraysOfArrays
            | Self::DrawBuffers
            | Self::DrawInstanced
            | Self::ExplicitAttribLocation
            | Self::FragmentCoordConventions
            | Self::ShaderBitEncoding
            | Self::ShaderStencilExport
            | Self::ShaderTextureLod
            | Self::UniformBufferObject
            | Self::TextureCubeMapArray
            | Self::TextureGather
            | Self::TextureMultisample
            | Self::TextureQueryLod
            | Self::TextureRectangle
            | Self::GpuShader4
            | Self::TextureArray => version != Version::Es100,
        }
    }

    const fn bit(self) -> u32 {
        1 << self as u32
    }
}

/// What `#extension` asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Behaviour {
    /// `require` or `enable`.
    Enable,
    /// `warn`: enabled, but uses are reported.
    Warn,
    /// `disable`, the default.
    Disable,
}

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

/// Which versions and extensions bring something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Since {
    core: Option<Version>,
    es: bool,
    /// The bits of the extensions of which any brings it.
    extensions: u32,
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

    fn extensions(self) -> impl Iterator<Item = Extension> {
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
