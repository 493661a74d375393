//! Textures of stencils alone (`ARB_texture_stencil8`).

use super::{context, fine, shading};
use gl_api::*;

const SIZE: i32 = 4;
const FRAGMENT: &str = "#version 130
    uniform usampler2D image;
    void main() { gl_FragColor = vec4(vec3(texture(image, gl_TexCoord[0].st).rgb) / 255.0, 1.0); }";

fn texture(c: &mut Context, name: GLuint) {
    c.bind_texture(GL_TEXTURE_2D, name);
    for filter in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        c.tex_parameteri(GL_TEXTURE_2D, filter, GL_NEAREST as GLint);
    }
}

fn image(c: &mut Context, texels: &[u8]) {
    c.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    let internal = GL_STENCIL_INDEX8 as GLint;
    let data = Data::Bytes(texels);
    let (format, ty) = (GL_STENCIL_INDEX, GL_UNSIGNED_BYTE);
    c.tex_image_2d(GL_TEXTURE_2D, 0, internal, SIZE, SIZE, 0, format, ty, data);
    fine(c);
}

/// What a shader reads of the bound texture, red of each pixel.
fn sampled(c: &mut Context) -> Vec<u8> {
    let program = shading::use_program(c, "", FRAGMENT);
    c.begin(GL_QUADS);
    for (s, t) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
        c.tex_coord_2f(s, t);
        c.vertex_2f(2.0 * s - 1.0, 2.0 * t - 1.0);
    }
    c.end();
    c.use_program(0);
    c.delete_program(program);
    let mut pixels = vec![0; (SIZE * SIZE * 4) as usize];
    c.read_pixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
    fine(c);
    assert!(pixels.chunks(4).all(|pixel| pixel[1..] == [0, 0, 255]));
    pixels.chunks(4).map(|pixel| pixel[0]).collect()
}

/// The stencils of the bound texture.
fn read(c: &mut Context) -> Vec<u8> {
    let mut texels = vec![9; (SIZE * SIZE) as usize];
    c.pixel_storei(GL_PACK_ALIGNMENT, 1);
    let (format, ty) = (GL_STENCIL_INDEX, GL_UNSIGNED_BYTE);
    c.get_tex_image(GL_TEXTURE_2D, 0, format, ty, DataOut::Bytes(&mut texels));
    fine(c);
    texels
}

fn texels() -> Vec<u8> {
    (0..16).map(|i| i * 17).collect()
}

#[test]
fn stencils_are_given_replaced_read_and_sampled() {
    let mut c = context(SIZE as u32, SIZE as u32);
    texture(&mut c, 1);
    let mut expected = texels();
    image(&mut c, &expected);
    assert_eq!(read(&mut c), expected);
    assert_eq!(sampled(&mut c), expected);
    let part = Data::Bytes(&[1, 2, 3, 4]);
    let (format, ty) = (GL_STENCIL_INDEX, GL_UNSIGNED_BYTE);
    c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 1, 2, 2, 2, format, ty, part);
    for (at, value) in [(9, 1), (10, 2), (13, 3), (14, 4)] {
        expected[at] = value;
    }
    assert_eq!(read(&mut c), expected);
    assert_eq!(sampled(&mut c), expected);
    // Wider numbers keep their lowest bits; the state of stencil transfer counts where texels are given.
    c.pixel_transferi(GL_INDEX_OFFSET, 2);
    let wide: Vec<u8> = [300_u32, 5].iter().flat_map(|v| v.to_le_bytes()).collect();
    c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 2, 1, format, GL_UNSIGNED_INT, Data::Bytes(&wide));
    c.pixel_transferi(GL_INDEX_OFFSET, 0);
    assert_eq!(read(&mut c)[..3], [46, 7, 34]);
    c.clear_tex_image(1, 0, format, ty, Data::Bytes(&[77]));
    assert_eq!(read(&mut c), [77; 16]);
    let mut box_of = [0; 4];
    c.get_texture_sub_image(1, 0, 1, 1, 0, 2, 2, 1, format, ty, 4, DataOut::Bytes(&mut box_of));
    assert_eq!(box_of, [77; 4]);
    fine(&mut c);
}

/// A texture is drawn to as a stencil buffer, never as a depth buffer; its levels tell what they have.
#[test]
fn stencils_are_drawn_to_copied_and_asked_for() {
    let mut c = context(SIZE as u32, SIZE as u32);
    texture(&mut c, 1);
    image(&mut c, &texels());
    let property = |c: &mut Context, name: GLenum| {
        let mut value = [-1];
        c.get_tex_level_parameteriv(GL_TEXTURE_2D, 0, name, &mut value);
        value[0]
    };
    assert_eq!(property(&mut c, GL_TEXTURE_STENCIL_SIZE), 8);
    assert_eq!(property(&mut c, GL_TEXTURE_DEPTH_SIZE), 0);
    assert_eq!(property(&mut c, GL_TEXTURE_DEPTH_TYPE), 0);
    assert_eq!(property(&mut c, GL_TEXTURE_RED_SIZE), 0);
    assert_eq!(property(&mut c, GL_TEXTURE_INTERNAL_FORMAT), GL_STENCIL_INDEX8 as GLint);
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
    c.bind_renderbuffer(GL_RENDERBUFFER, 1);
    c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, SIZE, SIZE);
    let (fb, color) = (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0);
    c.framebuffer_renderbuffer(fb, color, GL_RENDERBUFFER, 1);
    c.framebuffer_texture_2d(fb, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 1, 0);
    assert_eq!(c.check_framebuffer_status(fb), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
    c.framebuffer_texture_2d(fb, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
    c.framebuffer_texture_2d(fb, GL_STENCIL_ATTACHMENT, GL_TEXTURE_2D, 1, 0);
    assert_eq!(c.check_framebuffer_status(fb), GL_FRAMEBUFFER_COMPLETE);
    c.enable(GL_STENCIL_TEST);
    c.stencil_func(GL_ALWAYS, 0, !0);
    c.stencil_op(GL_KEEP, GL_KEEP, GL_INCR);
    c.rectf(-1.0, -1.0, 1.0, 0.0);
    c.disable(GL_STENCIL_TEST);
    let mut expected = texels();
    expected[..8].iter_mut().for_each(|value| *value += 1);
    assert_eq!(read(&mut c), expected);
    // From the stencil buffer to another texture.
    texture(&mut c, 2);
    c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_STENCIL_INDEX8, 0, 0, SIZE, SIZE, 0);
    assert_eq!(read(&mut c), expected);
    c.clear_stencil(200);
    c.clear(GL_STENCIL_BUFFER_BIT);
    c.copy_tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 3, 0, 0, SIZE, 1);
    expected[12..].fill(200);
    assert_eq!(read(&mut c), expected);
    c.bind_framebuffer(fb, 0);
    assert_eq!(sampled(&mut c), expected);
}

