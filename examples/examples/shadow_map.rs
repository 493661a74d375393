//! Shadow mapping: a z-buffered image from the light, compared with what the eye sees.
//!
//! *CS380, Texture Mapping*, slides 36 to 41. Pass 1 stores z as the light sees it in a depth
//! texture; pass 2 compares. On the left the fragment shader compares by itself; on the right a
//! `sampler2DShadow` compares four texels and blends the answers.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "shadow_map",
    lecture: "CS380: slides 36 to 41, \"Shadow mapping\"",
    source: include_str!("shadow_map.rs"),
    halves: [3, 2],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Pass 1: only depth is stored.
const LIGHT_VERTEX_SHADER: &str = "\
#version 130
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
in vec4 aVertex;

void main() {
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
}
";

const LIGHT_FRAGMENT_SHADER: &str = "\
#version 130

void main() {
}
";

/// Pass 2: the computation of the projector.
const VERTEX_SHADER: &str = "\
#version 130
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
uniform mat4 uSProjMatrix;
uniform mat4 uSModelViewMatrix;
in vec4 aVertex;
in vec3 aNormal;
in vec3 aColor;
out vec4 vTexCoord;
out vec3 vNormal;
out vec3 vColor;
out vec3 vToLight;

void main() {
    vTexCoord = uSProjMatrix * uSModelViewMatrix * aVertex;
    vNormal = aNormal;
    vColor = aColor;
    vToLight = vec3(3.2, 6.0, 2.6) - aVertex.xyz;
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
}
";

const COMPARE_FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
in vec4 vTexCoord;
in vec3 vNormal;
in vec3 vColor;
in vec3 vToLight;
out vec4 fragColor;

void main() {
    float diffuse = max(0.0, dot(normalize(vNormal), normalize(vToLight)));
    vec3 t = vTexCoord.xyz / vTexCoord.w;
    float seen = texture2D(uTexUnit0, t.xy).r;
    // Without a bias a surface would shadow itself, texel by texel.
    float lit = t.z - 0.0025 <= seen ? 1.0 : 0.0;
    fragColor = vec4(vColor * (0.22 + 0.85 * diffuse * lit), 1.0);
}
";

const SHADOW_FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2DShadow uTexUnit0;
in vec4 vTexCoord;
in vec3 vNormal;
in vec3 vColor;
in vec3 vToLight;
out vec4 fragColor;

void main() {
    float diffuse = max(0.0, dot(normalize(vNormal), normalize(vToLight)));
    vec4 biased = vTexCoord - vec4(0.0, 0.0, 0.0025 * vTexCoord.w, 0.0);
    float lit = shadow2DProj(uTexUnit0, biased).r;
    fragColor = vec4(vColor * (0.22 + 0.85 * diffuse * lit), 1.0);
}
";

/// Side of the depth texture.
const SIZE: GLsizei = 1024;

fn draw(window: &mut Window) {
    glEnable(GL_DEPTH_TEST);
    let (fbo, _) = depth_framebuffer();
    let model = scene().upload();
    let light_projection = perspective(60., 1., 3., 14.);
    let light_view = look_at(dvec3(3.2, 6.0, 2.6), DVec3::ZERO);

    // Pass 1: from the light, into the framebuffer object.
    let light = initShaders(window, LIGHT_VERTEX_SHADER, LIGHT_FRAGMENT_SHADER);
    glBindFramebuffer(GL_FRAMEBUFFER, fbo);
    glViewport(0, 0, SIZE, SIZE);
    glClear(GL_DEPTH_BUFFER_BIT);
    glUseProgram(light);
    safe_glUniformMatrix4fv(safe_glGetUniformLocation(light, "uProjMatrix"), &light_projection);
    safe_glUniformMatrix4fv(safe_glGetUniformLocation(light, "uModelViewMatrix"), &light_view);
    model.draw(light);

    // Pass 2: from the eye, with the depth texture.
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    let width = window.width / 2;
    let aspect = f64::from(width) / f64::from(window.height);
    for (x, fragment, compare) in [
        (0, COMPARE_FRAGMENT_SHADER, GL_NONE),
        (width, SHADOW_FRAGMENT_SHADER, GL_COMPARE_R_TO_TEXTURE),
    ] {
        let program = initShaders(window, VERTEX_SHADER, fragment);
        glViewport(x, 0, width, window.height);
        let filter = if compare == GL_NONE { GL_NEAREST } else { GL_LINEAR };
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, compare);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        glUseProgram(program);
        let uniform = |name| safe_glGetUniformLocation(program, name);
        safe_glUniform1i(uniform("uTexUnit0"), 0);
        safe_glUniformMatrix4fv(uniform("uProjMatrix"), &perspective(50., aspect, 0.5, 40.));
        let eye = look_at(dvec3(-0.9, 5.2, 5.6), dvec3(-0.1, 0.4, 0.));
        safe_glUniformMatrix4fv(uniform("uModelViewMatrix"), &eye);
        safe_glUniformMatrix4fv(uniform("uSModelViewMatrix"), &light_view);
        safe_glUniformMatrix4fv(uniform("uSProjMatrix"), &(unit_square() * light_projection));
        model.draw(program);
    }
}

fn scene() -> Mesh {
    let floor = rotate(-90., DVec3::X) * DMat4::from_scale(DVec3::splat(2.4));
    let mut scene = Mesh::plane().moved(floor).colored([0.86, 0.84, 0.80]);
    let ring = translate(0.1, 1.35, 0.1) * rotate(28., DVec3::X) * rotate(14., DVec3::Z);
    scene.append(Mesh::torus(0.26).moved(ring).colored([0.95, 0.55, 0.15]));
    let ball = translate(0.1, 1.35, 0.1) * DMat4::from_scale(DVec3::splat(0.42));
    scene.append(Mesh::sphere().moved(ball).colored([0.25, 0.50, 0.95]));
    for (x, z, degrees, side, color) in [
        (1.6, 1.2, 20., 0.32, [0.80, 0.25, 0.30]),
        (1.4, -1.4, 50., 0.45, [0.35, 0.75, 0.45]),
        (-1.7, 1.5, 75., 0.36, [0.70, 0.45, 0.85]),
    ] {
        let place = translate(x, side, z) * rotate(degrees, DVec3::Y);
        let block = Mesh::cube().moved(place * DMat4::from_scale(DVec3::splat(side)));
        scene.append(block.colored(color));
    }
    scene
}

/// A framebuffer object that has only a depth texture, which stays bound.
fn depth_framebuffer() -> (GLuint, GLuint) {
    let (mut fbo, mut texture): (GLuint, GLuint) = (0, 0);
    glGenTextures(1, &mut texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    let format = GL_DEPTH_COMPONENT;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, SIZE, SIZE, 0, format, GL_FLOAT, NULL);
    glGenFramebuffers(1, &mut fbo);
    glBindFramebuffer(GL_FRAMEBUFFER, fbo);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    assert_eq!(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    (fbo, texture)
}
