//! No memory: of each call whose size a client chooses, each large allocation fails once. That is GL_OUT_OF_MEMORY, the
//! state is what it was before, and the same call succeeds afterwards.

mod blits;
mod cases;
mod failing;

use cases::{CASES, Case, MEMORY};
use failing::{Failing, with_failing};
use gl_api::*;

#[global_allocator]
static ALLOCATOR: Failing = Failing;

/// More than the pools of a draw and the scratch of a call take: what is larger, a client asked for.
const LEAST: usize = 64 << 10;

/// Most large allocations of a call: more are a test that does not end.
const MOST: usize = 200;

fn context() -> Context {
    let desc = ContextDesc { width: 64, height: 64, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a context");
    c.clear_color(0.0, 0.0, 1.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.rectf(-1.0, -1.0, 0.0, 0.0);
    c.finish();
    c
}

fn picture(c: &mut Context) -> Vec<u8> {
    let mut pixels = vec![0; 64 * 64 * 4];
    c.read_pixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
    pixels
}

/// How many allocations failed.
fn run(case: &Case) -> usize {
    for number in 1..MOST {
        let mut c = context();
        (case.prepare)(&mut c);
        c.finish();
        assert_eq!(c.get_error(), GL_NO_ERROR, "{}: {:?}", case.name, c.messages());
        let before = ((case.state)(&mut c), picture(&mut c));
        let has_failed = with_failing(number, LEAST, || (case.call)(&mut c));
        let error = c.get_error();
        if !has_failed {
            assert_eq!(error, GL_NO_ERROR, "{}: {:?}", case.name, c.messages());
            assert_ne!((case.state)(&mut c), before.0, "{}: nothing has changed", case.name);
            return number - 1;
        }
        let at = format!("{}, allocation {number}", case.name);
        assert_eq!(error, GL_OUT_OF_MEMORY, "{at}: {:?}", c.messages());
        assert_eq!((case.state)(&mut c), before.0, "{at}: the state has changed");
        assert!(picture(&mut c) == before.1, "{at}: the picture has changed");
        (case.call)(&mut c);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{at}, once more: {:?}", c.messages());
    }
    panic!("{}: more than {MOST} allocations", case.name);
}

/// One test, as the allocator is the process's.
#[test]
fn no_memory_is_an_error_that_changes_nothing() {
    std::sync::LazyLock::force(&MEMORY);
    let only = std::env::var("DETGL_CASE").ok();
    for case in CASES
        .iter()
        .chain(blits::CASES)
        .filter(|case| only.as_deref().is_none_or(|only| only == case.name))
    {
        println!("{}", case.name);
        let failed = run(case);
        println!("{}: {failed} allocations", case.name);
        assert!(failed > 0, "{} allocates nothing large", case.name);
    }
}
