//! The command lines of the gallery and of single programs: an argument that is wrong is one line, and
//! exit status 2.

use crate::picture::{self, Picture};
use clap::Parser;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// The exit status for a wrong argument.
pub const WRONG_ARGUMENT: u8 = 2;

/// The arguments of the command line; else the exit status, with what is wrong printed in one line.
///
/// # Errors
/// When an argument is wrong, or asks for help, which is printed.
pub fn parsed<T: Parser>() -> Result<T, ExitCode> {
    T::try_parse().map_err(|error| {
        if error.use_stderr() {
            eprintln!("{}", one_line(&error.to_string()));
            return ExitCode::from(WRONG_ARGUMENT);
        }
        match error.print() {
            Ok(()) => ExitCode::SUCCESS,
            Err(_) => ExitCode::FAILURE,
        }
    })
}

/// What clap says is wrong, without how to get help.
fn one_line(message: &str) -> String {
    let about = message.split("\n\nUsage:").next().unwrap_or(message);
    let about = about.split("\n\nFor more information").next().unwrap_or(about);
    about.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The side of a picture in pixels, from 2 to `LARGEST`.
///
/// # Errors
/// When it is none.
pub fn side<const LARGEST: u32>(text: &str) -> Result<u32, String> {
    let side = text.parse().ok().filter(|side| (2..=LARGEST).contains(side));
    side.ok_or_else(|| format!("it must be a whole number from 2 to {LARGEST}, such as 512"))
}

/// A folder, or a name that nothing has.
///
/// # Errors
/// When a file has this name.
pub fn folder(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    match path.ancestors().find(|part| part.exists()) {
        Some(part) if !part.is_dir() => Err(format!(
            "{} is a file; it must be a folder, or a name that is free",
            part.display()
        )),
        Some(_) | None => Ok(path),
    }
}

/// The picture in a file.
///
/// # Errors
/// When it cannot be read or is no picture.
pub fn picture_file(text: &str) -> Result<Picture, String> {
    const ACCEPTED: &str = "it must be a PPM, PNG or JPEG file of at least one pixel";
    match picture::load(Path::new(text)) {
        Ok(Picture { pixels, .. }) if pixels.is_empty() => Err(ACCEPTED.to_owned()),
        Ok(picture) => Ok(picture),
        Err(error) => Err(format!("{ACCEPTED} ({error})")),
    }
}

/// What to say of an `--image` that none of these programs reads.
pub fn takes_no_picture(names: &[&str]) -> String {
    format!("error: invalid argument '--image': {} reads no picture file", names.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gallery::Arguments;

    fn refused(arguments: &[&str]) -> String {
        let all = ["gallery"].iter().chain(arguments);
        one_line(&Arguments::try_parse_from(all).expect_err("a wrong argument").to_string())
    }

    #[test]
    fn wrong_arguments_are_one_line() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
        let below = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml/pictures");
        let table: [(&[&str], [&str; 3]); 6] = [
            (&["--size", "abc"], ["'abc'", "--size", "2 to 4096"]),
            (&["--size", "-1"], ["'-1'", "--size", "2 to 4096"]),
            (&["--out", file], ["Cargo.toml'", "--out", "must be a folder"]),
            (&["--out", below], ["Cargo.toml/pictures'", "--out", "is a file"]),
            (&["--image", file], ["Cargo.toml'", "--image", "PPM, PNG or JPEG"]),
            (&["--only", "nothing"], ["'nothing'", "--only", "textured_square"]),
        ];
        for (arguments, parts) in table {
            let line = refused(arguments);
            assert!(!line.contains('\n'), "{line}");
            assert!(parts.iter().all(|part| line.contains(part)), "{parts:?}: {line}");
        }
    }
}
