//! What the calls on shaders, programs and uniforms refuse, and that nothing else changed.

use super::Case;
use super::common::shading::use_program;
use gl_api::*;

const VALUE: GLenum = GL_INVALID_VALUE;
const OPERATION: GLenum = GL_INVALID_OPERATION;
const ENUM: GLenum = GL_INVALID_ENUM;
/// The names of the fixture: a vertex and a fragment shader, the program of both, which is linked
/// and in use, and a program that is not linked.
const V: GLuint = 2;
const F: GLuint = 3;
const P: GLuint = 1;
const E: GLuint = 4;

/// A program in use with uniforms of each kind.
fn everything(c: &mut Context) -> GLuint {
    let vertex = "attribute vec4 a; void main() { gl_Position = a; }";
    let fragment = "#version 130
uniform float f; uniform int i; uniform uint u; uniform bool b; uniform vec3 v; uniform mat3 m;
uniform sampler2D s; uniform float fa[3]; uniform ivec2 iv; uniform mat2x3 n; uniform mat4 ma[2];
out vec4 color;
void main() {
    float all = f + float(i) + float(u) + float(b) + fa[0] + fa[2] + float(iv.x) + n[0].x + ma[0][0].x;
    color = vec4(m * v, all) + texture(s, v.xy);
}";
    use_program(c, vertex, fragment)
}

fn at(c: &mut Context, name: &str) -> GLint {
    c.get_uniform_location(P, name)
}

