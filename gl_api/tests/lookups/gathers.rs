//! `textureGather` (ARB_texture_gather): which four texels, in which order, on every kind of sampler.

use super::textures::{Kind, SHIFT, Texels};
use super::{Stage, context, drawn, program, run};
use gl_api::*;

const PREAMBLE: &str = "#version 130\n#extension GL_ARB_texture_gather : require\n\
                        #extension GL_ARB_texture_cube_map_array : enable\n";

/// The face +Y, where s = x / 2 + 1/2 and t = z / 2 + 1/2: about (0.5, 0.5), columns and rows 1 and 2 of 4.
const TOP: &str = "0.1, 1.0, 0.1";

/// Of every kind of sampler, coordinates with the texels 2 and 3 along s, or 1 and 2 of a cube.
const ROWS: [(&str, GLenum, [i32; 3], &str, i32); 4] = [
    ("2D", GL_TEXTURE_2D, [8, 4, 1], "vec2(0.4, 0.6)", 2),
    ("2DArray", GL_TEXTURE_2D_ARRAY, [8, 4, 3], "vec3(0.4, 0.6, 1.7)", 2),
    ("Cube", GL_TEXTURE_CUBE_MAP, [4, 4, 1], "vec3(TOP)", 1),
    ("CubeArray", GL_TEXTURE_CUBE_MAP_ARRAY, [4, 4, 12], "vec4(TOP, 1.0)", 1),
];

#[test]
fn every_sampler_gives_the_columns_of_four_texels_in_order() {
    let _current = context();
    for (name, target, size, coords, low) in ROWS {
        for (prefix, kind, bytes) in [
            ("", Kind::Float, "G".to_owned()),
            ("i", Kind::Int, format!("vec4(-(G) - {SHIFT}) / 255.0")),
            ("u", Kind::Uint, "vec4(G - 0x80000000u) / 255.0".to_owned()),
        ] {
            let coords = coords.replace("TOP", TOP);
            let mut calls = vec![(format!("textureGather(s, {coords})"), 0)];
            if name.starts_with("2D") {
                let off = format!("textureGatherOffset(s, {coords}, ivec2(-1, 31))");
                calls.push((off, -1));
            }
            for (call, offset) in calls {
                let body = format!("r = {};", bytes.replace('G', &call));
                let sampler = format!("{prefix}sampler{name}");
                for stage in [Stage::Vertex, Stage::Fragment] {
                    let texels = Texels { target, size, kind };
                    let got = run(stage, PREAMBLE, &sampler, &body, texels);
                    let [left, right] = [low, low + 1].map(|column| (column + offset) as u8);
                    assert_eq!(got, Ok([left, right, right, left]), "{sampler}: {body}");
                }
            }
        }
    }
}

/// A texture of 5×3 whose texels have numbers, row by row from 1, and a border of 200.
fn numbered(wrap: GLenum) {
    glDeleteTextures(1, &1);
    glBindTexture(GL_TEXTURE_2D, 1);
    let texels: [u8; 15] = std::array::from_fn(|at| at as u8 + 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, 5, 3, 0, GL_RED, GL_UNSIGNED_BYTE, &texels);
    for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        glTexParameteri(GL_TEXTURE_2D, pname, GL_NEAREST);
    }
    for pname in [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T] {
        glTexParameteri(GL_TEXTURE_2D, pname, wrap);
    }
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[200.0 / 255.0, 0.0, 0.0, 1.0]);
}

/// OpenGL 3.2, table 3.20: which of `n` texels stands for `i`; -1 and `n` are the border.
fn wrapped(wrap: GLenum, i: i32, n: i32) -> i32 {
    let mirror = |i: i32| if i >= 0 { i } else { -(1 + i) };
    match wrap {
        GL_REPEAT => i.rem_euclid(n),
        GL_MIRRORED_REPEAT => (n - 1) - mirror(i.rem_euclid(2 * n) - n),
        GL_CLAMP_TO_EDGE => i.clamp(0, n - 1),
        GL_CLAMP_TO_BORDER => i.clamp(-1, n),
        GL_MIRROR_CLAMP_TO_EDGE => mirror(i).clamp(0, n - 1),
        _ => mirror(i).clamp(0, n),
    }
}

