//! How much memory of C's is read and written: not a byte that a call has no use for, and all of it where objects
//! are shared.

use super::*;
use gl_api::{
    GL_ARRAY_BUFFER, GL_COMPILE, GL_COMPILE_STATUS, GL_DEBUG_SEVERITY_HIGH,
    GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, GL_FLOAT, GL_FRAGMENT_SHADER,
    GL_INVALID_OPERATION, GL_INVALID_VALUE, GL_NO_ERROR, GL_PIXEL_UNPACK_BUFFER, GL_READ_WRITE,
    GL_RGBA, GL_STATIC_DRAW, GL_TEXTURE, GL_TEXTURE_2D, GL_TRIANGLES, GL_UNIFORM_BLOCK_DATA_SIZE,
    GL_UNSIGNED_BYTE, GL_UNSIGNED_INT, GL_UNSIGNED_SHORT, GL_VERTEX_ARRAY, GL_VERTEX_SHADER,
};
use std::ptr::{null, without_provenance};

unsafe extern "C" {
    fn glCreateShader(ty: GLenum) -> u32;
    fn glCompileShader(shader: u32);
    fn glGetShaderiv(shader: u32, pname: GLenum, value: *mut i32);
    fn glCreateProgram() -> u32;
    fn glAttachShader(program: u32, shader: u32);
    fn glLinkProgram(program: u32);
    fn glUseProgram(program: u32);
    fn glGetUniformLocation(program: u32, name: *const c_char) -> i32;
    fn glUniform1f(location: i32, x: f32);
    fn glUniform3fv(location: i32, count: i32, values: *const f32);
    fn glUniform4fv(location: i32, count: i32, values: *const f32);
    fn glGetUniformfv(program: u32, location: i32, out: *mut f32);
    fn glGetUniformBlockIndex(program: u32, name: *const c_char) -> u32;
    fn glGetActiveUniformBlockiv(program: u32, block: u32, pname: GLenum, out: *mut i32);
    fn glBegin(mode: GLenum);
    fn glEnd();
    fn glDeleteBuffers(n: i32, names: *const u32);
    pub(crate) fn glGenBuffers(n: i32, names: *mut u32);
    pub(crate) fn glBindBuffer(target: GLenum, name: u32);
    pub(crate) fn glBufferData(target: GLenum, size: isize, data: *const c_void, usage: GLenum);
    fn glBufferSubData(target: GLenum, offset: isize, size: isize, data: *const c_void);
    pub(crate) fn glGetBufferSubData(target: GLenum, offset: isize, size: isize, data: *mut c_void);
    pub(crate) fn glMapBuffer(target: GLenum, access: GLenum) -> *mut c_void;
    fn glDrawElements(mode: GLenum, count: i32, ty: GLenum, indices: *const c_void);
    fn glDrawElementsBaseVertex(mode: GLenum, count: i32, ty: GLenum, at: *const c_void, base: i32);
    fn glVertexPointer(size: i32, ty: GLenum, stride: i32, pointer: *const c_void);
    fn glEnableClientState(array: GLenum);
    fn glDisableClientState(array: GLenum);
    fn glNewList(list: u32, mode: GLenum);
    fn glEndList();
    fn glCallList(list: u32);
    fn glRasterPos2f(x: f32, y: f32);
    fn glDrawPixels(w: i32, h: i32, format: GLenum, ty: GLenum, pixels: *const c_void);
    fn glDebugMessageInsert(s: GLenum, t: GLenum, id: u32, v: GLenum, n: i32, text: *const c_char);
    fn glObjectLabel(what: GLenum, name: u32, length: i32, label: *const c_char);
}

/// Runs `f` with a context of its own; with one that shares objects, too.
pub(crate) fn with_contexts(f: fn()) {
    let (dpy, config) = display();
    // SAFETY: handles are only looked up, and the list ends.
    unsafe {
        let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
        let context = eglCreateContext(dpy, config, null_mut(), null());
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
        f();
        let shared = eglCreateContext(dpy, config, context, null());
        assert_eq!(eglMakeCurrent(dpy, surface, surface, shared), 1);
        f();
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
    }
}

/// A linked program of this fragment shader, in use.
pub(crate) fn program(fragment: &str) -> u32 {
    let vertex = "void main() { gl_Position = gl_Vertex; }";
    // SAFETY: strings with their lengths.
    unsafe {
        let program = glCreateProgram();
        for (ty, source) in [(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, fragment)] {
            let shader = glCreateShader(ty);
            let (text, length) = (source.as_ptr().cast::<c_char>(), source.len() as i32);
            glShaderSource(shader, 1, &raw const text, &raw const length);
            glCompileShader(shader);
            glAttachShader(program, shader);
        }
        glLinkProgram(program);
        glUseProgram(program);
        assert_eq!(glGetError(), GL_NO_ERROR);
        program
    }
}

