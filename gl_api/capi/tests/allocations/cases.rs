//! The calls, what precedes each, and the state that it changes.

use gl_api::*;
use std::sync::LazyLock;

/// A call that needs much memory.
pub struct Case {
    pub name: &'static str,
    pub prepare: fn(&mut Context),
    pub call: fn(&mut Context),
    /// What the call changes.
    pub state: fn(&mut Context) -> Vec<i64>,
}

const SIDE: GLsizei = 256;
/// Bytes of an image of this side.
const BYTES: usize = (SIDE * SIDE * 4) as usize;
const T2: GLenum = GL_TEXTURE_2D;
const ARRAY: GLenum = GL_ARRAY_BUFFER;

fn nothing(_: &mut Context) {}

/// What the calls read: made before an allocation fails.
pub struct Memory {
    bytes: Vec<u8>,
    corners: Vec<f32>,
    indices: Vec<u8>,
    source: String,
    /// Numbers of lists, all 200.
    numbers: Vec<u8>,
}

/// What the calls read.
pub static MEMORY: LazyLock<Memory> = LazyLock::new(|| Memory {
    bytes: (0..BYTES + 64).map(|at| (at * at / 7 + at) as u8).collect(),
    // Triangles that cover all.
    corners: [-1.0_f32, -1.0, 3.0, -1.0, -1.0, 3.0].repeat(4096),
    indices: (0..3_u32 << 13).flat_map(|at| (at % 3).to_le_bytes()).collect(),
    source: format!("void main() {{ gl_Position = gl_Vertex; }} //{}", "x".repeat(BYTES)),
    numbers: vec![200; BYTES / 4],
});

/// Bytes that differ.
pub fn pattern(seed: usize) -> &'static [u8] {
    &MEMORY.bytes[seed..][..BYTES]
}

fn upload(c: &mut Context, level: GLint, side: GLsizei, seed: usize) {
    let texels = pattern(seed);
    let data = Data::Bytes(texels);
    c.tex_image_2d(T2, level, GL_RGBA8 as GLint, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
}

pub fn sum(bytes: &[u8]) -> i64 {
    bytes.iter().fold(17, |sum: i64, &byte| sum.wrapping_mul(31).wrapping_add(byte.into()))
}

/// The width of level 0 and of level 1, the format, and all texels of level 0.
fn texture(c: &mut Context) -> Vec<i64> {
    let mut all = Vec::new();
    for level in 0..2 {
        for name in [GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_INTERNAL_FORMAT] {
            let mut value = [0];
            c.get_tex_level_parameteriv(T2, level, name, &mut value);
            all.push(value[0].into());
        }
    }
    if all[0] > 0 {
        let mut texels = vec![0; (all[0] * all[1] * 4) as usize];
        c.get_tex_image(T2, 0, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut texels));
        all.push(sum(&texels));
    }
    all
}

/// The size, the usage and the bytes of the bound buffer.
fn buffer(c: &mut Context) -> Vec<i64> {
    let mut all = Vec::new();
    for name in [GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_MAPPED] {
        let mut value = [0];
        c.get_buffer_parameteriv(ARRAY, name, &mut value);
        all.push(i64::from(value[0]));
    }
    if all[2] == 0 {
        let mut bytes = vec![0; all[0] as usize];
        c.get_buffer_sub_data(ARRAY, 0, all[0] as GLsizeiptr, DataOut::Bytes(&mut bytes));
        all.push(sum(&bytes));
    }
    all
}

fn small_buffer(c: &mut Context) {
    let mut name = [0];
    c.gen_buffers(1, &mut name);
    c.bind_buffer(ARRAY, name[0]);
    c.buffer_data(ARRAY, 4, Data::Bytes(&[1, 2, 3, 4]), GL_STREAM_READ);
}

fn large_buffer(c: &mut Context) {
    small_buffer(c);
    c.buffer_data(ARRAY, BYTES as GLsizeiptr, Data::Bytes(pattern(3)), GL_STATIC_DRAW);
}

