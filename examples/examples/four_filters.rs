//! The four-way filter comparison on a floor of tiles.
//!
//! *Texture Mapping*, slide "Mipmap Texture Filtering". Above, without mipmaps: point sampling and linear
//! filtering; the far tiles are noise. Below, with them: mipmapped point sampling, whose levels show as
//! bands, and mipmapped linear filtering. On the right, slide "How do we anti-alias textures?": true area
//! integration, the exact mean of the texture over the quadrilateral that is a pixel's footprint, and how far
//! mipmapped linear filtering is from it.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::area::{AreaTexture, pixel_corners};
use examples::lecture::*;
use examples::picture::{Picture, packed_pixel_t};
use examples::plane_view::PlaneView;
use glam::dvec2;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "four_filters",
    lecture: "Texture Mapping: \"Mipmap Texture Filtering\"",
    source: include_str!("four_filters.rs"),
    halves: [6, 4],
    panels: &[
        "point sampling",
        "linear filtering",
        "mipmapped point sampling",
        "mipmapped linear filtering",
        "true area integration",
        "mipmapped linear, less the area: × 4 + grey",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Minification and magnification filters, as the slide has them.
const FILTERS: [(i32, GLenum, GLenum); 4] = [
    (0, GL_NEAREST, GL_NEAREST),
    (1, GL_LINEAR, GL_LINEAR),
    (3, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST),
    (4, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR),
];

const SKY: [f64; 3] = [0.55, 0.68, 0.85];

fn draw(window: &mut Window) {
    let [red, green, blue] = SKY;
    glClearColor(red, green, blue, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    load_texture(0, tiles(), GL_REPEAT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    for (panel, minify, magnify) in FILTERS {
        set_filter(GL_TEXTURE_2D, minify, magnify);
        draw_floor(window.panel(3, 2, panel));
    }
    glDisable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
    let [width, height] = [window.width / 3, window.height / 2];
    let mut linear = vec![packed_pixel_t::default(); (width * height) as usize];
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(width, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, &mut linear);
    let area = area_integrated(width, height);
    let less = |a: u8, b: u8| (128 + 4 * (i32::from(a) - i32::from(b))).clamp(0, 255) as u8;
    let difference: Vec<packed_pixel_t> = linear
        .iter()
        .zip(&area)
        .map(|(a, b)| packed_pixel_t { r: less(a.r, b.r), g: less(a.g, b.g), b: less(a.b, b.b) })
        .collect();
    for (panel, pixels) in [(2, &area), (5, &difference)] {
        window.panel(3, 2, panel);
        glWindowPos2i(2 * width, height - panel / 5 * height);
        glDrawPixels(width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    }
}

/// The floor, each pixel the exact mean over its footprint; rows from the bottom up.
fn area_integrated(width: i32, height: i32) -> Vec<packed_pixel_t> {
    let texture = AreaTexture::new(&tiles().flipped());
    let size = [width, height].map(f64::from);
    let view = perspective(60., size[0] / size[1], 0.1, 200.)
        * rotate(17., DVec3::X)
        * translate(0., -1., 0.);
    let plane = PlaneView::new(&view, size);
    let texel = |at| 64. * (0.25 * plane.point(at) + dvec2(0.5, 0.));
    let mut pixels = Vec::new();
    for at in 0..width * height {
        let corners = pixel_corners(f64::from(at % width), f64::from(at / width));
        let is_floor =
            corners.iter().all(|&at| plane.is_below_horizon(at) && plane.point(at).y > -120.);
        let color = if is_floor { texture.mean(&corners.map(texel)) } else { SKY };
        let [r, g, b] = color.map(|c| (255. * c + 0.5) as u8);
        pixels.push(packed_pixel_t { r, g, b });
    }
    pixels
}

/// Red and cream tiles with dark joints.
fn tiles() -> Picture {
    Picture::paint(64, 64, |x, y| {
        let (u, v) = (x * 4.0, y * 4.0);
        if u.fract().min(v.fract()) < 0.12 {
            return [0.12, 0.10, 0.10];
        }
        if (u.floor() + v.floor()) % 2.0 == 0.0 { [0.95, 0.90, 0.78] } else { [0.72, 0.16, 0.12] }
    })
}

/// A floor of tiles to the horizon, four units a tile's pattern.
fn draw_floor(aspect: f64) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60, aspect, 0.1, 200);
    glRotatef(17, 1, 0, 0);
    glBegin(GL_QUADS);
    for (x, z) in [(-90, 0), (90, 0), (90, -120), (-90, -120)] {
        glTexCoord2f(0.25 * f64::from(x) + 0.5, 0.25 * f64::from(z));
        glVertex3f(x, -1, z);
    }
    glEnd();
}
