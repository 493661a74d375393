//! Threads that share objects and say nothing to one another: whose call comes first is open, but nothing breaks.

use super::*;
use gl_api::{
    GL_ARRAY_BUFFER, GL_NO_ERROR, GL_RGBA, GL_STATIC_DRAW, GL_TEXTURE_2D, GL_TRIANGLES,
    GL_UNSIGNED_BYTE, GL_VERTEX_ARRAY,
};
use lengths::{glBindBuffer, glBufferData, glMapBuffer, program};
use std::ptr::{null, without_provenance_mut};

unsafe extern "C" {
    fn glDeleteTextures(n: i32, names: *const u32);
    fn glDeleteBuffers(n: i32, names: *const u32);
    fn glUnmapBuffer(target: GLenum) -> u8;
    fn glDrawArrays(mode: GLenum, first: i32, count: i32);
    fn glVertexPointer(size: i32, ty: GLenum, stride: i32, pointer: *const c_void);
    fn glEnableClientState(array: GLenum);
    fn glDeleteProgram(program: u32);
    fn glUseProgram(program: u32);
}

/// An interpreter takes a minute for a few.
const ROUNDS: u32 = if cfg!(miri) { 2 } else { 40 };
const THREADS: u32 = 3;

/// Changes, draws with and deletes what others change, draw with and delete.
fn work(seed: u32) {
    let names = [1, 2];
    let texels = [seed as u8; 16 * 16 * 4];
    // SAFETY: what is read and written is there; a mapped pointer is not used.
    unsafe {
        glEnable(GL_TEXTURE_2D);
        glEnableClientState(GL_VERTEX_ARRAY);
        for round in 0..ROUNDS {
            let name = names[(round % 2) as usize];
            let side = 1 << (round % 5);
            let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
            glBindTexture(GL_TEXTURE_2D, name);
            let (target, from) = (GL_TEXTURE_2D, texels.as_ptr().cast());
            glTexImage2D(target, 0, GL_RGBA as i32, side, side, 0, format, ty, from);
            glBindBuffer(GL_ARRAY_BUFFER, name);
            glBufferData(GL_ARRAY_BUFFER, 96, texels.as_ptr().cast(), GL_STATIC_DRAW);
            glVertexPointer(2, gl_api::GL_FLOAT, 0, null());
            glDrawArrays(GL_TRIANGLES, 0, 12);
            glMapBuffer(GL_ARRAY_BUFFER, gl_api::GL_READ_WRITE);
            glRectf(-1.0, -1.0, 1.0, 1.0);
            glUnmapBuffer(GL_ARRAY_BUFFER);
            if (round + seed).is_multiple_of(4) {
                glDeleteTextures(1, &raw const name);
                glDeleteBuffers(1, &raw const name);
            }
            if round % 8 == 0 {
                while glGetError() != GL_NO_ERROR {}
                let program = program("void main() { gl_FragColor = gl_FragCoord; }");
                glRectf(-1.0, -1.0, 0.0, 0.0);
                glUseProgram(0);
                glDeleteProgram(program);
            }
            let _ = pixel();
        }
        while glGetError() != GL_NO_ERROR {}
        glDisable(GL_TEXTURE_2D);
        fill([0.0, 1.0, 0.0]);
        assert_eq!(pixel(), [0, 255, 0, 255]);
    }
}

#[test]
fn objects_that_all_change_at_once_harm_nobody() {
    let (dpy, config) = display();
    // SAFETY: handles are only looked up.
    let contexts: Vec<usize> = unsafe {
        let first = eglCreateContext(dpy, config, null_mut(), null());
        let others = (1..THREADS).map(|_| eglCreateContext(dpy, config, first, null()).addr());
        std::iter::once(first.addr()).chain(others).collect()
    };
    let handles = [dpy, config].map(|handle| handle.addr());
    std::thread::scope(|scope| {
        for (seed, context) in contexts.into_iter().enumerate() {
            scope.spawn(move || {
                let [dpy, config, context] =
                    [handles[0], handles[1], context].map(without_provenance_mut);
                // SAFETY: as above. Every other one ends with its context current.
                unsafe {
                    let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
                    assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
                    work(seed as u32);
                    assert_eq!(eglDestroyContext(dpy, context), 1);
                    assert_eq!(eglDestroySurface(dpy, surface), 1);
                    if seed % 2 == 0 {
                        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
                    }
                }
            });
        }
    });
}
