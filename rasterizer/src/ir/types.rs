//! Types of scalars, and handles into a module.

/// The word that represents `true`.
pub const TRUE: u32 = !0;

/// The type of a scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ty {
    /// IEEE single precision.
    F32,
    /// Two's complement, wrapping.
    I32,
    /// Unsigned, wrapping.
    U32,
    /// `0` or [`TRUE`].
    Bool,
}

/// A handle into [`crate::ir::Module::values`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value(pub u32);

/// A handle into [`crate::ir::Module::variables`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Var(pub u32);

/// A handle into [`crate::ir::Module::textures`]: the slot that a draw binds a texture to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Texture(pub u32);

/// The axis of a derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Axis {
    /// Window x.
    X,
    /// Window y.
    Y,
}
