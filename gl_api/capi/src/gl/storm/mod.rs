//! Every C function of GL with typed arguments, alone and in random sequences. The memory of each pointer has as
//! many elements as the specification says, and an unmapped page follows it. So a call that reads or writes one byte
//! more ends the test, which names it.
//!
//! Lengths of typed pointers are those of the Khronos registry ([`crate::lengths`]), of untyped ones the formulas of
//! the specification, which stand here once more ([`lengths`]).

mod arguments;
mod cases;
mod lengths;
mod memory;
mod random;

use cases::{Case, SLOTS, cases};
use gl_api::*;
use lengths::{Counts, is_unlimited};
use memory::{NAME, Slot, guarded};
use random::Random;
use std::cell::Cell;
use std::time::{Duration, Instant};

/// Calls of a storm.
const CALLS: usize = 25_000;
/// Contexts of a group.
const THREADS: u64 = 8;

/// The seeds of storms: `DETGL_STORM=FIRST..END`, or a few.
fn seeds() -> std::ops::Range<u64> {
    let given = std::env::var("DETGL_STORM").unwrap_or_else(|_| "0..40".to_owned());
    let seeds = given
        .split_once("..")
        .and_then(|(first, end)| Some(first.parse().ok()?..end.parse().ok()?));
    seeds.unwrap_or_else(|| panic!("DETGL_STORM={given} must be FIRST..END"))
}

/// A context with an object of each kind that calls look up, most of them named 1.
fn with_objects(mut c: Context) -> Context {
    c.bind_texture(GL_TEXTURE_2D, 1);
    let texels = Data::Bytes(&[7; 64]);
    c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.buffer_data(GL_ARRAY_BUFFER, 64, Data::Null, GL_STATIC_DRAW);
    c.bind_buffer(GL_ARRAY_BUFFER, 0);
    let shader = c.create_shader(GL_FRAGMENT_SHADER);
    let source =
        "uniform vec4 u[4]; uniform mat3 m; void main() { gl_FragColor = u[3] + m[1].xyzz; }";
    c.shader_source(shader, 1, Strings(vec![source]), &[]);
    c.compile_shader(shader);
    let program = c.create_program();
    c.attach_shader(program, shader);
    c.link_program(program);
    c.use_program(program);
    c.begin_query(GL_SAMPLES_PASSED, 1);
    c.end_query(GL_SAMPLES_PASSED);
    c
}

fn desc() -> ContextDesc {
    ContextDesc { width: 16, height: 16, ..ContextDesc::default() }
}

fn new_context() -> Context {
    Context::new(desc()).expect("a device")
}

/// Runs a call a few times, within a list too.
fn try_case(case: &Case, slots: &[Slot; SLOTS], random: &Random, counts: Counts, rounds: usize) {
    NAME.set(case.name);
    for round in 0..rounds {
        // A list copies what a uniform takes at most: which one it is for is not known yet.
        let of_uniform = ["glUniform", "glProgramUniform"];
        let is_uniform = of_uniform.iter().any(|name| case.name.starts_with(name));
        let is_cut = counts != Counts::Honest && is_uniform;
        let in_list = round % 4 == 3 && !is_cut;
        if in_list {
            with_current(|c| c.new_list(1, GL_COMPILE));
        }
        (case.run)(slots, random, counts);
        with_current(|c| {
            c.end();
            if in_list {
                c.end_list();
            }
            while c.get_error() != GL_NO_ERROR {}
            c.messages();
        });
    }
}

#[test]
fn no_call_passes_the_end_of_what_the_specification_gives_it() {
    let slots = guarded();
    let random = Random(Cell::new(1));
    let cases = cases();
    assert!(cases.len() > 1100, "{}", cases.len());
    for case in &cases {
        let current = with_objects(new_context()).make_current();
        try_case(case, &slots, &random, Counts::Honest, 32);
        drop(current);
    }
}

#[test]
fn no_call_touches_memory_by_a_count_that_it_refuses() {
    let slots = guarded();
    let random = Random(Cell::new(2));
    let mut tried = 0;
    for case in cases().iter().filter(|case| !is_unlimited(case.name)) {
        let current = with_objects(new_context()).make_current();
        for &at in &case.counts {
            try_case(case, &slots, &random, Counts::Hostile(at), 24);
            tried += 1;
        }
        drop(current);
    }
    assert!(tried > 250, "{tried} counts");
}