fn two_buffers(c: &mut Context) {
    large_buffer(c);
    c.bind_buffer(GL_COPY_READ_BUFFER, 1);
    small_buffer(c);
    c.buffer_data(ARRAY, BYTES as GLsizeiptr, Data::Bytes(pattern(9)), GL_STATIC_DRAW);
}

fn renderbuffer(c: &mut Context) -> Vec<i64> {
    let names = [GL_RENDERBUFFER_WIDTH, GL_RENDERBUFFER_INTERNAL_FORMAT, GL_RENDERBUFFER_SAMPLES];
    names
        .map(|name| {
            let mut value = [0];
            c.get_renderbuffer_parameteriv(GL_RENDERBUFFER, name, &mut value);
            value[0].into()
        })
        .to_vec()
}

/// A draw that changes nothing, recorded and not submitted.
fn draw_unseen(c: &mut Context) {
    c.color_mask(false, false, false, false);
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.draw_arrays(GL_POINTS, 0, 3);
    c.disable_client_state(GL_VERTEX_ARRAY);
    c.color_mask(true, true, true, true);
}

fn a_renderbuffer(c: &mut Context) {
    let mut name = [0];
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA4, 8, 8);
}

/// What the list draws, and what it leaves of the texture: a call that it has no memory for is not in it.
fn list(c: &mut Context) -> Vec<i64> {
    c.call_list(1);
    let mut all = texture(c);
    all.extend(drawn(c));
    all
}

/// The sum of the whole picture: of calls that draw.
fn drawn(c: &mut Context) -> Vec<i64> {
    let mut pixels = vec![0; 64 * 64 * 4];
    c.read_pixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
    vec![sum(&pixels)]
}

fn draw_pixels(c: &mut Context) {
    let bytes = pattern(1);
    c.raster_pos_2f(-1.0, -1.0);
    c.draw_pixels(SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(bytes));
}

fn compile_list(c: &mut Context, call: fn(&mut Context)) {
    c.new_list(1, GL_COMPILE);
    call(c);
    c.end_list();
}

fn client_arrays(c: &mut Context) {
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.color_3f(0.0, 1.0, 0.5);
    c.vertex_pointer(2, GL_FLOAT, 0, MEMORY.corners.as_slice().arg());
    c.draw_arrays(GL_TRIANGLES, 0, 3 * 4096);
    c.disable_client_state(GL_VERTEX_ARRAY);
}

fn client_indices(c: &mut Context) {
    let corners = [-1.0_f32, -1.0, 3.0, -1.0, -1.0, 3.0];
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.color_3f(0.0, 1.0, 0.5);
    c.vertex_pointer(2, GL_FLOAT, 0, corners.as_slice().arg());
    c.draw_elements(GL_TRIANGLES, 3 << 13, GL_UNSIGNED_INT, Data::Bytes(&MEMORY.indices));
    c.disable_client_state(GL_VERTEX_ARRAY);
}

