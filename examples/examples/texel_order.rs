//! Addresses of texels, and how many lines of a cache they take.
//!
//! *Texture Mapping*, slide "Determine Texel Addresses": base + bytesPerTexel · (i + j · width), and "more complicated
//! address schemes are needed for good texture locality!". Three orders of 16 × 16 texels of four bytes; one
//! colour is one line of 64 bytes, dark to bright by address. The curves: 128 × 64 pixels, row by row, each of which reads
//! four texels through a cache of 64 lines; rows are as good as the others until the texture is turned.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::locality::{ORDERS, Order, lines_per_pixel};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "texel_order",
    lecture: "Texture Mapping: \"Determine Texel Addresses\"",
    source: include_str!("texel_order.rs"),
    halves: [4, 4],
    panels: &[
        "rows: a line of the cache has 16 × 1 texels",
        "tiles of 8 × 8: 8 × 2 texels",
        "Morton order: 4 × 4 texels",
        "lines loaded a pixel, the texture turned by 0 to 90°",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Colours of the curves: rows, tiles, Morton.
const COLORS: [[f64; 3]; 3] = [[0.95, 0.35, 0.30], [0.95, 0.80, 0.30], [0.40, 0.80, 0.95]];

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.11, 0.15, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (panel, order) in (0..).zip(ORDERS) {
        window.panel(2, 2, panel);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glOrtho(-0.5, 16.5, -2, 16.5, -1, 1);
        addresses(order);
    }
    window.panel(2, 2, 3);
    glLoadIdentity();
    glOrtho(-12, 94, -0.25, 1.3, -1, 1);
    curves(window);
}

/// Squares for 16 × 16 texels, and the way through them in the order of their addresses.
fn addresses(order: Order) {
    let mut way = [(0, 0); 256];
    glBegin(GL_QUADS);
    for j in 0..16 {
        for i in 0..16 {
            // A texture that is 16 texels wide.
            let address = order.address(i, j, 16);
            way[address as usize / 4] = (i, j);
            let line = address / 64;
            let [r, g, b] = COLORS[line as usize % 3];
            let light = 0.25 + 0.75 * f64::from(address % 64) / 64.;
            glColor3f(r * light, g * light, b * light);
            square(i, j);
        }
    }
    glEnd();
    glColor3f(0.05, 0.05, 0.08);
    glBegin(GL_LINE_STRIP);
    way.iter().for_each(|&(i, j)| glVertex2f(f64::from(i) + 0.5, f64::from(j) + 0.5));
    glEnd();
}

/// Four vertices around a texel.
fn square(i: u32, j: u32) {
    for (x, y) in [(0.04, 0.04), (0.96, 0.04), (0.96, 0.96), (0.04, 0.96)] {
        glVertex2f(f64::from(i) + x, f64::from(j) + y);
    }
}

/// Lines loaded per pixel over the texture's rotation.
fn curves(window: &mut Window) {
    glColor3f(0.45, 0.47, 0.52);
    glBegin(GL_LINES);
    for at in [0., 0.5, 1.] {
        glVertex2f(0, at);
        glVertex2f(90, at);
    }
    for degrees in [0, 45, 90] {
        glVertex2f(degrees, 0);
        glVertex2f(degrees, 1.2);
    }
    glEnd();
    for (order, [r, g, b]) in ORDERS.into_iter().zip(COLORS) {
        glColor3f(r, g, b);
        glLineWidth((f64::from(window.width) / 250.).max(1.));
        glBegin(GL_LINE_STRIP);
        for degrees in (0..=90).step_by(5) {
            glVertex2f(degrees, lines_per_pixel(order, f64::from(degrees)));
        }
        glEnd();
    }
    glLineWidth(1);
    for (y, text) in [(0., "0"), (0.5, "0.5"), (1., "1")] {
        window.caption(0.505, 0.5 * (y + 0.22) / 1.55, text);
    }
    for (y, text) in [(0.445, "red: rows"), (0.42, "yellow: tiles"), (0.395, "blue: Morton")] {
        window.caption(0.575, y, text);
    }
}
