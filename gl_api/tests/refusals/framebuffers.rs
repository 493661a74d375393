//! What the calls about framebuffers and about pixels drawn to them refuse, and why a framebuffer is incomplete.

use gl_api::*;

/// The preparation, the call, the error flag that it must set, and words that its message must have.
type Case = (fn(&mut Context), fn(&mut Context), GLenum, &'static str);

/// Most rows need nothing.
fn nothing(_: &mut Context) {}

const FB: GLenum = GL_FRAMEBUFFER;
const C0: GLenum = GL_COLOR_ATTACHMENT0;

fn blit(c: &mut Context, mask: GLenum, filter: GLenum) {
    c.blit_framebuffer(0, 0, 1, 1, 0, 0, 1, 1, mask, filter);
}

/// A framebuffer with a renderbuffer of so many samples is bound.
fn multisampled(c: &mut Context, samples: GLsizei) {
    framebuffer(c);
    c.bind_renderbuffer(GL_RENDERBUFFER, 1);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, samples, GL_RGBA8, 4, 4);
    c.framebuffer_renderbuffer(FB, C0, GL_RENDERBUFFER, 1);
}

const CASES: &[Case] = &[
    (
        framebuffer,
        |c| c.framebuffer_texture_2d_multisample(FB, C0, GL_TEXTURE_2D, 1, 0, 4),
        GL_INVALID_OPERATION,
        "OpenGL ES",
    ),
    (
        nothing,
        |c| c.renderbuffer_storage_multisample_ext(GL_TEXTURE_2D, 4, GL_RGBA8, 4, 4),
        GL_INVALID_ENUM,
        "target = GL_TEXTURE_2D",
    ),
    (
        nothing,
        |c| c.invalidate_framebuffer(GL_RENDERBUFFER, 0, &[]),
        GL_INVALID_ENUM,
        "target = GL_RENDERBUFFER",
    ),
    (nothing, |c| c.invalidate_framebuffer(FB, -1, &[]), GL_INVALID_VALUE, "numAttachments = -1"),
    (nothing, |c| c.invalidate_framebuffer(FB, 1, &[C0]), GL_INVALID_ENUM, "GL_COLOR"),
    (
        framebuffer,
        |c| c.invalidate_framebuffer(FB, 1, &[GL_COLOR_ATTACHMENT31]),
        GL_INVALID_OPERATION,
        "GL_MAX_COLOR_ATTACHMENTS",
    ),
    (
        nothing,
        |c| c.invalidate_sub_framebuffer(FB, 0, &[], 0, 0, -1, 1),
        GL_INVALID_VALUE,
        "width = -1",
    ),
    (
        nothing,
        |c| c.get_internalformativ(GL_PROXY_TEXTURE_2D, GL_RGBA8, GL_SAMPLES, 1, &mut [0]),
        GL_INVALID_ENUM,
        "target = GL_PROXY_TEXTURE_2D",
    ),
    (
        nothing,
        |c| c.get_internalformati64v(GL_TEXTURE, GL_RGBA8, GL_SAMPLES, 1, &mut [0]),
        GL_INVALID_ENUM,
        "target = GL_TEXTURE",
    ),
    (
        nothing,
        |c| c.get_internalformati64v(GL_TEXTURE_2D, GL_RGBA8, GL_RGBA, 1, &mut [0]),
        GL_INVALID_ENUM,
        "pname = GL_RGBA",
    ),
    (
        nothing,
        |c| c.get_internalformati64v(GL_TEXTURE_2D, GL_RGBA8, GL_MAX_WIDTH, -1, &mut [0]),
        GL_INVALID_VALUE,
        "bufSize = -1",
    ),
    (
        nothing,
        |c| c.get_internalformativ(GL_RENDERBUFFER, GL_RGBA8, GL_RGBA, 1, &mut [0]),
        GL_INVALID_ENUM,
        "pname = GL_RGBA",
    ),
    (
        nothing,
        |c| c.get_internalformativ(GL_RENDERBUFFER, GL_RGBA8, GL_SAMPLES, -1, &mut [0]),
        GL_INVALID_VALUE,
        "bufSize = -1",
    ),
    (nothing, |c| c.bind_renderbuffer(GL_TEXTURE_2D, 1), GL_INVALID_ENUM, "target = GL_TEXTURE_2D"),
    (
        nothing,
        |c| {
            c.check_framebuffer_status(GL_RENDERBUFFER);
        },
        GL_INVALID_ENUM,
        "target = GL_RENDERBUFFER",
    ),
    (
        nothing,
        |c| c.framebuffer_renderbuffer(GL_RENDERBUFFER, C0, GL_RENDERBUFFER, 0),
        GL_INVALID_ENUM,
        "target = GL_RENDERBUFFER",
    ),
    (
        nothing,
        |c| c.framebuffer_renderbuffer(FB, GL_BACK, GL_RENDERBUFFER, 0),
        GL_INVALID_ENUM,
        "attachment = GL_BACK",
    ),
    (
        nothing,
        |c| c.framebuffer_renderbuffer(FB, C0, GL_TEXTURE_2D, 0),
        GL_INVALID_ENUM,
        "renderbuffertarget = GL_TEXTURE_2D",
    ),
    (
        nothing,
        |c| c.get_renderbuffer_parameteriv(GL_TEXTURE_2D, GL_RENDERBUFFER_WIDTH, &mut [0]),
        GL_INVALID_ENUM,
        "target = GL_TEXTURE_2D",
    ),
    (
        nothing,
        |c| c.get_renderbuffer_parameteriv(GL_RENDERBUFFER, GL_TEXTURE_WIDTH, &mut [0]),
        GL_INVALID_ENUM,
        "pname = GL_TEXTURE_WIDTH",
    ),
    (nothing, |c| c.read_buffer(GL_LESS), GL_INVALID_ENUM, "src = GL_LESS"),
    (nothing, |c| c.raster_pos_2fv(&[0.0]), GL_INVALID_OPERATION, "1 of 2 numbers"),
    (nothing, |c| c.window_pos_3iv(&[0]), GL_INVALID_OPERATION, "1 of 3 numbers"),
    (nothing, |c| c.pixel_zoom(f32::NAN, 1.0), GL_INVALID_VALUE, "xfactor = NaN"),
    (
        nothing,
        |c| c.draw_pixels(-1, 1, GL_RGB, GL_FLOAT, Data::Null),
        GL_INVALID_VALUE,
        "width = -1",
    ),
    (
        nothing,
        |c| c.draw_pixels(1, -1, GL_RGB, GL_FLOAT, Data::Null),
        GL_INVALID_VALUE,
        "height = -1",
    ),
    (
        nothing,
        |c| c.draw_pixels(1, 1, GL_COLOR, GL_FLOAT, Data::Null),
        GL_INVALID_ENUM,
        "format = GL_COLOR",
    ),
    (
        nothing,
        |c| c.draw_pixels(1, 1, GL_RGBA_INTEGER, GL_INT, Data::Bytes(&[0; 16])),
        GL_INVALID_OPERATION,
        "integers are not drawn",
    ),
    (
        nothing,
        |c| c.draw_pixels(2, 2, GL_RGBA, GL_FLOAT, Data::Bytes(&[0; 16])),
        GL_INVALID_OPERATION,
        "has 16",
    ),
    (nothing, |c| c.copy_pixels(0, 0, -1, 1, GL_COLOR), GL_INVALID_VALUE, "width = -1"),
    (nothing, |c| c.copy_pixels(0, 0, 1, -1, GL_COLOR), GL_INVALID_VALUE, "height = -1"),
    (nothing, |c| c.copy_pixels(0, 0, 1, 1, GL_RGBA), GL_INVALID_ENUM, "type = GL_RGBA"),
    (
        |c| {
            framebuffer(c);
            renderbuffer(c, C0, GL_RGBA8, 2, 2);
        },
        |c| {
            c.copy_pixels(0, 0, 1, 1, GL_STENCIL);
        },
        GL_INVALID_OPERATION,
        "no such depth or stencil",
    ),
    (nothing, |c| c.bitmap(-1, 1, 0.0, 0.0, 0.0, 0.0, Data::Null), GL_INVALID_VALUE, "width = -1"),
    (nothing, |c| c.bitmap(1, -1, 0.0, 0.0, 0.0, 0.0, Data::Null), GL_INVALID_VALUE, "height = -1"),
    (
        nothing,
        |c| c.bitmap(9, 2, 0.0, 0.0, 0.0, 0.0, Data::Bytes(&[0; 3])),
        GL_INVALID_OPERATION,
        "take 6 bytes; the memory has 3",
    ),
    (nothing, |c| blit(c, 1, GL_NEAREST), GL_INVALID_VALUE, "mask = 0x1"),
    (nothing, |c| blit(c, GL_COLOR_BUFFER_BIT, GL_LINEAR_MIPMAP_LINEAR), GL_INVALID_ENUM, "filter"),
    (nothing, |c| blit(c, GL_DEPTH_BUFFER_BIT, GL_LINEAR), GL_INVALID_OPERATION, "GL_NEAREST"),
    (
        |c| {
            multisampled(c, 4);
            c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
        },
        |c| blit(c, GL_DEPTH_BUFFER_BIT, GL_SCALED_RESOLVE_NICEST_EXT),
        GL_INVALID_OPERATION,
        "filter = GL_SCALED_RESOLVE_NICEST_EXT",
    ),
    (
        nothing,
        |c| blit(c, GL_COLOR_BUFFER_BIT, GL_SCALED_RESOLVE_FASTEST_EXT),
        GL_INVALID_OPERATION,
        "the read framebuffer has one sample a pixel",
    ),
    (
        |c| multisampled(c, 4),
        |c| blit(c, GL_COLOR_BUFFER_BIT, GL_SCALED_RESOLVE_FASTEST_EXT),
        GL_INVALID_OPERATION,
        "the draw framebuffer has several samples",
    ),
    (
        nothing,
        |c| c.framebuffer_parameteri(FB, GL_FRAMEBUFFER_DEFAULT_WIDTH, 1),
        GL_INVALID_OPERATION,
        "bind a framebuffer object",
    ),
    (
        nothing,
        |c| c.framebuffer_parameteri(GL_TEXTURE_2D, GL_FRAMEBUFFER_DEFAULT_WIDTH, 1),
        GL_INVALID_ENUM,
        "target = GL_TEXTURE_2D",
    ),
    (framebuffer, |c| c.framebuffer_parameteri(FB, GL_SAMPLES, 1), GL_INVALID_ENUM, "pname"),
    (
        framebuffer,
        |c| c.framebuffer_parameteri(FB, GL_FRAMEBUFFER_DEFAULT_HEIGHT, -1),
        GL_INVALID_VALUE,
        "param = -1 must be 0 to 8192",
    ),
    (
        framebuffer,
        |c| c.framebuffer_parameteri(FB, GL_FRAMEBUFFER_DEFAULT_SAMPLES, 5),
        GL_INVALID_VALUE,
        "param = 5 must be 0 to 4",
    ),
    (
        framebuffer,
        |c| c.framebuffer_parameteri(FB, GL_FRAMEBUFFER_DEFAULT_LAYERS, 2049),
        GL_INVALID_VALUE,
        "param = 2049 must be 0 to 2048",
    ),
    (
        nothing,
        |c| c.get_framebuffer_parameteriv(FB, GL_FRAMEBUFFER_DEFAULT_WIDTH, &mut [0]),
        GL_INVALID_OPERATION,
        "bind a framebuffer object",
    ),
    (
        framebuffer,
        |c| c.get_framebuffer_parameteriv(FB, GL_RGBA, &mut [0]),
        GL_INVALID_ENUM,
        "pname = GL_RGBA",
    ),
    (
        nothing,
        |c| c.get_framebuffer_parameteriv(GL_RGBA, GL_SAMPLES, &mut [0]),
        GL_INVALID_ENUM,
        "target = GL_RGBA",
    ),
    (
        nothing,
        |c| c.framebuffer_texture_1d(FB, C0, GL_TEXTURE_1D, 1, 0),
        GL_INVALID_OPERATION,
        "texture = 1 is no texture",
    ),
    (
        |c| {
            c.bind_texture(GL_TEXTURE_2D, 1);
            framebuffer(c);
        },
        |c| {
            c.framebuffer_texture_1d(FB, C0, GL_TEXTURE_2D, 1, 0);
        },
        GL_INVALID_ENUM,
        "must be GL_TEXTURE_1D",
    ),
    (
        |c| {
            c.bind_texture(GL_TEXTURE_2D, 1);
            framebuffer(c);
        },
        |c| {
            c.framebuffer_texture_3d(FB, C0, GL_TEXTURE_3D, 1, 0, 0);
        },
        GL_INVALID_OPERATION,
        "is a GL_TEXTURE_2D",
    ),
    (
        |c| {
            c.bind_texture(GL_TEXTURE_3D, 1);
            framebuffer(c);
        },
        |c| {
            c.framebuffer_texture_3d(FB, C0, GL_TEXTURE_3D, 1, 0, 512);
        },
        GL_INVALID_VALUE,
        "zoffset = 512 must be 0 to 511",
    ),
    (
        |c| {
            c.bind_texture(GL_TEXTURE_3D, 1);
            framebuffer(c);
        },
        |c| {
            c.framebuffer_texture_layer(FB, C0, 1, 0, -1);
        },
        GL_INVALID_VALUE,
        "layer = -1",
    ),
    (
        |c| {
            c.bind_texture(GL_TEXTURE_3D, 1);
            framebuffer(c);
        },
        |c| {
            c.framebuffer_texture_layer(FB, C0, 1, 99, 0);
        },
        GL_INVALID_VALUE,
        "level = 99",
    ),
    (
        |c| {
            c.bind_texture(GL_TEXTURE_2D, 1);
            framebuffer(c);
        },
        |c| {
            c.framebuffer_texture_layer(FB, C0, 1, 0, 0);
        },
        GL_INVALID_OPERATION,
        "has no layers",
    ),
    (
        nothing,
        |c| c.framebuffer_texture(FB, GL_DEPTH, 0, 0),
        GL_INVALID_ENUM,
        "attachment = GL_DEPTH",
    ),
    (
        nothing,
        |c| c.framebuffer_texture(GL_TEXTURE_2D, C0, 0, 0),
        GL_INVALID_ENUM,
        "target = GL_TEXTURE_2D",
    ),
    (
        framebuffer,
        |c| c.framebuffer_texture(FB, C0, 1, 0),
        GL_INVALID_VALUE,
        "texture = 1 is no texture",
    ),
    (
        |c| c.bind_texture(GL_TEXTURE_3D, 1),
        |c| c.framebuffer_texture(FB, C0, 1, 0),
        GL_INVALID_OPERATION,
        "default framebuffer",
    ),
    (
        |c| {
            c.bind_texture(GL_TEXTURE_3D, 1);
            framebuffer(c);
        },
        |c| {
            c.framebuffer_texture(FB, C0, 1, -1);
        },
        GL_INVALID_VALUE,
        "level = -1",
    ),
    (
        |c| {
            c.bind_texture(GL_TEXTURE_BUFFER, 1);
            framebuffer(c);
        },
        |c| {
            c.framebuffer_texture(FB, C0, 1, 0);
        },
        GL_INVALID_OPERATION,
        "GL_TEXTURE_BUFFER",
    ),
    (
        |c| {
            c.bind_texture(GL_TEXTURE_CUBE_MAP, 1);
            framebuffer(c);
        },
        |c| c.framebuffer_texture_layer(FB, C0, 1, 0, 6),
        GL_INVALID_VALUE,
        "layer = 6 must be 0 to 5",
    ),
    (
        nothing,
        |c| c.framebuffer_texture_layer(FB, GL_DEPTH, 0, 0, 0),
        GL_INVALID_ENUM,
        "attachment = GL_DEPTH",
    ),
    (
        nothing,
        |c| c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 5, GL_RGBA8, 1, 1),
        GL_INVALID_VALUE,
        "samples = 5 must not be above 4",
    ),
    (
        nothing,
        |c| c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 5, GL_R8UI, 1, 1),
        GL_INVALID_OPERATION,
        "samples = 5 of GL_R8UI must not be above 4",
    ),
    (
        nothing,
        |c| c.renderbuffer_storage_multisample(GL_RENDERBUFFER, -1, GL_RGBA8, 1, 1),
        GL_INVALID_VALUE,
        "samples = -1",
    ),
    (
        nothing,
        |c| c.renderbuffer_storage(GL_RENDERBUFFER, GL_COMPRESSED_RGB, 1, 1),
        GL_INVALID_ENUM,
        "GL_COMPRESSED_RGB is of numbers that nothing is drawn to",
    ),
    (
        nothing,
        |c| {
            c.get_framebuffer_attachment_parameteriv(FB, C0, GL_FRAMEBUFFER_DEFAULT, &mut [0]);
        },
        GL_INVALID_ENUM,
        "pname",
    ),
    (
        nothing,
        |c| {
            let pname = GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE;
            c.get_framebuffer_attachment_parameteriv(FB, C0, pname, &mut [0]);
        },
        GL_INVALID_ENUM,
        "of the default framebuffer",
    ),
    (
        |c| {
            framebuffer(c);
        },
        |c| {
            let pname = GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL;
            c.get_framebuffer_attachment_parameteriv(FB, C0, pname, &mut [0]);
        },
        GL_INVALID_OPERATION,
        "nothing is attached to GL_COLOR_ATTACHMENT0",
    ),
    (
        |c| multisampled(c, 0),
        |c| {
            let pname = GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL;
            c.get_framebuffer_attachment_parameteriv(FB, C0, pname, &mut [0]);
        },
        GL_INVALID_ENUM,
        "cannot be asked",
    ),
    (
        |c| multisampled(c, 4),
        |c| c.copy_pixels(0, 0, 1, 1, GL_COLOR),
        GL_INVALID_OPERATION,
        "several samples",
    ),
    (
        |c| multisampled(c, 4),
        |c| c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 1, 1, 0),
        GL_INVALID_OPERATION,
        "several samples",
    ),
    (
        |c| {
            framebuffer(c);
        },
        |c| {
            c.clear(GL_COLOR_BUFFER_BIT);
        },
        GL_INVALID_FRAMEBUFFER_OPERATION,
        "framebuffer 1 is incomplete: nothing is attached",
    ),
    (
        |c| {
            framebuffer(c);
            renderbuffer(c, C0, GL_RGBA8, 2, 2);
        },
        |c| {
            c.read_pixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_BYTE, DataOut::Bytes(&mut [0; 4]));
        },
        GL_INVALID_OPERATION,
        "has nothing attached to GL_STENCIL_ATTACHMENT",
    ),
    (
        |c| {
            framebuffer(c);
            renderbuffer(c, C0, GL_RGBA8UI, 2, 2);
        },
        |c| {
            c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_BYTE, DataOut::Bytes(&mut [0; 4]));
        },
        GL_INVALID_OPERATION,
        "integer",
    ),
];

