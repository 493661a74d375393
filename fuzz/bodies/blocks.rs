//! Any bytes as compressed blocks, for the fuzz target `blocks` and the tests of hostile images of OpenGL ES.

use gl_api::*;

/// Compressed formats, and the bytes of a block of 4 × 4 texels.
pub const FORMATS: [(GLenum, usize); 19] = [
    (GL_ETC1_RGB8_OES, 8),
    (GL_COMPRESSED_RGB8_ETC2, 8),
    (GL_COMPRESSED_SRGB8_ETC2, 8),
    (GL_COMPRESSED_RGB8_PUNCHTHROUGH_ALPHA1_ETC2, 8),
    (GL_COMPRESSED_SRGB8_PUNCHTHROUGH_ALPHA1_ETC2, 8),
    (GL_COMPRESSED_RGBA8_ETC2_EAC, 16),
    (GL_COMPRESSED_SRGB8_ALPHA8_ETC2_EAC, 16),
    (GL_COMPRESSED_R11_EAC, 8),
    (GL_COMPRESSED_SIGNED_R11_EAC, 8),
    (GL_COMPRESSED_RG11_EAC, 16),
    (GL_COMPRESSED_SIGNED_RG11_EAC, 16),
    (GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8),
    (GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 8),
    (GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, 16),
    (GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16),
    (GL_COMPRESSED_RED_RGTC1, 8),
    (GL_COMPRESSED_SIGNED_RED_RGTC1, 8),
    (GL_COMPRESSED_RG_RGTC2, 16),
    (GL_COMPRESSED_SIGNED_RG_RGTC2, 16),
];

const VERTEX: &str = "#version 300 es\nvoid main() {\n\
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }";
/// White where a texel is a number that its format has.
const FRAGMENT: &str = "#version 300 es\nprecision highp float; uniform highp sampler2D image; out vec4 color;\n\
    void main() {\n\
      ivec2 at = ivec2(gl_FragCoord.xy) % textureSize(image, 0);\n\
      vec4 texel = texelFetch(image, at, 0);\n\
      color = vec4(all(lessThanEqual(abs(texel), vec4(1.0))));\n\
    }";

/// The first three bytes say which format and size, the others are the blocks, as many as there are. An image with too few
/// or too many is refused; every texel of another is a number in [-1, 1].
pub fn sample(c: &mut Context, bytes: &[u8]) {
    let [which, width, height, blocks @ ..] = bytes else { return };
    let (format, block) = FORMATS[usize::from(*which) % FORMATS.len()];
    let [width, height] = [width, height].map(|side| i32::from(side % 23));
    let expected = [width, height].map(|side| side as usize).map(|side| side.div_ceil(4));
    let (size, given) = (expected[0] * expected[1] * block, blocks.len());
    let mut texture = [0];
    c.gen_textures(1, &mut texture);
    c.bind_texture(GL_TEXTURE_2D, texture[0]);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
    let data = Data::Bytes(blocks);
    c.compressed_tex_image_2d(GL_TEXTURE_2D, 0, format, width, height, 0, given as i32, data);
    assert_eq!(
        c.get_error() == GL_NO_ERROR,
        given == size,
        "{} {width} × {height}",
        enum_name(format)
    );
    let mut padded = blocks.to_vec();
    padded.resize(size, 0x5a);
    let data = Data::Bytes(&padded);
    c.compressed_tex_image_2d(GL_TEXTURE_2D, 0, format, width, height, 0, size as i32, data);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    if size > 0 {
        // Images of ETC1 are given whole.
        if format != GL_ETC1_RGB8_OES {
            let data = Data::Bytes(&padded);
            c.compressed_tex_sub_image_2d(
                GL_TEXTURE_2D,
                0,
                0,
                0,
                width,
                height,
                format,
                size as i32,
                data,
            );
            assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
        }
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        let mut out = [0_u8; 40 * 30 * 4];
        c.read_pixels(0, 0, 40, 30, GL_RGBA, GL_UNSIGNED_BYTE, (&mut out).arg());
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
        assert!(out.iter().all(|&byte| byte == 255), "{} {width} × {height}", enum_name(format));
    }
    c.delete_textures(1, &texture);
}

/// Uses the program that samples.
pub fn prepare(c: &mut Context) {
    let program = c.create_program();
    for (stage, source) in [(GL_VERTEX_SHADER, VERTEX), (GL_FRAGMENT_SHADER, FRAGMENT)] {
        let shader = c.create_shader(stage);
        c.shader_source(shader, 1, Strings(vec![source]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.link_program(program);
    c.use_program(program);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}
