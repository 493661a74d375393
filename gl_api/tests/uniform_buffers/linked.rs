//! What a link finds: blocks and their uniforms, and what does not fit together.

use super::{BEGIN, context, draw, fine, floats, of_block, of_uniform, shading};
use gl_api::glsl::{Bindings, Options, Stage, compile, link};
use gl_api::*;

#[test]
fn blocks_and_uniforms_can_be_asked_for() {
    let mut c = context();
    let blocks = "uniform One { float a; vec4 b[3]; };\n\
        layout(std140) uniform Second { mat3 m; };\n\
        layout(packed) uniform Gone { float gone; };\n";
    let vertex = format!("{BEGIN}{blocks} void main() {{ gl_Position = b[0]; }}");
    let fragment = format!(
        "{BEGIN}{blocks} uniform vec2 own[2];\n\
         void main() {{ gl_FragColor = vec4(own[0] + own[1] + m[0].xy + a, 0.0, gl_Fog.density); }}"
    );
    let program = shading::use_program(&mut c, &vertex, &fragment);
    let mut value = [0];
    for (pname, expected) in
        [(GL_ACTIVE_UNIFORM_BLOCKS, 2), (GL_ACTIVE_UNIFORM_BLOCK_MAX_NAME_LENGTH, 7)]
    {
        c.get_programiv(program, pname, &mut value);
        assert_eq!(value, [expected], "{}", enum_name(pname));
    }
    for (index, name) in ["One", "Second"].into_iter().enumerate() {
        let index = index as u32;
        assert_eq!(c.get_uniform_block_index(program, name), index);
        let (mut length, mut text) = ([0], [0; 16]);
        c.get_active_uniform_block_name(program, index, 16, &mut length, TextOut::Bytes(&mut text));
        assert_eq!(&text[..length[0] as usize], name.as_bytes());
    }
    for name in ["Gone", "one", "a", ""] {
        assert_eq!(c.get_uniform_block_index(program, name), GL_INVALID_INDEX, "{name}");
    }
    for (block, pname, expected) in [
        ("One", GL_UNIFORM_BLOCK_NAME_LENGTH, 4),
        ("One", GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS, 2),
        ("One", GL_UNIFORM_BLOCK_DATA_SIZE, 64),
        ("One", GL_UNIFORM_BLOCK_REFERENCED_BY_VERTEX_SHADER, 1),
        ("One", GL_UNIFORM_BLOCK_REFERENCED_BY_FRAGMENT_SHADER, 1),
        ("One", GL_UNIFORM_BLOCK_REFERENCED_BY_GEOMETRY_SHADER, 0),
        ("Second", GL_UNIFORM_BLOCK_REFERENCED_BY_VERTEX_SHADER, 0),
        ("Second", GL_UNIFORM_BLOCK_REFERENCED_BY_FRAGMENT_SHADER, 1),
        ("Second", GL_UNIFORM_BLOCK_BINDING, 0),
    ] {
        assert_eq!(
            of_block(&mut c, program, block, pname),
            expected,
            "{block} {}",
            enum_name(pname)
        );
    }
    // Type, size, length of the name, block, offset, strides, order.
    let pnames = [
        GL_UNIFORM_TYPE,
        GL_UNIFORM_SIZE,
        GL_UNIFORM_NAME_LENGTH,
        GL_UNIFORM_BLOCK_INDEX,
        GL_UNIFORM_OFFSET,
        GL_UNIFORM_ARRAY_STRIDE,
        GL_UNIFORM_MATRIX_STRIDE,
        GL_UNIFORM_IS_ROW_MAJOR,
    ];
    for (name, expected) in [
        ("own", [GL_FLOAT_VEC2 as i32, 2, 7, -1, -1, -1, -1, 0]),
        ("a", [GL_FLOAT as i32, 1, 2, 0, 0, 0, 0, 0]),
        ("b[0]", [GL_FLOAT_VEC4 as i32, 3, 5, 0, 16, 16, 0, 0]),
        ("m", [GL_FLOAT_MAT3 as i32, 1, 2, 1, 0, 0, 16, 0]),
        ("gl_Fog.density", [GL_FLOAT as i32, 1, 15, -1, -1, -1, -1, 0]),
    ] {
        let found = pnames.map(|pname| of_uniform(&mut c, program, name, pname));
        assert_eq!(found, expected, "{name}");
    }
    // Every index has the name that has the index.
    c.get_programiv(program, GL_ACTIVE_UNIFORMS, &mut value);
    for index in 0..value[0] as u32 {
        let (mut length, mut text) = ([0], [0; 64]);
        c.get_active_uniform_name(program, index, 64, &mut length, TextOut::Bytes(&mut text));
        let name = std::str::from_utf8(&text[..length[0] as usize]).expect("ASCII").to_owned();
        let mut indices = [0; 2];
        c.get_uniform_indices(program, 2, Names(vec![&name, "nothing"]), &mut indices);
        assert_eq!(indices, [index, GL_INVALID_INDEX], "{name}");
        let (mut size, mut ty, mut other) = ([0], [0], [0; 64]);
        c.get_active_uniform(
            program,
            index,
            64,
            &mut length,
            &mut size,
            &mut ty,
            TextOut::Bytes(&mut other),
        );
        assert_eq!(text, other);
        let location = c.get_uniform_location(program, &name);
        assert_eq!(location >= 0, name.starts_with("own"), "{name}: {location}");
    }
    for name in ["gone", "B.a", "One.a", "b[1]"] {
        let mut index = [0];
        c.get_uniform_indices(program, 1, Names(vec![name]), &mut index);
        assert_eq!(index, [GL_INVALID_INDEX], "{name}");
    }
    fine(&mut c);
}

