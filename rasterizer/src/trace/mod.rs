//! What happens to one pixel, written down: the clears and fragments of the passes that watch it
//! ([`Watch`]), with the numbers that they were drawn with.
//!
//! Nothing is computed differently. The shader runs the same instructions over the same lanes, one
//! at a time; a texture access runs the texture unit's general kernels with a recorder in them;
//! tests and writes are what the attachment held before and after.

mod record;
mod watch;

pub use crate::desc::Facing;
pub use record::{
    Blending, Clear, Cleared, Expression, Fate, Fragment, InputSource, InputValue, Lookup,
    MAX_STEPS, Name, Operand, PixelEvent, Step, Test, Texel, Vertex, When, Write,
};
pub use watch::Watch;
