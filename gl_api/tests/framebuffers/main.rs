//! Framebuffers: attachments of every kind, completeness, stencil, clears, blits, reading back,
//! and what each call refuses.

#[path = "../common/shading.rs"]
mod shading;

mod attachments;
mod barrier;
mod blends;
mod blits;
mod clamps;
mod depth_tiles;
mod integers;
mod rectangles;
mod sample_shading;
mod sample_textures;
mod samples;
mod second_colors;
mod stencils;
mod whole;
mod without_attachments;

use gl_api::*;

/// A context with a default framebuffer of this size.
pub fn context(width: u32, height: u32) -> Context {
    Context::new(ContextDesc { width, height, ..ContextDesc::default() }).expect("a device")
}

/// Nothing was refused.
#[track_caller]
pub fn fine(c: &mut Context) {
    let messages = c.messages();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{messages:?}");
}

/// A new renderbuffer at a point of the bound framebuffer.
pub fn renderbuffer(c: &mut Context, point: GLenum, internal: GLenum, width: i32, height: i32) {
    let mut name = [0];
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.renderbuffer_storage(GL_RENDERBUFFER, internal, width, height);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name[0]);
}

/// A new framebuffer object, bound.
pub fn framebuffer(c: &mut Context) -> GLuint {
    let mut name = [0];
    c.gen_framebuffers(1, &mut name);
    c.bind_framebuffer(GL_FRAMEBUFFER, name[0]);
    name[0]
}

/// Pixels of the bound framebuffer as floats.
#[track_caller]
pub fn floats(c: &mut Context, area: [i32; 4], format: GLenum, components: usize) -> Vec<f32> {
    let [x, y, width, height] = area;
    let mut out = vec![0.0_f32; components * (width * height) as usize];
    let bytes = DataOut::Bytes(bytes_of(&mut out));
    c.read_pixels(x, y, width, height, format, GL_FLOAT, bytes);
    fine(c);
    out
}

/// Pixels of the bound framebuffer as bytes.
#[track_caller]
pub fn bytes(c: &mut Context, area: [i32; 4], format: GLenum, components: usize) -> Vec<u8> {
    let [x, y, width, height] = area;
    c.pixel_storei(GL_PACK_ALIGNMENT, 1);
    let mut out = vec![0; components * (width * height) as usize];
    c.read_pixels(x, y, width, height, format, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut out));
    fine(c);
    out
}

/// Numbers as the memory that a call writes to.
pub fn bytes_of<T: bytemuck::Pod>(values: &mut [T]) -> &mut [u8] {
    bytemuck::cast_slice_mut(values)
}

/// A rectangle in normalized device coordinates at a depth, counter-clockwise.
pub fn rectangle(c: &mut Context, [x0, y0, x1, y1]: [f32; 4], z: f32) {
    c.begin(GL_QUADS);
    for [x, y] in [[x0, y0], [x1, y0], [x1, y1], [x0, y1]] {
        c.vertex_3f(x, y, z);
    }
    c.end();
}

/// The whole view volume.
pub const ALL: [f32; 4] = [-1.0, -1.0, 1.0, 1.0];
