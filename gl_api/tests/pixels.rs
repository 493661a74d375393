//! Client pixels through texture storage and back, and the pixel store.

use gl_api::*;

fn context() -> Context {
    Context::new(ContextDesc { width: 4, height: 4, ..ContextDesc::default() }).expect("a device")
}

fn upload(
    context: &mut Context,
    internal: GLenum,
    width: i32,
    format: GLenum,
    ty: GLenum,
    bytes: &[u8],
) {
    let pixels = Data::Bytes(bytes);
    context.tex_image_2d(GL_TEXTURE_2D, 0, internal as i32, width, 1, 0, format, ty, pixels);
}

fn download(context: &mut Context, format: GLenum, ty: GLenum, bytes: usize) -> Vec<u8> {
    let mut out = vec![0; bytes];
    context.get_tex_image(GL_TEXTURE_2D, 0, format, ty, DataOut::Bytes(&mut out));
    let messages = context.messages();
    assert_eq!(context.get_error(), GL_NO_ERROR, "{messages:?}");
    out
}

/// Every byte through every type: 8 bits survive in all of them.
#[test]
fn bytes_survive_every_type() {
    let bytes: Vec<u8> = (0..=255).collect();
    for (ty, size) in [
        (GL_UNSIGNED_BYTE, 1),
        (GL_UNSIGNED_SHORT, 2),
        (GL_UNSIGNED_INT, 4),
        (GL_SHORT, 2),
        (GL_INT, 4),
        (GL_FLOAT, 4),
    ] {
        for swap in [0, 1] {
            let mut context = context();
            context.pixel_storei(GL_UNPACK_SWAP_BYTES, swap);
            context.pixel_storei(GL_PACK_SWAP_BYTES, swap);
            context.pixel_storei(GL_UNPACK_SWAP_BYTES, 0);
            upload(&mut context, GL_LUMINANCE8, 256, GL_LUMINANCE, GL_UNSIGNED_BYTE, &bytes);
            let wide = download(&mut context, GL_LUMINANCE, ty, 256 * size);
            context.pixel_storei(GL_UNPACK_SWAP_BYTES, swap);
            upload(&mut context, GL_LUMINANCE8, 256, GL_LUMINANCE, ty, &wide);
            let back = download(&mut context, GL_LUMINANCE, GL_UNSIGNED_BYTE, 256);
            // A signed type reaches 1/(2^b - 1) beyond its ends, within half a byte.
            assert_eq!(back, bytes, "{}, swap {swap}", enum_name(ty));
        }
    }
}

/// What is stored of R, G, B, A and what comes back (GL 2.1, tables 3.15 and 6.1).
#[test]
fn base_formats_keep_what_the_tables_say() {
    for (internal, expected) in [
        (GL_ALPHA8, [0, 0, 0, 40]),
        (GL_LUMINANCE8, [10, 0, 0, 255]),
        (GL_LUMINANCE8_ALPHA8, [10, 0, 0, 40]),
        (GL_INTENSITY8, [10, 0, 0, 255]),
        (GL_R8, [10, 0, 0, 255]),
        (GL_RG8, [10, 20, 0, 255]),
        (GL_RGB8, [10, 20, 30, 255]),
        (GL_RGBA8, [10, 20, 30, 40]),
        (GL_SRGB8, [10, 20, 30, 255]),
        (GL_SRGB8_ALPHA8, [10, 20, 30, 40]),
        (GL_SLUMINANCE8, [10, 0, 0, 255]),
        (GL_SLUMINANCE8_ALPHA8, [10, 0, 0, 40]),
        (3, [10, 20, 30, 255]),
    ] {
        let mut context = context();
        upload(&mut context, internal, 1, GL_BGRA, GL_UNSIGNED_BYTE, &[30, 20, 10, 40]);
        let back = download(&mut context, GL_RGBA, GL_UNSIGNED_BYTE, 4);
        assert_eq!(back, expected, "{}", enum_name(internal));
    }
}

#[test]
fn depth_keeps_its_bits() {
    for (internal, largest) in
        [(GL_DEPTH_COMPONENT16, 65_535.0), (GL_DEPTH_COMPONENT24, 16_777_215.0)]
    {
        for step in 0..=100_u32 {
            let depth = (f64::from(step) / 100.0 * largest).round_ties_even() / largest;
            let mut context = context();
            let given = (depth as f32).to_ne_bytes();
            upload(&mut context, internal, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &given);
            let back = download(&mut context, GL_DEPTH_COMPONENT, GL_FLOAT, 4);
            let back = f32::from_ne_bytes([back[0], back[1], back[2], back[3]]);
            assert!((f64::from(back) - depth).abs() < 0.6 / largest, "{depth} {back}");
        }
    }
}

