//! What shaders read of the fixed function's state (GLSL 1.30, section 7.4), and that the fixed
//! vertex stage and a program's agree.

use crate::shading::use_program;
use crate::{assert_close, context, point, probe, probed};
use gl_api::*;
use glam::{DMat4, DVec4};

/// An expression of a `vec4` in [0, 1], and its value in the state that [`set`] makes.
const VALUES: &[(&str, [f64; 4])] = &[
    ("gl_LightSource[2].ambient", [0.1, 0.2, 0.3, 0.4]),
    ("gl_LightSource[2].diffuse", [0.5, 0.6, 0.7, 0.8]),
    ("gl_LightSource[2].specular", [0.9, 0.8, 0.7, 0.6]),
    ("gl_LightSource[2].position / 8.0", [0.125, 0.25, 0.375, 0.125]),
    // (1, 2, 3) of length one, plus (0, 0, 1), of length one.
    ("gl_LightSource[2].halfVector", [0.140_789_3, 0.281_578_6, 0.949_153_2, 1.0]),
    ("vec4(-gl_LightSource[2].spotDirection / 4.0, 1.0)", [0.0, 0.0, 0.5, 1.0]),
    (
        "vec4(gl_LightSource[2].spotExponent / 128.0, gl_LightSource[2].spotCutoff / 180.0,
              gl_LightSource[2].spotCosCutoff, gl_LightSource[2].constantAttenuation)",
        [0.0625, 1.0 / 3.0, 0.5, 0.5],
    ),
    (
        "vec4(gl_LightSource[2].linearAttenuation, gl_LightSource[2].quadraticAttenuation, 0, 0)",
        [0.25, 0.125, 0.0, 0.0],
    ),
    ("gl_LightSource[0].diffuse", [1.0; 4]),
    ("gl_LightSource[7].diffuse", [0.0, 0.0, 0.0, 1.0]),
    ("gl_LightModel.ambient", [0.25, 0.5, 0.75, 1.0]),
    ("gl_FrontMaterial.emission", [0.05, 0.05, 0.05, 0.5]),
    ("gl_FrontMaterial.ambient", [0.2, 0.4, 0.6, 0.8]),
    ("gl_FrontMaterial.diffuse", [0.8, 0.6, 0.4, 0.2]),
    ("gl_BackMaterial.specular", [0.3, 0.3, 0.3, 1.0]),
    (
        "vec4(gl_FrontMaterial.shininess, gl_BackMaterial.shininess, 0, 0) / 128.0",
        [0.25, 0.5, 0.0, 0.0],
    ),
    ("gl_FrontLightModelProduct.sceneColor", [0.1, 0.25, 0.5, 0.2]),
    ("gl_FrontLightProduct[2].ambient", [0.02, 0.08, 0.18, 0.8]),
    ("gl_FrontLightProduct[2].diffuse", [0.4, 0.36, 0.28, 0.2]),
    ("gl_BackLightProduct[2].specular", [0.27, 0.24, 0.21, 1.0]),
    ("gl_Fog.color", [0.1, 0.3, 0.5, 0.7]),
    (
        "vec4(gl_Fog.density, gl_Fog.start / 8.0, gl_Fog.end / 8.0, gl_Fog.scale)",
        [0.75, 0.25, 0.75, 0.25],
    ),
    ("gl_EyePlaneT[3]", [0.5, 0.25, 0.125, 1.0]),
    ("gl_ObjectPlaneQ[0]", [0.0, 0.75, 0.0, 0.5]),
    ("gl_ObjectPlaneS[1]", [1.0, 0.0, 0.0, 0.0]),
    ("gl_ClipPlane[4]", [0.25, 0.5, 0.75, 1.0]),
    ("gl_TextureEnvColor[5]", [0.1, 0.2, 0.3, 0.4]),
    ("vec4(gl_NormalScale / 4.0)", [0.5; 4]),
];

fn set(c: &mut Context) {
    c.lightfv(GL_LIGHT2, GL_AMBIENT, &[0.1, 0.2, 0.3, 0.4]);
    c.lightfv(GL_LIGHT2, GL_DIFFUSE, &[0.5, 0.6, 0.7, 0.8]);
    c.lightfv(GL_LIGHT2, GL_SPECULAR, &[0.9, 0.8, 0.7, 0.6]);
    c.lightfv(GL_LIGHT2, GL_POSITION, &[1.0, 2.0, 3.0, 1.0]);
    c.lightfv(GL_LIGHT2, GL_SPOT_DIRECTION, &[0.0, 0.0, -2.0]);
    c.lightf(GL_LIGHT2, GL_SPOT_EXPONENT, 8.0);
    c.lightf(GL_LIGHT2, GL_SPOT_CUTOFF, 60.0);
    c.lightf(GL_LIGHT2, GL_CONSTANT_ATTENUATION, 0.5);
    c.lightf(GL_LIGHT2, GL_LINEAR_ATTENUATION, 0.25);
    c.lightf(GL_LIGHT2, GL_QUADRATIC_ATTENUATION, 0.125);
    c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.25, 0.5, 0.75, 1.0]);
    c.materialfv(GL_FRONT, GL_EMISSION, &[0.05, 0.05, 0.05, 0.5]);
    c.materialfv(GL_FRONT, GL_AMBIENT, &[0.2, 0.4, 0.6, 0.8]);
    c.materialfv(GL_FRONT, GL_DIFFUSE, &[0.8, 0.6, 0.4, 0.2]);
    c.materialfv(GL_BACK, GL_SPECULAR, &[0.3, 0.3, 0.3, 1.0]);
    c.materialf(GL_FRONT, GL_SHININESS, 32.0);
    c.materialf(GL_BACK, GL_SHININESS, 64.0);
    c.fogfv(GL_FOG_COLOR, &[0.1, 0.3, 0.5, 0.7]);
    c.fogf(GL_FOG_DENSITY, 0.75);
    c.fogf(GL_FOG_START, 2.0);
    c.fogf(GL_FOG_END, 6.0);
    c.tex_gendv(GL_Q, GL_OBJECT_PLANE, &[0.0, 0.75, 0.0, 0.5]);
    c.active_texture(GL_TEXTURE3);
    c.tex_gendv(GL_T, GL_EYE_PLANE, &[0.5, 0.25, 0.125, 1.0]);
    c.active_texture(GL_TEXTURE5);
    c.tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &[0.1, 0.2, 0.3, 0.4]);
    c.clip_plane(GL_CLIP_PLANE4, &[0.25, 0.5, 0.75, 1.0]);
    c.scalef(2.0, 2.0, 2.0);
}

