//! The same bits on every instruction set and at every thread count.

use crate::Random;
use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use texunit::lanes::Isa;

const SIZE: i32 = 48;

/// A context of such a device.
fn context_of(isa: Isa, threads: usize) -> Context {
    let desc = DeviceDesc::new(isa, threads);
    let device = Arc::new(Device::new(desc).expect("threads start"));
    let (width, height) = (SIZE as u32, SIZE as u32);
    let desc = ContextDesc { width, height, device: Some(device), ..Default::default() };
    Context::new(desc).expect("a small window")
}

/// Lit, fogged, textured by generated coordinates: strips in random places.
fn scene(isa: Isa, threads: usize) -> Vec<u8> {
    let mut c = context_of(isa, threads);
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
    for isa in Isa::executions() {
        for threads in [1, 2, 8] {
            assert_eq!(scene(isa, threads), expected, "{isa:?}, {threads} threads");
        }
    }
}

/// What comes of samples of floats that are resolved, after a clear.
fn resolved(c: &mut Context, random: &mut Random) -> Vec<u8> {
    for (name, samples) in [(1, 4), (2, 0)] {
        c.bind_renderbuffer(GL_RENDERBUFFER, name);
        let format = GL_RGBA32F;
        c.renderbuffer_storage_multisample(GL_RENDERBUFFER, samples, format, SIZE, SIZE);
        c.bind_framebuffer(GL_FRAMEBUFFER, name);
        let at = GL_COLOR_ATTACHMENT0;
        c.framebuffer_renderbuffer(GL_FRAMEBUFFER, at, GL_RENDERBUFFER, name);
    }
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
    c.clear_color(0.1, 0.7, 0.3, 0.6);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.begin(GL_TRIANGLE_STRIP);
    for _ in 0..20 {
        c.color_3d(random.between(0.0, 1.0), random.between(0.0, 1.0), random.between(0.0, 1.0));
        c.vertex_2d(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
    }
    c.end();
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 2);
    let (mask, filter) = (GL_COLOR_BUFFER_BIT, GL_NEAREST);
    c.blit_framebuffer(0, 0, SIZE, SIZE, 0, 0, SIZE, SIZE, mask, filter);
    c.bind_framebuffer(GL_FRAMEBUFFER, 2);
    let mut pixels = vec![0; (SIZE * SIZE * 16) as usize];
    c.read_pixels(0, 0, SIZE, SIZE, GL_RGBA, GL_FLOAT, DataOut::Bytes(&mut pixels));
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    pixels
}

/// The mipmaps of 13×7 sRGB texels.
fn mipmaps(c: &mut Context, random: &mut Random) -> Vec<u8> {
    let texels: Vec<u8> = (0..13 * 7 * 4).map(|_| random.below(256) as u8).collect();
    let (internal, pixels) = (GL_SRGB8_ALPHA8 as GLint, Data::Bytes(&texels));
    c.tex_image_2d(GL_TEXTURE_2D, 0, internal, 13, 7, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    c.generate_mipmap(GL_TEXTURE_2D);
    let mut all = Vec::new();
    for (level, texels) in [(1, 6 * 3), (2, 3), (3, 1)] {
        let mut level_bytes = vec![0; texels * 4];
        let out = DataOut::Bytes(&mut level_bytes);
        c.get_tex_image(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, out);
        all.extend(level_bytes);
    }
    all
}

/// What transform feedback writes of more vertices than a batch has.
fn captured(c: &mut Context, random: &mut Random) -> Vec<u8> {
    const COUNT: GLsizei = 70;
    let vertex = "void main() { gl_Position = vec4(sin(gl_Vertex.x), exp(gl_Vertex.y), \
                  normalize(gl_Vertex.xyz).z, inversesqrt(gl_Vertex.w + 2.0)); }";
    let program = crate::shading::use_program(c, vertex, "");
    let names = Names(vec!["gl_Position"]);
    c.transform_feedback_varyings(program, 1, names, GL_INTERLEAVED_ATTRIBS);
    c.link_program(program);
    c.use_program(program);
    let mut bytes = vec![0; COUNT as usize * 16];
    let size = bytes.len() as GLsizeiptr;
    c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 1);
    c.buffer_data(GL_TRANSFORM_FEEDBACK_BUFFER, size, Data::Null, GL_STATIC_READ);
    let floats: Vec<u8> =
        (0..COUNT * 4).flat_map(|_| (random.between(-1.0, 1.0) as f32).to_le_bytes()).collect();
    c.vertex_pointer(4, GL_FLOAT, 0, Data::Bytes(&floats));
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.begin_transform_feedback(GL_POINTS);
    c.draw_arrays(GL_POINTS, 0, COUNT);
    c.end_transform_feedback();
    let out = DataOut::Bytes(&mut bytes);
    c.get_buffer_sub_data(GL_TRANSFORM_FEEDBACK_BUFFER, 0, size, out);
    bytes
}

/// Kernels that run beside draws.
#[test]
fn what_is_made_beside_draws_is_the_same_everywhere() {
    for make in [resolved, mipmaps, captured] {
        let made = |isa| {
            let mut c = context_of(isa, 2);
            let made = make(&mut c, &mut Random::new(7));
            assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
            made
        };
        let expected = made(Isa::BASELINE);
        assert!(expected.iter().any(|byte| *byte != expected[0]));
        for isa in Isa::executions() {
            assert!(made(isa) == expected, "{isa:?}");
        }
    }
}

/// Where the code chooses an instruction set: a device's description does, and what runs takes its
/// device's, or the tests here would run it with the best one only.
#[test]
fn only_devices_choose_an_instruction_set() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut left: Vec<PathBuf> =
        ["texunit", "rasterizer", "gl_api"].map(|name| root.join(name).join("src")).to_vec();
    let mut choosing = Vec::new();
    while let Some(path) = left.pop() {
        if path.is_dir() {
            left.extend(path.read_dir().expect("a folder").map(|entry| entry.expect("one").path()));
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("text");
        // Unit tests choose.
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        let is_test = path.iter().any(|part| part == "tests" || part == "tests.rs");
        if !is_test && (code.contains("Isa::best()") || code.contains("Isa::from_env()")) {
            choosing.push(path);
        }
    }
    assert_eq!(choosing, [root.join("rasterizer/src/driver/resources.rs")]);
}