/// Each row: name, what precedes, the call, the state.
pub type Row = (&'static str, fn(&mut Context), fn(&mut Context), fn(&mut Context) -> Vec<i64>);

pub const fn row((name, prepare, call, state): Row) -> Case {
    Case { name, prepare, call, state }
}

pub const CASES: &[Case] = &[
    row(("glTexImage2D", |c| upload(c, 0, 4, 0), |c| upload(c, 0, SIDE, 5), texture)),
    row((
        "glTexImage2D without texels",
        |c| upload(c, 0, 4, 0),
        |c| {
            let rgba = GL_RGBA8 as GLint;
            c.tex_image_2d(T2, 0, rgba, SIDE, SIDE, 0, GL_RGBA, GL_UNSIGNED_BYTE, Data::Null);
        },
        texture,
    )),
    row((
        "glTexImage2D, converted",
        |c| upload(c, 0, 4, 0),
        |c| {
            let texels = pattern(2);
            let data = Data::Bytes(texels);
            c.pixel_transferf(GL_RED_SCALE, 0.5);
            c.tex_image_2d(T2, 0, GL_RGB16 as GLint, 128, 128, 0, GL_RGBA, GL_SHORT, data);
            c.pixel_transferf(GL_RED_SCALE, 1.0);
        },
        texture,
    )),
    row((
        "glTexSubImage2D",
        |c| {
            upload(c, 0, SIDE, 0);
            c.tex_parameteri(T2, GL_TEXTURE_MIN_FILTER, GL_LINEAR as GLint);
        },
        |c| {
            let data = Data::Bytes(pattern(7));
            c.enable(T2);
            c.color_mask(false, false, false, false);
            c.rectf(0.0, 0.0, 1.0, 1.0);
            c.color_mask(true, true, true, true);
            c.disable(T2);
            c.tex_sub_image_2d(T2, 0, 0, 0, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, data);
        },
        texture,
    )),
    row((
        "glTexStorage2D",
        |c| c.bind_texture(T2, 1),
        |c| c.tex_storage_2d(T2, 5, GL_RGBA8, SIDE, SIDE),
        |c| texture(c)[..6].to_vec(),
    )),
    row((
        "glGenerateMipmap",
        |c| upload(c, 0, SIDE, 0),
        |c| c.generate_mipmap(T2),
        |c| texture(c)[..6].to_vec(),
    )),
    row((
        "glCompressedTexImage2D",
        |c| upload(c, 0, 4, 0),
        |c| {
            let (texels, internal) = (pattern(1), GL_COMPRESSED_RGBA_S3TC_DXT5_EXT);
            let blocks = Data::Bytes(&texels[..BYTES / 4]);
            let size = (SIDE * SIDE) as GLsizei;
            c.compressed_tex_image_2d(T2, 0, internal, SIDE, SIDE, 0, size, blocks);
        },
        texture,
    )),
    row((
        "glCopyTexImage2D",
        |c| upload(c, 0, 4, 0),
        |c| c.copy_tex_image_2d(T2, 0, GL_RGBA32F, 0, 0, 64, 64, 0),
        texture,
    )),
    row((
        "glTexImage3D",
        nothing,
        |c| {
            let texels = pattern(1);
            let (rgba, data) = (GL_RGBA8 as GLint, Data::Bytes(texels));
            c.tex_image_3d(GL_TEXTURE_3D, 0, rgba, 32, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
        },
        |c| {
            let mut value = [0];
            c.get_tex_level_parameteriv(GL_TEXTURE_3D, 0, GL_TEXTURE_DEPTH, &mut value);
            vec![value[0].into()]
        },
    )),
    row((
        "glBufferData",
        small_buffer,
        |c| c.buffer_data(ARRAY, BYTES as GLsizeiptr, Data::Bytes(pattern(3)), GL_STATIC_DRAW),
        buffer,
    )),
    row((
        "glBufferData without bytes",
        small_buffer,
        |c| c.buffer_data(ARRAY, BYTES as GLsizeiptr, Data::Null, GL_STATIC_DRAW),
        buffer,
    )),
    row((
        "glBufferStorage",
        small_buffer,
        |c| c.buffer_storage(ARRAY, BYTES as GLsizeiptr, Data::Null, GL_MAP_READ_BIT),
        buffer,
    )),
    row((
        "glBufferSubData while a draw reads",
        |c| {
            large_buffer(c);
            c.vertex_pointer(2, GL_SHORT, 0, Data::Offset(0));
        },
        |c| {
            draw_unseen(c);
            c.buffer_sub_data(ARRAY, 0, BYTES as GLsizeiptr, Data::Bytes(pattern(4)));
        },
        buffer,
    )),
    row((
        "glCopyBufferSubData while a draw reads",
        |c| {
            two_buffers(c);
            c.vertex_pointer(2, GL_SHORT, 0, Data::Offset(0));
        },
        |c| {
            draw_unseen(c);
            c.copy_buffer_sub_data(GL_COPY_READ_BUFFER, ARRAY, 0, 0, BYTES as GLsizeiptr);
        },
        buffer,
    )),
    row((
        "glRenderbufferStorage",
        a_renderbuffer,
        |c| c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, SIDE, SIDE),
        renderbuffer,
    )),
    row((
        "glRenderbufferStorageMultisample",
        a_renderbuffer,
        |c| c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, GL_DEPTH24_STENCIL8, SIDE, SIDE),
        renderbuffer,
    )),
    row(("glDrawPixels in a list", nothing, |c| compile_list(c, draw_pixels), list)),
    row(("glTexImage2D in a list", nothing, |c| compile_list(c, |c| upload(c, 0, SIDE, 5)), list)),
    row(("glDrawArrays of client arrays", nothing, client_arrays, drawn)),
    row(("glDrawElements of client indices", nothing, client_indices, drawn)),
    row(("glDrawArrays in a list", nothing, |c| compile_list(c, client_arrays), list)),
    row((
        "glShaderSource",
        |c| {
            c.create_shader(GL_VERTEX_SHADER);
        },
        |c| {
            c.shader_source(1, 1, Strings(vec![&MEMORY.source]), &[]);
        },
        |c| {
            let mut value = [0];
            c.get_shaderiv(1, GL_SHADER_SOURCE_LENGTH, &mut value);
            vec![value[0].into()]
        },
    )),
    row((
        "glTexImage1D",
        nothing,
        |c| {
            let (format, data) = (GL_RGBA32F as GLint, Data::Bytes(pattern(1)));
            c.tex_image_1d(GL_TEXTURE_1D, 0, format, 8192, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
        },
        |c| width_of(c, GL_TEXTURE_1D),
    )),
    row((
        "glTexSubImage3D while a draw reads",
        |c| {
            let (rgba, null) = (GL_RGBA8 as GLint, Data::Null);
            c.tex_image_3d(GL_TEXTURE_3D, 0, rgba, 32, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, null);
            c.tex_parameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR as GLint);
        },
        |c| {
            draw_unseen_textured(c, GL_TEXTURE_3D);
            let (data, ty) = (Data::Bytes(pattern(7)), GL_UNSIGNED_BYTE);
            c.tex_sub_image_3d(GL_TEXTURE_3D, 0, 0, 0, 0, 32, 32, 32, GL_RGBA, ty, data);
        },
        |c| {
            let mut texels = vec![0; 32 * 32 * 32 * 4];
            let to = DataOut::Bytes(&mut texels);
            c.get_tex_image(GL_TEXTURE_3D, 0, GL_RGBA, GL_UNSIGNED_BYTE, to);
            vec![sum(&texels)]
        },
    )),
    row((
        "glTexStorage3D",
        |c| c.bind_texture(GL_TEXTURE_3D, 1),
        |c| c.tex_storage_3d(GL_TEXTURE_3D, 3, GL_RGBA8, 64, 64, 64),
        |c| width_of(c, GL_TEXTURE_3D),
    )),
    row((
        "glCompressedTexSubImage2D while a draw reads",
        |c| {
            let (internal, size) = (GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, SIDE * SIDE);
            let blocks = Data::Bytes(&pattern(1)[..BYTES / 4]);
            c.compressed_tex_image_2d(T2, 0, internal, SIDE, SIDE, 0, size, blocks);
            c.tex_parameteri(T2, GL_TEXTURE_MIN_FILTER, GL_LINEAR as GLint);
        },
        |c| {
            draw_unseen_textured(c, T2);
            let (internal, size) = (GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, SIDE * SIDE);
            let blocks = Data::Bytes(&pattern(9)[..BYTES / 4]);
            c.compressed_tex_sub_image_2d(T2, 0, 0, 0, SIDE, SIDE, internal, size, blocks);
        },
        texture,
    )),
    row((
        "glTexImage2DMultisample",
        nothing,
        |c| c.tex_image_2d_multisample(GL_TEXTURE_2D_MULTISAMPLE, 4, GL_RGBA8, 128, 128, true),
        |c| width_of(c, GL_TEXTURE_2D_MULTISAMPLE),
    )),
    row((
        "glDrawPixels, converted and zoomed",
        |c| {
            c.pixel_transferf(GL_RED_SCALE, 0.5);
            c.pixel_zoom(0.25, 0.25);
        },
        draw_pixels,
        drawn,
    )),
    row((
        "glCopyPixels",
        |c| {
            into_renderbuffer(c, 256);
            c.clear_color(0.5, 0.25, 1.0, 1.0);
            c.clear(GL_COLOR_BUFFER_BIT);
            c.rectf(-1.0, -1.0, 0.0, 0.5);
            c.raster_pos_2f(0.0, 0.0);
        },
        |c| c.copy_pixels(0, 0, 256, 256, GL_COLOR),
        |c| seen(c, 256),
    )),
    row((
        "glMapBufferRange while a draw reads",
        |c| {
            large_buffer(c);
            c.vertex_pointer(2, GL_SHORT, 0, Data::Offset(0));
        },
        |c| {
            draw_unseen(c);
            let access = GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT;
            if !c.map_buffer_range(ARRAY, 0, BYTES as GLsizeiptr, access).is_null() {
                c.unmap_buffer(ARRAY);
                c.buffer_sub_data(ARRAY, 0, 4, Data::Bytes(&[9; 4]));
            }
        },
        buffer,
    )),
    row((
        "glClearBufferSubData while a draw reads",
        |c| {
            large_buffer(c);
            c.vertex_pointer(2, GL_SHORT, 0, Data::Offset(0));
        },
        |c| {
            draw_unseen(c);
            let (red, one) = (GL_RED, Data::Bytes(&[9]));
            c.clear_buffer_sub_data(
                ARRAY,
                GL_R8,
                0,
                BYTES as GLsizeiptr,
                red,
                GL_UNSIGNED_BYTE,
                one,
            );
        },
        buffer,
    )),
    row((
        "glVertex",
        |c| c.color_3f(0.0, 1.0, 0.5),
        |c| {
            c.begin(GL_TRIANGLE_STRIP);
            for corner in MEMORY.corners.chunks_exact(2) {
                c.vertex_2f(corner[0], corner[1]);
            }
            c.end();
        },
        drawn,
    )),
    row((
        "glVertex in a list",
        nothing,
        |c| {
            compile_list(c, |c| {
                c.color_3f(0.0, 1.0, 0.5);
                c.begin(GL_TRIANGLE_STRIP);
                for corner in MEMORY.corners.chunks_exact(2) {
                    c.vertex_2f(corner[0], corner[1]);
                }
                c.end();
            });
        },
        list,
    )),
    row((
        "glCallLists in a list",
        |c| {
            c.new_list(200, GL_COMPILE);
            c.color_3f(0.0, 1.0, 0.5);
            c.rectf(-1.0, -1.0, 1.0, 1.0);
            c.end_list();
        },
        |c| {
            compile_list(c, |c| {
                c.call_lists(BYTES as GLsizei / 4, GL_UNSIGNED_BYTE, Data::Bytes(&MEMORY.numbers))
            })
        },
        list,
    )),
];