#[test]
fn uniforms_and_blocks_answer_in_every_context() {
    with_contexts(|| {
        let program = program(
            "#version 140
            uniform float one;
            uniform Block { vec4 color; };
            out vec4 result;
            void main() { result = color * one; }",
        );
        let (mut value, mut size) = (0.0, 0);
        // SAFETY: room for the one value that each call answers.
        unsafe {
            let location = glGetUniformLocation(program, c"one".as_ptr());
            glUniform1f(location, 3.5);
            glGetUniformfv(program, location, &raw mut value);
            let block = glGetUniformBlockIndex(program, c"Block".as_ptr());
            glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &raw mut size);
            assert_eq!(glGetError(), GL_NO_ERROR);
        }
        assert_eq!((value, size), (3.5, 16));
    });
}

#[test]
fn values_that_no_uniform_takes_are_not_read() {
    with_contexts(|| {
        let program = program(
            "uniform vec4 array[3]; uniform vec4 single;
            void main() { gl_FragColor = array[0] + array[1] + array[2] + single; }",
        );
        // Whoever reads there is stopped.
        let nowhere = without_provenance::<f32>(64);
        let last = [1.0, 2.0, 3.0, 4.0];
        // SAFETY: what is read is there; that nothing else is, is what is tested.
        unsafe {
            let at = |name: &CStr| glGetUniformLocation(program, name.as_ptr());
            glUniform4fv(-1, 1000, nowhere);
            assert_eq!(glGetError(), GL_NO_ERROR);
            glUniform3fv(at(c"single"), 1, nowhere);
            assert_eq!(glGetError(), GL_INVALID_OPERATION);
            glUniform4fv(at(c"single"), 1000, nowhere);
            assert_eq!(glGetError(), GL_INVALID_OPERATION);
            // Elements past the end are ignored.
            glUniform4fv(at(c"array[2]"), 1000, last.as_ptr());
            let mut values = [0.0; 4];
            glGetUniformfv(program, at(c"array[2]"), values.as_mut_ptr());
            assert_eq!((values, glGetError()), (last, GL_NO_ERROR));
        }
    });
}

#[test]
fn long_texts_are_refused_unread() {
    with_contexts(|| {
        let (source, ty) = (GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER);
        let (severity, nowhere) = (GL_DEBUG_SEVERITY_HIGH, without_provenance::<c_char>(64));
        // SAFETY: nothing is read, which is what is tested.
        unsafe {
            glDebugMessageInsert(source, ty, 1, severity, 4096, nowhere);
            assert_eq!(glGetError(), GL_INVALID_VALUE);
            let mut name = 0;
            glGenTextures(1, &raw mut name);
            glBindTexture(GL_TEXTURE_2D, name);
            glObjectLabel(GL_TEXTURE, name, 256, nowhere);
            assert_eq!(glGetError(), GL_INVALID_VALUE);
        }
    });
}

#[test]
fn nothing_needs_no_memory() {
    with_contexts(|| {
        let (array, elements) = (GL_ARRAY_BUFFER, GL_UNSIGNED_SHORT);
        // SAFETY: no call has anything to read or write.
        unsafe {
            let mut name = 0;
            glGenBuffers(1, &raw mut name);
            glBindBuffer(array, name);
            glBufferData(array, 16, null(), GL_STATIC_DRAW);
            glBufferSubData(array, 8, 0, null());
            glGetBufferSubData(array, 8, 0, null_mut());
            glDrawElements(GL_TRIANGLES, 0, elements, null());
            assert_eq!(glGetError(), GL_NO_ERROR);
            glDrawElements(GL_TRIANGLES, 3, elements, null());
            assert_eq!(glGetError(), GL_INVALID_OPERATION);
            glBufferData(array, 0, null(), GL_STATIC_DRAW);
            assert!(glMapBuffer(array, GL_READ_WRITE).is_null());
            assert_eq!(glGetError(), GL_INVALID_OPERATION);
        }
    });
}

