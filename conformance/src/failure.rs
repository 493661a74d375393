//! Why the program fails, and its exit status.

use conformance::judge::JudgeError;
use conformance::peers::{self, PeersError};
use conformance::report::PageError;
use std::process::ExitCode;

/// Why the program fails.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    #[error("--only {0:?}: nothing has this in its name; the names are\n{1}")]
    NoMatch(String, String),
    #[error(transparent)]
    Drive(#[from] conformance::probe::ProbeError),
    #[error(transparent)]
    Page(#[from] PageError),
    #[error(transparent)]
    Peers(#[from] PeersError),
    #[error(transparent)]
    PeersReport(#[from] peers::WriteError),
    #[error(transparent)]
    Judge(#[from] JudgeError),
    #[error(transparent)]
    Write(#[from] std::io::Error),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

/// The exit status; what went wrong is printed.
pub fn finish<T>(result: Result<T, Failure>, passes: impl FnOnce(T) -> bool) -> ExitCode {
    match result {
        Ok(found) => {
            if passes(found) {
                ExitCode::SUCCESS
            } else {
                ExitCode::FAILURE
            }
        }
        Err(failure) => {
            eprintln!("{failure}");
            match failure {
                Failure::NoMatch(..) => ExitCode::from(2),
                Failure::Drive(_)
                | Failure::Page(_)
                | Failure::Judge(_)
                | Failure::Write(_)
                | Failure::Peers(_)
                | Failure::PeersReport(_)
                | Failure::Json(_) => ExitCode::FAILURE,
            }
        }
    }
}
