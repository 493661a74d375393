//! Any text as the source of a shader: it compiles and links, or the info log has the reason.
#![no_main]

#[path = "../bodies/compile.rs"]
mod body;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|source: &str| body::compile_and_link(source));
