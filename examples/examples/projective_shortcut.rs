//! Projective textures with one reciprocal: (s/w) · (w/q) = s/q.
//!
//! *Texture Mapping*, slide "Interpolation in OpenGL". Hardware interpolates (s/w, t/w, r/w, q/w), which are linear
//! on the screen. A regular texture needs 1/(1/w); a projective one need not find w at all: the reciprocal of q/w is
//! w/q, and a multiplication gives s/q. TXP, the instruction that the slide names, does that in an assembly program.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "projective_shortcut",
    lecture: "Texture Mapping: \"Interpolation in OpenGL\"",
    source: include_str!("projective_shortcut.rs"),
    halves: [6, 4],
    panels: &[
        "what is interpolated: (s/w, t/w, q/w)",
        "(s, t), q left out: 1 RCP of 1/w",
        "(s/q, t/q): 2 RCP, of 1/w and of q",
        "(s/w)(w/q): 1 RCP, of q/w",
        "TXP, as assembly",
        "difference of the two ways × 2^22",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Positions and the projector's coordinates (s, t, 0, q) are of the fixed function.
const VERTEX_SHADER: &str = "\
#version 130
noperspective out vec4 vOverW; // s/w, t/w, q/w, 1/w

void main() {
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
    vOverW = vec4(gl_MultiTexCoord0.stq, 1.0) / gl_Position.w;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform int uWay;
noperspective in vec4 vOverW;
out vec4 fragColor;

void main() {
    float w = 1.0 / vOverW.w;
    vec2 st = vOverW.st * w;
    vec2 twice = st * (1.0 / (vOverW.p * w));
    vec2 once = vOverW.st * (1.0 / vOverW.p);
    vec2 at = uWay == 1 ? st : uWay == 2 ? twice : once;
    vec3 color = textureLod(uTexUnit0, at, 0.0).rgb;
    if (uWay == 0) color = vOverW.stp * vec3(1.6, 1.6, 1.0);
    if (uWay == 5) color = vec3(abs(twice - once) * 4194304.0, 0.0);
    fragColor = vec4(color, 1.0);
}
";

const TXP: &str = "!!ARBfp1.0
TXP result.color, fragment.texcoord[0], texture[0], 2D;
END";

fn draw(window: &mut Window) {
    glClearColor(0.08, 0.09, 0.12, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_texture(0, window.picture("slide.ppm"), GL_CLAMP_TO_BORDER);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[0.30, 0.29, 0.28, 1.]);
    set_filter(GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    for way in 0..6 {
        let aspect = window.panel(3, 2, way);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        gluPerspective(44, aspect, 0.1, 50);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        gluLookAt(-2.2, 2.8, 6.4, 0.1, 0.75, 0, 0, 1, 0);
        if way == 4 {
            glUseProgram(0);
            glProgramStringARB(
                GL_FRAGMENT_PROGRAM_ARB,
                GL_PROGRAM_FORMAT_ASCII_ARB,
                TXP.len(),
                TXP,
            );
            glEnable(GL_FRAGMENT_PROGRAM_ARB);
        } else {
            glUseProgram(program);
            safe_glUniform1i(safe_glGetUniformLocation(program, "uWay"), way);
        }
        floor_and_wall();
        glDisable(GL_FRAGMENT_PROGRAM_ARB);
    }
}

/// A floor and a wall; the texture coordinates are a projector's, which stands at the right.
fn floor_and_wall() {
    let view = look_at(dvec3(2.0, 2.6, 3.2), dvec3(-0.3, 0.5, -0.8));
    let projector = unit_square() * perspective(36., 1., 0.1, 20.) * view;
    let floor = [(-2.4, 0., 1.6), (2.4, 0., 1.6), (2.4, 0., -1.4), (-2.4, 0., -1.4)];
    let wall = [(-2.4, 0., -1.4), (2.4, 0., -1.4), (2.4, 2.6, -1.4), (-2.4, 2.6, -1.4)];
    glBegin(GL_QUADS);
    for (x, y, z) in floor.into_iter().chain(wall) {
        let at = projector * dvec3(x, y, z).extend(1.);
        glTexCoord4f(at.x, at.y, 0, at.w);
        glVertex3f(x, y, z);
    }
    glEnd();
}
