//! GLSL ES 1.00 and 3.00 in contexts of OpenGL ES: which shaders are accepted, by section of the specification.

use gl_api::glsl::{ContextLanguage, Options, Stage, compile};
use std::fmt::Write as _;

use Stage::{Fragment, Vertex};

/// Whether a shader is accepted.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Expected {
    Accepted,
    Refused,
}

use Expected::{Accepted, Refused};

/// The section, the stage, what is expected, and the shader behind its first lines.
type Row = (&'static str, Stage, Expected, &'static str);

/// The first lines of a shader of GLSL ES 3.00.
const HEADER_300: &str = "#version 300 es\nprecision mediump float;\n";
/// Those of one of GLSL ES 1.00.
const HEADER_100: &str = "precision mediump float;\n";

/// GLSL ES 3.00.
const ROWS_300: &[Row] = &[
    // 3.3 Version, 3.4 preprocessor
    ("3.4", Fragment, Accepted, "#if __VERSION__ == 300 && GL_ES == 1\nvoid main() {}\n#endif"),
    ("3.4", Fragment, Refused, "#if FOO\n#endif\nvoid main() {}"),
    ("3.4", Fragment, Refused, "#define A a ## b\nvoid A() {}\nvoid main() {}"),
    ("3.4", Fragment, Refused, "#ifdef FOO\n#else foo\n#endif\nvoid main() {}"),
    ("3.4", Fragment, Refused, "#ifdef FOO\n#endif foo\nvoid main() {}"),
    ("3.4", Fragment, Refused, "#undef GL_ES foo\nvoid main() {}"),
    ("3.4", Fragment, Refused, "#define GL_FOO 1\nvoid main() {}"),
    ("3.4", Fragment, Accepted, "#define A \\\n 1\nconst int a = A;\nvoid main() {}"),
    // 3.8 Keywords
    ("3.8", Vertex, Refused, "attribute vec4 a;\nvoid main() {}"),
    ("3.8", Vertex, Refused, "varying vec4 a;\nvoid main() {}"),
    ("3.8", Vertex, Refused, "void main() { int noperspective; }"),
    ("3.8", Vertex, Refused, "void main() { int coherent; }"),
    ("3.8", Vertex, Refused, "void main() { int volatile; }"),
    ("3.8", Vertex, Refused, "void main() { int patch; }"),
    ("3.8", Vertex, Refused, "void main() { int sample; }"),
    ("3.8", Vertex, Refused, "void main() { int subroutine; }"),
    ("3.8", Vertex, Refused, "void main() { int resource; }"),
    ("3.8", Vertex, Refused, "void main() { int atomic_uint; }"),
    ("3.8", Vertex, Refused, "void main() { int active; }"),
    ("3.8", Vertex, Refused, "void main() { int filter; }"),
    ("3.8", Vertex, Refused, "void main() { int image2D; }"),
    ("3.8", Vertex, Refused, "void main() { int iimageBuffer; }"),
    ("3.8", Vertex, Refused, "void main() { int sampler1D; }"),
    ("3.8", Vertex, Refused, "void main() { int sampler2DRect; }"),
    ("3.8", Vertex, Refused, "void main() { int isampler2DMS; }"),
    ("3.8", Vertex, Refused, "void main() { int samplerBuffer; }"),
    ("3.8", Vertex, Refused, "void main() { int using; }"),
    ("3.8", Vertex, Accepted, "void main() { int texture2D = 1; }"),
    ("3.9", Vertex, Refused, "void main() { int gl_foo; }"),
    ("3.9", Vertex, Accepted, "void main() { int a__b = 1; }"),
    // 4.1 Types
    ("4.1.3", Fragment, Accepted, "void main() { uint u = 3u; int i = int(u); }"),
    (
        "4.1.9",
        Fragment,
        Accepted,
        "void main() { float a[2] = float[2](1.0, 2.0); a = float[](3.0, 4.0); }",
    ),
    (
        "4.1.9",
        Fragment,
        Accepted,
        "void main() { float a[] = float[](1.0, 2.0); int n = a.length(); }",
    ),
    ("4.1.9", Fragment, Refused, "void main() { float a[]; }"),
    ("4.1.9", Fragment, Refused, "void main() { float a[2][2]; }"),
    ("4.1.9", Fragment, Refused, "void main() { float a[0]; }"),
    ("4.1.8", Fragment, Refused, "struct S { struct T { int a; } t; };\nvoid main() {}"),
    (
        "4.1.8",
        Fragment,
        Accepted,
        "struct S { int a; };\nvoid main() { S s = S(1); bool b = s == S(1); }",
    ),
    // 4.1.10: no implicit conversions
    ("4.1.10", Fragment, Refused, "void main() { float f = 1; }"),
    ("4.1.10", Fragment, Refused, "void main() { vec2 v = vec2(1.0) * 2; }"),
    ("4.1.10", Fragment, Refused, "void main() { uint u = 1; }"),
    ("4.1.10", Fragment, Refused, "float f(float x) { return x; }\nvoid main() { f(1); }"),
    // 4.2 Scoping
    ("4.2.2", Fragment, Refused, "void main() { int a; int a; }"),
    ("4.2.2", Fragment, Refused, "void f(int a) { int a; }\nvoid main() {}"),
    ("4.2.2", Fragment, Accepted, "int a;\nvoid main() { int a = 1; { float a = 1.0; } }"),
    (
        "4.2.2",
        Fragment,
        Refused,
        "int f(int a);\nint f(int a);\nint f(int a) { return a; }\nvoid main() {}",
    ),
    ("4.2.2", Fragment, Refused, "void f() {}\nint f;\nvoid main() {}"),
    ("6.1", Fragment, Refused, "void main() { int f(int a); }"),
    // 4.3 Storage
    ("4.3", Fragment, Refused, "uniform float a = 1.0;\nvoid main() {}"),
    ("4.3", Fragment, Refused, "uniform float a;\nfloat b = a;\nvoid main() {}"),
    ("4.3", Fragment, Accepted, "const float a = sin(1.0);\nfloat b = a;\nvoid main() {}"),
    ("4.3.4", Vertex, Refused, "in bool a;\nvoid main() {}"),
    ("4.3.4", Vertex, Refused, "in float a[2];\nvoid main() {}"),
    ("4.3.4", Vertex, Refused, "struct S { float a; };\nin S s;\nvoid main() {}"),
    (
        "4.3.4",
        Vertex,
        Accepted,
        "layout(location = 3) in mat3 a;\nvoid main() { gl_Position = vec4(a[0], 1.0); }",
    ),
    ("4.3.4", Vertex, Refused, "flat in float a;\nvoid main() {}"),
    ("4.3.4", Fragment, Refused, "in int a;\nvoid main() {}"),
    ("4.3.4", Fragment, Accepted, "flat in int a;\nvoid main() {}"),
    ("4.3.4", Fragment, Accepted, "struct S { float a; };\nin S s;\nvoid main() {}"),
    ("4.3.4", Fragment, Refused, "struct S { float a[2]; };\nin S s;\nvoid main() {}"),
    ("4.3.4", Fragment, Refused, "struct S { float a; };\nin S s[2];\nvoid main() {}"),
    ("4.3.4", Fragment, Refused, "layout(location = 0) in float a;\nvoid main() {}"),
    ("4.3.6", Vertex, Refused, "out int a;\nvoid main() {}"),
    ("4.3.6", Vertex, Refused, "out bool a;\nvoid main() {}"),
    ("4.3.6", Vertex, Refused, "layout(location = 0) out float a;\nvoid main() {}"),
    ("4.3.6", Vertex, Refused, "struct S { int a[2]; };\nflat out S s;\nvoid main() {}"),
    (
        "4.3.6",
        Fragment,
        Accepted,
        "layout(location = 1) out vec4 a;\nlayout(location = 0) out ivec2 b;\nvoid main() {}",
    ),
    ("4.3.6", Fragment, Accepted, "out vec4 a[4];\nvoid main() {}"),
    ("4.3.6", Fragment, Refused, "out mat2 a;\nvoid main() {}"),
    ("4.3.6", Fragment, Refused, "struct S { float a; };\nout S s;\nvoid main() {}"),
    ("4.3.6", Fragment, Refused, "flat out vec4 a;\nvoid main() {}"),
    (
        "4.3.7",
        Fragment,
        Accepted,
        "layout(std140, row_major) uniform B { mat4 m; float f[2]; } b[2];\nvoid main() { vec4 v = b[1].m[0]; }",
    ),
    ("4.3.7", Fragment, Refused, "uniform B { sampler2D s; };\nvoid main() {}"),
    ("4.3.7", Fragment, Refused, "out B { vec4 a; };\nvoid main() {}"),
    ("4.3.7", Fragment, Refused, "uniform B { vec4 a = vec4(1.0); };\nvoid main() {}"),
    (
        "4.3.7",
        Fragment,
        Refused,
        "uniform B { int a; } b[2];\nvoid main() { int i = 1; int a = b[i].a; }",
    ),
    // 4.5 Precision
    ("4.5.3", Fragment, Accepted, "lowp float a; mediump vec2 b; highp mat2 c;\nvoid main() {}"),
    ("4.5.3", Fragment, Refused, "lowp bool a;\nvoid main() {}"),
    ("4.5.3", Fragment, Refused, "struct S { int a; };\nlowp S s;\nvoid main() {}"),
    ("4.5.4", Fragment, Refused, "precision lowp uint;\nvoid main() {}"),
    ("4.5.4", Fragment, Refused, "precision lowp vec2;\nvoid main() {}"),
    ("4.5.4", Fragment, Refused, "uniform sampler3D s;\nvoid main() {}"),
    (
        "4.5.4",
        Fragment,
        Accepted,
        "precision lowp sampler3D;\nuniform sampler3D s;\nvoid main() {}",
    ),
    ("4.5.4", Fragment, Refused, "uniform sampler2DShadow s;\nvoid main() {}"),
    ("4.5.4", Fragment, Refused, "uniform isampler2D s;\nvoid main() {}"),
    ("4.5.4", Vertex, Refused, "uniform sampler2DArray s;\nvoid main() {}"),
    ("4.5.4", Fragment, Accepted, "uniform sampler2D s; uniform samplerCube c;\nvoid main() {}"),
    // 4.6 Invariance
    ("4.6.1", Vertex, Accepted, "invariant gl_Position;\ninvariant out vec4 a;\nvoid main() {}"),
    ("4.6.1", Fragment, Refused, "invariant in vec4 a;\nvoid main() {}"),
    // 4.7 Order
    ("4.7", Vertex, Refused, "out flat int a;\nvoid main() {}"),
    ("4.7", Vertex, Refused, "out highp invariant vec4 a;\nvoid main() {}"),
    ("4.7", Vertex, Accepted, "invariant centroid out highp vec4 a;\nvoid main() {}"),
    // 5 Operators
    ("5.1", Fragment, Accepted, "void main() { int a = (7 % 3) ^ (1 << 2) & ~1; a %= 2; }"),
    ("5.1", Fragment, Refused, "void main() { float a = 7.0 % 3.0; }"),
    ("5.9", Fragment, Refused, "void main() { bool b = vec2(1.0) < vec2(2.0); }"),
    ("5.9", Fragment, Accepted, "void main() { int a = 1 > 2 ? 3 : 4; }"),
    (
        "5.7",
        Fragment,
        Refused,
        "uniform sampler2D s[2];\nvoid main() { int i = 1; vec4 a = texture(s[i], vec2(0.0)); }",
    ),
    (
        "5.7",
        Fragment,
        Accepted,
        "uniform sampler2D s[2];\nvoid main() { const int i = 1; vec4 a = texture(s[i], vec2(0.0)); }",
    ),
    (
        "5.4.2",
        Fragment,
        Accepted,
        "void main() { mat3 a = mat3(mat2(1.0)); mat2x3 b = mat2x3(a); }",
    ),
    // 6 Statements
    ("6.1", Fragment, Refused, "float sin(float x) { return x; }\nvoid main() {}"),
    ("6.1", Fragment, Refused, "float sin(int x) { return 1.0; }\nvoid main() {}"),
    ("6.1", Fragment, Refused, "void f() { f(); }\nvoid main() { f(); }"),
    ("6.1", Fragment, Refused, "int main() { return 1; }"),
    ("6.1", Fragment, Refused, "float[2][2] f() {}\nvoid main() {}"),
    (
        "6.1",
        Fragment,
        Accepted,
        "float[2] f() { return float[2](1.0, 2.0); }\nvoid main() { float a = f()[1]; }",
    ),
    (
        "6.2",
        Fragment,
        Accepted,
        "void main() { int a = 1; switch (a) { case 0: a = 2; break; default: a = 3; } }",
    ),
    ("6.2", Fragment, Refused, "void main() { int a = 1; switch (a) { case 0: case 0: a = 2; } }"),
    ("6.2", Fragment, Refused, "void main() { float a = 1.0; switch (a) { case 0: a = 2.0; } }"),
    ("6.2", Fragment, Refused, "void main() { if (1) {} }"),
    ("6.4", Vertex, Refused, "void main() { discard; }"),
    // 7 Built-in variables
    (
        "7.1",
        Vertex,
        Accepted,
        "void main() { gl_Position = vec4(gl_VertexID, gl_InstanceID, 0, 1); gl_PointSize = 1.0; }",
    ),
    ("7.1", Vertex, Refused, "void main() { gl_FrontColor = vec4(1.0); }"),
    ("7.1", Vertex, Refused, "void main() { gl_ClipDistance[0] = 1.0; }"),
    ("7.2", Fragment, Refused, "void main() { gl_FragColor = vec4(1.0); }"),
    ("7.2", Fragment, Refused, "void main() { gl_FragData[0] = vec4(1.0); }"),
    ("7.2", Fragment, Accepted, "void main() { gl_FragDepth = gl_FragCoord.z; }"),
    ("7.2", Fragment, Refused, "void main() { int a = gl_PrimitiveID; }"),
    (
        "7.3",
        Fragment,
        Accepted,
        "const int a = gl_MaxVertexOutputVectors + gl_MinProgramTexelOffset;\nvoid main() {}",
    ),
    ("7.3", Fragment, Refused, "const int a = gl_MaxVaryingVectors;\nvoid main() {}"),
    // 8 Built-in functions
    (
        "8.3",
        Fragment,
        Accepted,
        "void main() { float i; float f = modf(1.5, i) + trunc(1.5) + roundEven(0.5) + float(isnan(i)); }",
    ),
    ("8.3", Fragment, Accepted, "void main() { vec2 a = mix(vec2(0.0), vec2(1.0), bvec2(true)); }"),
    (
        "8.4",
        Fragment,
        Accepted,
        "void main() { vec2 a = unpackHalf2x16(packHalf2x16(vec2(1.0))); }",
    ),
    ("8.4", Fragment, Refused, "void main() { vec4 a = unpackUnorm4x8(1u); }"),
    (
        "8.6",
        Fragment,
        Accepted,
        "void main() { mat2 a = inverse(mat2(1.0)); float b = determinant(a); }",
    ),
    (
        "8.8",
        Fragment,
        Accepted,
        "uniform sampler2D s;\nvoid main() { vec4 a = textureOffset(s, vec2(0.0), ivec2(-8, 7), 1.0); }",
    ),
    (
        "8.8",
        Fragment,
        Refused,
        "uniform sampler2D s;\nvoid main() { vec4 a = textureOffset(s, vec2(0.0), ivec2(-9, 7)); }",
    ),
    (
        "8.8",
        Fragment,
        Refused,
        "uniform sampler2D s;\nvoid main() { ivec2 o = ivec2(1); vec4 a = textureOffset(s, vec2(0.0), o); }",
    ),
    (
        "8.8",
        Vertex,
        Refused,
        "uniform sampler2D s;\nvoid main() { gl_Position = texture(s, vec2(0.0), 1.0); }",
    ),
    (
        "8.8",
        Vertex,
        Accepted,
        "uniform sampler2D s;\nvoid main() { gl_Position = textureGrad(s, vec2(0.0), vec2(1.0), vec2(0.0)) + texelFetch(s, ivec2(0), 0); }",
    ),
    (
        "8.8",
        Fragment,
        Refused,
        "uniform sampler2D s;\nvoid main() { vec4 a = texture2D(s, vec2(0.0)); }",
    ),
    (
        "8.8",
        Fragment,
        Refused,
        "uniform sampler2D s;\nvoid main() { vec4 a = textureGather(s, vec2(0.0)); }",
    ),
    ("8.9", Fragment, Accepted, "in float a;\nvoid main() { float b = dFdx(a) + fwidth(a); }"),
    ("8.9", Vertex, Refused, "void main() { float b = dFdx(1.0); }"),
    ("8", Fragment, Refused, "void main() { float a = noise1(1.0); }"),
];

