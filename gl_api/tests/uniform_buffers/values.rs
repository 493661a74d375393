//! What a shader reads: each member's words, from the bytes where they lie.

use super::{context, counted, draw, reading, word};
use gl_api::*;

/// Members, the type and the value of what is captured, and the bytes that it comes from.
const TABLE: &[(&str, &str, &str, &[u32])] = &[
    ("float a; float b;", "float", "b", &[4]),
    ("float a; vec2 b;", "vec2", "b", &[8, 12]),
    ("float a; vec3 b;", "vec3", "b", &[16, 20, 24]),
    ("vec3 a; float b;", "float", "b", &[12]),
    ("int a; ivec3 b;", "ivec3", "b", &[16, 20, 24]),
    ("uint a; uvec4 b;", "uvec4", "b", &[16, 20, 24, 28]),
    ("float a[3]; float b;", "float", "a[2]", &[32]),
    ("float a[3]; float b;", "float", "b", &[48]),
    ("uvec2 a[3];", "uvec2", "a[1]", &[16, 20]),
    ("mat3x2 a;", "vec2", "a[2]", &[32, 36]),
    ("mat2x4 a;", "vec4", "a[1]", &[16, 20, 24, 28]),
    ("layout(row_major) mat2x4 a;", "vec4", "a[1]", &[4, 20, 36, 52]),
    ("layout(row_major) mat4x2 a;", "vec2", "a[3]", &[12, 28]),
    ("float s; layout(row_major) mat3 a[2];", "vec3", "a[1][2]", &[72, 88, 104]),
    ("mat3 a[2];", "vec3", "a[1][2]", &[80, 84, 88]),
    ("S s;", "vec2", "s.y", &[8, 12]),
    ("float f; S s[2];", "vec2", "s[1].y", &[72, 76]),
    ("float f; S s[2];", "vec3", "s[1].m[1]", &[96, 100, 104]),
    ("U s[3];", "float", "s[two].y", &[40]),
    ("layout(row_major) S s[2];", "vec3", "s[1].m[1]", &[84, 100, 116]),
    ("S s[2]; float f;", "float", "f", &[96]),
    ("T t[2];", "float", "t[1].s[1].x", &[176]),
    ("float f; struct V { float x; vec2 y; } s[2]; V t;", "vec2", "s[1].y", &[40, 44]),
    ("struct { float x; vec2 y; } s[2]; struct { vec2 y; } t;", "vec2", "t.y", &[32, 36]),
    // Indices that only a draw knows.
    ("vec2 a[4];", "vec2", "a[two]", &[32, 36]),
    ("float f; S s[3];", "float", "s[two].x", &[112]),
    ("mat3 a[3];", "vec3", "a[two][two - 1]", &[112, 116, 120]),
    ("float f; T t[3];", "vec2", "t[two].s[two - 1].y", &[328, 332]),
];

/// S has 48 bytes, or 64 where its matrix of three rows lies row by row; T has 128.
#[test]
fn members_are_read_from_their_bytes() {
    let types = "struct S { float x; vec2 y; mat2x3 m; }; struct T { S s[2]; float f[2]; };\n\
        struct U { vec2 x; float y; }; uniform int two;";
    for &(members, ty, value, bytes) in TABLE {
        let mut c = context();
        let block = format!("{types}\nlayout(std140) uniform B {{ {members} }};");
        let program = reading(&mut c, &block, ty, value);
        let two = c.get_uniform_location(program, "two");
        c.uniform_1i(two, 2);
        counted(&mut c, 1, 1024);
        c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 1);
        let expected: Vec<u32> = bytes.iter().map(|&byte| word(byte)).collect();
        let found = draw(&mut c, expected.len());
        assert_eq!(found, expected, "{members} {value}");
    }
}

/// All that is not zero is true.
#[test]
fn any_bit_is_true() {
    let mut c = context();
    let value = "uvec4(uint(b[0].x), uint(b[0].y), uint(b[1].x), uint(b[1] == bvec2(true, false)))";
    reading(&mut c, "layout(std140) uniform B { bvec2 b[2]; };", "uvec4", value);
    let words: [u32; 6] = [1, 0, 7, 7, 0x8000_0000, 0];
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 1);
    c.buffer_data(GL_UNIFORM_BUFFER, 24, Data::Bytes(&bytes), GL_STATIC_DRAW);
    assert_eq!(draw(&mut c, 4), [1, 0, 1, 1]);
}

/// Both stages read the same block, beside uniforms of their own; packed blocks that nobody names
/// take nothing from anybody.
#[test]
fn both_stages_read_a_block() {
    let mut c = context();
    let block = "layout(std140) uniform B { vec4 place; vec4 color; };\n\
        layout(packed) uniform Unused { vec4 nothing; };\n\
        layout(std140) uniform Other { vec4 more; };\n";
    let begin = super::BEGIN;
    super::shading::use_program(
        &mut c,
        &format!(
            "{begin}{block} uniform vec4 own; void main() {{ gl_Position = gl_Vertex * place + own; }}"
        ),
        &format!("{begin}{block} void main() {{ gl_FragColor = color; }}"),
    );
    let values = [1.0, 1.0, 1.0, 1.0, 0.25, 0.5, 0.75, 1.0];
    super::floats(&mut c, 1, &values);
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 1);
    c.rectf(-1.0, -1.0, 1.0, 1.0);
    let mut pixel = [0; 4];
    c.read_pixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(pixel, [64, 128, 191, 255]);
    super::fine(&mut c);
}
