//! Linked programs.

/// How a program's values are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// All four components at once, rounded to bytes.
    Bytes,
    /// The first `components` components, one draw each, to the last bit of an `f32`.
    Exact {
        /// 1 to 4.
        components: usize,
    },
}

/// A linked program, and how its values are read.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    pub(super) name: u32,
    pub(super) precision: Precision,
}
