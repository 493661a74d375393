//! The interface of programs: attribute locations, varying slots, and the state that shaders can
//! read, shared by the GLSL linker, the fixed-function generator and the translation of draws.
//!
//! The slots of the built-in varyings are fixed, so that a GLSL stage and a fixed-function stage
//! fit each other without a further step. A slot that nobody reads costs nothing: the driver
//! removes it from both stages.

pub use crate::limits::{
    MAX_CLIP_PLANES, MAX_COMBINED_TEXTURE_IMAGE_UNITS, MAX_LIGHTS, MAX_TEXTURE_IMAGE_UNITS,
    MAX_TEXTURE_UNITS, MAX_VERTEX_ATTRIBS,
};

/// Location of `gl_Vertex`.
pub const ATTRIB_VERTEX: u8 = 16;
/// Location of `gl_Normal`.
pub const ATTRIB_NORMAL: u8 = 17;
/// Location of `gl_Color`.
pub const ATTRIB_COLOR: u8 = 18;
/// Location of `gl_SecondaryColor`.
pub const ATTRIB_SECONDARY_COLOR: u8 = 19;
/// Location of `gl_FogCoord`.
pub const ATTRIB_FOG_COORD: u8 = 20;
/// Location of the edge flag, which no shader reads.
pub const ATTRIB_EDGE_FLAG: u8 = 21;
/// Location of the colour index, which no shader reads.
pub const ATTRIB_INDEX: u8 = 22;
/// Location of `gl_MultiTexCoord0`; the other units follow.
pub const ATTRIB_TEX_COORD: u8 = 24;
/// First location of the materials of vertices, where `glMaterial` stands between `glBegin` and
/// `glEnd`.
pub const ATTRIB_MATERIAL: u8 = 32;

/// First of the four slots of `gl_FrontColor` / `gl_Color`.
pub const VARYING_COLOR: u16 = 0;
/// First of the four slots of `gl_FrontSecondaryColor` / `gl_SecondaryColor`.
pub const VARYING_SECONDARY_COLOR: u16 = 4;
/// First of the four slots of `gl_TexCoord[0]`; four for each unit.
pub const VARYING_TEX_COORD: u16 = 8;
/// The slot of `gl_FogFragCoord`.
pub const VARYING_FOG: u16 = 40;
/// First slot of the back colours (primary, then secondary).
pub const VARYING_BACK_COLOR: u16 = 41;
/// First of the eight slots of `gl_ClipDistance`.
pub const VARYING_CLIP_DISTANCE: u16 = 49;
/// First of the two slots of `gl_PrimitiveID`: its low and its high 16 bits.
pub const VARYING_PRIMITIVE_ID: u16 = 57;
/// First slot of user-defined varyings.
pub const VARYING_USER: u16 = 59;

/// A matrix of the GL state that shaders can read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum StateMatrix {
    /// `gl_ModelViewMatrix`.
    ModelView,
    /// `gl_ProjectionMatrix`.
    Projection,
    /// `gl_ModelViewProjectionMatrix`.
    ModelViewProjection,
    /// `gl_TextureMatrix[unit]`.
    Texture(u8),
    /// `state.matrix.program[n]`.
    Program(u8),
}

/// A form of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum MatrixForm {
    /// Itself.
    Plain,
    /// Its inverse.
    Inverse,
    /// Its transpose.
    Transpose,
    /// The transpose of its inverse.
    InverseTranspose,
}

/// A side of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Side {
    /// The front.
    Front,
    /// The back.
    Back,
}

/// The planes of coordinate generation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum TexGenPlane {
    /// `GL_EYE_PLANE`, in eye coordinates.
    Eye,
    /// `GL_OBJECT_PLANE`.
    Object,
}

/// A texture coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum TexCoord {
    /// s.
    S,
    /// t.
    T,
    /// r.
    R,
    /// q.
    Q,
}

/// A piece of GL state that a program reads through uniform words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum StateVar {
    /// 16 words, column by column.
    Matrix(StateMatrix, MatrixForm),
    /// `gl_NormalMatrix`: 9 words, column by column.
    NormalMatrix,
    /// `gl_DepthRange`: near, far, far - near.
    DepthRange,
    /// `GL_TEXTURE_ENV_COLOR` of a unit: 4 words.
    TextureEnvColor(u8),
    /// `gl_NormalScale`: 1 word, the factor of `GL_RESCALE_NORMAL`.
    NormalScale,
    /// `gl_ClipPlane` of a user clip plane, in eye coordinates: 4 words.
    ClipPlane(u8),
    /// Which user clip planes or distances are enabled: 8 words, 1.0 or 0.0 each.
    ClipEnables,
    /// `gl_Point`: size, minimum and maximum size, fade threshold, constant, linear and quadratic
    /// attenuation.
    Point,
    /// `gl_FrontMaterial`, `gl_BackMaterial`: emission, ambient, diffuse, specular (4 words each),
    /// shininess.
    Material(Side),
    /// `gl_LightSource` of a light: ambient, diffuse, specular, position, half vector (4 words
    /// each), spot direction (3), spot exponent, cutoff, cosine of the cutoff, constant, linear and
    /// quadratic attenuation.
    Light(u8),
    /// `gl_LightModel`: the ambient colour, 4 words.
    LightModel,
    /// `gl_FrontLightModelProduct`, `gl_BackLightModelProduct`: the scene's colour, 4 words.
    LightModelProduct(Side),
    /// `gl_FrontLightProduct`, `gl_BackLightProduct` of a light: ambient, diffuse, specular, 4 words
    /// each.
    LightProduct(Side, u8),
    /// `gl_EyePlaneS` and the like, of a unit: 4 words.
    TexGen(TexGenPlane, TexCoord, u8),
    /// `gl_Fog`: colour (4 words), density, start, end, 1 / (end - start).
    Fog,
    /// The number of rows of the draw framebuffer: 1 word, for a `gl_FragCoord` whose origin is the
    /// upper left.
    FramebufferHeight,
    /// The number of samples of the draw framebuffer, 1 where it has none: 1 word.
    SampleCount,
}

impl StateVar {
    /// How many uniform words it takes.
    pub fn words(self) -> u32 {
        match self {
            Self::Matrix(..) => 16,
            Self::NormalMatrix => 9,
            Self::DepthRange => 3,
            Self::NormalScale | Self::FramebufferHeight | Self::SampleCount => 1,
            Self::TextureEnvColor(_)
            | Self::ClipPlane(_)
            | Self::LightModel
            | Self::LightModelProduct(_)
            | Self::TexGen(..) => 4,
            Self::ClipEnables | Self::Fog => 8,
            Self::Point => 7,
            Self::Material(_) => 17,
            Self::Light(_) => 29,
            Self::LightProduct(..) => 12,
        }
    }
}

/// State that a program reads, and its words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StateBinding {
    /// The state.
    pub var: StateVar,
    /// First word.
    pub word: u32,
}
