//! The text of a shader, diagnostics about it, and spelling suggestions.

pub mod diagnostics;
pub mod source;
pub mod spelling;