const CASES: &[Case] = &[
    (|c| assert_eq!(c.create_shader(GL_POINTS), 0), ENUM, "GL_VERTEX_SHADER"),
    (|c| c.delete_shader(99), VALUE, "shader = 99 is no shader"),
    (|c| c.delete_shader(P), OPERATION, "is a program"),
    (|c| c.delete_program(99), VALUE, "program = 99 is no program"),
    (|c| c.delete_program(V), OPERATION, "is a shader"),
    (|c| c.shader_source(99, 0, Strings(vec![]), &[]), VALUE, "shader = 99"),
    (|c| c.shader_source(P, 0, Strings(vec![]), &[]), OPERATION, "is a program"),
    (|c| c.shader_source(F, -1, Strings(vec![]), &[]), VALUE, "count = -1"),
    (|c| c.shader_source(F, 2, Strings(vec![""]), &[]), OPERATION, "there are 1 strings"),
    (|c| c.shader_source(F, 1, Strings(vec!["a"]), &[2]), OPERATION, "lengths[0]"),
    (|c| c.compile_shader(0), VALUE, "shader = 0"),
    (|c| c.compile_shader(P), OPERATION, "is a program"),
    (|c| c.get_shaderiv(99, GL_COMPILE_STATUS, &mut [0]), VALUE, "shader = 99"),
    (|c| c.get_shaderiv(P, GL_COMPILE_STATUS, &mut [0]), OPERATION, "is a program"),
    (|c| c.get_shaderiv(F, GL_LINK_STATUS, &mut [0]), ENUM, "pname = GL_LINK_STATUS"),
    (|c| c.get_shader_info_log(99, 1, &mut [], TextOut::Null), VALUE, "shader = 99"),
    (|c| c.get_shader_info_log(P, 1, &mut [], TextOut::Null), OPERATION, "is a program"),
    (|c| c.get_shader_info_log(F, -1, &mut [], TextOut::Null), VALUE, "maxLength = -1"),
    (|c| c.get_shader_source(99, 1, &mut [], TextOut::Null), VALUE, "shader = 99"),
    (|c| c.get_shader_source(P, 1, &mut [], TextOut::Null), OPERATION, "is a program"),
    (|c| c.get_shader_source(F, -1, &mut [], TextOut::Null), VALUE, "maxLength = -1"),
    (|c| c.shader_binary(-1, &[], GL_RGBA, Data::Null, 0), VALUE, "count = -1"),
    (|c| c.shader_binary(1, &[V], GL_RGBA, Data::Null, -1), VALUE, "length = -1"),
    (|c| c.shader_binary(1, &[V], GL_RGBA, Data::Null, 0), ENUM, "binaryFormat = GL_RGBA"),
    (
        |c| c.get_program_binary(P, 0, &mut [], &mut [], DataOut::Bytes(&mut [])),
        OPERATION,
        "GL_NUM_PROGRAM_BINARY_FORMATS",
    ),
    (
        |c| c.get_program_binary(P, -1, &mut [], &mut [], DataOut::Bytes(&mut [])),
        VALUE,
        "bufSize = -1",
    ),
    (
        |c| c.get_program_binary(99, 0, &mut [], &mut [], DataOut::Bytes(&mut [])),
        VALUE,
        "99 is no program",
    ),
    (|c| c.program_binary(P, GL_RGBA, Data::Null, 0), ENUM, "binaryFormat = GL_RGBA"),
    (|c| c.program_binary(P, GL_RGBA, Data::Null, -1), VALUE, "length = -1"),
    (|c| c.program_parameteri(P, GL_RGBA, 0), ENUM, "pname = GL_RGBA"),
    (|c| c.program_parameteri(P, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, 2), VALUE, "value = 2"),
    (
        |c| c.get_shader_precision_format(GL_RGBA, GL_LOW_INT, &mut [0; 2], &mut [0]),
        ENUM,
        "shaderType = GL_RGBA",
    ),
    (
        |c| c.get_shader_precision_format(GL_VERTEX_SHADER, GL_INT, &mut [0; 2], &mut [0]),
        ENUM,
        "precisionType = GL_INT",
    ),
    (|c| c.attach_shader(99, V), VALUE, "program = 99"),
    (|c| c.attach_shader(P, 99), VALUE, "shader = 99"),
    (|c| c.attach_shader(V, V), OPERATION, "is a shader"),
    (|c| c.attach_shader(P, P), OPERATION, "is a program"),
    (|c| c.attach_shader(P, V), OPERATION, "attached already"),
    (|c| c.detach_shader(99, V), VALUE, "program = 99"),
    (|c| c.detach_shader(P, 99), VALUE, "shader = 99"),
    (|c| c.detach_shader(E, V), OPERATION, "is not attached"),
    (|c| c.detach_shader(P, E), OPERATION, "is a program"),
    (|c| c.bind_attrib_location(99, 1, "a"), VALUE, "program = 99"),
    (|c| c.bind_attrib_location(V, 1, "a"), OPERATION, "is a shader"),
    (|c| c.bind_attrib_location(P, 16, "a"), VALUE, "must be below 16"),
    (|c| c.bind_attrib_location(P, 1, "gl_a"), OPERATION, "reserved"),
    (|c| c.bind_frag_data_location(99, 1, "o"), VALUE, "program = 99"),
    (|c| c.bind_frag_data_location(V, 1, "o"), OPERATION, "is a shader"),
    (|c| c.bind_frag_data_location(P, 8, "o"), VALUE, "must be below 8"),
    (|c| c.bind_frag_data_location(P, 1, "gl_o"), OPERATION, "reserved"),
    (|c| c.bind_frag_data_location_indexed(99, 0, 1, "o"), VALUE, "program = 99"),
    (|c| c.bind_frag_data_location_indexed(V, 0, 1, "o"), OPERATION, "is a shader"),
    (|c| c.bind_frag_data_location_indexed(P, 0, 2, "o"), VALUE, "index = 2 must be 0 or 1"),
    (|c| c.bind_frag_data_location_indexed(P, 8, 0, "o"), VALUE, "colorNumber = 8 must be below"),
    (|c| c.bind_frag_data_location_indexed(P, 1, 1, "o"), VALUE, "MAX_DUAL_SOURCE_DRAW_BUFFERS, 1"),
    (|c| c.bind_frag_data_location_indexed(P, 0, 1, "gl_o"), OPERATION, "reserved"),
    (|c| c.link_program(99), VALUE, "program = 99"),
    (|c| c.link_program(V), OPERATION, "is a shader"),
    (|c| c.use_program(99), VALUE, "program = 99"),
    (|c| c.use_program(V), OPERATION, "is a shader"),
    (|c| c.use_program(E), OPERATION, "is not linked"),
    (|c| c.validate_program(99), VALUE, "program = 99"),
    (|c| c.validate_program(V), OPERATION, "is a shader"),
    (|c| c.get_programiv(99, GL_LINK_STATUS, &mut [0]), VALUE, "program = 99"),
    (|c| c.get_programiv(V, GL_LINK_STATUS, &mut [0]), OPERATION, "is a shader"),
    (|c| c.get_programiv(P, GL_COMPILE_STATUS, &mut [0]), ENUM, "pname"),
    (|c| c.get_program_info_log(99, 1, &mut [], TextOut::Null), VALUE, "program = 99"),
    (|c| c.get_program_info_log(P, -1, &mut [], TextOut::Null), VALUE, "maxLength = -1"),
    (|c| c.get_attached_shaders(99, 1, &mut [], &mut [0]), VALUE, "program = 99"),
    (|c| c.get_attached_shaders(P, -1, &mut [], &mut [0]), VALUE, "maxCount = -1"),
    (|c| assert_eq!(c.get_uniform_location(99, "f"), -1), VALUE, "program = 99"),
    (|c| assert_eq!(c.get_uniform_location(E, "f"), -1), OPERATION, "is not linked"),
    (|c| assert_eq!(c.get_attrib_location(99, "a"), -1), VALUE, "program = 99"),
    (|c| assert_eq!(c.get_attrib_location(E, "a"), -1), OPERATION, "is not linked"),
    (|c| assert_eq!(c.get_frag_data_location(99, "o"), -1), VALUE, "program = 99"),
    (|c| assert_eq!(c.get_frag_data_location(E, "o"), -1), OPERATION, "is not linked"),
    (|c| assert_eq!(c.get_frag_data_index(99, "o"), -1), VALUE, "program = 99"),
    (|c| assert_eq!(c.get_frag_data_index(E, "o"), -1), OPERATION, "is not linked"),
    (
        |c| c.get_active_uniform(P, 99, 9, &mut [], &mut [0], &mut [0], TextOut::Null),
        VALUE,
        "GL_ACTIVE_UNIFORMS",
    ),
    (
        |c| c.get_active_uniform(E, 0, 9, &mut [], &mut [0], &mut [0], TextOut::Null),
        VALUE,
        "GL_ACTIVE_UNIFORMS, 0",
    ),
    (
        |c| c.get_active_uniform(P, 0, -9, &mut [], &mut [0], &mut [0], TextOut::Null),
        VALUE,
        "maxLength = -9",
    ),
    (
        |c| c.get_active_attrib(P, 1, 9, &mut [], &mut [0], &mut [0], TextOut::Null),
        VALUE,
        "GL_ACTIVE_ATTRIBUTES, 1",
    ),
    (
        |c| c.get_active_attrib(P, 0, -9, &mut [], &mut [0], &mut [0], TextOut::Null),
        VALUE,
        "maxLength = -9",
    ),
    (|c| c.get_uniformfv(99, 0, &mut [0.0]), VALUE, "program = 99"),
    (|c| c.get_uniformfv(E, 0, &mut [0.0]), OPERATION, "is not linked"),
    (|c| c.get_uniformfv(P, -1, &mut [0.0]), OPERATION, "location = -1"),
    (|c| c.get_uniformiv(P, 999, &mut [0]), OPERATION, "location = 999"),
    (|c| c.get_uniformuiv(P, -2, &mut [0]), OPERATION, "location = -2"),
    (|c| c.getn_uniformfv(99, 0, 4, &mut [0.0]), VALUE, "program = 99"),
    (|c| c.getn_uniformfv(P, -1, 4, &mut [0.0]), OPERATION, "location = -1"),
    (|c| c.getn_uniformiv(P, 999, 4, &mut [0]), OPERATION, "location = 999"),
    (|c| c.getn_uniformuiv(P, -2, 4, &mut [0]), OPERATION, "location = -2"),
    (
        |c| {
            let l = at(c, "f");
            c.getn_uniformfv(P, l, 3, &mut [0.0]);
        },
        OPERATION,
        "bufSize = 3, but 4 bytes are needed",
    ),
    (
        |c| {
            let l = at(c, "f");
            c.getn_uniformiv(P, l, -1, &mut [0]);
        },
        OPERATION,
        "bufSize = -1, but 4 bytes are needed",
    ),
    (
        |c| {
            let l = at(c, "f");
            c.getn_uniformuiv(P, l, 0, &mut [0]);
        },
        OPERATION,
        "bufSize = 0, but 4 bytes are needed",
    ),
    // Uniforms: types, sizes, counts, locations.
    (
        |c| {
            let l = at(c, "f");
            c.uniform_1i(l, 1)
        },
        OPERATION,
        "\"f\" is a GL_FLOAT",
    ),
    (
        |c| {
            let l = at(c, "f");
            c.uniform_1ui(l, 1)
        },
        OPERATION,
        "GL_UNSIGNED_INT",
    ),
    (
        |c| {
            let l = at(c, "f");
            c.uniform_2f(l, 1.0, 1.0)
        },
        OPERATION,
        "GL_FLOAT_VEC2",
    ),
    (
        |c| {
            let l = at(c, "i");
            c.uniform_1f(l, 1.0)
        },
        OPERATION,
        "\"i\" is a GL_INT",
    ),
    (
        |c| {
            let l = at(c, "i");
            c.uniform_1ui(l, 1)
        },
        OPERATION,
        "GL_UNSIGNED_INT",
    ),
    (
        |c| {
            let l = at(c, "u");
            c.uniform_1i(l, 1)
        },
        OPERATION,
        "\"u\" is a GL_UNSIGNED_INT",
    ),
    (
        |c| {
            let l = at(c, "b");
            c.uniform_2i(l, 1, 1)
        },
        OPERATION,
        "\"b\" is a GL_BOOL",
    ),
    (
        |c| {
            let l = at(c, "v");
            c.uniform_3i(l, 1, 1, 1)
        },
        OPERATION,
        "GL_INT_VEC3",
    ),
    (
        |c| {
            let l = at(c, "v");
            c.uniform_4fv(l, 1, &[0.0; 4])
        },
        OPERATION,
        "GL_FLOAT_VEC4",
    ),
    (
        |c| {
            let l = at(c, "v");
            c.uniform_3fv(l, 2, &[0.0; 6])
        },
        OPERATION,
        "is no array",
    ),
    (
        |c| {
            let l = at(c, "v");
            c.uniform_3fv(l, -1, &[])
        },
        VALUE,
        "count = -1",
    ),
    (
        |c| {
            let l = at(c, "v");
            c.uniform_3fv(l, 1, &[0.0; 2])
        },
        OPERATION,
        "has 2",
    ),
    (
        |c| {
            let l = at(c, "iv");
            c.uniform_2f(l, 0.0, 0.0)
        },
        OPERATION,
        "GL_INT_VEC2",
    ),
    (
        |c| {
            let l = at(c, "fa");
            c.uniform_1fv(l, 3, &[0.0; 1])
        },
        OPERATION,
        "has 1",
    ),
    (
        |c| {
            let l = at(c, "ma");
            c.uniform_matrix_4fv(l, 1 << 28, false, &[0.0; 15])
        },
        OPERATION,
        "of count = 268435456 elements take ",
    ),
    (
        |c| {
            let l = at(c, "s");
            c.uniform_1f(l, 0.0)
        },
        OPERATION,
        "GL_SAMPLER_2D",
    ),
    (
        |c| {
            let l = at(c, "s");
            c.uniform_1ui(l, 0)
        },
        OPERATION,
        "GL_SAMPLER_2D",
    ),
    (
        |c| {
            let l = at(c, "s");
            c.uniform_1i(l, 48)
        },
        VALUE,
        "must be a texture unit",
    ),
    (
        |c| {
            let l = at(c, "s");
            c.uniform_1i(l, -1)
        },
        VALUE,
        "its value -1",
    ),
    (
        |c| {
            let l = at(c, "m");
            c.uniform_matrix_2fv(l, 1, false, &[0.0; 4])
        },
        OPERATION,
        "GL_FLOAT_MAT2",
    ),
    (
        |c| {
            let l = at(c, "m");
            c.uniform_matrix_3fv(l, 2, false, &[0.0; 18])
        },
        OPERATION,
        "is no array",
    ),
    (
        |c| {
            let l = at(c, "m");
            c.uniform_matrix_3fv(l, -3, false, &[])
        },
        VALUE,
        "count = -3",
    ),
    (
        |c| {
            let l = at(c, "m");
            c.uniform_matrix_3fv(l, 1, false, &[0.0; 8])
        },
        OPERATION,
        "has 8",
    ),
    (
        |c| {
            let l = at(c, "n");
            c.uniform_matrix_3x2fv(l, 1, false, &[0.0; 6])
        },
        OPERATION,
        "GL_FLOAT_MAT2x3",
    ),
    (
        |c| {
            let l = at(c, "m");
            c.uniform_3f(l, 0.0, 0.0, 0.0)
        },
        OPERATION,
        "GL_FLOAT_MAT3",
    ),
    (|c| c.uniform_1f(999, 0.0), OPERATION, "location = 999"),
    (|c| c.uniform_1f(-2, 0.0), OPERATION, "location = -2"),
    (
        |c| {
            c.use_program(0);
            c.uniform_1f(0, 0.0);
            c.use_program(P);
        },
        OPERATION,
        "no linked program is in use",
    ),
    // Generic attributes.
    (|c| c.vertex_attrib_1d(16, 0.0), VALUE, "must be below GL_MAX_VERTEX_ATTRIBS"),
    (|c| c.vertex_attrib_4nub(99, 0, 0, 0, 0), VALUE, "must be below GL_MAX_VERTEX_ATTRIBS"),
    (|c| c.vertex_attrib_3sv(1, &[0; 2]), OPERATION, "2 of 3 numbers"),
    (|c| c.vertex_attrib_4nuiv(1, &[0; 3]), OPERATION, "3 of 4 numbers"),
    (|c| c.vertex_attrib_i_4ubv(16, &[0; 4]), VALUE, "must be below GL_MAX_VERTEX_ATTRIBS"),
    (|c| c.vertex_attrib_i_2iv(1, &[0; 1]), OPERATION, "1 of 2 numbers"),
];

/// A context with the fixture.
fn context() -> Context {
    let mut c = super::context();
    assert_eq!(everything(&mut c), P);
    assert_eq!(c.create_program(), E);
    c
}

/// Runs the rows.
pub fn run() {
    super::table(
        "programs",
        context,
        CASES.iter().map(|(call, flag, words)| (call, *flag, *words)),
    );
}
