//! What can be bound, one row a place: how an object comes to be there, and how it shows.

use super::{CORNERS, SIZE, color_of, integer, quad, shading};
use gl_api::*;

/// A place that objects are bound to.
pub struct Kind {
    pub name: &'static str,
    /// A new name.
    pub new: fn(&mut Context) -> GLuint,
    /// Binds the name in a context; for what is made so, makes the object of this number.
    pub fill: fn(&mut Context, GLuint, u8),
    /// The number of the object that is bound, by what is drawn or read with it.
    pub number: fn(&mut Context) -> u8,
    /// The name that the context says is bound.
    pub bound: fn(&mut Context) -> GLuint,
    pub delete: fn(&mut Context, GLuint),
    pub exists: fn(&mut Context, GLuint) -> bool,
}

fn one(generate: impl FnOnce(&mut [GLuint])) -> GLuint {
    let mut name = [0];
    generate(&mut name);
    name[0]
}

fn new_buffer(c: &mut Context) -> GLuint {
    one(|name| c.gen_buffers(1, name))
}

fn delete_buffer(c: &mut Context, name: GLuint) {
    c.delete_buffers(1, &[name]);
}

fn buffer_of(c: &mut Context, target: GLenum, name: GLuint, bytes: &[u8]) {
    c.bind_buffer(target, name);
    c.buffer_data(target, bytes.len() as isize, Data::Bytes(bytes), GL_STATIC_DRAW);
}

/// Bytes for an array, which vertex array objects read from buffers only.
fn array_of(c: &mut Context, name: GLuint, bytes: &[u8]) {
    buffer_of(c, GL_ARRAY_BUFFER, name, bytes);
}

fn new_texture(c: &mut Context) -> GLuint {
    one(|name| c.gen_textures(1, name))
}

fn delete_texture(c: &mut Context, name: GLuint) {
    c.delete_textures(1, &[name]);
}

/// A texture of one texel.
pub fn texture_of(c: &mut Context, name: GLuint, number: u8) {
    c.bind_texture(GL_TEXTURE_2D, name);
    let texel = Data::Bytes(&[number, 0, 0, 255]);
    c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
}

/// The red that the textured window has.
fn textured(c: &mut Context) -> u8 {
    c.enable(GL_TEXTURE_2D);
    let [red, ..] = color_of(c, quad);
    c.disable(GL_TEXTURE_2D);
    red
}

/// Draws with an array of colours that is set already.
pub fn colored(c: &mut Context) -> u8 {
    array_of(c, 900, bytemuck::cast_slice(&CORNERS));
    c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.bind_buffer(GL_ARRAY_BUFFER, 0);
    let [red, ..] = color_of(c, |c| c.draw_arrays(GL_QUADS, 0, 4));
    red
}

/// An array of colours that are all alike.
pub fn colors_of(c: &mut Context, name: GLuint, number: u8) {
    buffer_of(c, GL_ARRAY_BUFFER, name, &[number; 16]);
    c.color_pointer(4, GL_UNSIGNED_BYTE, 0, Data::Offset(0));
    c.enable_client_state(GL_COLOR_ARRAY);
    c.bind_buffer(GL_ARRAY_BUFFER, 0);
}

/// The first byte of the buffer that is bound to a target.
fn first_byte(c: &mut Context, target: GLenum) -> u8 {
    let mut byte = [0];
    c.get_buffer_sub_data(target, 0, 1, DataOut::Bytes(&mut byte));
    byte[0]
}

const BLOCK: &str = "#version 140\nlayout(std140) uniform B { float red; }; out vec4 color; \
                     void main() { color = vec4(red, 0.0, 0.0, 1.0); }";
const TEXELS: &str = "#version 140\nuniform samplerBuffer s; out vec4 color; \
                      void main() { color = texelFetch(s, 0); }";
const THROUGH: &str = "#version 140\nin vec4 at; void main() { gl_Position = at; }";

