//! Fine geometry, or a texture of it: a carpet and a brick wall, with their triangles counted.
//!
//! *eScience*, slide 3, "The Quest for Visual Realism": a carpet's fibres are of one colour, and light makes it
//! vary. *TA 6*, "Textures": bricks as geometry, and a better way. From left to right: one flat face; every
//! fibre and brick modelled; a face with a texture, which is a picture of the geometry, taken from the front.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
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
                translate(0., if panel < 3 { 0.3 } else { 0.1 }, -3.9) * rotate(tilt, DVec3::X);
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
