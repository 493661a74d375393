//! The C ABI as C programs use it: by the addresses that `eglGetProcAddress` gives.
#![allow(unsafe_code, reason = "calls C functions")]

mod configs;
mod current;
mod glu;
mod glx;
mod handles;
mod images;
mod info;
mod lengths;
mod memory;
mod osmesa;
mod stack;
mod syncs;
mod threads;
mod unread;

use gl_api::{COMMANDS, GLenum, implemented};
use std::collections::BTreeSet;
use std::ffi::{CStr, c_char, c_void};
use std::ptr::null_mut;

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
    fn eglTerminate(dpy: Handle) -> u32;
    fn eglGetPlatformDisplay(platform: u32, native: Handle, list: *const isize) -> Handle;
    fn eglQueryString(dpy: Handle, name: i32) -> *const c_char;
    fn eglQueryDevicesEXT(max: i32, devices: *mut Handle, number: *mut i32) -> u32;
    fn eglGetConfigAttrib(dpy: Handle, config: Handle, name: i32, value: *mut i32) -> u32;
    fn eglSurfaceAttrib(dpy: Handle, surface: Handle, name: i32, value: i32) -> u32;
    fn eglSwapBuffers(dpy: Handle, surface: Handle) -> u32;
    fn eglCopyBuffers(dpy: Handle, surface: Handle, target: Handle) -> u32;
    fn eglQuerySurface(dpy: Handle, surface: Handle, name: i32, value: *mut i32) -> u32;
    fn eglGetCurrentSurface(which: i32) -> Handle;
    fn eglQueryContext(dpy: Handle, context: Handle, name: i32, value: *mut i32) -> u32;
    fn eglGetCurrentContext() -> Handle;
    fn eglGetCurrentDisplay() -> Handle;
    fn eglCreateSync(dpy: Handle, ty: u32, list: *const isize) -> Handle;
    fn eglCreateSyncKHR(dpy: Handle, ty: u32, list: *const i32) -> Handle;
    fn eglWaitSync(dpy: Handle, sync: Handle, flags: i32) -> u32;
    fn eglClientWaitSync(dpy: Handle, sync: Handle, flags: i32, timeout: u64) -> u32;
    fn eglDestroySync(dpy: Handle, sync: Handle) -> u32;
    fn eglGetProcAddress(name: *const c_char) -> *const c_void;
    fn glGetString(name: GLenum) -> *const c_char;
    fn glGetError() -> GLenum;
    fn glClearColor(r: f32, g: f32, b: f32, a: f32);
    fn glBegin(mode: GLenum);
    fn glClear(mask: u32);
    fn glDisable(cap: GLenum);
    fn glEnable(cap: GLenum);
    fn glTexImage2D(
        target: GLenum,
        level: i32,
        internal: i32,
        width: i32,
        height: i32,
        border: i32,
        format: GLenum,
        ty: GLenum,
        pixels: *const c_void,
    );
    fn glPixelStorei(pname: GLenum, value: i32);
    fn glGetDebugMessageLog(
        count: u32,
        room: i32,
        sources: *mut GLenum,
        types: *mut GLenum,
        ids: *mut u32,
        severities: *mut GLenum,
        lengths: *mut i32,
        text: *mut c_char,
    ) -> u32;
    fn glGetIntegerv(pname: GLenum, values: *mut i32);
    fn glFinish();
    fn glBlendFunc(from: GLenum, to: GLenum);
    fn glColor4f(r: f32, g: f32, b: f32, a: f32);
    fn glRectf(x1: f32, y1: f32, x2: f32, y2: f32);
    fn glScissor(x: i32, y: i32, width: i32, height: i32);
    fn glReadPixels(x: i32, y: i32, w: i32, h: i32, f: GLenum, t: GLenum, out: *mut c_void);
    fn glCopyPixels(x: i32, y: i32, w: i32, h: i32, what: GLenum);
    fn glRasterPos2f(x: f32, y: f32);
    fn glColorTable(t: GLenum, i: GLenum, w: i32, f: GLenum, ty: GLenum, table: *const c_void);
    fn glGenTextures(n: i32, names: *mut u32);
    fn glShaderSource(s: u32, n: i32, strings: *const *const c_char, lengths: *const i32);
    fn glBindTexture(target: GLenum, name: u32);
    fn glIsEnabled(cap: GLenum) -> u8;
    fn glIsTexture(name: u32) -> u8;
    fn OSMesaCreateContextExt(f: GLenum, d: i32, s: i32, a: i32, share: Handle) -> Handle;
    fn OSMesaMakeCurrent(c: Handle, buffer: *mut c_void, ty: GLenum, w: i32, h: i32) -> u8;
    fn OSMesaDestroyContext(c: Handle);
    fn OSMesaGetCurrentContext() -> Handle;
    fn OSMesaPixelStore(name: i32, value: i32);
}

