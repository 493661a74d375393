//! EGL images between contexts that share nothing else (EGL 1.5, section 3.9; `OES_EGL_image`): the oracle is a plain copy
//! of the bytes that were written.

use super::shading::use_program;
use super::views::{framebuffer, name};
use super::{context, fine, pixel};
use gl_api::host::{EglImage, EglImageError, EglImageSource, share};
use gl_api::*;

const SIDE: GLsizei = 8;
const D2: GLenum = GL_TEXTURE_2D;
const BUFFER: GLenum = GL_RENDERBUFFER;

fn es(width: u32, height: u32) -> Context {
    let desc = ContextDesc { api: Api::Es2, width, height, ..ContextDesc::default() };
    Context::new(desc).expect("a device")
}

/// A texture of one level of RGBA8, bound, of these bytes.
fn texture(c: &mut Context, bytes: &[u8]) -> GLuint {
    let name = name(c);
    c.bind_texture(D2, name);
    specify(c, bytes);
    c.tex_parameteri(D2, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    c.tex_parameteri(D2, GL_TEXTURE_MAG_FILTER, GL_NEAREST as GLint);
    fine(c);
    name
}

fn specify(c: &mut Context, bytes: &[u8]) {
    let (format, data) = (GL_RGBA, Data::Bytes(bytes));
    c.tex_image_2d(D2, 0, GL_RGBA as GLint, SIDE, SIDE, 0, format, GL_UNSIGNED_BYTE, data);
}

fn write(c: &mut Context, bytes: &[u8]) {
    let data = Data::Bytes(bytes);
    c.tex_sub_image_2d(D2, 0, 0, 0, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, data);
    fine(c);
}

/// The bytes of what is attached.
fn attached(c: &mut Context) -> Vec<u8> {
    let mut bytes = vec![0; (4 * SIDE * SIDE) as usize];
    let out = DataOut::Bytes(&mut bytes);
    c.read_pixels(0, 0, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, out);
    fine(c);
    bytes
}

fn attach(c: &mut Context, texture: GLuint) {
    framebuffer(c);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, D2, texture, 0);
    assert_eq!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
}

fn noise(seed: u32) -> Vec<u8> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    };
    (0..4 * SIDE * SIDE).map(|_| next()).collect()
}

fn of_2d(texture: GLuint) -> EglImageSource {
    EglImageSource::Texture2D { texture, level: 0 }
}

fn image(c: &Context, source: EglImageSource) -> EglImage {
    EglImage::new(&share(c), source).expect("a source")
}

/// A texture whose storage is an image, bound, to be sampled and attached.
fn target(c: &mut Context, image: &EglImage) -> GLuint {
    let name = texture(c, &[0; (4 * SIDE * SIDE) as usize]);
    c.egl_image_target_texture_2d(D2, image.handle());
    fine(c);
    name
}

/// Draws the bound texture over the window, texel by pixel, and reads that.
fn drawn(c: &mut Context) -> Vec<u8> {
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    c.enable(D2);
    let quad = [-1.0_f32, -1.0, 1.0, -1.0, -1.0, 1.0, 1.0, 1.0];
    let coordinates = [0.0_f32, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0];
    let bytes = |values: &[f32]| values.iter().flat_map(|v| v.to_ne_bytes()).collect::<Vec<u8>>();
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.enable_client_state(GL_TEXTURE_COORD_ARRAY);
    let mut names = [0; 2];
    c.gen_buffers(2, &mut names);
    for (buffer, values) in names.into_iter().zip([quad, coordinates]) {
        c.bind_buffer(GL_ARRAY_BUFFER, buffer);
        c.buffer_data(GL_ARRAY_BUFFER, 32, Data::Bytes(&bytes(&values)), GL_STATIC_DRAW);
        match buffer == names[0] {
            true => c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0)),
            false => c.tex_coord_pointer(2, GL_FLOAT, 0, Data::Offset(0)),
        }
    }
    c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
    fine(c);
    attached(c)
}

