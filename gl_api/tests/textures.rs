//! Texture images of every target and format: round trips, proxies, parts, copies, compressed
//! images, and pictures of each target sampled by the fixed function.

use gl_api::*;

fn context() -> Context {
    Context::new(ContextDesc { width: 4, height: 4, ..ContextDesc::default() }).expect("a device")
}

fn ok(c: &mut Context) {
    let messages = c.messages();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{messages:?}");
}

fn floats(bytes: &[u8]) -> Vec<f32> {
    bytes.chunks_exact(4).map(|b| f32::from_ne_bytes([b[0], b[1], b[2], b[3]])).collect()
}

/// Every internal format of fractions or floats, with the bits of R, G, B, A that come back (0 for
/// those that are not there).
const FORMATS: &[(GLenum, [u32; 4])] = &[
    (GL_RGB4, [4, 4, 4, 0]),
    (GL_RGB5, [5, 5, 5, 0]),
    (GL_RGB565, [5, 6, 5, 0]),
    (GL_RGB8, [8, 8, 8, 0]),
    (GL_RGB10, [10, 10, 10, 0]),
    (GL_RGB12, [12, 12, 12, 0]),
    (GL_RGB16, [16, 16, 16, 0]),
    (GL_R3_G3_B2, [3, 3, 2, 0]),
    (GL_RGBA2, [2, 2, 2, 2]),
    (GL_RGBA4, [4, 4, 4, 4]),
    (GL_RGB5_A1, [5, 5, 5, 1]),
    (GL_RGBA8, [8, 8, 8, 8]),
    (GL_RGB10_A2, [10, 10, 10, 2]),
    (GL_RGBA12, [12, 12, 12, 12]),
    (GL_RGBA16, [16, 16, 16, 16]),
    (GL_ALPHA16, [0, 0, 0, 16]),
    (GL_LUMINANCE16, [16, 0, 0, 0]),
    (GL_LUMINANCE16_ALPHA16, [16, 0, 0, 16]),
    (GL_INTENSITY16, [16, 0, 0, 0]),
    (GL_R16, [16, 0, 0, 0]),
    (GL_RG16, [16, 16, 0, 0]),
    (GL_RGBA8_SNORM, [7, 7, 7, 7]),
    (GL_RG16_SNORM, [15, 15, 0, 0]),
    (GL_RGBA16F, [11, 11, 11, 11]),
    (GL_RGBA32F, [20, 20, 20, 20]),
    (GL_LUMINANCE32F_ARB, [20, 0, 0, 0]),
    (GL_R11F_G11F_B10F, [6, 6, 5, 0]),
    (GL_RGB9_E5, [8, 8, 8, 0]),
];

#[test]
fn formats_keep_as_many_bits_as_they_promise() {
    let color = [0.37_f32, 0.81, 0.13, 0.66];
    for &(internal, bits) in FORMATS {
        for (target, ty) in [(GL_TEXTURE_1D, GL_FLOAT), (GL_TEXTURE_1D, GL_UNSIGNED_SHORT)] {
            let mut c = context();
            let pixels: Vec<u8> = match ty {
                GL_FLOAT => color.iter().flat_map(|x| x.to_ne_bytes()).collect(),
                _ => color.iter().flat_map(|x| ((x * 65_535.0) as u16).to_ne_bytes()).collect(),
            };
            c.tex_image_1d(target, 0, internal as i32, 1, 0, GL_RGBA, ty, Data::Bytes(&pixels));
            let mut out = [0; 16];
            c.get_tex_image(target, 0, GL_RGBA, GL_FLOAT, DataOut::Bytes(&mut out));
            ok(&mut c);
            for (component, (got, want)) in floats(&out).iter().zip(color).enumerate() {
                let want = match (bits[component], component) {
                    (0, 3) => 1.0,
                    (0, _) => 0.0,
                    _ => want,
                };
                let step = match bits[component] {
                    0 => 0.0,
                    bits => 1.0 / (2.0_f32.powi(bits as i32) - 1.0),
                };
                let name = enum_name(internal);
                assert!(
                    (got - want).abs() <= step / 2.0 + 2e-5,
                    "{name} {component}: {got} {want}"
                );
            }
        }
    }
}

