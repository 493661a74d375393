//! The program files. Each is an example of cargo as well.

#[path = "../examples/anisotropic.rs"]
pub mod anisotropic;
#[path = "../examples/bicubic_patch.rs"]
pub mod bicubic_patch;
#[path = "../examples/bilinear_formula.rs"]
pub mod bilinear_formula;
#[path = "../examples/blinn_bump.rs"]
pub mod blinn_bump;
#[path = "../examples/box_environment.rs"]
pub mod box_environment;
#[path = "../examples/bump_displacement.rs"]
pub mod bump_displacement;
#[path = "../examples/bump_example.rs"]
pub mod bump_example;
#[path = "../examples/bump_shadows.rs"]
pub mod bump_shadows;
#[path = "../examples/checker_shader.rs"]
pub mod checker_shader;
#[path = "../examples/cube_map_light.rs"]
pub mod cube_map_light;
#[path = "../examples/cylindrical_mapping.rs"]
pub mod cylindrical_mapping;
#[path = "../examples/decal_skin.rs"]
pub mod decal_skin;
#[path = "../examples/demon_coordinates.rs"]
pub mod demon_coordinates;
#[path = "../examples/demon_triangle.rs"]
pub mod demon_triangle;
#[path = "../examples/displacement_vs_bump.rs"]
pub mod displacement_vs_bump;
#[path = "../examples/dynamic_cube_map.rs"]
pub mod dynamic_cube_map;
#[path = "../examples/environment_map.rs"]
pub mod environment_map;
#[path = "../examples/explicit_uv.rs"]
pub mod explicit_uv;
#[path = "../examples/filter_cost.rs"]
pub mod filter_cost;
#[path = "../examples/fixed_point.rs"]
pub mod fixed_point;
#[path = "../examples/footprint.rs"]
pub mod footprint;
#[path = "../examples/forward_coverage.rs"]
pub mod forward_coverage;
#[path = "../examples/forward_inverse.rs"]
pub mod forward_inverse;
#[path = "../examples/four_filters.rs"]
pub mod four_filters;
#[path = "../examples/four_maps.rs"]
pub mod four_maps;
#[path = "../examples/geometry_or_texture.rs"]
pub mod geometry_or_texture;
#[path = "../examples/gift_wrapping.rs"]
pub mod gift_wrapping;
#[path = "../examples/gloss_map.rs"]
pub mod gloss_map;
#[path = "../examples/gouraud.rs"]
pub mod gouraud;
#[path = "../examples/interpolation.rs"]
pub mod interpolation;
#[path = "../examples/key_frames.rs"]
pub mod key_frames;
#[path = "../examples/lecture_mistakes.rs"]
pub mod lecture_mistakes;
#[path = "../examples/level_of_detail.rs"]
pub mod level_of_detail;
#[path = "../examples/lightmap_decal.rs"]
pub mod lightmap_decal;
#[path = "../examples/magnification.rs"]
pub mod magnification;
#[path = "../examples/map_shapes.rs"]
pub mod map_shapes;
#[path = "../examples/material_maps.rs"]
pub mod material_maps;
#[path = "../examples/minification.rs"]
pub mod minification;
#[path = "../examples/mip_pyramid.rs"]
pub mod mip_pyramid;
#[path = "../examples/mip_seams.rs"]
pub mod mip_seams;
#[path = "../examples/multipass.rs"]
pub mod multipass;
#[path = "../examples/normal_mapping.rs"]
pub mod normal_mapping;
#[path = "../examples/one_edge.rs"]
pub mod one_edge;
#[path = "../examples/oriented_normals.rs"]
pub mod oriented_normals;
#[path = "../examples/parametric.rs"]
pub mod parametric;
#[path = "../examples/perspective_correct.rs"]
pub mod perspective_correct;
#[path = "../examples/pixel_area.rs"]
pub mod pixel_area;
#[path = "../examples/planar_mapping.rs"]
pub mod planar_mapping;
#[path = "../examples/prefiltering.rs"]
pub mod prefiltering;
#[path = "../examples/preshaded_environment.rs"]
pub mod preshaded_environment;
#[path = "../examples/procedural.rs"]
pub mod procedural;
#[path = "../examples/projective_q.rs"]
pub mod projective_q;
#[path = "../examples/projective_shortcut.rs"]
pub mod projective_shortcut;
#[path = "../examples/projector.rs"]
pub mod projector;
#[path = "../examples/refraction.rs"]
pub mod refraction;
#[path = "../examples/rho_measures.rs"]
pub mod rho_measures;
#[path = "../examples/ripmap.rs"]
pub mod ripmap;
#[path = "../examples/shadow2d_proj.rs"]
pub mod shadow2d_proj;
#[path = "../examples/shadow_bias.rs"]
pub mod shadow_bias;
#[path = "../examples/shadow_map.rs"]
pub mod shadow_map;
#[path = "../examples/skins.rs"]
pub mod skins;
#[path = "../examples/solid_marble.rs"]
pub mod solid_marble;
#[path = "../examples/spaces.rs"]
pub mod spaces;
#[path = "../examples/sphere_map.rs"]
pub mod sphere_map;
#[path = "../examples/spherical_mapping.rs"]
pub mod spherical_mapping;
#[path = "../examples/supersampling.rs"]
pub mod supersampling;
#[path = "../examples/terrain.rs"]
pub mod terrain;
#[path = "../examples/texel_order.rs"]
pub mod texel_order;
#[path = "../examples/texgen.rs"]
pub mod texgen;
#[path = "../examples/texture_matrix.rs"]
pub mod texture_matrix;
#[path = "../examples/textured_square.rs"]
pub mod textured_square;
#[path = "../examples/tiling.rs"]
pub mod tiling;
#[path = "../examples/transparency.rs"]
pub mod transparency;
#[path = "../examples/triplanar.rs"]
pub mod triplanar;
#[path = "../examples/view_independence.rs"]
pub mod view_independence;
#[path = "../examples/visual_realism.rs"]
pub mod visual_realism;
#[path = "../examples/wall_lawn_sky.rs"]
pub mod wall_lawn_sky;