/// A program that is not linked has no blocks; asking is no error.
#[test]
fn what_is_not_linked_has_none() {
    let mut c = context();
    let program = c.create_program();
    assert_eq!(c.get_uniform_block_index(program, "B"), GL_INVALID_INDEX);
    let (mut value, mut index) = ([9], [9]);
    c.get_programiv(program, GL_ACTIVE_UNIFORM_BLOCKS, &mut value);
    c.get_uniform_indices(program, 1, Names(vec!["a"]), &mut index);
    assert_eq!((value, index), ([0], [GL_INVALID_INDEX]));
    fine(&mut c);
    assert_eq!(c.get_uniform_block_index(99, "B"), GL_INVALID_INDEX);
    assert_eq!(c.get_error(), GL_INVALID_VALUE);
}

/// What a vertex and a fragment shader declare, and words of why they do not link.
const UNLIKE: &[(&str, &str, &str)] = &[
    ("uniform B { vec4 a; };", "uniform B { vec4 b; };", "other members"),
    ("uniform B { vec4 a; };", "uniform B { vec3 a; };", "other members"),
    ("uniform B { vec4 a; };", "uniform B { ivec4 a; };", "other members"),
    ("uniform B { vec4 a; };", "uniform B { vec4 a; vec4 b; };", "other members"),
    ("uniform B { vec4 a, b; };", "uniform B { vec4 b, a; };", "other members"),
    ("uniform B { vec4 a; };", "layout(std140) uniform B { vec4 a; };", "another layout"),
    ("uniform B { mat4 a; };", "uniform B { layout(row_major) mat4 a; };", "another layout"),
    ("uniform B { vec4 a; };", "uniform C { vec4 a; };", "in the uniform blocks"),
    ("uniform B { vec4 a; };", "uniform vec4 a;", "a uniform of its own"),
    ("uniform B { vec4 a[4097]; };", "", "takes 65552 bytes"),
    ("uniform B { float a[32000]; };", "", "GL_MAX_UNIFORM_BLOCK_SIZE"),
];

fn logs(vertex: &str, fragment: &str) -> (bool, String) {
    let main = "void main() {}";
    let vertex = format!("{BEGIN}{vertex}\nvoid main() {{ gl_Position = vec4(0.0); }}");
    let fragment = format!("{BEGIN}{fragment}\n{main}");
    let shaders = [(Stage::Vertex, vertex), (Stage::Fragment, fragment)].map(|(stage, source)| {
        let compiled = compile(stage, &source, &Options::default());
        compiled.shader.unwrap_or_else(|| panic!("{source}\n{}", compiled.log))
    });
    let linked = link(&[&shaders[0], &shaders[1]], &Bindings::default());
    (linked.program.is_some(), linked.log)
}

#[test]
fn unlike_blocks_do_not_link() {
    for (vertex, fragment, words) in UNLIKE {
        let (links, log) = logs(vertex, fragment);
        assert!(!links && log.contains(words), "{vertex} {fragment}: {log}");
    }
    let largest = "uniform B { vec4 a[4096]; };";
    let (links, log) = logs(largest, largest);
    assert!(links, "{log}");
}

/// As many blocks as a stage may read, and one more.
#[test]
fn a_stage_has_so_many_blocks() {
    let mut c = context();
    let mut limit = [0];
    c.get_integerv(GL_MAX_VERTEX_UNIFORM_BLOCKS, &mut limit);
    for (count, fits) in [(limit[0], true), (limit[0] + 1, false)] {
        let blocks: String =
            (0..count).map(|n| format!("uniform B{n} {{ float f{n}; }};\n")).collect();
        let sum: Vec<String> = (0..count).map(|n| format!("f{n}")).collect();
        let source =
            format!("{BEGIN}{blocks} void main() {{ gl_Position = vec4({}); }}", sum.join(" + "));
        let compiled = compile(Stage::Vertex, &source, &Options::default());
        let linked = link(&[&compiled.shader.expect("valid")], &Bindings::default());
        assert_eq!(linked.program.is_some(), fits, "{count}: {}", linked.log);
    }
}

