//! The textured square: an sRGB picture glued to two triangles.
//!
//! *CS380, Texture Mapping*, slides 12 to 15. The lecture's shader multiplies a `mat4` with the
//! `vec2` it is given; here that is repaired by hand. `lecture_mistakes` runs it as printed.
//! The picture looks darker than its file: `GL_SRGB` decodes it to linear light, and the lecture
//! sends that "directly to the frame buffer".
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "textured_square",
    lecture: "CS380: slides 12 to 15, \"Texture mapping\"",
    source: include_str!("textured_square.rs"),
    halves: [2, 2],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const VERTEX_SHADER: &str = "\
#version 130
uniform float uVertexScale;
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
in vec2 aVertex;
in vec2 aTexCoord;
in vec3 aColor;
out vec3 vColor;
out vec2 vTexCoord;

void main()
{
    gl_Position = uProjMatrix * uModelViewMatrix * vec4(aVertex, 0.0, 1.0);
    vColor = aColor;
    vTexCoord = aTexCoord;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130

uniform sampler2D uTexUnit0;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec4 texColor0 = texture2D(uTexUnit0, vTexCoord);
    fragColor = texColor0;
}
";

const sqVerts: [GLfloat; 12] = [-1., -1., 1., 1., 1., -1., -1., -1., -1., 1., 1., 1.];
const sqTex: [GLfloat; 12] = [0., 0., 1., 1., 1., 0., 0., 0., 0., 1., 1., 1.];

fn draw(window: &mut Window) {
    initGLState(window);
    let h_program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    display(window, h_program);
}

fn initGLState(window: &mut Window) {
    glViewport(0, 0, window.width, window.height);
    glClearColor(0.08, 0.09, 0.11, 1);

    let mut h_texture: GLuint = 0;
    glActiveTexture(GL_TEXTURE0);
    glGenTextures(1, &mut h_texture);
    glBindTexture(GL_TEXTURE_2D, h_texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    let (mut twidth, mut theight): (GLint, GLint) = (0, 0);
    let pixdata: Vec<packed_pixel_t> = window.ppmread("reachup.ppm", &mut twidth, &mut theight);
    assert!(!pixdata.is_empty());
    // The lecture's "...": without this, only pictures whose rows are a multiple of 4 bytes work.
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB, twidth, theight, 0, GL_RGB, GL_UNSIGNED_BYTE, &pixdata);
}

fn display(window: &Window, h_program: GLuint) {
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(h_program);
    // The lecture asks for "texUnit0", which its shader does not have: the location would be -1, with which
    // `glUniform1i` does nothing. It would draw the same, as uniforms begin with 0.
    let h_texUnit0 = safe_glGetUniformLocation(h_program, "uTexUnit0");
    let h_aVertex = safe_glGetAttribLocation(h_program, "aVertex");
    let h_aTexCoord = safe_glGetAttribLocation(h_program, "aTexCoord");
    let h_uProjMatrix = safe_glGetUniformLocation(h_program, "uProjMatrix");
    let h_uModelViewMatrix = safe_glGetUniformLocation(h_program, "uModelViewMatrix");

    let aspect = f64::from(window.width) / f64::from(window.height);
    safe_glUniformMatrix4fv(h_uProjMatrix, &perspective(40., aspect, 0.1, 50.));
    let turned = translate(0., 0., -3.6) * rotate(-24., DVec3::Y) * rotate(-6., DVec3::X);
    safe_glUniformMatrix4fv(h_uModelViewMatrix, &turned);
    safe_glUniform1i(h_texUnit0, 0);

    let mut buffers: [GLuint; 2] = [0; 2];
    glGenBuffers(2, &mut buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, 12 * size_of::<GLfloat>(), &sqVerts, GL_STATIC_DRAW);
    safe_glVertexAttribPointer(h_aVertex, 2);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ARRAY_BUFFER, 12 * size_of::<GLfloat>(), &sqTex, GL_STATIC_DRAW);
    safe_glVertexAttribPointer(h_aTexCoord, 2);

    glDrawArrays(GL_TRIANGLES, 0, 6);
}
