//! What the calls of separable programs and their pipelines refuse (ARB_separate_shader_objects).

use super::Case;
use gl_api::*;

const VALUE: GLenum = GL_INVALID_VALUE;
const OPERATION: GLenum = GL_INVALID_OPERATION;
const ENUM: GLenum = GL_INVALID_ENUM;

/// The names of the fixture: separable programs of a vertex and of a fragment stage, one of both, one that is not
/// separable, one that is not linked, a shader; and pipelines: with both programs and bound, with a part of a program.
const V: GLuint = 3;
const F: GLuint = 5;
const BOTH: GLuint = 4;
const WHOLE: GLuint = 6;
const E: GLuint = 7;
const S: GLuint = 1;
const P: GLuint = 1;
const PART: GLuint = 2;

const VERTEX: &str = "uniform float f; void main() { gl_Position = gl_Vertex * f; }";
const FRAGMENT: &str = "uniform vec4 v; void main() { gl_FragColor = v; }";

fn shader(c: &mut Context, stage: GLenum, source: &str) -> GLuint {
    let shader = c.create_shader(stage);
    c.shader_source(shader, 1, Strings(vec![source]), &[]);
    c.compile_shader(shader);
    shader
}

/// A context with the fixture.
fn ready() -> Context {
    let mut c = super::context();
    let vertex = shader(&mut c, GL_VERTEX_SHADER, VERTEX);
    let v = c.create_shader_programv(GL_VERTEX_SHADER, 1, Names(vec![VERTEX]));
    let fragment = shader(&mut c, GL_FRAGMENT_SHADER, FRAGMENT);
    let f = c.create_shader_programv(GL_FRAGMENT_SHADER, 1, Names(vec![FRAGMENT]));
    let made = [1, 0].map(|separable| {
        let program = c.create_program();
        c.program_parameteri(program, GL_PROGRAM_SEPARABLE, separable);
        c.attach_shader(program, vertex);
        c.attach_shader(program, fragment);
        c.link_program(program);
        program
    });
    let unlinked = c.create_program();
    let mut pipelines = [0; 3];
    c.gen_program_pipelines(3, &mut pipelines);
    assert_eq!(([v, f], made, unlinked, vertex), ([V, F], [BOTH, WHOLE], E, S));
    c.use_program_stages(P, GL_VERTEX_SHADER_BIT, V);
    c.use_program_stages(P, GL_FRAGMENT_SHADER_BIT, F);
    c.use_program_stages(PART, GL_VERTEX_SHADER_BIT, BOTH);
    c.bind_program_pipeline(P);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    c
}

/// Transform feedback of a pipeline is active while `call` runs.
fn capturing(c: &mut Context, call: impl Fn(&mut Context)) {
    let capture = Names(vec!["gl_Position"]);
    c.transform_feedback_varyings(V, 1, capture, GL_INTERLEAVED_ATTRIBS);
    let again = shader(c, GL_VERTEX_SHADER, VERTEX);
    c.attach_shader(V, again);
    c.link_program(V);
    c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 1);
    c.buffer_data(GL_TRANSFORM_FEEDBACK_BUFFER, 64, Data::Null, GL_DYNAMIC_READ);
    c.begin_transform_feedback(GL_TRIANGLES);
    call(c);
    c.end_transform_feedback();
    c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    c.delete_buffers(1, &[1]);
    c.detach_shader(V, again);
    c.delete_shader(again);
    c.transform_feedback_varyings(V, 0, Names(vec![]), GL_INTERLEAVED_ATTRIBS);
}

