//! Any bytes as a sequence of calls of EGL and OSMesa, with valid and invalid handles and with memory that is freed: no memory
//! error occurs, and new contexts work afterwards.
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
