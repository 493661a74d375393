//! The unsized formats of sRGB of contexts of OpenGL ES (`EXT_sRGB`).

#[path = "common/shading.rs"]
mod shading;

use gl_api::*;
use shading::use_program;

fn es() -> Context {
    let version = Version::new(2, 0);
    let desc = ContextDesc { api: Api::Es2, version, width: 8, height: 8, ..Default::default() };
    Context::new(desc).expect("a device")
}

fn texture(c: &mut Context, internal: GLenum, format: GLenum, texels: &[u8]) -> GLuint {
    let mut name = [0];
    c.gen_textures(1, &mut name);
    c.bind_texture(GL_TEXTURE_2D, name[0]);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    let ty = GL_UNSIGNED_BYTE;
    c.tex_image_2d(GL_TEXTURE_2D, 0, internal as i32, 1, 1, 0, format, ty, texels.arg());
    name[0]
}

/// A full-window draw with a colour, to whatever is bound.
fn draw(c: &mut Context, color: &str) -> [u8; 4] {
    let vertex = "attribute vec2 corner; void main() { gl_Position = vec4(corner, 0.0, 1.0); }";
    let fragment = format!(
        "precision mediump float; uniform sampler2D image; void main() {{ gl_FragColor = {color}; }}"
    );
    let program = use_program(c, vertex, &fragment);
    let at = c.get_attrib_location(program, "corner") as GLuint;
    let corners: [f32; 6] = [-1.0, -1.0, 3.0, -1.0, -1.0, 3.0];
    c.enable_vertex_attrib_array(at);
    c.vertex_attrib_pointer(at, 2, GL_FLOAT, false, 0, corners.arg());
    c.draw_arrays(GL_TRIANGLES, 0, 3);
    let mut pixel = [0; 4];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    pixel
}

/// The linear values by the specification's formula: of 188, ((188 / 255 + 0.055) / 1.055)^2.4 is 0.5029, 128.2 255ths.
#[test]
fn texels_are_made_linear() {
    let mut c = es();
    assert!(c.get_string(GL_EXTENSIONS).split(' ').any(|name| name == "GL_EXT_sRGB"));
    texture(&mut c, GL_SRGB_ALPHA_EXT, GL_SRGB_ALPHA_EXT, &[188, 0, 255, 188]);
    assert_eq!(draw(&mut c, "texture2D(image, vec2(0.5))"), [128, 0, 255, 188]);
    texture(&mut c, GL_SRGB_EXT, GL_SRGB_EXT, &[255, 188, 0, 0]);
    assert_eq!(draw(&mut c, "texture2D(image, vec2(0.5))"), [255, 128, 0, 255]);
    let texel: &[u8] = &[0, 0, 188, 0];
    c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_SRGB_EXT, GL_UNSIGNED_BYTE, texel.arg());
    assert_eq!(draw(&mut c, "texture2D(image, vec2(0.5))"), [0, 0, 128, 255]);
}

/// What is drawn is encoded: 1.055 · 0.5^(1 / 2.4) - 0.055 is 0.7354, 187.5 255ths; blending adds linear values.
#[test]
fn attachments_encode_what_is_drawn() {
    let mut c = es();
    let name = texture(&mut c, GL_SRGB_ALPHA_EXT, GL_SRGB_ALPHA_EXT, &[0; 4]);
    let mut framebuffer = [0];
    c.gen_framebuffers(1, &mut framebuffer);
    c.bind_framebuffer(GL_FRAMEBUFFER, framebuffer[0]);
    let (point, target) = (GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, point, target, name, 0);
    assert_eq!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    let mut encoding = [0];
    let pname = GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING_EXT;
    c.get_framebuffer_attachment_parameteriv(GL_FRAMEBUFFER, point, pname, &mut encoding);
    assert_eq!(encoding, [GL_SRGB as GLint]);
    c.bind_texture(GL_TEXTURE_2D, 0);
    assert_eq!(draw(&mut c, "vec4(0.5, 0.0, 1.0, 0.5)"), [188, 0, 255, 128]);
    c.enable(GL_BLEND);
    c.blend_func(GL_ONE, GL_ONE);
    // 128 of 188 and a quarter: 0.5029 + 0.25 is encoded as 0.8823, 225.0 255ths.
    assert_eq!(draw(&mut c, "vec4(0.25, 0.0, 0.0, 0.0)"), [225, 0, 255, 128]);

    let name = texture(&mut c, GL_SRGB_EXT, GL_SRGB_EXT, &[0; 4]);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, point, target, name, 0);
    let status = c.check_framebuffer_status(GL_FRAMEBUFFER);
    assert_eq!(status, GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);

    let mut buffer = [0];
    c.gen_renderbuffers(1, &mut buffer);
    c.bind_renderbuffer(GL_RENDERBUFFER, buffer[0]);
    c.renderbuffer_storage(GL_RENDERBUFFER, GL_SRGB8_ALPHA8_EXT, 4, 4);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer[0]);
    assert_eq!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    c.disable(GL_BLEND);
    assert_eq!(draw(&mut c, "vec4(0.5, 0.0, 1.0, 0.5)"), [188, 0, 255, 128]);
}

type Call = fn(&mut Context);

fn image(c: &mut Context, internal: GLenum, format: GLenum, ty: GLenum) {
    c.tex_image_2d(GL_TEXTURE_2D, 0, internal as i32, 1, 1, 0, format, ty, Data::Null);
}

/// Calls that are refused, and the error.
const REFUSED: &[(&str, Call, GLenum)] = &[
    ("another type", |c| image(c, GL_SRGB, GL_SRGB, GL_FLOAT), GL_INVALID_OPERATION),
    (
        "another format",
        |c| image(c, GL_SRGB_ALPHA, GL_RGBA, GL_UNSIGNED_BYTE),
        GL_INVALID_OPERATION,
    ),
    (
        "the format with linear texels",
        |c| image(c, GL_RGBA, GL_SRGB_ALPHA, GL_UNSIGNED_BYTE),
        GL_INVALID_OPERATION,
    ),
    (
        "mipmaps",
        |c| {
            texture(c, GL_SRGB_ALPHA, GL_SRGB_ALPHA, &[0; 4]);
            c.generate_mipmap(GL_TEXTURE_2D);
        },
        GL_INVALID_OPERATION,
    ),
    (
        "a read",
        |c| {
            let out = DataOut::Bytes(&mut [0; 4]);
            c.read_pixels(0, 0, 1, 1, GL_SRGB_ALPHA, GL_UNSIGNED_BYTE, out);
        },
        GL_INVALID_ENUM,
    ),
    (
        "a renderbuffer without a size",
        |c| {
            let mut name = [0];
            c.gen_renderbuffers(1, &mut name);
            c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
            c.renderbuffer_storage(GL_RENDERBUFFER, GL_SRGB_ALPHA, 4, 4);
        },
        GL_INVALID_ENUM,
    ),
];

#[test]
fn what_is_none_of_its_is_refused() {
    for (what, call, error) in REFUSED {
        let mut c = es();
        texture(&mut c, GL_RGBA, GL_RGBA, &[0; 4]);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{what}");
        call(&mut c);
        assert_eq!(c.get_error(), *error, "{what}: {:?}", c.messages());
    }
}
