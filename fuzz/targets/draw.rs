//! Any text as the source of a fragment shader that is drawn with: the draw terminates.
#![no_main]

#[path = "../bodies/draw.rs"]
mod body;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|source: &str| body::link_and_run(source));