#[test]
fn shaders_read_the_state() {
    let mut c = context();
    set(&mut c);
    for &(value, expected) in VALUES {
        let mask = probe(&mut c, &format!("({value})"));
        let found = probed(&mut c, mask, |c| point(c, 0.0));
        assert_close(found, expected, 3e-7, &value);
    }
}

/// Draws the pixel, whatever the matrices are.
fn pixel_at_hand(c: &mut Context) {
    c.window_pos_2i(0, 0);
    c.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(&[0; 4]));
}

/// Every matrix in its four forms, of stacks without a simple inverse.
#[test]
fn shaders_read_the_matrices() {
    let mut c = context();
    let mut random = crate::Random::new(5);
    let mut stacks = Vec::new();
    for (mode, unit) in [(GL_MODELVIEW, 0), (GL_PROJECTION, 0), (GL_TEXTURE, 0), (GL_TEXTURE, 5)] {
        let matrix = random.modelview() * DMat4::from_diagonal(DVec4::new(1.0, 2.0, 0.5, 1.0));
        c.active_texture(GL_TEXTURE0 + unit);
        c.matrix_mode(mode);
        c.load_matrixd(&matrix.to_cols_array());
        stacks.push(matrix);
    }
    let names = [
        ("gl_ModelViewMatrix", "", stacks[0]),
        ("gl_ProjectionMatrix", "", stacks[1]),
        ("gl_ModelViewProjectionMatrix", "", stacks[1] * stacks[0]),
        ("gl_TextureMatrix", "[0]", stacks[2]),
        ("gl_TextureMatrix", "[5]", stacks[3]),
    ];
    for (name, index, matrix) in names {
        let inverse = matrix.inverse();
        for (form, expected) in [
            ("", matrix),
            ("Inverse", inverse),
            ("Transpose", matrix.transpose()),
            ("InverseTranspose", inverse.transpose()),
        ] {
            for column in 0..4 {
                let value = format!("({name}{form}{index}[{column}] / 256.0 + 0.5)");
                let mask = probe(&mut c, &value);
                let found = probed(&mut c, mask, pixel_at_hand);
                let expected = (expected.col(column) / 256.0 + 0.5).to_array();
                assert_close(found, expected, 3e-6, &value);
            }
        }
    }
}

/// What `ftransform` and the fixed vertex stage give is the same to the bit, lit or not: the second
/// pass passes a depth test for equality everywhere the first one drew.
#[test]
fn ftransform_is_the_fixed_transformation() {
    let desc = ContextDesc { width: 64, height: 64, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a small window");
    let source = "void main() { gl_Position = ftransform(); gl_FrontColor = vec4(0, 1, 0, 1); }";
    let program = use_program(&mut c, source, "");
    c.use_program(0);
    c.enable(GL_DEPTH_TEST);
    c.enable(GL_LIGHT0);
    for seed in 0..20 {
        let modelview = crate::Random::new(seed).modelview();
        c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        c.matrix_mode(GL_PROJECTION);
        c.load_identity();
        c.frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 20.0);
        c.matrix_mode(GL_MODELVIEW);
        c.load_matrixd(&modelview.to_cols_array());
        let draw = |c: &mut Context| {
            c.begin(GL_TRIANGLE_STRIP);
            for (x, y, z) in
                [(-1.0, -1.0, 0.3), (1.0, -1.0, 0.1), (-1.0, 1.0, -0.2), (1.0, 1.0, 0.7)]
            {
                c.vertex_3d(x, y, z);
            }
            c.end();
        };
        let count = |c: &mut Context, wanted: [u8; 3]| {
            let mut pixels = vec![0_u8; 64 * 64 * 4];
            let out = DataOut::Bytes(&mut pixels);
            c.read_pixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, out);
            pixels.chunks(4).filter(|pixel| pixel[..3] == wanted).count()
        };
        c.enable(GL_LIGHTING);
        c.materialfv(GL_FRONT_AND_BACK, GL_EMISSION, &[1.0; 4]);
        c.depth_func(GL_LESS);
        draw(&mut c);
        let drawn = count(&mut c, [255; 3]);
        c.use_program(program);
        c.disable(GL_LIGHTING);
        c.depth_func(GL_EQUAL);
        draw(&mut c);
        assert_eq!(count(&mut c, [0, 255, 0]), drawn, "{seed}");
        c.use_program(0);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    }
}