use crate::window::Program;

/// All of them, in the order of the techniques: mapping, interpolation and sampling, light.
pub const ALL: [Program; 77] = [
    textured_square::PROGRAM,
    geometry_or_texture::PROGRAM,
    wall_lawn_sky::PROGRAM,
    visual_realism::PROGRAM,
    explicit_uv::PROGRAM,
    bicubic_patch::PROGRAM,
    gift_wrapping::PROGRAM,
    parametric::PROGRAM,
    spaces::PROGRAM,
    demon_triangle::PROGRAM,
    demon_coordinates::PROGRAM,
    decal_skin::PROGRAM,
    skins::PROGRAM,
    key_frames::PROGRAM,
    lightmap_decal::PROGRAM,
    gloss_map::PROGRAM,
    four_maps::PROGRAM,
    material_maps::PROGRAM,
    planar_mapping::PROGRAM,
    triplanar::PROGRAM,
    terrain::PROGRAM,
    cylindrical_mapping::PROGRAM,
    spherical_mapping::PROGRAM,
    map_shapes::PROGRAM,
    texgen::PROGRAM,
    tiling::PROGRAM,
    transparency::PROGRAM,
    texture_matrix::PROGRAM,
    checker_shader::PROGRAM,
    solid_marble::PROGRAM,
    procedural::PROGRAM,
    interpolation::PROGRAM,
    one_edge::PROGRAM,
    perspective_correct::PROGRAM,
    gouraud::PROGRAM,
    projective_q::PROGRAM,
    projective_shortcut::PROGRAM,
    fixed_point::PROGRAM,
    forward_inverse::PROGRAM,
    forward_coverage::PROGRAM,
    bilinear_formula::PROGRAM,
    magnification::PROGRAM,
    minification::PROGRAM,
    mip_pyramid::PROGRAM,
    pixel_area::PROGRAM,
    supersampling::PROGRAM,
    footprint::PROGRAM,
    rho_measures::PROGRAM,
    prefiltering::PROGRAM,
    four_filters::PROGRAM,
    mip_seams::PROGRAM,
    filter_cost::PROGRAM,
    level_of_detail::PROGRAM,
    texel_order::PROGRAM,
    anisotropic::PROGRAM,
    ripmap::PROGRAM,
    view_independence::PROGRAM,
    blinn_bump::PROGRAM,
    bump_example::PROGRAM,
    normal_mapping::PROGRAM,
    oriented_normals::PROGRAM,
    bump_displacement::PROGRAM,
    bump_shadows::PROGRAM,
    displacement_vs_bump::PROGRAM,
    sphere_map::PROGRAM,
    environment_map::PROGRAM,
    box_environment::PROGRAM,
    refraction::PROGRAM,
    dynamic_cube_map::PROGRAM,
    preshaded_environment::PROGRAM,
    cube_map_light::PROGRAM,
    projector::PROGRAM,
    multipass::PROGRAM,
    shadow_map::PROGRAM,
    shadow2d_proj::PROGRAM,
    shadow_bias::PROGRAM,
    lecture_mistakes::PROGRAM,
];
