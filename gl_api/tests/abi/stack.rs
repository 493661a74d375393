//! Threads with little stack: 128 KB is what musl gives them.

use super::{SURFACE, display, eglCreateContext, eglCreatePbufferSurface, eglMakeCurrent, pixel};
use gl_api::*;
use std::ptr::{null, null_mut};

const STACK: usize = 128 << 10;

/// Compiles a shader.
fn shader(kind: GLenum, source: &str) -> u32 {
    let name = glCreateShader(kind);
    glShaderSource(name, 1, &[source], NULL);
    glCompileShader(name);
    name
}

/// Makes a context, compiles and draws; the pixel, and the error.
fn everything() -> ([u8; 4], GLenum) {
    let (dpy, config) = display();
    // SAFETY: handles are only looked up; the list ends with EGL_NONE.
    unsafe {
        let first = eglCreateContext(dpy, config, null_mut(), null());
        let context = eglCreateContext(dpy, config, first, null());
        let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
    }
    glEnable(GL_LIGHTING);
    glRectf(-1.0, -1.0, 1.0, 1.0);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPopAttrib();
    let program = glCreateProgram();
    let sum = format!("{}t.x{}", "(".repeat(8), "* 1.0)".repeat(8));
    let fragment = format!(
        "varying vec2 t; void main() {{ float z = {sum}; for (int i = 0; i < 4; i++) {{
         if (z > 9.0) z += sin(z); }} gl_FragColor = vec4(z > 9.0, 1, 0, 1); }}"
    );
    let vertex = "varying vec2 t; void main() { gl_Position = gl_Vertex; t = gl_Vertex.xy; }";
    glAttachShader(program, shader(GL_VERTEX_SHADER, vertex));
    glAttachShader(program, shader(GL_FRAGMENT_SHADER, &fragment));
    glLinkProgram(program);
    glUseProgram(program);
    glRectf(-1.0, -1.0, 1.0, 1.0);
    (pixel(), glGetError())
}

#[test]
fn a_thread_of_little_stack_compiles_and_draws() {
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(everything);
    let drawn = thread.expect("a thread").join().expect("no panic");
    assert_eq!(drawn, ([0, 255, 0, 255], GL_NO_ERROR));
}
