//! Every limit of the front end. The limits that shaders can read (`gl_Max…`) are those that
//! `glGet` reports; the others bound the time and memory that a hostile source costs.

/// How many generic vertex attributes there are (`GL_MAX_VERTEX_ATTRIBS`); locations 0 to 15.
pub const MAX_VERTEX_ATTRIBS: u8 = 16;
/// How many sets of texture coordinates there are, each with a fixed-function unit, a matrix and
/// coordinate generation (`GL_MAX_TEXTURE_COORDS`, `GL_MAX_TEXTURE_UNITS`).
pub const MAX_TEXTURE_UNITS: u8 = 8;
/// How many lights there are (`GL_MAX_LIGHTS`).
pub const MAX_LIGHTS: u8 = 8;
/// How many user clip planes and clip distances there are (`GL_MAX_CLIP_PLANES`).
pub const MAX_CLIP_PLANES: u8 = 8;
/// How many samplers each stage of a program may use (`GL_MAX_TEXTURE_IMAGE_UNITS`,
/// `GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS`).
pub const MAX_TEXTURE_IMAGE_UNITS: u8 = 16;
/// How many units textures can be bound to (`GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS`): enough for the three
/// stages.
pub const MAX_COMBINED_TEXTURE_IMAGE_UNITS: u8 = 48;
/// `gl_MaxClipDistances`.
pub const MAX_CLIP_DISTANCES: u8 = MAX_CLIP_PLANES;
/// `gl_MaxCullDistances`, and `gl_MaxCombinedClipAndCullDistances`.
pub const MAX_CULL_DISTANCES: u8 = 8;
/// `gl_MaxViewports` (`GL_MAX_VIEWPORTS`).
pub const MAX_VIEWPORTS: u8 = rasterizer::driver::MAX_VIEWPORTS as u8;
/// How many elements `gl_SampleMask` has (`GL_MAX_SAMPLE_MASK_WORDS`).
pub const MAX_SAMPLE_MASK_WORDS: u8 = 1;
/// `gl_MaxDrawBuffers`: how many elements `gl_FragData` has.
pub const MAX_DRAW_BUFFERS: u8 = 8;
/// `GL_MAX_DUAL_SOURCE_DRAW_BUFFERS`: how many draw buffers have a second colour.
pub const MAX_DUAL_SOURCE_DRAW_BUFFERS: u8 = 1;
/// `gl_MaxVaryingFloats`: how many scalars may pass from stage to stage.
pub const MAX_VARYING_FLOATS: u16 = 64;
/// `gl_MaxVertexOutputComponents`, `gl_MaxGeometryInputComponents`, `gl_MaxGeometryOutputComponents`
/// and `gl_MaxFragmentInputComponents`: how many scalars may pass between two stages of programs of
/// GLSL 1.50 on.
pub const MAX_STAGE_COMPONENTS: u16 = 128;
/// `gl_MaxGeometryOutputVertices`.
pub const MAX_GEOMETRY_OUTPUT_VERTICES: u32 = 256;
/// `gl_MaxGeometryTotalOutputComponents`.
pub const MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS: u32 = 1024;
/// `gl_MaxVertexUniformComponents` and `gl_MaxFragmentUniformComponents`.
pub const MAX_UNIFORM_COMPONENTS: i32 = 16384;
/// `GL_MAX_UNIFORM_LOCATIONS`.
pub const MAX_UNIFORM_LOCATIONS: u32 = 1 << 16;
/// `GL_MAX_VERTEX_UNIFORM_BLOCKS` and `GL_MAX_FRAGMENT_UNIFORM_BLOCKS`.
pub const MAX_UNIFORM_BLOCKS: usize = 16;
/// `GL_MAX_UNIFORM_BUFFER_BINDINGS`.
pub const MAX_UNIFORM_BUFFER_BINDINGS: usize = 64;
/// `GL_MAX_UNIFORM_BLOCK_SIZE`, in bytes.
pub const MAX_UNIFORM_BLOCK_SIZE: u32 = 65536;
/// `GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_COMPONENTS`.
pub const MAX_TRANSFORM_FEEDBACK_SEPARATE_COMPONENTS: usize = 128;
/// `GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS`.
pub const MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS: usize = 128;
/// The offsets that `textureOffset` takes.
pub const TEXEL_OFFSETS: std::ops::RangeInclusive<i32> = -8..=7;
/// The offsets that `textureGatherOffset` takes.
pub const GATHER_OFFSETS: std::ops::RangeInclusive<i32> = -32..=31;

/// The longest source that is accepted, in bytes.
pub const MAX_SOURCE: usize = 1 << 24;
/// How many steps a compilation or a link may take ([`crate::work`]).
pub const MAX_WORK: u64 = 1 << 21;
/// How many errors are reported before the compiler gives up.
pub const MAX_ERRORS: usize = 20;

/// How many characters a name of GLSL ES 3.00 may have (section 3.8).
pub const MAX_NAME_ES_300: usize = 1024;
/// How many tokens the macros of a shader may produce together.
pub const MAX_EXPANDED_TOKENS: usize = 1 << 20;
/// How deep calls of macros may nest in their arguments.
pub const MAX_MACRO_DEPTH: usize = 64;
/// How many conditionals can be open at once.
pub const MAX_CONDITIONALS: usize = 256;
/// How deep parentheses and signs may nest in a condition of `#if`.
pub const MAX_CONDITION_DEPTH: usize = 64;

/// How deep statements and expressions may nest.
pub const MAX_NESTING: u32 = 256;
/// How deep the tree of an expression may be, chains such as `a + b + c` included.
pub const MAX_TREE: u32 = 3 * MAX_NESTING;

/// How many scalars a variable may have.
pub const MAX_SCALARS: u32 = 1 << 16;
/// The largest size of an array that gets its size from its largest index.
pub const MAX_IMPLICIT_SIZE: u32 = MAX_SCALARS / 16;
/// How many dimensions an array may have.
pub const MAX_DIMENSIONS: u32 = 32;
/// How deep structures may nest.
pub const MAX_STRUCT_DEPTH: u32 = 32;

/// How deep statements, expressions and inlined calls may nest.
pub const MAX_INLINED_DEPTH: u32 = 1024;
/// How many values a stage may have.
pub const MAX_VALUES: usize = 200_000;
/// How many uniform words a program may have.
pub const MAX_UNIFORM_WORDS: u32 = 1 << 20;
/// The largest array of samplers with an index that is not constant.
pub const MAX_DYNAMIC_SAMPLERS: u32 = 32;
/// A variable without initializer is set to zero in each iteration of a loop if it has at most so
/// many scalars.
pub const MAX_CLEARED: usize = 64;
