//! Handles that are null, freed, made up or of something else, and pointers that are misaligned.

use super::*;
use std::ffi::c_char;
use std::ptr::{null, without_provenance_mut};

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
fn null_and_misaligned_pointers_are_no_harm() {
    let (dpy, config) = display();
    // One byte off what C's types need.
    let mut memory = [0_u32; 16];
    let off = memory.as_mut_ptr().cast::<u8>().wrapping_add(1);
    let mut list = [0_u8; 13];
    for (at, value) in [0x3057_i32, 4, EGL_NONE].iter().enumerate() {
        list[1 + at * 4..][..4].copy_from_slice(&value.to_ne_bytes());
    }
    // SAFETY: what is misaligned is large enough; null pointers are looked for.
    unsafe {
        assert_eq!(eglGetConfigAttrib(dpy, config, 0x3024, off.cast()), 1);
        assert_eq!(off.cast::<i32>().read_unaligned(), 8);
        assert_eq!(eglGetConfigAttrib(dpy, config, 0x3024, null_mut()), 0);
        assert_eq!(eglGetError(), 0x300C);
        assert!(!eglCreatePbufferSurface(dpy, config, list.as_ptr().add(1).cast()).is_null());
        assert_eq!(eglChooseConfig(dpy, null(), off.cast(), 1, off.add(8).cast()), 1);
        assert_eq!(eglChooseConfig(dpy, null(), off.cast(), 1, null_mut()), 0);
        assert_eq!(eglGetError(), 0x300C);
        assert_eq!(eglChooseConfig(dpy, null(), null_mut(), -1, off.cast()), 1);
        assert!(eglGetProcAddress(null()).is_null());
        let context = eglCreateContext(dpy, config, null_mut(), null());
        let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
        // GL's own pointers: misaligned ones work, null ones are refused or ignored.
        fill([1.0, 1.0, 1.0]);
        let (rgba, float) = (gl_api::GL_RGBA, gl_api::GL_FLOAT);
        glReadPixels(0, 0, 1, 1, rgba, float, off.cast());
        assert_eq!(off.cast::<f32>().read_unaligned(), 1.0);
        glReadPixels(0, 0, 1, 1, rgba, float, null_mut());
        glGenTextures(1, off.cast());
        assert_ne!(off.cast::<u32>().read_unaligned(), 0);
        let _ = glGetError();
        // The strings of what is no shader are not looked at.
        let garbage: [*const c_char; 1] = [std::ptr::without_provenance(5)];
        glShaderSource(99, 1, garbage.as_ptr(), null());
        assert_eq!(glGetError(), gl_api::GL_INVALID_VALUE);
        glGenTextures(1, null_mut());
        assert_ne!(glGetError(), gl_api::GL_NO_ERROR);
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
    }
}
