//! The C ABI as C programs use it: by the addresses that `eglGetProcAddress` gives.
#![allow(unsafe_code, reason = "calls C functions")]

use gl_api::{
    COMMANDS, Context, GL_COLOR_BUFFER_BIT, GL_FLOAT, GL_NO_ERROR, GL_RGBA, GL_UNSIGNED_BYTE,
    GL_UNSIGNED_SHORT, GL_VERSION, GLenum, implemented,
};
use std::collections::BTreeSet;
use std::ffi::{CStr, c_char, c_void};
use std::ptr::{null, null_mut, without_provenance_mut};

type Handle = *mut c_void;

unsafe extern "C" {
    fn eglGetError() -> i32;
    fn eglGetDisplay(native: Handle) -> Handle;
    fn eglInitialize(dpy: Handle, major: *mut i32, minor: *mut i32) -> u32;
    fn eglBindAPI(api: u32) -> u32;
    fn eglChooseConfig(dpy: Handle, list: *const i32, out: *mut Handle, n: i32, k: *mut i32)
    -> u32;
    fn eglCreatePbufferSurface(dpy: Handle, config: Handle, list: *const i32) -> Handle;
    fn eglCreateContext(dpy: Handle, config: Handle, share: Handle, list: *const i32) -> Handle;
    fn eglMakeCurrent(dpy: Handle, draw: Handle, read: Handle, context: Handle) -> u32;
    fn eglDestroyContext(dpy: Handle, context: Handle) -> u32;
    fn eglDestroySurface(dpy: Handle, surface: Handle) -> u32;
    fn eglGetProcAddress(name: *const c_char) -> *const c_void;
    fn glGetString(name: GLenum) -> *const c_char;
    fn glGetError() -> GLenum;
    fn glClearColor(r: f32, g: f32, b: f32, a: f32);
    fn glClear(mask: u32);
    fn glFinish();
    fn OSMesaCreateContextExt(f: GLenum, d: i32, s: i32, a: i32, share: Handle) -> Handle;
    fn OSMesaMakeCurrent(c: Handle, buffer: *mut c_void, ty: GLenum, w: i32, h: i32) -> u8;
    fn OSMesaDestroyContext(c: Handle);
}

const EGL_SUCCESS: i32 = 0x3000;
const EGL_BAD_ACCESS: i32 = 0x3002;
const EGL_BAD_CONFIG: i32 = 0x3005;
const EGL_BAD_CONTEXT: i32 = 0x3006;
const EGL_BAD_DISPLAY: i32 = 0x3008;
const EGL_BAD_MATCH: i32 = 0x3009;
const EGL_BAD_SURFACE: i32 = 0x300D;
const EGL_NONE: i32 = 0x3038;
const EGL_OPENGL_API: u32 = 0x30A2;
const EGL_OPENGL_ES_API: u32 = 0x30A0;
const SURFACE: [i32; 5] = [0x3057, 4, 0x3056, 4, EGL_NONE];

/// An initialized display, a config, and OpenGL bound.
fn display() -> (Handle, Handle) {
    let mut config = null_mut();
    let mut number = 0;
    let wanted = [0x3033, 1, 0x3040, 8, 0x3025, 24, 0x3026, 8, EGL_NONE];
    // SAFETY: every pointer is a local that is large enough.
    unsafe {
        let dpy = eglGetDisplay(null_mut());
        assert_eq!(eglInitialize(dpy, null_mut(), null_mut()), 1);
        assert_eq!(eglBindAPI(EGL_OPENGL_API), 1);
        assert_eq!(eglChooseConfig(dpy, wanted.as_ptr(), &mut config, 1, &mut number), 1);
        assert_eq!(number, 1);
        (dpy, config)
    }
}

#[test]
fn every_name_has_an_address_and_no_other_has() {
    let names: BTreeSet<&str> = implemented().map(|(name, _)| name).collect();
    for (name, _) in COMMANDS {
        assert_eq!(Context::get_proc_address(name).is_null(), !names.contains(name), "{name}");
    }
    for (name, there) in [
        (c"glClear", true),
        (c"eglMakeCurrent", true),
        (c"eglGetProcAddress", true),
        (c"OSMesaMakeCurrent", true),
        (c"glDoesNotExist", false),
        (c"", false),
    ] {
        // SAFETY: a string that a zero ends.
        assert_eq!(!unsafe { eglGetProcAddress(name.as_ptr()) }.is_null(), there, "{name:?}");
    }
}

