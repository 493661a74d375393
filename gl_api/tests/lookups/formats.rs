//! What a sample gives of the base formats: integers, signed fractions, blocks.

use super::{context, drawn, program};
use gl_api::*;

const VERTEX: &str = "void main() { gl_Position = gl_Vertex; }";

/// A texture of one texel of this format, sampled; `convert` makes fractions of `t`.
fn sampled(
    internal: GLenum,
    (format, ty): (GLenum, GLenum),
    texel: &[u8],
    shader: &str,
) -> [u8; 4] {
    let t = GL_TEXTURE_2D;
    glDeleteTextures(1, &1);
    glBindTexture(t, 1);
    glTexParameteri(t, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(t, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(t, 0, internal, 1, 1, 0, format, ty, texel);
    assert_eq!(glGetError(), GL_NO_ERROR, "{}", enum_name(internal));
    let program = program(VERTEX, shader).unwrap();
    let pixel = drawn(program);
    glUseProgram(0);
    glDeleteProgram(program);
    pixel
}

const UINTS: &str = "#version 130
uniform usampler2D s; void main() { gl_FragColor = vec4(texture(s, vec2(0.5))) / 255.0; }";
const INTS: &str = "#version 130
uniform isampler2D s; void main() { gl_FragColor = vec4(-texture(s, vec2(0.5))) / 255.0; }";
/// -1 to 1 as 0 to 254.
const SIGNED: &str = "uniform sampler2D s;
void main() { gl_FragColor = (texture2D(s, vec2(0.5)) * 127.0 + 127.0) / 255.0; }";

#[test]
fn integers() {
    let _current = context();
    let (a, l, la) =
        (GL_ALPHA_INTEGER_EXT, GL_LUMINANCE_INTEGER_EXT, GL_LUMINANCE_ALPHA_INTEGER_EXT);
    let (r, rg, rgba) = (GL_RED_INTEGER, GL_RG_INTEGER, GL_RGBA_INTEGER);
    let rows: &[(GLenum, GLenum, [u8; 4])] = &[
        (GL_ALPHA8UI_EXT, a, [0, 0, 0, 7]),
        (GL_ALPHA16UI_EXT, a, [0, 0, 0, 7]),
        (GL_ALPHA32UI_EXT, a, [0, 0, 0, 7]),
        (GL_LUMINANCE8UI_EXT, l, [7, 7, 7, 1]),
        (GL_LUMINANCE16UI_EXT, l, [7, 7, 7, 1]),
        (GL_LUMINANCE32UI_EXT, l, [7, 7, 7, 1]),
        (GL_LUMINANCE_ALPHA8UI_EXT, la, [7, 7, 7, 9]),
        (GL_LUMINANCE_ALPHA32UI_EXT, la, [7, 7, 7, 9]),
        (GL_INTENSITY8UI_EXT, r, [7, 7, 7, 7]),
        (GL_INTENSITY16UI_EXT, r, [7, 7, 7, 7]),
        (GL_R8UI, r, [7, 0, 0, 1]),
        (GL_RG16UI, rg, [7, 9, 0, 1]),
        (GL_RGB10_A2UI, rgba, [7, 9, 11, 3]),
        (GL_RGBA32UI, rgba, [7, 9, 11, 13]),
    ];
    for &(internal, format, want) in rows {
        let texel = [7_u8, 9, 11, 13];
        let got = sampled(internal, (format, GL_UNSIGNED_BYTE), &texel, UINTS);
        assert_eq!(got, want, "{}", enum_name(internal));
    }
    // A 1 that is not stored is 1, so that its negative is clamped to 0.
    for (internal, format, want) in [
        (GL_ALPHA8I_EXT, a, [0, 0, 0, 7]),
        (GL_LUMINANCE16I_EXT, l, [7, 7, 7, 0]),
        (GL_LUMINANCE_ALPHA16I_EXT, la, [7, 7, 7, 9]),
        (GL_INTENSITY32I_EXT, r, [7, 7, 7, 7]),
        (GL_RGBA8I, rgba, [7, 9, 11, 13]),
    ] {
        let texel = [-7_i8, -9, -11, -13].map(|c| c as u8);
        let got = sampled(internal, (format, GL_BYTE), &texel, INTS);
        assert_eq!(got, want, "{}", enum_name(internal));
    }
}

#[test]
fn signed_fractions() {
    let _current = context();
    for (internal, want) in [
        (GL_ALPHA8_SNORM, [127, 127, 127, 190]),
        (GL_LUMINANCE8_SNORM, [0, 0, 0, 254]),
        (GL_LUMINANCE8_ALPHA8_SNORM, [0, 0, 0, 190]),
        (GL_INTENSITY16_SNORM, [0, 0, 0, 0]),
        (GL_RED_SNORM, [0, 127, 127, 254]),
        (GL_RGBA_SNORM, [0, 190, 254, 190]),
        (GL_RGBA16_SNORM, [0, 190, 254, 190]),
    ] {
        let texel = [-1.0_f32, 63.0 / 127.0, 1.0, 63.0 / 127.0];
        let bytes: Vec<u8> = texel.iter().flat_map(|c| c.to_ne_bytes()).collect();
        let got = sampled(internal, (GL_RGBA, GL_FLOAT), &bytes, SIGNED);
        assert_eq!(got, want, "{}", enum_name(internal));
    }
}

/// Formats that do not serve any texture are there, but not listed (GL 2.1, section 6.1.3).
#[test]
fn the_list_of_compressed_formats_is_for_any_texture() {
    let _current = context();
    let mut count = 0;
    glGetIntegerv(GL_NUM_COMPRESSED_TEXTURE_FORMATS, &mut count);
    let mut formats = vec![0; count as usize];
    glGetIntegerv(GL_COMPRESSED_TEXTURE_FORMATS, &mut formats[..]);
    let has = |format: GLenum| formats.contains(&(format as i32));
    assert!(has(GL_COMPRESSED_RGB_S3TC_DXT1_EXT) && has(GL_COMPRESSED_RGBA_S3TC_DXT5_EXT));
    assert!(!has(GL_COMPRESSED_RGBA_S3TC_DXT1_EXT) && !has(GL_COMPRESSED_RED_RGTC1));
    assert!(!has(GL_COMPRESSED_SRGB_S3TC_DXT1_EXT) && !has(GL_COMPRESSED_LUMINANCE_ALPHA_3DC_ATI));
    assert_eq!(glGetError(), GL_NO_ERROR);
}

/// Where nothing is compressed, the internal format is the base format (GL 2.1, section 3.8.1).
#[test]
fn generic_compressed_formats_become_others() {
    let _current = context();
    for (asked, got) in [
        (GL_COMPRESSED_RGB, GL_RGB),
        (GL_COMPRESSED_RG, GL_RG),
        (GL_COMPRESSED_SRGB_ALPHA, GL_RGBA),
        (GL_COMPRESSED_SLUMINANCE, GL_LUMINANCE),
        (GL_COMPRESSED_INTENSITY, GL_INTENSITY),
    ] {
        glTexImage2D(GL_TEXTURE_2D, 0, asked, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, Data::Null);
        let mut answers = [0; 2];
        let [internal, compressed] = &mut answers;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, internal);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED, compressed);
        assert_eq!(answers, [got as i32, 0], "{}", enum_name(asked));
    }
    assert_eq!(glGetError(), GL_NO_ERROR);
}

