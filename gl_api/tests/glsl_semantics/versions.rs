//! Versions of the language: directives, literals, types, keywords and constant expressions that the
//! other tables do not cover.

use super::Row;

pub const TABLE: &[Row] = &[
    // Directives
    Row(
        110,
        "#\n # /* spaces */ define A 2.0 /* a comment\n over lines */\n/* before */ #define B A// at the end\n",
        "r.x = A + B;",
        [4.0, 0.0, 0.0, 0.0],
    ),
    Row(
        110,
        "#pragma optimize(off)\n#pragma debug(on)\n#pragma\nfloat g(float a) { return a; }\n#define f f\n#define g(x) g(x + 1.0)\nfloat f = 3.0;\n",
        "r.xy = vec2(f, g(1.0));",
        [3.0, 2.0, 0.0, 0.0],
    ),
    Row(
        110,
        "#if 1\n#elif garbage ( here\n#endif\n#if 0\n#if 1\n#else\n#error hidden\n#endif\n#else\nconst float c = 1.0;\n#endif\n",
        "r.x = c;",
        [1.0, 0.0, 0.0, 0.0],
    ),
    Row(
        110,
        "#if (17 % 5 == 2) && (7 / 2 == 3) && (1 << 3) + (16 >> 2) - 2 * 3 == 6 && (5 & 3 | 8 ^ 1) == 9 && ~0 == -1 && +1 != !1 && 2 >= 2 && 1 <= 2\nconst float c = 1.0;\n#else\nconst float c = 2.0;\n#endif\n",
        "r.x = c;",
        [1.0, 0.0, 0.0, 0.0],
    ),
    Row(
        110,
        "#define TWO(a, b) a b\n#define CALL(f, x) f(x)\n#define SQUARE(x) ((x) * (x))\n",
        "r.x = CALL(SQUARE, u.y); r.y = TWO(-, u.z); r.z = TWO(u.w,); r.w = SQUARE(CALL(\nSQUARE, /* , */ 2.0));",
        [4.0, -3.0, 4.0, 16.0],
    ),
    Row(
        110,
        "#define one 1.0\n#define one 1.0\n#undef never\n",
        "float a/**/= one;r.x = a;",
        [1.0, 0.0, 0.0, 0.0],
    ),
    Row(
        110,
        "\r\n#define A 2.0\r\n#define B 3.0\r",
        "\r\nr.xy = vec2(A, B);\r",
        [2.0, 3.0, 0.0, 0.0],
    ),
    // Literals
    Row(110, "", "r = vec4(.5, 1., 1e2, 2.5E-1);", [0.5, 1.0, 100.0, 0.25]),
    Row(120, "", "r = vec4(.5f, 1.F, 1e2f, 0x1F);", [0.5, 1.0, 100.0, 31.0]),
    Row(130, "", "r = vec4(3e0, 010u, 0XffU, 00);", [3.0, 8.0, 255.0, 0.0]),
    // Functions of integers before 1.30: where nothing else can be meant
    Row(
        110,
        "",
        "r = vec4(min(k, 5) / 4, max(-7, k), clamp(k + 40, -1, 3), abs(-k) + sign(-9)); int i = 3; i = min(i, k); r.x += float(i);",
        [2.0, 2.0, 3.0, 1.0],
    ),
    Row(
        110,
        "",
        "ivec2 v = min(ivec2(k, 9), 3); ivec2 w = clamp(ivec2(k, 9), ivec2(3), ivec2(4, 7)); r = vec4(v, w);",
        [2.0, 3.0, 3.0, 7.0],
    ),
    Row(
        110,
        "int min(int a, int b) { return 9; }\n",
        "r.xy = vec2(min(k, 1), min(3.0, 2.0));",
        [9.0, 2.0, 0.0, 0.0],
    ),
    Row(
        120,
        "int twice(int i) { return 2 * i; }\nconst int seven = min(7, 16777217);\n",
        "int i = min(k, 5); ivec2 v = clamp(ivec2(k, 9), 3, 16777217); float a[seven]; a[6] = 4.0; r = vec4(min(k, 5) / 4, list[max(abs(-1), min(k, 0))] + i, v.y, a[6]);",
        [0.5, 22.0, 9.0, 4.0],
    ),
    // Constants and arrays of ES
    Row(
        100,
        "precision mediump float;\nconst float c = cos((1.0, 0.0)); const int n = (5, 2);\nvoid f(inout float a[2], out float b[n]) { a[1] += a[0]; b[0] = 9.0; }\n",
        "float a[(3, n)]; float b[n]; a[0] = 3.0; a[1] = 4.0; f(a, b); r = vec4(c, a[0], a[1], b[0]);",
        [1.0, 3.0, 7.0, 9.0],
    ),
    // Types of 1.20
    Row(
        120,
        "",
        "mat2x2 a = mat2(u); mat3x3 b = mat3(2.0); mat4x4 c = m; r = vec4(a[1].y, b[2].z, c[3].w, (b * vec3(1)).x);",
        [4.0, 2.0, 16.0, 2.0],
    ),
    Row(
        120,
        "",
        "mat2x4 a = mat2x4(m); mat4x2 b = mat4x2(m); mat3x4 c = mat3x4(m); mat4x3 d = mat4x3(m); r = vec4(a[1][3], b[3][1], c[2][3], d[3][2]);",
        [8.0, 14.0, 12.0, 15.0],
    ),
    Row(
        120,
        "",
        "mat3x2 a = mat3x2(1, 2, 3, 4, 5, 6); mat2x3 b = mat2x3(1, 0, 1, 0, 1, 0); mat2 c = a * b; r = vec4(c[0], c[1]);",
        [6.0, 8.0, 3.0, 4.0],
    ),
    Row(
        120,
        "",
        "mat3x2 a = outerProduct(u.xy, vec3(1, 2, 3)); mat2x3 t = transpose(a); r = vec4(a[2], t[1].y, (vec2(1) * a).z);",
        [3.0, 6.0, 4.0, 9.0],
    ),
    Row(
        120,
        "",
        "mat2x3 a; a[k - 1][k] = 5.0; a[k - 2] = vec3(1, 2, 3); int c = int(x) - 2; r = vec4(a[c][k], a[0][c], a[c - 1][int(x) - 1], a[1][0]);",
        [5.0, 2.0, 3.0, 0.0],
    ),
    Row(
        120,
        "",
        "mat4x3 a = mat4x3(m); a++; a -= mat4x3(1.0); mat4x3 n = -a; r = vec4(a[0][0], a[0][1], n[3][2], a == a);",
        [1.0, 3.0, -16.0, 1.0],
    ),
    // Constant expressions with functions
    Row(
        120,
        "const int n = int(max(2.0, 1.5)) + int(sin(0.0)); const vec2 v = normalize(vec2(3.0, 4.0)); float a[n * 2];",
        "a[3] = v.y; r = vec4(a.length(), a[3] == v.y, v.x > 0.59 && v.x < 0.61, n);",
        [4.0, 1.0, 1.0, 2.0],
    ),
    Row(
        120,
        "struct S { float a[2]; vec3 v; }; const S s = S(float[2](1.0, 2.0), vec3(3.0)); const float f = s.a[1] + s.v.yz[1]; const bool b = s == S(float[](1.0, 2.0), vec3(3.0));",
        "r = vec4(f, b, s.a.length(), s.a[k - 1]);",
        [5.0, 1.0, 2.0, 2.0],
    ),
    // Arrays of structures
    Row(
        120,
        "struct L { vec3 c; float i; }; L pair[2] = L[2](L(vec3(1.0), 2.0), L(vec3(3.0), 4.0));",
        "L[2] other = pair; other[k - 1].c.y = 9.0; L[] made = L[](pair[0], other[1], pair[1]); r = vec4(made.length(), made[1].c.y, made[k].i, pair == other);",
        [3.0, 9.0, 4.0, 0.0],
    ),
    Row(
        120,
        "struct L { float i; }; L[2] swap(L[2] a) { return L[2](a[1], a[0]); } void set(inout L[2] a, out L b[2]) { b = a; a[0].i = 7.0; }",
        "L a[2] = L[](L(1.0), L(2.0)), b[2]; a = swap(a); set(a, b); r = vec4(a[0].i, a[1].i, b[0].i, swap(b)[0].i);",
        [7.0, 1.0, 2.0, 1.0],
    ),
    // Declarations
    Row(
        110,
        "struct { float a; } s; float f(void) { return 2.0; } float g(const in float, out float b); float g(const in float a, out float b) { b = a; return -a; }",
        "float a[2], b, c[3]; s.a = 1.0; a[1] = f(); c[2] = g(3.0, b); r = vec4(s.a, a[1], b, c[2]);",
        [1.0, 2.0, 3.0, -3.0],
    ),
    Row(
        130,
        "precision highp float; precision mediump int; uniform lowp float never; highp vec2 f(mediump float a, const in lowp int b) { return vec2(a, b); }",
        "highp int i = 3; lowp vec2 v = f(1.0, i); r.xy = v;",
        [1.0, 3.0, 0.0, 0.0],
    ),
    Row(
        120,
        "#pragma STDGL invariant(all)\ninvariant centroid varying vec3 a; centroid varying mat3x2 b[2]; varying float c[3];",
        "r.x = float(c.length() + b.length());",
        [5.0, 0.0, 0.0, 0.0],
    ),
    // A vector's components that an index names, both ways
    Row(
        130,
        "",
        "uvec3 a = uvec3(1u, 2u, 3u); a[k] += 4u; bvec2 b; b[k - 1] = true; ivec4 c; c[uint(k)] = int(a[k]); r = vec4(a[k], b.y, c.z, a[k - 1]);",
        [7.0, 1.0, 7.0, 2.0],
    ),
    // Switches
    Row(
        130,
        "float f(int n) { float v = 0.0; switch (n) { case 0: v += 1.0; case 1: v += 2.0; { v += 4.0; break; } case -1: return -1.0; default: v += 8.0; case 3: v += 16.0; } return v; }",
        "r = vec4(f(0), f(1), f(-1), f(7));",
        [7.0, 6.0, -1.0, 24.0],
    ),
    Row(
        130,
        "float f(int n) { float v = 0.0; for (int i = 0; i < 4; i++) { switch (n + i) { case 1: continue; case 2: v += 10.0; break; default: if (i == 3) return v + 100.0; v += 1.0; } v += 0.5; } return v; }",
        "r = vec4(f(0), f(1), f(int(x)), f(-1));",
        [112.0, 112.0, 104.5, 13.5],
    ),
    // What came with 1.40, and what stays by GL_ARB_compatibility
    Row(
        140,
        "#ifndef GL_ARB_compatibility\n#error not there\n#endif\n",
        "mat2 a = inverse(mat2(1, 2, 3, 4)); r = vec4(a[0], a[1]) * float(__VERSION__ - 139);",
        [-2.0, 1.0, 1.5, -0.5],
    ),
    Row(
        140,
        "#extension GL_ARB_compatibility : require\n",
        "mat3 a = inverse(mat3(1, 2, 3, 0, 1, 4, 5, 6, 0)); r = vec4(a[0], a[2].y);",
        [-24.0, 18.0, 5.0, 4.0],
    ),
    Row(
        140,
        "",
        "mat4 a = inverse(mat4(2, 0, 0, 0, 0, 4, 0, 0, 0, 0, 8, 0, 1, 2, 3, 1)); r = vec4(a[3].xyz, a[1].y);",
        [-0.5, -0.5, -0.375, 0.25],
    ),
    Row(
        140,
        "",
        "mat4 p = mat4(0, u.x, 0, 0, 1, 0, 0, 0, 0, 0, 0, u.y, 0, 0, u.w, 0); p = inverse(p); r = vec4(p[0].y, p[1].x, p[2].w, p[3].z);",
        [1.0, 1.0, 0.25, 0.5],
    ),
    // Integers of 1.30
    Row(
        130,
        "",
        "uint a = 0xFFFFFFFFu; ivec2 b = ivec2(-7, 7) % ivec2(3); uvec2 c = uvec2(7u, 9u) / 2u; r = vec4(a / 2u == 0x7FFFFFFFu, b.y, c.y, uint(-1) == a);",
        [1.0, 1.0, 4.0, 1.0],
    ),
    Row(
        130,
        "",
        "int i = 5; uint n = 3u; i <<= n; n |= 4u; n &= 6u; n ^= 1u; r = vec4(i, n, i >> n, ~i + 41);",
        [40.0, 7.0, 0.0, 0.0],
    ),
    // What GLSL 4.20 has relaxed
    Row(
        130,
        "#extension GL_ARB_shading_language_420pack : enable\n",
        "float a[] = {1.0, 2.0, u.z,}; vec4 v = {a[0], a[1], a[2], a.length()}; r = v;",
        [1.0, 2.0, 3.0, 3.0],
    ),
    Row(
        130,
        "#extension GL_ARB_shading_language_420pack : enable\nstruct S { vec2 p; mat2 m; };\nconst S s[2] = {{{1, 2}, {{3, 4}, {5, 6}}}, S(vec2(7.0), mat2(8.0))};\n",
        "r = vec4(s[0].p.y, s[0].m[1].y, s[1].p.length() + s[1].m.length(), s[1].m[1].y);",
        [2.0, 6.0, 4.0, 8.0],
    ),
    Row(
        130,
        "#extension GL_ARB_shading_language_420pack : enable\nvec4 f(in const highp int n) { return ivec4(n); }\n",
        "const float c = u.y; r = c.xxxx; r.x += f(3).x; c.x; r.w = c.r;",
        [5.0, 2.0, 2.0, 2.0],
    ),
    // Profiles of 1.50
    Row(
        150,
        "#if defined GL_core_profile && !defined GL_compatibility_profile && __VERSION__ == 150\nconst float c = 1.0;\n#endif\n",
        "r = vec4(c, determinant(mat2(1.0, 2.0, 3.0, 4.0)), determinant(mat3(2.0)), gl_MaxGeometryOutputVertices);",
        [1.0, -2.0, 8.0, 256.0],
    ),
    Row(
        330,
        "#if __VERSION__ == 330\nconst float c = 1.0;\n#endif\n",
        "r = vec4(c, intBitsToFloat(floatBitsToInt(u.y)), gl_MaxVertexOutputComponents, gl_MaxFragmentInputComponents);",
        [1.0, 2.0, 128.0, 128.0],
    ),
];
