//! What `glGet*` answers of the fixed function's state, and in which conversion.

use crate::context;
use gl_api::*;

/// A name, and what it is at first, as `glGetFloatv` answers.
const INITIAL: &[(GLenum, &[f32])] = &[
    (GL_LIGHTING, &[0.0]),
    (GL_LIGHT0, &[0.0]),
    (GL_LIGHT7, &[0.0]),
    (GL_COLOR_MATERIAL, &[0.0]),
    (GL_NORMALIZE, &[0.0]),
    (GL_RESCALE_NORMAL, &[0.0]),
    (GL_COLOR_SUM, &[0.0]),
    (GL_FOG, &[0.0]),
    (GL_CLIP_PLANE0, &[0.0]),
    (GL_CLIP_PLANE5, &[0.0]),
    (GL_TEXTURE_GEN_S, &[0.0]),
    (GL_TEXTURE_GEN_Q, &[0.0]),
    (GL_MAX_LIGHTS, &[8.0]),
    (GL_MAX_CLIP_PLANES, &[8.0]),
    (GL_LIGHT_MODEL_AMBIENT, &[0.2, 0.2, 0.2, 1.0]),
    (GL_LIGHT_MODEL_LOCAL_VIEWER, &[0.0]),
    (GL_LIGHT_MODEL_TWO_SIDE, &[0.0]),
    (GL_LIGHT_MODEL_COLOR_CONTROL, &[GL_SINGLE_COLOR as f32]),
    (GL_COLOR_MATERIAL_FACE, &[GL_FRONT_AND_BACK as f32]),
    (GL_COLOR_MATERIAL_PARAMETER, &[GL_AMBIENT_AND_DIFFUSE as f32]),
    (GL_FOG_COLOR, &[0.0; 4]),
    (GL_FOG_DENSITY, &[1.0]),
    (GL_FOG_START, &[0.0]),
    (GL_FOG_END, &[1.0]),
    (GL_FOG_INDEX, &[0.0]),
    (GL_FOG_MODE, &[GL_EXP as f32]),
    (GL_FOG_COORD_SRC, &[GL_FRAGMENT_DEPTH as f32]),
];

