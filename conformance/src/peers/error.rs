//! Why drivers cannot be compared.

use super::client::ClientError;
use std::path::PathBuf;

/// Why drivers cannot be compared.
#[derive(Debug, thiserror::Error)]
#[expect(missing_docs, reason = "the messages say it")]
pub enum PeersError {
    #[error(
        "there is no libdetgl.so in {0} or its deps/: build it with `cargo build --release -p \
         capi`, or name it with --lib"
    )]
    NoLibrary(PathBuf),
    #[error("there is no scene {0:?}")]
    NoScene(String),
    #[error(transparent)]
    Client(#[from] ClientError),
    #[error("a measuring process failed: {0}")]
    Child(String),
    #[error("a measuring process cannot be run: {0}")]
    Process(std::io::Error),
    #[error("a measuring process did not say what it measured: {0}")]
    Answer(#[from] serde_json::Error),
}
