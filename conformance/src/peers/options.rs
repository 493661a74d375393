//! The options of `conformance peers`.

use std::path::PathBuf;

/// What can be chosen.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    /// How often every driver draws every scene, in turns.
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub rounds: u16,
    /// Pixels across and up.
    #[arg(long, default_value_t = 1024, value_parser = clap::value_parser!(u16).range(16..=4096))]
    pub size: u16,
    /// DetGL's shared library; without it, the one that was built beside this program.
    #[arg(long, value_name = "PATH")]
    pub lib: Option<PathBuf>,
}
