//! Projector texture mapping: a slide projector lights the corner of a room.
//!
//! *CS380, Texture Mapping*, slides 25 to 32. On the left the fragment shader divides by w itself;
//! on the right `texture2DProj` does. The lecture mixes up `aTexCoord` and `vTexCoord`; that is repaired. The
//! room is drawn first in dim light, then the slide is added to it.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "projector",
    lecture: "CS380: slides 25 to 32, \"Projector texture mapping\"",
    source: include_str!("projector.rs"),
    halves: [3, 2],
    panels: &["divided by w by hand", "texture2DProj"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const VERTEX_SHADER: &str = "\
#version 130

uniform mat4 uModelViewMatrix;
uniform mat4 uProjMatrix;

uniform mat4 uSProjMatrix;
uniform mat4 uSModelViewMatrix;

in vec4 aVertex;
out vec4 vTexCoord;

void main(){
    vTexCoord = uSProjMatrix * uSModelViewMatrix * aVertex;
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
}
";

const DIVIDE_FRAGMENT_SHADER: &str = "\
#version 130

uniform sampler2D vTexUnit0;

in vec4 vTexCoord;
out vec4 fragColor;

void main(){
    vec2 tex2;
    tex2.x = vTexCoord.x/vTexCoord.w;
    tex2.y = vTexCoord.y/vTexCoord.w;
    vec4 texColor0 = texture2D(vTexUnit0, tex2);
    fragColor = texColor0;
}
";

const PROJ_FRAGMENT_SHADER: &str = "\
#version 130

uniform sampler2D vTexUnit0;

in vec4 vTexCoord;
out vec4 fragColor;
void main(){
    fragColor = texture2DProj(vTexUnit0, vTexCoord);
}
";

fn draw(window: &mut Window) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    // What is not on the slide is the border's black: no light.
    load_texture(0, window.picture("slide.ppm"), GL_CLAMP_TO_BORDER);

    let model = room_corner().upload();
    let dim = dim_room_program(window);
    let by_hand = initShaders(window, VERTEX_SHADER, DIVIDE_FRAGMENT_SHADER);
    let by_proj = initShaders(window, VERTEX_SHADER, PROJ_FRAGMENT_SHADER);

    for (panel, slide) in [(0, by_hand), (1, by_proj)] {
        let aspect = window.panel(2, 1, panel);
        glDisable(GL_BLEND);
        draw_room(&model, dim, aspect);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        draw_room(&model, slide, aspect);
    }
}

fn draw_room(model: &Model, program: GLuint, aspect: f64) {
    glUseProgram(program);
    let uniform = |name| safe_glGetUniformLocation(program, name);
    safe_glUniform1i(uniform("vTexUnit0"), 0);
    let eye = look_at(dvec3(5.2, 3.9, 6.2), dvec3(0., 1.15, 0.));
    safe_glUniformMatrix4fv(uniform("uModelViewMatrix"), &eye);
    safe_glUniformMatrix4fv(uniform("uProjMatrix"), &perspective(44., aspect, 0.5, 40.));
    // The projector is a camera whose picture is the unit square.
    let projector = look_at(dvec3(4.6, 2.6, 3.4), dvec3(-1.3, 1.35, -1.0));
    safe_glUniformMatrix4fv(uniform("uSModelViewMatrix"), &projector);
    let domain = unit_square() * perspective(32., 1., 0.5, 40.);
    safe_glUniformMatrix4fv(uniform("uSProjMatrix"), &domain);
    model.draw(program);
}
