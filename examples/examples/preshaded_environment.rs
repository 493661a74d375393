//! Pre-shaded environment maps: the material is in the map.
//!
//! *eScience*, slide 32 (SGI's ClearCoat). The surroundings are blurred once, into a small cube map a material:
//! each texel is the mean of all directions, weighted by cos^n around its own. Shading is then one look:
//! by the normal for the matte ball (n = 1), by the reflection for the others (n = 12, and 60); the last ball
//! has a clear coat, a mirror over the matte.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "preshaded_environment",
    lecture: "eScience: slide 32, \"Pre-shaded environment maps\"",
    source: include_str!("preshaded_environment.rs"),
    halves: [4, 2],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Pass 1: the mean around a direction, over 6 × 12 × 12 places of the cube.
const BLUR_FRAGMENT_SHADER: &str = "\
#version 130
uniform samplerCube uTexUnit0;
uniform float uExponent;
in vec3 vObject;
out vec4 fragColor;

vec4 look(vec3 from, vec3 toward) {
    // Far places of a face have a smaller solid angle.
    float weight = pow(max(0.0, dot(from, normalize(toward))), uExponent);
    weight /= dot(toward, toward) * length(toward);
    return weight * vec4(textureCube(uTexUnit0, toward).rgb, 1.0);
}

void main() {
    vec3 from = normalize(vObject);
    vec4 sum = vec4(0.0);
    for (int y = 0; y < 12; y++) {
        for (int x = 0; x < 12; x++) {
            vec2 at = (vec2(x, y) + 0.5) / 6.0 - 1.0;
            sum += look(from, vec3(at, 1.0)) + look(from, vec3(at, -1.0));
            sum += look(from, vec3(at.x, 1.0, at.y)) + look(from, vec3(at.x, -1.0, at.y));
            sum += look(from, vec3(1.0, at)) + look(from, vec3(-1.0, at));
        }
    }
    fragColor = vec4(sum.rgb / sum.a, 1.0);
}
";

/// Pass 2: one look, or two.
const FRAGMENT_SHADER: &str = "\
#version 130
uniform samplerCube uTexUnit0; // as it is
uniform samplerCube uTexUnit1; // blurred
uniform int uMaterial;         // 0: surroundings, 1: matte, 2: glossy, 3: clear coat
in vec3 vPosition;
in vec3 vNormal;
out vec4 fragColor;

void main() {
    vec3 v = normalize(vPosition), n = normalize(vNormal);
    vec3 bounced = reflect(v, n);
    vec3 color = textureCube(uTexUnit1, uMaterial == 2 ? bounced : n).rgb;
    float coat = 0.06 + 0.94 * pow(1.0 - max(0.0, dot(-v, n)), 5.0);
    vec3 mirror = textureCube(uTexUnit0, bounced).rgb;
    if (uMaterial == 3) color = mix(color * vec3(0.9, 0.25, 0.2), mirror, coat);
    if (uMaterial == 0) color = textureCube(uTexUnit0, v).rgb;
    fragColor = vec4(color, 1.0);
}
";

/// Side of a blurred face.
const SIDE: GLsizei = 16;

/// Exponent; and of each ball, material and place.
const BALLS: [(f64, &[(i32, f64)]); 3] =
    [(1., &[(1, -1.8), (3, 1.8)]), (12., &[(2, -0.6)]), (60., &[(2, 0.6)])];

fn draw(window: &mut Window) {
    load_cube_map(window);
    glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
    set_filter(GL_TEXTURE_CUBE_MAP, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    let blur = initShaders(window, EYE_VERTEX_SHADER, BLUR_FRAGMENT_SHADER);
    let shade = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let (around, ball) = (Mesh::cube().upload(), Mesh::sphere().upload());

    let (fbo, blurred) = cube_framebuffer(SIDE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    let projection = perspective(34., window.panel(1, 1, 0), 0.1, 50.);
    use_program(shade, &projection, &DMat4::from_scale(DVec3::splat(20.)));
    around.draw(shade);
    for (exponent, balls) in BALLS {
        glBindFramebuffer(GL_FRAMEBUFFER, fbo);
        glViewport(0, 0, SIDE, SIDE);
        for (face, target) in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).take(6).enumerate() {
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, blurred, 0);
            assert_eq!(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
            use_program(blur, &perspective(90., 1., 0.1, 50.), &look_through_face(face));
            safe_glUniform1f(safe_glGetUniformLocation(blur, "uExponent"), exponent);
            around.draw(blur);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        window.panel(1, 1, 0);
        glEnable(GL_CULL_FACE);
        for &(material, x) in balls {
            let place = translate(x, -0.15, -5.) * DMat4::from_scale(DVec3::splat(0.52));
            use_program(shade, &projection, &place);
            safe_glUniform1i(safe_glGetUniformLocation(shade, "uMaterial"), material);
            ball.draw(shade);
        }
        glDisable(GL_CULL_FACE);
    }
}
