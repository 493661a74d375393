//! Threads with little stack: 128 KB is what musl gives them.

use super::{SURFACE, display, eglCreateContext, eglCreatePbufferSurface, eglMakeCurrent, pixel};
use gl_api::*;
use std::ptr::{null, null_mut};

const STACK: usize = 128 << 10;

/// Compiles a shader; it need not be one.
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
    let sum = format!("{}t.x{}", "(".repeat(8), "* 1.0)".repeat(8));
    draw(&format!(
        "varying vec2 t; void main() {{ float z = {sum}; for (int i = 0; i < 4; i++) {{
         if (z > 9.0) z += sin(z); }} gl_FragColor = vec4(z > 9.0, 1, 0, 1); }}"
    ));
    (pixel(), glGetError())
}

/// Draws with a fragment shader, if it is one.
fn draw(fragment: &str) {
    let program = glCreateProgram();
    let vertex = "varying vec2 t; void main() { gl_Position = gl_Vertex; t = gl_Vertex.xy; }";
    glAttachShader(program, shader(GL_VERTEX_SHADER, vertex));
    glAttachShader(program, shader(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(program);
    glUseProgram(program);
    glRectf(-1.0, -1.0, 1.0, 1.0);
    glUseProgram(0);
    glDeleteProgram(program);
}

/// Shaders that nest as deep as they may, and deeper.
fn deep() -> ([u8; 4], GLenum) {
    let drawn = everything();
    for levels in [40, 60, 120, 200, 250, 400, 100_000] {
        let nested = |open: &str, inner: &str, close: &str| {
            let (open, close) = (open.repeat(levels), close.repeat(levels));
            draw(&format!(
                "varying vec2 t; void main() {{ float z = t.x; {open} {inner} {close}
                 gl_FragColor = vec4(z, 1, 0, 1); }}"
            ));
        };
        nested("if (z > t.y) { z *= 0.9; ", "", "}");
        nested("while (z < t.y) { z += 0.3; ", "", "}");
        nested("{", "z = 0.5;", "}");
        nested("z = (t.y - ", "z", ");");
        nested("z = sin(", "z", ");");
        nested("z = -", "z;", "");
        nested("z = t.x > 0.0 ? z : ", "z;", "");
        nested("z = vec2(z, ", "1.0", ").x;");
        nested("z = z", " + t.x", ";");
        let calls = (1..levels.min(5_000)).fold(
            "float f0(float a) { return a; }".to_owned(),
            |all, level| {
                all + &format!(
                    "float f{level}(float a) {{ if (a > 9.0) return a; return f{}(a + 0.1); }}\n",
                    level - 1
                )
            },
        );
        let last = levels.min(5_000) - 1;
        draw(&format!(
            "{calls} varying vec2 t; void main() {{ gl_FragColor = vec4(f{last}(t.x)); }}"
        ));
    }
    assert_eq!(glGetError(), GL_INVALID_OPERATION, "programs that do not link cannot be used");
    while glGetError() != GL_NO_ERROR {}
    drawn
}

#[test]
fn a_thread_of_little_stack_compiles_and_draws() {
    for work in [everything, deep] {
        let thread = std::thread::Builder::new().stack_size(STACK).spawn(work);
        let drawn = thread.expect("a thread").join().expect("no panic");
        assert_eq!(drawn, ([0, 255, 0, 255], GL_NO_ERROR));
    }
}
