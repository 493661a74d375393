//! The extensions that are implemented whole: `glGetString`, `glGetStringi`.

use crate::base::availability::EXTENSIONS_OF_CORE;
use crate::base::constants::*;
use crate::base::core_profile::removed_value;
use crate::base::error::{ErrorCode, Result, Table, invalid_value};
use crate::base::es_extensions::EXTENSIONS_OF_ES;
use crate::base::types::*;
use crate::base::version;
use crate::context::Context;
use crate::context::profile::Profile;
use std::sync::LazyLock;

/// The names by the year of their specification, as a program copies the string into an array of a size that
/// did for the extensions of its time: 2048 bytes in games of 2000, 4096 in those of the years after.
/// `GL_ARB_compatibility` says that later versions have kept what 3.0 calls deprecated.
pub(crate) const EXTENSIONS: &[&str] = &[
    // 1995
    "GL_EXT_abgr",
    "GL_EXT_bgra",
    "GL_EXT_blend_color",
    "GL_EXT_blend_minmax",
    "GL_EXT_blend_subtract",
    "GL_EXT_copy_texture",
    "GL_EXT_subtexture",
    "GL_EXT_texture_object",
    "GL_EXT_vertex_array",
    // 1996
    "GL_EXT_compiled_vertex_array",
    "GL_EXT_texture3D",
    // 1997
    "GL_EXT_draw_range_elements",
    "GL_EXT_packed_pixels",
    "GL_EXT_point_parameters",
    "GL_EXT_rescale_normal",
    "GL_EXT_separate_specular_color",
    "GL_EXT_texture_edge_clamp",
    "GL_SGIS_generate_mipmap",
    "GL_SGIS_texture_border_clamp",
    "GL_SGIS_texture_edge_clamp",
    "GL_SGIS_texture_lod",
    // 1998
    "GL_ARB_multitexture",
    "GL_EXT_fog_coord",
    // 1999
    "GL_ARB_multisample",
    "GL_ARB_texture_cube_map",
    "GL_ARB_texture_env_add",
    "GL_ARB_transpose_matrix",
    "GL_EXT_blend_func_separate",
    "GL_EXT_multi_draw_arrays",
    "GL_EXT_secondary_color",
    "GL_EXT_stencil_wrap",
    "GL_EXT_texture_cube_map",
    "GL_EXT_texture_env_add",
    "GL_EXT_texture_env_combine",
    "GL_EXT_texture_filter_anisotropic",
    "GL_EXT_texture_lod_bias",
    "GL_NV_blend_square",
    "GL_NV_texgen_reflection",
    "GL_NV_texture_env_combine4",
    // 2000
    "GL_ARB_point_parameters",
    "GL_ARB_texture_border_clamp",
    "GL_ARB_texture_compression",
    "GL_EXT_texture_compression_dxt1",
    "GL_EXT_texture_compression_s3tc",
    "GL_EXT_texture_env_dot3",
    "GL_NV_texture_rectangle",
    // 2001
    "GL_ARB_depth_texture",
    "GL_ARB_shadow",
    "GL_ARB_texture_env_combine",
    "GL_ARB_texture_env_crossbar",
    "GL_ARB_texture_env_dot3",
    "GL_ARB_texture_mirrored_repeat",
    "GL_ARB_window_pos",
    "GL_EXT_stencil_two_side",
    "GL_MESA_window_pos",
    // 2002
    "GL_ARB_draw_buffers",
    "GL_ARB_fragment_program",
    "GL_ARB_fragment_shader",
    "GL_ARB_shader_objects",
    "GL_ARB_vertex_program",
    "GL_ARB_vertex_shader",
    "GL_ATI_draw_buffers",
    "GL_ATI_texture_float",
    "GL_ATI_texture_mirror_once",
    "GL_EXT_shadow_funcs",
    "GL_NV_primitive_restart",
    // 2003
    "GL_ARB_fragment_program_shadow",
    "GL_ARB_half_float_pixel",
    "GL_ARB_occlusion_query",
    "GL_ARB_point_sprite",
    "GL_ARB_shading_language_100",
    "GL_ARB_texture_non_power_of_two",
    "GL_ARB_vertex_buffer_object",
    "GL_ATI_separate_stencil",
    "GL_ATI_texture_compression_3dc",
    "GL_EXT_blend_equation_separate",
    // 2004
    "GL_ARB_color_buffer_float",
    "GL_ARB_pixel_buffer_object",
    "GL_ARB_texture_compression_rgtc",
    "GL_ARB_texture_float",
    "GL_ARB_texture_rectangle",
    "GL_EXT_packed_depth_stencil",
    "GL_EXT_packed_float",
    "GL_EXT_pixel_buffer_object",
    "GL_EXT_texture_compression_latc",
    "GL_EXT_texture_compression_rgtc",
    "GL_EXT_texture_mirror_clamp",
    "GL_EXT_texture_rectangle",
    "GL_EXT_texture_sRGB",
    "GL_EXT_texture_shared_exponent",
    // 2005
    "GL_EXT_framebuffer_blit",
    "GL_EXT_framebuffer_multisample",
    "GL_EXT_framebuffer_object",
    // 2006
    "GL_EXT_draw_buffers2",
    "GL_EXT_draw_instanced",
    "GL_EXT_framebuffer_sRGB",
    "GL_EXT_gpu_program_parameters",
    "GL_EXT_gpu_shader4",
    "GL_EXT_texture_array",
    "GL_EXT_texture_buffer_object",
    "GL_EXT_texture_integer",
    "GL_EXT_timer_query",
    "GL_EXT_transform_feedback",
    "GL_OES_EGL_image",
    // 2008
    "GL_ARB_copy_buffer",
    "GL_ARB_depth_buffer_float",
    "GL_ARB_draw_instanced",
    "GL_ARB_framebuffer_object",
    "GL_ARB_framebuffer_sRGB",
    "GL_ARB_half_float_vertex",
    "GL_ARB_instanced_arrays",
    "GL_ARB_map_buffer_range",
    "GL_ARB_texture_buffer_object",
    "GL_ARB_texture_rg",
    "GL_ARB_texture_swizzle",
    "GL_ARB_vertex_array_bgra",
    "GL_ARB_vertex_array_object",
    "GL_EXT_provoking_vertex",
    "GL_EXT_texture_swizzle",
    "GL_EXT_vertex_array_bgra",
    "GL_NV_conditional_render",
    // 2009
    "GL_AMD_draw_buffers_blend",
    "GL_AMD_seamless_cubemap_per_texture",
    "GL_ARB_compatibility",
    "GL_ARB_depth_clamp",
    "GL_ARB_draw_buffers_blend",
    "GL_ARB_draw_elements_base_vertex",
    "GL_ARB_fragment_coord_conventions",
    "GL_ARB_provoking_vertex",
    "GL_ARB_seamless_cube_map",
    "GL_ARB_shader_texture_lod",
    "GL_ARB_sync",
    "GL_ARB_texture_cube_map_array",
    "GL_ARB_texture_gather",
    "GL_ARB_sample_shading",
    "GL_ARB_texture_multisample",
    "GL_ARB_texture_query_lod",
    "GL_ARB_uniform_buffer_object",
    "GL_EXT_texture_sRGB_decode",
    "GL_EXT_texture_snorm",
    "GL_NV_texture_barrier",
    // 2010
    "GL_AMD_conservative_depth",
    "GL_ARB_ES2_compatibility",
    "GL_ARB_blend_func_extended",
    "GL_ARB_conservative_depth",
    "GL_ARB_debug_output",
    "GL_ARB_draw_indirect",
    "GL_ARB_explicit_attrib_location",
    "GL_ARB_get_program_binary",
    "GL_ARB_occlusion_query2",
    "GL_ARB_sampler_objects",
    "GL_ARB_separate_shader_objects",
    "GL_ARB_shader_bit_encoding",
    "GL_ARB_shader_stencil_export",
    "GL_ARB_texture_buffer_object_rgb32",
    "GL_ARB_texture_compression_bptc",
    "GL_ARB_texture_rgb10_a2ui",
    "GL_ARB_timer_query",
    "GL_ARB_transform_feedback2",
    "GL_ARB_transform_feedback3",
    "GL_ARB_vertex_type_2_10_10_10_rev",
    "GL_ARB_viewport_array",
    // 2011
    "GL_ARB_base_instance",
    "GL_ARB_internalformat_query",
    "GL_ARB_shading_language_420pack",
    "GL_ARB_shading_language_packing",
    "GL_ARB_texture_storage",
    "GL_EXT_framebuffer_multisample_blit_scaled",
    // 2012
    "GL_AMD_vertex_shader_layer",
    "GL_AMD_vertex_shader_viewport_index",
    "GL_ARB_arrays_of_arrays",
    "GL_ARB_clear_buffer_object",
    "GL_ARB_copy_image",
    "GL_ARB_explicit_uniform_location",
    "GL_ARB_fragment_layer_viewport",
    "GL_ARB_framebuffer_no_attachments",
    "GL_ARB_internalformat_query2",
    "GL_ARB_invalidate_subdata",
    "GL_ARB_multi_draw_indirect",
    "GL_ARB_stencil_texturing",
    "GL_ARB_texture_buffer_range",
    "GL_ARB_texture_query_levels",
    "GL_ARB_texture_storage_multisample",
    "GL_ARB_texture_view",
    "GL_ARB_vertex_attrib_binding",
    "GL_KHR_debug",
    "GL_KHR_robustness",
    // 2013
    "GL_ARB_buffer_storage",
    "GL_ARB_clear_texture",
    "GL_ARB_seamless_cubemap_per_texture",
    "GL_ARB_texture_mirror_clamp_to_edge",
    "GL_ARB_texture_stencil8",
    "GL_ARB_vertex_type_10f_11f_11f_rev",
    // 2014
    "GL_ARB_clip_control",
    "GL_ARB_cull_distance",
    "GL_ARB_direct_state_access",
    "GL_ARB_get_texture_sub_image",
    "GL_ARB_texture_barrier",
    "GL_EXT_polygon_offset_clamp",
    // 2017
    "GL_ARB_polygon_offset_clamp",
    "GL_ARB_texture_filter_anisotropic",
];

