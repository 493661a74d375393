//! Shaders that draw to textures of integers, packed ones among them: what is written is kept as it
//! is, blending and the like stay out.

use super::shading::use_program;
use super::*;

const FRAGMENT: &str = "#version 130
out uvec4 color; void main() { color = uvec4(1023u, 512u, 7u, 2u); }";

#[test]
fn shaders_write_unsigned_integers() {
    for (internal, mask) in [
        (GL_RGB10_A2UI, [1023, 1023, 1023, 3]),
        (GL_RGBA8UI, [255; 4]),
        (GL_RGBA16UI, [65_535; 4]),
        (GL_RGBA32UI, [u32::MAX; 4]),
    ] {
        let mut c = context(2, 2);
        framebuffer(&mut c);
        let (target, format) = (GL_TEXTURE_2D, GL_RGBA_INTEGER);
        c.bind_texture(target, 1);
        c.tex_image_2d(target, 0, internal as i32, 2, 2, 0, format, GL_UNSIGNED_INT, Data::Null);
        c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, 1, 0);
        let status = c.check_framebuffer_status(GL_FRAMEBUFFER);
        assert_eq!(status, GL_FRAMEBUFFER_COMPLETE, "{}", enum_name(internal));
        use_program(&mut c, "", FRAGMENT);
        c.enable(GL_BLEND);
        c.blend_func(GL_ONE, GL_ONE);
        // Integers have no alpha to test.
        c.enable(GL_ALPHA_TEST);
        c.alpha_func(GL_NEVER, 0.0);
        for _ in 0..2 {
            rectangle(&mut c, [-1.0, -1.0, 1.0, 1.0], 0.0);
        }
        let mut words = [0_u32; 4];
        let out = DataOut::Bytes(bytes_of(&mut words));
        c.read_pixels(1, 1, 1, 1, format, GL_UNSIGNED_INT, out);
        fine(&mut c);
        let value = [1023_u32, 512, 7, 2];
        for (component, word) in words.into_iter().enumerate() {
            let most = mask[component];
            // GL leaves open what becomes of integers that do not fit: they are clamped or cut.
            let allowed = [value[component].min(most), value[component] & most];
            assert!(allowed.contains(&word), "{}: {words:?}", enum_name(internal));
        }
    }
}

/// A framebuffer of one texture of 2×2 texels of this format, each of which is `texel`.
fn of_integers(c: &mut Context, internal: GLenum, texel: [i32; 4]) {
    framebuffer(c);
    let mut name = [0];
    c.gen_textures(1, &mut name);
    let (target, format) = (GL_TEXTURE_2D, GL_RGBA_INTEGER);
    c.bind_texture(target, name[0]);
    let mut texels = [texel; 4];
    let data = Data::Bytes(bytes_of(texels.as_flattened_mut()));
    c.tex_image_2d(target, 0, internal as i32, 2, 2, 0, format, GL_INT, data);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, name[0], 0);
    fine(c);
}

/// The first pixel.
fn integers(c: &mut Context) -> [i32; 4] {
    let mut words = [0; 4];
    let out = DataOut::Bytes(bytes_of(&mut words));
    c.read_pixels(0, 0, 1, 1, GL_RGBA_INTEGER, GL_INT, out);
    fine(c);
    words
}

/// A call and what it draws.
type Draw = (&'static str, fn(&mut Context));

#[test]
fn without_a_fragment_shader_integers_stay_as_they_are() {
    let draws: [Draw; 5] = [
        ("glBegin", |c| rectangle(c, [-1.0, -1.0, 1.0, 1.0], 0.0)),
        ("glRectf", |c| c.rectf(-1.0, -1.0, 1.0, 1.0)),
        ("glDrawArrays", |c| {
            c.vertex_pointer(
                2,
                GL_FLOAT,
                0,
                Data::Bytes(bytemuck::bytes_of(&[-1.0_f32, -1.0, 3.0, -1.0, -1.0, 3.0])),
            );
            c.enable_client_state(GL_VERTEX_ARRAY);
            c.draw_arrays(GL_TRIANGLES, 0, 3);
        }),
        ("glDrawPixels", |c| c.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(&[9; 4]))),
        ("glBitmap", |c| c.bitmap(8, 1, 0.0, 0.0, 0.0, 0.0, Data::Bytes(&[0xFF, 0, 0, 0]))),
    ];
    for (name, draw) in draws {
        let mut c = context(2, 2);
        of_integers(&mut c, GL_RGBA16I, [1, 2, 3, 4]);
        c.raster_pos_2f(-1.0, -1.0);
        draw(&mut c);
        let messages = c.messages();
        assert_eq!(c.get_error(), GL_INVALID_OPERATION, "{name}");
        assert!(messages.iter().any(|m| m.to_string().contains("fragment shader")), "{messages:?}");
        assert_eq!(integers(&mut c), [1, 2, 3, 4], "{name}");
        use_program(
            &mut c,
            "",
            "#version 130
            out ivec4 color; void main() { color = ivec4(5, 6, 7, 8); }",
        );
        rectangle(&mut c, [-1.0, -1.0, 1.0, 1.0], 0.0);
        assert_eq!(integers(&mut c), [5, 6, 7, 8], "{name}");
    }
}

#[test]
fn integers_are_copied_to_integers_of_any_sign() {
    let mut c = context(2, 2);
    of_integers(&mut c, GL_RGBA16I, [1, -2, 300, 4]);
    let target = GL_TEXTURE_2D;
    c.copy_tex_image_2d(target, 0, GL_RGBA32UI, 0, 0, 2, 2, 0);
    let mut texels = [[0_u32; 4]; 4];
    let out = DataOut::Bytes(bytes_of(texels.as_flattened_mut()));
    c.get_tex_image(target, 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, out);
    fine(&mut c);
    // What is below 0 has no place there: it is 0.
    assert_eq!(texels, [[1, 0, 300, 4]; 4]);
    c.copy_tex_image_2d(target, 0, GL_RGBA8, 0, 0, 2, 2, 0);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}