#[test]
fn a_list_takes_the_pixels_of_a_buffer() {
    with_contexts(|| {
        let yellow = [255_u8, 255, 0, 255];
        // SAFETY: four bytes of the buffer for one pixel.
        unsafe {
            let (unpack, list) = (GL_PIXEL_UNPACK_BUFFER, 1);
            let mut name = 0;
            glGenBuffers(1, &raw mut name);
            glBindBuffer(unpack, name);
            glBufferData(unpack, 4, yellow.as_ptr().cast(), GL_STATIC_DRAW);
            glNewList(list, GL_COMPILE);
            glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, null());
            glEndList();
            // The list has them, whatever becomes of the buffer.
            glBufferData(unpack, 4, [0_u8; 4].as_ptr().cast(), GL_STATIC_DRAW);
            glBindBuffer(unpack, 0);
            glUseProgram(0);
            fill([0.0, 0.0, 1.0]);
            glRasterPos2f(-1.0, -1.0);
            glCallList(list);
            assert_eq!(glGetError(), GL_NO_ERROR);
        }
        assert_eq!(pixel(), yellow);
    });
}

/// The vertices that a draw reads, and none of those between.
#[test]
fn indices_may_lie_far_apart() {
    with_contexts(|| {
        let mut vertices = vec![[f32::NAN; 2]; 100_000];
        let indices = [0_u32, 99_999, 50_000];
        for (index, place) in indices.into_iter().zip([[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]]) {
            vertices[index as usize] = place;
        }
        let green = "void main() { gl_FragColor = vec4(0.0, 1.0, 0.0, 1.0); }";
        // SAFETY: the arrays are as long as the calls say, and stay until they are disabled.
        unsafe {
            fill([0.0, 0.0, 1.0]);
            program(green);
            glVertexPointer(2, GL_FLOAT, 0, vertices.as_ptr().cast());
            glEnableClientState(GL_VERTEX_ARRAY);
            glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, indices.as_ptr().cast());
            glDisableClientState(GL_VERTEX_ARRAY);
            assert_eq!(glGetError(), GL_NO_ERROR);
            assert_eq!(pixel(), [0, 255, 0, 255]);
            glUseProgram(0);
        }
    });
}

/// More bytes than a pointer of 32 bits can count, of which none is read.
#[test]
fn a_count_may_be_larger_than_memory() {
    with_contexts(|| {
        // SAFETY: between `glBegin` and `glEnd` nothing is deleted.
        unsafe {
            glBegin(GL_TRIANGLES);
            glDeleteBuffers(i32::MAX, [0].as_ptr());
            glEnd();
            assert_eq!(glGetError(), GL_INVALID_OPERATION);
        }
    });
}

/// ARB_draw_elements_base_vertex: sums of an index and the base wrap, wherever the vertices are.
#[test]
fn base_vertices_wrap_in_client_arrays() {
    with_contexts(|| {
        let corners: [f32; 8] = [9.0, 9.0, -1.0, -1.0, 3.0, -1.0, -1.0, 3.0];
        let draws = [([0xFFFF_FFFC_u32, 0xFFFF_FFFD, 0xFFFF_FFFE], 5), ([4, 5, 6], -3)];
        for (indices, base) in draws {
            fill([0.0, 0.0, 1.0]);
            // SAFETY: vertices 1 to 3 are there; the indices are as many as are said.
            unsafe {
                glBindBuffer(GL_ARRAY_BUFFER, 0);
                glUseProgram(0);
                glColor4f(1.0, 0.0, 0.0, 1.0);
                glVertexPointer(2, GL_FLOAT, 0, corners.as_ptr().cast());
                glEnableClientState(GL_VERTEX_ARRAY);
                let at = indices.as_ptr().cast();
                glDrawElementsBaseVertex(GL_TRIANGLES, 3, GL_UNSIGNED_INT, at, base);
                glDisableClientState(GL_VERTEX_ARRAY);
                assert_eq!(glGetError(), GL_NO_ERROR, "{base}");
            }
            assert_eq!(pixel(), [255, 0, 0, 255], "{base}");
        }
    });
}

/// A byte that is no UTF-8 is no character of the language, outside of comments, in which any byte may stand.
#[test]
fn bytes_of_shaders_that_are_no_text() {
    with_contexts(|| {
        for (source, expected) in [
            (&b"void main() { int a = true \xa4 1 : 2; }"[..], 0),
            (&b"void main() { int a = 1; } // \xa4"[..], 1),
        ] {
            let mut compiled = -1;
            // SAFETY: a string with its length, and room for one value.
            unsafe {
                let shader = glCreateShader(GL_VERTEX_SHADER);
                let (text, length) = (source.as_ptr().cast::<c_char>(), source.len() as i32);
                glShaderSource(shader, 1, &raw const text, &raw const length);
                glCompileShader(shader);
                glGetShaderiv(shader, GL_COMPILE_STATUS, &raw mut compiled);
                assert_eq!(glGetError(), GL_NO_ERROR);
            }
            assert_eq!(compiled, expected, "{}", source.escape_ascii());
        }
    });
}
