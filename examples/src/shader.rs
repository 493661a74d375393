//! Compiling programs and setting uniforms, under the names of the CS380 lecture's helpers.

use crate::matrix::DMat4;
use crate::window::Window;
use gl_api::constants::*;
use gl_api::types::{GLenum, GLfloat, GLint, GLuint};
use gl_api::*;

/// The largest size of an info log.
const LOG: usize = 1 << 16;

/// Compiles a shader and records its info log; 0 if the compiler rejects it.
pub fn readAndCompileShader(window: &mut Window, kind: GLenum, source: &str) -> GLuint {
    let shader = glCreateShader(kind);
    glShaderSource(shader, 1, source, NULL);
    glCompileShader(shader);
    let mut log = String::new();
    glGetShaderInfoLog(shader, LOG, NULL, &mut log);
    window.note(&log);
    let mut status: GLint = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &mut status);
    if status == 0 {
        glDeleteShader(shader);
        return 0;
    }
    shader
}

/// Compiles and links a program and records the info logs; 0 if it is rejected.
pub fn initShaders(window: &mut Window, vertex: &str, fragment: &str) -> GLuint {
    let vs = readAndCompileShader(window, GL_VERTEX_SHADER, vertex);
    let fs = readAndCompileShader(window, GL_FRAGMENT_SHADER, fragment);
    if vs == 0 || fs == 0 {
        return 0;
    }
    let program = glCreateProgram();
    glAttachShader(program, vs);
    glAttachShader(program, fs);
    glLinkProgram(program);
    let mut log = String::new();
    glGetProgramInfoLog(program, LOG, NULL, &mut log);
    window.note(&log);
    let mut status: GLint = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &mut status);
    if status == 0 { 0 } else { program }
}

/// Vertex shader that outputs position, normal and texture coordinates: in the eye's frame (`vPosition`,
/// `vNormal`) and the object's (`vObject`, `vObjectNormal`).
pub const EYE_VERTEX_SHADER: &str = "\
#version 130
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
in vec4 aVertex;
in vec3 aNormal;
in vec2 aTexCoord;
in vec3 aColor;
out vec3 vPosition;
out vec3 vNormal;
out vec3 vObject;
out vec3 vObjectNormal;
out vec2 vTexCoord;
out vec3 vColor;

void main() {
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = vec3(uModelViewMatrix * vec4(aNormal, 0.0));
    vObject = aVertex.xyz;
    vObjectNormal = aNormal;
    vTexCoord = aTexCoord;
    vColor = aColor;
    gl_Position = uProjMatrix * vec4(vPosition, 1.0);
}
";

/// Uses a program and sets its matrices; `uTexUnit0`, `uTexUnit1` and `uTexUnit2` are the units.
pub fn use_program(program: GLuint, projection: &DMat4, model_view: &DMat4) {
    glUseProgram(program);
    safe_glUniformMatrix4fv(safe_glGetUniformLocation(program, "uProjMatrix"), projection);
    safe_glUniformMatrix4fv(safe_glGetUniformLocation(program, "uModelViewMatrix"), model_view);
    for (unit, name) in (0..).zip(["uTexUnit0", "uTexUnit1", "uTexUnit2"]) {
        safe_glUniform1i(safe_glGetUniformLocation(program, name), unit);
    }
}

/// The location of a uniform; -1 for one that the program does not use.
pub fn safe_glGetUniformLocation(program: GLuint, name: &str) -> GLint {
    glGetUniformLocation(program, name)
}

/// The location of an attribute; -1 for one that the program does not use.
pub fn safe_glGetAttribLocation(program: GLuint, name: &str) -> GLint {
    glGetAttribLocation(program, name)
}

/// Sets an `int` or a sampler; location -1 is ignored.
pub fn safe_glUniform1i(location: GLint, value: GLint) {
    glUniform1i(location, value);
}

/// Sets a `float`; location -1 is ignored.
pub fn safe_glUniform1f(location: GLint, value: impl Arg<GLfloat>) {
    glUniform1f(location, value);
}

/// Sets a `vec3`; location -1 is ignored.
pub fn safe_glUniform3f(
    location: GLint,
    x: impl Arg<GLfloat>,
    y: impl Arg<GLfloat>,
    z: impl Arg<GLfloat>,
) {
    glUniform3f(location, x, y, z);
}

/// Sets a `mat4`; location -1 is ignored.
pub fn safe_glUniformMatrix4fv(location: GLint, matrix: &DMat4) {
    glUniformMatrix4fv(location, 1, GL_FALSE, &matrix.as_mat4().to_cols_array());
}

/// Enables an attribute array that starts at the begin of the bound buffer; location -1 is ignored.
pub fn safe_glVertexAttribPointer(location: GLint, size: GLint) {
    if location >= 0 {
        glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, 0, 0);
        glEnableVertexAttribArray(location);
    }
}
