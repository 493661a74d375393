//! The extensions that `#extension` can enable.

use super::Version;

/// An extension that a shader can enable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extension {
    /// `GL_ARB_arrays_of_arrays`: arrays of more than one dimension.
    ArraysOfArrays,
    /// `GL_AMD_vertex_shader_layer`: `gl_Layer` of the vertex stage.
    AmdVertexShaderLayer,
    /// `GL_AMD_vertex_shader_viewport_index`: `gl_ViewportIndex` of the vertex stage.
    AmdVertexShaderViewportIndex,
    /// `GL_AMD_conservative_depth`: `layout(depth_less)` of `gl_FragDepth`.
    AmdConservativeDepth,
    /// `GL_ARB_conservative_depth`: the same.
    ConservativeDepth,
    /// `GL_ARB_compatibility`: what GLSL 1.40 has removed, available with or without it.
    Compatibility,
    /// `GL_ARB_cull_distance`: `gl_CullDistance`.
    CullDistance,
    /// `GL_ARB_draw_buffers`: `gl_FragData`, which every version has.
    DrawBuffers,
    /// `GL_ARB_draw_instanced`: `gl_InstanceIDARB`.
    DrawInstanced,
    /// `GL_ARB_explicit_attrib_location`: `layout(location = n)`.
    ExplicitAttribLocation,
    /// `GL_ARB_explicit_uniform_location`: `layout(location = n)` of uniforms.
    ExplicitUniformLocation,
    /// `GL_ARB_fragment_layer_viewport`: `gl_Layer` and `gl_ViewportIndex` of the fragment stage.
    FragmentLayerViewport,
    /// `GL_ARB_fragment_coord_conventions`: `layout(...)` of `gl_FragCoord`.
    FragmentCoordConventions,
    /// `GL_ARB_sample_shading`: `gl_SampleID`, `gl_SamplePosition`, `gl_NumSamples`, `gl_SampleMask`.
    SampleShading,
    /// `GL_ARB_separate_shader_objects`: `layout(location = n)` of what passes between stages.
    SeparateShaderObjects,
    /// `GL_ARB_shader_bit_encoding`: `floatBitsToInt` and the like.
    ShaderBitEncoding,
    /// `GL_ARB_shader_stencil_export`: `gl_FragStencilRefARB`.
    ShaderStencilExport,
    /// `GL_ARB_shading_language_420pack`: lists as initializers, `layout(binding = n)`, qualifiers in
    /// any order.
    ShadingLanguage420Pack,
    /// `GL_ARB_shading_language_packing`: `packHalf2x16` and the like.
    ShadingLanguagePacking,
    /// `GL_APPLE_clip_distance`: `gl_ClipDistance` of GLSL ES 1.00 and 3.00.
    ClipDistance,
    /// `GL_EXT_blend_func_extended`: `gl_SecondaryFragColorEXT` of GLSL ES 1.00, `layout(index = n)` of 3.00.
    EsBlendFuncExtended,
    /// `GL_EXT_draw_buffers`: more than one element of `gl_FragData` in GLSL ES 1.00.
    EsDrawBuffers,
    /// `GL_EXT_frag_depth`: `gl_FragDepthEXT` of GLSL ES 1.00.
    FragDepth,
    /// `GL_OES_EGL_image_external`: `samplerExternalOES` of GLSL ES 1.00.
    EglImageExternal,
    /// `GL_OES_EGL_image_external_essl3`: the same of GLSL ES 3.00.
    EglImageExternal300,
    /// `GL_EXT_shader_texture_lod`: explicit levels and gradients in the fragment stage of GLSL ES 1.00.
    EsShaderTextureLod,
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
    /// `GL_ARB_texture_query_levels`: `textureQueryLevels`.
    TextureQueryLevels,
    /// `GL_ARB_texture_rectangle`: `sampler2DRect`.
    TextureRectangle,
    /// `GL_ARB_uniform_buffer_object`: uniform blocks.
    UniformBufferObject,
    /// `GL_ARB_viewport_array`: `gl_ViewportIndex` of the geometry stage.
    ViewportArray,
    /// `GL_EXT_gpu_shader4`: the part that GLSL 1.30 has adopted.
    GpuShader4,
    /// `GL_EXT_texture_array`: `sampler1DArray`, `sampler2DArray`.
    TextureArray,
    /// `GL_OES_standard_derivatives`: `dFdx`, `dFdy`, `fwidth` of GLSL ES.
    StandardDerivatives,
}

