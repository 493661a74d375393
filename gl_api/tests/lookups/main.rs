//! GLSL's texture lookups: every function on every kind of sampler, in both stages, against the
//! texel that it must find, in textures whose texels say where they are. And what lookups find in
//! textures of every format, made in every way, and at the ends of every range.

mod borders;
mod buffers;
mod byte_functions;
mod extensions;
mod extremes;
mod formats;
mod functions;
mod gathers;
mod indices;
mod limits;
mod lines;
mod mipmaps;
mod opaque;
mod parts;
mod repeats;
mod seamless;
mod shadows;
mod storage;
mod textures;
mod transfer;

use gl_api::*;
use textures::Texels;

/// A window of one quad.
fn context() -> Current {
    let desc = ContextDesc { width: 2, height: 2, ..ContextDesc::default() };
    Context::new(desc).expect("a device").make_current()
}

/// The program of two stages, or their logs.
fn program(vertex: &str, fragment: &str) -> Result<u32, String> {
    let program = glCreateProgram();
    let mut log = String::new();
    for (kind, source) in [(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, fragment)] {
        let shader = glCreateShader(kind);
        glShaderSource(shader, 1, source, NULL);
        glCompileShader(shader);
        let mut status = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &mut status);
        if status == 0 {
            glGetShaderInfoLog(shader, 1 << 16, NULL, &mut log);
            return Err(format!("{source}\n{log}"));
        }
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    let mut status = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &mut status);
    if status == 0 {
        glGetProgramInfoLog(program, 1 << 16, NULL, &mut log);
        return Err(format!("{fragment}\n{log}"));
    }
    Ok(program)
}

/// Fills the window by a program and gives its first pixel.
fn drawn(program: u32) -> [u8; 4] {
    glUseProgram(program);
    glBegin(GL_QUADS);
    for (x, y) in [(-1, -1), (1, -1), (1, 1), (-1, 1)] {
        glVertex2f(x, y);
    }
    glEnd();
    let mut pixel = [9; 4];
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut pixel);
    pixel
}

/// Where a lookup is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Vertex,
    Fragment,
}

/// A lookup in a shader: `r`, four bytes as fractions, is set by `body`, which may use the sampler
/// `s` and `d`, the column of the pixel, 0 or 1 (in the vertex stage 0).
fn run(
    stage: Stage,
    preamble: &str,
    sampler: &str,
    body: &str,
    texels: Texels,
) -> Result<[u8; 4], String> {
    texels.bind();
    let declare = format!("{preamble}\nuniform {sampler} s;");
    let (vertex, fragment) = match stage {
        Stage::Fragment => (
            "void main() { gl_Position = gl_Vertex; }".to_owned(),
            format!(
                "{declare}
void main() {{ float d = gl_FragCoord.x - 0.5; vec4 r; {body} gl_FragColor = r; }}"
            ),
        ),
        Stage::Vertex => (
            format!(
                "{declare}
varying vec4 v;
void main() {{ float d = 0.0; vec4 r; {body} v = r; gl_Position = gl_Vertex; }}"
            ),
            "varying vec4 v; void main() { gl_FragColor = v; }".to_owned(),
        ),
    };
    let program = program(&vertex, &fragment)?;
    let pixel = drawn(program);
    let error = glGetError();
    glUseProgram(0);
    glDeleteProgram(program);
    if error != GL_NO_ERROR {
        return Err(format!("{body}: {}", enum_name(error)));
    }
    Ok(pixel)
}