/// GLSL ES 1.00.
const ROWS_100: &[Row] = &[
    ("3.4", Fragment, Accepted, "#if __VERSION__ == 100 && defined(GL_ES)\nvoid main() {}\n#endif"),
    ("3.4", Fragment, Refused, "#if FOO\n#endif\nvoid main() {}"),
    (
        "3.4",
        Fragment,
        Accepted,
        "#ifdef GL_FRAGMENT_PRECISION_HIGH\nprecision highp float;\n#endif\nvoid main() {}",
    ),
    ("3.6", Fragment, Refused, "void main() { int flat; }"),
    ("3.6", Fragment, Refused, "void main() { int switch; }"),
    ("3.6", Fragment, Refused, "void main() { int default; }"),
    ("3.6", Fragment, Refused, "void main() { int sampler3D; }"),
    ("3.6", Fragment, Refused, "void main() { int sampler2DShadow; }"),
    ("3.6", Fragment, Refused, "void main() { int sampler2DRect; }"),
    ("3.6", Fragment, Refused, "void main() { int half; }"),
    ("3.6", Fragment, Refused, "void main() { int superp; }"),
    ("3.6", Fragment, Accepted, "void main() { int smooth = 1; int layout = 2; int uint = 3; }"),
    ("4.1.8", Fragment, Refused, "struct S { struct T { int a; } t; };\nvoid main() {}"),
    ("4.1.9", Fragment, Refused, "void main() { float a[2] = float[2](1.0, 2.0); }"),
    ("4.1.9", Fragment, Refused, "void main() { float a[2]; float b[2]; a = b; }"),
    ("4.1.9", Fragment, Refused, "void main() { float a[2]; float b[2]; bool c = a == b; }"),
    ("4.3", Fragment, Refused, "uniform float a;\nfloat b = a;\nvoid main() {}"),
    ("4.3.3", Vertex, Refused, "attribute int a;\nvoid main() {}"),
    ("4.3.3", Fragment, Refused, "attribute vec4 a;\nvoid main() {}"),
    ("4.3.5", Vertex, Refused, "varying int a;\nvoid main() {}"),
    ("4.3.5", Vertex, Accepted, "varying float a[2];\nvoid main() {}"),
    ("4.5.3", Vertex, Accepted, "uniform float a;\nvoid main() {}"),
    ("5.1", Fragment, Refused, "void main() { int a = 7 % 3; }"),
    ("5.1", Fragment, Refused, "void main() { int a = 1 & 3; }"),
    ("5.1", Fragment, Refused, "void main() { int a = 1 << 3; }"),
    ("5.1", Fragment, Refused, "void main() { int a = ~3; }"),
    ("5.4.2", Fragment, Refused, "void main() { mat3 a = mat3(mat2(1.0)); }"),
    ("5.8", Fragment, Refused, "void main() { float a = 1; }"),
    ("6.1", Fragment, Refused, "void f() { f(); }\nvoid main() { f(); }"),
    ("6.1", Fragment, Refused, "float[2] f() { float a[2]; return a; }\nvoid main() {}"),
    ("7.1", Fragment, Accepted, "void main() { gl_FragData[0] = vec4(gl_PointCoord, 0.0, 1.0); }"),
    ("7.2", Fragment, Refused, "void main() { gl_FragDepth = 1.0; }"),
    ("7.2", Fragment, Accepted, "void main() { gl_FragColor = vec4(gl_FragCoord.z); }"),
    (
        "8.7",
        Fragment,
        Refused,
        "uniform sampler2D s;\nvoid main() { gl_FragColor = texture2DLod(s, vec2(0.0), 1.0); }",
    ),
    (
        "8.7",
        Vertex,
        Accepted,
        "uniform sampler2D s;\nvoid main() { gl_Position = texture2DLod(s, vec2(0.0), 1.0); }",
    ),
    (
        "8.7",
        Vertex,
        Refused,
        "uniform sampler2D s;\nvoid main() { gl_Position = texture2D(s, vec2(0.0), 1.0); }",
    ),
    (
        "8.7",
        Fragment,
        Refused,
        "uniform sampler2D s;\nvoid main() { gl_FragColor = texture(s, vec2(0.0)); }",
    ),
    ("8", Fragment, Refused, "varying float a;\nvoid main() { float b = dFdx(a); }"),
    ("8", Fragment, Refused, "void main() { mat2 a = transpose(mat2(1.0)); }"),
];

