//! The floating-point state of the calling thread: DetGL computes in its own, whatever the host program has set.
//!
//! The state is a control word (rounding, treatment of denormals, which exceptions trap) and the sticky exception
//! flags. With DetGL's control word operations round to nearest, keep denormals, and trap on nothing (IEEE 754-2019,
//! sections 4.3, 7 and 8).

use std::cell::Cell;
use std::marker::PhantomData;
use std::mem::ManuallyDrop;

cfg_select! {
    // Miri has no inline assembly, and no control word but the default one.
    miri => { use elsewhere::{State, read, write}; }
    any(target_arch = "x86_64", all(target_arch = "x86", target_feature = "sse2")) => {
        use x86::{State, read, write};
    }
    target_arch = "aarch64" => { use aarch64::{State, read, write}; }
    _ => { use elsewhere::{State, read, write}; }
}

thread_local! {
    /// The host's state, while a call on this thread computes in another one.
    static HOST: Cell<Option<State>> = const { Cell::new(None) };
}

/// The calling thread computes with DetGL's control word while this value lives; dropping it restores the state that
/// the thread had, sticky exception flags included. May be nested.
#[must_use = "the host's state is restored when this value is dropped"]
#[derive(Debug)]
pub struct FloatEnv {
    found: State,
    /// The state is the thread's: restored on another one it would be wrong.
    not_send: PhantomData<*const ()>,
}

impl FloatEnv {
    /// Whether this processor's control word is known. Where it is not, nothing is set or restored.
    pub const IS_KNOWN: bool = State::IS_KNOWN;

    /// Sets DetGL's control word, unless it is set.
    #[inline(always)]
    pub fn enter() -> Self {
        let found = read();
        if !found.is_ours() {
            leave_host(found);
        }
        Self { found, not_send: PhantomData }
    }

    /// Sets DetGL's control word for the rest of the thread's life: for threads that DetGL starts.
    pub fn enter_for_good() {
        std::mem::forget(Self::enter());
        HOST.set(None);
    }

    /// Runs a function of the host program with the control word that it has set, within a call that computes. What the
    /// function changes of the state ends with it, as it would where the call restores the state.
    pub fn in_host<R>(callback: impl FnOnce() -> R) -> R {
        let _restored = Self { found: read(), not_send: PhantomData };
        let host = HOST.take();
        if let Some(host) = host {
            write(host);
        }
        let result = callback();
        HOST.set(host);
        result
    }
}

impl Drop for FloatEnv {
    #[inline(always)]
    fn drop(&mut self) {
        if read() != self.found {
            restore(self.found);
        }
    }
}

/// A [`FloatEnv`] for code that is instantiated a thousand times: neither of its ends is inlined.
#[must_use = "the host's state is restored when this value is dropped"]
#[derive(Debug)]
pub struct OutlinedFloatEnv(ManuallyDrop<FloatEnv>);

impl OutlinedFloatEnv {
    /// As [`FloatEnv::enter`].
    #[inline(never)]
    pub fn enter() -> Self {
        Self(ManuallyDrop::new(FloatEnv::enter()))
    }
}

impl Drop for OutlinedFloatEnv {
    #[inline(never)]
    fn drop(&mut self) {
        if read() != self.0.found {
            restore(self.0.found);
        }
    }
}

/// Remembers the host's state and sets the control word.
#[cold]
#[inline(never)]
fn leave_host(found: State) {
    HOST.set(Some(found));
    write(found.with_our_control());
}

/// Puts back what a guard found.
#[cold]
#[inline(never)]
fn restore(found: State) {
    if !found.is_ours() {
        HOST.set(None);
    }
    write(found);
}

/// MXCSR (Intel SDM, volume 1, section 10.2.3). The x87's control word is left to the host: where SSE2 computes, it
/// decides only how 32-bit x86 rounds 64-bit integers that a float cannot represent.
#[cfg(any(target_arch = "x86_64", all(target_arch = "x86", target_feature = "sse2")))]
#[cfg_attr(miri, expect(dead_code))]
mod x86 {
    use std::arch::asm;
    use std::mem::MaybeUninit;

    /// IE, DE, ZE, OE, UE, PE.
    const FLAGS: u32 = 0x3F;
    /// All exceptions masked, rounding to nearest, neither FTZ nor DAZ.
    const OURS: u32 = 0x1F80;

    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct State(pub(super) u32);

