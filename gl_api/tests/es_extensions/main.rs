//! Each extension that contexts of OpenGL ES announce does what its specification adds: a use of it here, or a test in
//! another file.

#[path = "../common/shading.rs"]
mod shading;

mod blocks;
mod drawing;
mod framebuffers;
mod objects;
mod textures;

use gl_api::*;
use shading::use_program;

/// The name of an extension without `GL_`, and a function that uses it and checks the result.
type Use = (&'static str, fn(&mut Context));

/// Those that other tests use: the name without `GL_`, the file below `tests` or `capi/tests`, and the test.
#[rustfmt::skip]
const ELSEWHERE: &[(&str, &str, &str)] = &[
    ("APPLE_clip_distance", "tests/glsl_es/rows_100.rs", "GL_APPLE_clip_distance"),
    ("EXT_blend_func_extended", "tests/es_second_colors.rs", "EXT_blend_func_extended"),
    ("EXT_color_buffer_half_float", "tests/es.rs", "EXT_color_buffer_half_float"),
    ("EXT_disjoint_timer_query", "tests/es.rs", "fn time_is_queried_and_reads_are_bounded"),
    ("EXT_draw_buffers", "tests/glsl_es/main.rs", "EXT_draw_buffers"),
    ("EXT_frag_depth", "tests/glsl_es/rows_100.rs", "GL_EXT_frag_depth"),
    ("EXT_multisampled_render_to_texture", "tests/es_implicit_samples.rs", "fn every_way_of_reading_gives_the_resolved_texels"),
    ("EXT_robustness", "tests/es.rs", "fn time_is_queried_and_reads_are_bounded"),
    ("EXT_sRGB", "tests/es_srgb.rs", "fn texels_are_made_linear"),
    ("EXT_shader_texture_lod", "tests/glsl_es/rows_100.rs", "GL_EXT_shader_texture_lod"),
    ("EXT_texture_border_clamp", "tests/es_rules.rs", "fn textures_and_samplers_have_borders"),
    ("EXT_texture_type_2_10_10_10_REV", "tests/es.rs", "EXT_texture_type_2_10_10_10_REV"),
    ("KHR_debug", "tests/debugging.rs", "KHR_debug"),
    ("KHR_robustness", "tests/es.rs", "fn time_is_queried_and_reads_are_bounded"),
    ("OES_EGL_image", "tests/special/egl_images.rs", "fn what_one_context_draws_another_samples"),
    ("OES_EGL_image_external", "tests/special/egl_images.rs", "fn external_textures_show_images_of_other_contexts"),
    ("OES_EGL_image_external_essl3", "tests/special/egl_images.rs", "OES_EGL_image_external_essl3"),
    ("OES_depth_texture", "tests/es_rules.rs", "fn depths_that_are_not_compared_are_not_filtered"),
    ("OES_required_internalformat", "tests/es_values.rs", "fn required_internal_formats_are_there"),
    ("OES_standard_derivatives", "tests/glsl_es/rows_100.rs", "GL_OES_standard_derivatives"),
    ("OES_surfaceless_context", "capi/tests/abi/configs.rs", "EGL_KHR_surfaceless_context"),
    ("OES_texture_float", "tests/es.rs", "OES_texture_float"),
    ("OES_texture_half_float", "tests/es.rs", "OES_texture_half_float"),
    ("OES_vertex_half_float", "tests/es_rules.rs", "fn half_floats_of_vertex_arrays_have_two_names"),
];

fn uses() -> impl Iterator<Item = Use> {
    [blocks::USES, drawing::USES, framebuffers::USES, objects::USES, textures::USES]
        .into_iter()
        .flatten()
        .copied()
}

fn es() -> Context {
    let version = Version::new(2, 0);
    let desc = ContextDesc { api: Api::Es2, version, width: 8, height: 8, ..Default::default() };
    Context::new(desc).expect("a device")
}

#[test]
fn each_does_what_it_adds() {
    for (name, use_it) in uses() {
        let mut c = es();
        use_it(&mut c);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{name}: {:?}", c.messages());
    }
}

#[test]
fn none_is_announced_without_a_test() {
    let mut c = es();
    let announced: Vec<&str> = c.get_string(GL_EXTENSIONS).split(' ').collect();
    let mut tested: Vec<String> =
        uses().map(|(name, _)| name).chain(ELSEWHERE.iter().map(|row| row.0)).map(full).collect();
    tested.sort();
    assert_eq!(announced, tested);
    for (name, file, words) in ELSEWHERE {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
        let text = std::fs::read_to_string(&path).expect("a file of the package");
        assert!(text.contains(words), "{name}: {file} has no {words}");
    }
}

fn full(name: &str) -> String {
    format!("GL_{name}")
}

/// A full-window draw with a shader's colour, which may read `image` and `place` (0 to 1); the pixel at the left below.
fn draw(c: &mut Context, color: &str) -> [u8; 4] {
    paint(c, color);
    pixel(c, 0, 0)
}

/// The draw alone.
fn paint(c: &mut Context, color: &str) {
    let vertex = "#version 300 es
        out vec2 place;
        void main() {
            vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
            place = corner;
            gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
        }";
    let fragment = format!(
        "#version 300 es
        precision highp float;
        uniform sampler2D image;
        in vec2 place;
        out vec4 color;
        void main() {{ color = {color}; }}"
    );
    use_program(c, vertex, &fragment);
    c.draw_arrays(GL_TRIANGLES, 0, 3);
}

fn pixel(c: &mut Context, x: GLint, y: GLint) -> [u8; 4] {
    let mut pixel = [0; 4];
    c.read_pixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    pixel
}

/// What the middle of the bound texture gives.
fn sampled(c: &mut Context) -> [u8; 4] {
    draw(c, "texture(image, vec2(0.5))")
}

/// A new texture, bound, with a filter and without mipmaps.
fn texture(c: &mut Context, filter: GLenum) -> GLuint {
    let mut name = [0];
    c.gen_textures(1, &mut name);
    c.bind_texture(GL_TEXTURE_2D, name[0]);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter as GLint);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter as GLint);
    name[0]
}

/// An image of one row of the bound texture.
fn row(
    c: &mut Context,
    (internal, format, ty): (GLenum, GLenum, GLenum),
    width: GLsizei,
    texels: &[u8],
) {
    c.tex_image_2d(GL_TEXTURE_2D, 0, internal as i32, width, 1, 0, format, ty, Data::Bytes(texels));
}

/// A framebuffer with a new renderbuffer of 8 × 8 pixels, complete.
fn renderbuffer(c: &mut Context, internal: GLenum, point: GLenum) {
    let (mut buffer, mut framebuffer) = ([0], [0]);
    c.gen_renderbuffers(1, &mut buffer);
    c.bind_renderbuffer(GL_RENDERBUFFER, buffer[0]);
    c.renderbuffer_storage(GL_RENDERBUFFER, internal, 8, 8);
    c.gen_framebuffers(1, &mut framebuffer);
    c.bind_framebuffer(GL_FRAMEBUFFER, framebuffer[0]);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer[0]);
    let status = c.check_framebuffer_status(GL_FRAMEBUFFER);
    assert_eq!(status, GL_FRAMEBUFFER_COMPLETE, "{internal:#x}: {:?}", c.messages());
}