#[test]
fn state_begins_as_the_tables_say() {
    let mut c = context();
    for &(name, expected) in INITIAL {
        let mut values = vec![f32::NAN; expected.len()];
        c.get_floatv(name, &mut values);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{name:#x}: {:?}", c.messages());
        assert_eq!(values, expected, "{name:#x}");
    }
}

#[test]
fn colours_become_integers_over_the_whole_range() {
    let mut c = context();
    c.lightfv(GL_LIGHT1, GL_DIFFUSE, &[1.0, -1.0, 0.0, 0.5]);
    let mut ints = [0; 4];
    c.get_lightiv(GL_LIGHT1, GL_DIFFUSE, &mut ints);
    assert_eq!(ints, [i32::MAX, i32::MIN, 0, 1_073_741_823]);
    c.lightiv(GL_LIGHT1, GL_DIFFUSE, &[i32::MAX, i32::MIN, 0, 1]);
    let mut floats = [0.0; 4];
    c.get_lightfv(GL_LIGHT1, GL_DIFFUSE, &mut floats);
    assert_eq!(floats[..2], [1.0, -1.0]);
    c.materialiv(GL_FRONT, GL_AMBIENT, &[i32::MAX; 4]);
    c.get_materialfv(GL_FRONT, GL_AMBIENT, &mut floats);
    assert_eq!(floats, [1.0; 4]);
    c.fogiv(GL_FOG_COLOR, &[i32::MAX, 0, i32::MIN, i32::MAX]);
    c.get_integerv(GL_FOG_COLOR, &mut ints);
    assert_eq!((ints[0], ints[2]), (i32::MAX, 0), "clamped when it is set");
    c.light_modeliv(GL_LIGHT_MODEL_AMBIENT, &[i32::MAX; 4]);
    c.get_integerv(GL_LIGHT_MODEL_AMBIENT, &mut ints);
    assert_eq!(ints, [i32::MAX; 4]);
}

#[test]
fn positions_are_rounded_to_integers() {
    let mut c = context();
    c.lightiv(GL_LIGHT0, GL_POSITION, &[1, -2, 3, 1]);
    c.translatef(0.0, 0.6, 0.4);
    let mut ints = [0; 4];
    c.get_lightiv(GL_LIGHT0, GL_POSITION, &mut ints);
    assert_eq!(ints, [1, -2, 3, 1]);
    c.lightiv(GL_LIGHT0, GL_POSITION, &[1, -2, 3, 1]);
    c.get_lightiv(GL_LIGHT0, GL_POSITION, &mut ints);
    assert_eq!(ints, [1, -1, 3, 1]);
    c.tex_genfv(GL_S, GL_OBJECT_PLANE, &[0.6, -0.6, 2.0, 0.0]);
    c.get_tex_geniv(GL_S, GL_OBJECT_PLANE, &mut ints);
    assert_eq!(ints, [1, -1, 2, 0]);
}

#[test]
fn each_unit_has_its_own_environment_and_generation() {
    let mut c = context();
    for unit in 0..8_u32 {
        c.active_texture(GL_TEXTURE0 + unit);
        c.tex_envf(GL_TEXTURE_ENV, GL_RGB_SCALE, [1.0, 2.0, 4.0][unit as usize % 3]);
        c.tex_envi(GL_TEXTURE_ENV, GL_SRC1_ALPHA, (GL_TEXTURE0 + unit) as GLint);
        c.tex_geni(GL_R, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP as GLint);
        c.tex_genfv(GL_Q, GL_OBJECT_PLANE, &[unit as f32, 0.0, 0.0, 0.0]);
        c.tex_envi(GL_POINT_SPRITE, GL_COORD_REPLACE, (unit % 2) as GLint);
    }
    for unit in 0..8_u32 {
        c.active_texture(GL_TEXTURE0 + unit);
        let mut value = [0];
        let mut get = |c: &mut Context, target, name| {
            c.get_tex_enviv(target, name, &mut value);
            value[0] as u32
        };
        assert_eq!(get(&mut c, GL_TEXTURE_ENV, GL_RGB_SCALE), [1, 2, 4][unit as usize % 3]);
        assert_eq!(get(&mut c, GL_TEXTURE_ENV, GL_ALPHA_SCALE), 1);
        assert_eq!(get(&mut c, GL_TEXTURE_ENV, GL_SRC1_ALPHA), GL_TEXTURE0 + unit);
        assert_eq!(get(&mut c, GL_TEXTURE_ENV, GL_OPERAND2_RGB), GL_SRC_ALPHA);
        assert_eq!(get(&mut c, GL_TEXTURE_ENV, GL_COMBINE_RGB), GL_MODULATE);
        assert_eq!(get(&mut c, GL_POINT_SPRITE, GL_COORD_REPLACE), unit % 2);
        let (mut plane, mut mode) = ([0.0; 4], [0]);
        c.get_tex_genfv(GL_Q, GL_OBJECT_PLANE, &mut plane);
        assert_eq!(plane[0], unit as f32);
        c.get_tex_geniv(GL_R, GL_TEXTURE_GEN_MODE, &mut mode);
        assert_eq!(mode[0] as u32, GL_NORMAL_MAP);
    }
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn lights_and_materials_begin_as_the_tables_say() {
    let mut c = context();
    let light = |c: &mut Context, light, name, count: usize| {
        let mut values = vec![0.0; count];
        c.get_lightfv(light, name, &mut values);
        values
    };
    assert_eq!(light(&mut c, GL_LIGHT0, GL_DIFFUSE, 4), [1.0; 4]);
    assert_eq!(light(&mut c, GL_LIGHT1, GL_SPECULAR, 4), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(light(&mut c, GL_LIGHT5, GL_POSITION, 4), [0.0, 0.0, 1.0, 0.0]);
    assert_eq!(light(&mut c, GL_LIGHT5, GL_SPOT_DIRECTION, 3), [0.0, 0.0, -1.0]);
    assert_eq!(light(&mut c, GL_LIGHT5, GL_SPOT_CUTOFF, 1), [180.0]);
    assert_eq!(light(&mut c, GL_LIGHT5, GL_SPOT_EXPONENT, 1), [0.0]);
    assert_eq!(light(&mut c, GL_LIGHT5, GL_CONSTANT_ATTENUATION, 1), [1.0]);
    assert_eq!(light(&mut c, GL_LIGHT5, GL_QUADRATIC_ATTENUATION, 1), [0.0]);
    for face in [GL_FRONT, GL_BACK] {
        let mut get = |name, count: usize| {
            let mut values = vec![0.0; count];
            c.get_materialfv(face, name, &mut values);
            values
        };
        assert_eq!(get(GL_AMBIENT, 4), [0.2, 0.2, 0.2, 1.0]);
        assert_eq!(get(GL_DIFFUSE, 4), [0.8, 0.8, 0.8, 1.0]);
        assert_eq!(get(GL_SPECULAR, 4), [0.0, 0.0, 0.0, 1.0]);
        assert_eq!(get(GL_EMISSION, 4), [0.0, 0.0, 0.0, 1.0]);
        assert_eq!(get(GL_SHININESS, 1), [0.0]);
    }
}
