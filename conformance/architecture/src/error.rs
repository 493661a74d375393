//! Why sources cannot be read.

use std::path::PathBuf;
use thiserror::Error;

/// Sources that cannot be read.
#[derive(Debug, Error)]
pub enum ReadError {
    /// A file is missing or unreadable.
    #[error("{path}: {source}")]
    Io {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: std::io::Error,
    },
    /// A file is not Rust.
    #[error("{path}:{line}: {source}", line = source.span().start().line)]
    Syntax {
        /// The file.
        path: PathBuf,
        /// The reason, with its position.
        source: syn::Error,
    },
}
