//! Rules of the language, each with a shader that violates it and a part of the expected log.

use gl_api::glsl::Stage::{self, Fragment, Vertex};

/// Shaders that do not compile.
pub const REFUSED: &[(Stage, &str, &str)] = &[
    // Functions of the shader hide the language's, and convert no further than any function.
    (
        Fragment,
        "#version 120\nfloat abs(float a) { return a; }\nvoid main() { bool b = abs(true) > 0.0; }",
        "there are: abs(float)",
    ),
    // Constructors.
    (
        Fragment,
        "void main() { mat2 m = mat2(vec4(1.0), 1.0); }",
        "too many arguments: mat2 takes 4 components",
    ),
    (Fragment, "void main() { mat2 m = mat2(vec3(1.0)); }", "mat2 takes 4 components, not 3"),
    // Uniform blocks.
    (
        Fragment,
        "#version 140\nlayout(std140) layout(row_major) uniform A { mat2 a; };\nvoid main() {}",
        "0:2(16): error: a declaration has one `layout(...)` before GLSL 4.20",
    ),
    // Lines.
    (Fragment, "void main() {}\r\n\rfloat f = true;", "0:3(11): error"),
    (Fragment, "#error not\rvoid main() {}", "#error not\n"),
    // Invariance.
    (
        Vertex,
        "#version 120\nuniform float u; invariant u; void main() {}",
        "only what passes from the vertex to the fragment stage can be invariant",
    ),
    (
        Vertex,
        "#version 120\nattribute float a; invariant a; void main() {}",
        "only what passes from the vertex to the fragment stage can be invariant",
    ),
    (
        Vertex,
        "#version 120\ninvariant float a; void main() {}",
        "only what passes from the vertex to the fragment stage can be invariant",
    ),
    (
        Vertex,
        "#version 120\nfloat a; invariant a; void main() {}",
        "only what passes from the vertex to the fragment stage can be invariant",
    ),
    (
        Vertex,
        "#version 120\ninvariant uniform float a; void main() {}",
        "only what passes from the vertex to the fragment stage can be invariant",
    ),
    (
        Vertex,
        "#version 120\ninvariant attribute float a; void main() {}",
        "only what passes from the vertex to the fragment stage can be invariant",
    ),
    (
        Vertex,
        "#version 120\ninvariant gl_Vertex; void main() {}",
        "only what passes from the vertex to the fragment stage can be invariant",
    ),
    (
        Fragment,
        "#version 120\ninvariant gl_FragColor; void main() {}",
        "only what passes from the vertex to the fragment stage can be invariant",
    ),
    (
        Fragment,
        "#version 130\ninvariant gl_FrontFacing; void main() {}",
        "only what passes from the vertex to the fragment stage can be invariant",
    ),
    (
        Vertex,
        "#version 130\ninvariant in float a; void main() {}",
        "only what passes from the vertex to the fragment stage can be invariant",
    ),
    (
        Vertex,
        "#version 120\nvoid main() { gl_Position = vec4(1.0); } invariant gl_Position;",
        "`gl_Position` is used before it is made invariant",
    ),
    (
        Vertex,
        "#version 100\nvarying float x; void main() { x = 1.0; } invariant x;",
        "`x` is used before it is made invariant",
    ),
    (Vertex, "#version 120\ninvariant x; varying float x; void main() {}", "`x` is not declared"),
    // Functions of the shader make no constants.
    (
        Fragment,
        "#version 120\nfloat f() { return 3.0; }\nconst float g = f();\nvoid main() {}",
        "0:3(17): error: the value of a constant is not a constant expression",
    ),
    (
        Fragment,
        "#version 120\nfloat f() { return 3.0; }\nuniform float g = f();\nvoid main() {}",
        "the value of a uniform is not a constant expression",
    ),
    (
        Fragment,
        "#version 120\nint f() { return 3; }\nfloat g[f()];\nvoid main() {}",
        "the size of an array is a constant integer",
    ),
    (
        Fragment,
        "#version 100\nprecision mediump float;\nfloat f() { return 3.0; }\nfloat g = f();\n\
         void main() {}",
        "functions of the shader cannot be called outside of functions",
    ),
    // `##` joins two tokens.
    (Fragment, "#version 130\n#define A 2##\nvoid main() {}", "0:2(12): error: `##` has nothing"),
    (Fragment, "#version 130\n#define A ##2\nvoid main() {}", "0:2(11): error: `##` has nothing"),
    (Fragment, "#version 130\n#define A(x) x##\nvoid main() {}", "`##` has nothing to join here"),
    (Fragment, "#version 130\n#define A(x) ##x\nvoid main() {}", "`##` has nothing to join here"),
    (
        Fragment,
        "#version 130\n#define A 1\n#define F(x, y) x##y\nint a = F(A, B);\nvoid main() {}",
        "`AB` is not declared",
    ),
    // The body of a `for` or a `while` is in the scope of its head.
    (
        Fragment,
        "void main() { for (int i = 0; i < 3; i++) { float i = 7.0; } }",
        "0:1(51): error: `i` is declared already",
    ),
    (
        Fragment,
        "#version 130\nvoid main() { for (int i = 0; i < 3; i++) float i = 7.0; }",
        "`i` is declared already",
    ),
    (
        Fragment,
        "#version 100\nvoid main() { while (bool i = false) { int i; } }",
        "`i` is declared already",
    ),
    // Conditions.
    (Fragment, "#if defined(\n#endif\nvoid main() {}", "`defined(` takes one name"),
    (Fragment, "#if defined(A B)\n#endif\nvoid main() {}", "`defined(` takes one name"),
    (Fragment, "#if defined\n#endif\nvoid main() {}", "`defined` needs a name"),
    (Fragment, "#if defined 3\n#endif\nvoid main() {}", "`defined` needs a name"),
    (
        Fragment,
        "#define A 3\n#define M(x) defined(x)\n#if M(A)\n#endif\nvoid main() {}",
        "`defined` needs a name",
    ),
    (Fragment, "void main() {}\0float f;", "found the character U+0000"),
    // Names of functions are those of variables, but in 1.10.
    (
        Fragment,
        "#version 120\nfloat g;\nvoid g() {}\nvoid main() {}",
        "0:3(6): error: `g` is declared already, in line 2",
    ),
    (
        Fragment,
        "#version 120\nvoid g() {}\nfloat g;\nvoid main() {}",
        "0:3(7): error: `g` is declared already",
    ),
    (
        Fragment,
        "#version 120\nvoid main() { float sin = 1.0; sin = sin(sin); }",
        "`sin` is a variable, not a function",
    ),
    (
        Fragment,
        "#version 100\nprecision mediump float;\nvoid g() {}\nfloat g;\nvoid main() {}",
        "`g` is declared already",
    ),
    (Fragment, "struct f { float a; };\nvoid f() {}\nvoid main() {}", "`f` is declared already"),
    (
        Fragment,
        "struct f { float a; };\nvoid main() { float f(float a); }",
        "`f` is declared already",
    ),
    (
        Fragment,
        "float f(float a) { return a; }\nstruct f { float b; };\nvoid main() {}",
        "0:2(8): error: `f` is declared already",
    ),
    (Fragment, "float g;\nvoid main() { g(); }", "`g` is a variable, not a function"),
    (Fragment, "float f() { return 1.0; }\nvoid main() { float x = f; }", "it is called with `()`"),
    // Structures in structures and prototypes among statements are of 1.10.
    (
        Fragment,
        "#version 120\nstruct T { struct U { float a; } u; };\nvoid main() {}",
        "a structure cannot be declared inside another",
    ),
    (Fragment, "struct T { struct U { float a; }; U u; };\nvoid main() {}", "expected a name"),
    (Fragment, "struct T { struct T { float a; } t; };\nvoid main() {}", "`T` is declared already"),
    (
        Fragment,
        "#version 120\nvoid main() { float f(float a); }",
        "a function cannot be declared inside another",
    ),
    (
        Fragment,
        "void main() { void f() {} }",
        "0:1(20): error: a function cannot be defined inside another",
    ),
    // What is returned is not converted.
    (
        Fragment,
        "#version 120\nfloat f() { return 1; }\nvoid main() {}",
        "0:2(20): error: cannot return int where float is needed",
    ),
    (
        Fragment,
        "#version 120\nvec2 f() { return ivec2(1); }\nvoid main() {}",
        "write `vec2(ivec2(1))`",
    ),
    // A function and its prototype.
    (
        Fragment,
        "void f(const in int i);\nvoid f(in int i) { i = 3; }\nvoid main() {}",
        "0:2(6): error: `f` differs from its declaration in line 1",
    ),
    // Qualifiers.
    (Fragment, "void main() { const const float a = 1.0; }", "`const` stands here twice"),
    (Fragment, "void f(inout inout float a) {}\nvoid main() {}", "one of `in`, `out` and `inout`"),
    (Fragment, "void f(out in float a) {}\nvoid main() {}", "one of `in`, `out` and `inout`"),
    (Fragment, "uniform uniform float a;\nvoid main() {}", "`uniform` stands here twice"),
    (Fragment, "#version 130\nhighp lowp float a;\nvoid main() {}", "one precision"),
    // There is nothing that is void.
    (Fragment, "void main() { void v[1]; }", "0:1(15): error: there are no arrays of void"),
    (Fragment, "uniform void v[2];\nvoid main() {}", "there are no arrays of void"),
    // Names and numbers.
    (Fragment, "struct S { int gl_a; };\nvoid main() {}", "names that begin with gl_ are reserved"),
    (Fragment, "#version 110\nfloat switch;\nvoid main() {}", "`switch` is reserved"),
    (Fragment, "#version 120\nvoid main() { float a = 1f; }", "which takes no `f`"),
    // Noise is no constant.
    (
        Fragment,
        "#version 120\nvoid main() { const float a = noise1(0.5); }",
        "the value of a constant is not a constant expression",
    ),
];

