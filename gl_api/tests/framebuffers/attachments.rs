//! What can be attached, and what is stored of a colour there.

use super::{ALL, bytes, context, fine, floats, framebuffer, rectangle, renderbuffer};
use gl_api::*;

/// How a component is stored.
#[derive(Clone, Copy)]
enum Stored {
    /// This many bits of a fraction.
    Fixed(i32),
    /// A float with this many bits of mantissa.
    Float(i32),
    /// Not at all: reads as this.
    Not(f32),
}

use Stored::{Fixed, Float, Not};

/// The definition in `f64`: what a colour between 0 and 1 reads as.
fn stored(component: f32, how: Stored) -> (f64, f64) {
    match how {
        Fixed(bits) => {
            let largest = 2.0_f64.powi(bits) - 1.0;
            ((f64::from(component) * largest).round() / largest, 1e-7)
        }
        Float(bits) => {
            (f64::from(component), f64::from(component) * 2.0_f64.powi(-bits - 1) + 1e-12)
        }
        Not(value) => (value.into(), 0.0),
    }
}

const COLOR: [f32; 4] = [0.81, 0.33, 0.17, 0.72];

const FORMATS: &[(GLenum, [Stored; 4])] = &[
    (GL_RGBA8, [Fixed(8); 4]),
    (GL_RGB8, [Fixed(8), Fixed(8), Fixed(8), Not(1.0)]),
    (GL_RG8, [Fixed(8), Fixed(8), Not(0.0), Not(1.0)]),
    (GL_R8, [Fixed(8), Not(0.0), Not(0.0), Not(1.0)]),
    (GL_RGBA16, [Fixed(16); 4]),
    (GL_RGB16, [Fixed(16), Fixed(16), Fixed(16), Not(1.0)]),
    (GL_RG16, [Fixed(16), Fixed(16), Not(0.0), Not(1.0)]),
    (GL_R16, [Fixed(16), Not(0.0), Not(0.0), Not(1.0)]),
    (GL_RGB10_A2, [Fixed(10), Fixed(10), Fixed(10), Fixed(2)]),
    (GL_RGB10, [Fixed(10), Fixed(10), Fixed(10), Not(1.0)]),
    (GL_RGB5_A1, [Fixed(5), Fixed(5), Fixed(5), Fixed(1)]),
    (GL_RGBA4, [Fixed(4); 4]),
    (GL_RGB5, [Fixed(5), Fixed(6), Fixed(5), Not(1.0)]),
    (GL_RGB565, [Fixed(5), Fixed(6), Fixed(5), Not(1.0)]),
    (GL_R3_G3_B2, [Fixed(3), Fixed(3), Fixed(2), Not(1.0)]),
    (GL_SRGB8_ALPHA8, [Fixed(8); 4]),
    (GL_SRGB8, [Fixed(8), Fixed(8), Fixed(8), Not(1.0)]),
    (GL_RGBA32F, [Float(23); 4]),
    (GL_RGB32F, [Float(23), Float(23), Float(23), Not(1.0)]),
    (GL_RG32F, [Float(23), Float(23), Not(0.0), Not(1.0)]),
    (GL_R32F, [Float(23), Not(0.0), Not(0.0), Not(1.0)]),
    (GL_RGBA16F, [Float(10); 4]),
    (GL_RGB16F, [Float(10), Float(10), Float(10), Not(1.0)]),
    (GL_RG16F, [Float(10), Float(10), Not(0.0), Not(1.0)]),
    (GL_R16F, [Float(10), Not(0.0), Not(0.0), Not(1.0)]),
    (GL_R11F_G11F_B10F, [Float(6), Float(6), Float(5), Not(1.0)]),
    (GL_ALPHA8, [Not(0.0), Not(0.0), Not(0.0), Fixed(8)]),
    (GL_ALPHA16, [Not(0.0), Not(0.0), Not(0.0), Fixed(16)]),
    (GL_LUMINANCE8, [Fixed(8), Not(0.0), Not(0.0), Not(1.0)]),
    (GL_LUMINANCE8_ALPHA8, [Fixed(8), Not(0.0), Not(0.0), Fixed(8)]),
    (GL_LUMINANCE16_ALPHA16, [Fixed(16), Not(0.0), Not(0.0), Fixed(16)]),
    (GL_INTENSITY8, [Fixed(8), Not(0.0), Not(0.0), Not(1.0)]),
    (GL_INTENSITY32F_ARB, [Float(23), Not(0.0), Not(0.0), Not(1.0)]),
];