/// `EXT_texture_shared_exponent`: only one format has bits that all components share.
#[test]
fn bits_of_a_shared_exponent_can_be_asked_for() {
    for (internal, bits) in [(GL_RGB9_E5, 5), (GL_RGB16F, 0), (GL_RGBA8, 0)] {
        let mut c = context();
        let asked = |c: &mut Context| {
            let mut bits = [-1];
            c.get_tex_level_parameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_SHARED_SIZE, &mut bits);
            bits[0]
        };
        assert_eq!(asked(&mut c), 0);
        let (rgb, ty) = (GL_RGB, GL_FLOAT);
        c.tex_image_2d(GL_TEXTURE_2D, 0, internal as i32, 2, 2, 0, rgb, ty, Data::Null);
        assert_eq!(asked(&mut c), bits, "{}", enum_name(internal));
        ok(&mut c);
    }
}

#[test]
fn integers_stay_themselves() {
    for (internal, ty, values) in [
        (GL_RGBA8UI, GL_INT, [0, 1, 200, 255]),
        (GL_RGBA8I, GL_INT, [-128, -1, 0, 127]),
        (GL_RGBA16UI, GL_INT, [0, 1, 40_000, 65_535]),
        (GL_RGBA16I, GL_INT, [-32_768, -1, 0, 32_767]),
        (GL_RGBA32I, GL_INT, [i32::MIN, -1, 123_456_789, i32::MAX]),
    ] {
        let mut c = context();
        let bytes: Vec<u8> = values.iter().flat_map(|v: &i32| v.to_ne_bytes()).collect();
        let format = GL_RGBA_INTEGER;
        c.tex_image_1d(GL_TEXTURE_1D, 0, internal as i32, 1, 0, format, ty, Data::Bytes(&bytes));
        let mut out = [0; 16];
        c.get_tex_image(GL_TEXTURE_1D, 0, format, ty, DataOut::Bytes(&mut out));
        ok(&mut c);
        assert_eq!(out[..], bytes[..], "{}", enum_name(internal));
    }
}

#[test]
fn every_packed_type_is_read_and_written() {
    for (format, ty, bytes) in [
        (GL_RGB, GL_UNSIGNED_BYTE_3_3_2, &[0xAE][..]),
        (GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV, &[0x9D]),
        (GL_RGB, GL_UNSIGNED_SHORT_5_6_5, &[0x34, 0xA2]),
        (GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV, &[0x34, 0xA2]),
        (GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, &[0x34, 0xA2]),
        (GL_BGRA, GL_UNSIGNED_SHORT_4_4_4_4_REV, &[0x34, 0xA2]),
        (GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, &[0x35, 0xA2]),
        (GL_BGRA, GL_UNSIGNED_SHORT_1_5_5_5_REV, &[0x34, 0xA2]),
        (GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, &[1, 2, 3, 4]),
        (GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, &[1, 2, 3, 4]),
        (GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, &[1, 2, 3, 4]),
        (GL_BGRA, GL_UNSIGNED_INT_2_10_10_10_REV, &[1, 2, 3, 4]),
        (GL_RGB, GL_UNSIGNED_INT_5_9_9_9_REV, &[0x12, 0x34, 0x56, 0x7F]),
        (GL_RGB, GL_UNSIGNED_INT_10F_11F_11F_REV, &[0x12, 0x34, 0x56, 0x71]),
        (GL_RGBA, GL_HALF_FLOAT, &[0, 0x3C, 0, 0x40, 0, 0xC0, 1, 0]),
    ] {
        for swap in [0, 1] {
            let mut c = context();
            c.pixel_storei(GL_UNPACK_SWAP_BYTES, swap);
            let internal = GL_RGBA32F as i32;
            c.tex_image_1d(GL_TEXTURE_1D, 0, internal, 1, 0, format, ty, Data::Bytes(bytes));
            let mut out = vec![0; bytes.len()];
            c.pixel_storei(GL_PACK_SWAP_BYTES, swap);
            c.get_tex_image(GL_TEXTURE_1D, 0, format, ty, DataOut::Bytes(&mut out));
            ok(&mut c);
            if ty == GL_UNSIGNED_INT_5_9_9_9_REV {
                // Not every word is the one that is written of its colour.
                continue;
            }
            assert_eq!(out, bytes, "{} swap {swap}", enum_name(ty));
        }
    }
}