/// Extensions that the registry has for the compatibility profile alone, and that Mesa's core contexts list: programs
/// look for them where what they add is part of the version.
const ALSO_OF_CORE: &[&str] = &[
    "GL_AMD_conservative_depth",
    "GL_AMD_vertex_shader_layer",
    "GL_AMD_vertex_shader_viewport_index",
    "GL_ARB_half_float_pixel",
    "GL_ARB_pixel_buffer_object",
    "GL_ARB_shader_texture_lod",
    "GL_ARB_texture_float",
    "GL_ARB_texture_rectangle",
    "GL_ATI_texture_float",
    "GL_EXT_abgr",
    "GL_EXT_draw_buffers2",
    "GL_EXT_draw_instanced",
    "GL_EXT_framebuffer_sRGB",
    "GL_EXT_packed_depth_stencil",
    "GL_EXT_packed_float",
    "GL_EXT_pixel_buffer_object",
    "GL_EXT_provoking_vertex",
    "GL_EXT_texture_array",
    "GL_EXT_texture_compression_dxt1",
    "GL_EXT_texture_compression_rgtc",
    "GL_EXT_texture_filter_anisotropic",
    "GL_EXT_texture_integer",
    "GL_EXT_texture_shared_exponent",
    "GL_EXT_texture_snorm",
    "GL_EXT_texture_sRGB",
    "GL_EXT_texture_swizzle",
    "GL_EXT_timer_query",
    "GL_EXT_transform_feedback",
    "GL_EXT_vertex_array_bgra",
    "GL_NV_conditional_render",
    "GL_OES_EGL_image",
];