fn check(c: &mut Context, internal: GLenum, how: [Stored; 4], what: &str) {
    // Sparse pixels take another way through the rasterizer than whole blocks.
    for area in [[0, 0, 1, 1], [37, 20, 1, 1], [69, 21, 1, 1]] {
        let got = floats(c, area, GL_RGBA, 4);
        for (i, how) in how.into_iter().enumerate() {
            let (want, tolerance) = stored(COLOR[i], how);
            let got = f64::from(got[i]);
            assert!(
                (got - want).abs() <= tolerance,
                "{} {what} component {i}: {got}, not {want}",
                enum_name(internal)
            );
        }
    }
}

#[test]
fn every_format_keeps_what_it_can_of_a_colour() {
    for &(internal, how) in FORMATS {
        let mut c = context(4, 4);
        framebuffer(&mut c);
        renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, internal, 70, 22);
        assert_eq!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
        c.viewport(0, 0, 70, 22);
        let [r, g, b, a] = COLOR;
        c.clear_color(r, g, b, a);
        c.clear(GL_COLOR_BUFFER_BIT);
        check(&mut c, internal, how, "cleared");
        c.clear_color(0.5, 0.5, 0.5, 0.5);
        c.clear(GL_COLOR_BUFFER_BIT);
        c.color_4f(r, g, b, a);
        rectangle(&mut c, ALL, 0.0);
        check(&mut c, internal, how, "drawn");
        // Blended over itself with weights that add up to one.
        c.enable(GL_BLEND);
        c.blend_color(0.0, 0.0, 0.0, 0.25);
        c.blend_func(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
        rectangle(&mut c, ALL, 0.0);
        let coarse = how.map(|how| match how {
            Float(bits) => Float(bits - 1),
            Fixed(_) | Not(_) => how,
        });
        check(&mut c, internal, coarse, "blended");
    }
}

#[test]
fn srgb_is_encoded_when_written_and_blended_as_light() {
    let light = |c: f64| if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
    let code = |l: f64| {
        if l <= 0.003_130_8 { l * 12.92 } else { 1.055 * l.powf(1.0 / 2.4) - 0.055 }
    };
    let mut c = context(4, 4);
    framebuffer(&mut c);
    renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, 8, 8);
    c.viewport(0, 0, 8, 8);
    c.enable(GL_FRAMEBUFFER_SRGB);
    c.clear_color(0.5, 0.2, 0.01, 0.5);
    c.clear(GL_COLOR_BUFFER_BIT);
    let cleared = bytes(&mut c, [3, 3, 1, 1], GL_RGBA, 4);
    let want = [0.5, 0.2, 0.01].map(|l| (code(l) * 255.0).round() as u8);
    assert_eq!(cleared, [want[0], want[1], want[2], 128]);
    c.enable(GL_BLEND);
    c.blend_func(GL_ONE, GL_ONE);
    c.color_4f(0.25, 0.1, 0.0, 0.25);
    rectangle(&mut c, ALL, 0.0);
    let blended = bytes(&mut c, [3, 3, 1, 1], GL_RGBA, 4);
    for (i, more) in [0.25, 0.1, 0.0].into_iter().enumerate() {
        let sum = light(f64::from(want[i]) / 255.0) + more;
        assert!((f64::from(blended[i]) - code(sum) * 255.0).abs() <= 0.501, "{i}");
    }
    assert_eq!(blended[3], 192);
}

