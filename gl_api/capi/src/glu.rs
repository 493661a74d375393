//! GLU's functions under their C names, for what [`gl_api::glu`] has. What calls the tessellator or
//! NURBS keeps the system's libGLU, and these functions work beside it: a quadric is laid out as
//! libGLU's, since its `gluDisk` calls whichever `gluPartialDisk` the process found first.

use crate::guard::c_functions;
use crate::memory;
use gl_api::glu::{self, GLUquadric, GLUquadricCallback};
use gl_api::host::quadric::{set_callback, set_normals, set_orientation, set_style, tell};
use gl_api::{Data, DataOut, GLboolean, GLenum, GLint, GLsizei, GLuint};
use std::ffi::{CStr, c_char, c_void};

type Quadric = *mut GLUquadric;

/// A matrix or viewport of the client's; zeros for the null pointer.
///
/// # Safety
/// A pointer that is not null has `N` values.
unsafe fn values<T: Copy + Default, const N: usize>(pointer: *const T) -> [T; N] {
    if pointer.is_null() {
        return [T::default(); N];
    }
    // SAFETY: promised by the caller; an array has no stricter alignment, and none is needed.
    unsafe { pointer.cast::<[T; N]>().read_unaligned() }
}

/// Writes coordinates where the client wants them; whether there were any.
///
/// # Safety
/// Pointers that are not null can be written to.
unsafe fn put<const N: usize>(found: Option<[f64; N]>, out: [*mut f64; N]) -> bool {
    for (at, value) in out.into_iter().zip(found.into_iter().flatten()) {
        if !at.is_null() {
            // SAFETY: promised by the caller.
            unsafe { at.write_unaligned(value) };
        }
    }
    found.is_some()
}

/// A quadric of the client's, unless the pointer cannot be one.
///
/// # Safety
/// A pointer that is aligned and not null is a quadric's.
unsafe fn quadric<'a>(pointer: Quadric) -> Option<&'a mut GLUquadric> {
    // SAFETY: promised by the caller.
    if pointer.is_aligned() { unsafe { pointer.as_mut() } } else { None }
}

/// What a quadric of the client's holds: drawing it may call what deletes it.
///
/// # Safety
/// As of [`quadric`].
unsafe fn copied(pointer: Quadric) -> Option<GLUquadric> {
    // SAFETY: promised by the caller.
    unsafe { quadric(pointer) }.copied()
}

/// Text of the client's; empty for the null pointer and for what is no UTF-8.
///
/// # Safety
/// A pointer that is not null ends with a zero.
unsafe fn text<'a>(pointer: *const c_char) -> &'a str {
    if pointer.is_null() {
        return "";
    }
    // SAFETY: promised by the caller.
    unsafe { CStr::from_ptr(pointer) }.to_str().unwrap_or("")
}

/// Words that end with a zero; null where there are none.
fn words(found: Option<&'static str>) -> *const u8 {
    match found {
        Some("") => c"".as_ptr().cast(),
        Some(words) => crate::param::Return::to_c(words),
        None => std::ptr::null(),
    }
}

