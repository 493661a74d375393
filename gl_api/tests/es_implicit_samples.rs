//! Textures and renderbuffers whose samples are resolved where they are read (`EXT_multisampled_render_to_texture`).

#[path = "common/shading.rs"]
mod shading;

use gl_api::*;
use shading::use_program;

const SIDE: GLsizei = 8;
const FB: GLenum = GL_FRAMEBUFFER;
const C0: GLenum = GL_COLOR_ATTACHMENT0;

fn context(api: Api, major: u8) -> Context {
    let version = Version::new(major, 0);
    Context::new(ContextDesc { api, version, width: 8, height: 8, ..ContextDesc::default() })
        .expect("a device")
}

fn es() -> Context {
    context(Api::Es2, 3)
}

/// A texture of zeros, `levels` of them, bound to a target.
fn texture(c: &mut Context, target: GLenum, levels: GLint) -> GLuint {
    let mut name = [0];
    c.gen_textures(1, &mut name);
    c.bind_texture(target, name[0]);
    c.tex_parameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    c.tex_parameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST as GLint);
    let texels: &[u8] = &[0; 8 * 8 * 4];
    let faces = if target == GL_TEXTURE_CUBE_MAP { 6 } else { 1 };
    let first = if faces == 6 { GL_TEXTURE_CUBE_MAP_POSITIVE_X } else { target };
    for (face, level) in (0..faces).flat_map(|face| (0..levels).map(move |level| (face, level))) {
        let (target, side) = (first + face, SIDE >> level);
        let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
        c.tex_image_2d(target, level, GL_RGBA as i32, side, side, 0, format, ty, texels.arg());
    }
    name[0]
}

/// A framebuffer with a level of a texture, drawn to with so many samples, is bound.
fn attached(c: &mut Context, of: (GLenum, GLuint, GLint), samples: GLsizei) -> GLuint {
    let (target, texture, level) = of;
    let mut name = [0];
    c.gen_framebuffers(1, &mut name);
    c.bind_framebuffer(FB, name[0]);
    c.framebuffer_texture_2d_multisample(FB, C0, target, texture, level, samples);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    assert_eq!(c.check_framebuffer_status(FB), GL_FRAMEBUFFER_COMPLETE, "{:?}", c.messages());
    name[0]
}

/// A new texture of one level, drawn to with four samples.
fn drawn_texture(c: &mut Context) -> GLuint {
    let name = texture(c, GL_TEXTURE_2D, 1);
    attached(c, (GL_TEXTURE_2D, name, 0), 4);
    name
}

