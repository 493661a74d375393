//! The depth test and the stencil test.

use texunit::sampler::Compare;

/// State of the depth test.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DepthState {
    /// `new OP stored` must hold.
    pub test: Compare,
    /// Whether passing fragments write.
    pub write: DepthWrite,
}

/// Whether fragments that pass write their depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DepthWrite {
    /// Yes.
    On,
    /// No.
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
    /// The reference of the comparison, and the value that [`StencilOp::Replace`] writes.
    pub reference: u8,
    /// The bits that are compared.
    pub read_mask: u8,
    /// The bits that are written.
    pub write_mask: u8,
    /// The operation where the stencil test fails.
    pub fail: StencilOp,
    /// The operation where it passes and the depth test fails.
    pub depth_fail: StencilOp,
    /// The operation where both pass.
    pub pass: StencilOp,
}

impl StencilFace {
    /// Whether fragments pass the test where this stencil is stored.
    pub fn passes(&self, stored: u8) -> bool {
        let [reference, stored] = [self.reference, stored].map(|value| value & self.read_mask);
        match self.test {
            Compare::Never => false,
            Compare::Less => reference < stored,
            Compare::Equal => reference == stored,
            Compare::LessEqual => reference <= stored,
            Compare::Greater => reference > stored,
            Compare::NotEqual => reference != stored,
            Compare::GreaterEqual => reference >= stored,
            Compare::Always => true,
        }
    }
}

/// An operation on a stencil value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum StencilOp {
    /// Unchanged.
    Keep,
    /// 0.
    Zero,
    /// The reference.
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
