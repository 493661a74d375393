//! What can go wrong.

use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why no mistakes could be planted or tried.
#[derive(Debug, Error)]
pub enum MutantsError {
    /// A file could not be read or written.
    #[error("{path}: {source}")]
    Io {
        /// Which.
        path: PathBuf,
        /// The system's words.
        source: io::Error,
    },
    /// A source file does not parse.
    #[error("{path}: {source}")]
    Syntax {
        /// Which.
        path: PathBuf,
        /// The parser's words.
        source: syn::Error,
    },
    /// The copy does not build, and no mistake is to blame.
    #[error("the copy of the workspace does not build:\n{0}")]
    Build(String),
    /// A program could not be started.
    #[error("{program}: {source}")]
    Start {
        /// Which.
        program: PathBuf,
        /// The system's words.
        source: io::Error,
    },
    /// The checks fail without any mistake.
    #[error("without a mistake these fail: {0}; mend them first")]
    Baseline(String),
    /// Nothing to do.
    #[error("no expression of the driver's files is in a path that contains {0:?}")]
    NothingSelected(String),
}

impl MutantsError {
    /// An [`MutantsError::Io`] about a path.
    pub fn io(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |source| Self::Io { path, source }
    }
}
