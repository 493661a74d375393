//! EGL images through C: which handles, targets and attributes there are (EGL 1.5, section 3.9; `EGL_KHR_image_base`,
//! `EGL_KHR_gl_image`), and a texture that contexts of two displays have in common.

use super::*;
use std::ptr::{null, without_provenance_mut};

const EGL_BAD_PARAMETER: i32 = 0x300C;
const EGL_GL_TEXTURE_2D: u32 = 0x30B1;
const EGL_GL_TEXTURE_3D: u32 = 0x30B2;
const EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_X: u32 = 0x30B3;
const EGL_GL_RENDERBUFFER: u32 = 0x30B9;
const EGL_GL_TEXTURE_LEVEL: i32 = 0x30BC;
const EGL_GL_TEXTURE_ZOFFSET: i32 = 0x30BD;
const EGL_IMAGE_PRESERVED: i32 = 0x30D2;

unsafe extern "C" {
    fn eglCreateImage(
        dpy: Handle,
        context: Handle,
        target: u32,
        buffer: Handle,
        list: *const isize,
    ) -> Handle;
    fn eglCreateImageKHR(
        dpy: Handle,
        context: Handle,
        target: u32,
        buffer: Handle,
        list: *const i32,
    ) -> Handle;
    fn eglDestroyImage(dpy: Handle, image: Handle) -> u32;
    fn eglDestroyImageKHR(dpy: Handle, image: Handle) -> u32;
    fn glEGLImageTargetTexture2DOES(target: GLenum, image: Handle);
    fn glGetTexImage(target: GLenum, level: i32, format: GLenum, ty: GLenum, out: *mut c_void);
}

/// A new context of a display, current on this thread without a surface.
fn context(dpy: Handle) -> Handle {
    // SAFETY: handles are only looked up; lists are null.
    unsafe {
        let context = eglCreateContext(dpy, null_mut(), null_mut(), null());
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), context), 1);
        context
    }
}

/// A texture of one texel, which is current.
fn texture(texel: [u8; 4]) -> u32 {
    let mut name = 0;
    // SAFETY: one name; a texel of four bytes.
    unsafe {
        glGenTextures(1, &mut name);
        glBindTexture(gl_api::GL_TEXTURE_2D, name);
        glTexImage2D(
            gl_api::GL_TEXTURE_2D,
            0,
            gl_api::GL_RGBA8 as i32,
            1,
            1,
            0,
            gl_api::GL_RGBA,
            gl_api::GL_UNSIGNED_BYTE,
            texel.as_ptr().cast(),
        );
    }
    name
}

fn buffer(name: u32) -> Handle {
    without_provenance_mut(name as usize)
}

#[test]
fn contexts_of_two_displays_have_a_texture_in_common() {
    let (dpy, _) = display();
    // SAFETY: handles are only looked up; lists end with EGL_NONE; a texel has four bytes.
    unsafe {
        let other = eglGetPlatformDisplay(0x31DD, null_mut(), null());
        assert_eq!(eglInitialize(other, null_mut(), null_mut()), 1);
        let first = context(dpy);
        let name = texture([1, 2, 3, 4]);
        let list = [EGL_IMAGE_PRESERVED, 1, EGL_GL_TEXTURE_LEVEL, 0, EGL_NONE];
        let image = eglCreateImageKHR(dpy, first, EGL_GL_TEXTURE_2D, buffer(name), list.as_ptr());
        assert_eq!(eglGetError(), EGL_SUCCESS);
        let second = context(other);
        texture([9; 4]);
        glEGLImageTargetTexture2DOES(gl_api::GL_TEXTURE_2D, image);
        assert_eq!(glGetError(), gl_api::GL_NO_ERROR);
        let mut texel = [0_u8; 4];
        glGetTexImage(
            gl_api::GL_TEXTURE_2D,
            0,
            gl_api::GL_RGBA,
            gl_api::GL_UNSIGNED_BYTE,
            (&raw mut texel).cast(),
        );
        assert_eq!(texel, [1, 2, 3, 4]);
        // Of the display that it was made with.
        assert_eq!(eglDestroyImageKHR(other, image), 0);
        assert_eq!(eglGetError(), EGL_BAD_PARAMETER);
        assert_eq!(eglDestroyImageKHR(dpy, image), 1);
        assert_eq!(eglDestroyImage(dpy, image), 0);
        assert_eq!(eglGetError(), EGL_BAD_PARAMETER);
        glEGLImageTargetTexture2DOES(gl_api::GL_TEXTURE_2D, image);
        assert_eq!(glGetError(), gl_api::GL_INVALID_VALUE);
        assert_eq!(eglMakeCurrent(other, null_mut(), null_mut(), null_mut()), 1);
        assert_eq!((eglDestroyContext(dpy, first), eglDestroyContext(other, second)), (1, 1));
    }
}