/// The width of level 0.
fn width_of(c: &mut Context, target: GLenum) -> Vec<i64> {
    let mut value = [0];
    c.get_tex_level_parameteriv(target, 0, GL_TEXTURE_WIDTH, &mut value);
    vec![value[0].into()]
}

/// As [`draw_unseen`], textured.
pub fn draw_unseen_textured(c: &mut Context, target: GLenum) {
    c.enable(target);
    c.color_mask(false, false, false, false);
    c.rectf(0.0, 0.0, 1.0, 1.0);
    c.color_mask(true, true, true, true);
    c.disable(target);
}

/// Draws to a renderbuffer of its own.
fn into_renderbuffer(c: &mut Context, side: GLsizei) {
    let mut names = [0; 2];
    let (renderbuffers, framebuffers) = names.split_at_mut(1);
    c.gen_renderbuffers(1, renderbuffers);
    c.gen_framebuffers(1, framebuffers);
    c.bind_renderbuffer(GL_RENDERBUFFER, names[0]);
    c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, side, side);
    c.bind_framebuffer(GL_FRAMEBUFFER, names[1]);
    let (target, point) = (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0);
    c.framebuffer_renderbuffer(target, point, GL_RENDERBUFFER, names[0]);
}

/// The sum of the pixels of the framebuffer that is drawn to.
fn seen(c: &mut Context, side: GLsizei) -> Vec<i64> {
    let mut pixels = vec![0; (side * side * 4) as usize];
    c.read_pixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
    vec![sum(&pixels)]
}
