//! Fences: of which display, and with which context (EGL 1.5, section 3.8.1).

use super::*;
use std::ptr::null;

const EGL_SYNC_FENCE: u32 = 0x30F9;
const EGL_BAD_PARAMETER: i32 = 0x300C;
const EGL_CONDITION_SATISFIED: u32 = 0x30F6;

#[test]
fn a_fence_is_of_the_display_whose_context_is_current() {
    let (dpy, config) = display();
    // SAFETY: handles are only looked up; lists are null.
    unsafe {
        let other = eglGetPlatformDisplay(0x31DD, null_mut(), null());
        assert_eq!(eglInitialize(other, null_mut(), null_mut()), 1);
        let context = eglCreateContext(dpy, config, null_mut(), null());
        assert!(eglCreateSync(dpy, EGL_SYNC_FENCE, null()).is_null());
        assert_eq!(eglGetError(), EGL_BAD_MATCH, "without a context");
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), context), 1);
        assert!(eglCreateSync(other, EGL_SYNC_FENCE, null()).is_null());
        assert_eq!(eglGetError(), EGL_BAD_MATCH, "the context is of another display");
        // The extension and EGL 1.5 name another error for a type that does not exist.
        assert!(eglCreateSync(dpy, 77, null()).is_null());
        assert_eq!(eglGetError(), EGL_BAD_PARAMETER);
        assert!(eglCreateSyncKHR(dpy, 77, null()).is_null());
        assert_eq!(eglGetError(), EGL_BAD_ATTRIBUTE);
        let sync = eglCreateSync(dpy, EGL_SYNC_FENCE, null());
        assert_eq!(eglWaitSync(dpy, sync, 0), 1);
        assert_eq!(eglWaitSync(dpy, sync, 1), 0);
        assert_eq!(eglGetError(), EGL_BAD_PARAMETER);
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
        // A client may wait without a context; the server would have nothing to wait with.
        assert_eq!(eglWaitSync(dpy, sync, 0), 0);
        assert_eq!(eglGetError(), EGL_BAD_MATCH);
        assert_eq!(eglClientWaitSync(dpy, sync, 0, 0), EGL_CONDITION_SATISFIED);
        assert_eq!(eglDestroySync(other, sync), 0);
        assert_eq!(eglGetError(), EGL_BAD_PARAMETER);
        assert_eq!(eglDestroySync(dpy, sync), 1);
    }
}

#[test]
fn an_osmesa_context_is_none_of_egls() {
    let (dpy, _) = display();
    let mut memory = [0_u8; 4 * 4 * 4];
    // SAFETY: the memory has 4×4 pixels, and stays until the context is gone.
    unsafe {
        let context = OSMesaCreateContextExt(gl_api::GL_RGBA, 24, 8, 0, null_mut());
        let (memory, byte) = (memory.as_mut_ptr().cast(), gl_api::GL_UNSIGNED_BYTE);
        assert_eq!(OSMesaMakeCurrent(context, memory, byte, 4, 4), 1);
        assert!(eglGetCurrentDisplay().is_null());
        assert!(eglGetCurrentContext().is_null());
        assert!(eglGetCurrentSurface(0x3059).is_null());
        assert!(eglCreateSync(dpy, EGL_SYNC_FENCE, null()).is_null());
        assert_eq!(eglGetError(), EGL_BAD_MATCH);
        assert_eq!(OSMesaGetCurrentContext(), context);
        OSMesaDestroyContext(context);
    }
}
