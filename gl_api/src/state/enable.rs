//! Capabilities: `glEnable` and `glEnableClientState`.

use crate::base::constants::*;
use crate::base::error::Table;
use crate::interface::{
    ATTRIB_COLOR, ATTRIB_EDGE_FLAG, ATTRIB_FOG_COORD, ATTRIB_INDEX, ATTRIB_NORMAL,
    ATTRIB_SECONDARY_COLOR, ATTRIB_TEX_COORD, ATTRIB_VERTEX, TexCoord,
};
use crate::objects::target::TextureTarget;
use crate::state::evaluators::EvaluatorName;

/// A capability that is one flag; its bit in [`Enables`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flag {
    AlphaTest,
    AutoNormal,
    Blend,
    ColorLogicOp,
    ColorMaterial,
    ColorSum,
    CullFace,
    DebugOutputSynchronous,
    DepthClamp,
    DepthTest,
    Dither,
    LineSmooth,
    LineStipple,
    FragmentProgram,
    FramebufferSrgb,
    Fog,
    IndexLogicOp,
    Lighting,
    Multisample,
    Normalize,
    PointSmooth,
    PointSprite,
    PolygonOffsetFill,
    PolygonOffsetLine,
    PolygonOffsetPoint,
    PolygonSmooth,
    PolygonStipple,
    PrimitiveRestart,
    PrimitiveRestartFixedIndex,
    RasterizerDiscard,
    RescaleNormal,
    SampleAlphaToCoverage,
    SampleAlphaToOne,
    SampleCoverage,
    SampleMask,
    SampleShading,
    ScissorTest,
    SeamlessCubeMaps,
    StencilTest,
    StencilTestTwoSide,
    VertexProgram,
    VertexProgramPointSize,
    VertexProgramTwoSide,
}

/// A capability of `glEnable`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Capability {
    Flag(Flag),
    /// Of the active texture unit.
    Texture(TextureTarget),
    /// Whether the log of `KHR_debug` is kept.
    DebugOutput,
    /// A coordinate of the active texture unit is generated.
    TexGen(TexCoord),
    Light(u8),
    ClipPlane(u8),
    /// A map of evaluators.
    Map(EvaluatorName),
}

