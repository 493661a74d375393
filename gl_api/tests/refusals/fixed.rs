//! What the calls of the fixed function refuse: the flag, what the message says, and that the state
//! stays.

use super::Case;
use gl_api::*;

const ENV: GLenum = GL_TEXTURE_ENV;

const CASES: &[Case] = &[
    // Lights.
    (|c| c.lightf(GL_LIGHT0 + 8, GL_SPOT_CUTOFF, 1.0), GL_INVALID_ENUM, "GL_LIGHT0 to GL_LIGHT7"),
    (|c| c.lightfv(GL_FRONT, GL_AMBIENT, &[0.0; 4]), GL_INVALID_ENUM, "light = GL_FRONT"),
    (|c| c.lightf(GL_LIGHT0, GL_SHININESS, 1.0), GL_INVALID_ENUM, "pname = GL_SHININESS must be"),
    (|c| c.lightf(GL_LIGHT0, GL_POSITION, 1.0), GL_INVALID_ENUM, "4 values"),
    (|c| c.lighti(GL_LIGHT0, GL_SPOT_DIRECTION, 1), GL_INVALID_ENUM, "3 values"),
    (|c| c.lightfv(GL_LIGHT0, GL_POSITION, &[0.0; 3]), GL_INVALID_OPERATION, "3 of 4"),
    (|c| c.lightiv(GL_LIGHT0, GL_SPOT_CUTOFF, &[]), GL_INVALID_OPERATION, "0 of 1"),
    (|c| c.lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 128.5), GL_INVALID_VALUE, "must be 0 to 128"),
    (|c| c.lighti(GL_LIGHT0, GL_SPOT_EXPONENT, -1), GL_INVALID_VALUE, "GL_SPOT_EXPONENT = -1"),
    (|c| c.lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 90.5), GL_INVALID_VALUE, "0 to 90, or 180"),
    (|c| c.lightf(GL_LIGHT0, GL_SPOT_CUTOFF, f32::NAN), GL_INVALID_VALUE, "NaN"),
    (|c| c.lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -0.5), GL_INVALID_VALUE, "not be negative"),
    (|c| c.lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, f32::NAN), GL_INVALID_VALUE, "NaN"),
    (|c| c.get_lightfv(GL_LIGHT0 + 9, GL_AMBIENT, &mut [0.0; 4]), GL_INVALID_ENUM, "light ="),
    (|c| c.get_lightiv(GL_LIGHT0, GL_EMISSION, &mut [0; 4]), GL_INVALID_ENUM, "pname ="),
    (|c| c.get_lightfv(GL_LIGHT0, GL_AMBIENT, &mut [0.0; 3]), GL_INVALID_OPERATION, "room for 3"),
    // The lighting model.
    (|c| c.light_modeli(GL_AMBIENT, 1), GL_INVALID_ENUM, "GL_LIGHT_MODEL_AMBIENT"),
    (|c| c.light_modelf(GL_LIGHT_MODEL_AMBIENT, 1.0), GL_INVALID_ENUM, "4 values"),
    (|c| c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[1.0]), GL_INVALID_OPERATION, "1 of 4"),
    (
        |c| c.light_modeli(GL_LIGHT_MODEL_COLOR_CONTROL, 1),
        GL_INVALID_ENUM,
        "must be GL_SINGLE_COLOR or GL_SEPARATE_SPECULAR_COLOR",
    ),
    // Materials.
    (
        |c| c.materialf(GL_LEFT, GL_SHININESS, 1.0),
        GL_INVALID_ENUM,
        "face = GL_LEFT must be GL_FRONT",
    ),
    (|c| c.materialf(GL_FRONT, GL_POSITION, 1.0), GL_INVALID_ENUM, "pname = GL_POSITION must be"),
    (|c| c.materialf(GL_FRONT, GL_AMBIENT, 1.0), GL_INVALID_ENUM, "4 values"),
    (|c| c.materialfv(GL_FRONT, GL_DIFFUSE, &[1.0; 2]), GL_INVALID_OPERATION, "2 of 4"),
    (|c| c.materialf(GL_FRONT, GL_SHININESS, 129.0), GL_INVALID_VALUE, "must be 0 to 128"),
    (|c| c.materiali(GL_BACK, GL_SHININESS, -1), GL_INVALID_VALUE, "GL_SHININESS = -1"),
    (
        |c| c.get_materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, &mut [0.0; 4]),
        GL_INVALID_ENUM,
        "must be GL_FRONT or GL_BACK",
    ),
    (
        |c| c.get_materialiv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, &mut [0; 4]),
        GL_INVALID_ENUM,
        "pname = GL_AMBIENT_AND_DIFFUSE",
    ),
    (|c| c.color_material(GL_AMBIENT, GL_AMBIENT), GL_INVALID_ENUM, "face ="),
    (|c| c.color_material(GL_FRONT, GL_SHININESS), GL_INVALID_ENUM, "mode = GL_SHININESS"),
    // Fog.
    (|c| c.fogf(GL_FOG, 1.0), GL_INVALID_ENUM, "pname = GL_FOG must be GL_FOG_MODE"),
    (|c| c.fogi(GL_FOG_MODE, GL_NEAREST as GLint), GL_INVALID_ENUM, "GL_EXP, GL_EXP2 or GL_LINEAR"),
    (|c| c.fogf(GL_FOG_MODE, 0.5), GL_INVALID_ENUM, "param ="),
    (|c| c.fogf(GL_FOG_DENSITY, -1.0), GL_INVALID_VALUE, "GL_FOG_DENSITY = -1"),
    (|c| c.fogf(GL_FOG_COLOR, 1.0), GL_INVALID_ENUM, "4 values"),
    (|c| c.fogfv(GL_FOG_COLOR, &[1.0; 3]), GL_INVALID_OPERATION, "3 of 4"),
    (|c| c.fogi(GL_FOG_COORD_SRC, 0), GL_INVALID_ENUM, "GL_FRAGMENT_DEPTH"),
    // Generated coordinates.
    (
        |c| c.tex_geni(GL_RED, GL_TEXTURE_GEN_MODE, 0),
        GL_INVALID_ENUM,
        "coord = GL_RED must be GL_S",
    ),
    (|c| c.tex_geni(GL_S, GL_TEXTURE_ENV_MODE, 0), GL_INVALID_ENUM, "pname ="),
    (
        |c| c.tex_geni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP as GLint),
        GL_INVALID_ENUM,
        "param = GL_SPHERE_MAP must be GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_REFLECTION_MAP or",
    ),
    (
        |c| c.tex_geni(GL_Q, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP as GLint),
        GL_INVALID_ENUM,
        "must be GL_OBJECT_LINEAR or GL_EYE_LINEAR",
    ),
    (|c| c.tex_genf(GL_S, GL_EYE_PLANE, 1.0), GL_INVALID_ENUM, "4 values"),
    (|c| c.tex_gend(GL_S, GL_OBJECT_PLANE, 1.0), GL_INVALID_ENUM, "4 values"),
    (|c| c.tex_genfv(GL_S, GL_EYE_PLANE, &[1.0; 2]), GL_INVALID_OPERATION, "2 of 4"),
    (|c| c.tex_gendv(GL_S, GL_OBJECT_PLANE, &[]), GL_INVALID_OPERATION, "0 of 4"),
    (|c| c.get_tex_genfv(GL_RED, GL_EYE_PLANE, &mut [0.0; 4]), GL_INVALID_ENUM, "coord ="),
    (|c| c.get_tex_geniv(GL_S, GL_TEXTURE_2D, &mut [0; 4]), GL_INVALID_ENUM, "pname ="),
    (|c| c.get_tex_gendv(GL_S, GL_EYE_PLANE, &mut [0.0]), GL_INVALID_OPERATION, "room for 1"),
    (
        |c| {
            c.active_texture(GL_TEXTURE8);
            c.tex_geni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP as GLint);
            c.active_texture(GL_TEXTURE0);
        },
        GL_INVALID_OPERATION,
        "for images alone",
    ),
    (
        |c| {
            c.active_texture(GL_TEXTURE8);
            c.enable(GL_TEXTURE_GEN_S);
            c.active_texture(GL_TEXTURE0);
        },
        GL_INVALID_OPERATION,
        "for images alone",
    ),
    (
        |c| {
            c.active_texture(GL_TEXTURE8);
            c.is_enabled(GL_TEXTURE_GEN_T);
            c.active_texture(GL_TEXTURE0);
        },
        GL_INVALID_OPERATION,
        "for images alone",
    ),
    (
        |c| {
            c.active_texture(GL_TEXTURE8);
            c.get_booleanv(GL_TEXTURE_GEN_R, &mut [0]);
            c.active_texture(GL_TEXTURE0);
        },
        GL_INVALID_OPERATION,
        "for images alone",
    ),
    // User clip planes.
    (|c| c.clip_plane(GL_CLIP_PLANE0 + 8, &[0.0; 4]), GL_INVALID_ENUM, "to GL_CLIP_PLANE7"),
    (|c| c.clip_plane(GL_CLIP_PLANE0, &[0.0; 3]), GL_INVALID_OPERATION, "3 of the 4"),
    (|c| c.get_clip_plane(GL_LIGHT0, &mut [0.0; 4]), GL_INVALID_ENUM, "plane = GL_LIGHT0"),
    (|c| c.get_clip_plane(GL_CLIP_PLANE1, &mut [0.0; 2]), GL_INVALID_OPERATION, "room for 2"),
    // Combiners.
    (|c| c.tex_envi(ENV, GL_TEXTURE_WRAP_S, 1), GL_INVALID_ENUM, "pname = GL_TEXTURE_WRAP_S"),
    (|c| c.tex_envi(ENV, GL_COMBINE_RGB, 1), GL_INVALID_ENUM, "GL_DOT3_RGBA"),
    (|c| c.tex_envi(ENV, GL_COMBINE_ALPHA, GL_DOT3_RGB as GLint), GL_INVALID_ENUM, "GL_SUBTRACT"),
    (|c| c.tex_envi(ENV, GL_SRC0_RGB, GL_SRC_COLOR as GLint), GL_INVALID_ENUM, "GL_PREVIOUS"),
    (|c| c.tex_envi(ENV, GL_SRC0_RGB, GL_TEXTURE8 as GLint), GL_INVALID_ENUM, "GL_TEXTURE7"),
    (|c| c.tex_envi(ENV, GL_OPERAND0_RGB, GL_TEXTURE as GLint), GL_INVALID_ENUM, "GL_SRC_COLOR"),
    (
        |c| c.tex_envi(ENV, GL_OPERAND1_ALPHA, GL_SRC_COLOR as GLint),
        GL_INVALID_ENUM,
        "must be GL_SRC_ALPHA or GL_ONE_MINUS_SRC_ALPHA",
    ),
    (|c| c.tex_envf(ENV, GL_RGB_SCALE, 3.0), GL_INVALID_VALUE, "must be 1, 2 or 4"),
    (|c| c.tex_envi(ENV, GL_ALPHA_SCALE, 0), GL_INVALID_VALUE, "must be 1, 2 or 4"),
    (|c| c.tex_envf(ENV, GL_TEXTURE_ENV_COLOR, 1.0), GL_INVALID_ENUM, "4 values"),
    (|c| c.tex_envi(GL_POINT_SPRITE, GL_RGB_SCALE, 1), GL_INVALID_ENUM, "GL_COORD_REPLACE"),
    (|c| c.tex_envi(GL_TEXTURE_FILTER_CONTROL, GL_RGB_SCALE, 1), GL_INVALID_ENUM, "LOD_BIAS"),
    (|c| c.get_tex_enviv(ENV, GL_FOG_MODE, &mut [0]), GL_INVALID_ENUM, "pname ="),
    (|c| c.get_tex_envfv(GL_FOG, GL_RGB_SCALE, &mut [0.0]), GL_INVALID_ENUM, "target = GL_FOG"),
    (|c| c.get_tex_envfv(ENV, GL_RGB_SCALE, &mut []), GL_INVALID_OPERATION, "room for 0"),
    // Between glBegin and glEnd.
    (
        |c| {
            c.begin(GL_POINTS);
            c.lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 45.0);
            c.end();
        },
        GL_INVALID_OPERATION,
        "between glBegin and glEnd",
    ),
    (
        |c| {
            c.begin(GL_POINTS);
            c.color_material(GL_FRONT, GL_DIFFUSE);
            c.end();
        },
        GL_INVALID_OPERATION,
        "between glBegin and glEnd",
    ),
];

/// Runs the rows.
pub fn run() {
    super::table(
        "fixed",
        super::context,
        CASES.iter().map(|(call, flag, words)| (call, *flag, *words)),
    );
}