/// Those of textures with depths, too, are read, but not given by themselves.
#[test]
fn formats_go_together() {
    let mut c = context(SIZE as u32, SIZE as u32);
    let refused = |c: &mut Context, call: &dyn Fn(&mut Context)| {
        call(c);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION);
        let said = c.messages().pop().expect("a message").text;
        assert!(said.contains("GL_STENCIL_INDEX"), "{said}");
    };
    texture(&mut c, 1);
    let give = |c: &mut Context, internal: GLenum, format: GLenum, ty: GLenum| {
        let (target, data) = (GL_TEXTURE_2D, Data::Null);
        c.tex_image_2d(target, 0, internal as GLint, SIZE, SIZE, 0, format, ty, data);
    };
    for (internal, format, ty) in [
        (GL_STENCIL_INDEX8, GL_DEPTH_COMPONENT, GL_FLOAT),
        (GL_STENCIL_INDEX8, GL_RED_INTEGER, GL_UNSIGNED_BYTE),
        (GL_DEPTH24_STENCIL8, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE),
        (GL_R8UI, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE),
    ] {
        refused(&mut c, &|c| give(c, internal, format, ty));
    }
    give(&mut c, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
    c.clear_tex_image(1, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, Data::Bytes(&[5, 0, 0, 0x80]));
    assert_eq!(read(&mut c), [5; 16]);
    image(&mut c, &texels());
    refused(&mut c, &|c| {
        let mut out = [0; 64];
        c.get_tex_image(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, DataOut::Bytes(&mut out));
    });
}

/// Faces of a cube map and layers of its array are sampled as stencils, too, with their border colour.
#[test]
fn cube_maps_have_stencils() {
    for (target, sampler, direction) in [
        (GL_TEXTURE_CUBE_MAP, "usamplerCube", "vec3(1.0, 0.0, 0.0)"),
        (GL_TEXTURE_CUBE_MAP_ARRAY, "usamplerCubeArray", "vec4(1.0, 0.0, 0.0, 1.0)"),
    ] {
        for internal in [GL_STENCIL_INDEX8, GL_DEPTH24_STENCIL8, GL_DEPTH32F_STENCIL8] {
            let mut c = context(SIZE as u32, SIZE as u32);
            c.bind_texture(target, 1);
            c.tex_parameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
            c.tex_parameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST as GLint);
            c.tex_parameteri(target, GL_DEPTH_STENCIL_TEXTURE_MODE, GL_STENCIL_INDEX as GLint);
            let layers = if target == GL_TEXTURE_CUBE_MAP { 6 } else { 12 };
            match target {
                GL_TEXTURE_CUBE_MAP => c.tex_storage_2d(target, 1, internal, 4, 4),
                _ => c.tex_storage_3d(target, 1, internal, 4, 4, layers),
            }
            c.bind_framebuffer(GL_FRAMEBUFFER, 1);
            c.draw_buffer(GL_NONE);
            c.read_buffer(GL_NONE);
            for layer in 0..layers {
                let (fb, at) = (GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT);
                match target {
                    GL_TEXTURE_CUBE_MAP if layer % 2 == 0 => {
                        let face = GL_TEXTURE_CUBE_MAP_POSITIVE_X + layer as GLenum;
                        c.framebuffer_texture_2d(fb, at, face, 1, 0);
                    }
                    _ => c.framebuffer_texture_layer(fb, at, 1, 0, layer),
                }
                c.clear_stencil(10 * layer + 3);
                c.clear(GL_STENCIL_BUFFER_BIT);
            }
            c.bind_framebuffer(GL_FRAMEBUFFER, 0);
            fine(&mut c);
            let text = format!(
                "#version 130\n#extension GL_ARB_texture_cube_map_array : enable\nuniform {sampler} image;
                 void main() {{ gl_FragColor = vec4(texture(image, {direction}).rrra) / 255.0; }}"
            );
            shading::use_program(&mut c, "", &text);
            c.rectf(-1.0, -1.0, 1.0, 1.0);
            let first = if target == GL_TEXTURE_CUBE_MAP { 3 } else { 63 };
            assert_eq!(super::pixel(&mut c, 1, 1), [first, first, first, 1], "{internal:#x}");
        }
    }
}
