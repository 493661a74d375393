//! Combinations of features: l-values with several dynamic indices, jumps out of nested statements,
//! structures as values, samplers as arguments, derivatives in divergent control flow.

use super::Row;

pub const TABLE: &[Row] = &[
    // Dynamic indices of l-values
    Row(
        110,
        "struct S { mat3 a; vec4 b[2]; };",
        "S s[3]; s[k].a[k - 1][k] = 7.0; s[k].b[k - 1].wz = u.xy; r = vec4(s[2].a[1][2], s[2].b[1].zw, s[1].a[1][2]);",
        [7.0, 2.0, 1.0, 0.0],
    ),
    Row(
        110,
        "struct A { mat2 m[2]; }; struct B { A a[2]; };",
        "B b[2]; int i = int(x) - 2; b[i].a[i].m[i][i][i] += 5.0; b[i].a[i].m[i] *= 2.0; r.xy = b[1].a[1].m[1][1]; r.z = b[i].a[0].m[1][1].y;",
        [0.0, 10.0, 0.0, 0.0],
    ),
    Row(
        110,
        "void f(inout mat2 m, int i) { m[i][1 - i] = 3.0; m[i] += vec2(1.0); }",
        "mat2 a[3]; int i = int(x) - 3; f(a[i + k], i); r = vec4(a[2][0], a[1][0]);",
        [1.0, 4.0, 0.0, 0.0],
    ),
    Row(
        120,
        "",
        "mat4x2 a; int i = int(x); a[i].yx = u.xy; a[i][0]++; r = vec4(a[3], a[0]);",
        [3.0, 1.0, 0.0, 0.0],
    ),
    Row(
        120,
        "struct S { float a[4]; int n; };",
        "S s; for (int i = 0; i < 4; i++) { s.a[i] = float(i * i); s.n += i; } S t = s; t.a[k]--; r = vec4(s.a[k], t.a[k], t.a[3], t.n);",
        [4.0, 3.0, 9.0, 6.0],
    ),
    // Jumps
    Row(
        130,
        "",
        "for (int i = 0; i < 6; i++) { switch (i) { case 0: case 1: r.x += 1.0; case 2: r.y += 1.0; if (i == 1) break; r.z += 1.0; break; case 4: continue; default: r.x += 10.0; } r.w += 1.0; }",
        [22.0, 3.0, 2.0, 5.0],
    ),
    Row(
        130,
        "float f(int n) { for (int i = 0; i < 4; i++) { switch (i + n) { case 3: return 30.0 + float(i); case 9: break; default: for (int j = 0; j < 3; j++) { if (i * j == 2) return float(10 * i + j); } } } return -1.0; }",
        "r = vec4(f(3), f(2), f(0), f(int(x) + 6));",
        [30.0, 31.0, 12.0, 12.0],
    ),
    Row(
        110,
        "float f(float a) { for (int i = 0; i < 5; i++) { for (int j = 0; j < 5; j++) { while (true) { a += 1.0; if (a > 20.0) return a; if (a > float(10 * i)) break; } if (j > i) break; } } return a; }",
        "r = vec4(f(x), f(0.0), f(19.5), f(25.0));",
        [20.5, 21.0, 20.5, 26.0],
    ),
    Row(
        110,
        "int g = 0; bool step() { g++; return g < 3; } void f() { do { if (!step()) return; } while (true); }",
        "f(); r.x = float(g); while (step() || g < 7) { if (g == 5) continue; r.y += 1.0; } r.z = float(g);",
        [3.0, 2.0, 7.0, 0.0],
    ),
    // Structures as values
    Row(
        120,
        "struct P { vec2 a; float b[2]; }; struct Q { P p[2]; int n; };",
        "P p = P(u.xy, float[2](3.0, 4.0)); Q q = Q(P[2](p, p), 5); Q o = q; r.x = float(q == o); o.p[k - 1].b[0] = 9.0; r.yzw = vec3(q == o, q != o, q.p[0] == o.p[0]);",
        [1.0, 0.0, 1.0, 1.0],
    ),
    Row(
        120,
        "struct S { float a; bvec2 b; };",
        "S s[] = S[](S(1.0, bvec2(true)), S(u.y, bvec2(false, true)), S(3.0, bvec2(false))); r = vec4(s.length(), s[k - 1].a, s[1].b.y, S(3.0, bvec2(false)) == s[k]);",
        [3.0, 2.0, 1.0, 1.0],
    ),
    Row(
        120,
        "struct S { vec2 v; }; S pick(S a, S b, bool first) { return first ? a : b; } void set(out S s) { s = S(vec2(8.0)); }",
        "S s[2]; s[0] = pick(S(u.xy), S(u.zw), k == 1); set(s[k - 1]); r = vec4(s[0].v, s[1].v);",
        [3.0, 4.0, 8.0, 8.0],
    ),
    Row(
        120,
        "struct S { mat2 m; }; const S c[2] = S[2](S(mat2(1.0)), S(mat2(1.0, 2.0, 3.0, 4.0))); const float e = c[1].m[1][0];",
        "r = vec4(c[k - 1].m[0], e, c[0].m[1].y);",
        [1.0, 2.0, 3.0, 1.0],
    ),
    // Uniforms with values
    Row(
        120,
        "uniform float a[3] = float[3](5.0, 6.0, 7.0); uniform mat2 b = mat2(1.0, 2.0, 3.0, 4.0); uniform ivec2 c = ivec2(8, -9);",
        "r = vec4(a[k], b[1][0], c);",
        [7.0, 3.0, 8.0, -9.0],
    ),
    Row(
        120,
        "struct S { vec2 a; float b[2]; }; uniform S s[2] = S[2](S(vec2(1.0), float[2](2.0, 3.0)), S(vec2(4.0, 5.0), float[2](6.0, 7.0)));",
        "r = vec4(s[k - 1].a, s[1].b[k - 1], s[0].b[0]);",
        [4.0, 5.0, 7.0, 2.0],
    ),
    // Samplers without a texture give (0, 0, 0, 1)
    Row(
        120,
        "uniform sampler2D one; struct S { sampler2D t[2]; float f; }; uniform S s; vec4 look(sampler2D t, vec2 p) { return texture2D(t, p); } vec4 far(sampler2D t[2]) { return look(t[1], vec2(0.0)); }",
        "r = look(one, u.xy) + look(s.t[1], u.xy) + far(s.t); r.x = s.f;",
        [0.0, 0.0, 0.0, 3.0],
    ),
    Row(
        130,
        "uniform sampler2D one; uniform isampler2D ints; uniform samplerCube cube; uniform sampler2DShadow shadow;",
        "for (int i = 0; i < k; i++) r += textureGrad(one, u.xy, vec2(x), u.zw); r.x = float(texelFetch(ints, ivec2(0), 0).w); r.y = textureLod(cube, u.xyz, 1.0).w; r.z = textureProjLod(shadow, u, 0.0);",
        [1.0, 1.0, 0.0, 2.0],
    ),
    // Derivatives where lanes differ
    Row(
        110,
        "",
        "float y = x * x; if (x > 3.0) { r.x = dFdx(y); r.y = dFdx(x * 2.0); } for (float i = 0.0; i < x; i += 1.0) r.z = dFdx(x); r.w = fwidth(y);",
        [6.0, 2.0, 1.0, 6.0],
    ),
    Row(
        110,
        "",
        "vec4 v = vec4(x, 1.0, x * 3.0, u.x); r = dFdx(v) + dFdy(v);",
        [1.0, 0.0, 3.0, 0.0],
    ),
    // Noise is of its arguments alone, and continuous
    Row(
        110,
        "",
        "r.x = float(noise1(x) == noise1(x)); r.y = float(noise3(u.xy) == noise3(u.xy)); r.z = float(abs(noise1(u) - noise1(u + 0.0001)) < 0.01); r.w = float(abs(noise4(u.x).w) <= 1.0);",
        [1.0, 1.0, 1.0, 1.0],
    ),
    // Preprocessor
    Row(
        110,
        "#define LINE(n) n\n#line LINE(20 + 1) (1 + 1)\nconst int line = __LINE__; const int file = __FILE__;",
        "r.xy = vec2(line, file);",
        [22.0, 2.0, 0.0, 0.0],
    ),
    Row(
        130,
        "#define JOIN(a, b) a ## b\n#define TWO JOIN(1, 2)\nfloat JOIN(na, me) = 3.0;",
        "r = vec4(name, TWO, JOIN(2., 5), JOIN(u, ).x);",
        [3.0, 12.0, 2.5, 1.0],
    ),
    Row(
        110,
        "#extension all : warn\n#if defined GL_ARB_texture_rectangle && GL_ARB_texture_rectangle == 1 && !(0x10 - 020 != 0)\n#define R 2.0\n#elif 1\n#define R 3.0\n#else\n#error\n#endif",
        "r.x = R;",
        [2.0, 0.0, 0.0, 0.0],
    ),
    // Redeclared variables of the language
    Row(
        120,
        "varying vec4 gl_TexCoord[3]; invariant varying vec4 a; invariant varying float b;",
        "r.x = 1.0;",
        [1.0, 0.0, 0.0, 0.0],
    ),
];
