//! The preprocessor (GLSL 1.30 section 3.3) and GLSL ES 1.00.

use super::Row;
use gl_api::glsl::{FixIts, Options, Stage, compile_strings};
use gl_api::*;

pub const TABLE: &[Row] = &[
    // The preprocessor
    Row(
        110,
        "#define TWICE(a) ((a) + (a))\n#define SUM(a, b) TWICE(a) + b\n",
        "r.x = SUM(u.x, TWICE(u.y));",
        [6.0, 0.0, 0.0, 0.0],
    ),
    Row(
        120,
        "#if __VERSION__ >= 120 && defined(GL_ARB_draw_buffers)\nconst float c = 1.0;\n#else\nconst float c = 2.0;\n#endif\n",
        "r.x = c;",
        [1.0, 0.0, 0.0, 0.0],
    ),
    Row(
        130,
        "#define JOIN(a, b) a##b\n",
        "float ab = 4.0; r.x = JOIN(a, b);",
        [4.0, 0.0, 0.0, 0.0],
    ),
    // The preprocessor
    Row(110, "#define ONE 1.0\n#undef ONE\n#define ONE 2.0\n", "r.x = ONE;", [2.0, 0.0, 0.0, 0.0]),
    Row(110, "#define EMPTY\n#define F() 3.0\n", "r.x = EMPTY F() EMPTY;", [3.0, 0.0, 0.0, 0.0]),
    Row(
        110,
        "#define F(a) (a)\n#define G F\n",
        "r.xy = vec2(G(4.0), F((1.0, 2.0)));",
        [4.0, 2.0, 0.0, 0.0],
    ),
    Row(110, "#define A B\n#define B A\n", "r.x = 1.0;", [1.0, 0.0, 0.0, 0.0]),
    Row(
        110,
        "#if defined A || !defined(B) && 1\n#define X 1.0\n#elif 1\n#define X 2.0\n#else\n#define X 3.0\n#endif\n",
        "r.x = X;",
        [1.0, 0.0, 0.0, 0.0],
    ),
    Row(
        110,
        "#if 0\n#error no\n#elif (3 > 2) == 1 && (7 & 3) == 3 && 1 << 2 == 4\nconst float c = 5.0;\n#endif\n",
        "r.x = c;",
        [5.0, 0.0, 0.0, 0.0],
    ),
    Row(
        110,
        "#if 0 && 1 / 0\n#else\nconst float c = 6.0;\n#endif\n",
        "r.x = c;",
        [6.0, 0.0, 0.0, 0.0],
    ),
    Row(110, "#ifndef GL_ES\nconst float c = 1.0;\n#endif\n", "r.x = c;", [1.0, 0.0, 0.0, 0.0]),
    Row(110, "#line 41\n", "r.x = 1.0;", [1.0, 0.0, 0.0, 0.0]),
    Row(
        110,
        "#line 5 7\nfloat l = float(__LINE__), f = float(__FILE__);\n",
        "r.xyz = vec3(l, f, __VERSION__);",
        [6.0, 7.0, 110.0, 0.0],
    ),
    Row(
        120,
        "#extension GL_ARB_texture_rectangle : enable\n#ifdef GL_ARB_texture_rectangle\nuniform sampler2DRect never;\n#endif\n",
        "r.x = float(__VERSION__);",
        [120.0, 0.0, 0.0, 0.0],
    ),
    Row(
        120,
        "#extension GL_EXT_gpu_shader4 : require\n",
        "r = vec4(7 % k, 1 << 3, abs(-k), max(3, k));",
        [1.0, 8.0, 2.0, 3.0],
    ),
    Row(
        120,
        "#extension all : disable\n#pragma anything(goes)\n#pragma STDGL invariant(all)\n",
        "r.x = 1.0; // a comment \\\n r.y = 2.0; /* another\n */ r.z = 3.0;",
        [1.0, 2.0, 3.0, 0.0],
    ),
    Row(
        130,
        "#define P(a, b) a ## b\n#define Q P(1, .5)\n",
        "r.x = Q; int P(n, 1) = 3; r.y = float(n1);",
        [1.5, 3.0, 0.0, 0.0],
    ),
    Row(
        110,
        "#define MAX(a, b) ((a) > (b) ? (a) : (b))\n",
        "r.x = MAX(MAX(u.x, u.w),\n  u.y);",
        [4.0, 0.0, 0.0, 0.0],
    ),
    // GLSL ES 1.00
    Row(100, "precision mediump float;\n", "r = u;", [1.0, 2.0, 3.0, 4.0]),
    Row(
        100,
        "precision mediump float;\n#ifdef GL_ES\nconst lowp float c = 2.0;\n#endif\n",
        "highp vec2 v = u.zw; r = vec4(c, v, __VERSION__);",
        [2.0, 3.0, 4.0, 100.0],
    ),
    Row(
        100,
        "precision mediump float;\n",
        "r = vec4(gl_MaxVaryingVectors, gl_MaxFragmentUniformVectors, gl_MaxVertexUniformVectors, gl_MaxDrawBuffers);",
        [16.0, 4096.0, 4096.0, 8.0],
    ),
    Row(
        100,
        "#extension GL_OES_standard_derivatives : enable\nprecision mediump float;\n",
        "r.x = dFdx(x) + fwidth(x);",
        [2.0, 0.0, 0.0, 0.0],
    ),
    // `##` joins what is written, which is then expanded; an empty argument joins as nothing
    Row(
        130,
        "#define A 1.0\n#define AB 5.0\n#define CAT(x, y) x##y\n",
        "r.x = CAT(A, B);",
        [5.0, 0.0, 0.0, 0.0],
    ),
    Row(
        130,
        "#define A 1\n#define CAT(x, y) x##y\n#define XCAT(x, y) CAT(x, y) + x\n",
        "r.x = XCAT(A, 2);",
        [13.0, 0.0, 0.0, 0.0],
    ),
    Row(130, "#define F(x, y) 3 + x##y\n", "r.x = F(, 4);", [7.0, 0.0, 0.0, 0.0]),
    Row(
        130,
        "#define F(x, y) int x##y\n",
        "F(, q) = 3; F(n, ) = 4; r.xy = vec2(q, n);",
        [3.0, 4.0, 0.0, 0.0],
    ),
    Row(
        130,
        "#define F(x, y, z) 4 x##y##z\n",
        "r = vec4(F(,,), F(+ 1, 2, ), F(, + 1, 0), F(,,+ 1));",
        [4.0, 16.0, 14.0, 5.0],
    ),
    Row(
        130,
        "#define F(x, y, z) x##y##z\n",
        "int F(a, b, c) = 3; int F(a, , c) = 4; int F(, , c) = 5; r.xyz = vec3(abc, ac, c);",
        [3.0, 4.0, 5.0, 0.0],
    ),
    Row(130, "#define F(x, y) x##y\n", "r.x = F(1 + 2, 3 + 4);", [28.0, 0.0, 0.0, 0.0]),
    // Every desktop compiler joins before 1.30, too
    Row(
        110,
        "#define JOIN(a, b) a##b\n#define F(x, y, z) 4 x##y##z\n",
        "float ab = 4.0; r.xy = vec2(JOIN(a, b), F(, + 1, 0));",
        [4.0, 14.0, 0.0, 0.0],
    ),
    Row(
        120,
        "#define A 1\n#define CAT(x, y) x##y\n#define XCAT(x, y) CAT(x, y) + x\n",
        "r.x = float(XCAT(A, 2));",
        [13.0, 0.0, 0.0, 0.0],
    ),
    // Before 1.30 a body may hold it that nobody uses
    Row(120, "#define F 2##\n#define G ##\n", "r.x = 1.0;", [1.0, 0.0, 0.0, 0.0]),
    // `defined` may come from a macro; its name is not expanded
    Row(
        110,
        "#define A B\n#define M defined(A)\n#define N(x) defined x && !defined ( B )\n\
         #if M && !defined M2 && N(C)\n#error\n#elif M && !(N(C))\nconst float c = 3.0;\n#endif\n",
        "r.x = c;",
        [3.0, 0.0, 0.0, 0.0],
    ),
    Row(
        130,
        "#define A 3\n#define M (defined(A) && A == 3)\n#if M\nconst float c = 3.0;\n#endif\n",
        "r.x = c;",
        [3.0, 0.0, 0.0, 0.0],
    ),
];

