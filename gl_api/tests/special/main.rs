//! GL 2.1's chapter 5 and what is seldom used: selection, feedback, evaluators, accumulation,
//! conditional rendering, materials of vertices, what happens to fragments; the tables of state; windows
//! with several samples;
//! and input that is bad in ways that no table of errors lists.

#[path = "../common/shading.rs"]
mod shading;
#[path = "../common/state_table.rs"]
mod state_table;

mod accumulation;
mod bad_input;
mod clip_control;
mod conditional;
mod cull_distances;
mod depth_clamp;
mod egl_images;
mod evaluators;
mod feedback;
mod fragments;
mod indices;
mod indirect;
mod level_counts;
mod materials;
mod packed;
mod provoking;
mod selection;
mod state;
mod stencil_textures;
mod stencil_texturing;
mod stored_texels;
mod view_kinds;
mod viewports;
mod views;
mod windows;

use gl_api::*;

fn context(width: u32, height: u32) -> Context {
    Context::new(ContextDesc { width, height, ..ContextDesc::default() }).expect("a device")
}

/// Nothing was refused.
#[track_caller]
fn fine(c: &mut Context) {
    let messages = c.messages();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{messages:?}");
}

/// A pixel of the window.
#[track_caller]
fn pixel(c: &mut Context, x: i32, y: i32) -> [u8; 4] {
    let mut pixel = [0; 4];
    c.read_pixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    fine(c);
    pixel
}

/// Counterclockwise corners in normalized device coordinates.
fn draw(c: &mut Context, mode: GLenum, corners: &[[f32; 3]]) {
    c.begin(mode);
    for [x, y, z] in corners {
        c.vertex_3f(*x, *y, *z);
    }
    c.end();
}

/// The whole window.
const ALL: [[f32; 3]; 4] = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
