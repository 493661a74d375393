//! Bad handles at EGL's and OSMesa's door, from several threads at once: nothing panics or hangs, and what is made
//! afterwards works.

#[path = "../../../fuzz/bodies/handles.rs"]
mod handles;
#[path = "../../../fuzz/bodies/random.rs"]
mod random;

// Linked for its C names.
use detgl as _;
use handles::Client;
use random::Random;
use std::time::{Duration, Instant};

#[test]
fn random_handles_do_no_harm() {
    let start = Instant::now();
    // Whose handles are of one display, which each terminates now and then.
    for seed in 0..40 {
        std::thread::scope(|scope| {
            for thread in 0..3 {
                scope.spawn(move || {
                    let mut client = Client::new();
                    client.make_calls(&mut Random::new(3 * seed + thread, &[]), 300);
                });
            }
        });
        Client::new().still_works();
        // A slow machine tries fewer.
        if start.elapsed() > Duration::from_secs(20) {
            break;
        }
    }
}
