//! What shaders compute: fragment shaders run on the interpreter, checked against values worked
//! out by hand.
//!
//! Every row is the body of a `main` that sets `r`. It can use
//! `u = (1, 2, 3, 4)`, `k = 2`, `yes = true`, `list = {10, 20, 30, 40}`, `m` with the elements 1 to
//! 16 column by column, and `x = gl_FragCoord.x`, which is 3.5 in the lane that is looked at.
//! Lanes are the pixels of an 8 by 8 block, quads by planes (see `texunit::lanes`).

use gl_api::glsl::{Bindings, Options, Stage, compile, link};
use rasterizer::ir::{Input, Output};
use rasterizer::shader::{Machine, Program, Run};
use texunit::lanes::{Isa, LANES};

/// The lane that is looked at: the one of column 3, row 0.
const LANE: usize = 17;

/// The column of a lane in its block.
fn column(lane: usize) -> usize {
    lane % 4 * 2 + lane / 16 % 2
}

struct Row(u32, &'static str, &'static str, [f32; 4]);

const TABLE: &[Row] = &[
    // Operators
    Row(110, "", "r = u + 1.0;", [2.0, 3.0, 4.0, 5.0]),
    Row(110, "", "r = 10.0 - u;", [9.0, 8.0, 7.0, 6.0]),
    Row(110, "", "r = u * u.wzyx;", [4.0, 6.0, 6.0, 4.0]),
    Row(110, "", "r = u / vec4(2.0, 4.0, 3.0, 8.0);", [0.5, 0.5, 1.0, 0.5]),
    Row(110, "", "r = -u; r.x = +u.x;", [1.0, -2.0, -3.0, -4.0]),
    Row(110, "", "r = vec4(k + 3, k - 3, k * 5, 7 / k);", [5.0, -1.0, 10.0, 3.0]),
    Row(130, "", "r = vec4(7 % k, -7 / k, 1 << k, -8 >> k);", [1.0, -3.0, 4.0, -2.0]),
    Row(130, "", "r = vec4(6 & k, 5 | k, 7 ^ k, ~k);", [2.0, 7.0, 5.0, -3.0]),
    Row(
        130,
        "",
        "uint n = uint(k); r = vec4(n - 3u > 100u, 7u / n, 7u % n, n << 3u);",
        [1.0, 3.0, 1.0, 16.0],
    ),
    Row(110, "", "r = vec4(u.x < u.y, u.x >= u.y, k == 2, k != 2);", [1.0, 0.0, 1.0, 0.0]),
    Row(
        110,
        "",
        "r = vec4(yes && k > 1, yes && k > 2, !yes || k > 1, yes ^^ true);",
        [1.0, 0.0, 1.0, 0.0],
    ),
    Row(110, "", "r = vec4(u == u, u != u, u.xy == u.zw, u.xy != u.zw);", [1.0, 0.0, 0.0, 1.0]),
    Row(110, "", "r = k > 1 ? u : -u;", [1.0, 2.0, 3.0, 4.0]),
    Row(110, "", "r.x = (r.y = 2.0, r.z = 3.0, 5.0);", [5.0, 2.0, 3.0, 0.0]),
    Row(
        110,
        "",
        "int i = k; r.x = float(i++); r.y = float(i); r.z = float(--i); r.w = float(i);",
        [2.0, 3.0, 2.0, 2.0],
    ),
    Row(110, "", "r = u; r += 1.0; r *= 2.0; r -= u; r /= 2.0;", [1.5, 2.0, 2.5, 3.0]),
    Row(
        130,
        "",
        "int i = 12; i %= 7; i <<= 2; i |= 1; i ^= k; i &= 30; i >>= 1; r.x = float(i);",
        [11.0, 0.0, 0.0, 0.0],
    ),
    Row(120, "", "r = vec4(k) + u * 2;", [4.0, 6.0, 8.0, 10.0]),
    Row(110, "", "vec2 v = u.xy; v++; r = vec4(v, --v);", [2.0, 3.0, 1.0, 2.0]),
    // Swizzles
    Row(110, "", "r = u.wzyx;", [4.0, 3.0, 2.0, 1.0]),
    Row(110, "", "r = u.xxyy.bgra;", [2.0, 1.0, 1.0, 2.0]),
    Row(110, "", "r = u.stpq;", [1.0, 2.0, 3.0, 4.0]),
    Row(110, "", "r.xz = u.yw;", [2.0, 0.0, 4.0, 0.0]),
    Row(110, "", "r = u; r.yx = r.xy;", [2.0, 1.0, 3.0, 4.0]),
    Row(110, "", "r.wzyx = u; r.xy *= 2.0;", [8.0, 6.0, 2.0, 1.0]),
    Row(110, "", "r.zyx.xy = vec2(7.0, 8.0);", [0.0, 8.0, 7.0, 0.0]),
    Row(110, "", "r = vec4(u.w, vec3(u).zx, 0.0);", [4.0, 3.0, 1.0, 0.0]),
    Row(110, "", "r = vec4(u[0], u[k], 0.0, 0.0); r[3] = 5.0; r[k] = 6.0;", [1.0, 3.0, 6.0, 5.0]),
    Row(110, "", "r = vec4((u * 2.0)[k], u.zw[1], u.wzyx[k], 0.0);", [6.0, 4.0, 2.0, 0.0]),
    Row(110, "", "r.wzyx[k] = 5.0; r.zy[k - 2] += 2.0;", [0.0, 5.0, 2.0, 0.0]),
    Row(
        110,
        "",
        "vec4 a[2]; a[k - 1].zx[k - 1] = 7.0; r = a[1]; r.w = a[k - 1].yx[k - 1];",
        [7.0, 0.0, 0.0, 7.0],
    ),
    // Matrices, column by column
    Row(110, "", "r = m[0];", [1.0, 2.0, 3.0, 4.0]),
    Row(110, "", "r = m[k];", [9.0, 10.0, 11.0, 12.0]),
    Row(110, "", "r = vec4(m[1][2], m[k][k], m[3].w, 0.0);", [7.0, 11.0, 16.0, 0.0]),
    Row(110, "", "r = m * vec4(1.0, 0.0, 0.0, 1.0);", [14.0, 16.0, 18.0, 20.0]),
    Row(110, "", "r = vec4(1.0, 0.0, 0.0, 1.0) * m;", [5.0, 13.0, 21.0, 29.0]),
    Row(
        110,
        "",
        "mat2 a = mat2(1.0, 2.0, 3.0, 4.0); mat2 b = mat2(5.0, 6.0, 7.0, 8.0); a = a * b; r = vec4(a[0], a[1]);",
        [23.0, 34.0, 31.0, 46.0],
    ),
    Row(110, "", "mat2 a = mat2(2.0); r = vec4(a[0], a[1]);", [2.0, 0.0, 0.0, 2.0]),
    Row(
        110,
        "",
        "mat2 a = mat2(u.xy, u.zw); a *= 2.0; a += a; r = vec4(a[0], a[1]);",
        [4.0, 8.0, 12.0, 16.0],
    ),
    Row(
        110,
        "",
        "mat3 a = mat3(1.0); a[1][2] = 5.0; a[k] = vec3(7.0); r = vec4(a * vec3(1.0), a[1].z);",
        [8.0, 8.0, 12.0, 5.0],
    ),
    Row(
        120,
        "",
        "mat2x3 a = mat2x3(1, 2, 3, 4, 5, 6); r = vec4(a * vec2(1, 1), 0.0);",
        [5.0, 7.0, 9.0, 0.0],
    ),
    Row(
        120,
        "",
        "mat2x3 a = mat2x3(1, 2, 3, 4, 5, 6); mat3x2 t = transpose(a); r = vec4(t[0], t[2]);",
        [1.0, 4.0, 3.0, 6.0],
    ),
    Row(
        120,
        "",
        "mat2 a = mat2(m); mat3 b = mat3(a); r = vec4(a[1], b[2].z, b[2].x);",
        [5.0, 6.0, 1.0, 0.0],
    ),
    Row(120, "", "mat2 a = outerProduct(u.xy, u.zw); r = vec4(a[0], a[1]);", [3.0, 6.0, 4.0, 8.0]),
    Row(
        110,
        "",
        "mat2 a = mat2(u); r.xy = a[1]; r.z = matrixCompMult(a, a)[1][0];",
        [3.0, 4.0, 9.0, 0.0],
    ),
    Row(110, "", "vec4 v = u; v *= mat4(2.0); r = v;", [2.0, 4.0, 6.0, 8.0]),
    // Constructors and conversions
    Row(110, "", "r = vec4(ivec2(2.7, -2.7), 1, true);", [2.0, -2.0, 1.0, 1.0]),
    Row(110, "", "r = vec4(bool(u.x), bool(0), int(true), float(false));", [1.0, 0.0, 1.0, 0.0]),
    Row(130, "", "r = vec4(uint(3.9), uint(k) + 4u, int(5u), uvec2(7u).y);", [3.0, 6.0, 5.0, 7.0]),
    Row(120, "", "float f = k; vec2 v = ivec2(3, 4); r = vec4(f, v, 1);", [2.0, 3.0, 4.0, 1.0]),
    // Control flow
    Row(
        110,
        "",
        "if (u.x > 0.0) r.x = 1.0; else r.x = 2.0; if (u.x < 0.0) { r.y = 1.0; } else if (k == 2) { r.y = 3.0; }",
        [1.0, 3.0, 0.0, 0.0],
    ),
    Row(110, "", "for (int i = 0; i < 5; i++) r.x += float(i);", [10.0, 0.0, 0.0, 0.0]),
    Row(110, "", "for (float f = 0.0; f < x; f += 1.0) r.x += 1.0;", [4.0, 0.0, 0.0, 0.0]),
    Row(
        110,
        "",
        "int i = 0; while (true) { i++; if (i == 3) continue; if (i > 5) break; r.x += float(i); }",
        [12.0, 0.0, 0.0, 0.0],
    ),
    Row(
        110,
        "",
        "int i = 9; do { r.x += 1.0; i--; } while (i > 9); r.y = float(i);",
        [1.0, 8.0, 0.0, 0.0],
    ),
    Row(
        110,
        "",
        "for (int i = 0; i < 3; i++) for (int j = 0; j < 3; j++) { if (j > i) break; r.x += 1.0; }",
        [6.0, 0.0, 0.0, 0.0],
    ),
    Row(
        110,
        "",
        "for (int i = 0; i < 3; i++) { int n; n += 1; r.x += float(n); }",
        [3.0, 0.0, 0.0, 0.0],
    ),
    Row(
        110,
        "",
        "int i = 0; while (bool go = i < 4) { i++; r.x += float(go); }",
        [4.0, 0.0, 0.0, 0.0],
    ),
    Row(
        130,
        "",
        "switch (k) { case 1: r.x = 1.0; break; case 2: r.x = 2.0; case 3: r.y = 3.0; break; default: r.z = 4.0; }",
        [2.0, 3.0, 0.0, 0.0],
    ),
    Row(
        130,
        "",
        "switch (k + 5) { default: r.x = 1.0; case 1: r.y = 2.0; break; case 2: r.z = 3.0; }",
        [1.0, 2.0, 0.0, 0.0],
    ),
    Row(
        130,
        "",
        "for (int i = 0; i < 4; i++) { switch (i) { case 1: continue; case 2: break; default: r.x += 1.0; } r.y += 1.0; }",
        [2.0, 3.0, 0.0, 0.0],
    ),
    Row(
        130,
        "float f(int i) { switch (i) { case 0: return 5.0; case 1: return 6.0; } return 7.0; }",
        "r = vec4(f(k - 2), f(k - 1), f(k), 0.0);",
        [5.0, 6.0, 7.0, 0.0],
    ),
    Row(
        130,
        "",
        "switch (k) { case 2: int a = 5; case 3: a += 1; r.x = float(a); }",
        [6.0, 0.0, 0.0, 0.0],
    ),
    Row(110, "", "if (x < 2.0) discard; r.x = 1.0;", [1.0, 0.0, 0.0, 0.0]),
    Row(
        110,
        "",
        "r = u; if (x > 3.0) { gl_FragColor = r + 1.0; return; } r = vec4(9.0);",
        [2.0, 3.0, 4.0, 5.0],
    ),
    // Short circuit
    Row(
        110,
        "float n = 0.0; bool hit() { n += 1.0; return true; }",
        "bool a = k > 5 && hit(); bool b = k > 1 || hit(); r = vec4(a, b, n, 0.0);",
        [0.0, 1.0, 0.0, 0.0],
    ),
    Row(
        110,
        "float n = 0.0; bool hit() { n += 1.0; return true; }",
        "bool a = k > 1 && hit(); bool b = k > 5 || hit(); r = vec4(a, b, n, 0.0);",
        [1.0, 1.0, 2.0, 0.0],
    ),
    Row(
        110,
        "",
        "int i = 0; r.x = k > 1 ? float(++i) : float(i += 5); r.y = float(i);",
        [1.0, 1.0, 0.0, 0.0],
    ),
    // Functions
    Row(
        110,
        "float twice(float a) { return a * 2.0; } vec2 twice(vec2 a) { return a * 2.0; }",
        "r = vec4(twice(u.x), twice(u.yz), 0.0);",
        [2.0, 4.0, 6.0, 0.0],
    ),
    Row(
        110,
        "float f(float a); float g(float a) { return f(a) + 1.0; } float f(float a) { return a * 3.0; }",
        "r.x = g(u.y);",
        [7.0, 0.0, 0.0, 0.0],
    ),
    Row(
        110,
        "void f(float a, out float b, inout float c) { b = a * 2.0; c += a; a = 0.0; }",
        "r = u; f(u.w, r.x, r.y); r.z = u.w;",
        [8.0, 6.0, 4.0, 4.0],
    ),
    Row(
        110,
        "void swap(inout float a, inout float b) { float t = a; a = b; b = t; }",
        "r = u; swap(r.x, r.w);",
        [4.0, 2.0, 3.0, 1.0],
    ),
    Row(
        110,
        "float f(float a) { if (a > 2.0) return 1.0; a += 5.0; for (int i = 0; i < 9; i++) { if (a > 8.0) return a; a += 1.0; } return -1.0; }",
        "r = vec4(f(u.x), f(u.y), f(u.z), f(-99.0));",
        [9.0, 9.0, 1.0, -1.0],
    ),
    Row(
        110,
        "float f(float a) { a *= 2.0; return a; }",
        "float a = 3.0; r = vec4(f(a), a, f(f(a)), 0.0);",
        [6.0, 3.0, 12.0, 0.0],
    ),
    Row(
        130,
        "vec3 reflect(vec3 w, vec3 n) { return n * (dot(w, n) * 2.0) - w; }",
        "r.xyz = reflect(vec3(1.0, 1.0, 0.0), vec3(0.0, 1.0, 0.0));",
        [-1.0, 1.0, 0.0, 0.0],
    ),
    Row(
        110,
        "const float c = 2.0; float g = c * 3.0; void f() { g += 1.0; }",
        "f(); f(); r.x = g; r.y = c;",
        [8.0, 2.0, 0.0, 0.0],
    ),
    Row(
        110,
        "float u2(const in float a) { return a; }",
        "float k = 5.0; { float k = 6.0; r.x = u2(k); } r.y = k;",
        [6.0, 5.0, 0.0, 0.0],
    ),
    Row(
        120,
        "void f(out int i, out ivec2 j) { i = 7; j = ivec2(8, 9); }",
        "f(r.x, r.wz);",
        [7.0, 0.0, 9.0, 8.0],
    ),
    // Arrays and structures
    Row(110, "", "r = vec4(list[0], list[k], list[3], list[k + 40]);", [10.0, 30.0, 40.0, 40.0]),
    Row(
        110,
        "",
        "float a[4]; for (int i = 0; i < 4; i++) a[i] = float(i * i); r = vec4(a[0], a[1], a[k], a[3]);",
        [0.0, 1.0, 4.0, 9.0],
    ),
    Row(
        110,
        "",
        "vec3 a[2]; a[0] = u.xyz; a[k - 1].y = 9.0; a[1].zx = u.xy; r = vec4(a[1], a[k - 2].z);",
        [2.0, 9.0, 1.0, 3.0],
    ),
    Row(
        120,
        "",
        "float a[3] = float[3](1.0, 2.0, 3.0); float b[3] = a; b[k] = 7.0; r = vec4(a[2], b[2], a.length(), a == b);",
        [3.0, 7.0, 3.0, 0.0],
    ),
    Row(
        120,
        "const float t[] = float[](5.0, 6.0, 7.0);",
        "r = vec4(t[1], t[k], t.length(), 0.0);",
        [6.0, 7.0, 3.0, 0.0],
    ),
    Row(
        110,
        "struct S { float a; vec2 b; int c; };",
        "S s = S(1.0, u.zw, 7); S t = s; t.b.y = 9.0; r = vec4(s.a, s.b.y, t.b.y, t.c);",
        [1.0, 4.0, 9.0, 7.0],
    ),
    Row(
        110,
        "struct S { float a; vec2 b; };",
        "S s[2]; s[0] = S(1.0, vec2(2.0)); s[k - 1] = S(3.0, u.xy); s[k - 1].b.x += 4.0; r = vec4(s[0].a, s[1].a, s[k - 1].b);",
        [1.0, 3.0, 5.0, 2.0],
    ),
    Row(
        110,
        "struct S { float a[3]; int n; }; float f(S s, int i) { s.a[i] *= 2.0; return s.a[i] + float(s.n); }",
        "S s; s.a[0] = 1.0; s.a[1] = 2.0; s.a[2] = 3.0; s.n = 10; r = vec4(f(s, k), s.a[2], f(s, 0), 0.0);",
        [16.0, 3.0, 12.0, 0.0],
    ),
    Row(
        120,
        "struct S { vec2 a; }; S make() { return S(vec2(3.0, 4.0)); } vec2[2] pair() { return vec2[2](vec2(1.0), vec2(2.0)); }",
        "r = vec4(make().a, pair()[k - 1]);",
        [3.0, 4.0, 2.0, 2.0],
    ),
    // Built-in functions
    Row(
        110,
        "",
        "r = vec4(abs(-u.x), sign(-u.y), floor(-1.5), ceil(1.2));",
        [1.0, -1.0, -2.0, 2.0],
    ),
    Row(
        110,
        "",
        "r = vec4(fract(-0.25), mod(-1.0, u.z), min(u.x, u.y), max(u.x, u.y));",
        [0.75, 2.0, 1.0, 2.0],
    ),
    Row(110, "", "r = clamp(u, 2.0, 3.0);", [2.0, 2.0, 3.0, 3.0]),
    Row(110, "", "r = mix(u, u.wzyx, 0.5);", [2.5, 2.5, 2.5, 2.5]),
    Row(110, "", "r = step(u, vec4(2.0)); r.z = smoothstep(1.0, 3.0, u.y);", [1.0, 1.0, 0.5, 0.0]),
    Row(
        110,
        "",
        "r = vec4(length(u.zw), distance(u.xy, vec2(4.0, 6.0)), dot(u, u), length(-u.z));",
        [5.0, 5.0, 30.0, 3.0],
    ),
    Row(110, "", "r.xyz = cross(vec3(1.0, 0.0, 0.0), vec3(0.0, u.x, 0.0));", [0.0, 0.0, 1.0, 0.0]),
    Row(
        110,
        "",
        "r = normalize(vec4(0.0, u.y, 0.0, 0.0)); r.x = normalize(-u.z);",
        [-1.0, 1.0, 0.0, 0.0],
    ),
    Row(
        110,
        "",
        "r.xy = reflect(vec2(1.0, -1.0), vec2(0.0, u.x)); r.zw = faceforward(u.xy, u.xy, u.xy);",
        [1.0, 1.0, -1.0, -2.0],
    ),
    Row(
        110,
        "",
        "r.xy = refract(vec2(0.0, -1.0), vec2(0.0, 1.0), u.x / 2.0);",
        [0.0, -1.0, 0.0, 0.0],
    ),
    Row(
        110,
        "",
        "r = vec4(sqrt(u.w), inversesqrt(u.w), pow(u.y, u.z), exp2(u.z));",
        [2.0, 0.5, 8.0, 8.0],
    ),
    Row(110, "", "r = vec4(log2(u.w), exp(0.0), log(u.x), sin(0.0));", [2.0, 1.0, 0.0, 0.0]),
    Row(110, "", "r = vec4(cos(0.0), atan(0.0, u.x), asin(0.0), acos(u.x));", [1.0, 0.0, 0.0, 0.0]),
    Row(110, "", "r = vec4(lessThan(u, vec4(2.0)));", [1.0, 0.0, 0.0, 0.0]),
    Row(
        110,
        "",
        "r = vec4(any(greaterThan(u, vec4(3.0))), all(greaterThanEqual(u, vec4(1.0))), not(equal(u.xy, u.xx)));",
        [1.0, 1.0, 0.0, 1.0],
    ),
    Row(
        130,
        "",
        "float whole; r.x = modf(-2.75, whole); r.y = whole; r.z = trunc(-u.w - 0.5); r.w = round(2.5);",
        [-0.75, -2.0, -4.0, 2.0],
    ),
    Row(
        130,
        "",
        "r = vec4(abs(-k), min(k, 1), clamp(k, 3, 5), max(3u, 2u));",
        [2.0, 1.0, 3.0, 3.0],
    ),
    Row(
        130,
        "",
        "r = vec4(isnan(u.x), isinf(u.x / 0.0), mix(u.xy, u.zw, bvec2(true, false)));",
        [0.0, 1.0, 3.0, 2.0],
    ),
    Row(110, "", "r.xy = vec2(dFdx(x), dFdy(x)); r.z = fwidth(x * 2.0);", [1.0, 0.0, 2.0, 0.0]),
    Row(110, "", "r.x = radians(degrees(0.0)) + float(gl_MaxTextureUnits);", [8.0, 0.0, 0.0, 0.0]),
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
];

