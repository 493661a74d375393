//! The program files, each of which also runs alone.

#[path = "../examples/anisotropic.rs"]
pub mod anisotropic;
#[path = "../examples/bump_displacement.rs"]
pub mod bump_displacement;
#[path = "../examples/checker_shader.rs"]
pub mod checker_shader;
#[path = "../examples/cube_map_light.rs"]
pub mod cube_map_light;
#[path = "../examples/demon_triangle.rs"]
pub mod demon_triangle;
#[path = "../examples/dynamic_cube_map.rs"]
pub mod dynamic_cube_map;
#[path = "../examples/environment_map.rs"]
pub mod environment_map;
#[path = "../examples/forward_inverse.rs"]
pub mod forward_inverse;
#[path = "../examples/four_filters.rs"]
pub mod four_filters;
#[path = "../examples/gloss_map.rs"]
pub mod gloss_map;
#[path = "../examples/lecture_mistakes.rs"]
pub mod lecture_mistakes;
#[path = "../examples/level_of_detail.rs"]
pub mod level_of_detail;
#[path = "../examples/lightmap_decal.rs"]
pub mod lightmap_decal;
#[path = "../examples/map_shapes.rs"]
pub mod map_shapes;
#[path = "../examples/mip_pyramid.rs"]
pub mod mip_pyramid;
#[path = "../examples/multipass.rs"]
pub mod multipass;
#[path = "../examples/normal_mapping.rs"]
pub mod normal_mapping;
#[path = "../examples/parametric.rs"]
pub mod parametric;
#[path = "../examples/perspective_correct.rs"]
pub mod perspective_correct;
#[path = "../examples/preshaded_environment.rs"]
pub mod preshaded_environment;
#[path = "../examples/procedural.rs"]
pub mod procedural;
#[path = "../examples/projective_q.rs"]
pub mod projective_q;
#[path = "../examples/projector.rs"]
pub mod projector;
#[path = "../examples/refraction.rs"]
pub mod refraction;
#[path = "../examples/resampling.rs"]
pub mod resampling;
#[path = "../examples/shadow_bias.rs"]
pub mod shadow_bias;
#[path = "../examples/shadow_map.rs"]
pub mod shadow_map;
#[path = "../examples/skins.rs"]
pub mod skins;
#[path = "../examples/solid_marble.rs"]
pub mod solid_marble;
#[path = "../examples/supersampling.rs"]
pub mod supersampling;
#[path = "../examples/texgen.rs"]
pub mod texgen;
#[path = "../examples/texture_matrix.rs"]
pub mod texture_matrix;
#[path = "../examples/textured_square.rs"]
pub mod textured_square;

use crate::window::Program;

/// All of them, in the order of the techniques: mapping, sampling, coordinates, light.
pub const ALL: [Program; 33] = [
    textured_square::PROGRAM,
    parametric::PROGRAM,
    demon_triangle::PROGRAM,
    skins::PROGRAM,
    lightmap_decal::PROGRAM,
    gloss_map::PROGRAM,
    checker_shader::PROGRAM,
    solid_marble::PROGRAM,
    procedural::PROGRAM,
    projective_q::PROGRAM,
    perspective_correct::PROGRAM,
    forward_inverse::PROGRAM,
    resampling::PROGRAM,
    mip_pyramid::PROGRAM,
    supersampling::PROGRAM,
    four_filters::PROGRAM,
    level_of_detail::PROGRAM,
    anisotropic::PROGRAM,
    texture_matrix::PROGRAM,
    map_shapes::PROGRAM,
    texgen::PROGRAM,
    bump_displacement::PROGRAM,
    normal_mapping::PROGRAM,
    environment_map::PROGRAM,
    refraction::PROGRAM,
    dynamic_cube_map::PROGRAM,
    preshaded_environment::PROGRAM,
    cube_map_light::PROGRAM,
    projector::PROGRAM,
    multipass::PROGRAM,
    shadow_map::PROGRAM,
    shadow_bias::PROGRAM,
    lecture_mistakes::PROGRAM,
];