#[test]
fn what_one_context_draws_another_samples() {
    let (mut a, mut b) = (es(4, 4), context(SIDE as u32, SIDE as u32));
    let first = noise(1);
    let source = texture(&mut a, &first);
    let image = image(&a, of_2d(source));
    target(&mut b, &image);
    assert_eq!(drawn(&mut b), first);
    // Draws that nothing but the other context changes between them.
    attach(&mut a, source);
    for step in 0..3_u8 {
        let red = f32::from(step) / 255.0;
        a.clear_color(red, 1.0, 0.0, 1.0);
        a.clear(GL_COLOR_BUFFER_BIT);
        a.flush();
        b.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
        assert_eq!(attached(&mut b), [step, 255, 0, 255].repeat((SIDE * SIDE) as usize));
        write(&mut a, &noise(7 + u32::from(step)));
        b.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
        assert_eq!(attached(&mut b), noise(7 + u32::from(step)));
    }
}

#[test]
fn what_is_written_through_a_target_is_the_sources() {
    let (mut a, mut b) = (context(4, 4), es(4, 4));
    let source = texture(&mut a, &noise(1));
    let image = image(&a, of_2d(source));
    let target = target(&mut b, &image);
    attach(&mut a, source);
    attach(&mut b, target);
    write(&mut b, &noise(2));
    assert_eq!(attached(&mut a), noise(2));
    b.clear_color(1.0, 0.0, 1.0, 0.0);
    b.enable(GL_SCISSOR_TEST);
    b.scissor(0, 0, 3, 3);
    b.clear(GL_COLOR_BUFFER_BIT);
    b.finish();
    let mut expected = noise(2);
    for (at, texel) in expected.chunks_exact_mut(4).enumerate() {
        if at % SIDE as usize <= 2 && at / SIDE as usize <= 2 {
            texel.copy_from_slice(&[255, 0, 255, 0]);
        }
    }
    assert_eq!(attached(&mut a), expected);
    assert_eq!(attached(&mut b), expected);
    // A third context, a renderbuffer.
    let mut c = es(4, 4);
    let mut renderbuffer = [0];
    c.gen_renderbuffers(1, &mut renderbuffer);
    c.bind_renderbuffer(BUFFER, renderbuffer[0]);
    c.egl_image_target_renderbuffer_storage(BUFFER, image.handle());
    framebuffer(&mut c);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, BUFFER, renderbuffer[0]);
    assert_eq!(attached(&mut c), expected);
    c.clear_color(0.0, 0.0, 0.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.finish();
    for other in [&mut a, &mut b] {
        assert_eq!(attached(other), [0, 0, 0, 255].repeat((SIDE * SIDE) as usize));
    }
}