/// Display, context, target and buffer, the attributes without their end, and the error.
type Case<'a> = (Handle, Handle, u32, Handle, &'a [i32], i32);

#[test]
fn what_no_image_is_made_of() {
    let (dpy, _) = display();
    let current = context(dpy);
    let name = texture([0; 4]);
    let cases: &[Case<'_>] = &[
        (null_mut(), current, EGL_GL_TEXTURE_2D, buffer(name), &[], EGL_BAD_DISPLAY),
        (dpy, null_mut(), EGL_GL_TEXTURE_2D, buffer(name), &[], EGL_BAD_CONTEXT),
        (dpy, buffer(3), EGL_GL_TEXTURE_2D, buffer(name), &[], EGL_BAD_CONTEXT),
        (dpy, current, 77, buffer(name), &[], EGL_BAD_PARAMETER),
        (dpy, current, EGL_GL_TEXTURE_2D, buffer(0), &[], EGL_BAD_PARAMETER),
        (dpy, current, EGL_GL_TEXTURE_2D, buffer(999), &[], EGL_BAD_PARAMETER),
        (dpy, current, EGL_GL_TEXTURE_3D, buffer(name), &[], EGL_BAD_PARAMETER),
        (dpy, current, EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_X, buffer(name), &[], EGL_BAD_PARAMETER),
        (dpy, current, EGL_GL_RENDERBUFFER, buffer(name), &[], EGL_BAD_PARAMETER),
        (dpy, current, EGL_GL_TEXTURE_2D, buffer(name), &[77, 1], EGL_BAD_PARAMETER),
        (
            dpy,
            current,
            EGL_GL_TEXTURE_2D,
            buffer(name),
            &[EGL_GL_TEXTURE_ZOFFSET, 0],
            EGL_BAD_PARAMETER,
        ),
        (
            dpy,
            current,
            EGL_GL_RENDERBUFFER,
            buffer(name),
            &[EGL_GL_TEXTURE_LEVEL, 0],
            EGL_BAD_PARAMETER,
        ),
        (
            dpy,
            current,
            EGL_GL_TEXTURE_2D,
            buffer(name),
            &[EGL_IMAGE_PRESERVED, 2],
            EGL_BAD_PARAMETER,
        ),
        (dpy, current, EGL_GL_TEXTURE_2D, buffer(name), &[EGL_GL_TEXTURE_LEVEL, 1], EGL_BAD_MATCH),
        (dpy, current, EGL_GL_TEXTURE_2D, buffer(name), &[EGL_GL_TEXTURE_LEVEL, -1], EGL_BAD_MATCH),
    ];
    for (row, &(dpy, context, target, buffer, pairs, error)) in cases.iter().enumerate() {
        let ints: Vec<i32> = pairs.iter().copied().chain([EGL_NONE]).collect();
        let attributes: Vec<isize> = ints.iter().map(|value| *value as isize).collect();
        // SAFETY: handles are only looked up; lists end with EGL_NONE.
        unsafe {
            let khr = eglCreateImageKHR(dpy, context, target, buffer, ints.as_ptr());
            assert_eq!((khr.is_null(), eglGetError()), (true, error), "row {row}");
            let image = eglCreateImage(dpy, context, target, buffer, attributes.as_ptr());
            assert_eq!((image.is_null(), eglGetError()), (true, error), "row {row}");
        }
    }
    // SAFETY: handles are only looked up; lists are null.
    unsafe {
        let image = eglCreateImage(dpy, current, EGL_GL_TEXTURE_2D, buffer(name), null());
        assert!(!image.is_null());
        let second = eglCreateImage(dpy, current, EGL_GL_TEXTURE_2D, buffer(name), null());
        assert_eq!((second.is_null(), eglGetError()), (true, EGL_BAD_ACCESS));
        assert_eq!(eglDestroyImage(null_mut(), image), 0);
        assert_eq!(eglGetError(), EGL_BAD_DISPLAY);
        assert_eq!(eglDestroyImage(dpy, image), 1);
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
        assert_eq!(eglDestroyContext(dpy, current), 1);
    }
}
