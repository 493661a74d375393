//! Program pipelines: separable programs that are combined (ARB_separate_shader_objects).

use super::{asked, context, drawn, log, no_error, shader};
use gl_api::*;

const VERTEX: &str = "#version 150 compatibility
#extension GL_ARB_separate_shader_objects : require
uniform vec4 tint;
layout(location = 3) out vec4 near; out vec2 named; flat out ivec2 whole;
void main() {
    gl_Position = gl_Vertex; near = tint; named = tint.zw; whole = ivec2(tint * 10.0);
}";

/// A separable program of one stage.
fn one(c: &mut Context, stage: GLenum, source: &str) -> GLuint {
    let program = c.create_shader_programv(stage, 1, Names(vec![source]));
    assert_eq!(asked(c, program, GL_LINK_STATUS), 1, "{}", log(c, program));
    assert_eq!(asked(c, program, GL_PROGRAM_SEPARABLE), 1);
    program
}

/// A fragment stage that writes an expression of its inputs.
fn fragment(c: &mut Context, inputs: &str, color: &str) -> GLuint {
    let source = format!(
        "#version 150 compatibility\n#extension GL_ARB_separate_shader_objects : require\n{inputs}
         void main() {{ gl_FragColor = {color}; }}"
    );
    one(c, GL_FRAGMENT_SHADER, &source)
}

/// A pipeline of these programs, bound.
fn pipeline(c: &mut Context, stages: &[(GLbitfield, GLuint)]) -> GLuint {
    let mut name = [0];
    c.gen_program_pipelines(1, &mut name);
    assert!(!c.is_program_pipeline(name[0]), "it has no state yet");
    for (bits, program) in stages {
        c.use_program_stages(name[0], *bits, *program);
    }
    c.bind_program_pipeline(name[0]);
    assert!(c.is_program_pipeline(name[0]));
    no_error(c);
    name[0]
}

fn of_pipeline(c: &mut Context, pipeline: GLuint, pname: GLenum) -> GLint {
    let mut value = [9];
    c.get_program_pipelineiv(pipeline, pname, &mut value);
    value[0]
}

fn set_tint(c: &mut Context, program: GLuint, tint: [f32; 4]) {
    let location = c.get_uniform_location(program, "tint");
    c.program_uniform_4fv(program, location, 1, &tint);
}

/// What the inputs of a fragment stage are, of a vertex stage whose `tint` is (0.2, 0.4, 0.6, 0.8).
#[test]
fn inputs_match_by_location_by_name_and_by_place() {
    for (inputs, color, expected) in [
        ("layout(location = 3) in vec4 other;", "other", [51, 102, 153, 204]),
        // The first components of a longer vector.
        ("layout(location = 3) in vec2 other;", "vec4(other, 0.0, 1.0)", [51, 102, 0, 255]),
        ("in vec2 named;", "vec4(named, 0.0, 1.0)", [153, 204, 0, 255]),
        ("in vec2 named; flat in ivec2 whole;", "vec4(whole, named) / 10.0", [51, 102, 15, 20]),
        // What matches nothing is zero here: another location, another type, a name with a location.
        ("layout(location = 2) in vec4 other;", "other", [0; 4]),
        ("layout(location = 3) in mat2 other;", "vec4(other[0], other[1])", [0; 4]),
        ("in vec4 near;", "near", [0; 4]),
        // Or what stands at its place, without location.
        ("in vec2 unknown;", "vec4(unknown, 0.0, 1.0)", [153, 204, 0, 255]),
    ] {
        let mut c = context();
        let vertex = one(&mut c, GL_VERTEX_SHADER, VERTEX);
        let fragment = fragment(&mut c, inputs, color);
        let stages = [(GL_VERTEX_SHADER_BIT, vertex), (GL_FRAGMENT_SHADER_BIT, fragment)];
        pipeline(&mut c, &stages);
        set_tint(&mut c, vertex, [0.2, 0.4, 0.6, 0.8]);
        assert_eq!(drawn(&mut c), expected, "{inputs}");
    }
}

