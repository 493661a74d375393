//! Terrain by three planes: grass on xz, rock on the other two; and the rule of 45 degrees.
//!
//! *TA 6*, "Triplanar / Box Mapping". On the left grass dropped on the land from above, which smears on the cliffs;
//! in the middle grass where the land faces up and rock from the two sides. The lecture's "never from an angle of
//! more than 45° from the normal" holds between two planes; where all three meet, at (1, 1, 1), the nearest is
//! acos(1/√3) = 54.7° away. On the right a ball, darker with that angle, and red where it is over 45°: 8 parts.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::noise::noise;
use examples::picture::smooth;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "terrain",
    lecture: "TA 6: \"Triplanar / Box Mapping\", terrain",
    source: include_str!("terrain.rs"),
    halves: [6, 2],
    panels: &[
        "grass on xz alone",
        "grass on xz, rock on the others",
        "over 45° from each axis: red",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0; // grass
uniform sampler2D uTexUnit1; // rock
uniform int uShow;
in vec3 vObject;
in vec3 vObjectNormal;
out vec4 fragColor;

void main() {
    vec3 n = normalize(vObjectNormal), p = vObject * 0.8;
    vec3 grass = texture2D(uTexUnit0, p.xz).rgb;
    vec3 weight = pow(abs(n), vec3(8.0));
    weight /= weight.x + weight.y + weight.z;
    vec3 rock_x = texture2D(uTexUnit1, p.zy).rgb, rock_z = texture2D(uTexUnit1, p.xy).rgb;
    vec3 color = weight.x * rock_x + weight.y * grass + weight.z * rock_z;
    if (uShow == 0) color = grass;
    if (uShow == 2) {
        vec3 along = abs(n);
        float angle = degrees(acos(min(1.0, max(along.x, max(along.y, along.z)))));
        color = angle > 45.0 ? vec3(0.9, 0.15, 0.1) : vec3(0.35, 0.6, 0.9) * (1.0 - angle / 60.0) + 0.15;
    }
    float light = max(0.0, dot(n, normalize(vec3(-0.5, 0.7, 0.5))));
    fragColor = vec4(color * (0.45 + 0.65 * light), 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.66, 0.78, 0.92, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    for (unit, file) in [(1, "rock.ppm"), (0, "grass.ppm")] {
        load_texture(unit, window.picture(file), GL_REPEAT);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    }
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let land = Mesh::surface(280, 280, |s, t| {
        let (x, z) = (14. * s - 7., 7. - 14. * t);
        let slope = |d: DVec3| (height(x + d.x, z + d.z) - height(x - d.x, z - d.z)) / 2e-2;
        let normal = dvec3(-slope(DVec3::X * 1e-2), 1., -slope(DVec3::Z * 1e-2));
        (dvec3(x, height(x, z), z), normal.normalize())
    });
    let [land, ball] = [land, Mesh::sphere()].map(|mesh| mesh.upload());
    let eye = look_at(dvec3(-0.6, 4.2, 5.6), dvec3(-0.4, 0.5, -1.));
    let corner = look_at(dvec3(1.9, 1.7, 2.3), DVec3::ZERO);
    for (panel, (model, view)) in (0..).zip([(land, eye), (land, eye), (ball, corner)]) {
        let aspect = window.panel(3, 1, panel);
        use_program(program, &perspective(40., aspect, 0.1, 50.), &view);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), panel);
        model.draw(program);
    }
    window.label(0., 0.86, [0.5, 0.05, 0.05], "(1, 1, 1): 54.7°");
}

/// Meadows at two heights, with cliffs between them, and hills.
fn height(x: f64, z: f64) -> f64 {
    let rough = noise(x * 1.5 + 16., z * 1.5 + 16., 64, 51) - 0.5;
    let edge = noise(x * 0.6 + 16., z * 0.6 + 16., 64, 52) + 0.12 * rough;
    let hills = noise(x + 16., z + 16., 64, 53);
    1.5 * smooth(0.50, 0.60, edge) + 0.9 * smooth(0.68, 0.76, edge) + 0.45 * hills
}
