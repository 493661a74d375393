//! A fixed number of calls and shaders, on every commit.

use fuzz_run::{Done, Target};
use std::time::Instant;

fn run(target: Target, seeds: u64) -> Done {
    let start = Instant::now();
    let done = target.run(0..seeds);
    println!("{}, {seeds} seeds: {done:?}, {:?}", target.name(), start.elapsed());
    done
}

/// Calls of one thread: none panics, and every context works afterwards.
#[test]
fn two_million_calls_leave_contexts_that_work() {
    let mut done = run(Target::Table, 700);
    done += run(Target::Calls, 300);
    assert_eq!(done.calls, 2_000_000);
}

#[test]
fn calls_on_the_threads_of_a_group_leave_contexts_that_work() {
    assert_eq!(run(Target::Group, 150).calls, 450_000);
}

#[test]
fn devices_draw_the_same_pictures_of_the_same_calls() {
    let done = run(Target::Devices, 150);
    assert_eq!((done.calls, done.pictures), (150 * 5 * 800, 150 * 4 * 4));
}

#[test]
fn devices_draw_the_same_pictures_of_the_same_shaders() {
    let done = run(Target::Shaders, 80);
    assert_eq!((done.shaders, done.pictures), (80 * 10 * 5, 80 * 10 * 4));
}