#[test]
fn each_of_the_four_is_wrapped_by_itself() {
    let _current = context();
    let vertex = "void main() { gl_Position = gl_Vertex; }";
    let source = |call: &str| {
        format!(
            "{PREAMBLE} uniform sampler2D s; uniform vec2 p; void main() {{ gl_FragColor = {call}; }}"
        )
    };
    let plain = program(vertex, &source("textureGather(s, p)")).expect("it compiles");
    let off = "textureGatherOffset(s, p, ivec2(-7, 3))";
    let off = program(vertex, &source(off)).expect("it compiles");
    for wrap in [
        GL_REPEAT,
        GL_MIRRORED_REPEAT,
        GL_CLAMP_TO_EDGE,
        GL_CLAMP_TO_BORDER,
        GL_MIRROR_CLAMP_TO_EDGE,
        GL_MIRROR_CLAMP_TO_BORDER_EXT,
    ] {
        numbered(wrap);
        for (program, [dx, dy]) in [(plain, [0, 0]), (off, [-7, 3])] {
            glUseProgram(program);
            for step in -30..30_i32 {
                // A quarter of a texel beside where the lower ones change.
                let (s, t) = (0.5 * f64::from(step) + 0.25, 0.5 * f64::from(7 - step) + 0.25);
                let p = [s / 5.0, t / 3.0].map(|coord| coord as f32);
                glUniform2f(glGetUniformLocation(program, "p"), p[0], p[1]);
                let [i, j] = [s, t].map(|place| (place - 0.5).floor() as i32);
                let texel = |x: i32, y: i32| {
                    let x = wrapped(wrap, i + dx + x, 5);
                    let y = wrapped(wrap, j + dy + y, 3);
                    let inside = (0..5).contains(&x) && (0..3).contains(&y);
                    if inside { (5 * y + x + 1) as u8 } else { 200 }
                };
                let want = [texel(0, 1), texel(1, 1), texel(1, 0), texel(0, 0)];
                assert_eq!(drawn(program), want, "{} {s} {t} {dx} {dy}", enum_name(wrap));
            }
        }
    }
    assert_eq!(glGetError(), GL_NO_ERROR);
}

/// What is gathered is of the base level, whatever the filters are, after the swizzle, and of depths as colours.
#[test]
fn the_first_component_is_that_of_the_base_level_after_the_swizzle() {
    let _current = context();
    let vertex = "void main() { gl_Position = gl_Vertex; }";
    let fragment = format!(
        "{PREAMBLE} uniform sampler2D s;
         void main() {{ gl_FragColor = textureGather(s, gl_FragCoord.xy * 8.0 + 0.5); }}"
    );
    let program = program(vertex, &fragment).expect("it compiles");
    Texels { target: GL_TEXTURE_2D, size: [8, 4, 1], kind: Kind::Float }.bind();
    for pname in [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T] {
        glTexParameteri(GL_TEXTURE_2D, pname, GL_REPEAT);
    }
    // Far apart, so that a sample would be of a small level.
    assert_eq!(drawn(program), [3, 4, 4, 3]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
    assert_eq!(drawn(program), [1, 2, 2, 1]);
    // Rows, then levels.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_GREEN);
    assert_eq!(drawn(program), [1, 1, 0, 0]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_ALPHA);
    assert_eq!(drawn(program), [1; 4]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_ONE);
    assert_eq!(drawn(program), [255; 4]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    assert_eq!(drawn(program), [0; 4], "an incomplete texture");
    glDeleteTextures(1, &1);
    glBindTexture(GL_TEXTURE_2D, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    let depths: [f32; 4] = [0.2, 0.4, 0.6, 0.8];
    let (depth, ty) = (GL_DEPTH_COMPONENT, GL_FLOAT);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, 2, 2, 0, depth, ty, &depths);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
    assert_eq!(drawn(program), [153, 204, 102, 51]);
    glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_ALPHA);
    assert_eq!(drawn(program), [0; 4], "depth as alpha has no red");
}

/// Beyond an edge of a seamless cube are the texels of the other face; beyond a corner the mean of the other three, of
/// integers the one of the face itself.
#[test]
fn over_the_edges_of_a_seamless_cube() {
    let _current = context();
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    let vertex = "void main() { gl_Position = gl_Vertex; }";
    // A texel's number is 16 face + 4 row + column, of 4×4. +X has s = 1/2 - z/2 and t = 1/2 - y/2.
    let number = |face: i32, row: i32, column: i32| 16 * face + 4 * row + column;
    for is_integer in [false, true] {
        glDeleteTextures(1, &1);
        glBindTexture(GL_TEXTURE_CUBE_MAP, 1);
        for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
            glTexParameteri(GL_TEXTURE_CUBE_MAP, pname, GL_NEAREST);
        }
        let (internal, format, ty) = match is_integer {
            true => (GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE),
            false => (GL_R8, GL_RED, GL_UNSIGNED_BYTE),
        };
        for face in 0..6 {
            let texels: [u8; 16] = std::array::from_fn(|at| (16 * face + at) as u8);
            let target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face as u32;
            glTexImage2D(target, 0, internal, 4, 4, 0, format, ty, &texels);
        }
        let (prefix, bytes) = if is_integer { ("u", "vec4(G) / 255.0") } else { ("", "G") };
        let call = bytes.replace('G', "textureGather(s, p)");
        let fragment = format!(
            "{PREAMBLE} uniform {prefix}samplerCube s; uniform vec3 p;
             void main() {{ gl_FragColor = {call}; }}"
        );
        let program = program(vertex, &fragment).expect("it compiles");
        glUseProgram(program);
        let gather = |p: [f32; 3]| {
            glUniform3f(glGetUniformLocation(program, "p"), p[0], p[1], p[2]);
            drawn(program).map(i32::from)
        };
        // Columns -1 and 0, rows 1 and 2: +Z lies to the left, row by row.
        let want = [number(4, 2, 3), number(0, 2, 0), number(0, 1, 0), number(4, 1, 3)];
        assert_eq!(gather([1.0, 0.0, 0.9]), want);
        // Rows -1 and 0, columns 1 and 2: +Y's last column, whose rows run with z, lies above.
        let want = [number(0, 0, 1), number(0, 0, 2), number(2, 1, 3), number(2, 2, 3)];
        assert_eq!(gather([1.0, 0.9, 0.0]), want);
        // The corner above on the left.
        let (left, own, above) = (number(4, 0, 3), number(0, 0, 0), number(2, 3, 3));
        let mean = (f64::from(left + own + above) / 3.0).round() as i32;
        let corner = if is_integer { own } else { mean };
        assert_eq!(gather([1.0, 0.95, 0.95]), [left, own, above, corner]);
        assert_eq!(glGetError(), GL_NO_ERROR);
    }
}