/// Uniforms, samplers and blocks of one name are each program's own.
#[test]
fn each_program_has_its_own_uniforms() {
    let mut c = context();
    let vertex = one(&mut c, GL_VERTEX_SHADER, VERTEX);
    let inputs = "uniform float tint; layout(location = 3) in vec4 near;
        layout(std140) uniform Block { vec4 member; };";
    let of_block = fragment(&mut c, inputs, "near * tint + member");
    let both = [(GL_VERTEX_SHADER_BIT, vertex), (GL_FRAGMENT_SHADER_BIT, of_block)];
    let bound = pipeline(&mut c, &both);
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 5, 1);
    let member: Vec<u8> = [0.2f32, 0.0, 0.0, 1.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    c.buffer_data(GL_UNIFORM_BUFFER, 16, Data::Bytes(&member), GL_STATIC_DRAW);
    c.uniform_block_binding(of_block, 0, 5);
    set_tint(&mut c, vertex, [0.0, 0.4, 0.8, 0.0]);
    let location = c.get_uniform_location(of_block, "tint");
    c.program_uniform_1f(of_block, location, 0.5);
    assert_eq!(drawn(&mut c), [51, 51, 102, 255]);
    // Nothing but a value changes.
    c.program_uniform_1f(of_block, location, 1.0);
    assert_eq!(drawn(&mut c), [51, 102, 204, 255]);
    // `glUniform` sets those of the active program.
    c.active_shader_program(bound, of_block);
    c.uniform_1f(location, 0.0);
    assert_eq!(drawn(&mut c), [51, 0, 0, 255]);
    assert_eq!(of_pipeline(&mut c, bound, GL_ACTIVE_PROGRAM), of_block as GLint);
    c.uniform_block_binding(of_block, 0, 6);
    c.uniform_1f(location, 1.0);
    assert_eq!(drawn(&mut c), [0, 102, 204, 0], "no buffer is bound to index 6");
}

/// A program in use comes before the pipeline; without a vertex stage the fixed function runs.
#[test]
fn programs_in_use_come_first_and_the_fixed_function_fills_in() {
    let mut c = context();
    let red = fragment(&mut c, "", "vec4(1.0, 0.0, 0.0, 1.0)");
    let bound = pipeline(&mut c, &[(GL_ALL_SHADER_BITS, red)]);
    assert_eq!(of_pipeline(&mut c, bound, GL_FRAGMENT_SHADER), red as GLint);
    assert_eq!(of_pipeline(&mut c, bound, GL_VERTEX_SHADER), 0, "it has no such stage");
    assert_eq!(drawn(&mut c), [255, 0, 0, 255]);
    let green = fragment(&mut c, "", "vec4(0.0, 1.0, 0.0, 1.0)");
    c.use_program(green);
    assert_eq!(drawn(&mut c), [0, 255, 0, 255]);
    c.use_program(0);
    assert_eq!(drawn(&mut c), [255, 0, 0, 255]);
    c.use_program_stages(bound, GL_FRAGMENT_SHADER_BIT, green);
    assert_eq!(drawn(&mut c), [0, 255, 0, 255]);
    c.use_program_stages(bound, GL_ALL_SHADER_BITS, 0);
    c.color_3f(0.0, 0.0, 1.0);
    assert_eq!(drawn(&mut c), [0, 0, 255, 255]);
    c.bind_program_pipeline(0);
    assert_eq!(drawn(&mut c), [0, 0, 255, 255]);
    c.delete_program_pipelines(1, &[bound]);
    assert!(!c.is_program_pipeline(bound));
}