#[test]
fn depth_and_stencil_go_together() {
    let mut c = context();
    let word = 0x1234_56AB_u32.to_ne_bytes();
    let (format, ty) = (GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
    c.tex_image_2d(GL_TEXTURE_2D, 0, format as i32, 1, 1, 0, format, ty, Data::Bytes(&word));
    let mut out = [0; 4];
    c.get_tex_image(GL_TEXTURE_2D, 0, format, ty, DataOut::Bytes(&mut out));
    assert_eq!(out, word);
    let mut bits = [0];
    c.get_tex_level_parameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_STENCIL_SIZE, &mut bits);
    assert_eq!(bits, [8]);
    ok(&mut c);
}

#[test]
fn scale_and_bias_are_applied_on_the_way_in_alone() {
    let mut c = context();
    c.bind_texture(GL_TEXTURE_1D, 1);
    c.pixel_transferf(GL_RED_SCALE, 0.5);
    c.pixel_transferf(GL_GREEN_BIAS, 0.25);
    let pixels = [1.0_f32, 0.5, 0.25, 1.0];
    let bytes: Vec<u8> = pixels.iter().flat_map(|x| x.to_ne_bytes()).collect();
    let internal = GL_RGBA32F as i32;
    c.tex_image_1d(GL_TEXTURE_1D, 0, internal, 1, 0, GL_RGBA, GL_FLOAT, Data::Bytes(&bytes));
    // GL 2.1, section 6.1.4: reading back performs no transfer operations, whatever the state is.
    for state in 0..2 {
        if state > 0 {
            c.pixel_transferf(GL_ALPHA_SCALE, 0.5);
            c.pixel_transferi(GL_MAP_COLOR, 1);
        }
        let (mut whole, mut part) = ([0; 16], [0; 16]);
        c.get_tex_image(GL_TEXTURE_1D, 0, GL_RGBA, GL_FLOAT, DataOut::Bytes(&mut whole));
        let out = DataOut::Bytes(&mut part);
        c.get_texture_sub_image(1, 0, 0, 0, 0, 1, 1, 1, GL_RGBA, GL_FLOAT, 16, out);
        ok(&mut c);
        assert_eq!(floats(&whole), [0.5, 0.75, 0.25, 1.0]);
        assert_eq!(floats(&part), [0.5, 0.75, 0.25, 1.0]);
    }
}

#[test]
fn proxies_answer_and_take_no_memory() {
    let mut c = context();
    let width = |c: &mut Context, target| {
        let mut width = [-1];
        c.get_tex_level_parameteriv(target, 0, GL_TEXTURE_WIDTH, &mut width);
        width[0]
    };
    let (ty, none) = (GL_UNSIGNED_BYTE, Data::Null);
    for (size, want) in [(8192, 8192), (8193, 0), (16, 16)] {
        let target = GL_PROXY_TEXTURE_2D;
        c.tex_image_2d(target, 0, GL_RGBA32F as i32, size, size, 0, GL_RGBA, ty, none);
        assert_eq!(width(&mut c, target), want);
    }
    for (size, want) in [(512, 512), (513, 0)] {
        let target = GL_PROXY_TEXTURE_3D;
        c.tex_image_3d(target, 0, GL_RGB as i32, size, 1, 1, 0, GL_RGB, ty, none);
        assert_eq!(width(&mut c, target), want);
    }
    // Each side is allowed, the whole is not.
    let target = GL_PROXY_TEXTURE_2D_ARRAY;
    c.tex_image_3d(target, 0, GL_RGBA32F as i32, 8192, 8192, 2048, 0, GL_RGBA, ty, none);
    assert_eq!(width(&mut c, target), 0);
    ok(&mut c);
}

