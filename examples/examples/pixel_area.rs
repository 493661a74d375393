//! A pixel's area in the texture, nine texels to a pixel, and six ways to take their colour.
//!
//! *eScience*, slides 11, 12 and 15. On the left eight by eight pixels of a turned square; the marked one, in the
//! middle, is the marked area of the texture, of nine texels. On the right its colour: by one point; by the
//! pixel's four corners (Crow 1981); by the mean of the area (Catmull 1978); from the levels of 4:1 and 16:1; by
//! the mean of those two, as the slide says; and by GL, which weights them by λ = log2 3: 0.415 and 0.585.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::noise::hash;
use examples::picture::{Color, Picture};
use gl_api::glu::angle::sin_cos_degrees;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "pixel_area",
    lecture: "eScience: slides 11, 12 and 15, a pixel as an area",
    source: include_str!("pixel_area.rs"),
    halves: [6, 2],
    panels: &["pixels", "the pixel's area in the texture", "its colour"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform int uShow;
uniform vec4 uSides; // of the pixel: to the right, and upward
in vec2 vTexCoord;
out vec4 fragColor;

const vec2 middle = vec2(0.5);
void main() {
    vec2 right = uSides.xy, up = uSides.zw, at = middle + 0.5 * right + 0.5 * up;
    vec4 color = textureGrad(uTexUnit0, at, right, up);
    vec4 level1 = texture2DLod(uTexUnit0, at, 1.0), level2 = texture2DLod(uTexUnit0, at, 2.0);
    if (uShow == 0) color = texelFetch(uTexUnit0, ivec2(at * 16.0), 0);
    if (uShow == 1) {
        color = vec4(0.0);
        for (int corner = 0; corner < 4; corner++) {
            vec2 of = middle + float(corner & 1) * right + float(corner >> 1) * up;
            color += 0.25 * texelFetch(uTexUnit0, ivec2(of * 16.0), 0);
        }
    }
    if (uShow == 2) {
        color = vec4(0.0);
        for (int point = 0; point < 1024; point++) {
            vec2 of = (vec2(point & 31, point >> 5) + 0.5) / 32.0;
            color += texelFetch(uTexUnit0, ivec2((middle + of.x * right + of.y * up) * 16.0), 0) / 1024.0;
        }
    }
    if (uShow == 3) color = level1;
    if (uShow == 4) color = level2;
    if (uShow == 5) color = 0.5 * (level1 + level2);
    if (uShow == 7) color = textureGrad(uTexUnit0, vTexCoord, right, up);
    fragColor = color;
}
";

const TEXELS: usize = 16;
const PIXELS: i32 = 8;
const YELLOW: [f32; 3] = [1., 0.95, 0.2];
const COLORS: [Color; 4] =
    [[0.95, 0.92, 0.85], [0.90, 0.45, 0.10], [0.15, 0.25, 0.65], [0.10, 0.45, 0.35]];
const WAYS: [&str; 7] = [
    "one point",
    "four corners",
    "the area",
    "level 4:1",
    "level 16:1",
    "mean of both",
    "GL, λ = 1.58",
];

fn draw(window: &mut Window) {
    let texture = load_texture(0, texels(), GL_CLAMP_TO_EDGE);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let (sin, cos) = sin_cos_degrees(25.);
    let side = 3. / TEXELS as f64;
    let show = safe_glGetUniformLocation(program, "uShow");
    let square = Mesh::plane().upload();
    let draw_square = |way: i32, place: &DMat4| {
        use_program(program, &DMat4::IDENTITY, place);
        let sides = safe_glGetUniformLocation(program, "uSides");
        glUniform4f(sides, side * cos, side * sin, -side * sin, side * cos);
        safe_glUniform1i(show, way);
        square.draw(program);
        glUseProgram(0);
    };
    glClearColor(0.20, 0.24, 0.32, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    // Texels from the middle are turned by 25 degrees, and three of them go to a pixel.
    let turned = rotate(-25., DVec3::Z) * DMat4::from_scale(DVec3::splat(2. / 3.));
    glViewport(0, 0, PIXELS, PIXELS);
    draw_square(7, &turned);
    let pixels = copy_window(PIXELS);
    glClear(GL_COLOR_BUFFER_BIT);

    window.panel(3, 1, 0);
    show_flat(pixels);
    outline(|x, y| [0.25 * 0.92 * x, 0.25 * 0.92 * y]);
    window.panel(3, 1, 1);
    glBindTexture(GL_TEXTURE_2D, texture);
    set_filter(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
    show_flat(texture);
    outline(|x, y| {
        [0.92 * 2. * side * (x * cos - y * sin), 0.92 * 2. * side * (x * sin + y * cos)]
    });
    set_filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    window.panel(3, 1, 2);
    for (way, name) in (0..).zip(WAYS) {
        let y = 0.86 - 0.25 * f64::from(way);
        let place = translate(0.5, y, 0.) * DMat4::from_scale(dvec3(0.4, 0.11, 1.));
        draw_square(way, &place);
        window.label(-0.45, y, [1.; 3], name);
    }
    window.label(0., -0.88, YELLOW, "9 texels : 1 pixel");
}

/// The outline of the unit square, moved to its place in the viewport.
fn outline(place: impl Fn(f64, f64) -> [f64; 2]) {
    glUseProgram(0);
    glDisable(GL_TEXTURE_2D);
    for mode in [GL_PROJECTION, GL_MODELVIEW] {
        glMatrixMode(mode);
        glLoadIdentity();
    }
    glColor3fv(&YELLOW);
    glLineWidth(3);
    glBegin(GL_LINE_LOOP);
    for (x, y) in [(0., 0.), (1., 0.), (1., 1.), (0., 1.)] {
        glVertex2dv(&place(x, y));
    }
    glEnd();
}

/// Texels of one colour each, in no order.
fn texels() -> Picture {
    Picture::paint_centers(TEXELS, TEXELS, |x, y| {
        let at = |place: f64| (place * TEXELS as f64) as i64;
        COLORS[(hash(at(x), at(y), 9) * COLORS.len() as f64) as usize]
    })
}
