//! Memory that C has in hand more than once, or has not written to yet. What is wrong here shows under Miri alone.

use super::*;
use gl_api::{
    GL_2D, GL_ACTIVE_UNIFORMS, GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, GL_FEEDBACK, GL_FLOAT,
    GL_FLOAT_VEC4, GL_LUMINANCE, GL_NO_ERROR, GL_READ_WRITE, GL_RENDER, GL_RGBA, GL_SELECT,
    GL_STATIC_DRAW, GL_UNIFORM_SIZE, GL_UNIFORM_TYPE, GL_UNSIGNED_BYTE, GL_VIEWPORT,
};
use lengths::{
    glBindBuffer, glBufferData, glGenBuffers, glGetBufferSubData, glMapBuffer, program,
    with_contexts,
};
use std::mem::MaybeUninit;
use std::ptr::null;

unsafe extern "C" {
    fn glGetBufferPointerv(target: GLenum, pname: GLenum, out: *mut *mut c_void);
    fn glUnmapBuffer(target: GLenum) -> u8;
    fn glSelectBuffer(size: i32, buffer: *mut u32);
    fn glFeedbackBuffer(size: i32, ty: GLenum, buffer: *mut f32);
    fn glRenderMode(mode: GLenum) -> i32;
    fn glRectf(x1: f32, y1: f32, x2: f32, y2: f32);
    fn glGetProgramiv(program: u32, pname: GLenum, out: *mut i32);
    fn glGetActiveUniform(
        program: u32,
        index: u32,
        room: i32,
        length: *mut i32,
        size: *mut i32,
        ty: *mut GLenum,
        name: *mut c_char,
    );
    fn glGetActiveUniformsiv(
        program: u32,
        count: i32,
        indices: *const u32,
        pname: GLenum,
        out: *mut i32,
    );
    fn gluScaleImage(
        format: GLenum,
        width: i32,
        height: i32,
        ty: GLenum,
        data: *const c_void,
        new_width: i32,
        new_height: i32,
        new_type: GLenum,
        new_data: *mut c_void,
    ) -> GLenum;
}

#[test]
fn both_pointers_to_a_mapped_buffer_are_good_until_it_is_unmapped() {
    with_contexts(|| {
        let mut name = 0;
        let mut again = null_mut();
        let mut bytes = [0_u8; 4];
        // SAFETY: four bytes of the buffer's.
        unsafe {
            glGenBuffers(1, &raw mut name);
            glBindBuffer(GL_ARRAY_BUFFER, name);
            glBufferData(GL_ARRAY_BUFFER, 4, null(), GL_STATIC_DRAW);
            let first = glMapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE).cast::<u8>();
            first.write(1);
            glGetBufferPointerv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &raw mut again);
            again.cast::<u8>().add(1).write(2);
            first.add(2).write(3);
            again.cast::<u8>().add(3).write(first.read() + 3);
            assert_eq!(glUnmapBuffer(GL_ARRAY_BUFFER), 1);
            glGetBufferSubData(GL_ARRAY_BUFFER, 0, 4, bytes.as_mut_ptr().cast());
            assert_eq!(glGetError(), GL_NO_ERROR);
        }
        assert_eq!(bytes, [1, 2, 3, 4]);
    });
}

#[test]
fn what_is_of_no_interest_may_go_to_one_place() {
    with_contexts(|| {
        let program = program("uniform vec4 a[3]; void main() { gl_FragColor = a[2]; }");
        let (mut ignored, mut ty, mut count) = (-1, 0, 0);
        let mut name = [1; 8];
        let mut numbers = [0_u32; 1];
        // SAFETY: C's prototypes ask for no two places.
        unsafe {
            let place = &raw mut ignored;
            glGetActiveUniform(program, 0, 8, place, place, &raw mut ty, name.as_mut_ptr());
            assert_eq!((ty, ignored), (GL_FLOAT_VEC4, 4));
            glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &raw mut count);
            assert_eq!(count, 1);
            let place = numbers.as_mut_ptr();
            glGetActiveUniformsiv(program, 1, place, GL_UNIFORM_SIZE, place.cast());
            assert_eq!(place.read(), 3);
            place.write(0);
            glGetActiveUniformsiv(program, 1, place, GL_UNIFORM_TYPE, place.cast());
            assert_eq!(place.read(), GL_FLOAT_VEC4);
            assert_eq!(glGetError(), GL_NO_ERROR);
        }
    });
}

#[test]
fn an_image_is_scaled_in_place() {
    let mut pixels = [10_u8, 20, 0, 0];
    let (place, ty) = (pixels.as_mut_ptr().cast::<c_void>(), GL_UNSIGNED_BYTE);
    // SAFETY: room for the larger of both images; without a context no row is padded.
    let error = unsafe { gluScaleImage(GL_LUMINANCE, 1, 2, ty, place, 1, 4, ty, place) };
    assert_eq!((error, pixels), (0, [10, 10, 20, 20]));
}

#[test]
fn what_is_written_need_not_have_been_written_before() {
    with_contexts(|| {
        let mut memory = [MaybeUninit::<u8>::uninit(); 64];
        // One byte off what C's types need, or none.
        for off in [0, 1] {
            let place = memory.as_mut_ptr().cast::<u8>().wrapping_add(off);
            // SAFETY: room for four values of four bytes.
            unsafe {
                glGetIntegerv(GL_VIEWPORT, place.cast());
                assert_eq!(place.cast::<[i32; 4]>().read_unaligned(), [0, 0, 4, 4]);
                fill([1.0, 0.0, 1.0]);
                let place = place.add(32);
                glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, place.cast());
                assert_eq!(place.cast::<[f32; 4]>().read_unaligned(), [1.0, 0.0, 1.0, 1.0]);
                assert_eq!(glGetError(), GL_NO_ERROR);
            }
            memory.fill(MaybeUninit::uninit());
        }
    });
}

/// What is found is counted, and written nowhere.
#[test]
fn selection_and_feedback_may_have_no_memory() {
    with_contexts(|| {
        // SAFETY: null is where nothing is written to.
        unsafe {
            glSelectBuffer(i32::MAX, null_mut());
            glFeedbackBuffer(i32::MAX, GL_2D, null_mut());
            for (mode, found) in [(GL_SELECT, 1), (GL_FEEDBACK, 10)] {
                glRenderMode(mode);
                glRectf(0.0, 0.0, 1.0, 1.0);
                assert_eq!(glRenderMode(GL_RENDER), found);
            }
            assert_eq!(glGetError(), GL_NO_ERROR);
        }
    });
}