/// The red that a program's fragment shader makes.
fn shaded(c: &mut Context, fragment: &str) -> u8 {
    let program = shading::use_program(c, THROUGH, fragment);
    let at = c.get_attrib_location(program, "at") as GLuint;
    c.vertex_attrib_pointer(at, 2, GL_FLOAT, false, 0, CORNERS.as_slice().arg());
    c.enable_vertex_attrib_array(at);
    let [red, ..] = color_of(c, |c| c.draw_arrays(GL_QUADS, 0, 4));
    c.disable_vertex_attrib_array(at);
    c.use_program(0);
    c.delete_program(program);
    red
}

fn indexed(c: &mut Context) -> u8 {
    // The four corners at the first index: the buffer says which of the colours it is.
    let colors: Vec<u8> = (0..=255).flat_map(|number| [number, 0, 0, 255]).collect();
    array_of(c, 901, &colors);
    c.color_pointer(4, GL_UNSIGNED_BYTE, 0, Data::Offset(0));
    array_of(c, 902, bytemuck::cast_slice(&[[0.0_f32; 2]; 256]));
    c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
    c.bind_buffer(GL_ARRAY_BUFFER, 0);
    c.enable_client_state(GL_COLOR_ARRAY);
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.point_size(4.0 * SIZE as f32);
    let [red, ..] =
        color_of(c, |c| c.draw_elements(GL_POINTS, 1, GL_UNSIGNED_BYTE, Data::Offset(0)));
    c.disable_client_state(GL_COLOR_ARRAY);
    c.disable_client_state(GL_VERTEX_ARRAY);
    red
}

