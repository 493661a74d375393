//! Arrays of arrays: ARB_arrays_of_arrays, in the versions that it can be enabled in.

use super::Row;

const ENABLE: &str = "#extension GL_ARB_arrays_of_arrays : enable\n";
const WARN: &str = "#extension GL_ARB_arrays_of_arrays : warn\n";

pub const TABLE: &[Row] = &[
    // The order of the dimensions: what stands after the name is outside of what stands before.
    Row(
        120,
        ENABLE,
        "float a[2][3]; float[3] b[2]; float[2][3] c; r = vec4(a.length(), b.length(), b[0].length(), c[1].length());",
        [2.0, 2.0, 3.0, 3.0],
    ),
    Row(
        130,
        ENABLE,
        "float[5][4] a[2][3]; r = vec4(a.length(), a[0].length(), a[0][0].length(), a[1][2][4].length());",
        [2.0, 3.0, 5.0, 4.0],
    ),
    Row(
        120,
        ENABLE,
        "float a[2][3]; float[3] b[2]; a[1][2] = 7.0; b = a; r = vec4(b[1][2], a == b, a[1] == b[1], a != b);",
        [7.0, 1.0, 1.0, 0.0],
    ),
    Row(110, ENABLE, "float a[2][3]; a[1][k] = 7.0; r.x = a[k - 1][2];", [7.0, 0.0, 0.0, 0.0]),
    Row(110, WARN, "float a[2][3]; a[0][1] = 7.0; r.x = a[0][1];", [7.0, 0.0, 0.0, 0.0]),
    // The order of the elements: the last index counts fastest
    Row(
        120,
        ENABLE,
        "float a[2][3]; for (int i = 0; i < 2; i++) for (int j = 0; j < 3; j++) a[i][j] = 10.0 * i + j; float[3] row = a[k - 1]; r = vec4(row[0], row[2], a[0][k], a[k - 2][1]);",
        [10.0, 12.0, 2.0, 1.0],
    ),
    Row(
        120,
        ENABLE,
        "vec2 a[2][2] = vec2[2][2](vec2[2](u.xy, u.zw), vec2[2](u.wz, u.yx)); r = vec4(a[0][1], a[1][k - 2].y, a[k - 1][1][0]);",
        [3.0, 4.0, 3.0, 2.0],
    ),
    Row(
        120,
        ENABLE,
        "mat2 a[1][2]; a[0][1] = mat2(u); a[0][k - 1][1].x += 5.0; r = vec4(a[0][1][0], a[0][1][1]);",
        [1.0, 2.0, 8.0, 4.0],
    ),
    // An index out of range means the last element, in each dimension by itself.
    Row(
        120,
        ENABLE,
        "float a[2][2] = float[2][2](float[2](1., 2.), float[2](3., 4.)); r = vec4(a[k + 9][0], a[0][k + 9], a[k + 9][k + 9], 0);",
        [3.0, 2.0, 4.0, 0.0],
    ),
    // Constructors: sizes that are left out come from the arguments.
    Row(
        120,
        ENABLE,
        "float b[2] = float[2](1., 2.); float[3][2] a = float[][2](b, b, b); float[3][2] c = float[3][](b, b, b); float[3][2] d = float[][](b, b, b); r = vec4(a == c, c == d, d[2][1], float[][](b, b)[1][k - 1]);",
        [1.0, 1.0, 2.0, 2.0],
    ),
    Row(
        120,
        ENABLE,
        "float b[2] = float[2](1., 2.); float a[][2] = float[][2](b, b, b); float c[][] = float[2][2](b, b); float[] d[3] = float[][](b, b, b); r = vec4(a.length(), c.length(), c[1].length(), d[2].length());",
        [3.0, 2.0, 2.0, 2.0],
    ),
    Row(
        120,
        "#extension GL_ARB_arrays_of_arrays : enable\nconst int t[2][2] = int[][](int[](1, 2), int[](3, 4)); float sized[t[1][0] + t.length()];\n",
        "r = vec4(sized.length(), t[1][1], t[k - 1][k - 2], t[0] == int[](1, 2));",
        [5.0, 4.0, 3.0, 1.0],
    ),
    Row(
        120,
        "#extension GL_ARB_arrays_of_arrays : enable\nstruct S { float a; vec2 b[2][3]; };\n",
        "S s[2][2]; s[1][0].b[1][2] = u.zw; S[2] t = s[1]; r = vec4(t[0].b[1][2], S[1][2](t)[0][0].b[k - 1][k].x, s[1][0] == t[0]);",
        [3.0, 4.0, 3.0, 1.0],
    ),
    // The largest index brings the outermost size.
    Row(
        120,
        ENABLE,
        "float a[][2]; a[2][1] = 5.0; float[3][2] a; r = vec4(a.length(), a[2][1], a[k][1], 0);",
        [3.0, 5.0, 5.0, 0.0],
    ),
    // Functions
    Row(
        120,
        "#extension GL_ARB_arrays_of_arrays : enable
float f(float a[2][3]) { return 1.0; } float f(float[3] a[3]) { return 2.0; } float f(float[3][2] a) { return 3.0; }
float[2][2] g(inout float a[2][2], out float[2] b[1]) { a[1][0] += 1.0; b[0][1] = 9.0; return float[2][2](a[1], a[0]); }\n",
        "float a[2][3]; float b[3][3]; float[2] c[3]; float[] d[1] = float[1][2](float[2](1., 2.)); float e[2][2] = float[2][2](d[0], d[0]); float h[2][2] = g(e, d); r = vec4(f(a) * 100.0 + f(b) * 10.0 + f(c), e[1][0], h[0][0], d[0][1]);",
        [123.0, 2.0, 2.0, 9.0],
    ),
    Row(
        120,
        ENABLE,
        "float a[2][2] = yes ? float[2][2](float[2](1., 2.), float[2](3., 4.)) : float[2][2](float[2](5., 6.), float[2](7., 8.)); r.x = a[1][0];",
        [3.0, 0.0, 0.0, 0.0],
    ),
    // Uniforms
    Row(
        120,
        "#extension GL_ARB_arrays_of_arrays : enable
uniform float t[2][3] = float[2][3](float[3](1., 2., 3.), float[3](4., 5., 6.)); uniform struct S { vec2 v[2][1]; } s[1][2] = S[1][2](S[2](S(vec2[2][1](vec2[1](vec2(7)), vec2[1](vec2(8)))), S(vec2[2][1](vec2[1](vec2(9)), vec2[1](vec2(10))))));\n",
        "float sum = 0.0; for (int i = 0; i < 2; i++) for (int j = 0; j < 3; j++) sum = 2.0 * sum + t[i][j]; r = vec4(sum, t[k - 1][k], s[0][1].v[0][0].x, s[0][k - 1].v[k - 1][0].y);",
        [120.0, 6.0, 9.0, 10.0],
    ),
    // What is left of a bracket of its own is an index.
    Row(120, ENABLE, "int n[2]; n[1] = 1; r.x = u[n[n[1]]] + list[n[0]];", [12.0, 0.0, 0.0, 0.0]),
];
