//! Vertex arrays, transform feedback, queries, samplers and pipelines by name and bound.

use crate::{Twin, context, flags, integer, run};
use gl_api::*;

macro_rules! twins {
    ($($name:ident: $named:expr, $bound:expr;)*) => {
        &[$(Twin { name: stringify!($name), named: $named, bound: $bound }),*]
    };
}

/// Buffers 1 and 2.
fn with_buffers() -> Context {
    let mut c = context();
    c.create_buffers(2, &mut [0; 2]);
    let corners: [f32; 6] = [-1.0, -1.0, 3.0, -1.0, -1.0, 3.0];
    let bytes: Vec<u8> = corners.iter().flat_map(|side| side.to_le_bytes()).collect();
    c.named_buffer_data(1, 24, Data::Bytes(&bytes), GL_STATIC_DRAW);
    c.named_buffer_data(2, 3, Data::Bytes(&[0, 1, 2]), GL_STATIC_DRAW);
    assert_eq!(flags(&mut c), GL_NO_ERROR, "{:?}", c.messages());
    c
}

/// What is known of the attributes and binding points of the bound object.
fn arrays(c: &mut Context) -> Vec<GLint> {
    let mut all = vec![integer(c, GL_ELEMENT_ARRAY_BUFFER_BINDING)];
    for index in 0..4 {
        for pname in [
            GL_VERTEX_ATTRIB_ARRAY_ENABLED,
            GL_VERTEX_ATTRIB_ARRAY_SIZE,
            GL_VERTEX_ATTRIB_ARRAY_TYPE,
            GL_VERTEX_ATTRIB_ARRAY_NORMALIZED,
            GL_VERTEX_ATTRIB_ARRAY_INTEGER,
            GL_VERTEX_ATTRIB_ARRAY_DIVISOR,
            GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING,
            GL_VERTEX_ATTRIB_BINDING,
            GL_VERTEX_ATTRIB_RELATIVE_OFFSET,
        ] {
            let mut value = [-1];
            c.get_vertex_attribiv(index, pname, &mut value);
            all.push(value[0]);
        }
        for pname in [GL_VERTEX_BINDING_OFFSET, GL_VERTEX_BINDING_STRIDE, GL_VERTEX_BINDING_DIVISOR]
        {
            let mut value = [-1];
            c.get_integeri_v(pname, index, &mut value);
            all.push(value[0]);
        }
    }
    all
}

#[test]
fn vertex_arrays() {
    let (mut named, mut bound) = (with_buffers(), with_buffers());
    named.create_vertex_arrays(1, &mut [0]);
    assert!(named.is_vertex_array(1));
    bound.gen_vertex_arrays(1, &mut [0]);
    bound.bind_vertex_array(1);
    run(
        &mut named,
        1,
        &mut bound,
        twins! {
            enable: |c, v| c.enable_vertex_array_attrib(v, 2), |c| c.enable_vertex_attrib_array(2);
            enable_more: |c, v| c.enable_vertex_array_attrib(v, 1), |c| c.enable_vertex_attrib_array(1);
            disable: |c, v| c.disable_vertex_array_attrib(v, 2), |c| c.disable_vertex_attrib_array(2);
            none: |c, v| c.enable_vertex_array_attrib(v, 16), |c| c.enable_vertex_attrib_array(16);
            format: |c, v| c.vertex_array_attrib_format(v, 1, 2, GL_FLOAT, false, 0), |c| c.vertex_attrib_format(1, 2, GL_FLOAT, false, 0);
            i_format: |c, v| c.vertex_array_attrib_i_format(v, 2, 3, GL_SHORT, 4), |c| c.vertex_attrib_i_format(2, 3, GL_SHORT, 4);
            l_format: |c, v| c.vertex_array_attrib_l_format(v, 3, 1, GL_DOUBLE, 8), |c| c.vertex_attrib_l_format(3, 1, GL_DOUBLE, 8);
            size: |c, v| c.vertex_array_attrib_format(v, 1, 5, GL_FLOAT, false, 0), |c| c.vertex_attrib_format(1, 5, GL_FLOAT, false, 0);
            ty: |c, v| c.vertex_array_attrib_i_format(v, 1, 4, GL_FLOAT, 0), |c| c.vertex_attrib_i_format(1, 4, GL_FLOAT, 0);
            offset: |c, v| c.vertex_array_attrib_format(v, 1, 4, GL_FLOAT, false, 99999), |c| c.vertex_attrib_format(1, 4, GL_FLOAT, false, 99999);
            binding: |c, v| c.vertex_array_attrib_binding(v, 1, 3), |c| c.vertex_attrib_binding(1, 3);
            no_binding: |c, v| c.vertex_array_attrib_binding(v, 1, 99), |c| c.vertex_attrib_binding(1, 99);
            buffer: |c, v| c.vertex_array_vertex_buffer(v, 3, 1, 0, 8), |c| c.bind_vertex_buffer(3, 1, 0, 8);
            no_buffer: |c, v| c.vertex_array_vertex_buffer(v, 3, 77, 0, 8), |c| c.bind_vertex_buffer(3, 77, 0, 8);
            stride: |c, v| c.vertex_array_vertex_buffer(v, 3, 1, 0, -8), |c| c.bind_vertex_buffer(3, 1, 0, -8);
            divisor: |c, v| c.vertex_array_binding_divisor(v, 2, 5), |c| c.vertex_binding_divisor(2, 5);
            elements: |c, v| c.vertex_array_element_buffer(v, 2), |c| c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, 2);
            several: |c, v| c.vertex_array_vertex_buffers(v, 0, 2, &[2, 0], &[1, 2], &[3, 4]),
                |c| { c.bind_vertex_buffer(0, 2, 1, 3); c.bind_vertex_buffer(1, 0, 2, 4); };
        },
    );
    let mut value = [-1];
    named.get_vertex_arrayiv(1, GL_ELEMENT_ARRAY_BUFFER_BINDING, &mut value);
    assert_eq!((value[0], integer(&mut named, GL_ELEMENT_ARRAY_BUFFER_BINDING)), (2, 0));
    for pname in [
        GL_VERTEX_ATTRIB_ARRAY_ENABLED,
        GL_VERTEX_ATTRIB_ARRAY_TYPE,
        GL_VERTEX_ATTRIB_RELATIVE_OFFSET,
    ] {
        for index in 0..4 {
            let (mut one, mut other) = ([-1], [-1]);
            named.get_vertex_array_indexediv(1, index, pname, &mut one);
            bound.get_vertex_attribiv(index, pname, &mut other);
            assert_eq!(one, other, "{} of {index}", enum_name(pname));
        }
    }
    let mut offset = [-1];
    named.get_vertex_array_indexed64iv(1, 0, GL_VERTEX_BINDING_OFFSET, &mut offset);
    assert_eq!(offset, [1]);
    assert_eq!(integer(&mut named, GL_VERTEX_ARRAY_BINDING), 0);
    named.bind_vertex_array(1);
    assert_eq!(arrays(&mut named), arrays(&mut bound));
    assert_eq!((flags(&mut named), flags(&mut bound)), (GL_NO_ERROR, GL_NO_ERROR));
}