fn source(row: &Row) -> String {
    let Row(version, declarations, body, _) = row;
    format!(
        "#version {version}
uniform vec4 u; uniform int k; uniform bool yes; uniform float list[4]; uniform mat4 m;
{declarations}
void main() {{
    float x = gl_FragCoord.x;
    vec4 r = vec4(0.0);
    {body}
    gl_FragColor = r;
}}
"
    )
}

/// The fragment program of a row and its uniform words.
fn program(row: &Row) -> (rasterizer::ir::Module, Vec<u32>) {
    let source = source(row);
    let compiled = compile(Stage::Fragment, &source, &Options::default());
    let shader = compiled.shader.unwrap_or_else(|| panic!("{source}\n{}", compiled.log));
    let linked = link(&[&shader], &Bindings::default());
    let program = linked.program.unwrap_or_else(|| panic!("{source}\n{}", linked.log));
    let mut words = vec![0; program.words as usize];
    for uniform in &program.uniforms {
        let value: Vec<u32> = match uniform.name.as_str() {
            "u" => [1.0f32, 2.0, 3.0, 4.0].map(f32::to_bits).into(),
            "k" => vec![2],
            "yes" => vec![rasterizer::ir::TRUE],
            "list" => [10.0f32, 20.0, 30.0, 40.0].map(f32::to_bits).into(),
            "m" => (1..=16u8).map(|i| f32::from(i).to_bits()).collect(),
            other => panic!("no value for {other}"),
        };
        words[uniform.word as usize..][..value.len()].copy_from_slice(&value);
    }
    let module = program.fragment.expect("a fragment stage was linked");
    (module, words)
}