#[test]
fn volumes_are_picked_out_of_larger_ones() {
    let mut c = context();
    // 4 images of 4 rows of 4 bytes; the box (1, 1, 1) to (3, 3, 3).
    let volume: Vec<u8> = (0..64).collect();
    for (name, value) in [
        (GL_UNPACK_ROW_LENGTH, 4),
        (GL_UNPACK_IMAGE_HEIGHT, 4),
        (GL_UNPACK_SKIP_PIXELS, 1),
        (GL_UNPACK_SKIP_ROWS, 1),
        (GL_UNPACK_SKIP_IMAGES, 1),
    ] {
        c.pixel_storei(name, value);
    }
    let (l, ty) = (GL_LUMINANCE, GL_UNSIGNED_BYTE);
    c.tex_image_3d(GL_TEXTURE_3D, 0, l as i32, 2, 2, 2, 0, l, ty, Data::Bytes(&volume));
    let mut out = [0; 8];
    c.pixel_storei(GL_PACK_ALIGNMENT, 1);
    c.get_tex_image(GL_TEXTURE_3D, 0, l, ty, DataOut::Bytes(&mut out));
    assert_eq!(out, [21, 22, 25, 26, 37, 38, 41, 42]);
    c.pixel_storei(GL_UNPACK_SKIP_IMAGES, 0);
    c.tex_sub_image_3d(GL_TEXTURE_3D, 0, 1, 1, 1, 1, 1, 1, l, ty, Data::Bytes(&volume));
    c.get_tex_image(GL_TEXTURE_3D, 0, l, ty, DataOut::Bytes(&mut out));
    assert_eq!(out, [21, 22, 25, 26, 37, 38, 41, 5]);
    ok(&mut c);
}

#[test]
fn borders_are_texels() {
    let mut c = context();
    let texels: Vec<u8> = (0..16).collect();
    let (l, ty) = (GL_LUMINANCE, GL_UNSIGNED_BYTE);
    c.tex_image_2d(GL_TEXTURE_2D, 0, l as i32, 4, 4, 1, l, ty, Data::Bytes(&texels));
    for (pname, want) in [(GL_TEXTURE_WIDTH, 4), (GL_TEXTURE_HEIGHT, 4), (GL_TEXTURE_BORDER, 1)] {
        let mut value = [0];
        c.get_tex_level_parameteriv(GL_TEXTURE_2D, 0, pname, &mut value);
        assert_eq!(value[0], want, "{}", enum_name(pname));
    }
    c.tex_sub_image_2d(GL_TEXTURE_2D, 0, -1, -1, 1, 1, l, ty, Data::Bytes(&[99]));
    let mut out = [0; 16];
    c.get_tex_image(GL_TEXTURE_2D, 0, l, ty, DataOut::Bytes(&mut out));
    ok(&mut c);
    assert_eq!((out[0], &out[1..]), (99, &texels[1..]));
}

#[test]
fn compressed_blocks_come_back_and_decode() {
    let mut c = context();
    // Red and blue ends; the first texel takes the first, all others the second.
    let block = [0x00, 0xF8, 0x1F, 0x00, 0x54, 0x55, 0x55, 0x55];
    let dxt1 = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
    c.compressed_tex_image_2d(GL_TEXTURE_2D, 0, dxt1, 4, 4, 0, 8, Data::Bytes(&block));
    let mut back = [0; 8];
    c.get_compressed_tex_image(GL_TEXTURE_2D, 0, DataOut::Bytes(&mut back));
    assert_eq!(back, block);
    let mut out = [0; 64];
    c.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut out));
    assert_eq!((&out[..4], &out[4..8]), (&[255, 0, 0, 255][..], &[0, 0, 255, 255][..]));
    // The same pixels, compressed here.
    let pixels = Data::Bytes(&out);
    c.tex_image_2d(GL_TEXTURE_2D, 0, dxt1 as i32, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    let mut again = [0; 64];
    c.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut again));
    assert_eq!(again, out);
    ok(&mut c);
}

