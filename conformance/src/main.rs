//! `cargo run --release -p conformance`: checks DetGL against the formulas of the specification,
//! shows that the checks can fail, and measures error against run time and at the extremes.

mod failure;
mod sections;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use conformance::check::Effort;
use conformance::judge;
use conformance::peers;
use conformance::peers::process::Task;
use conformance::report;
use conformance::report::{Count, Layout, Machine, PageName, closing, listed};
use failure::{Failure, finish, wrong};
use serde::Serialize;
use std::cell::RefCell;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

/// Checks DetGL against independent f64 formulas of the specification. The exit status is 0 when
/// everything passes, 1 when something fails, 2 for a wrong argument.
#[derive(Debug, Parser)]
#[command(name = "conformance", version, after_help = EXAMPLES)]
struct Args {
    /// Something else than the formulas.
    #[command(subcommand)]
    command: Option<Command>,
    /// Only what has this in its name, citation or description: checks, mistakes, scenes and functions,
    /// sweeps, features. Pages of a part have names of their own.
    #[arg(long, value_name = "TEXT", global = true)]
    only: Option<String>,
    /// JSON instead of tables and pages; of all, one object with a name for each subcommand.
    #[arg(long, global = true)]
    json: bool,
    /// Tables as wide as they are, instead of 100 columns.
    #[arg(long, global = true)]
    wide: bool,
    /// Judges another GL beside DetGL, through its C functions: system, llvmpipe, softpipe, or the path of a libEGL. May
    /// be given several times. With `left-out` after it: times of this GL beside DetGL's.
    #[arg(long, value_name = "DRIVER")]
    driver: Vec<String>,
    /// A sixteenth of the cases, or smaller pictures.
    #[arg(long, global = true, conflicts_with = "full")]
    quick: bool,
    /// Sixteen times the cases, or larger pictures.
    #[arg(long, global = true)]
    full: bool,
    /// Where the pages are written.
    #[arg(long, value_name = "DIR", global = true, default_value = "conformance-report",
          value_parser = folder)]
    out: PathBuf,
    /// What `all` has found as JSON: one object for all of it.
    #[arg(skip)]
    found: RefCell<serde_json::Map<String, serde_json::Value>>,
}

const EXAMPLES: &str = "Examples:
  conformance                        every formula, and conformance-report/index.html
  conformance --only bilinear        the checks that have this in their name or citation
  conformance extremes --only fog    sweeps with this in their name or parameter
  conformance --driver llvmpipe      the same checks of another GL, and conformance-report/drivers.md
  conformance all --quick            everything but peers, with few cases
  conformance error-vs-time --wide   a table as wide as it is";

/// A folder, or what does not exist yet.
fn folder(text: &str) -> Result<PathBuf, String> {
    const NEEDED: &str = "a folder is needed, or a name that is free";
    let path = PathBuf::from(text);
    if text.is_empty() {
        return Err(NEEDED.to_owned());
    }
    match path.ancestors().find(|part| part.exists()) {
        Some(part) if !part.is_dir() => Err(format!("{} is a file; {NEEDED}", part.display())),
        Some(_) | None => Ok(path),
    }
}

/// What else there is.
#[derive(Clone, Debug, Subcommand)]
enum Command {
    /// Everything below but peers, one after the other.
    All,
    /// Builds each known mistake into its formula, one at a time: every one must be noticed.
    SelfTest,
    /// Error and time of every way to sample, and of the other choices: mipmaps, formats, edges, shadows, …
    ErrorVsTime,
    /// Sweeps to where arithmetic breaks, with bounds on the error.
    Extremes,
    /// What scenes ask for without effect: what the plan leaves out, and what it costs.
    LeftOut,
    /// The same scenes on DetGL's shared library and on the machine's other GL drivers.
    Peers(peers::Options),
    /// One scene on one driver: the process that `peers` measures.
    #[command(hide = true)]
    Peer(Task),
    /// One check of one library: the process that `--driver` asks.
    #[command(hide = true)]
    Judged(judge::Task),
}

/// A section of what this program reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ReportSection {
    Formulas,
    SelfTest,
    ErrorVsTime,
    Extremes,
    LeftOut,
    Peers,
}

impl ReportSection {
    /// Its name in the JSON of all.
    fn key(self) -> &'static str {
        match self {
            Self::Formulas => "formulas",
            Self::SelfTest => "self-test",
            Self::ErrorVsTime => "error-vs-time",
            Self::Extremes => "extremes",
            Self::LeftOut => "left-out",
            Self::Peers => "peers",
        }
    }
}

/// What a command counts.
type Counted = Result<Vec<Count>, Failure>;