    impl State {
        pub const IS_KNOWN: bool = true;

        #[inline(always)]
        pub fn is_ours(self) -> bool {
            self.0 & !FLAGS == OURS
        }

        pub fn with_our_control(self) -> Self {
            Self(self.0 & FLAGS | OURS)
        }
    }

    // The compiler knows nothing of the control word and could move arithmetic past these instructions. As neither is
    // `nomem`, no access to memory is moved past them, and so no operation on what is read after or was stored before.
    // `_mm_getcsr` and `_mm_setcsr` are deprecated for lack of such a promise.

    #[inline(always)]
    pub fn read() -> State {
        let mut word = MaybeUninit::<u32>::uninit();
        // SAFETY: writes the four bytes of `word`, and nothing else.
        unsafe {
            asm!("stmxcsr [{}]", in(reg) word.as_mut_ptr(), options(nostack, preserves_flags));
            State(word.assume_init())
        }
    }

    #[inline(always)]
    pub fn write(state: State) {
        // SAFETY: `state` was read from the register, or has bits that every processor has. Code of Rust runs with the
        // control word that it assumes; the host's is put back when none follows.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &state.0, options(nostack)) }
    }
}

/// FPCR and FPSR (Arm ARM, sections C5.2.8 and C5.2.10).
#[cfg(target_arch = "aarch64")]
#[cfg_attr(miri, expect(dead_code))]
mod aarch64 {
    use std::arch::asm;

    /// No traps, rounding to nearest, no flushing, NaNs propagate.
    const OURS: u64 = 0;

    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct State {
        control: u64,
        flags: u64,
    }

    impl State {
        pub const IS_KNOWN: bool = true;

        #[inline(always)]
        pub fn is_ours(self) -> bool {
            self.control == OURS
        }

        pub fn with_our_control(self) -> Self {
            Self { control: OURS, ..self }
        }
    }

    // The compiler knows nothing of these registers and could move arithmetic past the instructions. As neither block is
    // `nomem`, no access to memory is moved past it, and so no operation on what is read after or was stored before.

    #[inline(always)]
    pub fn read() -> State {
        let (control, flags);
        // SAFETY: reads two registers.
        unsafe {
            asm!(
                "mrs {}, fpcr",
                "mrs {}, fpsr",
                out(reg) control,
                out(reg) flags,
                options(nostack, preserves_flags)
            );
        }
        State { control, flags }
    }

    #[inline(always)]
    pub fn write(state: State) {
        // SAFETY: `state` was read from the registers, or has bits that every processor has. Code of Rust runs with the
        // control word that it assumes; the host's is put back when none follows.
        unsafe {
            asm!(
                "msr fpcr, {}",
                "msr fpsr, {}",
                in(reg) state.control,
                in(reg) state.flags,
                options(nostack)
            );
        }
    }
}

/// A processor without such a state, or whose is not known.
#[allow(dead_code, reason = "not used where the state is known")]
mod elsewhere {
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct State;

    impl State {
        pub const IS_KNOWN: bool = false;

        pub fn is_ours(self) -> bool {
            true
        }

        pub fn with_our_control(self) -> Self {
            self
        }
    }

    pub fn read() -> State {
        State
    }

    pub fn write(State: State) {}
}

#[cfg(test)]
mod tests {
    use super::{FloatEnv, read};

    #[test]
    fn guards_nest_and_restore_what_they_found() {
        let found = read();
        {
            let _outer = FloatEnv::enter();
            let _inner = FloatEnv::enter();
            // Inexact, and a division by zero.
            let third = std::hint::black_box(1.0_f32) / std::hint::black_box(3.0);
            std::hint::black_box(third / std::hint::black_box(0.0));
        }
        assert_eq!(read(), found);
    }

    #[test]
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    fn the_hosts_state_is_there_in_callbacks_and_afterwards() {
        use super::{State, write};
        // Upward, FTZ and DAZ, division by zero traps, overflow was seen.
        let (host, ours) = (State(0xDDC8), read());
        write(host);
        let outer = FloatEnv::enter();
        let within = read();
        let (called, nested) = FloatEnv::in_host(|| {
            let called = read();
            let _nested = FloatEnv::enter();
            (called, read())
        });
        let after = FloatEnv::in_host(read);
        drop(outer);
        let restored = read();
        write(ours);
        assert_eq!([called, after, restored], [host; 3]);
        assert!(within.is_ours() && nested.is_ours());
    }
}
