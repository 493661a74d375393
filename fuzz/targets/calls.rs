//! Any bytes as a sequence of GL calls: none panics, and the context works afterwards.
#![no_main]

#[path = "../bodies/calls.rs"]
mod calls;
#[path = "../bodies/context.rs"]
mod context;
#[path = "../bodies/random.rs"]
mod random;

use calls::make_calls;
use context::{context_of, still_works};
use libfuzzer_sys::fuzz_target;
use random::Random;

fuzz_target!(|bytes: &[u8]| {
    let mut c = context_of(gl_api::Api::Compatibility);
    make_calls(&mut c, &mut Random::new(0, bytes), 100);
    still_works(&mut c);
});