/// A version in which a shader compiles, one in which it does not, the shader, and a part of the log.
pub const CHANGED: &[(&str, &str, &str, &str)] = &[
    // The comma is no operator of constant expressions from GLSL 1.20 on.
    ("110", "120", "void main() { const vec2 v = (vec2(1.0), vec2(2.0)); }", "constant expression"),
    // Words that a version reserves.
    ("120", "130", "void main() { float superp = 1.0; }", "`superp` is reserved"),
    ("110", "120", "void main() { float precision = 1.0; }", "`precision` is reserved"),
    ("110", "120", "void main() { float lowp = 1.0; }", "`lowp` is reserved"),
    ("130", "140", "void main() { float isampler2DRect; }", "`isampler2DRect` is a keyword"),
    ("120", "140", "void main() { float usampler2DRect; }", "`usampler2DRect` is a keyword"),
    ("130", "140", "void main() { float isamplerBuffer; }", "`isamplerBuffer` is a keyword"),
];

/// Fragment shaders with what their version does not have and all drivers accept, and the message.
pub const DEVIATIONS: &[(Stage, &str, &str)] = &[
    (
        Fragment,
        "#define P(a, b) a ## b\nvoid main() { int P(x, 1) = 1; }",
        "`##` is not in GLSL 1.10",
    ),
    (
        Fragment,
        "#version 120\n#define P(a, b) a##b\n#if P(1, 0) == 10\nvoid main() {}\n#endif",
        "`##` is not in GLSL 1.20",
    ),
    (
        Fragment,
        "#version 120\n#define A 1.0 + \\\n 2.0\nvoid main() { float f = A; }",
        "a line continued by `\\` is not in GLSL 1.20",
    ),
    (
        Fragment,
        "#define A 1.0 + \\\r\n 2.0\r\nvoid main() { float f = A; }",
        "a line continued by `\\` is not in GLSL 1.10",
    ),
    (
        Fragment,
        "#version 140\nvoid main() { float f = \\\r1.0; }",
        "a line continued by `\\` is not in GLSL 1.40",
    ),
    (Fragment, "void main() { float f = 1.0f; }", "the suffix `f` is not in GLSL 1.10"),
    (Fragment, "#if UNKNOWN\n#endif\nvoid main() {}", "`UNKNOWN` is not defined and counts as 0"),
    (
        Fragment,
        "uniform sampler2D s; void main() { gl_FragColor = texture2DLod(s, vec2(0.5), 1.0); }",
        "`texture2DLod` in the fragment stage is an extension",
    ),
    (
        Fragment,
        "void f() {}\n#extension GL_ARB_shader_texture_lod : enable\nvoid main() {}",
        "`#extension` stands behind a part of the program",
    ),
    (
        Fragment,
        "#version 120\nvoid main() { int i = abs(-1); }",
        "`abs` of integers is not in GLSL 1.20",
    ),
    (
        Fragment,
        "#version 140\nuniform B { struct S { float a; } s; };\nvoid main() {}",
        "a structure is not defined inside of a uniform block",
    ),
];