#[test]
fn buffers_are_read_from_and_written_to() {
    let mut c = context();
    let texels: Vec<u8> = (0..16).collect();
    c.bind_buffer(GL_PIXEL_UNPACK_BUFFER, 1);
    c.buffer_data(GL_PIXEL_UNPACK_BUFFER, 16, Data::Bytes(&texels), GL_STATIC_DRAW);
    let (rgba, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    c.tex_image_2d(GL_TEXTURE_2D, 0, rgba as i32, 3, 1, 0, rgba, ty, Data::Offset(4));
    c.bind_buffer(GL_PIXEL_UNPACK_BUFFER, 0);
    c.bind_buffer(GL_PIXEL_PACK_BUFFER, 2);
    c.buffer_data(GL_PIXEL_PACK_BUFFER, 16, Data::Null, GL_STREAM_READ);
    c.get_tex_image(GL_TEXTURE_2D, 0, rgba, ty, DataOut::Offset(2));
    let mut out = [0; 16];
    c.get_buffer_sub_data(GL_PIXEL_PACK_BUFFER, 0, 16, DataOut::Bytes(&mut out));
    ok(&mut c);
    assert_eq!(out[2..14], texels[4..16]);
}

#[test]
fn no_pixels_are_read_and_written_anywhere() {
    let mut c = context();
    let (rgba, ty, beyond) = (GL_RGBA, GL_UNSIGNED_BYTE, 20);
    c.tex_image_2d(GL_TEXTURE_2D, 0, rgba as i32, 2, 2, 0, rgba, ty, Data::Null);
    for target in [GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_PACK_BUFFER] {
        c.bind_buffer(target, 1);
    }
    c.buffer_data(GL_PIXEL_PACK_BUFFER, 16, Data::Null, GL_STREAM_READ);
    let data = Data::Offset(beyond);
    c.read_pixels(0, 0, 0, 5, rgba, ty, DataOut::Offset(beyond));
    c.get_tex_image(GL_TEXTURE_2D, 1, rgba, ty, DataOut::Offset(beyond));
    c.draw_pixels(0, 5, rgba, ty, data);
    c.bitmap(0, 5, 0.0, 0.0, 0.0, 0.0, data);
    c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 2, 0, rgba, ty, data);
    c.tex_image_2d(GL_TEXTURE_2D, 1, rgba as i32, 0, 0, 0, rgba, ty, data);
    ok(&mut c);
    c.read_pixels(0, 0, 1, 1, rgba, ty, DataOut::Offset(beyond));
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 2, 1, rgba, ty, data);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}

/// Draws the window with one texture coordinate and gives the colour.
fn sampled(c: &mut Context, [s, t, r]: [f32; 3]) -> [u8; 4] {
    c.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE as i32);
    c.begin(GL_TRIANGLES);
    c.tex_coord_3f(s, t, r);
    for (x, y) in [(-1.0, -1.0), (3.0, -1.0), (-1.0, 3.0)] {
        c.vertex_2f(x, y);
    }
    c.end();
    let mut out = [0; 4];
    c.read_pixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut out));
    out
}

fn nearest(c: &mut Context, target: GLenum) {
    c.tex_parameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
    c.tex_parameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST as i32);
}

#[test]
fn the_fixed_function_samples_every_target_and_the_last_in_rank_wins() {
    let mut c = context();
    let (l, ty) = (GL_LUMINANCE, GL_UNSIGNED_BYTE);
    let texels: Vec<u8> = (0..8).map(|i| 10 * i).collect();
    let at = |from: usize| Data::Bytes(&texels[from..]);
    c.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    for target in [GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_3D] {
        nearest(&mut c, target);
    }
    c.tex_image_1d(GL_TEXTURE_1D, 0, l as i32, 2, 0, l, ty, at(0));
    c.tex_image_2d(GL_TEXTURE_2D, 0, l as i32, 2, 2, 0, l, ty, at(1));
    c.tex_image_2d(GL_TEXTURE_RECTANGLE, 0, l as i32, 2, 2, 0, l, ty, at(2));
    c.tex_image_3d(GL_TEXTURE_3D, 0, l as i32, 2, 2, 2, 0, l, ty, at(0));
    // Texel (1, 1, 1) of each, as far as there is one.
    for (target, coords, want) in [
        (GL_TEXTURE_1D, [0.75, 0.75, 0.75], 10),
        (GL_TEXTURE_2D, [0.75, 0.75, 0.75], 40),
        (GL_TEXTURE_RECTANGLE, [1.5, 1.5, 0.0], 50),
        (GL_TEXTURE_3D, [0.75, 0.75, 0.75], 70),
    ] {
        c.enable(target);
        assert_eq!(sampled(&mut c, coords), [want, want, want, 255], "{}", enum_name(target));
    }
    ok(&mut c);
}

