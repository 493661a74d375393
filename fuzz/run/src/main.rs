//! `fuzz-run TARGET FIRST..END`, on every core: prints the figures.

use fuzz_run::{Done, Target};
use std::ops::Range;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

fn asked() -> Option<(Target, Range<u64>)> {
    let mut arguments = std::env::args().skip(1);
    let (name, seeds) = (arguments.next()?, arguments.next()?);
    let target = Target::ALL.into_iter().find(|target| target.name() == name)?;
    let (first, end) = seeds.split_once("..")?;
    Some((target, first.parse().ok()?..end.parse().ok()?))
}

fn main() -> ExitCode {
    let Some((target, seeds)) = asked() else {
        let names = Target::ALL.map(Target::name).join(", ");
        eprintln!(
            "fuzz-run TARGET FIRST..END: the target is one of {names}, the seeds are numbers"
        );
        return ExitCode::FAILURE;
    };
    let (start, next, total) =
        (Instant::now(), AtomicU64::new(seeds.start), Mutex::new(Done::default()));
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    if seed >= seeds.end {
                        return;
                    }
                    let done = target.run(seed..seed + 1);
                    // A thread that panicked holds nothing by halves.
                    *total.lock().unwrap_or_else(|poisoned| poisoned.into_inner()) += done;
                }
            });
        }
    });
    let Done { calls, shaders, pictures, varied } =
        *total.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    println!(
        "{} {}..{}: {calls} calls, {shaders} shaders, {pictures} pictures compared, {varied} of more than one colour, {:.0} s",
        target.name(),
        seeds.start,
        seeds.end,
        start.elapsed().as_secs_f64(),
    );
    ExitCode::SUCCESS
}
