//! Builds the copy.

use crate::choice::Mutant;
use crate::error::MutantsError;
use crate::rewrite::Rewritten;
use crate::tree::plant;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

/// How often mistakes that do not compile are taken out: errors of types come before those of lifetimes, crate by crate.
const ROUNDS: usize = 16;

/// What was built.
#[derive(Debug)]
pub struct Built {
    /// The program that runs checks.
    pub runner: PathBuf,
    /// The mistakes that compile.
    pub mutants: Vec<Mutant>,
}

/// Plants the mistakes and builds the copy in `copy_root`.
/// Calls `say` with a line of progress for each step.
///
/// # Errors
/// When the copy does not build without mistakes either.
pub fn build(
    root: &Path,
    copy_root: &Path,
    mut mutants: Vec<Mutant>,
    say: &dyn Fn(String),
) -> Result<Built, MutantsError> {
    let cargo = std::env::var_os("CARGO").map_or_else(|| PathBuf::from("cargo"), PathBuf::from);
    let target = copy_root.join("target");
    for _ in 0..ROUNDS {
        let rewritten = plant(root, copy_root, &mutants.iter().collect::<Vec<_>>())?;
        say(format!("building a copy with {} mistakes", mutants.len()));
        let output = Command::new(&cargo)
            .args(["build", "--release", "--offline", "--package", "mutant_runner"])
            .args(["--message-format", "json"])
            .current_dir(copy_root)
            .env("CARGO_TARGET_DIR", &target)
            .env("CARGO_INCREMENTAL", "0")
            // What a mistake makes a lint forbid, as a sum that overflows, is a mistake all the same.
            .env("RUSTFLAGS", "--cap-lints=allow")
            .output()
            .map_err(|source| MutantsError::Start { program: cargo.clone(), source })?;
        if output.status.success() {
            return Ok(Built { runner: target.join("release/mutant_runner"), mutants });
        }
        let messages = String::from_utf8_lossy(&output.stdout);
        let bad = rejected(&messages, &rewritten);
        if bad.is_empty() {
            let mut text = rendered(&messages);
            text += &String::from_utf8_lossy(&output.stderr);
            return Err(MutantsError::Build(text));
        }
        say(format!("{} mistakes do not compile", bad.len()));
        mutants.retain(|mutant| !bad.contains(&mutant.number));
    }
    Err(MutantsError::Build(format!("mistakes do not compile after {ROUNDS} rounds")))
}

/// The compiler's errors.
fn errors(messages: &str) -> impl Iterator<Item = Value> {
    let lines = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    lines.filter(|line| line["reason"] == "compiler-message" && line["message"]["level"] == "error")
}

fn rendered(messages: &str) -> String {
    errors(messages)
        .filter_map(|error| error["message"]["rendered"].as_str().map(str::to_owned))
        .collect()
}

/// The mistakes that errors point at.
fn rejected(messages: &str, rewritten: &BTreeMap<String, Rewritten>) -> BTreeSet<u32> {
    let mut bad = BTreeSet::new();
    for error in errors(messages) {
        for span in error["message"]["spans"].as_array().into_iter().flatten() {
            let file = span["file_name"].as_str().and_then(|file| rewritten.get(file));
            let byte = |name: &str| span[name].as_u64().and_then(|byte| usize::try_from(byte).ok());
            if let (Some(file), Some(start), Some(end)) =
                (file, byte("byte_start"), byte("byte_end"))
            {
                bad.extend(file.at(&(start..end)));
            }
        }
    }
    bad
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_blames_the_mistake_that_it_points_at() {
        let parts = vec![(10..50, vec![1]), (20..30, vec![2])];
        let file = Rewritten { text: " ".repeat(60), parts };
        let files = BTreeMap::from([("a/src/lib.rs".to_owned(), file)]);
        let message = |start: u32| {
            format!(
                r#"{{"reason":"compiler-message","message":{{"level":"error","rendered":"no","spans":[{{"file_name":"a/src/lib.rs","byte_start":{start},"byte_end":{}}}]}}}}"#,
                start + 2
            )
        };
        assert_eq!(rejected(&message(22), &files), BTreeSet::from([2]));
        assert_eq!(rejected(&message(40), &files), BTreeSet::from([1]));
        assert_eq!(rejected(&message(55), &files), BTreeSet::new());
        assert_eq!(rendered(&message(1)), "no");
    }
}