#[test]
fn sampler_objects_swizzles_and_borders_show() {
    let mut c = context();
    let (rgba, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    nearest(&mut c, GL_TEXTURE_2D);
    let pixels = Data::Bytes(&[10, 20, 30, 40]);
    c.tex_image_2d(GL_TEXTURE_2D, 0, rgba as i32, 1, 1, 0, rgba, ty, pixels);
    c.enable(GL_TEXTURE_2D);
    let swizzle = [GL_BLUE, GL_ONE, GL_ZERO, GL_RED].map(|name| name as i32);
    c.tex_parameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, &swizzle);
    assert_eq!(sampled(&mut c, [0.5; 3]), [30, 255, 0, 10]);
    let identity = [GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA].map(|name| name as i32);
    c.tex_parameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, &identity);
    let mut sampler = [0];
    c.gen_samplers(1, &mut sampler);
    let [sampler] = sampler;
    for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        c.sampler_parameteri(sampler, pname, GL_NEAREST as i32);
    }
    c.sampler_parameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER as i32);
    c.sampler_parameterfv(sampler, GL_TEXTURE_BORDER_COLOR, &[1.0, 0.0, 1.0, 2.0]);
    c.bind_sampler(0, sampler);
    assert_eq!(sampled(&mut c, [1.5, 0.5, 0.0]), [255, 0, 255, 255]);
    c.delete_samplers(1, &[sampler]);
    assert_eq!(sampled(&mut c, [1.5, 0.5, 0.0]), [10, 20, 30, 40]);
    ok(&mut c);
}

#[test]
fn mirrored_once_a_row_ends_at_the_border() {
    let mut c = context();
    let (rgba, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    nearest(&mut c, GL_TEXTURE_1D);
    let pixels = Data::Bytes(&[10, 20, 30, 40, 50, 60, 70, 80]);
    c.tex_image_1d(GL_TEXTURE_1D, 0, rgba as i32, 2, 0, rgba, ty, pixels);
    c.enable(GL_TEXTURE_1D);
    c.tex_parameterfv(GL_TEXTURE_1D, GL_TEXTURE_BORDER_COLOR, &[1.0, 0.0, 1.0, 1.0]);
    let wrap = GL_MIRROR_CLAMP_TO_BORDER_EXT as i32;
    c.tex_parameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, wrap);
    let mut set = [0];
    c.get_tex_parameteriv(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, &mut set);
    assert_eq!(set, [wrap]);
    let [first, second, border] = [[10, 20, 30, 40], [50, 60, 70, 80], [255, 0, 255, 255]];
    for (s, expected) in [
        (0.2, first),
        (-0.2, first),
        (-0.7, second),
        (0.99, second),
        (-1.0, border),
        (1.01, border),
        (-9.0, border),
    ] {
        assert_eq!(sampled(&mut c, [s, 0.5, 0.0]), expected, "{s}");
    }
    ok(&mut c);
}