fn main() -> ExitCode {
    let args = match Args::try_parse() {
        Ok(args) => args,
        Err(error) => return wrong(&error),
    };
    let start = Instant::now();
    let refused = match &args.command {
        _ if args.driver.is_empty() => None,
        None => args.json.then_some("--driver writes a page; --json is not for it"),
        Some(Command::LeftOut) => None,
        Some(
            Command::All
            | Command::SelfTest
            | Command::ErrorVsTime
            | Command::Extremes
            | Command::Peers(_)
            | Command::Peer(_)
            | Command::Judged(_),
        ) => Some("--driver goes with the formulas and with left-out, and no other subcommand"),
    };
    if let Some(text) = refused {
        return wrong(&Args::command().error(ErrorKind::ArgumentConflict, text));
    }
    let counted = match &args.command {
        None if !args.driver.is_empty() => args.judge(),
        None => args.formulas(),
        Some(Command::All) => args.all(),
        Some(Command::SelfTest) => args.self_test(),
        Some(Command::ErrorVsTime) => args.error_vs_time(),
        Some(Command::Extremes) => args.extremes(),
        Some(Command::LeftOut) => args.left_out_beside_others(),
        Some(Command::Peers(options)) => args.peers(options),
        Some(Command::Peer(task)) => return finish(task.run().map_err(Failure::from), |()| true),
        Some(Command::Judged(task)) => return finish(task.run().map_err(Failure::from), |()| true),
    };
    if let (Ok(counts), false) = (&counted, args.json) {
        println!("\n{}", closing(counts, start.elapsed().as_secs_f64(), &Machine::here()));
    }
    finish(counted, |counts| counts.iter().all(|count| count.passed == count.all))
}

impl Args {
    fn effort(&self) -> Effort {
        match (self.quick, self.full) {
            (true, _) => Effort::Quick,
            (false, true) => Effort::Thorough,
            (false, false) => Effort::Full,
        }
    }

    fn layout(&self) -> Layout {
        if self.wide { Layout::Wide } else { Layout::Narrow }
    }

    /// The name of a page about what `--only` selects.
    fn page(&self, subject: &str) -> PageName {
        PageName::new(subject, self.only.as_deref())
    }

    /// Whether one of the texts contains the argument of `--only`.
    fn is_selected(&self, texts: &[&str]) -> bool {
        let text = self.only.as_deref().unwrap_or_default();
        texts.iter().any(|t| t.contains(text))
    }

    fn no_match(&self, mut names: Vec<&str>) -> Failure {
        names.dedup();
        Failure::NoMatch(self.only.clone().unwrap_or_default(), listed(&names))
    }

    /// The items of `all` one of whose texts contains the argument of `--only`.
    fn selected<'a, T>(
        &self,
        all: impl Iterator<Item = &'a T> + Clone,
        texts: impl Fn(&T) -> [&'static str; 2],
    ) -> Result<Vec<&'a T>, Failure> {
        let selected: Vec<&T> = all.clone().filter(|item| self.is_selected(&texts(item))).collect();
        if selected.is_empty() {
            return Err(self.no_match(all.map(|item| texts(item)[0]).collect()));
        }
        Ok(selected)
    }

    /// Prints a table, or JSON; the JSON of a part of `all` is kept.
    fn print(
        &self,
        part: ReportSection,
        table: impl FnOnce() -> String,
        found: &impl Serialize,
    ) -> Result<(), Failure> {
        match (&self.command, self.json) {
            (_, false) => println!("{}", table()),
            (Some(Command::All), true) => {
                let found = serde_json::to_value(found)?;
                self.found.borrow_mut().insert(part.key().to_owned(), found);
            }
            (_, true) => println!("{}", report::json(found)?),
        }
        Ok(())
    }

    /// Prints the path of a page.
    fn print_path(&self, page: &PageName) {
        println!("{}", self.out.join(page.file()).display());
    }

    /// Warns where `noisy` of `of` times are not to be relied on.
    fn warn(&self, noisy: usize, of: usize) {
        if let Some(warning) = Machine::here().warnings(noisy, of) {
            eprintln!("{warning}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(arguments: &[&str]) -> String {
        let all = ["conformance"].iter().chain(arguments);
        Args::try_parse_from(all).expect_err("a wrong argument").to_string()
    }

    #[test]
    fn wrong_arguments_name_value_and_what_is_needed() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
        let below = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml/pages");
        let table: [(&[&str], [&str; 3]); 7] = [
            (&["--out", file], ["Cargo.toml'", "--out", "a folder is needed"]),
            (&["extremes", "--out", below], ["pages'", "--out", "is a file"]),
            (&["--out", ""], ["''", "--out", "a folder is needed"]),
            (&["peers", "--size", "abc"], ["'abc'", "--size", "16 to 4096"]),
            (&["peers", "--size", "-1"], ["'-1'", "--size", "16 to 4096"]),
            (&["peers", "--rounds", "0"], ["'0'", "--rounds", "1 to 1000"]),
            (&["peers", "--lib", "/nothing"], ["'/nothing'", "--lib", "no file"]),
        ];
        for (arguments, parts) in table {
            let text = refused(arguments);
            assert!(parts.iter().all(|part| text.contains(part)), "{parts:?}: {text}");
        }
    }
}