#[test]
fn hostile_handles_have_their_errors() {
    let (dpy, config) = display();
    let none = null_mut();
    let made_up = without_provenance_mut::<c_void>(0xDEAD_BEE1);
    // SAFETY: handles are only looked up.
    unsafe {
        let context = eglCreateContext(dpy, config, none, null());
        let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
        assert!(!context.is_null() && !surface.is_null());
        let gone = eglCreateContext(dpy, none, none, null());
        assert_eq!(eglDestroyContext(dpy, gone), 1);
        assert_eq!(eglMakeCurrent(made_up, surface, surface, context), 0);
        assert_eq!(eglGetError(), EGL_BAD_DISPLAY);
        type Case = (&'static str, Handle, Handle, Handle, i32);
        let cases: [Case; 6] = [
            ("freed context", surface, surface, gone, EGL_BAD_CONTEXT),
            ("context made up", surface, surface, made_up, EGL_BAD_CONTEXT),
            ("surface as context", surface, surface, surface, EGL_BAD_CONTEXT),
            ("surface made up", made_up, made_up, context, EGL_BAD_SURFACE),
            ("one surface", surface, none, context, EGL_BAD_MATCH),
            ("surface alone", surface, surface, none, EGL_BAD_MATCH),
        ];
        for (what, draw, read, context, error) in cases {
            assert_eq!(eglMakeCurrent(dpy, draw, read, context), 0, "{what}");
            assert_eq!(eglGetError(), error, "{what}");
        }
        assert!(eglCreateContext(dpy, made_up, none, null()).is_null());
        assert_eq!(eglGetError(), EGL_BAD_CONFIG);
        assert_eq!(eglDestroyContext(dpy, context), 1);
        assert_eq!(eglDestroySurface(dpy, surface), 1);
        assert_eq!(eglDestroySurface(dpy, surface), 0);
        assert_eq!(eglGetError(), EGL_BAD_SURFACE);
        assert_eq!(eglGetError(), EGL_SUCCESS);
    }
}

#[test]
fn versions_that_are_not_there_are_refused() {
    let (dpy, config) = display();
    for (major, minor, there) in
        [(1, 0, true), (1, 5, true), (2, 1, true), (2, 2, false), (3, 0, false), (3, 2, false)]
    {
        let list = [0x3098, major, 0x30FB, minor, EGL_NONE];
        // SAFETY: the list ends with EGL_NONE.
        unsafe {
            let context = eglCreateContext(dpy, config, null_mut(), list.as_ptr());
            assert_eq!(!context.is_null(), there, "{major}.{minor}");
            assert_eq!(eglGetError(), if there { EGL_SUCCESS } else { EGL_BAD_MATCH });
            eglDestroyContext(dpy, context);
        }
    }
    // SAFETY: no pointers.
    assert_eq!(unsafe { eglBindAPI(EGL_OPENGL_ES_API) }, 0);
}

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
        assert!(version.to_bytes().starts_with(b"2.1"), "{version:?}");
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

/// The first pixel of a picture cleared to (1, 0.5, 0, 1), as bytes.
fn osmesa(format: GLenum, ty: GLenum, bytes: usize) -> Option<Vec<u8>> {
    let mut memory = vec![0_u8; bytes * 4 * 4];
    // SAFETY: the memory has 4×4 pixels of so many bytes, and stays until the context is gone.
    unsafe {
        let context = OSMesaCreateContextExt(format, 24, 8, 0, null_mut());
        if context.is_null() {
            return None;
        }
        assert_eq!(OSMesaMakeCurrent(context, memory.as_mut_ptr().cast(), ty, 4, 4), 1);
        glClearColor(1.0, 0.5, 0.0, 1.0);
        glClear(GL_COLOR_BUFFER_BIT);
        glFinish();
        OSMesaMakeCurrent(null_mut(), null_mut(), 0, 0, 0);
        OSMesaDestroyContext(context);
    }
    assert!(memory.chunks_exact(bytes).all(|pixel| *pixel == memory[..bytes]));
    Some(memory[..bytes].to_vec())
}

#[test]
fn osmesa_fills_the_clients_memory_in_every_format() {
    for (format, ty, pixel) in [
        (GL_RGBA, GL_UNSIGNED_BYTE, vec![255, 128, 0, 255]),
        (1, GL_UNSIGNED_BYTE, vec![0, 128, 255, 255]),
        (2, GL_UNSIGNED_BYTE, vec![255, 255, 128, 0]),
        (gl_api::GL_RGB, GL_UNSIGNED_BYTE, vec![255, 128, 0]),
        (4, GL_UNSIGNED_BYTE, vec![0, 128, 255]),
        (5, gl_api::GL_UNSIGNED_SHORT_5_6_5, 0xFC00_u16.to_le_bytes().to_vec()),
        (
            GL_RGBA,
            GL_UNSIGNED_SHORT,
            [65535_u16, 32768, 0, 65535].iter().flat_map(|v| v.to_le_bytes()).collect(),
        ),
        (
            GL_RGBA,
            GL_FLOAT,
            [1.0_f32, 0.5, 0.0, 1.0].iter().flat_map(|v| v.to_le_bytes()).collect(),
        ),
        (2, GL_FLOAT, [1.0_f32, 1.0, 0.5, 0.0].iter().flat_map(|v| v.to_le_bytes()).collect()),
    ] {
        assert_eq!(osmesa(format, ty, pixel.len()), Some(pixel), "{format:#x} {ty:#x}");
    }
    assert_eq!(osmesa(gl_api::GL_COLOR_INDEX, GL_UNSIGNED_BYTE, 1), None);
}