#[test]
fn copies_take_the_framebuffer_to_every_target() {
    let mut c = context();
    c.clear_color(1.0, 0.5, 0.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.copy_tex_image_1d(GL_TEXTURE_1D, 0, GL_RGBA8, 0, 0, 4, 0);
    c.copy_tex_image_2d(GL_TEXTURE_RECTANGLE, 0, GL_RGB16, 0, 0, 4, 4, 0);
    let (rgba, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    c.tex_image_3d(GL_TEXTURE_2D_ARRAY, 0, rgba as i32, 2, 2, 2, 0, rgba, ty, Data::Null);
    c.copy_tex_sub_image_3d(GL_TEXTURE_2D_ARRAY, 0, 0, 0, 1, 0, 0, 2, 2);
    c.tex_image_3d(GL_TEXTURE_CUBE_MAP_ARRAY, 0, rgba as i32, 1, 1, 12, 0, rgba, ty, Data::Null);
    c.copy_tex_sub_image_3d(GL_TEXTURE_CUBE_MAP_ARRAY, 0, 0, 0, 11, 0, 0, 1, 1);
    let mut out = [0; 64];
    for (target, texels, filled) in [
        (GL_TEXTURE_1D, 4, 0),
        (GL_TEXTURE_RECTANGLE, 16, 0),
        (GL_TEXTURE_2D_ARRAY, 8, 4),
        (GL_TEXTURE_CUBE_MAP_ARRAY, 12, 11),
    ] {
        c.get_tex_image(target, 0, rgba, ty, DataOut::Bytes(&mut out));
        for (at, texel) in out.chunks_exact(4).take(texels).enumerate() {
            let want = if at >= filled { [255, 128, 0, 255] } else { [0; 4] };
            assert_eq!(texel, want, "{} {at}", enum_name(target));
        }
    }
    ok(&mut c);
}

#[test]
fn glu_builds_the_levels_of_a_row() {
    let current = Context::new(ContextDesc { width: 4, height: 4, ..ContextDesc::default() })
        .expect("a device")
        .make_current();
    let row: Vec<u8> = (0..8).map(|i| 10 * i).collect();
    let (l, ty) = (GL_LUMINANCE, GL_UNSIGNED_BYTE);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    assert_eq!(glu::gluBuild1DMipmaps(GL_TEXTURE_1D, l, 8, l, ty, &row), 0);
    let mut out = [0_u8; 4];
    glGetTexImage(GL_TEXTURE_1D, 1, l, ty, &mut out);
    assert_eq!(out, [5, 25, 45, 65]);
    glGetTexImage(GL_TEXTURE_1D, 3, l, ty, &mut out[..1]);
    assert_eq!(out[0], 35);
    // Only level 2 of an image that is level 1.
    glBindTexture(GL_TEXTURE_1D, 1);
    assert_eq!(glu::gluBuild1DMipmapLevels(GL_TEXTURE_1D, l, 4, l, ty, 1, 2, 2, &row), 0);
    let mut widths = [0; 4];
    for (level, width) in widths.iter_mut().enumerate() {
        glGetTexLevelParameteriv(GL_TEXTURE_1D, level, GL_TEXTURE_WIDTH, width);
    }
    assert_eq!(widths, [0, 0, 2, 0]);
    assert_eq!(glu::gluBuild1DMipmapLevels(GL_TEXTURE_1D, l, 4, l, ty, 1, 0, 2, &row), 100_901);
    assert_eq!(glGetError(), GL_NO_ERROR);
    drop(current);
}

/// The way from a row or image to the next counts only where there is a next one: it may reach beyond any memory.
#[test]
fn one_row_may_lie_in_however_wide_an_image() {
    let mut c = context();
    for name in [GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT] {
        c.pixel_storei(name, i32::MAX);
    }
    for name in [GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT] {
        c.pixel_storei(name, i32::MAX);
    }
    let given: Vec<u8> = (0..32).collect();
    let (target, format, ty) = (GL_TEXTURE_3D, GL_RGBA, GL_FLOAT);
    c.tex_image_3d(target, 0, GL_RGBA32F as i32, 2, 1, 1, 0, format, ty, Data::Bytes(&given));
    ok(&mut c);
    let mut out = [0; 32];
    c.get_tex_image(target, 0, format, ty, DataOut::Bytes(&mut out));
    ok(&mut c);
    assert_eq!(out[..], given);
    c.tex_image_3d(target, 0, GL_RGBA32F as i32, 2, 1, 2, 0, format, ty, Data::Bytes(&given));
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}
