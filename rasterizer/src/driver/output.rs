//! What happens to fragments after the shader, besides the depth test and blending: stencil,
//! logical operation, sRGB encoding.

use texunit::format::Format;
use texunit::sampler::Compare;

/// State of a pipeline that comes after the fragment shader. By default all of it is off.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct OutputState {
    /// The stencil test; `None` neither tests nor writes.
    pub stencil: Option<StencilState>,
    /// Takes the place of blending where the attachment is fixed-point or of integers.
    pub logic_op: Option<LogicOp>,
    /// What is written to attachments of an sRGB format.
    pub srgb: SrgbWrite,
}

/// The stencil test of both faces (GL 2.1, section 4.1.5).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StencilState {
    /// Of front faces, points and lines.
    pub front: StencilFace,
    /// Of back faces.
    pub back: StencilFace,
}

/// The stencil test of a face, and what follows it. Stencils have 8 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StencilFace {
    /// `(reference & read_mask) OP (stored & read_mask)` must hold.
    pub test: Compare,
    /// What is compared with, and what [`StencilOp::Replace`] writes.
    pub reference: u8,
    /// The bits that are compared.
    pub read_mask: u8,
    /// The bits that are written.
    pub write_mask: u8,
    /// Where the stencil test fails.
    pub fail: StencilOp,
    /// Where it passes and the depth test fails.
    pub depth_fail: StencilOp,
    /// Where both pass.
    pub pass: StencilOp,
}

/// What happens to a stencil.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum StencilOp {
    /// It stays.
    Keep,
    /// It becomes 0.
    Zero,
    /// It becomes the reference.
    Replace,
    /// One more, up to 255.
    Increment,
    /// One less, down to 0.
    Decrement,
    /// One more; 255 becomes 0.
    IncrementWrap,
    /// One less; 0 becomes 255.
    DecrementWrap,
    /// Every bit is inverted.
    Invert,
}

/// A logical operation of source `s` and destination `d`, bit by bit (GL 2.1, table 4.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LogicOp {
    /// 0.
    Clear,
    /// `s & d`.
    And,
    /// `s & !d`.
    AndReverse,
    /// `s`.
    Copy,
    /// `!s & d`.
    AndInverted,
    /// `d`.
    Noop,
    /// `s ^ d`.
    Xor,
    /// `s | d`.
    Or,
    /// `!(s | d)`.
    Nor,
    /// `!(s ^ d)`.
    Equivalent,
    /// `!d`.
    Invert,
    /// `s | !d`.
    OrReverse,
    /// `!s`.
    CopyInverted,
    /// `!s | d`.
    OrInverted,
    /// `!(s & d)`.
    Nand,
    /// All ones.
    Set,
}

/// What is written to attachments of an sRGB format (`ARB_framebuffer_sRGB`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SrgbWrite {
    /// Colours are written and blended as if the format were not sRGB.
    #[default]
    AsIs,
    /// Colours are linear: blended so, and encoded when written.
    Encode,
}

impl SrgbWrite {
    /// The format that texels of an attachment are written as.
    pub fn format(self, format: Format) -> Format {
        match self {
            Self::AsIs => format.without_srgb(),
            Self::Encode => format,
        }
    }
}