c_functions! {
    gluGetString(name: GLenum) -> *const u8 { words(glu::gluGetString(name)) }

    gluErrorString(error: GLenum) -> *const u8 { words(glu::gluErrorString(error)) }

    gluCheckExtension(name: *const c_char, list: *const c_char) -> GLboolean {
        glu::gluCheckExtension(text(name), text(list)).into()
    }

    gluOrtho2D(left: f64, right: f64, bottom: f64, top: f64) {
        glu::gluOrtho2D(left, right, bottom, top);
    }

    gluPerspective(fovy: f64, aspect: f64, near: f64, far: f64) {
        glu::gluPerspective(fovy, aspect, near, far);
    }

    gluLookAt(
        eye_x: f64, eye_y: f64, eye_z: f64, center_x: f64, center_y: f64, center_z: f64, up_x: f64,
        up_y: f64, up_z: f64
    ) {
        glu::gluLookAt(eye_x, eye_y, eye_z, center_x, center_y, center_z, up_x, up_y, up_z);
    }

    gluPickMatrix(x: f64, y: f64, width: f64, height: f64, viewport: *mut GLint) {
        glu::gluPickMatrix(x, y, width, height, &values(viewport));
    }

    gluProject(
        x: f64, y: f64, z: f64, model: *const f64, projection: *const f64, viewport: *const GLint,
        win_x: *mut f64, win_y: *mut f64, win_z: *mut f64
    ) -> GLuint {
        let (model, projection, viewport) = (values(model), values(projection), values(viewport));
        let found = glu::gluProject(x, y, z, &model, &projection, &viewport);
        put(found, [win_x, win_y, win_z]).into()
    }

    gluUnProject(
        x: f64, y: f64, z: f64, model: *const f64, projection: *const f64, viewport: *const GLint,
        obj_x: *mut f64, obj_y: *mut f64, obj_z: *mut f64
    ) -> GLuint {
        let (model, projection, viewport) = (values(model), values(projection), values(viewport));
        let found = glu::gluUnProject(x, y, z, &model, &projection, &viewport);
        put(found, [obj_x, obj_y, obj_z]).into()
    }

    gluUnProject4(
        x: f64, y: f64, z: f64, clip_w: f64, model: *const f64, projection: *const f64,
        viewport: *const GLint, near: f64, far: f64, obj_x: *mut f64, obj_y: *mut f64,
        obj_z: *mut f64, obj_w: *mut f64
    ) -> GLuint {
        let (model, projection, viewport) = (values(model), values(projection), values(viewport));
        let found =
            glu::gluUnProject4(x, y, z, clip_w, &model, &projection, &viewport, near, far);
        put(found, [obj_x, obj_y, obj_z, obj_w]).into()
    }

    gluScaleImage(
        format: GLenum, w_in: GLsizei, h_in: GLsizei, type_in: GLenum, data_in: *const c_void,
        w_out: GLsizei, h_out: GLsizei, type_out: GLenum, data_out: *mut c_void
    ) -> GLenum {
        let from = Data::Client(memory::pointer(data_in.cast()));
        let to = DataOut::Client(memory::pointer(data_out.cast_const().cast()));
        glu::gluScaleImage(format, w_in, h_in, type_in, from, w_out, h_out, type_out, to)
    }

    gluBuild1DMipmaps(
        target: GLenum, internal: GLint, width: GLsizei, format: GLenum, ty: GLenum,
        data: *const c_void
    ) -> GLenum {
        let data = Data::Client(memory::pointer(data.cast()));
        glu::gluBuild1DMipmaps(target, internal, width, format, ty, data)
    }

    gluBuild2DMipmaps(
        target: GLenum, internal: GLint, width: GLsizei, height: GLsizei, format: GLenum,
        ty: GLenum, data: *const c_void
    ) -> GLenum {
        let data = Data::Client(memory::pointer(data.cast()));
        glu::gluBuild2DMipmaps(target, internal, width, height, format, ty, data)
    }

    gluBuild3DMipmaps(
        target: GLenum, internal: GLint, width: GLsizei, height: GLsizei, depth: GLsizei,
        format: GLenum, ty: GLenum, data: *const c_void
    ) -> GLenum {
        let data = Data::Client(memory::pointer(data.cast()));
        glu::gluBuild3DMipmaps(target, internal, width, height, depth, format, ty, data)
    }

    gluBuild1DMipmapLevels(
        target: GLenum, internal: GLint, width: GLsizei, format: GLenum, ty: GLenum, level: GLint,
        base: GLint, max: GLint, data: *const c_void
    ) -> GLenum {
        let data = Data::Client(memory::pointer(data.cast()));
        glu::gluBuild1DMipmapLevels(target, internal, width, format, ty, level, base, max, data)
    }

    gluBuild2DMipmapLevels(
        target: GLenum, internal: GLint, width: GLsizei, height: GLsizei, format: GLenum,
        ty: GLenum, level: GLint, base: GLint, max: GLint, data: *const c_void
    ) -> GLenum {
        let data = Data::Client(memory::pointer(data.cast()));
        glu::gluBuild2DMipmapLevels(
            target, internal, width, height, format, ty, level, base, max, data,
        )
    }

    gluBuild3DMipmapLevels(
        target: GLenum, internal: GLint, width: GLsizei, height: GLsizei, depth: GLsizei,
        format: GLenum, ty: GLenum, level: GLint, base: GLint, max: GLint, data: *const c_void
    ) -> GLenum {
        let data = Data::Client(memory::pointer(data.cast()));
        glu::gluBuild3DMipmapLevels(
            target, internal, width, height, depth, format, ty, level, base, max, data,
        )
    }

    gluNewQuadric() -> *mut c_void {
        Box::into_raw(Box::new(glu::gluNewQuadric())).cast()
    }

    gluDeleteQuadric(quad: Quadric) {
        if !quad.is_null() && quad.is_aligned() {
            // From gluNewQuadric, as the prototype says, and not used again.
            drop(Box::from_raw(quad));
        }
    }

    gluQuadricNormals(quad: Quadric, normal: GLenum) {
        // Told when nothing is borrowed: the callback may delete the quadric.
        tell(quadric(quad).and_then(|quad| set_normals(quad, normal)));
    }

    gluQuadricTexture(quad: Quadric, texture: GLboolean) {
        if let Some(quad) = quadric(quad) {
            glu::gluQuadricTexture(quad, texture);
        }
    }

    gluQuadricOrientation(quad: Quadric, orientation: GLenum) {
        tell(quadric(quad).and_then(|quad| set_orientation(quad, orientation)));
    }

    gluQuadricDrawStyle(quad: Quadric, draw: GLenum) {
        tell(quadric(quad).and_then(|quad| set_style(quad, draw)));
    }

    gluQuadricCallback(quad: Quadric, which: GLenum, callback: GLUquadricCallback) {
        tell(quadric(quad).and_then(|quad| set_callback(quad, which, callback)));
    }

    gluSphere(quad: Quadric, radius: f64, slices: GLint, stacks: GLint) {
        if let Some(quad) = copied(quad) {
            glu::gluSphere(&quad, radius, slices, stacks);
        }
    }

    gluCylinder(
        quad: Quadric, base: f64, top: f64, height: f64, slices: GLint, stacks: GLint
    ) {
        if let Some(quad) = copied(quad) {
            glu::gluCylinder(&quad, base, top, height, slices, stacks);
        }
    }

    gluDisk(quad: Quadric, inner: f64, outer: f64, slices: GLint, loops: GLint) {
        if let Some(quad) = copied(quad) {
            glu::gluDisk(&quad, inner, outer, slices, loops);
        }
    }

    gluPartialDisk(
        quad: Quadric, inner: f64, outer: f64, slices: GLint, loops: GLint, start: f64, sweep: f64
    ) {
        if let Some(quad) = copied(quad) {
            glu::gluPartialDisk(&quad, inner, outer, slices, loops, start, sweep);
        }
    }
}
