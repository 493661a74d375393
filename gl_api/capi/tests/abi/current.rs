//! What is current where: threads, destroyed contexts, two surfaces, shared objects.

use super::*;
use gl_api::{GL_BLEND, GL_COLOR, GL_COLOR_BUFFER_BIT, GL_NO_ERROR, GL_TEXTURE_2D, GL_VERSION};
use std::ffi::CStr;
use std::ptr::{null, without_provenance_mut};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{TryRecvError, channel};

#[test]
fn a_context_is_current_on_one_thread_and_outlives_its_destruction() {
    let (dpy, config) = display();
    // SAFETY: handles are only looked up; strings are the library's.
    unsafe {
        let context = eglCreateContext(dpy, config, null_mut(), null());
        let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
        let handles = [dpy, surface, context].map(|handle| handle.addr());
        let elsewhere = std::thread::spawn(move || {
            let [dpy, surface, context] = handles.map(without_provenance_mut);
            (eglMakeCurrent(dpy, surface, surface, context), eglGetError())
        });
        assert_eq!(elsewhere.join().expect("no panic"), (0, EGL_BAD_ACCESS));
        assert_eq!(eglDestroyContext(dpy, context), 1);
        let version = CStr::from_ptr(glGetString(GL_VERSION));
        assert!(version.to_bytes().starts_with(b"3.3"), "{version:?}");
        glClear(GL_COLOR_BUFFER_BIT);
        assert_eq!(glGetError(), GL_NO_ERROR);
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 0);
        assert_eq!(eglGetError(), EGL_BAD_CONTEXT);
        // A thread that ends with a context gives it back.
        let context = eglCreateContext(dpy, config, null_mut(), null());
        let handles = [dpy, surface, context].map(|handle| handle.addr());
        let ended = std::thread::spawn(move || {
            let [dpy, surface, context] = handles.map(without_provenance_mut);
            eglMakeCurrent(dpy, surface, surface, context)
        });
        assert_eq!(ended.join().expect("no panic"), 1);
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
    }
}

#[test]
fn what_is_drawn_to_need_not_be_what_is_read_from() {
    let (dpy, config) = display();
    let none = null_mut();
    // SAFETY: handles are only looked up.
    unsafe {
        let context = eglCreateContext(dpy, config, none, null());
        let [one, other] = [(); 2].map(|()| eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr()));
        assert_eq!(eglMakeCurrent(dpy, one, one, context), 1);
        fill([1.0, 0.0, 0.0]);
        assert_eq!(eglMakeCurrent(dpy, other, one, context), 1);
        assert_eq!([0x3059, 0x305A].map(|which| eglGetCurrentSurface(which)), [other, one]);
        fill([0.0, 1.0, 0.0]);
        assert_eq!(pixel(), [255, 0, 0, 255], "it is `one` that is read");
        // A copy goes from one to the other.
        glRasterPos2f(-1.0, -1.0);
        glCopyPixels(0, 0, 1, 1, GL_COLOR);
        assert_eq!(eglMakeCurrent(dpy, one, other, context), 1);
        assert_eq!(pixel(), [255, 0, 0, 255], "the copied pixel");
        assert_eq!(eglMakeCurrent(dpy, other, other, context), 1);
        let mut last = [0_u8; 4];
        let (rgba, byte) = (gl_api::GL_RGBA, gl_api::GL_UNSIGNED_BYTE);
        glReadPixels(3, 3, 1, 1, rgba, byte, (&raw mut last).cast());
        assert_eq!(last, [0, 255, 0, 255], "beside it");
        // What is swapped is what is drawn to.
        assert_eq!(eglSwapBuffers(dpy, other), 1);
        assert_eq!(eglSwapBuffers(dpy, one), 0);
        assert_eq!(eglGetError(), EGL_BAD_SURFACE);
        assert_eq!(eglCopyBuffers(dpy, one, none), 0);
        assert_eq!(eglGetError(), 0x300A);
        // Both are in use while they are current, and destroyed after that.
        assert_eq!(eglMakeCurrent(dpy, one, other, context), 1);
        assert_eq!(eglDestroySurface(dpy, other), 1);
        assert_eq!(pixel(), [255, 0, 0, 255]);
        assert_eq!(eglMakeCurrent(dpy, none, none, none), 1);
        assert_eq!(eglSwapBuffers(dpy, one), 0);
        assert_eq!(eglGetError(), EGL_BAD_SURFACE);
        assert_eq!(eglMakeCurrent(dpy, one, other, context), 0);
        assert_eq!(eglGetError(), EGL_BAD_SURFACE);
        assert_eq!(glGetError(), GL_NO_ERROR);
    }
}

/// As libraries of windows do it: a thread that loads makes its own context, while the first one waits for it.
#[test]
fn a_context_shares_with_one_that_is_current_on_a_waiting_thread() {
    let (dpy, config) = display();
    // SAFETY: handles are only looked up; one name goes where there is room for it.
    unsafe {
        let context = eglCreateContext(dpy, config, null_mut(), null());
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), context), 1);
        let mut name = 0;
        glGenTextures(1, &mut name);
        glBindTexture(GL_TEXTURE_2D, name);
        let handles = [dpy, config, context].map(|handle| handle.addr());
        let loader = std::thread::spawn(move || {
            let [dpy, config, context] = handles.map(without_provenance_mut);
            assert_eq!(eglBindAPI(EGL_OPENGL_API), 1);
            let shared = eglCreateContext(dpy, config, context, null());
            assert!(!shared.is_null(), "{:#x}", eglGetError());
            assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), shared), 1);
            assert_eq!(glIsTexture(name), 1);
            glGenTextures(1, &mut name);
            glBindTexture(GL_TEXTURE_2D, name);
            name
        });
        // The first context makes no call until the other has its texture.
        let loaded = loader.join().expect("no panic");
        assert_ne!(loaded, name);
        assert_eq!(glIsTexture(loaded), 1);
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
    }
}

