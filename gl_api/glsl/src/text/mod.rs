//! The text of a shader, what is wrong with it, and how that is reported.

pub mod diagnostics;
pub mod source;
pub mod spelling;
