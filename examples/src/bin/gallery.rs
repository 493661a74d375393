//! `cargo run --release`: draws every lecture picture into `gallery/`.

use examples::arguments::parsed;
use examples::gallery::{Arguments, run};
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Arguments = match parsed() {
        Ok(arguments) => arguments,
        Err(status) => return status,
    };
    match run(&arguments) {
        Ok(status) => status,
        Err(error) => {
            eprintln!("gallery: {error}");
            ExitCode::FAILURE
        }
    }
}
