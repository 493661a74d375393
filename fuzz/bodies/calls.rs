//! Random calls with random arguments, for the fuzz target `calls` and the tests of hostile calls.

use super::random::Random;
use gl_api::*;

impl Random<'_> {
    fn float(&mut self) -> f32 {
        match self.next() % 4 {
            0 => self.pick(&[
                0.0,
                -0.0,
                1.0,
                -1.0,
                0.5,
                1e30,
                -1e30,
                f32::MAX,
                f32::INFINITY,
                f32::NEG_INFINITY,
                f32::NAN,
                1e-40,
                1e7,
                -1e7,
            ]),
            1 => f32::from_bits(self.next() as u32),
            _ => (self.next() % 2001) as f32 / 1000.0 - 1.0,
        }
    }

    fn int(&mut self) -> i32 {
        match self.next() % 4 {
            0 => self.pick(&[i32::MIN, -1, 0, 1, 2, 3, 4, 7, 8, 64, 255, 8192, 8193, i32::MAX]),
            1 => self.next() as i32,
            _ => (self.next() % 20) as i32,
        }
    }

    fn name(&mut self) -> u32 {
        self.pick(&[0, 1, 2, 3, 4, 5, 666, u32::MAX])
    }

    fn enumerant(&mut self) -> u32 {
        match self.next() % 16 {
            0 => self.next() as u32,
            1 => self.pick(&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]),
            _ => self.pick(ENUMS),
        }
    }
}

/// Enums that some call takes.
const ENUMS: &[u32] = &[
    GL_TEXTURE_2D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_CUBE_MAP_POSITIVE_X,
    GL_TEXTURE_CUBE_MAP_NEGATIVE_Z,
    GL_TEXTURE_1D,
    GL_TEXTURE_3D,
    GL_RGB,
    GL_RGBA,
    GL_RGBA8,
    GL_BGRA,
    GL_RED,
    GL_ALPHA,
    GL_LUMINANCE,
    GL_LUMINANCE_ALPHA,
    GL_SRGB8,
    GL_DEPTH_COMPONENT,
    GL_DEPTH_COMPONENT24,
    GL_UNSIGNED_BYTE,
    GL_BYTE,
    GL_UNSIGNED_SHORT,
    GL_SHORT,
    GL_UNSIGNED_INT,
    GL_INT,
    GL_FLOAT,
    GL_DOUBLE,
    GL_TEXTURE_MIN_FILTER,
    GL_TEXTURE_MAG_FILTER,
    GL_TEXTURE_WRAP_S,
    GL_TEXTURE_WRAP_T,
    GL_TEXTURE_MIN_LOD,
    GL_TEXTURE_MAX_LOD,
    GL_TEXTURE_BASE_LEVEL,
    GL_TEXTURE_MAX_LEVEL,
    GL_TEXTURE_LOD_BIAS,
    GL_TEXTURE_COMPARE_MODE,
    GL_GENERATE_MIPMAP,
    GL_NEAREST,
    GL_LINEAR,
    GL_LINEAR_MIPMAP_LINEAR,
    GL_NEAREST_MIPMAP_NEAREST,
    GL_CLAMP,
    GL_REPEAT,
    GL_CLAMP_TO_BORDER,
    GL_MIRRORED_REPEAT,
    GL_TEXTURE_ENV,
    GL_TEXTURE_ENV_MODE,
    GL_REPLACE,
    GL_MODULATE,
    GL_DECAL,
    GL_BLEND,
    GL_ADD,
    GL_TEXTURE0,
    GL_TEXTURE1,
    GL_TEXTURE7,
    GL_MODELVIEW,
    GL_PROJECTION,
    GL_TEXTURE,
    GL_DEPTH_TEST,
    GL_CULL_FACE,
    GL_SCISSOR_TEST,
    GL_ALPHA_TEST,
    GL_LIGHTING,
    GL_LEQUAL,
    GL_ALWAYS,
    GL_NEVER,
    GL_GREATER,
    GL_SRC_ALPHA,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_ONE,
    GL_FUNC_ADD,
    GL_MIN,
    GL_FRONT,
    GL_BACK,
    GL_FRONT_AND_BACK,
    GL_CW,
    GL_CCW,
    GL_FLAT,
    GL_SMOOTH,
    GL_FILL,
    GL_LINE,
    GL_TRIANGLES,
    GL_TRIANGLE_STRIP,
    GL_TRIANGLE_FAN,
    GL_QUADS,
    GL_QUAD_STRIP,
    GL_POLYGON,
    GL_LINES,
    GL_LINE_LOOP,
    GL_POINTS,
    GL_ARRAY_BUFFER,
    GL_ELEMENT_ARRAY_BUFFER,
    GL_STATIC_DRAW,
    GL_VERTEX_ARRAY,
    GL_COLOR_ARRAY,
    GL_TEXTURE_COORD_ARRAY,
    GL_FRAMEBUFFER,
    GL_RENDERBUFFER,
    GL_COLOR_ATTACHMENT0,
    GL_COLOR_ATTACHMENT1,
    GL_DEPTH_ATTACHMENT,
    GL_UNPACK_ALIGNMENT,
    GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_SKIP_PIXELS,
    GL_PACK_ALIGNMENT,
    GL_VERTEX_SHADER,
    GL_FRAGMENT_SHADER,
    GL_COMPILE_STATUS,
    GL_LINK_STATUS,
    GL_VIEWPORT,
    GL_MODELVIEW_MATRIX,
    GL_TEXTURE_BINDING_2D,
    GL_COLOR_BUFFER_BIT,
    GL_DEPTH_BUFFER_BIT,
    GL_EXTENSIONS,
];