/// What a shader may write, and what a program may ask.
#[test]
fn the_extension_brings_functions_and_limits() {
    let _current = context();
    let texels = Texels { target: GL_TEXTURE_2D, size: [8, 4, 1], kind: Kind::Float };
    let attempt = |preamble: &str, call: &str| {
        let body = format!("r = {call};");
        run(Stage::Fragment, preamble, "sampler2D", &body, texels)
    };
    let enabled = "#extension GL_ARB_texture_gather : enable";
    let plain = "textureGather(s, vec2(0.4, 0.6))";
    assert_eq!(attempt(enabled, plain), Ok([2, 3, 3, 2]));
    assert!(attempt("", plain).is_err_and(|log| log.contains(enabled)));
    let off = |offset: &str| format!("textureGatherOffset(s, vec2(0.4, 0.6), {offset})");
    assert_eq!(attempt(enabled, &off("ivec2(1, 31)")), Ok([3, 4, 4, 3]));
    assert_eq!(attempt(enabled, &off("ivec2(-32)")), Ok([0; 4]));
    for offset in ["ivec2(32, 0)", "ivec2(0, -33)", "ivec2(d)"] {
        let log = attempt(enabled, &off(offset)).expect_err(offset);
        assert!(log.contains("a constant expression from -32 to 31"), "{log}");
    }
    let defined = "GL_ARB_texture_gather != 1\n#error\n#endif\n";
    assert_eq!(attempt(&format!("{enabled}\n#if {defined}"), plain), Ok([2, 3, 3, 2]));
    for (pname, want) in [
        (GL_MIN_PROGRAM_TEXTURE_GATHER_OFFSET_ARB, -32),
        (GL_MAX_PROGRAM_TEXTURE_GATHER_OFFSET_ARB, 31),
        (GL_MAX_PROGRAM_TEXTURE_GATHER_COMPONENTS_ARB, 4),
    ] {
        let mut value = [0];
        glGetIntegerv(pname, &mut value);
        assert_eq!(value, [want], "{}", enum_name(pname));
    }
}
