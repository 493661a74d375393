//! The operations on fragments after the shader, besides the depth test and blending: stencil,
//! logical operation, sRGB encoding.

use super::depth_stencil::StencilState;
use texunit::format::Format;

/// State of a pipeline for the stages after the fragment shader. All of it is off by default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct OutputState {
    /// The stencil test; `None` neither tests nor writes.
    pub stencil: Option<StencilState>,
    /// The logical operation; it replaces blending where the attachment is fixed-point or of integers.
    pub logic_op: Option<LogicOp>,
    /// The encoding of colours for attachments of an sRGB format.
    pub srgb: SrgbWrite,
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

/// The encoding of colours for attachments of an sRGB format (`ARB_framebuffer_sRGB`).
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