const SHADERS: &[&str] = &[
    "void main() { gl_Position = ftransform(); gl_TexCoord[0] = gl_MultiTexCoord0; }",
    "#version 130\nin vec4 a; out vec4 v; uniform mat4 m; void main() { v = a; gl_Position = m * a; }",
    "uniform sampler2D t; void main() { gl_FragColor = texture2D(t, gl_TexCoord[0].st); }",
    "#version 130\nin vec4 v; out vec4 c; uniform int n;\
     void main() { c = v; for (int i = 0; i < n; i++) c *= 1.1; if (c.x > 9.0) discard; }",
    "void main() { while (true) {} }",
    "void main() { ((((((",
    "#version 999\n\u{fffd}\u{1}",
    "",
];

/// One call with random arguments.
type Call = fn(&mut Context, &mut Random<'_>);

/// Bytes for pixels, vertices and indices: enough for some requests and too short for others.
pub const BYTES: [u8; 3000] = {
    let mut bytes = [0; 3000];
    let mut i = 0;
    while i < bytes.len() {
        bytes[i] = (i * 37 + i / 5) as u8;
        i += 1;
    }
    bytes
};

/// The calls. Sizes are small, so that a run is quick; a test of its own covers extreme sizes.
const CALLS: &[Call] = &[
    |c, r| c.bind_texture(r.enumerant(), r.name()),
    |c, r| c.active_texture(r.enumerant()),
    |c, r| {
        let (target, format) = (r.pick(&[GL_TEXTURE_2D, 0x8515, 0x8518]), r.enumerant());
        let internal = r.enumerant() as i32;
        let size = [r.int(), r.int()].map(|v| v.min(300));
        let (level, border, ty) = (r.int(), r.int() % 2, r.enumerant());
        c.tex_image_2d(
            target,
            level,
            internal,
            size[0],
            size[1],
            border,
            format,
            ty,
            (&BYTES).arg(),
        );
    },
    |c, r| {
        let size = r.pick(&[1, 2, 4, 8, 16]);
        let level = r.pick(&[0, 1, 2, 3, 4]);
        c.tex_image_2d(
            GL_TEXTURE_2D,
            level,
            GL_RGBA8 as i32,
            size,
            size,
            0,
            GL_RGBA,
            GL_UNSIGNED_BYTE,
            (&BYTES).arg(),
        );
    },
    |c, r| {
        let (x, y, w, h) = (r.int(), r.int(), r.int(), r.int());
        let (level, format, ty) = (r.int(), r.enumerant(), r.enumerant());
        c.tex_sub_image_2d(GL_TEXTURE_2D, level, x, y, w, h, format, ty, (&BYTES).arg());
    },
    |c, r| {
        let (x, y, w, h) = (r.int(), r.int(), r.int().min(64), r.int().min(64));
        c.copy_tex_image_2d(GL_TEXTURE_2D, r.int(), r.enumerant(), x, y, w, h, 0);
    },
    |c, r| c.tex_parameteri(r.enumerant(), r.enumerant(), r.enumerant() as i32),
    |c, r| c.tex_parameterf(GL_TEXTURE_2D, r.enumerant(), r.float()),
    |c, r| c.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, r.enumerant() as i32),
    |c, r| c.generate_mipmap(r.enumerant()),
    |c, r| c.pixel_storei(r.enumerant(), r.int()),
    |c, r| c.enable(r.enumerant()),
    |c, r| c.disable(r.enumerant()),
    |c, r| c.matrix_mode(r.enumerant()),
    |c, _| c.push_matrix(),
    |c, _| c.pop_matrix(),
    |c, _| c.load_identity(),
    |c, r| c.rotatef(r.float(), r.float(), r.float(), r.float()),
    |c, r| c.scalef(r.float(), r.float(), r.float()),
    |c, r| c.viewport(r.int(), r.int(), r.int(), r.int()),
    |c, r| c.scissor(r.int(), r.int(), r.int(), r.int()),
    |c, r| c.depth_range(r.float().into(), r.float().into()),
    |c, r| c.depth_func(r.enumerant()),
    |c, r| c.blend_func(r.enumerant(), r.enumerant()),
    |c, r| c.blend_equation(r.enumerant()),
    |c, r| c.alpha_func(r.enumerant(), r.float()),
    |c, r| c.cull_face(r.enumerant()),
    |c, r| c.shade_model(r.enumerant()),
    |c, r| c.line_width(r.float()),
    |c, r| c.point_size(r.float()),
    |c, r| c.polygon_offset(r.float(), r.float()),
    |c, r| c.clear_color(r.float(), r.float(), r.float(), r.float()),
    |c, r| c.clear(r.enumerant() & 0x4500),
    |c, r| c.begin(r.pick(&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10])),
    |c, _| c.end(),
    |c, r| {
        c.begin(r.pick(&[0, 1, 3, 4, 5, 6, 7, 8, 9]));
        for _ in 0..r.next() % 20 {
            c.tex_coord_4f(r.float(), r.float(), r.float(), r.float());
            c.color_4f(r.float(), r.float(), r.float(), r.float());
            c.vertex_4f(r.float(), r.float(), r.float(), r.float());
        }
        c.end();
    },
    |c, r| c.bind_buffer(r.enumerant(), r.name()),
    |c, r| {
        let usage = r.enumerant();
        let usage = r.pick(&[GL_STATIC_DRAW, usage]);
        c.buffer_data(r.enumerant(), r.int() as isize, (&BYTES).arg(), usage);
    },
    |c, r| c.vertex_pointer(r.int(), r.enumerant(), r.int(), (&BYTES).arg()),
    |c, r| c.vertex_pointer(r.int(), r.enumerant(), r.int(), Offset(r.next() as usize).arg()),
    |c, r| c.tex_coord_pointer(r.int(), r.enumerant(), r.int(), (&BYTES).arg()),
    |c, r| c.enable_client_state(r.enumerant()),
    |c, r| c.disable_client_state(r.enumerant()),
    |c, r| c.draw_arrays(r.enumerant() % 12, r.int(), r.int().min(500)),
    |c, r| {
        let count = r.int().min(500);
        c.draw_elements(r.enumerant() % 12, count, r.enumerant(), (&BYTES).arg());
    },
    |c, r| c.bind_framebuffer(r.enumerant(), r.name() % 4),
    |c, r| {
        let (attachment, texture) = (r.enumerant(), r.name());
        c.framebuffer_texture_2d(GL_FRAMEBUFFER, attachment, r.enumerant(), texture, r.int());
    },
    |c, r| c.bind_renderbuffer(GL_RENDERBUFFER, r.name()),
    |c, r| {
        c.renderbuffer_storage(GL_RENDERBUFFER, r.enumerant(), r.int().min(64), r.int().min(64));
    },
    |c, r| {
        let mut out = [0_u8; 5000];
        let (x, y, w, h) = (r.int(), r.int(), r.int(), r.int());
        c.read_pixels(x, y, w, h, r.enumerant(), r.enumerant(), (&mut out).arg());
    },
    |c, r| {
        let shader = c.create_shader(r.pick(&[GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, 7]));
        let source = r.pick(SHADERS);
        c.shader_source(shader, 1, source.arg(), Null.arg());
        c.compile_shader(shader);
        c.attach_shader(r.name() % 6, shader);
    },
    |c, _| {
        c.create_program();
    },
    |c, r| c.attach_shader(r.name(), r.name()),
    |c, r| c.link_program(r.name() % 12),
    |c, r| c.use_program(r.name() % 12),
    |c, r| c.uniform_1i(r.int(), r.int()),
    |c, r| c.uniform_4f(r.int(), r.float(), r.float(), r.float(), r.float()),
    |c, r| c.delete_textures(1, &[r.name()]),
    |c, r| c.delete_program(r.name()),
    |c, r| {
        let mut out = [0.0; 64];
        c.get_floatv(r.enumerant(), &mut out);
    },
    |c, _| c.flush(),
];

/// Makes `count` random calls.
pub fn make_calls(c: &mut Context, random: &mut Random<'_>, count: usize) {
    for _ in 0..count {
        let call = random.pick(CALLS);
        call(c, random);
    }
}
