//! Any bytes as blocks of a compressed image: it is refused, or its texels are numbers that its format has.
#![no_main]

#[path = "../bodies/blocks.rs"]
mod blocks;
#[path = "../bodies/context.rs"]
mod context;

use context::{context_of, still_works};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let mut c = context_of(gl_api::Api::Es2);
    blocks::prepare(&mut c);
    blocks::sample(&mut c, bytes);
    still_works(&mut c);
});
