//! One line on stderr at the end of the first frame says that there are messages which nobody has read.

use super::*;
use std::process::Command;

/// Which test is to draw, in a process of its own.
const CHILD: &str = "DETGL_TEST_UNREAD";

/// Runs a test of this file in a process of its own, and gives what DetGL said.
fn said(test: &str, debug: Option<&str>) -> Vec<String> {
    let mut child = Command::new(std::env::current_exe().expect("a file"));
    child.args(["--exact", test, "--nocapture"]).env(CHILD, "1");
    match debug {
        Some(value) => child.env("DETGL_DEBUG", value),
        None => child.env_remove("DETGL_DEBUG"),
    };
    let output = child.output().expect("it runs");
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{text}");
    text.lines().filter(|line| line.starts_with("detgl: ")).map(str::to_owned).collect()
}

/// The line is there once, and not with `DETGL_DEBUG=0`.
fn is_said_once(test: &str) {
    let lines = said(test, None);
    assert_eq!(lines.len(), 1, "{lines:?}");
    assert!(
        lines[0].contains("1 error that nobody read; the first, error: glEnable: "),
        "{lines:?}"
    );
    assert!(lines[0].contains("DETGL_DEBUG=1 prints all"), "{lines:?}");
    assert_eq!(said(test, Some("0")), [""; 0]);
}

#[test]
fn a_swap_says_so() {
    if std::env::var_os(CHILD).is_none() {
        return is_said_once("unread::a_swap_says_so");
    }
    let (dpy, config) = display();
    // SAFETY: the list ends with EGL_NONE, and handles are only looked up.
    unsafe {
        let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
        let context = eglCreateContext(dpy, config, null_mut(), null_mut());
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
        glEnable(1);
        for _ in 0..2 {
            assert_eq!(eglSwapBuffers(dpy, surface), 1);
        }
    }
}

#[test]
fn osmesa_says_so_when_it_finishes() {
    if std::env::var_os(CHILD).is_none() {
        return is_said_once("unread::osmesa_says_so_when_it_finishes");
    }
    let mut memory = [0_u8; 4 * 4 * 4];
    // SAFETY: the memory has 4×4 pixels of four bytes, and stays until the context is gone.
    unsafe {
        let context = OSMesaCreateContextExt(gl_api::GL_RGBA, 24, 8, 0, null_mut());
        let ty = gl_api::GL_UNSIGNED_BYTE;
        assert_eq!(OSMesaMakeCurrent(context, memory.as_mut_ptr().cast(), ty, 4, 4), 1);
        glEnable(1);
        glFinish();
        glFinish();
        OSMesaMakeCurrent(null_mut(), null_mut(), 0, 0, 0);
        OSMesaDestroyContext(context);
    }
}

#[test]
fn calls_without_a_context_say_so_once() {
    let test = "unread::calls_without_a_context_say_so_once";
    if std::env::var_os(CHILD).is_none() {
        let lines = said(test, None);
        assert_eq!(lines.len(), 1, "{lines:?}");
        assert!(
            lines[0].starts_with("detgl: glClear: ignored, as this thread has no current context"),
            "{lines:?}"
        );
        assert_eq!(said(test, Some("0")), [""; 0]);
        return;
    }
    // SAFETY: they have no pointers.
    unsafe {
        glClear(0x4000);
        glFinish();
    }
}

/// Draws within a pair of calls, one of which is missing, and reads the picture back: said although that is refused.
fn read_back_is_refused(mistake: fn()) {
    let (dpy, config) = display();
    let mut pixels = [0_u8; 4];
    // SAFETY: the list ends with EGL_NONE, handles are only looked up, and the memory has one pixel.
    unsafe {
        let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
        let context = eglCreateContext(dpy, config, null_mut(), null_mut());
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
        mistake();
        let to = pixels.as_mut_ptr().cast();
        glReadPixels(0, 0, 1, 1, gl_api::GL_RGBA, gl_api::GL_UNSIGNED_BYTE, to);
    }
}

#[test]
fn a_refused_read_back_says_so() {
    let test = "unread::a_refused_read_back_says_so";
    if std::env::var_os(CHILD).is_none() {
        let lines = said(test, None);
        assert_eq!(lines.len(), 1, "{lines:?}");
        assert!(
            lines[0].contains("glReadPixels: must not be called between glBegin and glEnd"),
            "{lines:?}"
        );
        assert_eq!(said(test, Some("0")), [""; 0]);
        return;
    }
    // SAFETY: it has no pointers.
    read_back_is_refused(|| unsafe { glBegin(gl_api::GL_TRIANGLES) });
}
