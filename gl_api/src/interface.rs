//! Where the parts of a program meet: attribute locations, varying slots, and the state that
//! shaders can read, shared by the GLSL linker, the fixed-function generator and the translation
//! of draws.
//!
//! The slots of the built-in varyings are fixed, so that a GLSL stage and a fixed-function stage
//! fit each other without a further step. A slot that nobody reads costs nothing: the driver
//! removes it from both stages.

/// How many generic vertex attributes there are (`GL_MAX_VERTEX_ATTRIBS`); locations 0 to 15.
pub const MAX_VERTEX_ATTRIBS: u8 = 16;
/// How many texture units there are: coordinates, images and fixed function alike.
pub const MAX_TEXTURE_UNITS: u8 = 8;

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
/// Location of `gl_MultiTexCoord0`; the other units follow.
pub const ATTRIB_TEX_COORD: u8 = 24;

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
/// First slot of what the shader declares itself.
pub const VARYING_USER: u16 = 49;

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
}

/// Which form of a matrix.
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
}

impl StateVar {
    /// How many uniform words it takes.
    pub fn words(self) -> u32 {
        match self {
            Self::Matrix(..) => 16,
            Self::NormalMatrix => 9,
            Self::DepthRange => 3,
            Self::TextureEnvColor(_) => 4,
        }
    }
}

/// State that a program reads, and where its words begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StateBinding {
    /// What is read.
    pub var: StateVar,
    /// First word.
    pub word: u32,
}