#[test]
fn table() {
    let mut wrong = String::new();
    for row in TABLE {
        let (module, words) = program(row);
        if let Err(error) = module.validate() {
            panic!("{}\n{error}", source(row));
        }
        let program =
            Program::new(&module, |output| matches!(output, Output::Color { target: 0, .. }));
        for isa in Isa::available() {
            let prepared = program.prepare(isa, &words, &[]);
            let mut machine = Machine::default();
            machine.begin(&program);
            for (index, input) in program.inputs().iter().enumerate() {
                let register = machine.input_mut(index);
                for lane in 0..LANES {
                    let value = match input {
                        Input::FragCoord(0) => 0.5 + column(lane) as f32,
                        other => panic!("no value for {other:?}"),
                    };
                    register[lane] = value.to_bits();
                }
            }
            let run = Run {
                isa,
                program: &program,
                prepared: &prepared,
                textures: &[],
                active: !0,
                budget: 1_000_000,
            };
            machine.run(run).expect("the shaders end soon");
            let mut found = [0.0; 4];
            for (index, output) in program.outputs().iter().enumerate() {
                if let Output::Color { target: 0, component } = output {
                    found[usize::from(*component)] = f32::from_bits(machine.output(index)[LANE]);
                }
            }
            if found != row.3 {
                wrong.push_str(&format!("{}\nexpected {:?}, found {found:?}\n", row.2, row.3));
                break;
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn table_is_valid_ir() {
    for row in TABLE {
        let (module, _) = program(row);
        assert_eq!(module.validate(), Ok(()), "{}", source(row));
    }
}