#[test]
fn integers_are_cleared_and_read_as_they_are() {
    for (internal, ty, value) in [
        (GL_RGBA32I, GL_INT, [-5, i32::MAX, i32::MIN, 7]),
        (GL_RGBA8I, GL_INT, [-128, 127, 0, -1]),
        (GL_RGBA16UI, GL_UNSIGNED_INT, [0, 65_535, 1, 2]),
    ] {
        let mut c = context(4, 4);
        framebuffer(&mut c);
        renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, internal, 9, 9);
        if ty == GL_INT {
            c.clear_bufferiv(GL_COLOR, 0, &value);
        } else {
            c.clear_bufferuiv(GL_COLOR, 0, &value.map(|v| v as u32));
        }
        let mut got = [0_i32; 4];
        let out = DataOut::Bytes(super::bytes_of(&mut got));
        c.read_pixels(8, 8, 1, 1, GL_RGBA_INTEGER, ty, out);
        fine(&mut c);
        assert_eq!(got, value);
    }
}

/// How many layers, slices or faces the textures of a target have here.
fn layers(target: GLenum) -> usize {
    if target == GL_TEXTURE_CUBE_MAP_ARRAY { 12 } else { 4 }
}

/// A texture of a target with an image of 8 × 8 (× its layers), bound.
fn texture(c: &mut Context, target: GLenum) -> GLuint {
    let mut name = [0];
    c.gen_textures(1, &mut name);
    c.bind_texture(target, name[0]);
    let (format, ty, data) = (GL_RGBA, GL_UNSIGNED_BYTE, Data::Null);
    match target {
        GL_TEXTURE_1D => c.tex_image_1d(target, 0, GL_RGBA8 as i32, 8, 0, format, ty, data),
        GL_TEXTURE_3D | GL_TEXTURE_2D_ARRAY | GL_TEXTURE_CUBE_MAP_ARRAY => {
            let depth = layers(target) as i32;
            c.tex_image_3d(target, 0, GL_RGBA8 as i32, 8, 8, depth, 0, format, ty, data);
        }
        GL_TEXTURE_CUBE_MAP => {
            for face in 0..6 {
                let target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
                c.tex_image_2d(target, 0, GL_RGBA8 as i32, 8, 8, 0, format, ty, data);
            }
        }
        GL_TEXTURE_1D_ARRAY => {
            c.tex_image_2d(target, 0, GL_RGBA8 as i32, 8, 4, 0, format, ty, data);
        }
        _ => c.tex_image_2d(target, 0, GL_RGBA8 as i32, 8, 8, 0, format, ty, data),
    }
    fine(c);
    name[0]
}

/// Fills what is attached with a level of red and reads it back.
fn paint(c: &mut Context, level: u8) {
    assert_eq!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    c.clear_color(f32::from(level) / 255.0, 0.0, 0.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    assert_eq!(bytes(c, [0, 0, 1, 1], GL_RED, 1), [level]);
}

#[test]
fn every_slice_of_every_kind_of_texture_is_drawn_to_by_itself() {
    const FB: GLenum = GL_FRAMEBUFFER;
    const AT: GLenum = GL_COLOR_ATTACHMENT0;
    let mut c = context(4, 4);
    framebuffer(&mut c);
    let line = texture(&mut c, GL_TEXTURE_1D);
    c.framebuffer_texture_1d(FB, AT, GL_TEXTURE_1D, line, 0);
    paint(&mut c, 11);
    for target in [GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE] {
        let plane = texture(&mut c, target);
        c.framebuffer_texture_2d(FB, AT, target, plane, 0);
        paint(&mut c, 22);
    }
    let cube = texture(&mut c, GL_TEXTURE_CUBE_MAP);
    for face in 0..6 {
        let target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
        c.framebuffer_texture_2d(FB, AT, target, cube, 0);
        paint(&mut c, 30 + face as u8);
    }
    for target in
        [GL_TEXTURE_3D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_1D_ARRAY, GL_TEXTURE_CUBE_MAP_ARRAY]
    {
        let layered = texture(&mut c, target);
        for layer in 0..layers(target) as i32 {
            if target == GL_TEXTURE_3D && layer % 2 == 0 {
                c.framebuffer_texture_3d(FB, AT, target, layered, 0, layer);
            } else {
                c.framebuffer_texture_layer(FB, AT, layered, 0, layer);
            }
            paint(&mut c, 40 + layer as u8);
        }
        let mut texels = vec![0_u8; 8 * 8 * layers(target)];
        c.get_tex_image(target, 0, GL_RED, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut texels));
        let slice = if target == GL_TEXTURE_1D_ARRAY { 8 } else { 64 };
        for (i, texel) in texels[..slice * layers(target)].iter().enumerate() {
            assert_eq!(usize::from(*texel), 40 + i / slice, "{}", enum_name(target));
        }
    }
    for face in 0..6 {
        let mut texels = [0_u8; 64];
        let target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
        let out = DataOut::Bytes(&mut texels);
        c.get_tex_image(target, 0, GL_RED, GL_UNSIGNED_BYTE, out);
        assert_eq!(texels, [30 + face as u8; 64]);
    }
    fine(&mut c);
}