/// Draws white on one side of `x = 3.5` pixels, the middle of a column: two of the four samples of its pixels lie on
/// either side.
fn draw_half(c: &mut Context, side: Side) {
    let edge = 3.5 / 4.0 - 1.0;
    let (left, right) = match side {
        Side::Left => (-1.0, edge),
        Side::Right => (edge, 1.0),
    };
    let corners: [f32; 8] = [left, -1.0, right, -1.0, left, 1.0, right, 1.0];
    let source = "attribute vec2 corner; void main() { gl_Position = vec4(corner, 0.0, 1.0); }";
    let color = "void main() { gl_FragColor = vec4(1.0); }";
    let program = use_program(c, source, color);
    let at = c.get_attrib_location(program, "corner") as GLuint;
    c.enable_vertex_attrib_array(at);
    c.vertex_attrib_pointer(at, 2, GL_FLOAT, false, 0, corners.arg());
    c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

#[derive(Clone, Copy)]
enum Side {
    Left,
    Right,
}

/// A row of the bound framebuffer, its red.
fn row(c: &mut Context, side: GLsizei) -> Vec<u8> {
    let mut pixels = vec![9; (side * side * 4) as usize];
    c.read_pixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    let rows: Vec<Vec<u8>> = pixels
        .chunks(side as usize * 4)
        .map(|row| row.chunks(4).map(|pixel| pixel[0]).collect())
        .collect();
    assert!(rows.iter().all(|row| *row == rows[0]), "the rows differ: {rows:?}");
    rows[0].clone()
}

const LEFT: [u8; 8] = [255, 255, 255, 128, 0, 0, 0, 0];

/// The texels of level 0, drawn with a shader to another framebuffer.
fn sampled(c: &mut Context, texture: GLuint) -> Vec<u8> {
    let other = self::texture(c, GL_TEXTURE_2D, 1);
    attached(c, (GL_TEXTURE_2D, other, 0), 0);
    c.bind_texture(GL_TEXTURE_2D, texture);
    let corners: [f32; 8] = [-1.0, -1.0, 1.0, -1.0, -1.0, 1.0, 1.0, 1.0];
    let source = "attribute vec2 corner; varying vec2 at;\
                  void main() { at = corner * 0.5 + 0.5; gl_Position = vec4(corner, 0.0, 1.0); }";
    let color = "precision highp float; varying vec2 at; uniform sampler2D image;\
                 void main() { gl_FragColor = texture2D(image, at); }";
    let program = use_program(c, source, color);
    let at = c.get_attrib_location(program, "corner") as GLuint;
    c.enable_vertex_attrib_array(at);
    c.vertex_attrib_pointer(at, 2, GL_FLOAT, false, 0, corners.arg());
    c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
    row(c, SIDE)
}

#[test]
fn every_way_of_reading_gives_the_resolved_texels() {
    for major in [2, 3] {
        let mut c = context(Api::Es2, major);
        drawn_texture(&mut c);
        let mut samples = [0];
        c.get_integerv(GL_SAMPLES, &mut samples);
        assert_eq!(samples, [4]);
        draw_half(&mut c, Side::Left);
        assert_eq!(row(&mut c, SIDE), LEFT, "glReadPixels");

        let texture = drawn_texture(&mut c);
        draw_half(&mut c, Side::Left);
        assert_eq!(sampled(&mut c, texture), LEFT, "a shader");

        drawn_texture(&mut c);
        draw_half(&mut c, Side::Left);
        let copy = self::texture(&mut c, GL_TEXTURE_2D, 1);
        c.copy_tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 0, 0, SIDE, SIDE);
        assert_eq!(sampled(&mut c, copy), LEFT, "glCopyTexSubImage2D");

        let texture = drawn_texture(&mut c);
        draw_half(&mut c, Side::Left);
        c.bind_texture(GL_TEXTURE_2D, texture);
        c.generate_mipmap(GL_TEXTURE_2D);
        attached(&mut c, (GL_TEXTURE_2D, texture, 1), 0);
        assert_eq!(row(&mut c, SIDE / 2), [255, 192, 0, 0], "glGenerateMipmap");
    }
    let mut c = es();
    drawn_texture(&mut c);
    draw_half(&mut c, Side::Left);
    let copy = texture(&mut c, GL_TEXTURE_2D, 1);
    let mut name = [0];
    c.gen_framebuffers(1, &mut name);
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, name[0]);
    c.framebuffer_texture_2d(GL_DRAW_FRAMEBUFFER, C0, GL_TEXTURE_2D, copy, 0);
    c.blit_framebuffer(0, 0, 8, 8, 8, 0, 0, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, name[0]);
    let mirrored: Vec<u8> = LEFT.into_iter().rev().collect();
    assert_eq!(row(&mut c, SIDE), mirrored, "glBlitFramebuffer");
}

/// The two halves cover every sample of the column between them once.
#[test]
fn draws_that_follow_each_other_go_to_the_same_samples() {
    type Between = fn(&mut Context);
    let between: &[Between] = &[
        |_| (),
        |c| c.finish(),
        |c| c.flush(),
        |c| assert_eq!(row(c, SIDE), LEFT),
        |c| {
            let mut bound = [0];
            c.get_integerv(GL_FRAMEBUFFER_BINDING, &mut bound);
            c.bind_framebuffer(FB, 0);
            c.clear(GL_COLOR_BUFFER_BIT);
            c.bind_framebuffer(FB, bound[0] as GLuint);
        },
    ];
    for (at, between) in between.iter().enumerate() {
        let mut c = es();
        drawn_texture(&mut c);
        draw_half(&mut c, Side::Left);
        between(&mut c);
        draw_half(&mut c, Side::Right);
        assert_eq!(row(&mut c, SIDE), [255; 8], "{at}");
    }
}