/// How often another thread has asked EGL something.
static QUERIES: AtomicUsize = AtomicUsize::new(0);

#[test]
fn no_thread_waits_for_anothers_frame() {
    let (dpy, config) = display();
    let list = [0x3057, 1024, 0x3056, 1024, EGL_NONE];
    let (stop, stopped) = channel::<()>();
    // SAFETY: handles are only looked up; the list ends with EGL_NONE, the value is a local.
    unsafe {
        let context = eglCreateContext(dpy, config, null_mut(), null());
        let surface = eglCreatePbufferSurface(dpy, config, list.as_ptr());
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
        let handles = [dpy, surface].map(|handle| handle.addr());
        let elsewhere = std::thread::spawn(move || {
            let [dpy, surface] = handles.map(without_provenance_mut);
            let mut width = 0;
            while stopped.try_recv() == Err(TryRecvError::Empty) {
                assert_eq!(eglQuerySurface(dpy, surface, 0x3057, &mut width), 1);
                QUERIES.fetch_add(1, Ordering::Relaxed);
            }
        });
        glEnable(GL_BLEND);
        glBlendFunc(gl_api::GL_SRC_ALPHA, gl_api::GL_ONE_MINUS_SRC_ALPHA);
        for layer in 0..60_u8 {
            glColor4f(f32::from(layer) / 60.0, 0.5, 0.0, 0.1);
            glRectf(-1.0, -1.0, 1.0, 1.0);
        }
        let before = QUERIES.load(Ordering::Relaxed);
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
        let meanwhile = QUERIES.load(Ordering::Relaxed) - before;
        stop.send(()).expect("the other thread listens");
        elsewhere.join().expect("no panic");
        assert!(meanwhile > 50, "{meanwhile} calls while the frame was drawn");
    }
}

#[test]
fn contexts_that_share_report_stopped_draws_alike() {
    const STRATEGY: i32 = 0x31BD;
    const LOSE_CONTEXT: [i32; 3] = [STRATEGY, 0x31BF, EGL_NONE];
    const NO_NOTIFICATION: [i32; 3] = [STRATEGY, 0x31BE, EGL_NONE];
    let (dpy, config) = display();
    // SAFETY: the lists end with EGL_NONE, and handles are only looked up.
    unsafe {
        let silent = eglCreateContext(dpy, config, null_mut(), null());
        let told = eglCreateContext(dpy, config, null_mut(), LOSE_CONTEXT.as_ptr());
        assert!(!silent.is_null() && !told.is_null());
        for (share, attributes) in [(silent, LOSE_CONTEXT), (told, NO_NOTIFICATION)] {
            assert!(eglCreateContext(dpy, config, share, attributes.as_ptr()).is_null());
            assert_eq!(eglGetError(), EGL_BAD_MATCH);
        }
        for (share, attributes) in [(silent, NO_NOTIFICATION), (told, LOSE_CONTEXT)] {
            assert!(!eglCreateContext(dpy, config, share, attributes.as_ptr()).is_null());
            assert_eq!(eglGetError(), EGL_SUCCESS);
        }
    }
}

/// A surface of off-screen pixels keeps its picture, which the next frame draws over (`EGL_BUFFER_PRESERVED`).
#[test]
fn a_swap_keeps_what_was_drawn() {
    const SWAP_BEHAVIOR: i32 = 0x3093;
    const PRESERVED: i32 = 0x3094;
    let (dpy, config) = display();
    // SAFETY: handles are only looked up; the lists end with EGL_NONE, the value is a local.
    unsafe {
        let context = eglCreateContext(dpy, config, null_mut(), null());
        let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
        assert_eq!(eglSurfaceAttrib(dpy, surface, SWAP_BEHAVIOR, PRESERVED), 1);
        let mut behavior = 0;
        assert_eq!(eglQuerySurface(dpy, surface, SWAP_BEHAVIOR, &mut behavior), 1);
        assert_eq!(behavior, PRESERVED);
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
        glClearColor(1.0, 0.0, 0.0, 1.0);
        glClear(GL_COLOR_BUFFER_BIT);
        assert_eq!(eglSwapBuffers(dpy, surface), 1);
        // Green on the right, over the frame before.
        glEnable(gl_api::GL_SCISSOR_TEST);
        glScissor(2, 0, 2, 4);
        glClearColor(0.0, 1.0, 0.0, 1.0);
        glClear(GL_COLOR_BUFFER_BIT);
        assert_eq!(eglSwapBuffers(dpy, surface), 1);
        let mut row = [[0_u8; 4]; 4];
        let (rgba, byte) = (gl_api::GL_RGBA, gl_api::GL_UNSIGNED_BYTE);
        glReadPixels(0, 0, 4, 1, rgba, byte, (&raw mut row).cast());
        let [red, green] = [[255, 0, 0, 255], [0, 255, 0, 255]];
        assert_eq!(row, [red, red, green, green]);
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
    }
}
