//! Forward mapping's holes and overlaps, and what repairs them: fractional areas of pixels, summed and divided.
//!
//! *eScience*, slide 8: a patch of the texture "does not match up with the pixels' boundaries, thus requiring
//! calculation of the fractional area of pixel coverage". 32 × 32 texels are sent to 48 × 48 pixels. Above: each
//! texel to one pixel, the last one wins; how many texels came to a pixel: 0 black, 1 grey, 2 yellow, more red.
//! Below: their plain sum, and the sum of each colour times the part of the pixel that its texel covers, over
//! the sum of the parts (64 points a pixel measure them).
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "forward_coverage",
    lecture: "eScience: slide 8, fractional area of pixel coverage",
    source: include_str!("forward_coverage.rs"),
    halves: [4, 4],
    panels: &["one pixel a texel", "texels a pixel", "their sum", "areas as weights"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0; // sums of r, g, b and 1
uniform int uShow;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec4 sum = texture2DLod(uTexUnit0, vTexCoord, 0.0);
    // The mean of 8 x 8 points is the third level.
    if (uShow == 3) sum = texture2DLod(uTexUnit0, vTexCoord, 3.0);
    vec3 color = sum.rgb;
    if (uShow == 1) {
        color = vec3(0.5) * min(sum.a, 1.0);
        if (sum.a > 1.5) color = vec3(0.95, 0.85, 0.2);
        if (sum.a > 2.5) color = vec3(0.85, 0.15, 0.1);
    }
    if (uShow == 3) color = sum.rgb / max(sum.a, 0.001) * min(1.0, 2.0 * sum.a);
    fragColor = vec4(color, 1.0);
}
";

const TEXELS: usize = 32;
const PIXELS: GLsizei = 48;

/// A texel's place and its colour.
type Texel = ([usize; 2], [u8; 3]);

fn draw(window: &mut Window) {
    let image = window.picture("demon_image.h").flipped();
    let texels: Vec<Texel> = (0..TEXELS * TEXELS)
        .map(|at| {
            let place = [at % TEXELS, at / TEXELS];
            let [x, y] = [place[0] * image.width / TEXELS, place[1] * image.height / TEXELS];
            let pixel = image.pixels[y * image.width + x];
            (place, [pixel.r, pixel.g, pixel.b])
        })
        .collect();
    glBlendFunc(GL_ONE, GL_ONE);
    let last = forward(PIXELS, || send(&texels, GL_POINTS));
    glEnable(GL_BLEND);
    let sums = forward(PIXELS, || send(&texels, GL_POINTS));
    let areas = forward(8 * PIXELS, || send(&texels, GL_QUADS));
    glDisable(GL_BLEND);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let square = Mesh::plane().upload();
    for (panel, texture) in (0..).zip([last, sums, sums, areas]) {
        window.panel(2, 2, panel);
        glBindTexture(GL_TEXTURE_2D, texture);
        use_program(program, &DMat4::IDENTITY, &DMat4::IDENTITY);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), panel);
        square.draw(program);
    }
}

/// A texture of floats, with mipmaps, in which something was drawn through the camera.
fn forward(side: GLsizei, draw: impl Fn()) -> GLuint {
    let (mut fbo, mut sums): (GLuint, GLuint) = (0, 0);
    glGenTextures(1, &mut sums);
    glBindTexture(GL_TEXTURE_2D, sums);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F_ARB, side, side, 0, GL_RGBA, GL_FLOAT, NULL);
    set_filter(GL_TEXTURE_2D, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST);
    glGenFramebuffers(1, &mut fbo);
    glBindFramebuffer(GL_FRAMEBUFFER, fbo);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, sums, 0);
    glViewport(0, 0, side, side);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60, 1, 0.1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0.1, -2.3);
    glRotatef(-58, 1, 0, 0);
    glRotatef(12, 0, 0, 1);
    draw();
    glGenerateMipmap(GL_TEXTURE_2D);
    sums
}

/// Draws each texel as a point in its middle, or as its square.
fn send(texels: &[Texel], kind: GLenum) {
    let corners: &[(f64, f64)] = match kind {
        GL_POINTS => &[(0.5, 0.5)],
        _ => &[(0., 0.), (1., 0.), (1., 1.), (0., 1.)],
    };
    glBegin(kind);
    for ([s, t], color) in texels {
        glColor3ubv(color);
        for (x, y) in corners {
            let place = |at: usize, part: f64| 2. * (at as f64 + part) / TEXELS as f64 - 1.;
            glVertex2d(place(*s, *x), place(*t, *y));
        }
    }
    glEnd();
}