/// Luminance is R of what is read back, and no G and B (GL 2.1, section 6.1.4).
#[test]
fn blocks_of_luminance_are_read_back_as_red() {
    let _current = context();
    for (internal, alpha) in
        [(GL_COMPRESSED_LUMINANCE_LATC1_EXT, 255), (GL_COMPRESSED_LUMINANCE_ALPHA_LATC2_EXT, 100)]
    {
        let texels = [[200_u8, 100]; 16].concat();
        let ty = GL_UNSIGNED_BYTE;
        glTexImage2D(GL_TEXTURE_2D, 0, internal, 4, 4, 0, GL_LUMINANCE_ALPHA, ty, &texels);
        let mut out = [0_u8; 64];
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, ty, &mut out);
        assert_eq!(out[..4], [200, 0, 0, alpha], "{}", enum_name(internal));
    }
    assert_eq!(glGetError(), GL_NO_ERROR);
}

#[test]
fn blocks_of_luminance() {
    let _current = context();
    let plain = "uniform sampler2D s; void main() { gl_FragColor = texture2D(s, vec2(0.5)); }";
    for (internal, want) in [
        (GL_COMPRESSED_LUMINANCE_LATC1_EXT, [200, 200, 200, 255]),
        (GL_COMPRESSED_LUMINANCE_ALPHA_LATC2_EXT, [200, 200, 200, 100]),
        (GL_COMPRESSED_LUMINANCE_ALPHA_3DC_ATI, [200, 200, 200, 100]),
        (GL_COMPRESSED_RED_RGTC1, [200, 0, 0, 255]),
        (GL_COMPRESSED_RG_RGTC2, [200, 0, 0, 255]),
    ] {
        let got = sampled(internal, (GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE), &[200, 100], plain);
        let want = if internal == GL_COMPRESSED_RG_RGTC2 { [200, 200, 0, 255] } else { want };
        assert_eq!(got, want, "{}", enum_name(internal));
    }
}

