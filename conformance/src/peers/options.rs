//! The options of `conformance peers`.

use std::path::PathBuf;

/// What can be chosen.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    /// How often every driver draws every scene, in turns.
    #[arg(long, default_value_t = 5, allow_negative_numbers = true, value_parser = number::<1, 1000>)]
    pub rounds: u16,
    /// Pixels across and up.
    #[arg(long, default_value_t = 1024, allow_negative_numbers = true, value_parser = number::<16, 4096>)]
    pub size: u16,
    /// DetGL's shared library; without it, the one that was built beside this program.
    #[arg(long, value_name = "PATH", value_parser = library)]
    pub lib: Option<PathBuf>,
}

fn number<const LEAST: u16, const MOST: u16>(text: &str) -> Result<u16, String> {
    let number = text.parse().ok().filter(|number| (LEAST..=MOST).contains(number));
    number.ok_or_else(|| format!("a whole number from {LEAST} to {MOST} is needed"))
}

fn library(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    if path.is_file() { Ok(path) } else { Err("no file has this name".to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_say_what_is_accepted() {
        assert_eq!(number::<16, 4096>("16"), Ok(16));
        for wrong in ["abc", "-1", "15", "4097", ""] {
            let said = number::<16, 4096>(wrong);
            assert_eq!(said, Err("a whole number from 16 to 4096 is needed".to_owned()), "{wrong}");
        }
    }
}
