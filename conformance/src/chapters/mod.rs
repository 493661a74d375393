//! The checks: one file for each chapter of formulas.
//!
//! A check makes its cases (the same in every run), computes each with the oracle and with the driver, and keeps the
//! largest error. [`CHAPTERS`] lists all of them, in the order of the pipeline; no other file of this layer names it.
//!
//! To add a check: write the formula as an [`oracle`](crate::oracle), with a unit test from values computed by hand;
//! write a file here that makes cases and calls [`Harness::compare`](crate::check::Harness::compare); add it to
//! [`CHAPTERS`]; and add the mistakes that it must detect to [`MUTATIONS`](crate::mutation::MUTATIONS), each of which
//! a test builds in. Where cases are filtered, or only some of them reach a mode or a branch, the check counts those that
//! do and says how many must ([`Tally::reach`](crate::check::Tally::reach)).

mod accumulation;
mod anisotropic_pictures;
mod anisotropy;
mod attributes;
mod bitmaps;
mod blend;
mod blending;
mod blits;
mod buffer_textures;
mod buffers;
mod builtin;
mod color_sum;
mod combine;
mod combined_pictures;
mod completeness;
mod compressed;
mod computed_pictures;
mod coverage;
mod cube;
mod cube_array;
mod cube_pictures;
mod depth_clamp;
mod depth_test;
mod env;
mod es_levels;
mod etc;
mod evaluator_meshes;
mod evaluators;
mod filter;
mod format;
mod fragment;
mod geometry;
mod glsl_fragments;
mod glsl_numbers;
mod integer;
mod integer_lookup;
mod interpolation;
mod layers;
mod lecture;
mod level;
mod line_ties;
mod lines;
mod lists;
mod lod;
mod lod_query;
mod lod_segments;
mod lookup;
mod lookup_offset;
mod meshes;
mod mipmap;
mod multisample;
mod packing;
mod picture_formats;
mod pictures;
mod pixel;
mod pixel_rects;
mod points;
mod polygon_offset;
mod polygons;
mod powers;
mod probe_pictures;
mod projection;
mod provoking;
mod pyramid;
mod sample_shading;
mod sampled_rects;
mod sampler_object;
mod samples;
mod scale_image;
mod seamless;
mod second_color;
mod shading;
mod shadow;
mod shadow_array;
mod small_floats;
mod srgb;
mod stencil_regions;
mod stiff_matrices;
mod stores;
mod swizzle_paths;
mod target;
mod texel_mode;
mod texture_pictures;
mod transforms;
mod uniform_block;
mod vertex;
mod vertex_arrays;
mod view_volume;
mod wrap;

use crate::check::Check;

/// A heading, and the checks under it.
pub type Chapter = (&'static str, &'static [Check]);

