//! The calls of pixel rectangles: GL 2.1, sections 2.13, 3.6, 3.7 and 4.3.3.
//!
//! In the order in which pixels pass through them: [`memory`] finds them in the client's memory or a buffer,
//! [`position`] says where they go, [`draw`], [`copy`] and [`bitmap`] make fragments of them, [`zoom`] sets how many
//! pixels of the window each becomes, and [`stencil`] writes those that are no fragments.

pub(crate) mod bitmap;
pub(crate) mod copy;
pub(crate) mod draw;
pub(crate) mod map;
pub(crate) mod memory;
pub(crate) mod position;
pub(crate) mod stencil;
pub(crate) mod store;
pub(crate) mod transfer;
pub(crate) mod zoom;
