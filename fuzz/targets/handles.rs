//! Any bytes as a sequence of calls of EGL and OSMesa, with handles and memory that come and go: no harm is done, and
//! what is made afterwards works.
#![no_main]

#[path = "../bodies/handles.rs"]
mod handles;
#[path = "../bodies/random.rs"]
mod random;

// Linked for its C names.
use detgl as _;
use handles::Client;
use libfuzzer_sys::fuzz_target;
use random::Random;

fuzz_target!(|bytes: &[u8]| {
    let mut client = Client::new();
    client.make_calls(&mut Random::new(0, bytes), 200);
    client.still_works();
});