const EGL_SUCCESS: i32 = 0x3000;
const EGL_BAD_ACCESS: i32 = 0x3002;
const EGL_BAD_ATTRIBUTE: i32 = 0x3004;
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
        assert_eq!(detgl::get_proc_address(name).is_null(), !names.contains(name), "{name}");
    }
    use gl_api::availability::{Api, Version};
    let of = |api, version, name| !detgl::get_proc_address_of(api, version, name).is_null();
    for (name, core, es2) in [
        ("glClear", true, true),
        ("glBegin", false, false),
        ("glGenVertexArrays", true, false),
        // By extensions.
        ("glDrawArraysInstancedARB", true, false),
        ("glDrawArraysInstancedEXT", true, true),
        ("glDoesNotExist", false, false),
    ] {
        assert_eq!(of(Api::Core, Version::new(3, 3), name), core, "{name}");
        assert_eq!(of(Api::Es2, Version::new(2, 0), name), es2, "{name}");
    }
    for (name, there) in [
        (c"glClear", true),
        (c"eglMakeCurrent", true),
        (c"eglGetProcAddress", true),
        (c"OSMesaMakeCurrent", true),
        (c"glDoesNotExist", false),
        (c"glColorTable", false),
        (c"", false),
    ] {
        // SAFETY: a string that a zero ends.
        assert_eq!(!unsafe { eglGetProcAddress(name.as_ptr()) }.is_null(), there, "{name:?}");
    }
}

/// The first pixel of what is read from.
fn pixel() -> [u8; 4] {
    let mut pixel = [0_u8; 4];
    // SAFETY: one pixel of four bytes.
    unsafe {
        glReadPixels(
            0,
            0,
            1,
            1,
            gl_api::GL_RGBA,
            gl_api::GL_UNSIGNED_BYTE,
            (&raw mut pixel).cast(),
        );
    }
    pixel
}

/// A context that is current on this thread, with what there is to be said of calls.
fn logging() {
    let (dpy, config) = display();
    // SAFETY: every pointer is null or a local list that ends with EGL_NONE.
    unsafe {
        let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
        let context = eglCreateContext(dpy, config, null_mut(), null_mut());
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
        glEnable(gl_api::GL_DEBUG_OUTPUT);
    }
}

/// Takes a message, if there is one.
fn message() -> Option<String> {
    let mut text = vec![0_u8; 4096];
    let none: Handle = null_mut();
    // SAFETY: as many bytes as it says.
    let taken = unsafe {
        glGetDebugMessageLog(
            1,
            4096,
            none.cast(),
            none.cast(),
            none.cast(),
            none.cast(),
            none.cast(),
            text.as_mut_ptr().cast(),
        )
    };
    let text = CStr::from_bytes_until_nul(&text).expect("ends with zero");
    (taken == 1).then(|| text.to_string_lossy().into_owned())
}

#[test]
fn rows_that_may_be_packed_are_told_of() {
    logging();
    let image = |width, height, format| {
        let pixels = [0_u8; 64];
        // SAFETY: the rows take no more bytes than there are, padded or not.
        unsafe {
            let (target, ty) = (gl_api::GL_TEXTURE_2D, gl_api::GL_UNSIGNED_BYTE);
            let pixels = pixels.as_ptr().cast();
            glTexImage2D(target, 0, gl_api::GL_RGB as i32, width, height, 0, format, ty, pixels);
        }
    };
    let (rgb, rgba) = (gl_api::GL_RGB, gl_api::GL_RGBA);
    image(3, 1, rgb);
    image(4, 3, rgb);
    image(3, 3, rgba);
    assert_eq!(message(), None, "nothing is padded");
    image(3, 3, rgb);
    let text = "glTexImage: rows of 9 bytes are read 12 apart, as GL_UNPACK_ALIGNMENT is 4: if they \
                are packed, call glPixelStorei(GL_UNPACK_ALIGNMENT, 1)";
    assert_eq!(message().as_deref(), Some(text));
    // SAFETY: no pointers.
    unsafe { glPixelStorei(gl_api::GL_UNPACK_ALIGNMENT, 1) };
    image(1, 3, rgb);
    // SAFETY: no pointers.
    unsafe { glPixelStorei(gl_api::GL_UNPACK_ALIGNMENT, 2) };
    image(3, 3, rgb);
    assert_eq!(message(), None, "said so");
}

/// Fills what is drawn to.
fn fill([r, g, b]: [f32; 3]) {
    // SAFETY: no pointers.
    unsafe {
        glClearColor(r, g, b, 1.0);
        glClear(gl_api::GL_COLOR_BUFFER_BIT);
    }
}

#[test]
fn the_imaging_subset_has_names_alone() {
    let (dpy, config) = display();
    // SAFETY: handles are only looked up; the table is not read.
    unsafe {
        // Without a context it is ignored, as every call.
        glColorTable(0, 0, 0, 0, 0, std::ptr::null());
        let context = eglCreateContext(dpy, config, null_mut(), std::ptr::null());
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), context), 1);
        glColorTable(0, 0, 0, 0, 0, std::ptr::null());
        assert_eq!(glGetError(), gl_api::GL_INVALID_OPERATION);
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
    }
}
