//! Any bytes as a sequence of GL calls: none panics, and the context goes on working.
#![no_main]

#[path = "../bodies/calls.rs"]
mod calls;

use calls::{Random, context, make_calls, still_works};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let mut c = context();
    make_calls(&mut c, &mut Random::new(0, bytes), 100);
    still_works(&mut c);
});
