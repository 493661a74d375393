//! Shaders of GLSL ES 1.00.

use super::Expected::{Accepted, Refused};
use super::Row;
use gl_api::glsl::Stage::{Fragment, Vertex};

/// By section.
pub const ROWS_100: &[Row] = &[
    ("3.4", Fragment, Accepted, "#if __VERSION__ == 100 && defined(GL_ES)\nvoid main() {}\n#endif"),
    ("3.4", Fragment, Refused, "#if FOO\n#endif\nvoid main() {}"),
    (
        "3.4",
        Fragment,
        Accepted,
        "#ifdef GL_FRAGMENT_PRECISION_HIGH\nprecision highp float;\n#endif\nvoid main() {}",
    ),
    ("3.4", Vertex, Accepted, "#line 9\nint a[__LINE__ == 9 ? 1 : 0];\nvoid main() {}"),
    (
        "3.4",
        Vertex,
        Accepted,
        "#line 9 4\n\nint a[__LINE__ == 10 && __FILE__ == 4 ? 1 : 0];\nvoid main() {}",
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
    (
        "4.2.7",
        Vertex,
        Refused,
        "int f(int a);\nint f(int a);\nint f(int a) { return a; }\nvoid main() {}",
    ),
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
    ("4.1.9", Fragment, Accepted, "void main() { float[2] a; }"),
    ("4.2.2", Fragment, Accepted, "int f(int a) { int a = 1; return a; }\nvoid main() {}"),
    ("4.2.2", Fragment, Refused, "int f(int a, int a) { return a; }\nvoid main() {}"),
    (
        "7.2",
        Fragment,
        Refused,
        "void main() { if (false) gl_FragColor = vec4(1.0); else gl_FragData[0] = vec4(1.0); }",
    ),
    ("8", Fragment, Refused, "float sin(float x);\nvoid main() {}"),
    ("8", Fragment, Refused, "vec2 sin(vec2 x) { return x; }\nvoid main() {}"),
    ("8", Fragment, Accepted, "int sin(int x) { return x; }\nvoid main() { int a = sin(1); }"),
];

/// GLSL ES 1.00 with an extension.
pub const EXTENDED_100: &[(&str, Row)] = &[
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
        "GL_EXT_blend_func_extended",
        (
            "",
            Fragment,
            Accepted,
            "void main() { gl_FragColor = vec4(0.0); gl_SecondaryFragColorEXT = vec4(float(gl_MaxDualSourceDrawBuffersEXT)); }",
        ),
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