/// Levels, faces, slices and renderbuffers are sources; each shows itself alone.
#[test]
fn every_source_shows_itself() {
    let (mut a, mut b) = (context(4, 4), es(4, 4));
    let texel = |n: usize| [n as u8, 255 - n as u8, 7, 9];
    let cube = name(&mut a);
    a.bind_texture(GL_TEXTURE_CUBE_MAP, cube);
    a.tex_storage_2d(GL_TEXTURE_CUBE_MAP, 2, GL_RGBA8, 2, 2);
    let volume = name(&mut a);
    a.bind_texture(GL_TEXTURE_3D, volume);
    a.tex_storage_3d(GL_TEXTURE_3D, 2, GL_RGBA8, 4, 4, 4);
    let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    let mut sources = Vec::new();
    for n in 0..12 {
        let (face, level) = (n % 6, n / 6);
        let bytes = texel(n).repeat(4 >> (2 * level));
        let (face_target, side) = (GL_TEXTURE_CUBE_MAP_POSITIVE_X + face as GLenum, 2 >> level);
        let data = Data::Bytes(&bytes);
        a.tex_sub_image_2d(face_target, level as GLint, 0, 0, side, side, format, ty, data);
        let (face, level) = (face as u8, level as u32);
        sources.push((EglImageSource::CubeMapFace { texture: cube, face, level }, n));
    }
    for n in 12..18 {
        let (level, slice) = if n < 16 { (0, n - 12) } else { (1, n - 16) };
        let side = 4 >> level;
        let bytes = texel(n).repeat((side * side) as usize);
        let (z, data) = (slice as GLint, Data::Bytes(&bytes));
        a.tex_sub_image_3d(GL_TEXTURE_3D, level, 0, 0, z, side, side, 1, format, ty, data);
        let (level, slice) = (level as u32, slice as u32);
        sources.push((EglImageSource::Texture3D { texture: volume, level, slice }, n));
    }
    let mut renderbuffer = [0];
    a.gen_renderbuffers(1, &mut renderbuffer);
    a.bind_renderbuffer(BUFFER, renderbuffer[0]);
    a.renderbuffer_storage(BUFFER, GL_RGBA8, 4, 4);
    framebuffer(&mut a);
    a.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, BUFFER, renderbuffer[0]);
    let [red, green, blue, alpha] = texel(18).map(|value| f32::from(value) / 255.0);
    a.clear_color(red, green, blue, alpha);
    a.clear(GL_COLOR_BUFFER_BIT);
    sources.push((EglImageSource::Renderbuffer(renderbuffer[0]), 18));
    fine(&mut a);
    a.finish();
    let images: Vec<_> = sources.iter().map(|(source, n)| (image(&a, *source), *n)).collect();
    let mut targets = Vec::new();
    for (image, n) in &images {
        let target = target(&mut b, image);
        attach(&mut b, target);
        assert_eq!(pixel(&mut b, 0, 0), texel(*n), "{:?}", sources[*n].0);
        targets.push((target, *n));
    }
    // What is written to one is in no other.
    for &(target, n) in &targets {
        b.bind_texture(D2, target);
        let data = texel(100 + n);
        b.tex_sub_image_2d(D2, 0, 0, 0, 1, 1, format, ty, Data::Bytes(&data));
    }
    fine(&mut b);
    let mut found = [0; 4 * 64];
    a.get_tex_image(GL_TEXTURE_3D, 0, format, ty, DataOut::Bytes(&mut found));
    for slice in 0..4 {
        assert_eq!(found[64 * slice..64 * slice + 4], texel(112 + slice));
        assert_eq!(found[64 * slice + 4..64 * slice + 8], texel(12 + slice));
    }
    assert_eq!(pixel(&mut a, 0, 0), texel(118));
    assert_eq!(pixel(&mut a, 1, 0), texel(18));
    for face in 0..6 {
        let face_target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face as GLenum;
        let mut found = [0; 4];
        a.get_tex_image(face_target, 1, format, ty, DataOut::Bytes(&mut found));
        assert_eq!(found, texel(106 + face));
    }
    fine(&mut a);
}

/// Depths and stencils, floats and integers, and blocks go from one context to another.
#[test]
fn images_have_every_format() {
    let (mut a, mut b) = (context(4, 4), context(4, 4));
    for (internal, format, ty, bytes) in [
        (GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1),
        (GL_RGB565, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2),
        (GL_RGBA32F, GL_RGBA, GL_FLOAT, 16),
        (GL_RG16I, GL_RG_INTEGER, GL_SHORT, 4),
        (GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 4),
        (GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 2),
        (GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, 4),
    ] {
        let source = name(&mut a);
        a.bind_texture(D2, source);
        // Floats that are numbers.
        let given: Vec<u8> = noise(internal)[..16 * bytes].iter().map(|byte| byte & 0x3F).collect();
        a.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
        a.tex_image_2d(D2, 0, internal as GLint, 4, 4, 0, format, ty, Data::Bytes(&given));
        fine(&mut a);
        let image = image(&a, of_2d(source));
        target(&mut b, &image);
        let mut found = vec![0; 16 * bytes];
        b.pixel_storei(GL_PACK_ALIGNMENT, 1);
        b.get_tex_image(D2, 0, format, ty, DataOut::Bytes(&mut found));
        fine(&mut b);
        assert_eq!(found, given, "{internal:#x}");
        let mut answer = [0];
        b.get_tex_level_parameteriv(D2, 0, GL_TEXTURE_INTERNAL_FORMAT, &mut answer);
        assert_eq!(answer[0] as GLenum, internal);
    }
    let source = name(&mut a);
    a.bind_texture(D2, source);
    let (dxt, blocks) = (GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, &noise(3)[..64]);
    a.compressed_tex_image_2d(D2, 0, dxt, 8, 8, 0, 64, Data::Bytes(blocks));
    let image = image(&a, of_2d(source));
    target(&mut b, &image);
    let mut found = [0; 64];
    b.get_compressed_tex_image(D2, 0, DataOut::Bytes(&mut found));
    fine(&mut b);
    assert_eq!(&found[..], blocks);
}