/// Those of core contexts.
static CORE: LazyLock<Vec<&str>> = LazyLock::new(|| {
    let in_core = |name: &&str| EXTENSIONS_OF_CORE.contains(name) || ALSO_OF_CORE.contains(name);
    EXTENSIONS.iter().copied().filter(in_core).collect()
});

/// The extensions of a context.
pub(crate) fn extensions_of(context: &Context) -> &'static [&'static str] {
    match context.profile {
        Profile::Compatibility(_) => EXTENSIONS,
        Profile::Core(_) => &CORE,
        Profile::Es => EXTENSIONS_OF_ES,
    }
}

/// `GL_VERSION` of a profile.
fn version_of(profile: &str) -> String {
    format!("{} ({profile} Profile) DetGL {}", version::reported(), env!("CARGO_PKG_VERSION"))
}

static CORE_VERSION: LazyLock<String> = LazyLock::new(|| version_of("Core"));
static COMPATIBILITY_VERSION: LazyLock<String> = LazyLock::new(|| version_of("Compatibility"));

/// What stands first is what programs look for (OpenGL ES 3.0, section 6.1.5).
static ES_VERSION: LazyLock<String> = LazyLock::new(|| {
    format!("OpenGL ES {} DetGL {}", version::IMPLEMENTED_ES, env!("CARGO_PKG_VERSION"))
});