/// Calls whose state makes the lengths of later ones others than the formulas here say, and those that take a long time
/// by intent.
const LEFT_OUT_OF_STORMS: &[&str] = &[
    "glPixelStoref",
    "glPixelStorei",
    "glPixelMapfv",
    "glPixelMapuiv",
    "glPixelMapusv",
    // They keep their memory and write to it later.
    "glFeedbackBuffer",
    "glSelectBuffer",
    // A pointer to memory of the library, which nothing here unmaps in time.
    "glDebugMessageCallback",
    "glDebugMessageCallbackARB",
];

/// Calls that write as much as an object of the share group has: another thread may give it more between the moment at
/// which the memory is measured and the call, which a program prevents by its own order of calls.
const LEFT_OUT_OF_GROUPS: &[&str] = &[
    "glGetAttachedShaders",
    "glGetAttachedObjectsARB",
    "glGetUniformfv",
    "glGetUniformfvARB",
    "glGetUniformiv",
    "glGetUniformivARB",
    "glGetUniformuiv",
    "glGetUniformuivEXT",
    "glGetActiveUniformsiv",
    "glGetActiveUniformBlockiv",
];

/// Whether other threads call at the same time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Company {
    Alone,
    Group,
}

impl Company {
    fn leaves_out(self, name: &str) -> bool {
        LEFT_OUT_OF_STORMS.contains(&name)
            || (self == Self::Group && LEFT_OUT_OF_GROUPS.contains(&name))
    }
}

/// Random calls on a context that keeps its state; with `Counts::Hostile`, now and then.
fn storm(mut c: Context, seed: u64, company: Company) -> Context {
    let slots = guarded();
    let random = Random(Cell::new(seed));
    let cases = cases();
    let cases: Vec<&Case> = cases.iter().filter(|case| !company.leaves_out(case.name)).collect();
    c = with_objects(c);
    let current = c.make_current();
    for number in 0..CALLS {
        let case = cases[random.below(cases.len() as u64) as usize];
        NAME.set(case.name);
        let counts = match case.counts.as_slice() {
            counts if !counts.is_empty() && !is_unlimited(case.name) && number % 8 == 0 => {
                Counts::Hostile(random.pick(counts))
            }
            _ => Counts::Honest,
        };
        // A list would copy what a uniform takes at most, whichever that will be.
        let counts = if case.name.starts_with("glUniform") { Counts::Honest } else { counts };
        let begin = Instant::now();
        (case.run)(&slots, &random, counts);
        let took = begin.elapsed();
        assert!(took < Duration::from_secs(10), "seed {seed}: {} took {took:?}", case.name);
        // What begins a primitive or a list would swallow most of the rest.
        if number % 16 == 0 {
            with_current(|c| {
                c.end();
                c.end_list();
                while c.get_error() != GL_NO_ERROR {}
                c.messages();
            });
        }
    }
    current.release().expect("the context is still current")
}

/// The context still draws what it is asked to.
fn assert_draws(c: &mut Context) {
    c.end();
    c.end_list();
    c.render_mode(GL_RENDER);
    c.end_transform_feedback();
    c.end_conditional_render();
    c.use_program(0);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    c.draw_buffer(GL_BACK);
    c.read_buffer(GL_BACK);
    c.bind_buffer(GL_PIXEL_PACK_BUFFER, 0);
    c.disable(GL_SCISSOR_TEST);
    c.color_mask(true, true, true, true);
    c.clear_color(0.0, 1.0, 0.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    while c.get_error() != GL_NO_ERROR {}
    let mut pixel = [0; 4];
    for transfer in [GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE] {
        c.pixel_transferf(transfer, 1.0);
        c.pixel_transferf(transfer + 1, 0.0);
    }
    c.pixel_transferi(GL_MAP_COLOR, 0);
    c.read_pixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!((pixel, c.get_error()), ([0, 255, 0, 255], GL_NO_ERROR), "{:?}", c.messages());
}

#[test]
fn random_calls_leave_a_context_that_works() {
    for seed in seeds() {
        let mut c = storm(new_context(), seed, Company::Alone);
        assert_draws(&mut c);
    }
}

#[test]
fn random_calls_on_several_threads_of_a_group_leave_contexts_that_work() {
    for seed in seeds().step_by(16) {
        let first = new_context();
        let others: Vec<Context> =
            (1..THREADS).map(|_| first.new_shared(desc()).expect("a context")).collect();
        std::thread::scope(|scope| {
            for (number, c) in (0..).zip(std::iter::once(first).chain(others)) {
                let seed = seed * THREADS + number;
                scope.spawn(move || assert_draws(&mut storm(c, seed, Company::Group)));
            }
        });
    }
}