/// What specifies a sibling anew gives it storage of its own; attachments follow, the others keep what they had.
#[test]
fn a_sibling_that_is_specified_anew_is_orphaned() {
    type Specify = fn(&mut Context);
    const CALLS: &[(&str, Specify, bool)] = &[
        ("glTexImage2D", |c| specify(c, &noise(2)), true),
        ("glCopyTexImage2D", |c| c.copy_tex_image_2d(D2, 0, GL_RGBA, 0, 0, SIDE, SIDE, 0), true),
        ("glTexStorage2D", |c| c.tex_storage_2d(D2, 1, GL_RGBA8, SIDE, SIDE), true),
        ("glGenerateMipmap", |c| c.generate_mipmap(D2), true),
        ("glTexSubImage2D", |c| write(c, &noise(3)), false),
        ("glTexParameteri", |c| c.tex_parameteri(D2, GL_TEXTURE_WRAP_S, GL_REPEAT as GLint), false),
    ];
    for (call, specify_anew, orphans) in CALLS {
        for of_source in [true, false] {
            let (mut a, mut b) = (context(4, 4), es(4, 4));
            let source = texture(&mut a, &noise(1));
            attach(&mut a, source);
            let image = image(&a, of_2d(source));
            let target = target(&mut b, &image);
            attach(&mut b, target);
            let (of, other) = if of_source { (&mut a, &mut b) } else { (&mut b, &mut a) };
            specify_anew(of);
            fine(of);
            of.clear_color(0.0, 1.0, 0.0, 1.0);
            of.clear(GL_COLOR_BUFFER_BIT);
            of.finish();
            let green = [0, 255, 0, 255].repeat((SIDE * SIDE) as usize);
            assert_eq!(attached(of), green, "{call}");
            let expected = if *orphans { noise(1) } else { green };
            assert_eq!(attached(other), expected, "{call}, of the source: {of_source}");
            // The image shows what it showed.
            let mut c = es(4, 4);
            let third = self::target(&mut c, &image);
            attach(&mut c, third);
            assert_eq!(attached(&mut c), expected, "{call}, a third context");
        }
    }
}

/// A level that no image shows can be specified; mipmaps that are there already are filled.
#[test]
fn other_levels_of_a_source_are_its_own() {
    let (mut a, mut b) = (context(4, 4), es(4, 4));
    let source = texture(&mut a, &noise(1));
    a.generate_mipmap(D2);
    let image = image(&a, of_2d(source));
    let target = target(&mut b, &image);
    attach(&mut b, target);
    let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    let half = [1, 2, 3, 4].repeat(16);
    a.tex_image_2d(D2, 1, GL_RGBA as GLint, 4, 4, 0, format, ty, Data::Bytes(&half));
    write(&mut a, &noise(2));
    assert_eq!(attached(&mut b), noise(2));
    a.generate_mipmap(D2);
    write(&mut a, &noise(3));
    assert_eq!(attached(&mut b), noise(3));
    // With a chain that has a gap the levels are specified.
    a.tex_image_2d(D2, 1, GL_RGBA as GLint, 0, 0, 0, format, ty, Data::Null);
    a.generate_mipmap(D2);
    write(&mut a, &noise(4));
    assert_eq!(attached(&mut b), noise(3));
}

#[test]
fn renderbuffers_are_orphaned_too() {
    let (mut a, mut b) = (es(4, 4), es(4, 4));
    let mut names = [0];
    a.gen_renderbuffers(1, &mut names);
    a.bind_renderbuffer(BUFFER, names[0]);
    a.renderbuffer_storage(BUFFER, GL_RGBA8, SIDE, SIDE);
    framebuffer(&mut a);
    a.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, BUFFER, names[0]);
    let image = image(&a, EglImageSource::Renderbuffer(names[0]));
    let target = target(&mut b, &image);
    attach(&mut b, target);
    write(&mut b, &noise(1));
    assert_eq!(attached(&mut a), noise(1));
    a.renderbuffer_storage(BUFFER, GL_RGB565, SIDE, SIDE);
    a.clear_color(1.0, 1.0, 1.0, 1.0);
    a.clear(GL_COLOR_BUFFER_BIT);
    assert_eq!(pixel(&mut a, 0, 0), [255; 4]);
    assert_eq!(attached(&mut b), noise(1));
}

