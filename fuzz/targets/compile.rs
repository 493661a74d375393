//! Any text as the source of a shader: it compiles and links, or a log says why not.
#![no_main]

#[path = "../bodies/shaders.rs"]
mod shaders;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|source: &str| shaders::compile_and_link(source));
