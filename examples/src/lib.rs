//! # The lecture programs
//!
//! Each file in `examples/examples/` is one program that follows the code of a lecture, statement
//! by statement. It runs alone (`cargo run --release -p examples --example textured_square`, with a
//! picture of yours after `--`), and this library collects all of them for the gallery.
//!
//! | module | is |
//! |---|---|
//! | [`window`] | the context, its picture, the command line of a program |
//! | [`shader`] | compiling and uniforms, under the names of the CS380 lecture |
//! | [`texture`] | texture and framebuffer objects |
//! | [`mesh`] | planes, boxes, spheres, tori |
//! | [`matrix`] | matrices in `f64` |
//! | [`mod@picture`] | picture files, and procedural pictures that replace them |
//! | [`corridor`] | the room of the lightmap picture, and its baked light |
//! | [`scene`] | scenes that several programs share |
//! | `label` | labels at points of a picture ([`Window::label`](window::Window::label)) |
//! | [`tables`] | ripmaps and summed areas |
//! | [`wire`] | lines for diagrams |
//! | [`teapot`] | Newell's teapot, in bicubic patches |
//! | [`stretch`] | how a texture is stretched on a surface |
//! | [`locality`] | the lines of a cache that texels take, by the order of their addresses |
//! | [`plane_view`] | a plane in perspective, pixel by pixel |
//! | [`area`] | exact area integration |
//! | [`printed_shaders`] | the shaders of CS380's slides, as printed |
//! | [`programs`] | the list of programs |
//! | [`inputs`] | the inputs of a picture, shown beside its result |
//! | [`lectures`] | `docs/lectures.md`: which programs and checks have each item of the lectures |
//! | [`arguments`] | what command lines accept, and what they say of the rest |
//! | [`gallery`] | all pictures, and the page that shows them |

// The program files name this crate as they do when they run alone.
extern crate self as examples;

pub mod area;
pub mod arguments;
mod caption;
pub mod corridor;
mod font;
pub mod gallery;
pub mod inputs;
mod label;
pub mod lectures;
pub mod locality;
pub mod matrix;
pub mod mesh;
pub mod picture;
pub mod plane_view;
pub mod printed_shaders;
pub mod programs;
pub mod scene;
#[allow(non_snake_case, reason = "the lecture's names")]
pub mod shader;
pub mod stretch;
pub mod tables;
pub mod teapot;
pub mod texture;
pub mod window;
pub mod wire;

/// The imports of a program file: GL, GLU, and the helpers.
pub mod lecture {
    pub use crate::inputs::*;
    pub use crate::matrix::*;
    pub use crate::mesh::*;
    pub use crate::picture::packed_pixel_t;
    pub use crate::scene::*;
    pub use crate::shader::*;
    pub use crate::texture::{
        color_framebuffer, copy_window, cube_framebuffer, depth_framebuffer, load_cube_map,
        load_texels, load_texture, load_volume, set_filter,
    };
    pub use crate::window::{Program, Window};
    pub use gl_api::constants::*;
    pub use gl_api::glu::*;
    pub use gl_api::types::*;
    pub use gl_api::*;
}

/// The README's program compiles and runs.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct Readme;
