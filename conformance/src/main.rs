//! `cargo run --release -p conformance`: checks DetGL against the formulas of the specification.

use clap::Parser;
use conformance::check::{Bench, Check, Effort, Outcome, Subject, Verdict, checks};
use conformance::mutation::Variant;
use conformance::report;
use std::process::ExitCode;

/// Checks DetGL against independent f64 formulas of the specification. The exit status is 0 when
/// every check passes, 1 when one fails, 2 for a wrong argument.
#[derive(Debug, Parser)]
#[command(name = "conformance", version)]
struct Args {
    /// Only checks whose name or citation contains this.
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// A JSON array instead of the table.
    #[arg(long)]
    json: bool,
    /// A sixteenth of the cases.
    #[arg(long)]
    quick: bool,
}

fn main() -> ExitCode {
    let args = Args::parse();
    let wanted = |check: &&Check| {
        let text = args.only.as_deref().unwrap_or_default();
        check.name.contains(text) || check.citation.contains(text)
    };
    let wanted: Vec<&Check> = checks().filter(wanted).collect();
    if wanted.is_empty() {
        let names: Vec<&str> = checks().map(|check| check.name).collect();
        eprintln!("no check has that in its name or citation; the names are {}", names.join(", "));
        return ExitCode::from(2);
    }
    let bench = Bench {
        subject: Subject::Driver,
        effort: if args.quick { Effort::Quick } else { Effort::Full },
        variant: Variant::TRUE,
    };
    let outcomes: Vec<Outcome> = wanted.iter().map(|check| check.run(&bench)).collect();
    if args.json {
        match report::json(&outcomes) {
            Ok(text) => println!("{text}"),
            Err(error) => {
                eprintln!("{error}");
                return ExitCode::FAILURE;
            }
        }
    } else {
        println!("{}", report::table(&outcomes));
    }
    if outcomes.iter().all(|outcome| outcome.verdict == Verdict::Pass) {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
