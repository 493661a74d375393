//! Any bytes as the choices of a grammar of GLSL ES: the shader is refused with a reason, or a draw with it ends.
#![no_main]

#[path = "../bodies/context.rs"]
mod context;
#[path = "../bodies/es_shader.rs"]
mod es_shader;
#[path = "../bodies/random.rs"]
mod random;

use context::{context_of, still_works};
use libfuzzer_sys::fuzz_target;
use random::Random;

fuzz_target!(|bytes: &[u8]| {
    let mut c = context_of(gl_api::Api::Es2);
    es_shader::draw(&mut c, &es_shader::shader(&mut Random::new(0, bytes)));
    still_works(&mut c);
});
