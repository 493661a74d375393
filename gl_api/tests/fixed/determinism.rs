//! The same bits on every instruction set and at every thread count.

use crate::Random;
use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc, Explain};
use std::sync::Arc;
use texunit::lanes::Isa;

const SIZE: i32 = 48;

/// Lit, fogged, textured by generated coordinates: strips in random places.
fn scene(isa: Isa, threads: usize) -> Vec<u8> {
    let desc = DeviceDesc { isa, threads, budget: DeviceDesc::BUDGET, explain: Explain::Off };
    let device = Arc::new(Device::new(desc).expect("threads start"));
    let (width, height) = (SIZE as u32, SIZE as u32);
    let desc = ContextDesc { width, height, device: Some(device), ..Default::default() };
    let mut c = Context::new(desc).expect("a small window");
    let mut random = Random::new(5);
    c.matrix_mode(GL_PROJECTION);
    c.frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 20.0);
    c.matrix_mode(GL_MODELVIEW);
    for cap in [GL_LIGHTING, GL_LIGHT0, GL_LIGHT1, GL_NORMALIZE, GL_FOG, GL_DEPTH_TEST] {
        c.enable(cap);
    }
    c.lightfv(GL_LIGHT1, GL_POSITION, &[1.0, 1.0, -2.0, 1.0]);
    c.lightfv(GL_LIGHT1, GL_DIFFUSE, &[1.0, 0.5, 0.25, 1.0]);
    c.lightf(GL_LIGHT1, GL_SPOT_CUTOFF, 70.0);
    c.lightf(GL_LIGHT1, GL_SPOT_EXPONENT, 3.0);
    c.lightf(GL_LIGHT1, GL_QUADRATIC_ATTENUATION, 0.0625);
    c.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    c.light_modeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    c.light_modeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR as GLint);
    c.materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, &[1.0; 4]);
    c.materialf(GL_FRONT_AND_BACK, GL_SHININESS, 12.5);
    c.fogf(GL_FOG_DENSITY, 0.1);
    c.bind_texture(GL_TEXTURE_2D, 1);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR as GLint);
    let texels: Vec<u8> = (0..64).map(|_| random.below(256) as u8).collect();
    let pixels = Data::Bytes(&texels);
    c.tex_image_2d(GL_TEXTURE_2D, 0, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    for cap in [GL_TEXTURE_2D, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T] {
        c.enable(cap);
    }
    c.tex_geni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP as GLint);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for _ in 0..12 {
        c.load_matrixd(&random.modelview().to_cols_array());
        c.begin(GL_TRIANGLE_STRIP);
        for _ in 0..12 {
            c.normal_3d(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 1.0);
            c.vertex_3d(
                random.between(-2.0, 2.0),
                random.between(-2.0, 2.0),
                random.between(-1.0, 1.0),
            );
        }
        c.end();
    }
    let mut pixels = vec![0; (SIZE * SIZE * 4) as usize];
    let out = DataOut::Bytes(&mut pixels);
    c.read_pixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, out);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    pixels
}

#[test]
fn a_lit_scene_is_the_same_everywhere() {
    let expected = scene(Isa::BASELINE, 1);
    assert!(expected.iter().any(|byte| *byte != 0));
    for isa in Isa::available() {
        for threads in [1, 2, 8] {
            assert_eq!(scene(isa, threads), expected, "{isa:?}, {threads} threads");
        }
    }
}
