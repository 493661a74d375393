//! Warnings for a draw whose picture may not be what was meant: the usual reasons of a black one.
//!
//! What they warn of is legal, and may be right: each is said once ([`crate::context::said`]). A draw
//! compares a few numbers that it has at hand; what is made for a message is made when one is due.

pub(crate) mod depths;

pub(crate) mod arrays;
pub(crate) mod sight;
pub(crate) mod state;
pub(crate) mod textures;
