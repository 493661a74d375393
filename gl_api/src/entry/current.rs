//! The thread's current context.
//!
//! A call takes the context out of its place for as long as it runs, so that nothing can borrow it
//! twice; a call from within a call finds no context, and is ignored.
//!
//! The place has nothing to destroy, so that it is there to the end of the thread: the main thread's
//! destructors run before the functions of `atexit`, which may call GL. What a thread that is
//! ending leaves there is dropped by [`ThreadEnd`], or by the host that the context belongs to.

use crate::base::refused_result::RefusedResult;
use crate::context::Context;
use crate::context::debug::Echo;
use std::cell::Cell;
use std::fmt;
use std::marker::PhantomData;
use std::mem::ManuallyDrop;
use std::sync::OnceLock;

thread_local! {
    static CURRENT: Cell<Option<ManuallyDrop<Box<Context>>>> = const { Cell::new(None) };
    static WARNED: Cell<bool> = const { Cell::new(false) };
}

/// Puts the context back, even when a call panics. It has nothing else to destroy, which each entry point would have
/// code for.
struct Taken(ManuallyDrop<Option<Box<Context>>>);

impl Taken {
    fn new(context: Box<Context>) -> Self {
        Self(ManuallyDrop::new(Some(context)))
    }
}

impl Drop for Taken {
    #[inline(never)]
    fn drop(&mut self) {
        swap_current(self.0.take());
    }
}

// What follows is the same for all entry points, so that it is not part of each of them.

#[inline(never)]
fn take() -> Option<Taken> {
    swap_current(None).map(Taken::new)
}

/// The context for an entry point.
#[inline(never)]
fn take_for(name: &str) -> Option<Taken> {
    let taken = take();
    if taken.is_none() {
        warn(name);
    }
    taken
}

/// Runs `f` with the thread's current context, if there is one.
pub fn with_current<R>(f: impl FnOnce(&mut Context) -> R) -> Option<R> {
    let mut taken = take()?;
    let result = taken.0.as_deref_mut().map(f);
    drop(taken);
    result
}

/// Runs the entry point `name`. As a part of each entry point: as functions of their own, a thousand of them,
/// these few instructions are 70 KB more.
#[inline(always)]
pub fn call<R: RefusedResult>(name: &str, f: impl FnOnce(&mut Context) -> R) -> R {
    let Some(mut taken) = take_for(name) else { return R::refused_result() };
    let result = taken.0.as_deref_mut().map(f);
    drop(taken);
    result.unwrap_or_else(R::refused_result)
}

/// Says once a thread that it has no current context, unless `DETGL_DEBUG=0` wants nothing said.
#[cold]
#[inline(never)]
fn warn(name: &str) {
    if !WARNED.replace(true) && Echo::from_env() != Echo::Nothing {
        eprintln!(
            "detgl: {name}: ignored, as this thread has no current context: call eglMakeCurrent or OSMesaMakeCurrent \
             before (in Rust, keep what Context::make_current returns)"
        );
    }
}

/// Makes a context the thread's current one, or none; gives the one that was.
pub fn set_current(context: Option<Context>) -> Option<Context> {
    register_thread_end();
    swap_current(context.map(Box::new)).map(|context| *context)
}

/// As [`set_current`], where the thread's end is expected already.
pub fn swap_current(context: Option<Box<Context>>) -> Option<Box<Context>> {
    CURRENT.replace(context.map(ManuallyDrop::new)).map(ManuallyDrop::into_inner)
}

/// What a host does with the context that is current where a thread ends.
static HOST: OnceLock<fn()> = OnceLock::new();

/// Its destructor is the thread's end.
struct ThreadEnd {
    /// Whether the thread was the one that the program began with. With that the process ends, and what comes last may
    /// use its context.
    main: Cell<bool>,
}

impl Drop for ThreadEnd {
    fn drop(&mut self) {
        match HOST.get() {
            Some(host) => host(),
            None if self.main.get() => {}
            None => drop(swap_current(None)),
        }
    }
}

thread_local! {
    static END: ThreadEnd = const { ThreadEnd { main: Cell::new(false) } };
}

/// Sees to it that the current context is taken care of when this thread ends. A thread that is ending already keeps
/// it.
fn register_thread_end() {
    // The first use registers the destructor.
    let _ = END.try_with(|end| {
        if HOST.get().is_none() {
            end.main.set(std::thread::current().name() == Some("main"));
        }
    });
}

/// Has `host` take care of the current context when this thread ends, and any other that has one.
pub fn expect_thread_end(host: fn()) {
    HOST.get_or_init(|| host);
    register_thread_end();
}

/// A context that is current until this is dropped; then the one before is current again.
pub struct Current {
    before: Option<Context>,
    released: bool,
    /// A context is current on one thread.
    _thread: PhantomData<*const ()>,
}

impl Context {
    /// Makes this the thread's current context, for as long as the guard lives.
    #[must_use = "the context is current only as long as the guard lives: `let _current = …`, as `let _ = …` drops it at once"]
    pub fn make_current(self) -> Current {
        Current { before: set_current(Some(self)), released: false, _thread: PhantomData }
    }
}

impl Current {
    /// Ends being current and gives the context back, unless the thread has lost it meanwhile.
    pub fn release(mut self) -> Option<Context> {
        self.released = true;
        set_current(self.before.take())
    }
}

impl Drop for Current {
    fn drop(&mut self) {
        if !self.released {
            set_current(self.before.take());
        }
    }
}

impl fmt::Debug for Current {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Current")
    }
}