/// The implemented capabilities; anything else is `GL_INVALID_ENUM`.
/// `GL_DITHER` changes nothing, and messages are always synchronous.
pub(crate) const CAPABILITY: Table<Capability> = Table {
    section: "GL 2.1, table 6.22 and others; what DetGL implements",
    rows: &[
        (GL_ALPHA_TEST, Capability::Flag(Flag::AlphaTest)),
        (GL_AUTO_NORMAL, Capability::Flag(Flag::AutoNormal)),
        (GL_BLEND, Capability::Flag(Flag::Blend)),
        (GL_COLOR_LOGIC_OP, Capability::Flag(Flag::ColorLogicOp)),
        (GL_COLOR_MATERIAL, Capability::Flag(Flag::ColorMaterial)),
        (GL_COLOR_SUM, Capability::Flag(Flag::ColorSum)),
        (GL_CULL_FACE, Capability::Flag(Flag::CullFace)),
        (GL_DEBUG_OUTPUT, Capability::DebugOutput),
        (GL_DEBUG_OUTPUT_SYNCHRONOUS, Capability::Flag(Flag::DebugOutputSynchronous)),
        (GL_DEPTH_CLAMP, Capability::Flag(Flag::DepthClamp)),
        (GL_DEPTH_TEST, Capability::Flag(Flag::DepthTest)),
        (GL_DITHER, Capability::Flag(Flag::Dither)),
        (GL_LINE_SMOOTH, Capability::Flag(Flag::LineSmooth)),
        (GL_LINE_STIPPLE, Capability::Flag(Flag::LineStipple)),
        (GL_FRAGMENT_PROGRAM_ARB, Capability::Flag(Flag::FragmentProgram)),
        (GL_FRAMEBUFFER_SRGB, Capability::Flag(Flag::FramebufferSrgb)),
        (GL_FOG, Capability::Flag(Flag::Fog)),
        (GL_INDEX_LOGIC_OP, Capability::Flag(Flag::IndexLogicOp)),
        (GL_LIGHTING, Capability::Flag(Flag::Lighting)),
        (GL_MULTISAMPLE, Capability::Flag(Flag::Multisample)),
        (GL_NORMALIZE, Capability::Flag(Flag::Normalize)),
        (GL_POINT_SMOOTH, Capability::Flag(Flag::PointSmooth)),
        (GL_POINT_SPRITE, Capability::Flag(Flag::PointSprite)),
        (GL_POLYGON_OFFSET_FILL, Capability::Flag(Flag::PolygonOffsetFill)),
        (GL_POLYGON_OFFSET_LINE, Capability::Flag(Flag::PolygonOffsetLine)),
        (GL_POLYGON_OFFSET_POINT, Capability::Flag(Flag::PolygonOffsetPoint)),
        (GL_POLYGON_SMOOTH, Capability::Flag(Flag::PolygonSmooth)),
        (GL_POLYGON_STIPPLE, Capability::Flag(Flag::PolygonStipple)),
        (GL_PRIMITIVE_RESTART, Capability::Flag(Flag::PrimitiveRestart)),
        (GL_PRIMITIVE_RESTART_FIXED_INDEX, Capability::Flag(Flag::PrimitiveRestartFixedIndex)),
        (GL_RASTERIZER_DISCARD, Capability::Flag(Flag::RasterizerDiscard)),
        (GL_RESCALE_NORMAL, Capability::Flag(Flag::RescaleNormal)),
        (GL_SAMPLE_ALPHA_TO_COVERAGE, Capability::Flag(Flag::SampleAlphaToCoverage)),
        (GL_SAMPLE_ALPHA_TO_ONE, Capability::Flag(Flag::SampleAlphaToOne)),
        (GL_SAMPLE_COVERAGE, Capability::Flag(Flag::SampleCoverage)),
        (GL_SAMPLE_MASK, Capability::Flag(Flag::SampleMask)),
        (GL_SAMPLE_SHADING, Capability::Flag(Flag::SampleShading)),
        (GL_SCISSOR_TEST, Capability::Flag(Flag::ScissorTest)),
        (GL_STENCIL_TEST, Capability::Flag(Flag::StencilTest)),
        (GL_STENCIL_TEST_TWO_SIDE_EXT, Capability::Flag(Flag::StencilTestTwoSide)),
        (GL_TEXTURE_CUBE_MAP_SEAMLESS, Capability::Flag(Flag::SeamlessCubeMaps)),
        (GL_VERTEX_PROGRAM_ARB, Capability::Flag(Flag::VertexProgram)),
        (GL_VERTEX_PROGRAM_POINT_SIZE, Capability::Flag(Flag::VertexProgramPointSize)),
        (GL_VERTEX_PROGRAM_TWO_SIDE, Capability::Flag(Flag::VertexProgramTwoSide)),
        (GL_TEXTURE_1D, Capability::Texture(TextureTarget::D1)),
        (GL_TEXTURE_2D, Capability::Texture(TextureTarget::D2)),
        (GL_TEXTURE_3D, Capability::Texture(TextureTarget::D3)),
        (GL_TEXTURE_RECTANGLE, Capability::Texture(TextureTarget::Rect)),
        (GL_TEXTURE_CUBE_MAP, Capability::Texture(TextureTarget::Cube)),
        (GL_TEXTURE_GEN_S, Capability::TexGen(TexCoord::S)),
        (GL_TEXTURE_GEN_T, Capability::TexGen(TexCoord::T)),
        (GL_TEXTURE_GEN_R, Capability::TexGen(TexCoord::R)),
        (GL_TEXTURE_GEN_Q, Capability::TexGen(TexCoord::Q)),
        (GL_LIGHT0, Capability::Light(0)),
        (GL_LIGHT1, Capability::Light(1)),
        (GL_LIGHT2, Capability::Light(2)),
        (GL_LIGHT3, Capability::Light(3)),
        (GL_LIGHT4, Capability::Light(4)),
        (GL_LIGHT5, Capability::Light(5)),
        (GL_LIGHT6, Capability::Light(6)),
        (GL_LIGHT7, Capability::Light(7)),
        (GL_CLIP_PLANE0, Capability::ClipPlane(0)),
        (GL_CLIP_PLANE1, Capability::ClipPlane(1)),
        (GL_CLIP_PLANE2, Capability::ClipPlane(2)),
        (GL_CLIP_PLANE3, Capability::ClipPlane(3)),
        (GL_CLIP_PLANE4, Capability::ClipPlane(4)),
        (GL_CLIP_PLANE5, Capability::ClipPlane(5)),
        (GL_CLIP_DISTANCE6, Capability::ClipPlane(6)),
        (GL_CLIP_DISTANCE7, Capability::ClipPlane(7)),
    ],
};

/// The flags that are enabled.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Enables(u64);

/// Some flags, whatever they are set to.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Flags(u64);

impl Flags {
    pub const fn of(flags: &[Flag]) -> Self {
        let (mut mask, mut at) = (0, 0);
        while at < flags.len() {
            mask |= 1 << flags[at] as u32;
            at += 1;
        }
        Self(mask)
    }

    /// Those of both.
    pub fn with(self, Self(more): Self) -> Self {
        Self(self.0 | more)
    }
}

impl Default for Enables {
    fn default() -> Self {
        Self(1 << Flag::Dither as u32 | 1 << Flag::Multisample as u32)
    }
}

impl Enables {
    pub fn has(&self, flag: Flag) -> bool {
        self.0 >> flag as u32 & 1 == 1
    }

    /// Copies some flags from others.
    pub fn copy_from(&mut self, Flags(mask): Flags, from: &Self) {
        self.0 = self.0 & !mask | from.0 & mask;
    }

    pub fn set(&mut self, flag: Flag, on: bool) {
        self.0 = self.0 & !(1 << flag as u32) | u64::from(on) << flag as u32;
    }
}

/// Whether a call enables or disables a capability.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Switch {
    On,
    Off,
}

/// The conventional arrays, as their attribute location.
pub(crate) const CLIENT_ARRAY: Table<u8> = Table {
    section: "GL 2.1, section 2.8",
    rows: &[
        (GL_VERTEX_ARRAY, ATTRIB_VERTEX),
        (GL_NORMAL_ARRAY, ATTRIB_NORMAL),
        (GL_COLOR_ARRAY, ATTRIB_COLOR),
        (GL_SECONDARY_COLOR_ARRAY, ATTRIB_SECONDARY_COLOR),
        (GL_EDGE_FLAG_ARRAY, ATTRIB_EDGE_FLAG),
        (GL_FOG_COORD_ARRAY, ATTRIB_FOG_COORD),
        (GL_INDEX_ARRAY, ATTRIB_INDEX),
        (GL_TEXTURE_COORD_ARRAY, ATTRIB_TEX_COORD),
    ],
};
