//! Contexts, shaders, arrays and textures for the rows of both tables.

use super::shading::use_program;
use gl_api::*;

pub fn context() -> Context {
    Context::new(ContextDesc { width: 16, height: 8, ..ContextDesc::default() }).expect("a device")
}

/// A triangle over the whole picture.
pub fn triangle(c: &mut Context) {
    c.begin(GL_TRIANGLES);
    for [x, y] in [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]] {
        c.tex_coord_2f(x, y);
        c.vertex_2f(x, y);
    }
    c.end();
}

/// A vertex shader of one attribute at location 0, `pos`.
pub const VERTEX: &str = "#version 120\nattribute vec2 pos; varying vec2 uv;\n\
    void main() { uv = pos; gl_Position = vec4(pos, 0.0, 1.0); }";
pub const WHITE: &str = "#version 120\nvoid main() { gl_FragColor = vec4(1.0); }";
/// A fragment shader that looks a texture up.
pub const TEXTURED: &str = "#version 120\nuniform sampler2D s; varying vec2 uv;\n\
    void main() { gl_FragColor = texture2D(s, uv); }";
/// One that compares a depth.
pub const SHADOWED: &str = "#version 120\nuniform sampler2DShadow s; varying vec2 uv;\n\
    void main() { gl_FragColor = shadow2D(s, vec3(uv, 0.5)); }";

/// Puts [`VERTEX`] and a fragment shader in use.
pub fn shaded(c: &mut Context, fragment: &str) -> GLuint {
    use_program(c, VERTEX, fragment)
}

/// Sets a uniform of the program in use.
pub fn set(c: &mut Context, program: GLuint, name: &str, value: GLint) {
    let location = c.get_uniform_location(program, name);
    c.uniform_1i(location, value);
}

/// The bytes of numbers.
pub fn bytes(numbers: &[f32]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_ne_bytes()).collect()
}

/// A buffer of so many bytes, bound to `GL_ARRAY_BUFFER`.
pub fn buffer(c: &mut Context, name: GLuint, size: GLsizeiptr) {
    c.bind_buffer(GL_ARRAY_BUFFER, name);
    c.buffer_data(GL_ARRAY_BUFFER, size, Data::Null, GL_STATIC_DRAW);
}

/// An array of floats, from the first byte of the bound buffer on.
pub fn array(c: &mut Context, location: GLuint, size: GLint) {
    c.enable_vertex_attrib_array(location);
    c.vertex_attrib_pointer(location, size, GL_FLOAT, false, 0, Data::Offset(0));
}

/// Attribute 0 of [`triangle`]'s positions.
pub fn positions(c: &mut Context) {
    let positions = bytes(&[-1.0, -1.0, 3.0, -1.0, -1.0, 3.0]);
    c.bind_buffer(GL_ARRAY_BUFFER, 0);
    c.enable_vertex_attrib_array(0);
    c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 0, Data::Bytes(&positions));
}

/// Draws the three vertices of the arrays.
pub fn draw(c: &mut Context) {
    c.draw_arrays(GL_TRIANGLES, 0, 3);
}

/// Texels of every format of [`texture`].
const TEXELS: [u8; 64] = [63; 64];

/// A texture of 4×4 texels, bound to `GL_TEXTURE_2D` of the active unit, that is not mipmapped.
pub fn texture(c: &mut Context, name: GLuint, format: GLenum) {
    let (pixels, ty) = match format {
        GL_DEPTH_COMPONENT => (GL_DEPTH_COMPONENT, GL_FLOAT),
        _ => (GL_RGBA, GL_UNSIGNED_BYTE),
    };
    c.bind_texture(GL_TEXTURE_2D, name);
    c.tex_image_2d(GL_TEXTURE_2D, 0, format as GLint, 4, 4, 0, pixels, ty, Data::Bytes(&TEXELS));
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
}

/// Draws to a level of a texture.
pub fn draw_to(c: &mut Context, point: GLenum, texture: GLuint, level: GLint) {
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture, level);
}

/// Draws to a texture of its own, 1, and nothing else.
pub fn draw_to_color(c: &mut Context) {
    texture(c, 1, GL_RGBA);
    draw_to(c, GL_COLOR_ATTACHMENT0, 1, 0);
    c.bind_texture(GL_TEXTURE_2D, 0);
}

/// Draws to a depth texture of its own, 1, and nothing else.
pub fn draw_to_depth(c: &mut Context) {
    texture(c, 1, GL_DEPTH_COMPONENT);
    draw_to(c, GL_DEPTH_ATTACHMENT, 1, 0);
    c.draw_buffer(GL_NONE);
    c.read_buffer(GL_NONE);
    c.bind_texture(GL_TEXTURE_2D, 0);
}