/// What no shader may say, and words of why.
const WRONG: &[(&str, &str)] = &[
    ("uniform B { sampler2D s; };", "no samplers"),
    ("uniform B { float f = 1.0; };", "takes no value"),
    ("uniform B { float f[]; };", "needs a size"),
    ("uniform B { uniform C { float f; }; };", "expected"),
    ("uniform B { };", "needs a member"),
    ("uniform B { in float f; };", "takes `layout"),
    ("uniform B { layout(std140) float f; };", "of a whole block"),
    ("uniform B { float f; float f; };", "declared already"),
    ("uniform B { float f; }; float f;", "declared already"),
    ("uniform B { float f; }; float B;", "declared already"),
    ("uniform B { float f; }; void B() {}", "declared already"),
    ("uniform B { float f; }; void g() { f = 1.0; }", "cannot assign"),
    ("uniform B { float f; }; float g() { return B.f; }", "not a variable"),
    ("uniform B { float f; } b;", "no name behind it"),
    ("const uniform B { float f; };", "stand `layout(...)` and `uniform`"),
    ("layout(std140) uniform float f;", "only uniform blocks"),
    ("layout(row_major) uniform mat4 m;", "only uniform blocks"),
    ("layout(std430) uniform B { float f; };", "is no layout"),
    ("in B { float f; };", "blocks of inputs and outputs are not in GLSL 1.30"),
];

#[test]
fn wrong_blocks_are_reported() {
    for (source, words) in WRONG {
        let source = format!("{BEGIN}{source}\nvoid main() {{}}");
        let compiled = compile(Stage::Fragment, &source, &Options::default());
        assert!(compiled.shader.is_none(), "{source}");
        assert!(compiled.log.contains(words), "{source}\n{}", compiled.log);
    }
}

/// Blocks come with the extension, and the words of their layouts are names without it.
#[test]
fn without_the_extension_there_are_none() {
    let block = "uniform B { float f; };\nvoid main() {}";
    for version in [110, 120, 130] {
        let source = format!("#version {version}\n{block}");
        let compiled = compile(Stage::Fragment, &source, &Options::default());
        assert!(compiled.shader.is_none());
        assert!(
            compiled.log.contains("`#extension GL_ARB_uniform_buffer_object"),
            "{}",
            compiled.log
        );
        let source = format!(
            "#version {version}\n#extension GL_ARB_uniform_buffer_object : warn\n\
             #if GL_ARB_uniform_buffer_object != 1\n#error\n#endif\n{block}"
        );
        let compiled = compile(Stage::Fragment, &source, &Options::default());
        assert!(compiled.shader.is_some(), "{}", compiled.log);
        assert!(
            compiled.log.contains("come from GL_ARB_uniform_buffer_object"),
            "{}",
            compiled.log
        );
    }
    let names = "float std140, shared, column_major; void main() {}";
    assert!(compile(Stage::Fragment, names, &Options::default()).shader.is_some());
}

/// Each block of an array of arrays has a name and a buffer of its own (`ARB_arrays_of_arrays`).
#[test]
fn blocks_of_arrays_of_arrays_have_buffers_of_their_own() {
    let mut c = context();
    let vertex = "#version 150\n#extension GL_ARB_arrays_of_arrays : require\n\
        uniform Block { float a[2]; } many[2][3];\n\
        out float found[6]; out ivec2 lengths;\n\
        void main() {\n\
          found = float[6](many[0][0].a[1], many[0][1].a[1], many[0][2].a[1],\n\
                           many[1][0].a[1], many[1][1].a[1], many[1][2].a[1]);\n\
          lengths = ivec2(many.length(), many[1].length()); gl_Position = vec4(0.0);\n\
        }";
    let program = shading::use_program(&mut c, &vertex.replace("out ivec2", "flat out ivec2"), "");
    let names = Names(vec!["found", "lengths"]);
    c.transform_feedback_varyings(program, 2, names, GL_INTERLEAVED_ATTRIBS);
    c.link_program(program);
    c.use_program(program);
    fine(&mut c);
    for outer in 0..2 {
        for inner in 0..3 {
            let name = format!("Block[{outer}][{inner}]");
            let index = c.get_uniform_block_index(program, &name);
            let binding = 3 * outer + inner + 1;
            c.uniform_block_binding(program, index, binding);
            floats(&mut c, binding, &[0.0, 0.0, 0.0, 0.0, binding as f32, 0.0, 0.0, 0.0]);
            c.bind_buffer_base(GL_UNIFORM_BUFFER, binding, binding);
        }
    }
    fine(&mut c);
    let found = draw(&mut c, 8);
    let expected: Vec<u32> = (1..7).map(|value| (value as f32).to_bits()).chain([2, 3]).collect();
    assert_eq!(found, expected);
    for (wrong, words) in [
        ("many[0].a[1]", "an index is missing before the member"),
        ("many[0][1][2].a[1]", "no array of them"),
        ("float(many[0][1].length())", "no array of them"),
    ] {
        let vertex = vertex.replace("float[6](many[0][0].a[1]", &format!("float[6]({wrong}"));
        let compiled = compile(Stage::Vertex, &vertex, &Options::default());
        let log = compiled.log;
        assert!(compiled.shader.is_none() && log.contains(words), "{wrong}: {log}");
    }
}
