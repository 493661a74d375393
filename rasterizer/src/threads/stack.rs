//! A large stack for recursion as deep as a shader nests, whatever the caller's stack: a thread has 128 KB with musl and
//! 512 KB on macOS, and a stack overflow ends the process.

use std::panic::resume_unwind;
use std::thread::{Builder, scope};
use texunit::lanes::FloatEnv;

/// Bytes of the stack; pages are committed when touched. The deepest shaders need 1 MB in an optimized build, 8 MB in
/// an unoptimized one.
const STACK: usize = 16 << 20;

/// Runs `work` on a thread with a large stack and waits for it; on the caller's stack where no thread can be started. A
/// panic is passed on.
pub fn with_large_stack<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    let mut work = Some(work);
    let done = scope(|scope| {
        let run = || {
            FloatEnv::enter_for_good();
            work.take().map(|work| work())
        };
        let thread = Builder::new().name("detgl shader".into()).stack_size(STACK);
        let thread = thread.spawn_scoped(scope, run).ok()?;
        thread.join().unwrap_or_else(|panic| resume_unwind(panic))
    });
    match (done, work) {
        (Some(done), _) => done,
        (None, Some(work)) => work(),
        (None, None) => unreachable!("who took the work has done it"),
    }
}

#[cfg(test)]
mod tests {
    use super::with_large_stack;

    #[test]
    #[cfg_attr(target_family = "wasm", ignore = "there are no threads there")]
    fn work_has_a_larger_stack_than_its_caller() {
        fn depth(left: usize) -> usize {
            let filler = std::hint::black_box([left; 128]);
            if left == 0 { 0 } else { 1 + depth(filler[7] - 1) }
        }
        let caller = std::thread::Builder::new().stack_size(64 << 10);
        let caller = caller.spawn(|| with_large_stack(|| depth(4_000))).expect("a thread");
        assert_eq!(caller.join().expect("no overflow"), 4_000);
    }

    #[test]
    #[cfg_attr(target_family = "wasm", ignore = "a panic ends the program there")]
    fn a_panic_is_passed_on() {
        let panic = std::panic::catch_unwind(|| with_large_stack(|| panic!("oh")));
        assert_eq!(panic.expect_err("it panics").downcast_ref::<&str>(), Some(&"oh"));
    }
}