/// Where something else writes to the texture, the samples are gone: each is the texel.
#[test]
fn samples_are_discarded_where_the_texture_is_changed() {
    let mut c = es();
    let texture = drawn_texture(&mut c);
    draw_half(&mut c, Side::Left);
    c.bind_texture(GL_TEXTURE_2D, texture);
    let texel: &[u8] = &[10; 4];
    c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel.arg());
    let mut pixel = [0; 4];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(pixel, [10; 4]);
    draw_half(&mut c, Side::Right);
    // Two samples of the column were 128, two are white.
    c.read_pixels(3, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(pixel[0], 192, "(128 + 128 + 255 + 255) / 4 is 191.5");

    // So they are where it is attached with one sample.
    let texture = drawn_texture(&mut c);
    draw_half(&mut c, Side::Left);
    c.framebuffer_texture_2d(FB, C0, GL_TEXTURE_2D, texture, 0);
    let mut samples = [9];
    c.get_integerv(GL_SAMPLES, &mut samples);
    assert_eq!(samples, [0]);
    assert_eq!(row(&mut c, SIDE), LEFT);
    draw_half(&mut c, Side::Right);
    let drawn = row(&mut c, SIDE);
    assert!(matches!(drawn[3], 128 | 255), "one sample is covered or not: {drawn:?}");
}

#[test]
fn faces_and_levels_have_samples_of_their_own() {
    let mut c = es();
    let cube = texture(&mut c, GL_TEXTURE_CUBE_MAP, 2);
    // Both levels are sampled, so that level 1 is a complete attachment.
    c.tex_parameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, 1);
    let face = GL_TEXTURE_CUBE_MAP_NEGATIVE_Y;
    attached(&mut c, (face, cube, 1), 4);
    c.viewport(0, 0, 4, 4);
    draw_half(&mut c, Side::Left);
    // The edge lies at 1.75 pixels: three samples of the column lie on its left.
    assert_eq!(row(&mut c, 4), [255, 191, 0, 0]);
    attached(&mut c, (GL_TEXTURE_CUBE_MAP_POSITIVE_X, cube, 0), 4);
    c.viewport(0, 0, 8, 8);
    draw_half(&mut c, Side::Left);
    assert_eq!(row(&mut c, SIDE), LEFT);
    attached(&mut c, (face, cube, 0), 0);
    assert_eq!(row(&mut c, SIDE), [0; 8], "of another face");
    attached(&mut c, (face, cube, 1), 0);
    assert_eq!(row(&mut c, 4), [255, 191, 0, 0], "as it was");
}

fn renderbuffer(c: &mut Context, point: GLenum, internal: GLenum) {
    let mut name = [0];
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.renderbuffer_storage_multisample_ext(GL_RENDERBUFFER, 4, internal, SIDE, SIDE);
    c.framebuffer_renderbuffer(FB, point, GL_RENDERBUFFER, name[0]);
}

#[test]
fn renderbuffers_of_the_extension_are_read() {
    let mut c = es();
    let mut name = [0];
    c.gen_framebuffers(1, &mut name);
    c.bind_framebuffer(FB, name[0]);
    renderbuffer(&mut c, C0, GL_RGBA8);
    draw_half(&mut c, Side::Left);
    assert_eq!(row(&mut c, SIDE), LEFT);
    let copy = texture(&mut c, GL_TEXTURE_2D, 1);
    c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, SIDE, SIDE, 0);
    assert_eq!(sampled(&mut c, copy), LEFT);

    // Those of OpenGL ES 3.0 are not, before a blit.
    c.bind_framebuffer(FB, name[0]);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, GL_RGBA8, SIDE, SIDE);
    let mut pixel = [0; 4];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}