/// Shaders that compile, with a warning.
pub const WARNED: &[(Stage, &str, &str)] = &[
    (
        Fragment,
        "#version 120\nfloat abs(mat2 m) { return 0.0; }\nvoid main() { float f = abs(1.0); }",
        "0:3(25): warning: the shader's own `abs` hides the language's `abs`",
    ),
    (
        Fragment,
        "#version 130\nfloat pow(float a, int n) { return a; }\n\
         void main() { float f = pow(1.0, 2.0); }",
        "warning: the shader's own `pow` hides the language's `pow`",
    ),
    (
        Fragment,
        "#version 140\nuniform A { struct X { float a; } x; };\nvoid main() {}",
        "0:2(13): warning: a structure is not defined inside of a uniform block",
    ),
    (Fragment, "void main() {}\0", "0:1(15): warning: the text ends with U+0000"),
    (Fragment, "void main() {}\n\0\0\n", "0:2(1): warning: the text ends with U+0000"),
];

/// Pairs of a vertex and a fragment shader that link.
pub const LINKED: &[(&str, &str)] = &[
    // Only what both stages declare has to agree.
    (
        "varying float x; void main() { gl_Position = vec4(x); }",
        "varying vec2 y; void main() { gl_FragColor = vec4(1.0); }",
    ),
    // The size of an array may come from the other stage.
    (
        "varying float x[]; void main() { x[1] = 1.0; gl_Position = vec4(1.0); }",
        "varying float x[3]; void main() { gl_FragColor = vec4(1.0); }",
    ),
    // Invariance is declared in both stages, in whichever way.
    (
        "#version 120\ninvariant varying float x; void main() { x = 1.0; gl_Position = vec4(x); }",
        "#version 120\ninvariant varying float x; void main() { gl_FragColor = vec4(x); }",
    ),
    (
        "#version 120\nvarying float x; invariant x; void main() { x = 1.0; gl_Position = vec4(x); }",
        "#version 120\ninvariant varying float x; void main() { gl_FragColor = vec4(x); }",
    ),
    (
        "#version 100\ninvariant varying float x; void main() { x = 1.0; gl_Position = vec4(x); }",
        "#version 100\nprecision mediump float; varying float x; invariant x; void main() { gl_FragColor = vec4(x); }",
    ),
    (
        "#version 120\ninvariant gl_Position, gl_FrontColor; void main() { gl_Position = gl_FrontColor = vec4(1.0); }",
        "#version 120\ninvariant gl_FragCoord; void main() { gl_FragColor = gl_FragCoord; }",
    ),
    (
        "#version 130\ninvariant out float x; void main() { x = 1.0; gl_Position = vec4(x); }",
        "#version 130\ninvariant in float x; invariant out vec4 c; void main() { c = vec4(x); }",
    ),
    // Of what all is invariant, it need not be said.
    (
        "#pragma STDGL invariant(all)\nvarying float x; void main() { x = 1.0; gl_Position = vec4(x); }",
        "#version 120\ninvariant varying float x; void main() { gl_FragColor = vec4(x); }",
    ),
    (
        "#version 120\n#pragma STDGL invariant(all)\nvarying float x; void main() { x = 1.0; gl_Position = vec4(x); }",
        "#version 120\nvarying float x; void main() { gl_FragColor = vec4(x); }",
    ),
];