const CASES: &[Case] = &[
    (|c| assert_eq!(c.create_shader_programv(GL_POINTS, 0, Names(vec![])), 0), ENUM, "type ="),
    (
        |c| assert_eq!(c.create_shader_programv(GL_VERTEX_SHADER, -1, Names(vec![])), 0),
        VALUE,
        "count = -1",
    ),
    (|c| c.gen_program_pipelines(-1, &mut []), VALUE, "n = -1"),
    (|c| c.delete_program_pipelines(-1, &[]), VALUE, "n = -1"),
    (|c| c.bind_program_pipeline(9), OPERATION, "glGenProgramPipelines"),
    (|c| c.use_program_stages(9, GL_VERTEX_SHADER_BIT, V), OPERATION, "glGenProgramPipelines"),
    (|c| c.use_program_stages(0, GL_VERTEX_SHADER_BIT, V), OPERATION, "pipeline = 0"),
    (|c| c.use_program_stages(P, 0x10, V), VALUE, "has the bits 0x10"),
    (|c| c.use_program_stages(P, GL_VERTEX_SHADER_BIT, 99), VALUE, "99 is no program"),
    (|c| c.use_program_stages(P, GL_VERTEX_SHADER_BIT, S), OPERATION, "is a shader"),
    (|c| c.use_program_stages(P, GL_VERTEX_SHADER_BIT, E), OPERATION, "is not linked"),
    (|c| c.use_program_stages(P, GL_VERTEX_SHADER_BIT, WHOLE), OPERATION, "is not separable"),
    (|c| c.active_shader_program(9, V), OPERATION, "glGenProgramPipelines"),
    (|c| c.active_shader_program(P, 99), VALUE, "99 is no program"),
    (|c| c.active_shader_program(P, E), OPERATION, "is not linked"),
    (|c| c.validate_program_pipeline(9), OPERATION, "glGenProgramPipelines"),
    (|c| c.get_program_pipelineiv(9, GL_ACTIVE_PROGRAM, &mut [0]), OPERATION, "pipeline = 9"),
    (|c| c.get_program_pipelineiv(P, GL_LINE, &mut [0]), ENUM, "pname = GL_LINE"),
    (|c| c.get_program_pipeline_info_log(9, 1, &mut [], TextOut::Null), OPERATION, "pipeline = 9"),
    (|c| c.get_program_pipeline_info_log(P, -1, &mut [], TextOut::Null), VALUE, "maxLength = -1"),
    (|c| c.program_parameteri(V, GL_PROGRAM_SEPARABLE, 2), VALUE, "value = 2"),
    // Uniforms.
    (|c| c.uniform_1f(0, 1.0), OPERATION, "no linked program is in use"),
    (|c| c.program_uniform_1f(S, 0, 1.0), OPERATION, "is a shader"),
    (|c| c.program_uniform_1f(E, 0, 1.0), OPERATION, "is not linked"),
    (|c| c.program_uniform_1i(V, 0, 1), OPERATION, "is a GL_FLOAT"),
    // Draws.
    (
        |c| {
            c.bind_program_pipeline(PART);
            c.begin(GL_TRIANGLES);
            c.bind_program_pipeline(P);
        },
        OPERATION,
        "has a fragment stage that the pipeline does not use",
    ),
    // Transform feedback.
    (|c| capturing(c, |c| c.bind_program_pipeline(P)), OPERATION, "transform feedback is active"),
    (
        |c| capturing(c, |c| c.use_program_stages(P, GL_VERTEX_SHADER_BIT, V)),
        OPERATION,
        "transform feedback is active",
    ),
    (|c| capturing(c, |c| c.link_program(V)), OPERATION, "transform feedback is active"),
];

/// Calls that set a uniform of what is no program.
macro_rules! of_no_program {
    ($($call:ident($($argument:expr),*);)*) => {
        &[$((|c| c.$call(99, $($argument),*), VALUE, "program = 99 is no program")),*]
    };
}

const UNIFORMS: &[Case] = of_no_program! {
    program_uniform_1f(0, 1.0);
    program_uniform_2f(0, 1.0, 1.0);
    program_uniform_3f(0, 1.0, 1.0, 1.0);
    program_uniform_4f(0, 1.0, 1.0, 1.0, 1.0);
    program_uniform_1i(0, 1);
    program_uniform_2i(0, 1, 1);
    program_uniform_3i(0, 1, 1, 1);
    program_uniform_4i(0, 1, 1, 1, 1);
    program_uniform_1ui(0, 1);
    program_uniform_2ui(0, 1, 1);
    program_uniform_3ui(0, 1, 1, 1);
    program_uniform_4ui(0, 1, 1, 1, 1);
    program_uniform_1fv(0, 1, &[1.0; 1]);
    program_uniform_2fv(0, 1, &[1.0; 2]);
    program_uniform_3fv(0, 1, &[1.0; 3]);
    program_uniform_4fv(0, 1, &[1.0; 4]);
    program_uniform_1iv(0, 1, &[1; 1]);
    program_uniform_2iv(0, 1, &[1; 2]);
    program_uniform_3iv(0, 1, &[1; 3]);
    program_uniform_4iv(0, 1, &[1; 4]);
    program_uniform_1uiv(0, 1, &[1; 1]);
    program_uniform_2uiv(0, 1, &[1; 2]);
    program_uniform_3uiv(0, 1, &[1; 3]);
    program_uniform_4uiv(0, 1, &[1; 4]);
    program_uniform_matrix_2fv(0, 1, false, &[1.0; 4]);
    program_uniform_matrix_3fv(0, 1, false, &[1.0; 9]);
    program_uniform_matrix_4fv(0, 1, false, &[1.0; 16]);
    program_uniform_matrix_2x3fv(0, 1, false, &[1.0; 6]);
    program_uniform_matrix_3x2fv(0, 1, false, &[1.0; 6]);
    program_uniform_matrix_2x4fv(0, 1, false, &[1.0; 8]);
    program_uniform_matrix_4x2fv(0, 1, false, &[1.0; 8]);
    program_uniform_matrix_3x4fv(0, 1, false, &[1.0; 12]);
    program_uniform_matrix_4x3fv(0, 1, false, &[1.0; 12]);
};

/// Runs the rows.
pub fn run() {
    let rows = CASES.iter().chain(UNIFORMS);
    super::table("pipelines", ready, rows.map(|(call, flag, words)| (call, *flag, *words)));
}
