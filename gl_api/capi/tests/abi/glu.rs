//! GLU under its C names.

use super::*;
use std::ffi::CStr;

unsafe extern "C" {
    fn gluGetString(name: GLenum) -> *const c_char;
    fn gluErrorString(error: GLenum) -> *const c_char;
    fn gluNewQuadric() -> Handle;
    fn gluDeleteQuadric(quad: Handle);
    fn gluQuadricCallback(quad: Handle, which: GLenum, callback: Option<extern "C" fn(GLenum)>);
    fn gluQuadricDrawStyle(quad: Handle, style: GLenum);
    fn gluQuadricNormals(quad: Handle, normals: GLenum);
    fn gluQuadricOrientation(quad: Handle, orientation: GLenum);
    fn gluSphere(quad: Handle, radius: f64, slices: i32, stacks: i32);
    fn gluBuild2DMipmaps(
        t: GLenum,
        i: i32,
        w: i32,
        h: i32,
        f: GLenum,
        ty: GLenum,
        p: Handle,
    ) -> u32;
    fn gluUnProject(
        x: f64,
        y: f64,
        z: f64,
        model: *const f64,
        projection: *const f64,
        viewport: *const i32,
        out_x: *mut f64,
        out_y: *mut f64,
        out_z: *mut f64,
    ) -> u32;
}

thread_local! {
    static LAST: std::cell::Cell<GLenum> = const { std::cell::Cell::new(0) };
}

extern "C" fn note(error: GLenum) {
    LAST.set(error);
}

#[test]
fn words_and_refusals() {
    // SAFETY: strings are the library's; null pointers are looked for.
    unsafe {
        assert_eq!(CStr::from_ptr(gluGetString(100_800)), c"1.3");
        assert_eq!(CStr::from_ptr(gluGetString(100_801)), c"");
        assert_eq!(CStr::from_ptr(gluErrorString(0x501)), c"invalid value");
        assert!(gluErrorString(666).is_null() && gluGetString(0).is_null());
        let out = null_mut();
        let (matrix, viewport) = ([0.0; 16].as_ptr(), [0; 4].as_ptr());
        assert_eq!(gluUnProject(0.0, 0.0, 0.0, matrix, matrix, viewport, out, out, out), 0);
        let nothing = std::ptr::null();
        let viewport = std::ptr::null();
        assert_eq!(gluUnProject(0.0, 0.0, 0.0, nothing, nothing, viewport, out, out, out), 0);
    }
    let quad: [GLenum; 3] = [gl_api::GL_TEXTURE_2D, gl_api::GL_RGB, gl_api::GL_UNSIGNED_BYTE];
    let [target, format, ty] = quad;
    // SAFETY: nothing is read for sizes that are refused.
    let build = |w, h| unsafe { gluBuild2DMipmaps(target, 3, w, h, format, ty, null_mut()) };
    assert_eq!([build(0, 4), build(-1, 4), build(i32::MAX, i32::MAX)], [100_901, 100_901, 100_902]);
}

#[test]
fn quadrics_tell_of_errors_and_bear_null() {
    // SAFETY: the quadric is GLU's own, or null.
    unsafe {
        let quad = gluNewQuadric();
        gluQuadricCallback(quad, 100_103, Some(note));
        for (what, error, call) in [
            ("radius", 100_901, Some((-1.0, 8, 8))),
            ("slices", 100_901, Some((1.0, 1, 8))),
            ("stacks", 100_901, Some((1.0, 8, 0))),
            ("not a number", 100_901, Some((f64::NAN, 8, 8))),
            ("style", 100_900, None),
        ] {
            LAST.set(0);
            match call {
                Some((radius, slices, stacks)) => gluSphere(quad, radius, slices, stacks),
                None => gluQuadricDrawStyle(quad, 1),
            }
            assert_eq!(LAST.get(), error, "{what}");
        }
        gluDeleteQuadric(quad);
        gluSphere(null_mut(), 1.0, 8, 8);
        gluQuadricDrawStyle(null_mut(), 100_012);
        gluDeleteQuadric(null_mut());
    }
}

thread_local! {
    static DOOMED: std::cell::Cell<Handle> = const { std::cell::Cell::new(null_mut()) };
}

extern "C" fn delete(error: GLenum) {
    LAST.set(error);
    // SAFETY: the quadric is GLU's own, and nobody uses it again.
    unsafe { gluDeleteQuadric(DOOMED.take()) };
}

/// Run by Miri, which knows what is borrowed.
#[test]
fn a_quadric_may_be_deleted_by_its_own_callback() {
    for (call, error) in [(0, 100_900), (1, 100_900), (2, 100_900), (3, 100_900), (4, 100_901)] {
        LAST.set(0);
        // SAFETY: the quadric is GLU's own, and not used once it is deleted.
        unsafe {
            let quad = gluNewQuadric();
            gluQuadricCallback(quad, 100_103, Some(delete));
            DOOMED.set(quad);
            // Each is refused.
            match call {
                0 => gluQuadricNormals(quad, 7),
                1 => gluQuadricOrientation(quad, 7),
                2 => gluQuadricDrawStyle(quad, 7),
                3 => gluQuadricCallback(quad, 7, None),
                _ => gluSphere(quad, -1.0, 8, 8),
            }
        }
        assert_eq!(LAST.get(), error);
        assert!(DOOMED.get().is_null());
    }
}
