//! The shaders of the CS380 lecture, as printed: which are rejected and why, and what applying the fix-its does.

use gl_api::glsl::{
    Bindings, Comparison, Compiled, DataType, Dim, FixIts, Options, Sampler, Scalar, Stage,
    compile, link,
};

const fn sampler(dim: Dim) -> DataType {
    DataType::Sampler(Sampler { dim, scalar: Scalar::Float, comparison: Comparison::No })
}
const SAMPLER_2D: DataType = sampler(Dim::D2);
const SAMPLER_CUBE: DataType = sampler(Dim::Cube);

const TEXTURED_VERT: &str = include_str!("lecture/textured.vert");
const TEXTURED_FRAG: &str = include_str!("lecture/textured.frag");
const ENVIRONMENT_FRAG: &str = include_str!("lecture/environment.frag");
const PROJECTOR_VERT: &str = include_str!("lecture/projector.vert");
const PROJECTOR_FRAG: &str = include_str!("lecture/projector.frag");

/// The vertex stage of the environment map, which the lecture does not print.
const ENVIRONMENT_VERT: &str = "#version 130
uniform mat4 uProjMatrix, uModelViewMatrix;
uniform mat3 uNormalMatrix;
in vec4 aVertex;
in vec3 aNormal;
out vec3 vNormal;
out vec4 vPosition;
void main() {
    vNormal = uNormalMatrix * aNormal;
    vPosition = uModelViewMatrix * aVertex;
    gl_Position = uProjMatrix * vPosition;
}
";

fn compiled(stage: Stage, source: &str, fix_its: FixIts) -> Compiled {
    compile(stage, source, &Options { fix_its, ..Options::default() })
}

fn linked(vertex: &str, fragment: &str) -> glsl::Program {
    let vertex = compiled(Stage::Vertex, vertex, FixIts::Apply);
    let fragment = compiled(Stage::Fragment, fragment, FixIts::Apply);
    let shaders = [
        vertex.shader.as_ref().unwrap_or_else(|| panic!("{}", vertex.log)),
        fragment.shader.as_ref().unwrap_or_else(|| panic!("{}", fragment.log)),
    ];
    let linked = link(&shaders, &Bindings::default());
    let program = linked.program.unwrap_or_else(|| panic!("{}", linked.log));
    for module in program.vertex.iter().chain(&program.fragment) {
        module.validate().expect("the linker gives valid modules");
    }
    program
}

#[test]
fn as_printed() {
    let table = [
        ("textured.vert", Stage::Vertex, TEXTURED_VERT),
        ("textured.frag", Stage::Fragment, TEXTURED_FRAG),
        ("environment.frag", Stage::Fragment, ENVIRONMENT_FRAG),
        ("projector.vert", Stage::Vertex, PROJECTOR_VERT),
        ("projector.frag", Stage::Fragment, PROJECTOR_FRAG),
    ];
    let mut report = String::new();
    for (name, stage, source) in table {
        let off = compiled(stage, source, FixIts::Suggest);
        let on = compiled(stage, source, FixIts::Apply);
        let verdict = if off.shader.is_some() { "accepted" } else { "rejected" };
        report.push_str(&format!("== {name}: {verdict}\n{}", off.log));
        assert!(on.shader.is_some(), "{name}: {}", on.log);
        report.push_str(&format!("-- with repairs\n{}", on.log));
    }
    insta::assert_snapshot!(report);
}

#[test]
fn textured_square() {
    let program = linked(TEXTURED_VERT, TEXTURED_FRAG);
    let attributes: Vec<_> =
        program.attributes.iter().map(|a| (a.name.as_str(), a.ty, a.location)).collect();
    let vector = |size| DataType::Vector(Scalar::Float, size);
    assert_eq!(
        attributes,
        [("aVertex", vector(2), 0), ("aTexCoord", vector(2), 1), ("aColor", vector(3), 2)]
    );
    // `uVertexScale` is declared and not used, so it is not active.
    let uniforms: Vec<_> =
        program.uniforms.iter().map(|u| (u.name.as_str(), u.ty, u.location, u.word)).collect();
    let matrix = DataType::Matrix(4, 4);
    assert_eq!(
        uniforms,
        [
            ("uProjMatrix", matrix, 0, 0),
            ("uModelViewMatrix", matrix, 1, 16),
            ("uTexUnit0", SAMPLER_2D, 2, 32)
        ]
    );
    assert_eq!(program.samplers.len(), 1);
    assert_eq!((program.samplers[0].slot, program.samplers[0].word), (0, 32));
    assert_eq!(program.words, 33);
}

#[test]
fn projector_and_environment() {
    linked(PROJECTOR_VERT, PROJECTOR_FRAG);
    let program = linked(ENVIRONMENT_VERT, ENVIRONMENT_FRAG);
    assert!(program.uniforms.iter().any(|u| u.ty == SAMPLER_CUBE));
}
