//! The fixed function in a draw: which stages are generated for its state, and the uniform words that they read.

pub(crate) mod keys;
pub(crate) mod words;
