//! `cargo run --release -p conformance`: checks DetGL against the formulas of the specification,
//! shows that the checks can fail, and measures error against run time and at the extremes.

mod failure;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use conformance::chapters::checks;
use conformance::check::{Check, Effort, Harness, Outcome, Subject, Verdict};
use conformance::judge::{self, Driver};
use conformance::left_out::{self, Feature};
use conformance::mutation::{MUTATIONS, MutationRow, Variant};
use conformance::peers;
use conformance::peers::process::Task;
use conformance::report::{Count, Layout, Machine, NOISY, PageName, bar, closing, listed};
use conformance::sweep::{SWEEPS, Sweep, SweepOutcome};
use conformance::tradeoff::choices::{CHOICES, Choice, ChoiceOutcome};
use conformance::tradeoff::{self, Scene, functions};
use conformance::{filter_pictures, report, self_test};
use failure::{Failure, finish, wrong};
use indicatif::ProgressBar;
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

/// The JSON of `error-vs-time`.
#[derive(Serialize)]
struct Tradeoff<'a> {
    scenes: &'a [tradeoff::Row],
    choices: &'a [ChoiceOutcome],
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

    /// Everything; what `--only` selects nothing of is left out.
    fn all(&self) -> Counted {
        let parts: [fn(&Self) -> Counted; 5] =
            [Self::formulas, Self::self_test, Self::error_vs_time, Self::extremes, Self::left_out];
        let mut counts = Vec::new();
        let mut names = Vec::new();
        for part in parts {
            match part(self) {
                Ok(of) => counts.extend(of),
                Err(Failure::NoMatch(_, of)) => names.push(of),
                Err(failure) => return Err(failure),
            }
        }
        if counts.is_empty() {
            return Err(Failure::NoMatch(self.only.clone().unwrap_or_default(), names.join(",\n")));
        }
        if self.json {
            println!("{}", report::json(&*self.found.borrow())?);
        }
        Ok(counts)
    }

    fn formulas(&self) -> Counted {
        let selected = self.selected(checks(), |check: &Check| [check.name, check.citation])?;
        let harness =
            Harness { subject: Subject::Driver, effort: self.effort(), variant: Variant::CORRECT };
        let bar = bar(selected.len());
        let outcomes: Vec<Outcome> = selected
            .iter()
            .map(|check| {
                bar.set_message(check.name);
                let outcome = check.run(&harness);
                bar.inc(1);
                outcome
            })
            .collect();
        bar.finish_and_clear();
        self.print(ReportSection::Formulas, || report::table(self.layout(), &outcomes), &outcomes)?;
        if !self.json {
            let pictures =
                if self.only.is_none() { filter_pictures::pictures()? } else { Vec::new() };
            let page = self.page("index");
            report::checks_page(&self.out, &page, &outcomes, &pictures)?;
            self.print_path(&page);
        }
        let passes = |outcome: &Outcome| outcome.verdict == Verdict::Pass;
        Ok(vec![Count::of(&outcomes, "checks pass", passes)])
    }

    /// The checks by DetGL and by other libraries.
    fn judge(&self) -> Counted {
        let selected = self.selected(checks(), |check: &Check| [check.name, check.citation])?;
        let drivers = self.driver.iter().map(|name| Driver::open(name));
        let drivers = drivers.collect::<Result<Vec<_>, _>>()?;
        let bar = bar(selected.len());
        let rows: Vec<judge::Row> = selected
            .iter()
            .map(|check| {
                bar.set_message(check.name);
                let row = judge::judge(check, self.effort(), &drivers);
                bar.inc(1);
                row
            })
            .collect();
        bar.finish_and_clear();
        let (summary, table) = (judge::summary(&rows, &drivers), judge::page(&rows, &drivers));
        println!("{summary}\n{table}");
        std::fs::create_dir_all(&self.out)?;
        let path = self.out.join("drivers.md");
        std::fs::write(&path, format!("{summary}\n{table}"))?;
        println!("{}", path.display());
        let own = rows.iter().filter(|row| row.own.verdict == Verdict::Pass).count();
        Ok(vec![Count { passed: own, all: rows.len(), what: "checks of DetGL pass" }])
    }

    fn self_test(&self) -> Counted {
        let rows = self.selected(MUTATIONS.iter(), |row: &MutationRow| [row.check, row.what])?;
        let bar = bar(rows.len());
        let trials = self_test::run_with(Subject::Driver, &rows, &|| bar.inc(1));
        bar.finish_and_clear();
        self.print(
            ReportSection::SelfTest,
            || report::trials_table(self.layout(), &trials),
            &trials,
        )?;
        if !self.json {
            let page = self.page("self-test");
            report::trials_page(&self.out, &page, &trials)?;
            self.print_path(&page);
        }
        Ok(vec![Count::of(&trials, "mistakes noticed", |trial| trial.noticed)])
    }

    fn error_vs_time(&self) -> Counted {
        let side = match self.effort() {
            Effort::Quick => 96,
            Effort::Full => 256,
            Effort::Thorough => 512,
        };
        let scenes = tradeoff::scenes(side);
        let chosen: Vec<&Scene> =
            scenes.iter().filter(|scene| self.is_selected(&[scene.name, scene.what])).collect();
        let calls: Vec<&str> =
            functions::names().filter(|name| self.is_selected(&[name])).collect();
        let choices: Vec<&Choice> =
            CHOICES.iter().filter(|choice| self.is_selected(&[choice.name, choice.what])).collect();
        if chosen.is_empty() && choices.is_empty() && calls.is_empty() {
            let names = scenes.iter().map(|scene| scene.name);
            let names = names.chain(CHOICES.iter().map(|choice| choice.name));
            let names = names.chain(functions::names());
            return Err(self.no_match(names.collect()));
        }
        let bar = bar(chosen.len() + choices.len() + 1);
        let measured = tradeoff::measure(side, chosen, |scene| {
            bar.set_message(scene.name);
            bar.inc(1);
        })?;
        let mut chosen = Vec::with_capacity(choices.len());
        for choice in choices {
            bar.set_message(choice.name);
            chosen.push(choice.measure(side / 2)?);
            bar.inc(1);
        }
        bar.set_message("functions");
        let functions = functions::measure(&calls)?;
        bar.finish_and_clear();
        let table = || {
            let all = tradeoff::overall(&measured.rows);
            let rows = [measured.rows.clone(), all].concat();
            let layout = self.layout();
            let tables = [
                (!measured.rows.is_empty()).then(|| report::tradeoff_table(layout, &rows)),
                (!chosen.is_empty()).then(|| report::choices_table(layout, &chosen)),
                (!functions.is_empty()).then(|| report::functions_table(layout, &functions)),
            ];
            tables.into_iter().flatten().collect::<Vec<_>>().join("\n")
        };
        self.print(
            ReportSection::ErrorVsTime,
            table,
            &Tradeoff { scenes: &measured.rows, choices: &chosen, functions: &functions },
        )?;
        if !self.json {
            let page = self.page("error-vs-time");
            report::tradeoff_page(&self.out, &page, &measured, &chosen, &functions)?;
            self.print_path(&page);
        }
        let noisy = measured.rows.iter().filter(|row| row.spread() > NOISY).count();
        let noisy = noisy + chosen.iter().filter(|choice| choice.spread() > NOISY).count();
        self.warn(noisy, measured.rows.len() + chosen.len());
        let of_choices: usize = chosen.iter().map(|choice| choice.rows.len()).sum();
        let all = measured.rows.len() + of_choices + functions.len();
        Ok(vec![Count { passed: all, all, what: "times measured" }])
    }

    fn extremes(&self) -> Counted {
        let selected =
            self.selected(SWEEPS.iter(), |sweep: &Sweep| [sweep.name, sweep.parameter])?;
        let bar = bar(selected.len());
        let swept: Vec<SweepOutcome> = selected
            .iter()
            .map(|sweep| {
                bar.set_message(sweep.name);
                let outcome = sweep.run();
                bar.inc(1);
                outcome
            })
            .collect();
        bar.finish_and_clear();
        self.print(
            ReportSection::Extremes,
            || report::sweeps_table(self.layout(), &swept),
            &swept,
        )?;
        if !self.json {
            let page = self.page("extremes");
            report::sweeps_page(&self.out, &page, &swept)?;
            self.print_path(&page);
        }
        Ok(vec![Count::of(&swept, "sweeps pass", SweepOutcome::passes)])
    }

    /// The features of `left-out`, timed in other libraries, too: those of `--driver`, or llvmpipe where it is installed.
    fn left_out_beside_others(&self) -> Counted {
        let drivers = match &self.driver[..] {
            [] => Vec::from_iter(Driver::open("llvmpipe").ok()),
            names => names.iter().map(|name| Driver::open(name)).collect::<Result<_, _>>()?,
        };
        self.left_out_beside(&drivers)
    }

    fn left_out(&self) -> Counted {
        self.left_out_beside(&[])
    }

    fn left_out_beside(&self, drivers: &[Driver]) -> Counted {
        let selected =
            self.selected(left_out::features(), |feature: &Feature| [feature.name, feature.what])?;
        let rounds = match self.effort() {
            Effort::Quick => 3,
            Effort::Full => 9,
            Effort::Thorough => 28,
        };
        let bar = bar(selected.len());
        let mut rows = Vec::with_capacity(selected.len());
        for feature in selected {
            bar.set_message(feature.name);
            let row = left_out::measure(feature, rounds)?;
            let peers =
                drivers.iter().map(|driver| driver.time(feature.name, rounds.min(3))).collect();
            rows.push(left_out::Row { peers, ..row });
            bar.inc(1);
        }
        bar.finish_and_clear();
        let names: Vec<&str> = drivers.iter().map(|driver| driver.name.as_str()).collect();
        self.print(
            ReportSection::LeftOut,
            || report::left_out_table(self.layout(), &rows, &names),
            &rows,
        )?;
        if !self.json {
            let page = self.page("left-out");
            report::left_out_page(&self.out, &page, &rows, &names)?;
            self.print_path(&page);
        }
        self.warn(rows.iter().filter(|row| row.timing.noise > NOISY).count(), rows.len());
        Ok(vec![Count::of(&rows, "features pass", left_out::Row::passes)])
    }

    fn peers(&self, options: &peers::Options) -> Counted {
        let only = self.only.as_deref().unwrap_or_default();
        let scenes = peers::selected(only);
        if scenes.is_empty() {
            return Err(self.no_match(peers::names()));
        }
        let bar = ProgressBar::new_spinner();
        let comparison = peers::compare(options, &scenes, |what| {
            bar.set_message(what.to_owned());
            bar.tick();
        })?;
        bar.finish_and_clear();
        self.print(ReportSection::Peers, || peers::table(self.layout(), &comparison), &comparison)?;
        if !self.json {
            let subject = self.page("peers");
            let name = subject.file().trim_end_matches(".html");
            peers::write(&self.out, name, &comparison)?;
            println!("{}", self.out.join(format!("{name}.md")).display());
        }
        Ok(vec![Count { passed: scenes.len(), all: scenes.len(), what: "scenes compared" }])
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
