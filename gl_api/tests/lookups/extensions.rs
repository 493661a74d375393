//! The functions that extensions bring: other names, and arrays of cubes.

use super::functions::{Names, Wrong, bytes};
use super::textures::{Kind, Texels};
use super::{Stage, context, run};
use gl_api::*;

/// The names that other extensions bring, on `GL_TEXTURE_2D` alone: preamble, call, level.
const EXTENSIONS: &[(&str, &str, usize)] = &[
    ("", "texture2D(s, vec2(0.3, 0.6))", 0),
    ("", "texture2D(s, vec2(0.3 + d / 8.0, 0.6), 1.0)", 1),
    ("", "texture2DProj(s, vec3(0.6, 1.2, 2.0))", 0),
    (LOD, "texture2DLod(s, vec2(0.3, 0.6), 1.0)", 1),
    (LOD, "texture2DProjLod(s, vec3(0.6, 1.2, 2.0), 1.0)", 1),
    (LOD, "texture2DGradARB(s, vec2(0.3, 0.6), vec2(0.25, 0.0), vec2(0.0))", 1),
    (LOD, "texture2DProjGradARB(s, vec3(0.6, 1.2, 2.0), vec2(0.0, 0.5), vec2(0.0))", 1),
    (LOD, "texture2DProjGradARB(s, vec4(0.6, 1.2, 7.0, 2.0), vec2(0.0, 0.5), vec2(0.0))", 1),
];
const LOD: &str = "#extension GL_ARB_shader_texture_lod : enable";

#[test]
fn names_of_extensions() {
    let _current = context();
    let mut wrong = Wrong::default();
    let texels = Texels { target: GL_TEXTURE_2D, size: [8, 4, 1], kind: Kind::Float };
    for &(preamble, call, level) in EXTENSIONS {
        let body = format!("r = {call};");
        let got = run(Stage::Fragment, preamble, "sampler2D", &body, texels);
        wrong.check(&body, got, bytes([[2, 2, 0], [1, 1, 0]][level], level));
    }
}

/// The layer of an array of cubes is the nearest, held in range.
#[test]
fn layers_of_cubes_are_rounded_and_held() {
    let _current = context();
    let mut wrong = Wrong::default();
    let texels = Texels { target: GL_TEXTURE_CUBE_MAP_ARRAY, size: [4, 4, 18], kind: Kind::Float };
    for (layer, cube) in [
        ("-7.0", 0),
        ("0.49", 0),
        ("0.5", 1),
        ("1.49", 1),
        ("1.5", 2),
        ("2.6", 2),
        ("1e30", 2),
        ("-1e30", 0),
    ] {
        // The middle of +Z.
        let body = format!("r = texture(s, vec4(0.1, -0.1, 1.0, {layer}));");
        let preamble = Names::Overloaded.preamble();
        let got = run(Stage::Fragment, preamble, "samplerCubeArray", &body, texels);
        wrong.check(&body, got, bytes([2, 2, 6 * cube + 4], 0));
    }
}

/// The functions come with the extension, to earlier versions too, and only with it.
#[test]
fn arrays_of_cubes_come_with_their_extension() {
    let _current = context();
    let texels = Texels { target: GL_TEXTURE_CUBE_MAP_ARRAY, size: [4, 4, 12], kind: Kind::Float };
    let body = "r = texture(s, vec4(0.1, -0.1, 1.0, 1.0));";
    let run = |preamble| run(Stage::Fragment, preamble, "samplerCubeArray", body, texels);
    let enabled = "#extension GL_ARB_texture_cube_map_array : enable";
    assert_eq!(run(enabled), Ok([2, 2, 10, 0]));
    assert!(run("#version 130").is_err_and(|log| log.contains(enabled)));
}
