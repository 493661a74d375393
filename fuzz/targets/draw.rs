//! Any text as the source of a fragment shader that draws: it ends.
#![no_main]

#[path = "../bodies/shaders.rs"]
mod shaders;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|source: &str| shaders::link_and_run(source));