/// Every check, chapter by chapter, in the order of the pipeline.
pub const CHAPTERS: &[Chapter] = &[
    ("The client's pixels", &[pixel::UNPACK, pixel::PACK, pixel::STORE, pixel::TRANSFER]),
    (
        "Texel formats",
        &[
            format::SAMPLED,
            format::QUERIED,
            format::INTEGERS,
            integer::SAMPLED,
            integer_lookup::PACKED,
            compressed::COMPRESSED,
            etc::RGB,
            etc::PUNCHTHROUGH,
            etc::RGBA,
            etc::EAC,
            small_floats::SHARED,
            small_floats::UPLOADED,
            small_floats::RENDERED,
            srgb::DECODE,
            texel_mode::DEPTH_MODE,
            texel_mode::SWIZZLE,
            swizzle_paths::PATHS,
        ],
    ),
    ("Mipmaps", &[mipmap::GENERATED, mipmap::FLOATS, mipmap::GLU, scale_image::SCALE]),
    (
        "Rasterization",
        &[
            coverage::COVERAGE,
            coverage::SHARED_EDGES,
            interpolation::PERSPECTIVE,
            interpolation::DEPTH,
            depth_clamp::CLAMP,
            provoking::FLAT,
            samples::POSITION,
            samples::MASK,
            samples::RESOLVE,
        ],
    ),
    (
        "Points, lines and polygons",
        &[
            points::SIZE,
            points::SMOOTH,
            points::ATTENUATION,
            points::SPRITE,
            points::POINT_COORD,
            lines::DIAMOND,
            lines::WIDTH,
            lines::STIPPLE,
            lines::SMOOTH,
            lines::VALUES,
            lines::JOINTS,
            line_ties::TIES,
            line_ties::WIDE_VALUES,
            meshes::MESH,
            meshes::DEPTH,
            view_volume::POINTS,
            view_volume::LINES,
            polygons::STIPPLE,
            polygons::CULL,
            polygons::MODE,
            polygons::SMOOTH,
            polygons::CLIP,
            polygon_offset::OFFSET_UNITS,
            polygon_offset::OFFSET_SLOPE,
        ],
    ),
    (
        "Sampling",
        &[
            projection::PROJECTIVE,
            cube::FACE,
            cube::FILTER,
            seamless::SEAMLESS,
            cube_array::FILTER,
            lod::LOD,
            lod::BIAS_CLAMP,
            lod_query::QUERY,
            lod_segments::LINES,
            lod_segments::POINTS,
            lod_segments::RECTANGLES,
            lookup::LOD,
            lookup::GRAD,
            lookup_offset::LOD,
            lookup_offset::GRAD,
            pyramid::LAMBDA,
            pyramid::CUBE_GRAD,
            level::LEVEL,
            es_levels::LEVELS,
            wrap::NEAREST,
            wrap::LINEAR,
            integer_lookup::WRAP,
            sampler_object::PRECEDENCE,
            target::FILTERED,
            target::OFFSET,
            target::PROJECTED,
            target::FETCH,
            pyramid::SIZE,
            filter::NEAREST,
            filter::BILINEAR,
            anisotropy::ANISOTROPY,
            shadow::COMPARE,
            texel_mode::COMPARE_LINEAR,
            shadow_array::COMPARE,
        ],
    ),
    (
        "Vertices",
        &[
            vertex_arrays::DIVISOR,
            vertex_arrays::BASE,
            vertex_arrays::RESTART,
            vertex_arrays::PACKED,
            uniform_block::STD140,
            vertex::TEXGEN,
            stiff_matrices::EYE_PLANES,
            vertex::LIGHTING,
        ],
    ),
    (
        "Geometry shaders",
        &[
            geometry::ORDER,
            geometry::STRIP,
            geometry::ADJACENCY,
            geometry::FEEDBACK,
            layers::DRAW,
            layers::CLEAR,
        ],
    ),
    (
        "Fragments",
        &[
            env::ENVIRONMENT,
            combine::COMBINE,
            combine::FOG,
            fragment::ALPHA,
            fragment::STENCIL,
            depth_test::TEST,
            blend::BLEND,
            second_color::BLEND,
            fragment::LOGIC,
        ],
    ),
    (
        "Colour buffers",
        &[
            stores::FORMATS,
            stores::DITHER,
            stores::COLOR_MASK,
            stores::DRAW_BUFFERS,
            accumulation::SCISSOR,
            accumulation::ACCUM,
            blending::SEPARATE,
            blending::USUAL,
            blending::HALF,
            blending::TARGETS,
            blending::SRGB_WRITTEN,
            blending::SRGB_BLENDED,
        ],
    ),
    (
        "Depth and stencil buffers",
        &[
            buffers::DEPTH_FORMATS,
            buffers::DEPTH_MASK,
            sample_shading::DEPTH_ONLY,
            buffers::STENCIL_FACES,
            buffers::STENCIL_CLEAR,
            stencil_regions::REGIONS,
            buffers::QUERY,
            buffers::CONDITIONAL,
        ],
    ),
    (
        "Samples",
        &[
            multisample::ALPHA_TO_COVERAGE,
            multisample::COVERAGE,
            multisample::RESOLVE,
            multisample::DEPTH,
            multisample::LINES,
            multisample::POINTS,
            multisample::FADE,
            sampled_rects::RECTS,
            sample_shading::SHADING,
        ],
    ),
    (
        "Pixel rectangles and copies",
        &[
            bitmaps::BITMAP,
            pixel_rects::ZOOM,
            pixel_rects::COPY,
            pixel_rects::MAPS,
            pixel_rects::INDICES,
            pixel_rects::DEPTH_STENCIL,
            pixel_rects::READ_LUMINANCE,
            blits::NEAREST,
            blits::LINEAR,
            blits::DEPTH_STENCIL,
            blits::COPY_TEXTURE,
        ],
    ),
    (
        "Transformation and light",
        &[
            transforms::ROTATE,
            transforms::FRUSTUM,
            transforms::ORTHO,
            transforms::LOOK_AT,
            transforms::PRODUCT,
            transforms::VIEWPORT,
            transforms::RASTER_POSITION,
            transforms::SELECTION,
            lists::CALLS,
            lists::MEMORY,
            shading::TWO_SIDED,
            shading::COLOR_MATERIAL,
            shading::SEPARATE_SPECULAR,
            shading::RESCALE,
            color_sum::COLOR_SUM,
            color_sum::CLAMPED,
            color_sum::FOG_DEPTH,
            evaluators::CURVE,
            evaluators::SURFACE,
            evaluators::NORMAL,
            evaluators::GRID,
            evaluator_meshes::MESH,
            attributes::CURRENT,
            attributes::ARRAYS,
            view_volume::INDICES,
            attributes::FEEDBACK,
        ],
    ),
    (
        "GLSL",
        &[
            glsl_numbers::ARITHMETIC,
            glsl_numbers::BITS,
            glsl_numbers::COMPARISONS,
            glsl_numbers::CONVERSIONS,
            glsl_numbers::RELATIONAL,
            glsl_numbers::SELECTING,
            glsl_numbers::PRODUCTS,
            glsl_numbers::TRANSPOSE,
            glsl_numbers::DETERMINANT,
            glsl_numbers::INVERSE,
            glsl_fragments::DERIVATIVES,
            glsl_fragments::FRAG_COORD,
            glsl_fragments::FRONT_FACING,
            glsl_fragments::NOPERSPECTIVE,
            glsl_fragments::CLIP_DISTANCE,
            glsl_fragments::FRAG_DEPTH,
        ],
    ),
    (
        "Textures in pictures",
        &[
            texture_pictures::LINEAR,
            texture_pictures::NEAREST,
            texture_pictures::TRILINEAR,
            texture_pictures::MIPMAPS,
            texture_pictures::PERSPECTIVE,
            anisotropic_pictures::AFFINE,
            anisotropic_pictures::PERSPECTIVE,
            anisotropic_pictures::OF_FORMATS,
            anisotropic_pictures::ARRAYS,
            probe_pictures::PROBES,
            picture_formats::FORMATS,
            cube_pictures::CUBE,
            cube_pictures::LEVELS,
            computed_pictures::COMPUTED,
            computed_pictures::PROJECTED,
            combined_pictures::MODULATED,
            combined_pictures::TWO_TEXTURES,
        ],
    ),
    ("The lectures", &[lecture::LECTURES]),
    ("Built-in functions", &builtin::ULP),
    ("Constant exponents", &[powers::OF_FLOATS, powers::OF_TEXELS]),
    ("Numbers in words", &packing::ALL),
    ("Completeness", &[completeness::MIPMAPS]),
    ("Textures of buffers", &[buffer_textures::FETCH]),
    ("Where built-in functions end", &[builtin::EXTREMES]),
];

/// Every check.
pub fn checks() -> impl Iterator<Item = &'static Check> + Clone {
    CHAPTERS.iter().flat_map(|(_, checks)| checks.iter())
}