/// The names with blanks between them.
/// The names as `glGetString` gives them, as many as fit: programs of the years of the first ones copy the string into
/// arrays of 4096 bytes. Programs that look for the later ones ask `glGetStringi`, which has them all.
static JOINED: LazyLock<String> = LazyLock::new(|| {
    const LONGEST: usize = 4095;
    let mut joined = String::new();
    for name in EXTENSIONS {
        if joined.len() + 1 + name.len() > LONGEST {
            break;
        }
        if !joined.is_empty() {
            joined.push(' ');
        }
        joined.push_str(name);
    }
    joined
});
static JOINED_OF_ES: LazyLock<String> = LazyLock::new(|| EXTENSIONS_OF_ES.join(" "));

pub(crate) fn get_string(context: &mut Context, name: GLenum) -> Result<&'static str> {
    const STRING: Table<&str> = Table {
        section: "GL 2.1, section 6.1.11",
        rows: &[
            (GL_VENDOR, "DetGL"),
            (GL_RENDERER, "DetGL"),
            (GL_VERSION, ""),
            (GL_SHADING_LANGUAGE_VERSION, "3.30"),
            (GL_EXTENSIONS, ""),
            (GL_PROGRAM_ERROR_STRING_ARB, ""),
        ],
    };
    match (name, context.profile) {
        (GL_VERSION, Profile::Compatibility(_)) => Ok(&COMPATIBILITY_VERSION),
        (GL_VERSION, Profile::Core(_)) => Ok(&CORE_VERSION),
        (GL_VERSION, Profile::Es) => Ok(&ES_VERSION),
        (GL_SHADING_LANGUAGE_VERSION, Profile::Es) => Ok("OpenGL ES GLSL ES 3.00"),
        (GL_EXTENSIONS, Profile::Compatibility(_)) => Ok(&JOINED),
        (GL_EXTENSIONS, Profile::Core(_)) => {
            Err(removed_value("name", name, ErrorCode::InvalidEnum))
        }
        (GL_EXTENSIONS, Profile::Es) => Ok(&JOINED_OF_ES),
        (GL_PROGRAM_ERROR_STRING_ARB, _) => {
            Ok(context.state.assembly.error.map_or("", |(_, message)| message))
        }
        _ => STRING.decode("name", name),
    }
}

pub(crate) fn get_stringi(
    context: &mut Context,
    name: GLenum,
    index: GLuint,
) -> Result<&'static str> {
    const LIST: Table<GLenum> =
        Table { section: "GL 3.0, section 6.1.11", rows: &[(GL_EXTENSIONS, GL_EXTENSIONS)] };
    LIST.decode("name", name)?;
    let names = extensions_of(context);
    match names.get(index as usize) {
        Some(name) => Ok(name),
        None => invalid_value(
            LIST.section,
            format!("index = {index} must be below GL_NUM_EXTENSIONS, {}", names.len()),
        ),
    }
}

#[cfg(test)]
mod tests {
    use crate::query::extensions::*;

    #[test]
    fn no_name_stands_twice() {
        let unique: std::collections::BTreeSet<_> = EXTENSIONS.iter().collect();
        assert_eq!(unique.len(), EXTENSIONS.len());
    }

    #[test]
    fn programs_of_2000_find_what_they_look_for_in_what_they_copy() {
        let names = [
            "GL_ARB_multitexture",
            "GL_ARB_texture_compression",
            "GL_EXT_compiled_vertex_array",
            "GL_EXT_texture_compression_s3tc",
            "GL_EXT_texture_edge_clamp",
            "GL_EXT_texture_env_add",
            "GL_EXT_texture_filter_anisotropic",
        ];
        let copied: Vec<&str> = JOINED[..2048].split(' ').collect();
        for name in names {
            assert!(copied.contains(&name), "{name} is not in the first 2048 bytes");
        }
        assert!(JOINED.len() < 4096, "{} bytes", JOINED.len());
    }
}