/// GL 3.2, sections 4.4.2 and 4.4.7: clears go to every layer, draws to the first, from which is read.
#[test]
fn all_layers_of_a_level_are_attached_at_once() {
    const FB: GLenum = GL_FRAMEBUFFER;
    const AT: GLenum = GL_COLOR_ATTACHMENT0;
    let mut c = context(4, 4);
    framebuffer(&mut c);
    c.viewport(0, 0, 8, 8);
    let of_layers = [
        GL_TEXTURE_3D,
        GL_TEXTURE_2D_ARRAY,
        GL_TEXTURE_1D_ARRAY,
        GL_TEXTURE_CUBE_MAP_ARRAY,
        GL_TEXTURE_CUBE_MAP,
    ];
    let asked = |c: &mut Context, pname| {
        let mut value = [-1];
        c.get_framebuffer_attachment_parameteriv(FB, AT, pname, &mut value);
        value[0]
    };
    for target in of_layers {
        let name = texture(&mut c, target);
        c.framebuffer_texture(FB, AT, name, 0);
        assert_eq!(asked(&mut c, GL_FRAMEBUFFER_ATTACHMENT_LAYERED), 1);
        paint(&mut c, 77);
        c.color_3f(1.0, 0.0, 0.0);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        assert_eq!(bytes(&mut c, [0, 0, 1, 1], GL_RED, 1), [255]);
        let targets = match target {
            GL_TEXTURE_CUBE_MAP => (0..6).map(|at| GL_TEXTURE_CUBE_MAP_POSITIVE_X + at).collect(),
            _ => vec![target],
        };
        let (count, slice) = match target {
            GL_TEXTURE_CUBE_MAP => (1, 64),
            GL_TEXTURE_1D_ARRAY => (4, 8),
            _ => (layers(target), 64),
        };
        for (face, target) in targets.into_iter().enumerate() {
            let mut texels = vec![0_u8; slice * count];
            c.get_tex_image(target, 0, GL_RED, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut texels));
            for (at, &texel) in texels.iter().enumerate() {
                let first = face == 0 && at < slice;
                assert_eq!(texel, if first { 255 } else { 77 }, "{} {at}", enum_name(target));
            }
        }
    }
    let plane = texture(&mut c, GL_TEXTURE_2D);
    c.framebuffer_texture(FB, AT, plane, 0);
    assert_eq!(asked(&mut c, GL_FRAMEBUFFER_ATTACHMENT_LAYERED), 0);
    let [volume, array] =
        [GL_TEXTURE_3D, GL_TEXTURE_2D_ARRAY].map(|target| texture(&mut c, target));
    c.framebuffer_texture(FB, AT + 1, volume, 0);
    let mixed = GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS;
    assert_eq!(c.check_framebuffer_status(FB), mixed);
    c.framebuffer_texture(FB, AT, array, 0);
    assert_eq!(c.check_framebuffer_status(FB), mixed);
    c.framebuffer_texture_layer(FB, AT, array, 0, 1);
    c.framebuffer_texture_layer(FB, AT + 1, volume, 0, 1);
    assert_eq!(c.check_framebuffer_status(FB), GL_FRAMEBUFFER_COMPLETE);
    fine(&mut c);
}