pub const KINDS: &[Kind] = &[
    Kind {
        name: "an array of vertices",
        new: new_buffer,
        fill: colors_of,
        number: colored,
        bound: |c| integer(c, GL_COLOR_ARRAY_BUFFER_BINDING),
        delete: delete_buffer,
        exists: Context::is_buffer,
    },
    Kind {
        name: "GL_ELEMENT_ARRAY_BUFFER",
        new: new_buffer,
        fill: |c, name, number| buffer_of(c, GL_ELEMENT_ARRAY_BUFFER, name, &[number; 4]),
        number: indexed,
        bound: |c| integer(c, GL_ELEMENT_ARRAY_BUFFER_BINDING),
        delete: delete_buffer,
        exists: Context::is_buffer,
    },
    Kind {
        name: "GL_ARRAY_BUFFER",
        new: new_buffer,
        fill: |c, name, number| buffer_of(c, GL_ARRAY_BUFFER, name, &[number; 4]),
        number: |c| first_byte(c, GL_ARRAY_BUFFER),
        bound: |c| integer(c, GL_ARRAY_BUFFER_BINDING),
        delete: delete_buffer,
        exists: Context::is_buffer,
    },
    Kind {
        name: "GL_PIXEL_UNPACK_BUFFER",
        new: new_buffer,
        fill: |c, name, number| {
            let bytes = [number; 4 * (SIZE * SIZE) as usize];
            buffer_of(c, GL_PIXEL_UNPACK_BUFFER, name, &bytes);
        },
        number: |c| {
            c.window_pos_2i(0, 0);
            let size = SIZE as GLsizei;
            let draw = |c: &mut Context| {
                c.draw_pixels(size, size, GL_RGBA, GL_UNSIGNED_BYTE, Data::Offset(0));
            };
            color_of(c, draw)[0]
        },
        bound: |c| integer(c, GL_PIXEL_UNPACK_BUFFER_BINDING),
        delete: delete_buffer,
        exists: Context::is_buffer,
    },
    Kind {
        name: "a uniform block",
        new: new_buffer,
        fill: |c, name, number| {
            let red = f32::from(number) / 255.0;
            buffer_of(c, GL_UNIFORM_BUFFER, name, &red.to_le_bytes());
            c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, name);
        },
        number: |c| shaded(c, BLOCK),
        bound: |c| {
            let mut name = [0];
            c.get_integeri_v(GL_UNIFORM_BUFFER_BINDING, 0, &mut name);
            name[0] as GLuint
        },
        delete: delete_buffer,
        exists: Context::is_buffer,
    },
    Kind {
        name: "GL_TEXTURE_2D",
        new: new_texture,
        fill: texture_of,
        number: textured,
        bound: |c| integer(c, GL_TEXTURE_BINDING_2D),
        delete: delete_texture,
        exists: Context::is_texture,
    },
    Kind {
        name: "GL_TEXTURE_BUFFER",
        new: new_texture,
        fill: |c, name, number| {
            c.bind_texture(GL_TEXTURE_BUFFER, name);
            let buffer = new_buffer(c);
            buffer_of(c, GL_TEXTURE_BUFFER, buffer, &[number; 4]);
            c.tex_buffer(GL_TEXTURE_BUFFER, GL_RGBA8, buffer);
            // The texture has it.
            delete_buffer(c, buffer);
        },
        number: |c| shaded(c, TEXELS),
        bound: |c| integer(c, GL_TEXTURE_BINDING_BUFFER),
        delete: delete_texture,
        exists: Context::is_texture,
    },
    Kind {
        name: "a sampler",
        new: |c| one(|name| c.gen_samplers(1, name)),
        // Outside of the texture is the border, whose red is the number.
        fill: |c, name, number| {
            let border = [f32::from(number) / 255.0, 0.0, 0.0, 1.0];
            c.sampler_parameterfv(name, GL_TEXTURE_BORDER_COLOR, &border);
            for (pname, value) in [
                (GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER),
                (GL_TEXTURE_MIN_FILTER, GL_NEAREST),
                (GL_TEXTURE_MAG_FILTER, GL_NEAREST),
            ] {
                c.sampler_parameteri(name, pname, value as i32);
            }
            c.bind_sampler(0, name);
        },
        number: |c| {
            let texture = new_texture(c);
            texture_of(c, texture, 255);
            c.tex_coord_2f(2.0, 0.5);
            let number = textured(c);
            delete_texture(c, texture);
            number
        },
        bound: |c| integer(c, GL_SAMPLER_BINDING),
        delete: |c, name| c.delete_samplers(1, &[name]),
        exists: Context::is_sampler,
    },
    Kind {
        name: "GL_RENDERBUFFER",
        new: |c| one(|name| c.gen_renderbuffers(1, name)),
        fill: |c, name, number| {
            c.bind_renderbuffer(GL_RENDERBUFFER, name);
            c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, number.into(), 1);
        },
        number: |c| {
            let mut width = [0];
            c.get_renderbuffer_parameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &mut width);
            width[0] as u8
        },
        bound: |c| integer(c, GL_RENDERBUFFER_BINDING),
        delete: |c, name| c.delete_renderbuffers(1, &[name]),
        exists: Context::is_renderbuffer,
    },
    Kind {
        name: "an assembly program",
        new: |c| one(|name| c.gen_programs(1, name)),
        fill: |c, name, number| {
            c.bind_program(GL_FRAGMENT_PROGRAM_ARB, name);
            let text = "!!ARBfp1.0\nMOV result.color, program.local[0];\nEND";
            let length = text.len() as GLsizei;
            c.program_string(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, length, text);
            let red = f32::from(number) / 255.0;
            c.program_local_parameter_4f(GL_FRAGMENT_PROGRAM_ARB, 0, red, 0.0, 0.0, 1.0);
        },
        number: |c| {
            c.enable(GL_FRAGMENT_PROGRAM_ARB);
            let [red, ..] = color_of(c, quad);
            c.disable(GL_FRAGMENT_PROGRAM_ARB);
            red
        },
        bound: |c| {
            let mut name = [0];
            c.get_assembly_programiv(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_BINDING_ARB, &mut name);
            name[0] as GLuint
        },
        delete: |c, name| c.delete_programs(1, &[name]),
        exists: Context::is_assembly_program,
    },
];