/// A geometry stage of its own between the others; points become what covers the pixel.
#[test]
fn three_programs_make_three_stages() {
    let mut c = context();
    let vertex = one(&mut c, GL_VERTEX_SHADER, VERTEX);
    let geometry = "#version 150
        #extension GL_ARB_separate_shader_objects : require
        layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;
        layout(location = 3) in vec4 from[]; layout(location = 0) out vec4 to;
        uniform vec4 tint;
        void main() {
            for (int i = 0; i < 3; i++) {
                gl_Position = gl_in[i].gl_Position; to = from[i].wzyx + tint; EmitVertex();
            }
        }";
    let geometry = one(&mut c, GL_GEOMETRY_SHADER, geometry);
    let last = fragment(&mut c, "layout(location = 0) in vec4 to;", "to");
    let stages = [
        (GL_VERTEX_SHADER_BIT, vertex),
        (GL_GEOMETRY_SHADER_BIT, geometry),
        (GL_FRAGMENT_SHADER_BIT, last),
    ];
    let bound = pipeline(&mut c, &stages);
    set_tint(&mut c, vertex, [0.2, 0.4, 0.6, 0.8]);
    set_tint(&mut c, geometry, [0.0, 0.0, 0.0, 0.2]);
    assert_eq!(drawn(&mut c), [204, 153, 102, 102]);
    c.use_program_stages(bound, GL_VERTEX_SHADER_BIT, 0);
    c.begin(GL_TRIANGLES);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    c.validate_program_pipeline(bound);
    assert_eq!(of_pipeline(&mut c, bound, GL_VALIDATE_STATUS), 0);
    let mut said = String::new();
    c.get_program_pipeline_info_log(bound, 256, &mut [], TextOut::String(&mut said));
    assert!(said.contains("a geometry stage and no vertex stage"), "{said}");
    assert_eq!(of_pipeline(&mut c, bound, GL_INFO_LOG_LENGTH), said.len() as GLint + 1);
}

/// A link makes the new executable that of all pipelines; one that fails, and a deletion, leave what is there.
#[test]
fn pipelines_follow_links_and_hold_their_programs() {
    let mut c = context();
    let program = c.create_program();
    c.program_parameteri(program, GL_PROGRAM_SEPARABLE, 1);
    let link = |c: &mut Context, color: &str| {
        let source = format!("void main() {{ gl_FragColor = {color}; }}");
        let made = shader(c, GL_FRAGMENT_SHADER, &source);
        c.attach_shader(program, made);
        c.link_program(program);
        c.detach_shader(program, made);
        c.delete_shader(made);
    };
    link(&mut c, "vec4(1.0)");
    let bound = pipeline(&mut c, &[(GL_FRAGMENT_SHADER_BIT, program)]);
    assert_eq!(drawn(&mut c), [255; 4]);
    link(&mut c, "vec4(0.0, 1.0, 1.0, 1.0)");
    assert_eq!(drawn(&mut c), [0, 255, 255, 255]);
    link(&mut c, "undeclared");
    assert_eq!(asked(&mut c, program, GL_LINK_STATUS), 0);
    assert_eq!(drawn(&mut c), [0, 255, 255, 255]);
    c.delete_program(program);
    assert!(c.is_program(program));
    assert_eq!(drawn(&mut c), [0, 255, 255, 255]);
    c.delete_program_pipelines(1, &[bound]);
    assert!(!c.is_program(program));
    no_error(&mut c);
}

/// Linked again without the parameter, a program can no longer be a part.
#[test]
fn parts_stay_separable() {
    let mut c = context();
    let red = fragment(&mut c, "", "vec4(1.0, 0.0, 0.0, 1.0)");
    let bound = pipeline(&mut c, &[(GL_FRAGMENT_SHADER_BIT, red)]);
    c.validate_program_pipeline(bound);
    assert_eq!(of_pipeline(&mut c, bound, GL_VALIDATE_STATUS), 1);
    let source = "void main() { gl_FragColor = vec4(1.0); }";
    let made = shader(&mut c, GL_FRAGMENT_SHADER, source);
    c.attach_shader(red, made);
    c.program_parameteri(red, GL_PROGRAM_SEPARABLE, 0);
    c.link_program(red);
    c.begin(GL_TRIANGLES);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    c.validate_program_pipeline(bound);
    assert_eq!(of_pipeline(&mut c, bound, GL_VALIDATE_STATUS), 0);
}