/// A depth buffer of as many samples hides, one with another number leaves the framebuffer incomplete.
#[test]
fn depths_have_as_many_samples() {
    let mut c = es();
    drawn_texture(&mut c);
    renderbuffer(&mut c, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT16);
    assert_eq!(c.check_framebuffer_status(FB), GL_FRAMEBUFFER_COMPLETE, "{:?}", c.messages());
    c.enable(GL_DEPTH_TEST);
    c.clear(GL_DEPTH_BUFFER_BIT);
    c.color_mask(false, false, false, false);
    draw_half(&mut c, Side::Right);
    c.color_mask(true, true, true, true);
    c.depth_func(GL_EQUAL);
    draw_half(&mut c, Side::Right);
    let right: Vec<u8> = LEFT.iter().map(|left| 255 - left).collect();
    let drawn = row(&mut c, SIDE);
    assert_eq!((drawn[2], drawn[4]), (right[2], right[4]), "{drawn:?}");
    assert_eq!(drawn[3], 128);

    let mut name = [0];
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.renderbuffer_storage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, SIDE, SIDE);
    c.framebuffer_renderbuffer(FB, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, name[0]);
    assert_eq!(c.check_framebuffer_status(FB), GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE);
}

#[test]
fn the_number_of_samples_is_asked_for() {
    let mut c = es();
    assert!(c.get_string(GL_EXTENSIONS).contains("GL_EXT_multisampled_render_to_texture"));
    let mut most = [0];
    c.get_integerv(GL_MAX_SAMPLES_EXT, &mut most);
    assert_eq!(most, [4]);
    let texture = texture(&mut c, GL_TEXTURE_2D, 1);
    for (asked, got) in [(0, 0), (1, 4), (2, 4), (4, 4)] {
        attached(&mut c, (GL_TEXTURE_2D, texture, 0), asked);
        let mut samples = [9];
        let pname = GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_SAMPLES_EXT;
        c.get_framebuffer_attachment_parameteriv(FB, C0, pname, &mut samples);
        assert_eq!(samples, [got], "{asked}");
    }
    renderbuffer(&mut c, C0, GL_RGBA8);
    let mut samples = [9];
    c.get_renderbuffer_parameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES_EXT, &mut samples);
    assert_eq!((samples, c.get_error()), ([4], GL_NO_ERROR));
}

type Call = fn(&mut Context);

