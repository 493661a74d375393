//! Rules of the language, each with a shader that breaks it and words of what the log says.

use gl_api::glsl::Stage::{self, Fragment};

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
    // Lines.
    (Fragment, "void main() {}\r\n\rfloat f = true;", "0:3(11): error"),
    (Fragment, "#error not\rvoid main() {}", "#error not\n"),
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
];
