//! Why the program fails, and its exit status.

use conformance::judge::JudgeError;
use conformance::peers::{self, PeersError};
use conformance::report::PageError;
use std::process::ExitCode;

/// The exit status for a wrong argument.
const WRONG_ARGUMENT: u8 = 2;

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
                Failure::NoMatch(..) | Failure::Judge(_) => ExitCode::from(WRONG_ARGUMENT),
                Failure::Drive(_)
                | Failure::Page(_)
                | Failure::Write(_)
                | Failure::Peers(_)
                | Failure::PeersReport(_)
                | Failure::Json(_) => ExitCode::FAILURE,
            }
        }
    }
}

/// The exit status where the command line says nothing to do; what is wrong is printed in one line.
pub fn wrong(error: &clap::Error) -> ExitCode {
    if error.use_stderr() {
        eprintln!("{}", one_line(&error.to_string()));
        return ExitCode::from(WRONG_ARGUMENT);
    }
    match error.print() {
        Ok(()) => ExitCode::SUCCESS,
        Err(_) => ExitCode::FAILURE,
    }
}

/// What clap says is wrong, without how to get help.
fn one_line(message: &str) -> String {
    let about = message.split("\n\nUsage:").next().unwrap_or(message);
    let about = about.split("\n\nFor more information").next().unwrap_or(about);
    about.split_whitespace().collect::<Vec<_>>().join(" ")
}
