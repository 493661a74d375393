//! The program files, each of which also runs alone.

#[path = "../examples/demon_triangle.rs"]
pub mod demon_triangle;
#[path = "../examples/environment_map.rs"]
pub mod environment_map;
#[path = "../examples/lecture_mistakes.rs"]
pub mod lecture_mistakes;
#[path = "../examples/lightmap_decal.rs"]
pub mod lightmap_decal;
#[path = "../examples/multipass.rs"]
pub mod multipass;
#[path = "../examples/normal_mapping.rs"]
pub mod normal_mapping;
#[path = "../examples/projector.rs"]
pub mod projector;
#[path = "../examples/shadow_map.rs"]
pub mod shadow_map;
#[path = "../examples/textured_square.rs"]
pub mod textured_square;

use crate::window::Program;

/// All of them, in the order of the lectures.
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
