//! The uniform words of the fixed function, counted from its first one. They follow those of the
//! program where one stage is a program's.
//!
//! Words that nearly every draw reads come first: a draw has the words up to the last one that its stages read, and
//! only the groups that they read are updated.

use crate::interface::{MAX_CLIP_PLANES, MAX_LIGHTS, MAX_TEXTURE_UNITS, Side};

/// Reference of the alpha test.
pub const ALPHA_REF: u32 = 0;
/// Fog: colour (3 words), factor and offset of the distance.
pub const FOG: u32 = ALPHA_REF + 1;
/// Environment colours, 4 words a unit.
pub const ENV_COLOR: u32 = FOG + 5;
/// Model-view-projection matrix, 16 words column by column.
pub const MVP: u32 = ENV_COLOR + 4 * MAX_TEXTURE_UNITS as u32;
/// Model-view matrix, 16 words column by column.
pub const MODELVIEW: u32 = MVP + 16;
/// What normals are multiplied by, 9 words column by column.
pub const NORMAL: u32 = MODELVIEW + 16;
/// Points: size, least and largest size, constant, linear and quadratic attenuation.
pub const POINT: u32 = NORMAL + 9;
/// Ambient colour of the lighting model, 3 words.
pub const MODEL_AMBIENT: u32 = POINT + 6;
/// Materials, [`MATERIAL_WORDS`] a side.
const MATERIALS: u32 = MODEL_AMBIENT + 3;
/// Lights, [`LIGHT_WORDS`] each.
const LIGHTS: u32 = MATERIALS + 2 * MATERIAL_WORDS;
/// User clip planes in object coordinates, 4 words each; in eye coordinates beside a program.
pub const CLIP_PLANES: u32 = LIGHTS + LIGHT_WORDS * MAX_LIGHTS as u32;
/// Planes of generated coordinates, in object coordinates: 4 words for each of s, t, r, q of each
/// unit.
pub const PLANES: u32 = CLIP_PLANES + 4 * MAX_CLIP_PLANES as u32;
/// Texture matrices, 16 words a unit.
pub const TEXTURE_MATRIX: u32 = PLANES + 16 * MAX_TEXTURE_UNITS as u32;
/// How many there are.
pub const COUNT: u32 = TEXTURE_MATRIX + 16 * MAX_TEXTURE_UNITS as u32;

/// Of a material: what of the scene's colour is constant (3 words), alpha, shininess.
pub const MATERIAL_WORDS: u32 = 5;
/// Of a light: position (or direction) and half vector (3 words each), spot axis (3), cosine of the
/// cutoff, spot exponent, attenuation (3), then for each side its products with the material's
/// ambient, diffuse and specular colour (3 each).
pub const LIGHT_WORDS: u32 = GEOMETRY_WORDS + 2 * 9;
const GEOMETRY_WORDS: u32 = 14;

fn side_number(side: Side) -> u32 {
    match side {
        Side::Front => 0,
        Side::Back => 1,
    }
}

/// The first word of a side's material.
pub fn material(side: Side) -> u32 {
    MATERIALS + MATERIAL_WORDS * side_number(side)
}

/// The first word of a light.
pub fn light(index: usize) -> u32 {
    LIGHTS + LIGHT_WORDS * index as u32
}

/// The first word of a light's products with a side's material.
pub fn products(index: usize, side: Side) -> u32 {
    light(index) + GEOMETRY_WORDS + 9 * side_number(side)
}