/// GLSL ES 1.00 with an extension.
const EXTENDED_100: &[(&str, Row)] = &[
    (
        "GL_OES_standard_derivatives",
        (
            "",
            Fragment,
            Accepted,
            "varying float a;\nvoid main() { gl_FragColor = vec4(dFdx(a), fwidth(a), 0.0, 1.0); }",
        ),
    ),
    (
        "GL_EXT_frag_depth",
        (
            "",
            Fragment,
            Accepted,
            "void main() { gl_FragDepthEXT = 0.5; gl_FragColor = vec4(1.0); }",
        ),
    ),
    (
        "GL_EXT_shader_texture_lod",
        (
            "",
            Fragment,
            Accepted,
            "uniform sampler2D s; uniform samplerCube c;\nvoid main() { gl_FragColor = texture2DLodEXT(s, vec2(0.0), 1.0) + textureCubeGradEXT(c, vec3(1.0), vec3(0.0), vec3(0.0)) + texture2DProjLodEXT(s, vec3(1.0), 0.0); }",
        ),
    ),
    (
        "GL_EXT_draw_buffers",
        ("", Fragment, Accepted, "void main() { gl_FragData[3] = vec4(1.0); }"),
    ),
    (
        "GL_APPLE_clip_distance",
        (
            "",
            Vertex,
            Accepted,
            "void main() { gl_Position = vec4(0.0); gl_ClipDistance[1] = 1.0; }",
        ),
    ),
];