/// An image outlives its source, and the targets their image and its handle.
#[test]
fn texels_live_as_long_as_somebody_has_them() {
    let mut b = es(4, 4);
    let target = {
        let mut a = es(4, 4);
        let source = texture(&mut a, &noise(1));
        let image = image(&a, of_2d(source));
        a.delete_textures(1, &[source]);
        drop(a);
        let target = target(&mut b, &image);
        let handle = image.handle();
        drop(image);
        let name = name(&mut b);
        b.bind_texture(D2, name);
        b.egl_image_target_texture_2d(D2, handle);
        assert_eq!(b.get_error(), GL_INVALID_VALUE, "the handle is gone");
        target
    };
    attach(&mut b, target);
    assert_eq!(attached(&mut b), noise(1));
}

fn refused(c: &Context, source: EglImageSource) -> EglImageError {
    EglImage::new(&share(c), source).expect_err("it cannot be a source")
}

/// The errors of `EGL_KHR_image_base` and `EGL_KHR_gl_image`.
#[test]
fn what_cannot_be_a_source() {
    use EglImageError::{BadAccess, BadMatch, BadParameter};
    let mut c = context(4, 4);
    let plain = texture(&mut c, &noise(1));
    let cube = name(&mut c);
    c.bind_texture(GL_TEXTURE_CUBE_MAP, cube);
    let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    let face = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
    c.tex_image_2d(face, 0, GL_RGBA as GLint, 4, 4, 0, format, ty, Data::Null);
    let volume = name(&mut c);
    c.bind_texture(GL_TEXTURE_3D, volume);
    c.tex_storage_3d(GL_TEXTURE_3D, 2, GL_RGBA8, 4, 4, 4);
    let gap = name(&mut c);
    c.bind_texture(D2, gap);
    c.tex_image_2d(D2, 0, GL_RGBA as GLint, 4, 4, 0, format, ty, Data::Null);
    c.tex_image_2d(D2, 2, GL_RGBA as GLint, 1, 1, 0, format, ty, Data::Null);
    let border = name(&mut c);
    c.bind_texture(D2, border);
    c.tex_image_2d(D2, 0, GL_RGBA as GLint, 6, 6, 1, format, ty, Data::Null);
    let mut renderbuffers = [0; 3];
    c.gen_renderbuffers(3, &mut renderbuffers);
    let [fine_one, samples, empty] = renderbuffers;
    for name in renderbuffers {
        c.bind_renderbuffer(BUFFER, name);
        match name {
            _ if name == fine_one => c.renderbuffer_storage(BUFFER, GL_RGBA8, 4, 4),
            _ if name == samples => c.renderbuffer_storage_multisample(BUFFER, 4, GL_RGBA8, 4, 4),
            _ => {}
        }
    }
    fine(&mut c);
    let d2 = |texture, level| EglImageSource::Texture2D { texture, level };
    let face = |texture, face| EglImageSource::CubeMapFace { texture, face, level: 0 };
    let d3 = |texture, level, slice| EglImageSource::Texture3D { texture, level, slice };
    let parameter = |source, words: &str| match refused(&c, source) {
        BadParameter(rule) => assert!(rule.contains(words), "{rule}"),
        other => panic!("{source:?}: {other}"),
    };
    parameter(d2(99, 0), "buffer = 99 is no texture");
    parameter(d2(cube, 0), "is a GL_TEXTURE_CUBE_MAP");
    parameter(face(plain, 0), "target wants a GL_TEXTURE_CUBE_MAP");
    parameter(face(cube, 0), "incomplete");
    parameter(d2(gap, 0), "incomplete");
    parameter(d2(gap, 2), "incomplete");
    parameter(d2(border, 0), "border");
    parameter(d3(volume, 0, 4), "EGL_GL_TEXTURE_ZOFFSET = 4 must be below 4");
    parameter(d3(volume, 1, 2), "must be below 2");
    parameter(EglImageSource::Renderbuffer(99), "no renderbuffer");
    parameter(EglImageSource::Renderbuffer(samples), "4 samples");
    parameter(EglImageSource::Renderbuffer(empty), "no storage");
    assert!(matches!(refused(&c, d3(volume, 2, 0)), BadMatch(_)));
    // Siblings, as long as they are.
    for source in [d2(plain, 0), EglImageSource::Renderbuffer(fine_one), d3(volume, 1, 1)] {
        let first = image(&c, source);
        assert!(matches!(refused(&c, source), BadAccess(_)), "{source:?}");
        drop(first);
        let second = image(&c, source);
        let mut b = context(4, 4);
        let shown = target(&mut b, &second);
        assert!(matches!(refused(&b, d2(shown, 0)), BadAccess(_)), "{source:?}");
        drop(second);
        assert!(matches!(refused(&c, source), BadAccess(_)), "{source:?}: a target is left");
        b.delete_textures(1, &[shown]);
        image(&c, source);
    }
    let first = image(&c, d3(volume, 0, 0));
    // Another slice is no sibling.
    let second = image(&c, d3(volume, 0, 1));
    drop((first, second));
}

