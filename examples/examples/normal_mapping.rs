//! Normal mapping: one flat wall; the texture's r, g, b are the coordinates of its normals.
//!
//! *CS380, Texture Mapping*, slides 16 and 17; *Texture Mapping*, slides "Normal Mapping" and
//! "Multitexturing" (diffuse × decal + specular). The left third is lit without the normal map.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::normals::normal_map;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "normal_mapping",
    lecture: "CS380: slides 16 and 17, \"Normal mapping\"",
    source: include_str!("normal_mapping.rs"),
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
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
in vec4 aVertex;
in vec2 aTexCoord;
out vec4 vPosition;
out vec2 vTexCoord;

void main() {
    vPosition = uModelViewMatrix * aVertex;
    vTexCoord = aTexCoord;
    gl_Position = uProjMatrix * vPosition;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0; // decal
uniform sampler2D uTexUnit1; // normals
uniform mat4 uModelViewMatrix;
uniform vec3 uLight; // in eye coordinates
uniform float uBumps; // 0: flat, 1: as the normal map says
in vec4 vPosition;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    // normal_x = 2R - 1, and so on; then from the wall's frame to the eye's.
    vec3 normal = 2.0 * texture2D(uTexUnit1, vTexCoord).rgb - 1.0;
    normal = mix(vec3(0.0, 0.0, 1.0), normal, uBumps);
    normal = normalize((uModelViewMatrix * vec4(normal, 0.0)).xyz);

    vec3 toLight = uLight - vec3(vPosition);
    float fall = 3.2 / (2.0 + dot(toLight, toLight));
    toLight = normalize(toLight);
    vec3 toV = normalize(vec3(-vPosition));
    vec3 h = normalize(toV + toLight);
    float diffuse = max(0.0, dot(normal, toLight));
    float specular = pow(max(0.0, dot(h, normal)), 48.0);

    vec3 decal = texture2D(uTexUnit0, vTexCoord).rgb;
    vec3 intensity = decal * (0.10 + fall * diffuse) + 0.45 * fall * specular * vec3(1.0, 0.95, 0.85);
    fragColor = vec4(intensity, 1.0);
}
";

/// How many texels the bricks stand out of the wall.
const DEPTH: f64 = 7.;

fn draw(window: &mut Window) {
    glViewport(0, 0, window.width, window.height);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    load_texture(0, window.picture("bricks.ppm"), GL_REPEAT);
    load_texture(1, normal_map(&window.picture("bricks_height.ppm"), DEPTH), GL_REPEAT);

    let h_program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    glUseProgram(h_program);
    safe_glUniform1i(safe_glGetUniformLocation(h_program, "uTexUnit0"), 0);
    safe_glUniform1i(safe_glGetUniformLocation(h_program, "uTexUnit1"), 1);

    let aspect = f64::from(window.width) / f64::from(window.height);
    let h_uProjMatrix = safe_glGetUniformLocation(h_program, "uProjMatrix");
    safe_glUniformMatrix4fv(h_uProjMatrix, &perspective(50., aspect, 0.1, 50.));
    let view = look_at(dvec3(-1.5, -0.5, 3.1), dvec3(0.25, 0., 0.));
    let h_uModelViewMatrix = safe_glGetUniformLocation(h_program, "uModelViewMatrix");
    safe_glUniformMatrix4fv(h_uModelViewMatrix, &view);
    let light = view.transform_point3(dvec3(0.55, 0.75, 0.7));
    safe_glUniform3f(safe_glGetUniformLocation(h_program, "uLight"), light.x, light.y, light.z);

    let wall = Mesh::plane().moved(DMat4::from_scale(dvec3(4., 4., 1.))).tiled(5., 5.).upload();
    let h_uBumps = safe_glGetUniformLocation(h_program, "uBumps");
    let third = window.width / 3;
    glEnable(GL_SCISSOR_TEST);
    for (bumps, x, width) in [(0., 0, third), (1., third, window.width - third)] {
        glScissor(x, 0, width, window.height);
        safe_glUniform1f(h_uBumps, bumps);
        wall.draw(h_program);
    }
}
