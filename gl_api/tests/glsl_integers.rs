//! Integer attributes and uniforms reach shaders with all their bits, and read back unchanged.

use gl_api::*;

const VERTEX: &str = "#version 130
in ivec4 a; in uvec2 b; uniform uint low; uniform int high; flat out vec4 color;
void main() {
    bool exact = a == ivec4(0x12345678, -0x12345679, 0, 1) && b == uvec2(0xfedcba98u, 16777217u);
    bool words = low == 0xffffffffu && high == -16777217;
    color = vec4(exact, words, 0.0, 1.0);
    gl_Position = gl_Vertex;
}";
const FRAGMENT: &str = "#version 130
flat in vec4 color;
void main() { gl_FragColor = color; }";

#[test]
fn all_bits_arrive() {
    let desc = ContextDesc { width: 4, height: 4, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    let program = c.create_program();
    for (ty, source) in [(GL_VERTEX_SHADER, VERTEX), (GL_FRAGMENT_SHADER, FRAGMENT)] {
        let shader = c.create_shader(ty);
        c.shader_source(shader, 1, Strings(vec![source]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.bind_attrib_location(program, 1, "a");
    c.bind_attrib_location(program, 2, "b");
    c.link_program(program);
    c.use_program(program);
    let low = c.get_uniform_location(program, "low");
    let high = c.get_uniform_location(program, "high");
    c.uniform_1ui(low, u32::MAX);
    c.uniform_1i(high, -16_777_217);
    let mut back = [0; 1];
    c.get_uniformuiv(program, low, &mut back);
    assert_eq!(back, [u32::MAX]);
    c.get_uniformuiv(program, high, &mut back);
    assert_eq!(back, [-16_777_217_i32 as u32]);
    c.vertex_attrib_i_2i(1, 0x1234_5678, -0x1234_5679);
    c.vertex_attrib_i_2uiv(2, &[0xfedc_ba98, 16_777_217]);
    c.begin(GL_QUADS);
    for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
        c.vertex_2f(x, y);
    }
    c.end();
    let mut out = [0_u8; 4];
    c.read_pixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut out));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    assert_eq!(out, [255, 255, 0, 255]);
    c.vertex_attrib_i_4iv(1, &[1, 2]);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    c.vertex_attrib_i_1ui(99, 1);
    assert_eq!(c.get_error(), GL_INVALID_VALUE);
}

/// Alpha of integers without it is 1 in every frame: shaders that are compiled again for opaque textures leave it.
#[test]
fn alpha_of_integers_is_the_integer_one() {
    const VERTEX: &str = "#version 130\nvoid main() { gl_Position = gl_Vertex; }";
    const FRAGMENT: &str = "#version 130
uniform usampler2D image; uniform float one;
void main() {
    uvec4 texel = texture(image, vec2(0.5));
    bool right = texel.a == 1u && texel.a + 1u == 2u && texel.r == 7u;
    gl_FragColor = vec4(right ? one : 0.0, 0.0, 0.0, 1.0);
}";
    let mut c = Context::new(ContextDesc { width: 4, height: 4, ..ContextDesc::default() })
        .expect("a device");
    let program = c.create_program();
    for (ty, source) in [(GL_VERTEX_SHADER, VERTEX), (GL_FRAGMENT_SHADER, FRAGMENT)] {
        let shader = c.create_shader(ty);
        c.shader_source(shader, 1, Strings(vec![source]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.link_program(program);
    c.use_program(program);
    let one = c.get_uniform_location(program, "one");
    c.uniform_1f(one, 1.0);
    c.bind_texture(GL_TEXTURE_2D, 1);
    c.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    c.tex_image_2d(
        GL_TEXTURE_2D,
        0,
        GL_RGB8UI as GLint,
        1,
        1,
        0,
        GL_RGB_INTEGER,
        GL_UNSIGNED_BYTE,
        Data::Bytes(&[7, 8, 9]),
    );
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST as GLint);
    for frame in 0..4 {
        c.clear(GL_COLOR_BUFFER_BIT);
        c.begin(GL_QUADS);
        for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            c.vertex_2f(x, y);
        }
        c.end();
        let mut out = [0_u8; 4];
        c.read_pixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut out));
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
        assert_eq!(out, [255, 0, 0, 255], "frame {frame}");
    }
}