/// Contexts that draw to an image at the same time, on threads of their own: each pixel is what one of them drew.
#[test]
fn two_threads_draw_to_one_image() {
    let mut a = es(4, 4);
    let source = texture(&mut a, &noise(1));
    let image = image(&a, of_2d(source));
    std::thread::scope(|scope| {
        for red in [0.0, 1.0] {
            let image = &image;
            scope.spawn(move || {
                let mut c = es(4, 4);
                let target = target(&mut c, image);
                attach(&mut c, target);
                for step in 0..40 {
                    c.clear_color(red, 1.0, 0.0, 1.0);
                    c.clear(GL_COLOR_BUFFER_BIT);
                    c.finish();
                    if step % 8 == 7 {
                        c.egl_image_target_texture_2d(D2, image.handle());
                    }
                }
            });
        }
    });
    attach(&mut a, source);
    for texel in attached(&mut a).chunks_exact(4) {
        assert!(matches!(texel, [0 | 255, 255, 0, 255]), "{texel:?}");
    }
}

/// `OES_EGL_image_external` and `OES_EGL_image_external_essl3`: textures that are EGL images alone.
#[test]
fn external_textures_show_images_of_other_contexts() {
    type Refused = (fn(&mut Context), GLenum);
    const EXTERNAL: GLenum = GL_TEXTURE_EXTERNAL_OES;
    const VERTEX: &str = "attribute vec2 at; varying vec2 coord;
        void main() { gl_Position = vec4(at, 0.0, 1.0); coord = at * 0.5 + 0.5; }";
    const VERTEX_300: &str = "#version 300 es
        in vec2 at; out vec2 coord;
        void main() { gl_Position = vec4(at, 0.0, 1.0); coord = at * 0.5 + 0.5; }";
    const HEADER: &str = "#extension GL_OES_EGL_image_external : require
        precision highp float; uniform samplerExternalOES image; varying vec2 coord;";
    const HEADER_300: &str = "#version 300 es
        #extension GL_OES_EGL_image_external_essl3 : require
        precision highp float; uniform samplerExternalOES image; in vec2 coord; out vec4 color;";
    let bytes = noise(5);
    let mut a = context(4, 4);
    let source = texture(&mut a, &bytes);
    let image = image(&a, of_2d(source));
    let mut b = es(SIDE as u32, SIDE as u32);
    let external = name(&mut b);
    b.bind_texture(EXTERNAL, external);
    b.egl_image_target_texture_2d(EXTERNAL, image.handle());
    b.tex_parameteri(EXTERNAL, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    b.tex_parameteri(EXTERNAL, GL_TEXTURE_MAG_FILTER, GL_NEAREST as GLint);
    let (mut units, mut bound, mut wrap) = ([0], [0], [0]);
    b.get_tex_parameteriv(EXTERNAL, GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES, &mut units);
    b.get_tex_parameteriv(EXTERNAL, GL_TEXTURE_WRAP_S, &mut wrap);
    b.get_integerv(GL_TEXTURE_BINDING_EXTERNAL_OES, &mut bound);
    assert_eq!((units, bound), ([1], [external as GLint]));
    assert_eq!(wrap, [GL_CLAMP_TO_EDGE as GLint]);
    fine(&mut b);
    for (vertex, header, body) in [
        (VERTEX, HEADER, "gl_FragColor = texture2D(image, coord);"),
        (VERTEX, HEADER, "gl_FragColor = texture2DProj(image, vec3(coord, 1.0) * 3.0);"),
        (VERTEX, HEADER, "gl_FragColor = texture2DProj(image, vec4(coord, 9.0, 1.0) * 3.0);"),
        (VERTEX_300, HEADER_300, "color = texture(image, coord);"),
        (VERTEX_300, HEADER_300, "color = texture(image, coord, 2.0);"),
        (VERTEX_300, HEADER_300, "color = textureProj(image, vec3(coord, 1.0) * 3.0);"),
        (VERTEX_300, HEADER_300, "color = texelFetch(image, ivec2(gl_FragCoord.xy), 0);"),
        (
            VERTEX_300,
            HEADER_300,
            "color = textureSize(image, 0) == ivec2(8) ? texture(image, coord) : vec4(0.0);",
        ),
    ] {
        let program = use_program(&mut b, vertex, &format!("{header} void main() {{ {body} }}"));
        let (mut size, mut ty) = ([0], [0]);
        b.get_active_uniform(program, 0, 0, &mut [], &mut size, &mut ty, TextOut::Bytes(&mut []));
        assert_eq!((size, ty), ([1], [GL_SAMPLER_EXTERNAL_OES]));
        b.clear(GL_COLOR_BUFFER_BIT);
        let at = b.get_attrib_location(program, "at") as GLuint;
        let corners: [f32; 8] = [-1.0, -1.0, 1.0, -1.0, -1.0, 1.0, 1.0, 1.0];
        b.vertex_attrib_pointer(at, 2, GL_FLOAT, false, 0, corners.as_slice().arg());
        b.enable_vertex_attrib_array(at);
        b.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
        assert_eq!(attached(&mut b), bytes, "{body}");
    }
    // Without an image it is incomplete, and what other calls do with a texture is refused.
    let empty = name(&mut b);
    b.bind_texture(EXTERNAL, empty);
    b.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
    assert_eq!(attached(&mut b)[..4], [0, 0, 0, 0]);
    let refused: [Refused; 7] = [
        (|c| c.tex_parameteri(EXTERNAL, GL_TEXTURE_WRAP_S, GL_REPEAT as GLint), GL_INVALID_ENUM),
        (
            |c| {
                let filter = GL_LINEAR_MIPMAP_LINEAR as GLint;
                c.tex_parameteri(EXTERNAL, GL_TEXTURE_MIN_FILTER, filter);
            },
            GL_INVALID_ENUM,
        ),
        (
            |c| {
                let (format, ty, texel) = (GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(&[0; 4]));
                c.tex_image_2d(EXTERNAL, 0, GL_RGBA as GLint, 1, 1, 0, format, ty, texel);
            },
            GL_INVALID_ENUM,
        ),
        (|c| c.tex_storage_2d(EXTERNAL, 1, GL_RGBA8, 1, 1), GL_INVALID_ENUM),
        (|c| c.generate_mipmap(EXTERNAL), GL_INVALID_ENUM),
        (
            |c| {
                c.bind_framebuffer(GL_FRAMEBUFFER, 1);
                c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, EXTERNAL, 1, 0);
            },
            GL_INVALID_ENUM,
        ),
        (|c| c.bind_texture(GL_TEXTURE_2D, 1), GL_INVALID_OPERATION),
    ];
    for (number, (call, flag)) in refused.iter().enumerate() {
        b.messages();
        call(&mut b);
        assert_eq!(b.get_error(), *flag, "{number}: {:?}", b.messages());
    }
    // OpenGL has no such textures.
    a.bind_texture(EXTERNAL, 9);
    assert_eq!(a.get_error(), GL_INVALID_ENUM);
    a.egl_image_target_texture_2d(EXTERNAL, image.handle());
    assert_eq!(a.get_error(), GL_INVALID_ENUM);
}
