//! Bump or displacement? The profile and the shadow tell.
//!
//! *eScience*, slide 30: "Compare the profiles and the shadows cast by these two objects. Which is bump mapped?"
//! From left to right a smooth ball; the ball with a bumped normal, whose shadow is the smooth one's; and the
//! ball whose points are moved by the same bumps, which its outline and its shadow show. One shadow map each.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use gl_api::glu::angle::sin_cos_degrees;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "bump_shadows",
    lecture: "eScience: slide 30, profiles and shadows",
    source: include_str!("bump_shadows.rs"),
    halves: [6, 2],
    panels: &["smooth", "bump", "displacement"],
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
uniform mat4 uSProjMatrix;
uniform mat4 uSModelViewMatrix;
uniform float uDisplace;
in vec4 aVertex;
in vec3 aNormal;
in vec3 aColor;
out vec4 vTexCoord;
out vec3 vNormal;
out vec3 vColor;

void main() {
    // The floor has no colour and no bumps.
    vec3 wave = sin(8.0 * aNormal);
    float h = uDisplace * aColor.r * wave.x * wave.y * wave.z;
    vec4 place = aVertex + vec4(h * aNormal, 0.0);
    vNormal = aNormal;
    vColor = aColor;
    vTexCoord = uSProjMatrix * uSModelViewMatrix * place;
    gl_Position = uProjMatrix * uModelViewMatrix * place;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform float uBump;
in vec4 vTexCoord;
in vec3 vNormal;
in vec3 vColor;
out vec4 fragColor;

void main() {
    vec3 n = normalize(vNormal), wave = sin(8.0 * n), slope = 8.0 * cos(8.0 * n);
    vec3 gradient = uBump * vColor.r * slope * wave.yzx * wave.zxy;
    // Only what lies in the surface turns the normal.
    vec3 bumped = normalize(n - gradient + dot(gradient, n) * n);
    float diffuse = max(0.0, dot(bumped, normalize(vec3(-3.0, 6.0, 4.0))));
    vec3 t = vTexCoord.xyz / vTexCoord.w;
    float lit = t.z - 0.012 <= texture2D(uTexUnit0, t.xy).r ? 1.0 : 0.0;
    vec3 color = vColor.r > 0.5 ? vec3(0.92, 0.62, 0.35) : vec3(0.80, 0.82, 0.85);
    fragColor = vec4(color * (0.2 + 0.85 * diffuse * lit), 1.0);
}
";

const SIZE: GLsizei = 1024;

/// Height of the bumps: of the normals, of the vertices.
const PANELS: [(f64, f64); 3] = [(0., 0.), (0.2, 0.), (0.2, 0.2)];

fn draw(window: &mut Window) {
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    let fbo = depth_framebuffer(SIZE, GL_NEAREST);
    let mut shadows: GLint = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &mut shadows);
    let other = load_texture(0, window.picture("bricks.ppm"), GL_REPEAT);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    let mut scene = Mesh::surface(192, 96, |s, t| {
        let (sin_s, cos_s) = sin_cos_degrees(360. * s);
        let (sin_t, cos_t) = sin_cos_degrees(180. * t);
        let out = dvec3(sin_t * sin_s, -cos_t, sin_t * cos_s);
        (out + DVec3::Y * 1.25, out)
    });
    let floor = rotate(-90., DVec3::X) * DMat4::from_scale(DVec3::splat(3.2));
    scene.append(Mesh::plane().moved(floor).colored([0.; 3]));
    let scene = scene.upload();
    let [light_projection, light_view] =
        [perspective(44., 1., 3., 14.), look_at(dvec3(-3., 6., 4.), dvec3(0.3, 0.8, -0.4))];
    let uniform = |name| safe_glGetUniformLocation(program, name);
    for (panel, (bump, displace)) in (0..).zip(PANELS) {
        glBindFramebuffer(GL_FRAMEBUFFER, fbo);
        glBindTexture(GL_TEXTURE_2D, other);
        glViewport(0, 0, SIZE, SIZE);
        glClear(GL_DEPTH_BUFFER_BIT);
        use_program(program, &light_projection, &light_view);
        safe_glUniform1f(uniform("uBump"), bump);
        safe_glUniform1f(uniform("uDisplace"), displace);
        scene.draw(program);

        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glBindTexture(GL_TEXTURE_2D, shadows as GLuint);
        let aspect = window.panel(3, 1, panel);
        let eye = look_at(dvec3(1.2, 3.6, 5.6), dvec3(0.35, 0.75, 0.));
        use_program(program, &perspective(40., aspect, 0.5, 40.), &eye);
        safe_glUniformMatrix4fv(uniform("uSModelViewMatrix"), &light_view);
        safe_glUniformMatrix4fv(uniform("uSProjMatrix"), &(unit_square() * light_projection));
        scene.draw(program);
    }
}