fn check(header: &str, rows: &[Row], wrong: &mut String) {
    let options = Options { context: ContextLanguage::Es30, ..Options::default() };
    for (section, stage, expected, body) in rows {
        let compiled = compile(*stage, &format!("{header}{body}\n"), &options);
        if compiled.shader.is_some() != (*expected == Accepted) {
            let what = if *expected == Accepted { "refused" } else { "accepted" };
            let _ = writeln!(wrong, "{section}: {what}: {body}\n{}", compiled.log);
        }
    }
}

#[test]
fn shaders_are_accepted_as_the_specification_says() {
    let mut wrong = String::new();
    check(HEADER_300, ROWS_300, &mut wrong);
    check(HEADER_100, ROWS_100, &mut wrong);
    check("#version 100\n#line 1\nprecision mediump float;\n", ROWS_100, &mut wrong);
    for (extension, row) in EXTENDED_100 {
        let header = format!("#extension {extension} : require\n{HEADER_100}");
        check(&header, &[*row], &mut wrong);
        let refused = if *extension == "GL_EXT_draw_buffers" { Accepted } else { Refused };
        check(HEADER_100, &[(extension, row.1, refused, row.3)], &mut wrong);
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Defaults of precision: none of floats in the fragment stage (section 4.5.4), and only within their scope.
#[test]
fn floats_of_the_fragment_stage_need_a_precision() {
    let mut wrong = String::new();
    for header in ["", "#version 300 es\n"] {
        let rows: &[Row] = &[
            ("4.5.4", Fragment, Refused, "uniform float a;\nvoid main() {}"),
            ("4.5.4", Fragment, Refused, "void main() { vec2 a; }"),
            ("4.5.4", Fragment, Refused, "float f() { return 1.0; }\nvoid main() {}"),
            ("4.5.4", Fragment, Refused, "void main() { { precision lowp float; } float a; }"),
            ("4.5.4", Fragment, Accepted, "uniform lowp float a;\nvoid main() { int i = 1; }"),
            ("4.5.4", Vertex, Accepted, "uniform float a;\nvoid main() { gl_Position = vec4(a); }"),
        ];
        check(header, rows, &mut wrong);
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// `#version 300 es` stands first; other versions are OpenGL's.
#[test]
fn versions_of_opengl_es() {
    let mut wrong = String::new();
    let rows: &[Row] = &[
        ("3.3", Vertex, Accepted, "#version 100\nvoid main() {}"),
        ("3.3", Vertex, Accepted, "#version 300 es\nvoid main() {}"),
        ("3.3", Vertex, Refused, "#version 300\nvoid main() {}"),
        ("3.3", Vertex, Refused, "#version 100 es\nvoid main() {}"),
        ("3.3", Vertex, Refused, "#version 310 es\nvoid main() {}"),
        ("3.3", Vertex, Refused, "#version 330\nvoid main() {}"),
        ("3.3", Vertex, Refused, "precision highp float;\n#version 300 es\nvoid main() {}"),
        ("3.3", Vertex, Refused, "#version 300 es core\nvoid main() {}"),
    ];
    check("", rows, &mut wrong);
    assert!(wrong.is_empty(), "{wrong}");
}
