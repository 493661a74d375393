//! The shaders of the checks, and how they are compiled.

use super::error::ProbeError;
use super::pack;
use super::program::{Precision, Program};
use super::session::Session;
use crate::gl::*;
use gl_api::constants::*;

const VERTEX: &str = "#version 120
varying vec4 a, b, c;
void main() {
    gl_Position = gl_Vertex;
    a = gl_MultiTexCoord0;
    b = gl_MultiTexCoord1;
    c = gl_MultiTexCoord2;
}
";

const VERSION: &str = "#version 130
#extension GL_ARB_shader_texture_lod : enable
#extension GL_ARB_texture_cube_map_array : enable
#extension GL_ARB_texture_rectangle : enable
#extension GL_EXT_texture_array : enable
";

const FRAGMENT: &str = "#version 130
#extension GL_ARB_shader_texture_lod : enable
#extension GL_ARB_texture_rectangle : enable
#extension GL_EXT_texture_array : enable
varying vec4 a, b, c;
";

const BYTES: &str = "
void main() {
    gl_FragColor = value();
}
";

/// `image` at (a.s, a.t).
pub const TEXTURE_2D: &str = "
uniform sampler2D image;
vec4 value() { return texture2D(image, a.xy); }
";

/// `image` at (a.s, a.t), with derivatives b.xy by x and b.zw by y, and bias c.x. The quads that
/// differences are taken over are the cells.
pub const TEXTURE_2D_BIAS: &str = "
uniform sampler2D image;
vec4 value() {
    vec2 pixel = mod(floor(gl_FragCoord.xy), 2.0);
    return texture2D(image, a.xy + pixel.x * b.xy + pixel.y * b.zw, c.x);
}
";

/// `image` at (a.s/a.q, a.t/a.q).
pub const TEXTURE_2D_PROJ: &str = "
uniform sampler2D image;
vec4 value() { return texture2DProj(image, a); }
";

/// `image` in direction (a.x, a.y, a.z).
pub const TEXTURE_CUBE: &str = "
uniform samplerCube image;
vec4 value() { return textureCube(image, a.xyz); }
";

/// `image` in direction `a.xyz` of the cube `a.w`.
pub const TEXTURE_CUBE_ARRAY: &str = "
uniform samplerCubeArray image;
vec4 value() { return texture(image, a); }
";

/// `image` at (a.s, a.t) compared with a.z.
pub const SHADOW_2D: &str = "
uniform sampler2DShadow image;
vec4 value() { return shadow2D(image, a.xyz); }
";

/// The interpolated value of `a`.
pub const INPUT: &str = "
vec4 value() { return a; }
";

/// Window depth.
pub const FRAGMENT_DEPTH: &str = "
vec4 value() { return vec4(gl_FragCoord.z, 0.0, 0.0, 0.0); }
";

impl Session {
    /// Compiles and links the program whose fragments output `value()`, which `body` defines.
    ///
    /// # Errors
    /// With the info log, when it is rejected.
    pub fn program(&self, body: &str, precision: Precision) -> Result<Program, ProbeError> {
        self.link(FRAGMENT, body, precision)
    }

    /// The program of a field: `head` declares its inputs, `body` defines `value()`.
    pub(super) fn field_program(
        &self,
        head: &str,
        body: &str,
        precision: Precision,
    ) -> Result<Program, ProbeError> {
        self.link(&format!("{VERSION}{head}"), body, precision)
    }

    /// Uses a program without a vertex shader.
    ///
    /// # Errors
    /// With the info log, when it is rejected.
    pub fn fragment_only(&self, source: &str) -> Result<(), ProbeError> {
        let name = glCreateProgram();
        compile(name, GL_FRAGMENT_SHADER, "fragment shader", source)?;
        glLinkProgram(name);
        glUseProgram(name);
        self.check("using a fragment shader")
    }

    /// Lets the samplers of the program in use read the units 0, 1, … in this order.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn sampler_units(&self, names: &[&str]) -> Result<(), ProbeError> {
        let mut program = [0i32; 1];
        glGetIntegerv(GL_CURRENT_PROGRAM, &mut program);
        for (unit, name) in (0..).zip(names) {
            let unit: i32 = unit;
            glUniform1i(glGetUniformLocation(program[0], *name), unit);
        }
        self.check("choosing the units of samplers")
    }

    /// Links a program whose shaders are attached.
    pub(super) fn link_program(&self, name: u32) -> Result<(), ProbeError> {
        glLinkProgram(name);
        let mut linked = 0;
        glGetProgramiv(name, GL_LINK_STATUS, &mut linked);
        if linked == 0 {
            let mut log = String::new();
            glGetProgramInfoLog(name, 1 << 16, NULL, &mut log);
            return Err(ProbeError::Shader { stage: "program", log });
        }
        self.check("linking")
    }

    fn link(&self, head: &str, body: &str, precision: Precision) -> Result<Program, ProbeError> {
        let main = match precision {
            Precision::Bytes => BYTES,
            Precision::Exact { .. } => pack::GLSL,
        };
        let name = glCreateProgram();
        compile(name, GL_VERTEX_SHADER, "vertex shader", VERTEX)?;
        let fragment = format!("{head}{body}{main}");
        compile(name, GL_FRAGMENT_SHADER, "fragment shader", &fragment)?;
        self.link_program(name)?;
        Ok(Program { name, precision })
    }
}

pub(super) fn compile(
    program: u32,
    kind: u32,
    stage: &'static str,
    source: &str,
) -> Result<(), ProbeError> {
    let shader = glCreateShader(kind);
    glShaderSource(shader, 1, source, NULL);
    glCompileShader(shader);
    let mut compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &mut compiled);
    if compiled == 0 {
        let mut log = String::new();
        glGetShaderInfoLog(shader, 1 << 16, NULL, &mut log);
        return Err(ProbeError::Shader { stage, log });
    }
    glAttachShader(program, shader);
    Ok(())
}
