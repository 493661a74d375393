//! Which declaration a name means, and how lines end (GLSL 1.20 sections 3.1, 4.2 and 6.1).

use super::Row;

pub const TABLE: &[Row] = &[
    // From 1.20 on a function of the shader hides all of the language's that have its name
    Row(120, "float abs(float a) { return 50.0; }", "r.x = abs(-3);", [50.0, 0.0, 0.0, 0.0]),
    Row(130, "float abs(float a) { return 50.0; }", "r.x = abs(-3);", [50.0, 0.0, 0.0, 0.0]),
    Row(
        140,
        "float max(float a, float b) { return 50.0; }",
        "r.x = max(1, 2);",
        [50.0, 0.0, 0.0, 0.0],
    ),
    Row(
        120,
        "float pow(float a, int n) { return 50.0; }",
        "r.xy = vec2(pow(2, 3), pow(2.0, 3));",
        [50.0, 50.0, 0.0, 0.0],
    ),
    Row(
        130,
        "float mod(float a, int n) { return 50.0; }",
        "r.x = mod(5, 2);",
        [50.0, 0.0, 0.0, 0.0],
    ),
    Row(
        120,
        "float clamp(float a, float b, int c) { return 50.0; }",
        "r.x = clamp(0.3, 0, 1);",
        [50.0, 0.0, 0.0, 0.0],
    ),
    // What it does not take, the language's still does, with a warning
    Row(
        120,
        "float abs(mat2 m) { return 50.0; }",
        "r.xy = vec2(abs(-3.0), abs(mat2(1.0)));",
        [3.0, 50.0, 0.0, 0.0],
    ),
    // In 1.10 and GLSL ES it hides only the one that takes the same
    Row(
        110,
        "float abs(float a) { return 50.0; }",
        "r.xyz = vec3(abs(-1.0), abs(vec2(-2.0)));",
        [50.0, 2.0, 2.0, 0.0],
    ),
    Row(
        100,
        "precision mediump float; float sin(float a, float b) { return 50.0; }",
        "r.xy = vec2(sin(0.0), sin(0.0, 0.0));",
        [0.0, 50.0, 0.0, 0.0],
    ),
    // A carriage return ends a line, and so does a pair of it and a line feed
    Row(
        120,
        "float a = 3.0; // a comment\rfloat b = 4.0;\r",
        "r.xy = vec2(a, b);",
        [3.0, 4.0, 0.0, 0.0],
    ),
    Row(110, "#define A 3.0\r#define B 4.0\r", "r.xy = vec2(A, B);", [3.0, 4.0, 0.0, 0.0]),
    Row(110, "#line 1\rfloat a = float(__LINE__);", "r.x = a;", [2.0, 0.0, 0.0, 0.0]),
    Row(
        110,
        "#line 1\n\r\r\n\n\nfloat a = float(__LINE__);\r\rfloat b = float(__LINE__);",
        "r.xy = vec2(a, b);",
        [5.0, 7.0, 0.0, 0.0],
    ),
    Row(130, "#define A 3.0 + \\\r4.0\n", "r.x = A;", [7.0, 0.0, 0.0, 0.0]),
    Row(130, "#define A 3.0 + \\\n\r4.0\n", "r.x = A;", [7.0, 0.0, 0.0, 0.0]),
    // Initializers of globals may call functions of the shader; they run before `main`, in order
    Row(120, "float f() { return 3.0; } float g = f();", "r.x = g;", [3.0, 0.0, 0.0, 0.0]),
    Row(110, "float f() { return 3.0; } float g = f() + 1.0;", "r.x = g;", [4.0, 0.0, 0.0, 0.0]),
    Row(
        120,
        "float f(); float g = f(); float f() { return 3.0; }",
        "g += 1.0; r.x = g;",
        [4.0, 0.0, 0.0, 0.0],
    ),
    Row(
        130,
        "float g = 1.0; float f() { g += 1.0; return 3.0; } float h = f(); float i = g;",
        "r.xyz = vec3(g, h, i);",
        [2.0, 3.0, 2.0, 0.0],
    ),
    // Also those that nobody names, if they have effects
    Row(
        140,
        "float g = 1.0; float f() { g += 1.0; return 3.0; } float h = f();",
        "r.x = g;",
        [2.0, 0.0, 0.0, 0.0],
    ),
    Row(110, "float g; float h = g = 5.0;", "r.x = g;", [5.0, 0.0, 0.0, 0.0]),
    // What is called finds the globals that come later, without their values
    Row(
        120,
        "float f(); float h = f(); float g = 1.0; const float c = 2.0; float a[2];
         float f() { if (g > 0.5) return 9.0; a[1] = c; g = 5.0; return g + a[1]; }",
        "r = vec4(g, h, a[1], c);",
        [1.0, 7.0, 2.0, 2.0],
    ),
    Row(
        120,
        "float f(float a) { for (int i = 0; i < 3; i++) { if (a > 4.0) return a; a *= 2.0; }
         return 0.0; }
         struct S { float a; vec2 b; }; S s = S(f(3.0), vec2(f(5.0), f(0.0)));",
        "r.xyz = vec3(s.a, s.b);",
        [6.0, 5.0, 0.0, 0.0],
    ),
    // Functions have names of their own in 1.10
    Row(
        110,
        "float g = 3.0; float g() { return 2.0; } float h() { return g + 2.0; } float h = 1.0;",
        "r = vec4(g, g(), h, h());",
        [3.0, 2.0, 1.0, 5.0],
    ),
    Row(110, "float cos = 3.0;", "r.xy = vec2(cos, cos(0.0));", [3.0, 1.0, 0.0, 0.0]),
    Row(110, "", "float cos = 0.0; cos = cos(cos); r.x = cos;", [1.0, 0.0, 0.0, 0.0]),
    Row(
        110,
        "float f(float f) { return f * 2.0; }",
        "float f = f(2.0); r.x = f(f);",
        [8.0, 0.0, 0.0, 0.0],
    ),
    // and prototypes among statements,
    Row(
        110,
        "float f() { float g(float); return g(3.0); } float g(float a) { return a * 2.0; }",
        "float g(float a); r.xy = vec2(f(), g(2.0));",
        [6.0, 4.0, 0.0, 0.0],
    ),
    // and structures in structures, whose names are those of the scope around
    Row(
        110,
        "struct T { struct U { float a; vec2 b; } u, w[2]; struct { float c; } v; };",
        "T t; U a = U(3.0, vec2(4.0, 5.0)); t.w[1] = a; t.v.c = 6.0; t.u = t.w[1];
         r = vec4(t.u.a, t.w[1].b, t.v.c);",
        [3.0, 4.0, 5.0, 6.0],
    ),
    Row(
        110,
        "",
        "struct T { struct U { float a; } u; }; T t = T(U(3.0)); r.x = t.u.a;",
        [3.0, 0.0, 0.0, 0.0],
    ),
    // A local structure hides a function, and a structure one of the language's
    Row(
        120,
        "float f(float a) { return a; } struct cos { float a; };",
        "struct f { vec2 a; }; r.xyz = vec3(f(vec2(3.0)).a, cos(4.0).a);",
        [3.0, 3.0, 4.0, 0.0],
    ),
];
