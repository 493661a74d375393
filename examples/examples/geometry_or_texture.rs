//! Fine geometry, or a texture of it: a carpet and a brick wall, with their triangles counted.
//!
//! *eScience*, slide 3, "The Quest for Visual Realism": a carpet's fibres are of one colour, and light makes it
//! vary. *TA 6*, "Textures": bricks as geometry, and a better way. From left to right: one flat face; every
//! fibre and brick modelled; a face with a texture, which is a picture of the geometry, taken from the front.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::noise::hash;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "geometry_or_texture",
    lecture: "eScience: slide 3, carpet; TA 6: \"Textures\", bricks",
    source: include_str!("geometry_or_texture.rs"),
    halves: [6, 4],
    panels: &[
        "carpet: one face",
        "carpet: geometry",
        "carpet: a texture of it",
        "bricks: one face",
        "bricks: geometry",
        "bricks: a texture of it",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const VERTEX_SHADER: &str = "\
#version 130
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
in vec4 aVertex;
in vec3 aNormal;
in vec2 aTexCoord;
in vec3 aColor;
out vec3 vColor;
out vec2 vTexCoord;

void main() {
    // The light is the object's, so that a picture of the object has it as well.
    vColor = aColor * (0.35 + 0.65 * max(0.0, dot(aNormal, normalize(vec3(-0.5, 0.6, 0.6)))));
    vTexCoord = aTexCoord;
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform int uTextured;
in vec3 vColor;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec3 color = uTextured == 1 ? texture2D(uTexUnit0, vTexCoord).rgb : vColor;
    fragColor = vec4(color, 1.0);
}
";

fn draw(window: &mut Window) {
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    let textured = safe_glGetUniformLocation(program, "uTextured");
    let other = load_texture(0, window.picture("bricks.ppm"), GL_REPEAT);
    let mut panel = 0;
    for (detail, color, tilt) in [(carpet(), WOOL, -52.), (bricks(), CLAY, -12.)] {
        let flat = Mesh::plane().colored(color);
        let texture = photograph(&detail, program, other);
        glClearColor(0.86, 0.88, 0.90, 1);
        for (mesh, with_texture) in [(&flat, 0), (&detail, 0), (&flat, 1)] {
            let aspect = window.panel(3, 2, panel);
            if panel == 0 {
                glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            }
            let place =
                translate(0., if panel < 3 { 0.3 } else { 0.1 }, -3.7) * rotate(tilt, DVec3::X);
            let place = place * rotate(24., if panel < 3 { DVec3::Z } else { DVec3::Y });
            use_program(program, &perspective(42., aspect, 0.1, 50.), &place);
            glBindTexture(GL_TEXTURE_2D, texture);
            safe_glUniform1i(textured, with_texture);
            mesh.upload().draw(program);
            let triangles = mesh.indices.len() / 3;
            window.label(0., 0.9, [0.1, 0.1, 0.2], &format!("{triangles} triangles"));
            panel += 1;
        }
    }
}

/// Draws a mesh from the front into a texture, with its pyramid.
fn photograph(mesh: &Mesh, program: GLuint, other: GLuint) -> GLuint {
    let (_, picture) = color_framebuffer(512);
    // Nothing is read while it is drawn to.
    glBindTexture(GL_TEXTURE_2D, other);
    glEnable(GL_DEPTH_TEST);
    glViewport(0, 0, 512, 512);
    glClearColor(MORTAR[0], MORTAR[1], MORTAR[2], 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    use_program(program, &DMat4::IDENTITY, &DMat4::from_scale(dvec3(1., 1., -1.)));
    safe_glUniform1i(safe_glGetUniformLocation(program, "uTextured"), 0);
    mesh.upload().draw(program);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindTexture(GL_TEXTURE_2D, picture);
    glGenerateMipmap(GL_TEXTURE_2D);
    set_filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    picture
}

const WOOL: [f32; 3] = [0.80, 0.30, 0.25];
const CLAY: [f32; 3] = [0.72, 0.36, 0.26];
const MORTAR: [f32; 3] = [0.70, 0.68, 0.64];

/// Pyramids of four faces, all of one colour, each leaning its own way.
fn carpet() -> Mesh {
    const SIDE: i64 = 72;
    let mut carpet = Mesh::plane().colored(WOOL);
    for at in 0..SIDE * SIDE {
        let (column, row) = (at % SIDE, at / SIDE);
        let lean = |seed: u32| 1.6 * (hash(column, row, seed) - 0.5);
        let middle = |at: i64| (2 * at + 1) as f64 / SIDE as f64 - 1.;
        let step = 1. / SIDE as f64;
        let foot = dvec3(middle(column), middle(row), 0.);
        let tip = foot + dvec3(step * lean(1), step * lean(2), step * (1.6 + lean(3)));
        let corner = |(x, y): (f64, f64)| foot + dvec3(x, y, 0.) * step;
        let around = [(-1., -1.), (1., -1.), (1., 1.), (-1., 1.)].map(corner);
        for side in 0..4 {
            let (a, b) = (around[side], around[(side + 1) % 4]);
            let normal = (b - a).cross(tip - a).normalize();
            carpet.append(Mesh::triangle([a, b, tip], normal).colored(WOOL));
        }
    }
    carpet
}

/// Boxes in courses over a plane of mortar.
fn bricks() -> Mesh {
    let mut wall = Mesh::plane().colored(MORTAR);
    for row in 0..12 {
        for column in 0..=6 {
            let tone = 0.75 + 0.4 * hash(column, row, 4) as f32;
            let (left, right) = (column as f64 / 3. - 1.333 + (row % 2) as f64 / 6., 0.305);
            let (left, right) = (left.max(-1.), (left + right).min(1.));
            if right > left {
                let low = row as f64 / 6. - 1.;
                let middle = translate((left + right) / 2., low + 0.083, 0.);
                let size = dvec3((right - left) / 2., 0.07, 0.02 + 0.03 * hash(column, row, 5));
                let brick = Mesh::cube().moved(middle * DMat4::from_scale(size));
                wall.append(brick.colored(CLAY.map(|c| c * tone)));
            }
        }
    }
    wall
}