/// Stages and uniforms are part of display lists; binding is not (section 5.5).
#[test]
fn lists_have_stages_and_uniforms() {
    let mut c = context();
    let vertex = one(&mut c, GL_VERTEX_SHADER, VERTEX);
    let near = fragment(&mut c, "layout(location = 3) in vec4 near;", "near");
    let bound = pipeline(&mut c, &[(GL_VERTEX_SHADER_BIT, vertex)]);
    c.bind_program_pipeline(0);
    c.new_list(1, GL_COMPILE);
    c.bind_program_pipeline(bound);
    c.use_program_stages(bound, GL_FRAGMENT_SHADER_BIT, near);
    set_tint(&mut c, vertex, [1.0, 0.0, 1.0, 1.0]);
    c.end_list();
    let mut name = [0];
    c.get_integerv(GL_PROGRAM_PIPELINE_BINDING, &mut name);
    assert_eq!(name[0] as GLuint, bound);
    assert_eq!(of_pipeline(&mut c, bound, GL_FRAGMENT_SHADER), 0);
    c.call_list(1);
    assert_eq!(drawn(&mut c), [255, 0, 255, 255]);
}

/// Locations that two outputs share, and those past the last, do not link.
#[test]
fn locations_are_checked() {
    for (outputs, problem) in [
        (
            "layout(location = 0) out vec4 a; layout(location = 0) out vec4 b;",
            "both have location 0",
        ),
        (
            "layout(location = 0) out vec4 a[2]; layout(location = 1) out vec4 b;",
            "both have location 1",
        ),
        (
            "layout(location = 0) out mat2 a; layout(location = 1) out vec4 b;",
            "both have location 1",
        ),
        ("layout(location = 32) out vec4 a; out vec4 b;", "which has 32"),
        (
            "layout(location = 0) out Block { vec4 a; vec4 c; }; layout(location = 1) out vec4 b;",
            "location 1",
        ),
    ] {
        let mut c = context();
        let all = if outputs.contains("a[2]") {
            "a[0] = a[1]"
        } else if outputs.contains("mat2") {
            "a = mat2(1.0)"
        } else if outputs.contains("c;") {
            "a = c = vec4(1.0)"
        } else {
            "a = vec4(1.0)"
        };
        let source = format!(
            "#version 150\n#extension GL_ARB_separate_shader_objects : require\n{outputs}
             void main() {{ gl_Position = vec4(0.0); {all}; b = vec4(1.0); }}"
        );
        let program = c.create_shader_programv(GL_VERTEX_SHADER, 1, Names(vec![&source]));
        assert_eq!(asked(&mut c, program, GL_LINK_STATUS), 0, "{outputs}");
        let said = log(&mut c, program);
        assert!(said.contains(problem), "{outputs}: {said}");
    }
}

/// Transform feedback captures what the last stage before the fragments was linked to capture.
#[test]
fn the_last_stage_is_captured() {
    let mut c = context();
    let vertex = c.create_program();
    let made = shader(&mut c, GL_VERTEX_SHADER, VERTEX);
    c.attach_shader(vertex, made);
    c.program_parameteri(vertex, GL_PROGRAM_SEPARABLE, 1);
    c.transform_feedback_varyings(vertex, 1, Names(vec!["near"]), GL_INTERLEAVED_ATTRIBS);
    c.link_program(vertex);
    let red = fragment(&mut c, "", "vec4(1.0, 0.0, 0.0, 1.0)");
    let stages = [(GL_VERTEX_SHADER_BIT, vertex), (GL_FRAGMENT_SHADER_BIT, red)];
    let bound = pipeline(&mut c, &stages);
    set_tint(&mut c, vertex, [0.25, 0.5, 0.75, 1.0]);
    c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 1);
    c.buffer_data(GL_TRANSFORM_FEEDBACK_BUFFER, 48, Data::Null, GL_STREAM_READ);
    c.begin_transform_feedback(GL_TRIANGLES);
    assert_eq!(drawn(&mut c), [255, 0, 0, 255]);
    // Another active program changes nothing of the pipeline.
    c.active_shader_program(bound, vertex);
    no_error(&mut c);
    c.end_transform_feedback();
    let mut bytes = [0; 16];
    c.get_buffer_sub_data(GL_TRANSFORM_FEEDBACK_BUFFER, 32, 16, DataOut::Bytes(&mut bytes));
    let last = bytes.chunks(4).map(|word| f32::from_le_bytes([word[0], word[1], word[2], word[3]]));
    assert_eq!(last.collect::<Vec<f32>>(), [0.25, 0.5, 0.75, 1.0]);
    no_error(&mut c);
}
