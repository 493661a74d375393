//! Programs that know nothing of DetGL, run by `detgl run`: C with the system's headers, PyOpenGL,
//! MuJoCo, what others draw with. Where a client is not installed, its test says so and passes.
//!
//! `DETGL_PYTHON` names the Python to use, `python3` if it is not set. Elsewhere than where `detgl run` stands in for
//! the system's libraries, there is nothing to test.
#![cfg(all(unix, not(target_vendor = "apple")))]

mod c;
mod deb;
mod demon;
mod doctor;
mod frameworks;
mod picture;
mod python;
mod tarball;
mod wheel;

use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output};

/// Says that a test had nothing to do. Not captured, as what a passing test prints is.
fn skip(test: &str, why: &str) {
    let why = why.trim().lines().last().unwrap_or_default();
    let mut out = std::io::stderr().lock();
    writeln!(out, "skipped: {test}: {why}").expect("standard error is open");
}

/// A script or source of this folder.
fn source(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "tests", "clients", name].iter().collect()
}

/// A folder of a test's own, empty.
fn folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("clients").join(test);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).expect("an earlier run's folder can be removed");
    }
    std::fs::create_dir_all(&folder).expect("the target folder is writable");
    folder
}

/// The program that stands in for the system's libraries.
fn detgl() -> Command {
    Command::new(env!("CARGO_BIN_EXE_detgl"))
}

/// Runs to the end; what was printed, and whether all went well.
fn run(command: &mut Command) -> Result<Output, String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    if output.status.success() {
        return Ok(output);
    }
    let said = [output.stdout, output.stderr].concat();
    Err(format!("{command:?}: {}\n{}", output.status, String::from_utf8_lossy(&said)))
}

/// What `DETGL_PYTHON` names.
fn python_program() -> OsString {
    std::env::var_os("DETGL_PYTHON").unwrap_or_else(|| "python3".into())
}

#[test]
fn help_has_examples() {
    let output = run(detgl().arg("--help")).expect("it prints");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    for example in ["detgl run -- python3 draw.py", "DETGL_DEBUG=1 detgl run", "detgl install"] {
        assert!(text.contains(example), "{text}");
    }
}
