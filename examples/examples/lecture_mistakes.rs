//! The lecture's mistakes: its shaders exactly as printed (`examples/src/printed_shaders.rs`).
//!
//! *CS380, Texture Mapping*, slides 14, 15, 22, 30 and 31. As they stand they do not compile: a
//! `mat4 * vec2`, a `sampler2D` handed to `textureCube`, names mixed up. First they go through a
//! context as the specification wants it, which says what is wrong; then through one with repairs
//! switched on, which lists what it repaired, and draws.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::printed_shaders::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "lecture_mistakes",
    lecture: "CS380: slides 14, 15, 22, 30 and 31, as printed",
    source: include_str!("lecture_mistakes.rs"),
    halves: [3, 1],
    panels: &["slides 14 and 15", "slide 22", "slides 30 and 31"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// The programs: slides, vertex shader, fragment shader.
const PROGRAMS: [(&str, &str, &str); 3] = [
    ("slides 14 and 15", SQUARE_VERTEX_SHADER, SQUARE_FRAGMENT_SHADER),
    ("slide 22", ENVIRONMENT_VERTEX_SHADER, ENVIRONMENT_FRAGMENT_SHADER),
    ("slides 30 and 31", PROJECTOR_VERTEX_SHADER, PROJECTOR_FRAGMENT_SHADER),
];

fn draw(window: &mut Window) {
    window.check_strictly();
    for (slides, vertex, fragment) in PROGRAMS {
        window.note(&format!("== {slides}, as the specification wants it"));
        initShaders(window, vertex, fragment);
    }

    window.apply_fix_its();
    glClearColor(0.08, 0.09, 0.11, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    for (panel, (slides, vertex, fragment)) in (0..).zip(PROGRAMS) {
        window.note(&format!("== {slides}, with repairs"));
        let program = initShaders(window, vertex, fragment);
        window.panel(3, 1, panel);
        draw_panel(window, panel, program);
    }
}

/// What the slides around the shaders show: a square, a mirror, a slide in the corner of a room.
fn draw_panel(window: &Window, panel: i32, program: GLuint) {
    glUseProgram(program);
    let uniform = |name| safe_glGetUniformLocation(program, name);
    // The slides call it one way, then the other.
    safe_glUniform1i(uniform(if panel < 2 { "uTexUnit0" } else { "vTexUnit0" }), 0);
    safe_glUniformMatrix4fv(uniform("uProjMatrix"), &perspective(40., 1., 0.1, 50.));
    let place = translate(0., 0., -3.6);
    let (mesh, model_view) = match panel {
        0 => {
            load_texture(0, window.picture("reachup.ppm"), GL_CLAMP_TO_EDGE);
            (Mesh::plane(), place * rotate(-24., DVec3::Y))
        }
        1 => {
            load_cube_map(window);
            (Mesh::torus(0.4), translate(0., 0., -4.6) * rotate(65., DVec3::X))
        }
        _ => {
            load_texture(0, window.picture("slide.ppm"), GL_CLAMP_TO_BORDER);
            let projector = look_at(dvec3(2.8, 0.9, 1.6), DVec3::splat(-0.3));
            safe_glUniformMatrix4fv(uniform("uSModelViewMatrix"), &projector);
            let domain = unit_square() * perspective(34., 1., 0.5, 20.);
            safe_glUniformMatrix4fv(uniform("uSProjMatrix"), &domain);
            let mut corner = Mesh::plane().moved(translate(0., 0., -1.));
            corner.append(Mesh::plane().moved(translate(-1., 0., 0.) * rotate(90., DVec3::Y)));
            corner.append(Mesh::plane().moved(translate(0., -1., 0.) * rotate(-90., DVec3::X)));
            (corner, look_at(dvec3(2.6, 1.9, 2.6), DVec3::splat(-0.15)))
        }
    };
    safe_glUniformMatrix4fv(uniform("uModelViewMatrix"), &model_view);
    mesh.upload().draw(program);
}