impl Extension {
    /// Every extension and its name.
    pub const ALL: [(Self, &'static str); 38] = [
        (Self::ArraysOfArrays, "GL_ARB_arrays_of_arrays"),
        (Self::AmdVertexShaderLayer, "GL_AMD_vertex_shader_layer"),
        (Self::AmdVertexShaderViewportIndex, "GL_AMD_vertex_shader_viewport_index"),
        (Self::AmdConservativeDepth, "GL_AMD_conservative_depth"),
        (Self::ConservativeDepth, "GL_ARB_conservative_depth"),
        (Self::Compatibility, "GL_ARB_compatibility"),
        (Self::CullDistance, "GL_ARB_cull_distance"),
        (Self::DrawBuffers, "GL_ARB_draw_buffers"),
        (Self::DrawInstanced, "GL_ARB_draw_instanced"),
        (Self::ExplicitAttribLocation, "GL_ARB_explicit_attrib_location"),
        (Self::ExplicitUniformLocation, "GL_ARB_explicit_uniform_location"),
        (Self::FragmentLayerViewport, "GL_ARB_fragment_layer_viewport"),
        (Self::FragmentCoordConventions, "GL_ARB_fragment_coord_conventions"),
        (Self::SampleShading, "GL_ARB_sample_shading"),
        (Self::SeparateShaderObjects, "GL_ARB_separate_shader_objects"),
        (Self::ShaderBitEncoding, "GL_ARB_shader_bit_encoding"),
        (Self::ShaderStencilExport, "GL_ARB_shader_stencil_export"),
        (Self::ShadingLanguage420Pack, "GL_ARB_shading_language_420pack"),
        (Self::ShadingLanguagePacking, "GL_ARB_shading_language_packing"),
        (Self::ClipDistance, "GL_APPLE_clip_distance"),
        (Self::EsBlendFuncExtended, "GL_EXT_blend_func_extended"),
        (Self::EsDrawBuffers, "GL_EXT_draw_buffers"),
        (Self::FragDepth, "GL_EXT_frag_depth"),
        (Self::EglImageExternal, "GL_OES_EGL_image_external"),
        (Self::EglImageExternal300, "GL_OES_EGL_image_external_essl3"),
        (Self::EsShaderTextureLod, "GL_EXT_shader_texture_lod"),
        (Self::ShaderTextureLod, "GL_ARB_shader_texture_lod"),
        (Self::TextureCubeMapArray, "GL_ARB_texture_cube_map_array"),
        (Self::TextureGather, "GL_ARB_texture_gather"),
        (Self::TextureMultisample, "GL_ARB_texture_multisample"),
        (Self::TextureQueryLod, "GL_ARB_texture_query_lod"),
        (Self::TextureQueryLevels, "GL_ARB_texture_query_levels"),
        (Self::TextureRectangle, "GL_ARB_texture_rectangle"),
        (Self::UniformBufferObject, "GL_ARB_uniform_buffer_object"),
        (Self::ViewportArray, "GL_ARB_viewport_array"),
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
            Self::StandardDerivatives
            | Self::EsDrawBuffers
            | Self::FragDepth
            | Self::EglImageExternal
            | Self::EsShaderTextureLod => version == Version::Es100,
            Self::EglImageExternal300 => version == Version::Es300,
            Self::ClipDistance | Self::EsBlendFuncExtended => version.is_es(),
            Self::CullDistance => version >= Version::V130 && !version.is_es(),
            Self::Compatibility => version >= Version::V140 && !version.is_es(),
            Self::ArraysOfArrays
            | Self::AmdVertexShaderLayer
            | Self::AmdVertexShaderViewportIndex
            | Self::AmdConservativeDepth
            | Self::ConservativeDepth
            | Self::FragmentLayerViewport
            | Self::ViewportArray
            | Self::DrawBuffers
            | Self::ShadingLanguage420Pack
            | Self::DrawInstanced
            | Self::ExplicitAttribLocation
            | Self::ExplicitUniformLocation
            | Self::FragmentCoordConventions
            | Self::SampleShading
            | Self::SeparateShaderObjects
            | Self::ShadingLanguagePacking
            | Self::ShaderBitEncoding
            | Self::ShaderStencilExport
            | Self::ShaderTextureLod
            | Self::UniformBufferObject
            | Self::TextureCubeMapArray
            | Self::TextureGather
            | Self::TextureMultisample
            | Self::TextureQueryLod
            | Self::TextureQueryLevels
            | Self::TextureRectangle
            | Self::GpuShader4
            | Self::TextureArray => !version.is_es(),
        }
    }

    pub(super) const fn bit(self) -> u64 {
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
