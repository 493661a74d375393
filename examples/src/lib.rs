//! # The lecture programs
//!
//! Each file in `examples/examples/` is one program that follows the code of a lecture, statement
//! by statement. It runs alone (`cargo run --release -p examples --example textured_square --
//! picture.ppm`), and this library collects all of them for the gallery.
//!
//! | module | is |
//! |---|---|
//! | [`window`] | the context, the picture it shows, the command line of a program |
//! | [`shader`] | compiling and uniforms, under the names of the CS380 lecture |
//! | [`texture`] | texture objects, where how they are made is not the point |
//! | [`mesh`] | planes, boxes, spheres, tori |
//! | [`matrix`] | matrices in `f64` |
//! | [`mod@picture`] | picture files, and the drawn pictures that stand in for them |
//! | [`corridor`] | the room of the lightmap picture, and its baked light |
//! | [`gallery`] | all pictures, and the page that shows them |

// The program files name this crate as they do when they run alone.
extern crate self as examples;

pub mod corridor;
pub mod gallery;
pub mod matrix;
pub mod mesh;
pub mod picture;
#[allow(non_snake_case, reason = "the lecture's names")]
pub mod shader;
pub mod texture;
pub mod window;

/// What a program file needs: GL, GLU, and the helpers.
pub mod lecture {
    pub use crate::matrix::*;
    pub use crate::mesh::*;
    pub use crate::picture::packed_pixel_t;
    pub use crate::shader::*;
    pub use crate::texture::{load_cube_map, load_texture};
    pub use crate::window::{Program, Window};
    pub use gl_api::constants::*;
    pub use gl_api::entry::*;
    pub use gl_api::glu::*;
    pub use gl_api::types::*;
}

/// The program files, in the order of the lectures.
pub mod programs {
    #[path = "../../examples/demon_triangle.rs"]
    pub mod demon_triangle;
    #[path = "../../examples/environment_map.rs"]
    pub mod environment_map;
    #[path = "../../examples/lecture_mistakes.rs"]
    pub mod lecture_mistakes;
    #[path = "../../examples/lightmap_decal.rs"]
    pub mod lightmap_decal;
    #[path = "../../examples/multipass.rs"]
    pub mod multipass;
    #[path = "../../examples/normal_mapping.rs"]
    pub mod normal_mapping;
    #[path = "../../examples/projector.rs"]
    pub mod projector;
    #[path = "../../examples/shadow_map.rs"]
    pub mod shadow_map;
    #[path = "../../examples/textured_square.rs"]
    pub mod textured_square;

    use crate::window::Program;

    /// All of them.
    pub const ALL: [Program; 9] = [
        demon_triangle::PROGRAM,
        lightmap_decal::PROGRAM,
        textured_square::PROGRAM,
        normal_mapping::PROGRAM,
        environment_map::PROGRAM,
        projector::PROGRAM,
        multipass::PROGRAM,
        shadow_map::PROGRAM,
        lecture_mistakes::PROGRAM,
    ];
}