/// Pairs of a vertex and a fragment shader that compile and do not link.
pub const UNLINKED: &[(&str, &str, &str)] = &[
    // What both stages declare agrees, also where nobody reads it.
    (
        "varying float x; void main() { x = 1.0; gl_Position = vec4(1.0); }",
        "varying vec2 x; void main() { gl_FragColor = vec4(1.0); }",
        "`x` is float in the vertex shader and vec2 in the fragment shader",
    ),
    (
        "varying float x[2]; void main() { gl_Position = vec4(1.0); }",
        "varying float x[3]; void main() { gl_FragColor = vec4(1.0); }",
        "`x` is float[2] in the vertex shader and float[3] in the fragment shader",
    ),
    (
        "#version 130\nflat out float x; void main() { gl_Position = vec4(1.0); }",
        "#version 130\nin float x; void main() { gl_FragColor = vec4(1.0); }",
        "`x` is flat in the vertex shader and smooth in the fragment shader",
    ),
    (
        "#version 120\ncentroid varying float x; void main() { gl_Position = vec4(1.0); }",
        "#version 120\nvarying float x; void main() { gl_FragColor = vec4(1.0); }",
        "`x` is centroid in the vertex shader and not centroid in the fragment shader",
    ),
    // Invariance.
    (
        "#version 120\ninvariant varying float x; void main() { x = 1.0; gl_Position = vec4(x); }",
        "#version 120\nvarying float x; void main() { gl_FragColor = vec4(x); }",
        "`x` is invariant in the vertex shader and not invariant in the fragment shader",
    ),
    (
        "#version 120\nvarying float x; void main() { x = 1.0; gl_Position = vec4(x); }",
        "#version 120\ninvariant varying float x; void main() { gl_FragColor = vec4(x); }",
        "`x` is not invariant in the vertex shader and invariant in the fragment shader",
    ),
    (
        "#version 120\nvarying float x; invariant x; void main() { x = 1.0; gl_Position = vec4(x); }",
        "#version 120\nvarying float x; void main() { gl_FragColor = vec4(x); }",
        "`x` is invariant in the vertex shader and not invariant in the fragment shader",
    ),
    (
        "#version 130\nvarying float x; void main() { x = 1.0; gl_Position = vec4(x); }",
        "#version 130\nvarying float x; invariant x; void main() { gl_FragColor = vec4(x); }",
        "`x` is not invariant in the vertex shader and invariant in the fragment shader",
    ),
    (
        "#version 100\ninvariant varying float x; void main() { x = 1.0; gl_Position = vec4(x); }",
        "#version 100\nprecision mediump float; varying float x; void main() { gl_FragColor = vec4(x); }",
        "`x` is invariant in the vertex shader and not invariant in the fragment shader",
    ),
    (
        "#version 120\n#pragma STDGL invariant(none)\ninvariant varying float x; void main() { gl_Position = vec4(1.0); }",
        "#version 120\nvarying float x; void main() { gl_FragColor = vec4(1.0); }",
        "`x` is invariant in the vertex shader and not invariant in the fragment shader",
    ),
    // Functions that initializers call.
    (
        "void main() { gl_Position = vec4(1.0); }",
        "float f(); float g = f(); void main() { gl_FragColor = vec4(g); }",
        "`f()` is called and never defined",
    ),
];
