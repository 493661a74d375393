//! The pictures that the clients draw, drawn by this crate's own functions.

use super::picture::Picture;
use gl_api::*;

const SIZE: usize = 256;

/// 128×128 RGB texels with something at every scale.
pub fn image() -> Vec<u8> {
    let mut texels = Vec::with_capacity(128 * 128 * 3);
    for y in 0..128_u32 {
        for x in 0..128_u32 {
            let check = if (x / 16 + y / 16) % 2 == 0 { 200 } else { 40 };
            texels.extend([check, (x * 2) as u8, (x * x + y * 3) as u8]);
        }
    }
    texels
}

/// The current picture, as the clients read it.
fn read() -> Picture {
    let mut pixels = vec![0; SIZE * SIZE * 3];
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, SIZE as i32, SIZE as i32, GL_RGB, GL_UNSIGNED_BYTE, &mut pixels);
    assert_eq!(glGetError(), GL_NO_ERROR);
    Picture { width: SIZE, height: SIZE, pixels }
}

fn decal(corners: [(f32, f32); 3]) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glBindTexture(GL_TEXTURE_2D, 666);
    let texels = image();
    glu::gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB8, 128, 128, GL_RGB, GL_UNSIGNED_BYTE, &texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_TRIANGLES);
    for ((s, t), (x, y)) in [(0.0, 0.0), (1.0, 0.0), (0.5, 1.0)].into_iter().zip(corners) {
        glTexCoord2f(s, t);
        glVertex2f(x, y);
    }
    glEnd();
}

fn context() -> Current {
    let (width, height) = (SIZE as u32, SIZE as u32);
    let desc = ContextDesc { width, height, ..ContextDesc::default() };
    Context::new(desc).expect("a device").make_current()
}

/// `demon.c`.
pub fn lecture() -> Picture {
    let _current = context();
    decal([(-0.8, 0.8), (0.8, 0.8), (0.0, -0.8)]);
    read()
}

/// `pyopengl.py`.
pub fn decal_and_shader() -> Picture {
    let _current = context();
    decal([(-1.0, 0.8), (0.0, 0.8), (-0.5, -0.8)]);
    let script = include_str!("pyopengl.py");
    let program = glCreateProgram();
    for (stage, name) in [(GL_VERTEX_SHADER, "VERTEX = "), (GL_FRAGMENT_SHADER, "FRAGMENT = ")] {
        let text = script.split(&format!("\n{name}\"\"\"")).nth(1);
        let text = text.and_then(|text| text.split("\"\"\"").next()).expect("the script has it");
        let shader = glCreateShader(stage);
        glShaderSource(shader, 1, &[text], NULL);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    glUseProgram(program);
    glUniform3f(glGetUniformLocation(program, "tint"), 0.9, 0.6, 0.2);
    let position = glGetAttribLocation(program, "position") as u32;
    glBegin(GL_TRIANGLE_STRIP);
    for (x, y) in [(0, -1), (1, -1), (0, 1), (1, 1)] {
        glVertexAttrib2f(position, x, y);
    }
    glEnd();
    read()
}