/// A shader pair whose position is attribute 1.
fn program(c: &mut Context) -> GLuint {
    let program = c.create_program();
    let sources = [
        (GL_VERTEX_SHADER, "attribute vec2 at; void main() { gl_Position = vec4(at, 0.0, 1.0); }"),
        (GL_FRAGMENT_SHADER, "void main() { gl_FragColor = vec4(1.0, 0.0, 1.0, 1.0); }"),
    ];
    for (stage, source) in sources {
        let shader = c.create_shader(stage);
        c.shader_source(shader, 1, Strings(vec![source]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.bind_attrib_location(program, 1, "at");
    c.link_program(program);
    program
}

#[test]
fn a_draw_of_arrays_that_were_never_bound_before() {
    let mut c = with_buffers();
    c.create_vertex_arrays(1, &mut [0]);
    c.vertex_array_attrib_format(1, 1, 2, GL_FLOAT, false, 0);
    c.vertex_array_attrib_binding(1, 1, 0);
    c.vertex_array_vertex_buffer(1, 0, 1, 0, 8);
    c.vertex_array_element_buffer(1, 2);
    c.enable_vertex_array_attrib(1, 1);
    let program = program(&mut c);
    c.use_program(program);
    c.bind_vertex_array(1);
    c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, Data::Offset(0));
    let mut pixel = [0; 4];
    c.read_pixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!((pixel, flags(&mut c)), ([255, 0, 255, 255], GL_NO_ERROR), "{:?}", c.messages());
}

#[test]
fn transform_feedback_objects() {
    let (mut named, mut bound) = (with_buffers(), with_buffers());
    named.create_transform_feedbacks(1, &mut [0]);
    assert!(named.is_transform_feedback(1));
    bound.gen_transform_feedbacks(1, &mut [0]);
    bound.bind_transform_feedback(GL_TRANSFORM_FEEDBACK, 1);
    const T: GLenum = GL_TRANSFORM_FEEDBACK_BUFFER;
    run(
        &mut named,
        1,
        &mut bound,
        twins! {
            base: |c, x| c.transform_feedback_buffer_base(x, 0, 1), |c| c.bind_buffer_base(T, 0, 1);
            range: |c, x| c.transform_feedback_buffer_range(x, 2, 1, 4, 16), |c| c.bind_buffer_range(T, 2, 1, 4, 16);
            odd: |c, x| c.transform_feedback_buffer_range(x, 2, 1, 2, 16), |c| c.bind_buffer_range(T, 2, 1, 2, 16);
            empty: |c, x| c.transform_feedback_buffer_range(x, 2, 1, 4, 0), |c| c.bind_buffer_range(T, 2, 1, 4, 0);
            index: |c, x| c.transform_feedback_buffer_base(x, 4, 1), |c| c.bind_buffer_base(T, 4, 1);
        },
    );
    assert_eq!(integer(&mut named, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING), 0, "the generic binding");
    for index in 0..4 {
        let (mut one, mut other, mut start, mut size, mut others) =
            ([-1], [-1], [-1], [-1], [-1; 2]);
        named.get_transform_feedbacki_v(1, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, index, &mut one);
        bound.get_integeri_v(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, index, &mut other);
        named.get_transform_feedbacki64_v(1, GL_TRANSFORM_FEEDBACK_BUFFER_START, index, &mut start);
        named.get_transform_feedbacki64_v(1, GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, index, &mut size);
        bound.get_integer64i_v(GL_TRANSFORM_FEEDBACK_BUFFER_START, index, &mut others[..1]);
        bound.get_integer64i_v(GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, index, &mut others[1..]);
        assert_eq!((one, [start[0], size[0]]), (other, others), "{index}");
    }
    for pname in [GL_TRANSFORM_FEEDBACK_ACTIVE, GL_TRANSFORM_FEEDBACK_PAUSED] {
        let mut value = [-1];
        named.get_transform_feedbackiv(1, pname, &mut value);
        assert_eq!(value, [0]);
    }
    assert_eq!((flags(&mut named), flags(&mut bound)), (GL_NO_ERROR, GL_NO_ERROR));
}

#[test]
fn queries_have_their_target_and_answer_to_buffers() {
    let mut c = with_buffers();
    let targets = [GL_SAMPLES_PASSED, GL_TIMESTAMP, GL_PRIMITIVES_GENERATED];
    for (target, name) in targets.into_iter().zip(1..) {
        let mut names = [0];
        c.create_queries(target, 1, &mut names);
        let (mut has, mut available, mut result) = ([0], [0], [99]);
        c.get_query_objectuiv(name, GL_QUERY_TARGET, &mut has);
        c.get_query_objectuiv(name, GL_QUERY_RESULT_AVAILABLE, &mut available);
        c.get_query_objectuiv(name, GL_QUERY_RESULT, &mut result);
        assert!(c.is_query(name));
        assert_eq!((names, has, available, result), ([name], [target], [1], [0]));
    }
    c.begin_query(GL_PRIMITIVES_GENERATED, 1);
    assert_eq!(flags(&mut c), GL_INVALID_OPERATION, "it is one of samples");
    c.begin_query(GL_SAMPLES_PASSED, 1);
    c.rectf(-1.0, -1.0, 1.0, 1.0);
    c.end_query(GL_SAMPLES_PASSED);
    c.named_buffer_data(1, 40, Data::Bytes(&[0xee; 40]), GL_STATIC_DRAW);
    c.get_query_buffer_objectiv(1, 1, GL_QUERY_RESULT, 4);
    c.get_query_buffer_objectuiv(1, 1, GL_QUERY_RESULT_NO_WAIT, 8);
    c.get_query_buffer_objecti64v(1, 1, GL_QUERY_TARGET, 16);
    c.get_query_buffer_objectui64v(1, 1, GL_QUERY_RESULT_AVAILABLE, 24);
    let mut bytes = [0; 40];
    c.get_named_buffer_sub_data(1, 0, 40, DataOut::Bytes(&mut bytes));
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four"));
    assert_eq!([0, 4, 8, 12].map(word), [0xeeee_eeee, 64, 64, 0xeeee_eeee]);
    assert_eq!([16, 20, 24, 28, 32].map(word), [GL_SAMPLES_PASSED, 0, 1, 0, 0xeeee_eeee]);
    assert_eq!(flags(&mut c), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn samplers_and_pipelines_exist_at_once() {
    let mut c = context();
    let (mut samplers, mut pipelines) = ([0; 2], [0; 2]);
    c.create_samplers(2, &mut samplers);
    c.create_program_pipelines(2, &mut pipelines);
    for at in 0..2 {
        assert!(c.is_sampler(samplers[at]) && c.is_program_pipeline(pipelines[at]));
    }
    c.create_transform_feedbacks(1, &mut [0]);
    for (identifier, name) in
        [(GL_PROGRAM_PIPELINE, 2), (GL_TRANSFORM_FEEDBACK, 1), (GL_SAMPLER, 2)]
    {
        c.object_label(identifier, name, -1, "own");
        let mut length = [0];
        c.get_object_label(identifier, name, 0, &mut length, TextOut::Null);
        assert_eq!(length, [3], "{}", enum_name(identifier));
    }
    assert_eq!(flags(&mut c), GL_NO_ERROR);
}
