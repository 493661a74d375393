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
