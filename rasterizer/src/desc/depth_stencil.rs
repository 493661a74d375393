//! The depth test and the stencil test.

use texunit::sampler::Compare;

/// What is done with depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DepthState {
    /// `new OP stored` must hold.
    pub test: Compare,
    /// Whether passing fragments write.
    pub write: DepthWrite,
}

/// Whether passing fragments write their depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DepthWrite {
    /// They do.
    On,
    /// They do not.
    Off,
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
