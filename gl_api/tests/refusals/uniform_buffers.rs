//! What the calls of uniform blocks refuse (ARB_uniform_buffer_object).

use super::row;
use gl_api::*;

/// The preparation, the call, the error flag that it must set, and words that its message must have.
type Case = (fn(&mut Context), fn(&mut Context), GLenum, &'static str);

const TARGET: GLenum = GL_UNIFORM_BUFFER;

/// With program 1, which has a uniform of its own and a block of one member, and buffer 1.
fn ready() -> Context {
    let mut c = super::context();
    let program = c.create_program();
    let shader = c.create_shader(GL_VERTEX_SHADER);
    let vertex = "#extension GL_ARB_uniform_buffer_object : require\n\
        uniform float own; uniform Block { vec4 member; };\n\
        void main() { gl_Position = member * own; }";
    c.shader_source(shader, 1, Strings(vec![vertex]), &[]);
    c.compile_shader(shader);
    c.attach_shader(program, shader);
    c.link_program(program);
    c.use_program(program);
    c.bind_buffer_base(TARGET, 0, 1);
    c.buffer_data(TARGET, 64, Data::Null, GL_DYNAMIC_READ);
    assert_eq!((program, c.get_error()), (1, GL_NO_ERROR), "{:?}", c.messages());
    c
}

fn nothing(_: &mut Context) {}

fn uniform_name(c: &mut Context, program: GLuint, index: GLuint, size: GLsizei) {
    let mut text = [0; 8];
    c.get_active_uniform_name(program, index, size, &mut [0], TextOut::Bytes(&mut text));
}

fn block_name(c: &mut Context, program: GLuint, index: GLuint, size: GLsizei) {
    let mut text = [0; 8];
    c.get_active_uniform_block_name(program, index, size, &mut [0], TextOut::Bytes(&mut text));
}

const NONE: &str = "99 is no program";
const UNIFORMS: &str = "must be below GL_ACTIVE_UNIFORMS, 2";
const BLOCKS: &str = "must be below GL_ACTIVE_UNIFORM_BLOCKS, 1";

const ROWS: &[Case] = &[
    (
        nothing,
        |c| c.get_uniform_indices(99, 1, Names(vec!["own"]), &mut [0]),
        GL_INVALID_VALUE,
        NONE,
    ),
    (
        nothing,
        |c| c.get_uniform_indices(1, -1, Names(vec![]), &mut []),
        GL_INVALID_VALUE,
        "uniformCount = -1",
    ),
    (
        nothing,
        |c| c.get_uniform_indices(1, 2, Names(vec!["own"]), &mut [0; 2]),
        GL_INVALID_OPERATION,
        "there are 1 names",
    ),
    (
        nothing,
        |c| c.get_active_uniformsiv(99, 1, &[0], GL_UNIFORM_TYPE, &mut [0]),
        GL_INVALID_VALUE,
        NONE,
    ),
    (
        nothing,
        |c| c.get_active_uniformsiv(1, -1, &[0], GL_UNIFORM_TYPE, &mut [0]),
        GL_INVALID_VALUE,
        "uniformCount = -1",
    ),
    (
        nothing,
        |c| c.get_active_uniformsiv(1, 2, &[0], GL_UNIFORM_TYPE, &mut [0; 2]),
        GL_INVALID_OPERATION,
        "there are 1 indices",
    ),
    (
        nothing,
        |c| c.get_active_uniformsiv(1, 2, &[0, 2], GL_UNIFORM_TYPE, &mut [0; 2]),
        GL_INVALID_VALUE,
        UNIFORMS,
    ),
    (
        nothing,
        |c| c.get_active_uniformsiv(1, 1, &[0], GL_UNIFORM_BLOCK_BINDING, &mut [0]),
        GL_INVALID_ENUM,
        "must be GL_UNIFORM_TYPE",
    ),
    (nothing, |c| uniform_name(c, 99, 0, 8), GL_INVALID_VALUE, NONE),
    (nothing, |c| uniform_name(c, 1, 2, 8), GL_INVALID_VALUE, UNIFORMS),
    (nothing, |c| uniform_name(c, 1, 0, -1), GL_INVALID_VALUE, "= -1"),
    (
        nothing,
        |c| {
            c.get_uniform_block_index(99, "Block");
        },
        GL_INVALID_VALUE,
        NONE,
    ),
    (
        nothing,
        |c| c.get_active_uniform_blockiv(99, 0, GL_UNIFORM_BLOCK_BINDING, &mut [0]),
        GL_INVALID_VALUE,
        NONE,
    ),
    (
        nothing,
        |c| c.get_active_uniform_blockiv(1, 1, GL_UNIFORM_BLOCK_BINDING, &mut [0]),
        GL_INVALID_VALUE,
        BLOCKS,
    ),
    (
        nothing,
        |c| c.get_active_uniform_blockiv(1, 0, GL_UNIFORM_TYPE, &mut [0]),
        GL_INVALID_ENUM,
        "must be GL_UNIFORM_BLOCK_BINDING",
    ),
    (
        nothing,
        |c| c.get_active_uniform_blockiv(1, 0, GL_UNIFORM_BLOCK_BINDING, &mut []),
        GL_INVALID_OPERATION,
        "room for 0",
    ),
    (nothing, |c| block_name(c, 99, 0, 8), GL_INVALID_VALUE, NONE),
    (nothing, |c| block_name(c, 1, 1, 8), GL_INVALID_VALUE, BLOCKS),
    (nothing, |c| block_name(c, 1, 0, -1), GL_INVALID_VALUE, "= -1"),
    (nothing, |c| c.uniform_block_binding(99, 0, 0), GL_INVALID_VALUE, NONE),
    (nothing, |c| c.uniform_block_binding(1, 1, 0), GL_INVALID_VALUE, BLOCKS),
    (
        nothing,
        |c| c.uniform_block_binding(1, GL_INVALID_INDEX, 0),
        GL_INVALID_VALUE,
        "GL_INVALID_INDEX is what glGetUniformBlockIndex answers",
    ),
    (
        nothing,
        |c| c.uniform_block_binding(1, 0, 64),
        GL_INVALID_VALUE,
        "must be below GL_MAX_UNIFORM_BUFFER_BINDINGS, 64",
    ),
    (
        nothing,
        |c| c.bind_buffer_base(TARGET, 64, 1),
        GL_INVALID_VALUE,
        "index = 64 must be below GL_MAX_UNIFORM_BUFFER_BINDINGS",
    ),
    (
        nothing,
        |c| c.bind_buffer_range(TARGET, 0, 1, 8, 16),
        GL_INVALID_VALUE,
        "offset = 8 must be at least 0 and a multiple of 16",
    ),
    (
        nothing,
        |c| c.bind_buffer_range(TARGET, 0, 1, -16, 16),
        GL_INVALID_VALUE,
        "offset = -16 must be",
    ),
    (
        nothing,
        |c| c.bind_buffer_range(TARGET, 0, 1, 0, 0),
        GL_INVALID_VALUE,
        "size = 0 must be at least 1",
    ),
    (nothing, |c| c.bind_buffer_range(TARGET, 0, 1, 0, -4), GL_INVALID_VALUE, "size = -4"),
    (
        nothing,
        |c| c.get_integeri_v(GL_UNIFORM_BUFFER_BINDING, 64, &mut [0]),
        GL_INVALID_VALUE,
        "index = 64 must be below 64",
    ),
    (
        nothing,
        |c| c.get_integer64i_v(GL_UNIFORM_BUFFER_START, 64, &mut [0]),
        GL_INVALID_VALUE,
        "index = 64 must be below 64",
    ),
    (nothing, |c| c.get_integer64i_v(GL_FOG, 0, &mut [0]), GL_INVALID_ENUM, "must be GL_BLEND"),
    (
        |c| {
            c.map_buffer_range(TARGET, 0, 4, GL_MAP_READ_BIT);
        },
        |c| c.draw_arrays(GL_POINTS, 0, 1),
        GL_INVALID_OPERATION,
        "which the uniform block \"Block\" is read from, is mapped",
    ),
];

/// Runs the rows.
pub fn run() {
    for (number, (prepare, call, flag, words)) in ROWS.iter().enumerate() {
        let mut c = ready();
        prepare(&mut c);
        row(&mut c, format!("uniform buffers {number}"), call, *flag, words);
    }
}
