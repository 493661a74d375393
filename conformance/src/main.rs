//! `cargo run --release -p conformance`: checks DetGL against the formulas of the specification,
//! shows that the checks can fail, and measures error against run time and at the extremes.

use clap::{Parser, Subcommand};
use conformance::chapters::checks;
use conformance::check::{Check, Effort, Harness, Outcome, Subject, Verdict};
use conformance::left_out::{self, Feature};
use conformance::mutation::{MUTATIONS, MutationRow, Variant};
use conformance::peers::process::Task;
use conformance::peers::{self, PeersError};
use conformance::report::page::PageError;
use conformance::sweep::{SWEEPS, Sweep, SweepOutcome};
use conformance::tradeoff::{self, functions};
use conformance::{filter_pictures, report, self_test};
use serde::Serialize;
use std::path::PathBuf;
use std::process::ExitCode;

/// Checks DetGL against independent f64 formulas of the specification. The exit status is 0 when
/// everything passes, 1 when something fails, 2 for a wrong argument.
#[derive(Debug, Parser)]
#[command(name = "conformance", version)]
struct Args {
    /// Something else than the formulas.
    #[command(subcommand)]
    command: Option<Command>,
    /// Only checks or sweeps whose name or citation contains this.
    #[arg(long, value_name = "TEXT", global = true)]
    only: Option<String>,
    /// JSON instead of tables and pages.
    #[arg(long, global = true)]
    json: bool,
    /// A sixteenth of the cases, or smaller pictures.
    #[arg(long, global = true, conflicts_with = "full")]
    quick: bool,
    /// Sixteen times the cases, or larger pictures.
    #[arg(long, global = true)]
    full: bool,
    /// Where the pages are written.
    #[arg(long, value_name = "DIR", global = true, default_value = "conformance-report")]
    out: PathBuf,
}

/// What else there is.
#[derive(Clone, Debug, Subcommand)]
enum Command {
    /// Builds each known mistake into its formula, one at a time: every one must be noticed.
    SelfTest,
    /// Error of every way to sample against the exact area integral, and what it takes.
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
}

/// Why the program fails.
#[derive(Debug, thiserror::Error)]
enum Failure {
    #[error("nothing has {0:?} in its name or citation; the names are {1}")]
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
    Json(#[from] serde_json::Error),
}

fn main() -> ExitCode {
    let args = Args::parse();
    let passed = match &args.command {
        None => args.formulas(),
        Some(Command::SelfTest) => args.self_test(),
        Some(Command::ErrorVsTime) => args.error_vs_time(),
        Some(Command::Extremes) => args.extremes(),
        Some(Command::LeftOut) => args.left_out(),
        Some(Command::Peers(options)) => args.peers(options),
        Some(Command::Peer(task)) => task.run().map(|()| true).map_err(Failure::from),
    };
    match passed {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(failure) => {
            eprintln!("{failure}");
            match failure {
                Failure::NoMatch(..) => ExitCode::from(2),
                Failure::Drive(_)
                | Failure::Page(_)
                | Failure::Peers(_)
                | Failure::PeersReport(_)
                | Failure::Json(_) => ExitCode::FAILURE,
            }
        }
    }
}

/// The JSON of `error-vs-time`.
#[derive(Serialize)]
struct Tradeoff<'a> {
    scenes: &'a [tradeoff::Row],
    functions: &'a [functions::FunctionRow],
}

impl Args {
    fn effort(&self) -> Effort {
        match (self.quick, self.full) {
            (true, _) => Effort::Quick,
            (false, true) => Effort::Thorough,
            (false, false) => Effort::Full,
        }
    }

