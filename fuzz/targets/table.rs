//! Any bytes as a sequence of calls, drawn from the whole table of entry points with arguments by
//! type: none panics, and the context works afterwards.
#![no_main]

#[path = "../bodies/context.rs"]
mod context;

use context::{context_of, still_works};
use gl_api::exercise::{Random, exercises};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let (mut c, mut random) = (context_of(gl_api::Api::Compatibility), Random::new(0, bytes));
    let all = exercises();
    for _ in 0..bytes.len().min(400) {
        let exercise = &all[random.below(all.len())];
        (exercise.run)(&mut c, &mut random);
    }
    c.end_list();
    c.render_mode(gl_api::GL_RENDER);
    c.end_conditional_render();
    still_works(&mut c);
});