/// Parameters of textures and of sampler objects say whether sRGB colours are linear.
#[test]
fn colours_of_srgb_textures_are_decoded_or_as_they_are() {
    let _current = context();
    let (rgba, bytes) = (GL_RGBA, GL_UNSIGNED_BYTE);
    // Bytes, and what they are as linear light.
    let (stored, linear) = ([188, 128, 64, 100], [128, 55, 13, 100]);
    let lookup = "uniform sampler2D s; void main() { gl_FragColor = texture2D(s, vec2(0.5)); }";
    let fetch = "#version 130
uniform sampler2D s; void main() { gl_FragColor = texelFetch(s, ivec2(0), 0); }";
    let (lookup, fetch) = (program(VERTEX, lookup).unwrap(), program(VERTEX, fetch).unwrap());
    let t = GL_TEXTURE_2D;
    let (decode, skip) = (GL_DECODE_EXT as i32, GL_SKIP_DECODE_EXT as i32);
    glBindTexture(t, 1);
    glTexParameteri(t, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (internal, stored, linear) in [
        (GL_SRGB8_ALPHA8, stored, linear),
        (GL_SRGB8, [188, 128, 64, 255], [128, 55, 13, 255]),
        (GL_SLUMINANCE8_ALPHA8, [188, 188, 188, 100], [128, 128, 128, 100]),
        (GL_SLUMINANCE8, [188, 188, 188, 255], [128, 128, 128, 255]),
        (GL_RGBA8, [188, 128, 64, 100], [188, 128, 64, 100]),
    ] {
        glTexImage2D(t, 0, internal, 1, 1, 0, rgba, bytes, &[188_u8, 128, 64, 100]);
        glTexParameteri(t, GL_TEXTURE_SRGB_DECODE_EXT, skip);
        assert_eq!(drawn(lookup), stored, "{}", enum_name(internal));
        // Texels that are fetched are always linear.
        assert_eq!(drawn(fetch), linear, "{}", enum_name(internal));
        assert_eq!(drawn(lookup), stored, "{}", enum_name(internal));
        glTexParameteri(t, GL_TEXTURE_SRGB_DECODE_EXT, decode);
        assert_eq!(drawn(lookup), linear, "{}", enum_name(internal));
    }
    // The fixed function, and a sampler object, which takes the texture's place.
    glTexImage2D(t, 0, GL_SRGB8_ALPHA8, 1, 1, 0, rgba, bytes, &[188_u8, 128, 64, 100]);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(t);
    let mut sampler = [0];
    glGenSamplers(1, &mut sampler);
    glSamplerParameteri(sampler[0], GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    let mut value = [0];
    glGetSamplerParameteriv(sampler[0], GL_TEXTURE_SRGB_DECODE_EXT, &mut value);
    assert_eq!(value, [decode]);
    glSamplerParameteri(sampler[0], GL_TEXTURE_SRGB_DECODE_EXT, skip);
    assert_eq!(drawn(0), linear);
    glBindSampler(0, sampler[0]);
    assert_eq!(drawn(0), stored);
    glTexParameteri(t, GL_TEXTURE_SRGB_DECODE_EXT, skip);
    glSamplerParameteri(sampler[0], GL_TEXTURE_SRGB_DECODE_EXT, decode);
    assert_eq!(drawn(0), linear);
    glBindSampler(0, 0);
    assert_eq!(drawn(0), stored);
    glGetTexParameteriv(t, GL_TEXTURE_SRGB_DECODE_EXT, &mut value);
    assert_eq!(value, [skip]);
    assert_eq!(glGetError(), GL_NO_ERROR);
}

/// Compressed colours too.
#[test]
fn colours_of_srgb_blocks_are_as_they_are() {
    let _current = context();
    let lookup = "uniform sampler2D s; void main() { gl_FragColor = texture2D(s, vec2(0.5)); }";
    let lookup = program(VERTEX, lookup).unwrap();
    let t = GL_TEXTURE_2D;
    glBindTexture(t, 1);
    glTexParameteri(t, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    // Two colours of a block alike: red 16 of 31, green 32 of 63, blue 16 of 31.
    let block = [0x10_u8, 0x84, 0x10, 0x84, 0, 0, 0, 0];
    for (internal, want) in [
        (GL_COMPRESSED_SRGB_S3TC_DXT1_EXT, [132, 130, 132, 255]),
        (GL_COMPRESSED_RGB_S3TC_DXT1_EXT, [132, 130, 132, 255]),
    ] {
        glCompressedTexImage2D(t, 0, internal, 4, 4, 0, 8, &block);
        glTexParameteri(t, GL_TEXTURE_SRGB_DECODE_EXT, GL_SKIP_DECODE_EXT);
        assert_eq!(drawn(lookup), want, "{}", enum_name(internal));
    }
    assert_eq!(glGetError(), GL_NO_ERROR);
}
