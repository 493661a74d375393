//! `cargo run --release -p mutants`: plants mistakes in a copy of the driver's sources and says which of them no check
//! of conformance notices.

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use mutants::build::{Built, build};
use mutants::choice::{Mutant, choose};
use mutants::error::MutantsError;
use mutants::replacements::Replacement;
use mutants::report::{counts, listing, page, survivor_key, survivors};
use mutants::trial::{Effort, Fate, Trials, output_folder};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Plants mistakes in a copy of the driver's sources, all in one build, and runs the checks of conformance with each. The
/// exit status is 0 when at least the wanted share of those that change something is noticed, 1 when not, 2 for a wrong
/// argument.
#[derive(Debug, Parser)]
#[command(name = "mutants", version)]
struct Args {
    /// How many mistakes.
    #[arg(long, default_value_t = 1300)]
    count: usize,
    /// Which of all that are possible.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Only files whose path contains this.
    #[arg(long, default_value = "")]
    only: String,
    /// Tries only this many of what was planted, every nth, so that a build serves several runs.
    #[arg(long)]
    sample: Option<usize>,
    /// Tries only these, by number.
    #[arg(long, value_delimiter = ',')]
    numbers: Vec<u32>,
    /// Tries only those that survived by the listing (mutants.txt) of an earlier run.
    #[arg(long, value_name = "FILE")]
    survivors: Option<PathBuf>,
    /// Percent of the mistakes that change something which must be noticed.
    #[arg(long, default_value_t = 97.0)]
    least: f64,
    /// How many cases checks try.
    #[arg(long, value_enum, default_value_t = Effort::Quick)]
    effort: Effort,
    /// Processes at a time.
    #[arg(long, default_value_t = 2)]
    jobs: usize,
    /// Ends after so many minutes: what was tried by then is a random part.
    #[arg(long)]
    minutes: Option<u64>,
    /// Seconds, and ten times the usual, that a check gets before it counts as endless.
    #[arg(long, default_value_t = 10)]
    time_limit: u64,
    /// Lists the mistakes that are chosen, and ends.
    #[arg(long)]
    list: bool,
    /// Where the copy, its build and the report are.
    #[arg(long, value_name = "DIR", default_value = "target/mutants")]
    out: PathBuf,
}

fn main() -> ExitCode {
    let args = Args::parse();
    match run(&args) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("mutants: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(args: &Args) -> Result<ExitCode, MutantsError> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let root = root.canonicalize().map_err(MutantsError::io(&root))?;
    fs::create_dir_all(&args.out).map_err(MutantsError::io(&args.out))?;
    let out = args.out.canonicalize().map_err(MutantsError::io(&args.out))?;
    let (mutants, from) = choose(&root, &args.only, args.count, args.seed)?;
    if args.list {
        for Mutant { number, file, replacement } in &mutants {
            let Replacement { line, before, after, .. } = replacement;
            println!("{number}\t{file}:{line}\t{before}\t{after}");
        }
        return Ok(ExitCode::SUCCESS);
    }
    let planted = mutants.len();
    let say = |what: String| eprintln!("{what}");
    let Built { runner, mutants } = build(&root, &out.join("tree"), mutants, &say)?;
    let trials = Trials {
        runner,
        folder: output_folder(&out)?,
        time_limit: Duration::from_secs(args.time_limit),
        effort: args.effort,
    };
    say("running everything without a mistake".to_owned());
    let baseline = trials.baseline()?;
    let tried = selected(args, &mutants)?;
    let path = out.join("mutants.txt");
    let mut file = File::create(&path).map_err(MutantsError::io(&path))?;
    let end = args.minutes.map(|minutes| Instant::now() + Duration::from_secs(60 * minutes));
    let fates = try_all(
        &tried,
        (args.jobs, end),
        &|mutant| trials.try_mutant(mutant, &baseline),
        // What ends early has said what it knows.
        &mut |fate| write!(file, "{}", listing(std::slice::from_ref(fate))),
    )?;
    let all = counts(&fates);
    let of = format!(
        "{} of {from} possible mistakes were planted (seed {}), {} compile, {} were tried with {} checks, sweeps and \
        pictures.",
        planted,
        args.seed,
        mutants.len(),
        fates.len(),
        baseline.len()
    );
    for (name, text) in [("mutants.md", page(&fates, &of)), ("mutants.txt", listing(&fates))] {
        let path = out.join(name);
        fs::write(&path, text).map_err(MutantsError::io(&path))?;
        println!("{}", path.display());
    }
    println!(
        "{} of {} mistakes that change something are noticed, {:.1} %",
        all.noticed,
        all.changing,
        all.percent()
    );
    Ok(if all.percent() >= args.least { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The mistakes that the arguments select.
fn selected(args: &Args, mutants: &[Mutant]) -> Result<Vec<Mutant>, MutantsError> {
    let read = |path: &PathBuf| fs::read_to_string(path).map_err(MutantsError::io(path));
    let wanted = args.survivors.as_ref().map(read).transpose()?.map(|text| survivors(&text));
    let step = args.sample.map_or(1, |sample| mutants.len().div_ceil(sample.max(1)));
    let chosen = mutants.iter().enumerate().filter(|(at, mutant)| {
        at % step.max(1) == 0
            && (args.numbers.is_empty() || args.numbers.contains(&mutant.number))
            && wanted.as_ref().is_none_or(|wanted| wanted.contains(&survivor_key(mutant)))
    });
    let mut chosen: Vec<Mutant> = chosen.map(|(_, mutant)| mutant.clone()).collect();
    // In no order of files, so that the first of them are a random part.
    chosen.sort_by_key(|mutant| mutant.number.wrapping_mul(0x9e37_79b9));
    Ok(chosen)
}

/// Tries mistakes on several threads, up to an end; `note` is called with each fate.
fn try_all(
    mutants: &[Mutant],
    (jobs, end): (usize, Option<Instant>),
    try_one: &(dyn Fn(u32) -> Result<Fate, MutantsError> + Sync),
    note: &mut (dyn FnMut(&(Mutant, Fate)) -> io::Result<()> + Send),
) -> Result<Vec<(Mutant, Fate)>, MutantsError> {
    let bar = ProgressBar::new(mutants.len() as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} {eta}") {
        bar.set_style(style);
    }
    let next = AtomicUsize::new(0);
    let found = Mutex::new((note, Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..jobs.max(1) {
            scope.spawn(|| {
                while let Some(mutant) = mutants.get(next.fetch_add(1, Ordering::Relaxed)) {
                    if end.is_some_and(|end| Instant::now() > end) {
                        return;
                    }
                    let fate = try_one(mutant.number).map(|fate| (mutant.clone(), fate));
                    bar.inc(1);
                    if let Ok(mut found) = found.lock() {
                        let (note, all) = &mut *found;
                        // The page at the end has it, too.
                        let _ = fate.as_ref().map(note);
                        all.push(fate);
                    }
                }
            });
        }
    });
    bar.finish_and_clear();
    let (_, found) = found.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    let mut fates = found.into_iter().collect::<Result<Vec<(Mutant, Fate)>, _>>()?;
    fates.sort_by_key(|(mutant, _)| mutant.number);
    Ok(fates)
}