    /// The items of `all` one of whose texts contains the argument of `--only`.
    fn selected<'a, T>(
        &self,
        all: impl Iterator<Item = &'a T> + Clone,
        texts: impl Fn(&T) -> [&'static str; 2],
    ) -> Result<Vec<&'a T>, Failure> {
        let text = self.only.as_deref().unwrap_or_default();
        let selected: Vec<&T> =
            all.clone().filter(|item| texts(item).iter().any(|t| t.contains(text))).collect();
        if selected.is_empty() {
            let mut names: Vec<&str> = all.map(|item| texts(item)[0]).collect();
            names.dedup();
            return Err(Failure::NoMatch(text.to_owned(), names.join(", ")));
        }
        Ok(selected)
    }

    /// Prints a table, or JSON.
    fn print(&self, table: impl FnOnce() -> String, found: &impl Serialize) -> Result<(), Failure> {
        let text = if self.json { report::json(found)? } else { table() };
        println!("{text}");
        Ok(())
    }

    /// Prints the path of a page.
    fn print_path(&self, page: &str) {
        println!("\n{}", self.out.join(page).display());
    }

    fn formulas(&self) -> Result<bool, Failure> {
        let selected = self.selected(checks(), |check: &Check| [check.name, check.citation])?;
        let harness =
            Harness { subject: Subject::Driver, effort: self.effort(), variant: Variant::CORRECT };
        let outcomes: Vec<Outcome> = selected.iter().map(|check| check.run(&harness)).collect();
        self.print(|| report::table(&outcomes), &outcomes)?;
        if !self.json {
            let pictures =
                if self.only.is_none() { filter_pictures::pictures()? } else { Vec::new() };
            report::checks_page(&self.out, &outcomes, &pictures)?;
            self.print_path("index.html");
        }
        Ok(outcomes.iter().all(|outcome| outcome.verdict == Verdict::Pass))
    }

    fn self_test(&self) -> Result<bool, Failure> {
        let rows = self.selected(MUTATIONS.iter(), |row: &MutationRow| [row.check, row.what])?;
        let trials = self_test::run(Subject::Driver, &rows);
        self.print(|| report::trials_table(&trials), &trials)?;
        Ok(trials.iter().all(|trial| trial.noticed))
    }

    fn error_vs_time(&self) -> Result<bool, Failure> {
        let side = match self.effort() {
            Effort::Quick => 96,
            Effort::Full => 256,
            Effort::Thorough => 512,
        };
        let bar = indicatif::ProgressBar::new(tradeoff::scenes(side).len() as u64);
        let measured = tradeoff::measure(side, |scene| {
            bar.set_message(scene.name);
            bar.inc(1);
        })?;
        bar.finish_and_clear();
        let functions = functions::measure()?;
        let table = || {
            let all = tradeoff::overall(&measured.rows);
            let rows = [measured.rows.clone(), all].concat();
            format!("{}\n{}", report::tradeoff_table(&rows), report::functions_table(&functions))
        };
        self.print(table, &Tradeoff { scenes: &measured.rows, functions: &functions })?;
        if !self.json {
            report::tradeoff_page(&self.out, &measured, &functions)?;
            self.print_path("error-vs-time.html");
        }
        Ok(true)
    }

    fn extremes(&self) -> Result<bool, Failure> {
        let selected =
            self.selected(SWEEPS.iter(), |sweep: &Sweep| [sweep.name, sweep.parameter])?;
        let swept: Vec<SweepOutcome> = selected.iter().map(|sweep| sweep.run()).collect();
        self.print(|| report::sweeps_table(&swept), &swept)?;
        if !self.json {
            report::sweeps_page(&self.out, &swept)?;
            self.print_path("extremes.html");
        }
        Ok(swept.iter().all(SweepOutcome::passes))
    }

    fn left_out(&self) -> Result<bool, Failure> {
        let selected =
            self.selected(left_out::features(), |feature: &Feature| [feature.name, feature.what])?;
        let rounds = match self.effort() {
            Effort::Quick => 3,
            Effort::Full => 9,
            Effort::Thorough => 28,
        };
        let bar = indicatif::ProgressBar::new(selected.len() as u64);
        let mut rows = Vec::with_capacity(selected.len());
        for feature in selected {
            bar.set_message(feature.name);
            rows.push(left_out::measure(feature, rounds)?);
            bar.inc(1);
        }
        bar.finish_and_clear();
        self.print(|| report::left_out_table(&rows), &rows)?;
        if !self.json {
            report::left_out_page(&self.out, &rows)?;
            self.print_path("left-out.html");
        }
        Ok(rows.iter().all(left_out::Row::passes))
    }

    fn peers(&self, options: &peers::Options) -> Result<bool, Failure> {
        let only = self.only.as_deref().unwrap_or_default();
        let scenes = peers::selected(only);
        if scenes.is_empty() {
            return Err(Failure::NoMatch(only.to_owned(), peers::names().join(", ")));
        }
        let bar = indicatif::ProgressBar::new_spinner();
        let comparison = peers::compare(options, &scenes, |what| {
            bar.set_message(what.to_owned());
            bar.tick();
        })?;
        bar.finish_and_clear();
        self.print(|| peers::table(&comparison), &comparison)?;
        if !self.json {
            peers::write(&self.out, &comparison)?;
            self.print_path("peers.md");
        }
        Ok(true)
    }
}
