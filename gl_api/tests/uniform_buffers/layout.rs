//! Where members lie: the example of the specification, and each rule by itself.

use super::{BEGIN, context, of_block, of_uniform, shading};
use gl_api::*;

/// The block that ARB_uniform_buffer_object, section 2.15.3.1.2, works out, with the table that
/// stands there: name, offset, array stride, matrix stride.
const EXAMPLE: &str = "
    struct f_struct { int d; bvec2 e; };
    struct o_struct { uvec3 j; vec2 k; float l[2]; vec2 m; mat3 n[2]; };
    layout(std140) uniform Example {
        float a; vec2 b; vec3 c; f_struct f; float g; float h[2]; mat2x3 i; o_struct o[2];
    };";
const OFFSETS: &[(&str, i32, i32, i32)] = &[
    ("a", 0, 0, 0),
    ("b", 8, 0, 0),
    ("c", 16, 0, 0),
    ("f.d", 32, 0, 0),
    ("f.e", 40, 0, 0),
    ("g", 48, 0, 0),
    ("h", 64, 16, 0),
    ("i", 96, 0, 16),
    ("o[0].j", 128, 0, 0),
    ("o[0].k", 144, 0, 0),
    ("o[0].l", 160, 16, 0),
    ("o[0].m", 192, 0, 0),
    ("o[0].n", 208, 48, 16),
    ("o[1].j", 304, 0, 0),
    ("o[1].k", 320, 0, 0),
    ("o[1].l[0]", 336, 16, 0),
    ("o[1].m", 368, 0, 0),
    ("o[1].n[0]", 384, 48, 16),
];

#[test]
fn the_example_of_the_specification() {
    let mut c = context();
    let vertex = format!("{BEGIN}{EXAMPLE} void main() {{ gl_Position = vec4(a); }}");
    let program = shading::use_program(&mut c, &vertex, "");
    for &(name, offset, array, matrix) in OFFSETS {
        let found = [GL_UNIFORM_OFFSET, GL_UNIFORM_ARRAY_STRIDE, GL_UNIFORM_MATRIX_STRIDE]
            .map(|pname| of_uniform(&mut c, program, name, pname));
        assert_eq!(found, [offset, array, matrix], "{name}");
    }
    assert_eq!(of_block(&mut c, program, "Example", GL_UNIFORM_BLOCK_DATA_SIZE), 480);
    let count = of_block(&mut c, program, "Example", GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS);
    assert_eq!(count as usize, OFFSETS.len());
    // Their indices are those of their names.
    let mut indices = vec![0; OFFSETS.len()];
    let block = c.get_uniform_block_index(program, "Example");
    c.get_active_uniform_blockiv(
        program,
        block,
        GL_UNIFORM_BLOCK_ACTIVE_UNIFORM_INDICES,
        &mut indices,
    );
    for (&(name, ..), &index) in OFFSETS.iter().zip(&indices) {
        let mut by_name = [0];
        c.get_uniform_indices(program, 1, Names(vec![name]), &mut by_name);
        assert_eq!(by_name, [index as u32], "{name}");
    }
}

/// A member, the bytes it has, and the offset of a `float` after it.
const RULES: &[(&str, i32, i32)] = &[
    ("float m;", 4, 4),
    ("bool m;", 4, 4),
    ("vec2 m;", 8, 8),
    ("vec3 m;", 12, 12),
    ("uvec4 m;", 16, 16),
    ("float m[3];", 48, 48),
    ("vec3 m[2];", 32, 32),
    ("mat2 m;", 32, 32),
    ("mat4x2 m;", 64, 64),
    ("layout(row_major) mat4x2 m;", 32, 32),
    ("layout(row_major) mat2x4 m;", 64, 64),
    ("layout(row_major) mat2x3 m[3];", 144, 144),
    ("S m;", 16, 16),
    ("S m[3];", 48, 48),
    ("T m;", 48, 48),
];

/// After a `float`: the member begins at the next multiple of its alignment.
#[test]
fn each_rule() {
    let types = "struct S { float x; }; struct T { vec3 x; S y; bool z; };";
    for packing in ["std140", "shared", "packed"] {
        for &(member, bytes, after) in RULES {
            let mut c = context();
            let vertex = format!(
                "{BEGIN}{types}\nlayout({packing}) uniform B {{ {member} float after; }};\n\
                 void main() {{ gl_Position = vec4(after); }}"
            );
            let program = shading::use_program(&mut c, &vertex, "");
            let offset = of_uniform(&mut c, program, "after", GL_UNIFORM_OFFSET);
            assert_eq!(offset, after, "{packing} {member} of {bytes} bytes");
            let size = of_block(&mut c, program, "B", GL_UNIFORM_BLOCK_DATA_SIZE);
            assert_eq!(size, (after + 4 + 15) / 16 * 16, "{packing} {member}");
        }
    }
}

/// Defaults, the block's words and the member's words, each over what was there before.
#[test]
fn matrices_lie_as_the_last_word_says() {
    let blocks = "
        layout(row_major) uniform;
        uniform A { mat4 a0; layout(column_major) mat4 a1; };
        layout(column_major, std140) uniform B { mat4 b0; layout(row_major) mat4 b1; vec4 b2; };
        uniform C { mat4 c0; };
        layout(row_major, column_major) uniform;
        uniform D { mat4 d0; layout(row_major) uniform mat4 d1[2]; };";
    let mut c = context();
    let vertex =
        format!("{BEGIN}{blocks} void main() {{ gl_Position = a0[0] + b0[0] + c0[0] + d0[0]; }}");
    let program = shading::use_program(&mut c, &vertex, "");
    for (name, rows) in
        [("a0", 1), ("a1", 0), ("b0", 0), ("b1", 1), ("b2", 0), ("c0", 1), ("d0", 0), ("d1", 1)]
    {
        assert_eq!(of_uniform(&mut c, program, name, GL_UNIFORM_IS_ROW_MAJOR), rows, "{name}");
    }
}