/// Row length, skips and alignment pick the same rectangle out of a larger picture.
#[test]
fn the_pixel_store_picks_a_rectangle() {
    let mut context = context();
    // Rows of 5 pixels of 3 bytes, 16 bytes apart.
    let mut picture = vec![0; 16 * 4];
    for (y, row) in picture.chunks_exact_mut(16).enumerate() {
        for (x, pixel) in row.chunks_mut(3).enumerate().take(5) {
            pixel.copy_from_slice(&[x as u8, y as u8, 7]);
        }
    }
    context.pixel_storei(GL_UNPACK_ROW_LENGTH, 5);
    context.pixel_storei(GL_UNPACK_SKIP_PIXELS, 2);
    context.pixel_storei(GL_UNPACK_SKIP_ROWS, 1);
    let pixels = Data::Bytes(&picture);
    context.tex_image_2d(GL_TEXTURE_2D, 0, 3, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    context.pixel_storei(GL_PACK_ALIGNMENT, 1);
    let back = download(&mut context, GL_RGB, GL_UNSIGNED_BYTE, 12);
    assert_eq!(back, [2, 1, 7, 3, 1, 7, 2, 2, 7, 3, 2, 7]);
}

/// Pixels outside the framebuffer are left as they were.
#[test]
fn reading_outside_leaves_the_memory_alone() {
    let mut context = context();
    context.clear_color(1.0, 0.0, 0.0, 1.0);
    context.clear(GL_COLOR_BUFFER_BIT);
    let mut out = [9; 3 * 3 * 4];
    let pixels = DataOut::Bytes(&mut out);
    context.read_pixels(2, -1, 3, 3, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    let (inside, outside) = ([255, 0, 0, 255], [9; 4]);
    for (index, pixel) in out.chunks_exact(4).enumerate() {
        let expected = if index >= 3 && index % 3 < 2 { inside } else { outside };
        assert_eq!(pixel, expected, "{index}");
    }
}

#[test]
fn rendering_to_a_texture_reaches_its_samples() {
    let mut context = context();
    context.bind_texture(GL_TEXTURE_2D, 1);
    let filter = GL_NEAREST as i32;
    context.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    context.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    let (rgba, byte) = (GL_RGBA, GL_UNSIGNED_BYTE);
    context.tex_image_2d(GL_TEXTURE_2D, 0, rgba as i32, 4, 4, 0, rgba, byte, Data::Null);
    for color in [[1.0, 0.0, 1.0, 1.0], [0.0, 1.0, 0.0, 1.0]] {
        context.bind_framebuffer(GL_FRAMEBUFFER, 1);
        context.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 1, 0);
        let [r, g, b, a] = color;
        context.clear_color(r, g, b, a);
        context.clear(GL_COLOR_BUFFER_BIT);
        context.bind_framebuffer(GL_FRAMEBUFFER, 0);
        context.enable(GL_TEXTURE_2D);
        context.begin(GL_TRIANGLES);
        for (x, y) in [(-1.0, -1.0), (3.0, -1.0), (-1.0, 3.0)] {
            context.tex_coord_2f(x, y);
            context.vertex_2f(x, y);
        }
        context.end();
        let mut out = [0; 64];
        context.read_pixels(0, 0, 4, 4, rgba, byte, DataOut::Bytes(&mut out));
        let expected = color.map(|c: f32| (c * 255.0) as u8);
        assert!(out.chunks_exact(4).all(|pixel| pixel == expected), "{out:?}");
    }
    assert!(context.messages().is_empty());
}

#[test]
fn queries_convert() {
    let mut context = context();
    context.color_4f(1.0, 0.5, 0.0, -1.0);
    let mut ints = [0; 4];
    context.get_integerv(GL_CURRENT_COLOR, &mut ints);
    assert_eq!((ints[0], ints[3]), (i32::MAX, i32::MIN));
    context.load_identity();
    context.translatef(1.0, 2.0, 3.0);
    let mut matrix = [0.0; 16];
    context.get_floatv(GL_MODELVIEW_MATRIX, &mut matrix);
    assert_eq!(matrix[12..], [1.0, 2.0, 3.0, 1.0]);
    let mut on = [7];
    context.get_booleanv(GL_DEPTH_TEST, &mut on);
    assert_eq!(on, [0]);
    context.enable(GL_DEPTH_TEST);
    context.get_booleanv(GL_DEPTH_TEST, &mut on);
    assert_eq!(on, [1]);
    context.get_integerv(GL_DEPTH_BITS, &mut ints);
    assert_eq!(ints[0], 24);
    assert_eq!(context.get_error(), GL_NO_ERROR);
}

/// Luminance is R of texels, but R + G + B of the framebuffer's pixels (GL 2.1, sections 6.1.4 and
/// 4.3.2).
#[test]
fn texels_have_the_luminance_of_red() {
    let mut context = context();
    upload(&mut context, GL_RGBA8, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[10, 20, 30, 40]);
    assert_eq!(download(&mut context, GL_LUMINANCE, GL_UNSIGNED_BYTE, 1), [10]);
    assert_eq!(download(&mut context, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2), [10, 40]);
    context.clear_color(0.25, 0.5, 0.125, 1.0);
    context.clear(GL_COLOR_BUFFER_BIT);
    let mut out = [0.0_f32];
    let bytes = DataOut::Bytes(bytemuck::cast_slice_mut(&mut out));
    context.read_pixels(0, 0, 1, 1, GL_LUMINANCE, GL_FLOAT, bytes);
    assert!((out[0] - 0.875).abs() < 0.01, "{out:?}");
    // Sums of a buffer of fractions are fractions.
    context.clear_color(1.0, 1.0, 0.5, 1.0);
    context.clear(GL_COLOR_BUFFER_BIT);
    let bytes = DataOut::Bytes(bytemuck::cast_slice_mut(&mut out));
    context.read_pixels(0, 0, 1, 1, GL_LUMINANCE, GL_FLOAT, bytes);
    assert_eq!(out, [1.0]);
}

/// Depth textures take depths with stencils, but give none back.
#[test]
fn stencils_beside_depths_are_left_out_where_there_is_no_room() {
    let mut context = context();
    let (format, ty) = (GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
    let word = 0x8000_00FF_u32.to_ne_bytes();
    upload(&mut context, GL_DEPTH_COMPONENT24, 1, format, ty, &word);
    let depth = download(&mut context, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4);
    assert_eq!(u32::from_ne_bytes([depth[0], depth[1], depth[2], depth[3]]) >> 8, 0x80_0000);
    context.get_tex_image(GL_TEXTURE_2D, 0, format, ty, DataOut::Bytes(&mut [0; 4]));
    assert_eq!(context.get_error(), GL_INVALID_OPERATION);
}