/// GLSL 1.30 section 3.3: `__FILE__` is the number of the string, `__LINE__` counts the lines of it, and a `#line` renumbers
/// the strings that follow.
#[test]
fn strings_of_a_source_are_counted() {
    let check = |strings: &[&str]| {
        let mut c = Context::new(ContextDesc::default()).expect("a device");
        let shader = c.create_shader(GL_FRAGMENT_SHADER);
        c.shader_source(shader, strings.len() as GLsizei, Strings(strings.to_vec()), &[]);
        c.compile_shader(shader);
        let mut log = String::new();
        c.get_shader_info_log(shader, 1 << 16, &mut [], TextOut::String(&mut log));
        log
    };
    // An array of no elements is an error, which says where it is.
    let at = "int a[__FILE__ == 1 && __LINE__ == 2 ? 1 : 0];\n";
    let end = "void main() {}\n";
    assert_eq!(check(&["#version 120\n", &format!("\n{at}"), end]), "");
    assert_eq!(check(&["#version 120\n// half a ", &format!("line\n{at}"), end]), "");
    assert_ne!(check(&["#version 120\n", at, end]), "");
    assert_ne!(check(&[&format!("#version 120\n\n{at}{end}")]), "");
    let log = check(&["#version 120\n", "\n  float x = ;\n", end]);
    assert!(log.starts_with("1:2(13): error"), "{log}");
    let log = check(&["#version 120\n#line 9 4\n\n", "int b;\n", "\n  float x = ;\n"]);
    assert!(log.starts_with("6:2(13): error"), "{log}");
    // What stands at the end of a string is said of the line that comes next.
    let log = check(&["#version 330\n#line 9 4\n", "  float x = ;\n"]);
    assert!(log.starts_with("4:9(13): error"), "{log}");
    // Repairs, of which the first makes its string longer, do not move the numbers.
    let strings = ["#version 120\n", "void f() { int a = 1 }\n", "\n  float x = ;\n"];
    let starts = [strings[0].len(), strings[0].len() + strings[1].len()].map(|at| at as u32);
    let options = Options { fix_its: FixIts::Apply, ..Options::default() };
    let log = compile_strings(Stage::Fragment, &strings.concat(), &starts, &options).log;
    assert!(log.contains("1:1(") && log.contains("repaired"), "{log}");
    assert!(log.contains("2:2(13): error"), "{log}");
}