/// Calls that are refused; the error and words of the message.
const REFUSED: &[(&str, Call, GLenum, &str)] = &[
    (
        "another target",
        |c| c.framebuffer_texture_2d_multisample(GL_TEXTURE_2D, C0, GL_TEXTURE_2D, 1, 0, 4),
        GL_INVALID_ENUM,
        "target = GL_TEXTURE_2D",
    ),
    (
        "another point",
        |c| c.framebuffer_texture_2d_multisample(FB, C0 + 1, GL_TEXTURE_2D, 1, 0, 4),
        GL_INVALID_ENUM,
        "must be GL_COLOR_ATTACHMENT0",
    ),
    (
        "depths",
        |c| c.framebuffer_texture_2d_multisample(FB, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 1, 0, 4),
        GL_INVALID_ENUM,
        "must be GL_COLOR_ATTACHMENT0",
    ),
    (
        "another target of textures",
        |c| c.framebuffer_texture_2d_multisample(FB, C0, GL_TEXTURE_3D, 1, 0, 4),
        GL_INVALID_ENUM,
        "textarget = GL_TEXTURE_3D",
    ),
    (
        "a target that the texture has not",
        |c| c.framebuffer_texture_2d_multisample(FB, C0, GL_TEXTURE_CUBE_MAP_POSITIVE_X, 1, 0, 4),
        GL_INVALID_OPERATION,
        "does not fit",
    ),
    (
        "no texture",
        |c| c.framebuffer_texture_2d_multisample(FB, C0, GL_TEXTURE_2D, 77, 0, 4),
        GL_INVALID_OPERATION,
        "texture = 77",
    ),
    (
        "no level",
        |c| c.framebuffer_texture_2d_multisample(FB, C0, GL_TEXTURE_2D, 1, -1, 4),
        GL_INVALID_VALUE,
        "level = -1",
    ),
    (
        "too many samples",
        |c| c.framebuffer_texture_2d_multisample(FB, C0, GL_TEXTURE_2D, 1, 0, 5),
        GL_INVALID_VALUE,
        "samples = 5",
    ),
    (
        "fewer than no samples",
        |c| c.framebuffer_texture_2d_multisample(FB, C0, GL_TEXTURE_2D, 1, 0, -1),
        GL_INVALID_VALUE,
        "samples = -1",
    ),
    (
        "the default framebuffer",
        |c| {
            c.bind_framebuffer(FB, 0);
            c.framebuffer_texture_2d_multisample(FB, C0, GL_TEXTURE_2D, 1, 0, 4);
        },
        GL_INVALID_OPERATION,
        "glBindFramebuffer",
    ),
    (
        "too many samples of a renderbuffer",
        |c| c.renderbuffer_storage_multisample_ext(GL_RENDERBUFFER, 5, GL_RGBA8, 4, 4),
        GL_INVALID_VALUE,
        "samples = 5",
    ),
    (
        "fewer than no samples of a renderbuffer",
        |c| c.renderbuffer_storage_multisample_ext(GL_RENDERBUFFER, -1, GL_RGBA8, 4, 4),
        GL_INVALID_VALUE,
        "samples = -1",
    ),
    (
        "another target of renderbuffers",
        |c| c.renderbuffer_storage_multisample_ext(GL_TEXTURE_2D, 4, GL_RGBA8, 4, 4),
        GL_INVALID_ENUM,
        "target = GL_TEXTURE_2D",
    ),
    (
        "a format of renderbuffers that is none",
        |c| c.renderbuffer_storage_multisample_ext(GL_RENDERBUFFER, 4, GL_RGB9_E5, 4, 4),
        GL_INVALID_ENUM,
        "GL_RGB9_E5",
    ),
    (
        "a draw to an incomplete framebuffer",
        |c| {
            renderbuffer(c, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT16);
            c.framebuffer_texture_2d(FB, C0, GL_TEXTURE_2D, 1, 0);
            c.clear(GL_COLOR_BUFFER_BIT);
        },
        GL_INVALID_FRAMEBUFFER_OPERATION,
        "samples a pixel",
    ),
];

#[test]
fn what_is_refused_changes_nothing() {
    for (what, call, error, words) in REFUSED {
        let mut c = es();
        drawn_texture(&mut c);
        let mut buffer = [0];
        c.gen_renderbuffers(1, &mut buffer);
        c.bind_renderbuffer(GL_RENDERBUFFER, buffer[0]);
        call(&mut c);
        let message = c.messages().last().map(ToString::to_string).unwrap_or_default();
        assert_eq!(c.get_error(), *error, "{what}: {message}");
        assert!(message.contains(words), "{what}: {message}");
    }
}

/// OpenGL has renderbuffers of the same name, which are read behind a blit, and no such textures.
#[test]
fn opengl_has_no_implicit_samples() {
    for (api, major) in [(Api::Compatibility, 3), (Api::Core, 3)] {
        let version = Version::new(major, 3);
        let mut c =
            Context::new(ContextDesc { api, version, ..ContextDesc::default() }).expect("a device");
        let texture = texture(&mut c, GL_TEXTURE_2D, 1);
        let mut name = [0];
        c.gen_framebuffers(1, &mut name);
        c.bind_framebuffer(FB, name[0]);
        c.framebuffer_texture_2d_multisample(FB, C0, GL_TEXTURE_2D, texture, 0, 4);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION);
        renderbuffer(&mut c, C0, GL_RGBA8);
        let pname = GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_SAMPLES_EXT;
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
        c.get_framebuffer_attachment_parameteriv(FB, C0, pname, &mut [0]);
        assert_eq!(c.get_error(), GL_INVALID_ENUM);
        let mut pixel = [0; 4];
        c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
        assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    }
}