#[test]
fn depth_and_stencil_of_one_image_are_both_there() {
    for internal in [GL_DEPTH24_STENCIL8, GL_DEPTH32F_STENCIL8] {
        let mut c = context(4, 4);
        framebuffer(&mut c);
        renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, GL_RGBA8, 16, 16);
        renderbuffer(&mut c, GL_DEPTH_STENCIL_ATTACHMENT, internal, 16, 16);
        assert_eq!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
        c.viewport(0, 0, 16, 16);
        c.clear_bufferfi(GL_DEPTH_STENCIL, 0, 0.5, 0x5A);
        c.enable(GL_DEPTH_TEST);
        c.enable(GL_STENCIL_TEST);
        c.stencil_func(GL_EQUAL, 0x5A, !0);
        c.stencil_op(GL_KEEP, GL_DECR, GL_INCR);
        rectangle(&mut c, [-1.0, -1.0, 0.0, 1.0], -0.5);
        rectangle(&mut c, [0.0, -1.0, 1.0, 1.0], 0.5);
        assert_eq!(bytes(&mut c, [2, 2, 1, 1], GL_STENCIL_INDEX, 1), [0x5B]);
        assert_eq!(bytes(&mut c, [12, 2, 1, 1], GL_STENCIL_INDEX, 1), [0x59]);
        let depth = floats(&mut c, [2, 2, 1, 1], GL_DEPTH_COMPONENT, 1)[0];
        assert!((depth - 0.25).abs() < 1e-6, "{depth}");
        let depth = floats(&mut c, [12, 2, 1, 1], GL_DEPTH_COMPONENT, 1)[0];
        assert!((depth - 0.5).abs() < 1e-6, "{depth}");
        let mut both = [0_u32];
        let out = DataOut::Bytes(super::bytes_of(&mut both));
        c.read_pixels(2, 2, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, out);
        fine(&mut c);
        assert_eq!(both[0] & 0xFF, 0x5B);
        assert_eq!(both[0] >> 24, 0x40);
    }
}

#[test]
fn a_stencil_alone_has_no_depth() {
    let mut c = context(4, 4);
    framebuffer(&mut c);
    renderbuffer(&mut c, GL_STENCIL_ATTACHMENT, GL_STENCIL_INDEX8, 8, 8);
    c.draw_buffer(GL_NONE);
    c.read_buffer(GL_NONE);
    assert_eq!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    for (pname, want) in [(GL_DEPTH_BITS, 0), (GL_STENCIL_BITS, 8), (GL_RED_BITS, 0)] {
        let mut value = [9];
        c.get_integerv(pname, &mut value);
        assert_eq!(value[0], want, "{}", enum_name(pname));
    }
    c.clear_bufferiv(GL_STENCIL, 0, &[7]);
    c.enable(GL_DEPTH_TEST);
    c.depth_func(GL_NEVER);
    c.enable(GL_STENCIL_TEST);
    c.stencil_op(GL_KEEP, GL_KEEP, GL_INCR);
    c.viewport(0, 0, 8, 8);
    rectangle(&mut c, ALL, 0.0);
    assert_eq!(bytes(&mut c, [0, 0, 8, 8], GL_STENCIL_INDEX, 1), [8; 64]);
}

