//! The host program's floating-point state has no influence on what is drawn, and calls leave it as it is.
#![cfg(all(
    target_os = "linux",
    target_env = "gnu",
    any(target_arch = "x86_64", target_arch = "aarch64")
))]
#![allow(unsafe_code, reason = "calls C functions")]

mod c;
mod scenes;

use c::*;
// Linked for its C names.
use detgl as _;
use scenes::{SCENES, draw};
use std::cell::Cell;
use std::ffi::{c_char, c_void};
use std::process::Command;

/// What a child process does, by names of `MODES` and `WHEN`.
const ASKED: &str = "DETGL_TEST_FLOAT_ENV";

/// A way for the host to compute, and what sets it; whether the processor can.
type Mode = (&'static str, fn() -> bool);

const MODES: [Mode; 6] = [
    ("to nearest", || fesetround(TONEAREST) == 0),
    ("downward", || fesetround(DOWNWARD) == 0),
    ("upward", || fesetround(UPWARD) == 0),
    ("toward zero", || fesetround(TOWARDZERO) == 0),
    ("flush denormals", || {
        flush_denormals();
        true
    }),
    // AArch64's processors need not have it.
    ("trap", || feenableexcept(DIVBYZERO | INVALID | OVERFLOW) != -1),
];

/// When a mode is set: before the first call, once there is a context, or by another thread, which makes the first
/// context and ends.
const WHEN: [&str; 3] = ["before", "after", "elsewhere"];

#[test]
fn pictures_do_not_depend_on_the_hosts_floating_point_state() {
    let wanted = child("to nearest", "before", 1);
    assert_eq!(wanted.lines().count(), SCENES.len(), "{wanted}");
    for threads in [1, 2] {
        for (mode, _) in MODES {
            for when in WHEN {
                assert_eq!(child(mode, when, threads), wanted, "{mode}, {when}, {threads} threads");
            }
        }
    }
}

/// Draws in a process of its own; the digests of its pictures.
fn child(mode: &str, when: &str, threads: u32) -> String {
    let mut child = Command::new(std::env::current_exe().expect("a file"));
    child.args(["--exact", "draws_in_a_mode", "--nocapture", "--test-threads=1"]);
    child.env(ASKED, format!("{mode}/{when}")).env("DETGL_THREADS", threads.to_string());
    let output = child.output().expect("it starts");
    let said = String::from_utf8_lossy(&output.stdout);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{mode}, {when}: {}\n{said}{errors}", output.status);
    said.lines().filter(|line| line.starts_with("picture ")).collect::<Vec<_>>().join("\n")
}

/// What a child process does; nothing in the parent.
#[test]
fn draws_in_a_mode() {
    let Ok(asked) = std::env::var(ASKED) else { return };
    let (mode, when) = asked.split_once('/').expect("a mode and when");
    let (_, set) = MODES.into_iter().find(|(name, _)| *name == mode).expect("a mode");
    match when {
        "before" => {
            set();
            make_context();
        }
        "after" => {
            make_context();
            glFinish();
            set();
        }
        _ => {
            let first = std::thread::spawn(move || {
                set();
                make_context();
                draw(SCENES[0]);
                set_default();
            });
            first.join().expect("no panic");
            make_context();
        }
    }
    let (control, _) = state();
    let drawn: Vec<_> = SCENES.iter().map(|&scene| draw(scene)).collect();
    assert_eq!(state().0, control, "the control word is the host's");
    flags_are_kept();
    callbacks_run_in_the_hosts_state();
    set_default();
    for ((name, _), words) in SCENES.iter().zip(drawn) {
        let digest = words.into_iter().fold(0xCBF2_9CE4_8422_2325_u64, |hash, word| {
            (hash ^ u64::from(word)).wrapping_mul(0x100_0000_01B3)
        });
        println!("\npicture {name}: {digest:x}");
    }
}

/// Neither are flags of the host lost, nor does it see those of what is computed for it.
fn flags_are_kept() {
    for raised in [0, INVALID | OVERFLOW] {
        assert_eq!(feclearexcept(ALL), 0);
        // Where they trap it would.
        let control = state().0;
        if raised != 0 {
            set_default();
            feraiseexcept(raised);
        }
        let before = state();
        let calls: [(&str, fn()); 9] = [
            ("glClearColor", || glClearColor(0.1, 0.2, 0.3, 0.4)),
            ("glColor4d", || glColor4d(0.1, 1e-300, 1e300, 0.1)),
            ("glRotated", || glRotated(33.0, 0.1, 0.2, 0.3)),
            ("glBegin", || glBegin(gl_api::GL_TRIANGLES)),
            ("glVertex2d", || glVertex2d(-0.9, -0.7)),
            ("glVertex3d", || glVertex3d(0.9, -0.3, 0.1)),
            ("glEnd", || glEnd()),
            ("GLU's quadrics", cylinder_and_disk),
            ("glFinish", || glFinish()),
        ];
        for (name, call) in calls {
            call();
            assert_eq!(state(), before, "{name}");
        }
        if raised == 0 {
            assert_eq!(state().0, control);
        }
    }
}

thread_local! {
    static CONTROL: Cell<u64> = const { Cell::new(u64::MAX) };
}

fn callbacks_run_in_the_hosts_state() {
    extern "C" fn message(
        _source: GLenum,
        _ty: GLenum,
        _id: u32,
        _severity: GLenum,
        _length: i32,
        _text: *const c_char,
        _user: *const c_void,
    ) {
        CONTROL.set(state().0);
        // A call within the callback leaves its state, too.
        let _ = glGetError();
        assert_eq!(state().0, CONTROL.get());
    }
    thread_local! {
        static AT_ERROR: Cell<u64> = const { Cell::new(u64::MAX) };
    }
    extern "C" fn error(_error: GLenum) {
        AT_ERROR.set(state().0);
        glColor4d(0.1, 0.1, 0.1, 0.1);
        assert_eq!(state().0, AT_ERROR.get());
    }
    flush_denormals();
    call_back(message, error);
    let control = state().0;
    assert_eq!((CONTROL.get(), AT_ERROR.get()), (control, control));
}