/// A new renderbuffer at a point of the bound framebuffer.
pub(super) fn renderbuffer(
    c: &mut Context,
    point: GLenum,
    internal: GLenum,
    width: i32,
    height: i32,
) {
    let mut name = [0];
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.renderbuffer_storage(GL_RENDERBUFFER, internal, width, height);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name[0]);
}

/// A new framebuffer object, bound.
pub(super) fn framebuffer(c: &mut Context) {
    let mut name = [0];
    c.gen_framebuffers(1, &mut name);
    c.bind_framebuffer(GL_FRAMEBUFFER, name[0]);
}

/// Runs the rows.
pub fn run() {
    for (row, (prepare, call, flag, words)) in CASES.iter().enumerate() {
        let mut c = super::context();
        prepare(&mut c);
        super::row(&mut c, format!("framebuffers {row}"), call, *flag, words);
    }
}

/// A framebuffer to be made, the status it must have, and words that its message must have.
type Incomplete = (fn(&mut Context), GLenum, &'static str);

const INCOMPLETE: &[Incomplete] = &[
    (
        |_| {},
        GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT,
        "framebuffer 1 is incomplete: nothing is attached",
    ),
    (
        |c| renderbuffer(c, C0, GL_DEPTH_COMPONENT24, 2, 2),
        GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT,
        "GL_COLOR_ATTACHMENT0: a depth format cannot be a colour",
    ),
    (
        |c| renderbuffer(c, GL_DEPTH_ATTACHMENT, GL_RGBA8, 2, 2),
        GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT,
        "GL_DEPTH_ATTACHMENT: its format has no depth",
    ),
    (
        |c| renderbuffer(c, GL_DEPTH_ATTACHMENT, GL_STENCIL_INDEX8, 2, 2),
        GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT,
        "its format has no depth",
    ),
    (
        |c| renderbuffer(c, GL_STENCIL_ATTACHMENT, GL_DEPTH_COMPONENT24, 2, 2),
        GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT,
        "its format has no stencil",
    ),
    (
        |c| renderbuffer(c, C0, GL_RGBA8, 0, 2),
        GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT,
        "call glRenderbufferStorage",
    ),
    (
        |c| {
            renderbuffer(c, C0, GL_RGBA8, 2, 2);
            renderbuffer(c, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, 2, 2);
            renderbuffer(c, GL_STENCIL_ATTACHMENT, GL_STENCIL_INDEX8, 2, 2);
        },
        GL_FRAMEBUFFER_UNSUPPORTED,
        "must be one image",
    ),
    (
        |c| {
            renderbuffer(c, C0, GL_RGBA8, 2, 2);
            renderbuffer(c, C0 + 1, GL_RGBA8, 2, 2);
            c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, GL_RGBA8, 2, 2);
        },
        GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE,
        "GL_COLOR_ATTACHMENT1 has 4 samples a pixel, the attachments before have 1",
    ),
    (
        |c| {
            renderbuffer(c, C0, GL_RGBA8, 2, 2);
            c.draw_buffer(C0 + 3);
        },
        GL_FRAMEBUFFER_COMPLETE,
        "GL_COLOR_ATTACHMENT3 is drawn to",
    ),
    (
        |c| {
            renderbuffer(c, C0, GL_RGBA8, 2, 2);
            c.read_buffer(C0 + 3);
        },
        GL_FRAMEBUFFER_COMPLETE,
        "GL_COLOR_ATTACHMENT3 is read from",
    ),
    (
        |c| {
            c.bind_texture(GL_TEXTURE_2D, 5);
            c.framebuffer_texture_2d(FB, C0, GL_TEXTURE_2D, 5, 3);
        },
        GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT,
        "texture 5 has no image at level 3",
    ),
    (
        |c| {
            c.bind_texture(GL_TEXTURE_2D, 5);
            let rgba = GL_RGBA as i32;
            c.tex_image_2d(GL_TEXTURE_2D, 0, rgba, 6, 6, 1, GL_RGBA, GL_UNSIGNED_BYTE, Data::Null);
            c.framebuffer_texture_2d(FB, C0, GL_TEXTURE_2D, 5, 0);
        },
        GL_FRAMEBUFFER_UNSUPPORTED,
        "texture 5 has a border at level 0",
    ),
];

#[test]
fn an_incomplete_framebuffer_says_what_is_missing() {
    for (make, status, words) in INCOMPLETE {
        let mut c = super::context();
        framebuffer(&mut c);
        make(&mut c);
        assert_eq!(c.check_framebuffer_status(FB), *status, "{words}");
        let messages = c.messages();
        assert_eq!(c.get_error(), GL_NO_ERROR, "{messages:?}");
        let text = messages.last().expect("a message").to_string();
        assert!(text.contains(words), "{text:?} lacks {words:?}");
    }
}