#[test]
fn what_is_attached_lives_as_long_as_it_is_attached() {
    let mut c = context(4, 4);
    let first = framebuffer(&mut c);
    let plane = texture(&mut c, GL_TEXTURE_2D);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, plane, 0);
    paint(&mut c, 77);
    // Not bound: stays attached.
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    c.delete_textures(1, &[plane]);
    c.bind_framebuffer(GL_FRAMEBUFFER, first);
    assert_eq!(bytes(&mut c, [0, 0, 1, 1], GL_RED, 1), [77]);
    // Bound: taken off.
    let plane = texture(&mut c, GL_TEXTURE_2D);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, plane, 0);
    c.delete_textures(1, &[plane]);
    let status = c.check_framebuffer_status(GL_FRAMEBUFFER);
    assert_eq!(status, GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
}

#[test]
fn an_attachment_without_an_image_has_no_components() {
    let mut c = context(4, 4);
    framebuffer(&mut c);
    let mut names = [0];
    c.gen_renderbuffers(1, &mut names);
    c.bind_renderbuffer(GL_RENDERBUFFER, names[0]);
    let plane = texture(&mut c, GL_TEXTURE_2D);
    let asked = |c: &mut Context| {
        [
            GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE,
            GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING,
            GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE,
        ]
        .map(|pname| {
            let (mut value, point) = ([-1], GL_COLOR_ATTACHMENT0);
            c.get_framebuffer_attachment_parameteriv(GL_FRAMEBUFFER, point, pname, &mut value);
            fine(c);
            value[0] as GLenum
        })
    };
    let none = [GL_NONE, GL_LINEAR, 0];
    let point = GL_COLOR_ATTACHMENT0;
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, names[0]);
    assert_eq!(asked(&mut c), none);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, plane, 3);
    assert_eq!(asked(&mut c), none);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, plane, 0);
    assert_eq!(asked(&mut c), [GL_UNSIGNED_NORMALIZED, GL_LINEAR, 8]);
}

#[test]
fn several_samples_are_resolved_when_read() {
    let mut c = context(4, 4);
    framebuffer(&mut c);
    let mut name = [0];
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 2, GL_RGBA8, 8, 8);
    let mut samples = [0];
    c.get_renderbuffer_parameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &mut samples);
    assert_eq!(samples, [4]);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name[0]);
    c.clear_color(0.2, 0.4, 0.6, 0.8);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
    c.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    assert_eq!(bytes(&mut c, [3, 3, 1, 1], GL_RGBA, 4), [51, 102, 153, 204]);
}

/// What is attached to the bound framebuffer's colour and depth, by type.
fn attached(c: &mut Context) -> [GLenum; 2] {
    [GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT].map(|point| {
        let (kind, mut value) = (GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, [0]);
        c.get_framebuffer_attachment_parameteriv(GL_FRAMEBUFFER, point, kind, &mut value);
        value[0] as GLenum
    })
}

/// What was deleted while another framebuffer was bound stays, whatever has its name by now.
#[test]
fn a_deleted_image_is_detached_and_no_other_of_its_name() {
    let mut c = context(4, 4);
    let make = |c: &mut Context| {
        c.bind_texture(GL_TEXTURE_2D, 7);
        let (target, format) = (GL_TEXTURE_2D, GL_RGBA);
        c.tex_image_2d(target, 0, GL_RGBA as i32, 4, 4, 0, format, GL_UNSIGNED_BYTE, Data::Null);
        c.bind_renderbuffer(GL_RENDERBUFFER, 7);
        c.renderbuffer_storage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, 4, 4);
    };
    let delete = |c: &mut Context| {
        c.delete_textures(1, &[7]);
        c.delete_renderbuffers(1, &[7]);
    };
    let name = framebuffer(&mut c);
    make(&mut c);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 7, 0);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 7);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    delete(&mut c);
    make(&mut c);
    c.bind_framebuffer(GL_FRAMEBUFFER, name);
    delete(&mut c);
    assert_eq!(attached(&mut c), [GL_TEXTURE, GL_RENDERBUFFER]);
    assert_eq!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    make(&mut c);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 7, 0);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 7);
    delete(&mut c);
    assert_eq!(attached(&mut c), [0; 2]);
    fine(&mut c);
}
