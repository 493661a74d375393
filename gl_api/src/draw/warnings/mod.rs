//! Warnings of a draw whose picture may not be what was meant: the usual reasons of a black one.
//!
//! What they warn of is legal, and may be right, so each is given once ([`crate::context::warnings`]). A draw compares
//! a few numbers that it has at hand; the text is made only where a warning is given.

pub(crate) mod arrays;
pub(crate) mod constant_color;
pub(crate) mod depth;
pub(crate) mod effect;
pub(crate) mod inputs;
pub(crate) mod picture;
pub(crate) mod rejected;
pub(crate) mod state;
pub(crate) mod textures;
pub(crate) mod visibility;
