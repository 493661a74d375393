//! GLSL 1.50 and 3.30: which shaders the contexts of GL 3.3 accept, and which programs link.

use gl_api::glsl::interface::VARYING_USER;
use gl_api::glsl::{Bindings, ContextLanguage, Linked, Options, Shader, Stage, compile, link};
use rasterizer::ir::{Input, Output};
use rasterizer::shader::{Invocation, Machine, Program};
use std::fmt::Write as _;
use texunit::lanes::{Isa, LANES};

use ContextLanguage::{Compatibility31, Compatibility33, Core33};
use Stage::{Fragment, Geometry, Vertex};

/// Compiles for a context.
fn compiled(context: ContextLanguage, stage: Stage, source: &str) -> Result<Shader, String> {
    let compiled = compile(stage, source, &Options { context, ..Options::default() });
    compiled.shader.ok_or(compiled.log)
}

/// Shaders that a context accepts.
const ACCEPTED: &[(ContextLanguage, Stage, &str)] = &[
    (
        Compatibility33,
        Vertex,
        "#version 150 compatibility\nvoid main() { gl_Position = ftransform(); }",
    ),
    (
        Compatibility33,
        Vertex,
        "#version 150\n#extension GL_ARB_compatibility : enable\nvoid main() { gl_Position = gl_Vertex; }",
    ),
    (Compatibility33, Vertex, "#version 140\nvoid main() { gl_Position = gl_Vertex; }"),
    (Compatibility33, Vertex, "#version 110\nvoid main() { gl_Position = gl_Vertex; }"),
    (Core33, Vertex, "#version 120\nvoid main() { gl_Position = gl_Vertex; }"),
    (Core33, Vertex, "#version 150 core\nin vec4 a;\nvoid main() { gl_Position = a; }"),
    (Core33, Fragment, "#version 330\nvoid main() { gl_FragColor = vec4(1.0); }"),
    (
        Core33,
        Fragment,
        "#version 330\nuniform sampler2D t;\nvoid main() { gl_FragColor = texture2D(t, vec2(0.5)); }",
    ),
    // Blocks of inputs, outputs and uniforms
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; flat int b; noperspective float c[2]; } x;\nvoid main() { x.a = vec4(1.0); x.b = 1; x.c[1] = 2.0; }",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { out vec4 a; };\nuniform B { vec4 c; } u[2];\nvoid main() { a = u[1].c; }",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x[3];\nvoid main() { for (int i = 0; i < x.length(); i++) x[i].a = vec4(i); }",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout gl_PerVertex { vec4 gl_Position; float gl_ClipDistance[4]; };\nvoid main() { gl_Position = vec4(gl_ClipDistance.length()); }",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nstruct S { vec4 a; };\nin vec4 v[2];\nout S s;\nvoid main() { s.a = v[1]; }",
    ),
    (
        Core33,
        Fragment,
        "#version 330\nlayout(location = 0, index = 1) out vec4 r;\nvoid main() { r = vec4(1.0); }",
    ),
    (
        Core33,
        Fragment,
        "#version 150\nlayout(ORIGIN_upper_left) in vec4 gl_FragCoord;\nvoid main() { gl_FragColor = gl_FragCoord; }",
    ),
    (
        Core33,
        Fragment,
        "#version 330\n#extension GL_ARB_conservative_depth : enable\nlayout(depth_less) out float gl_FragDepth;\nvoid main() { gl_FragDepth = 0.5; }",
    ),
    (
        Core33,
        Fragment,
        "#version 330\nstruct L { sampler2D map; vec4 c; };\nuniform L l[3];\nuniform int n;\nvoid main() { gl_FragColor = texture(l[n].map, vec2(0.5)); }",
    ),
    // The geometry stage
    (
        Core33,
        Geometry,
        "#version 150\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\nin vec4 a[];\nin B { float b; } x[];\nout B { float b; };\nvoid main() { for (int i = 0; i < gl_in.length(); i++) { gl_Position = gl_in[i].gl_Position + a[i]; b = x[i].b; gl_Layer = gl_PrimitiveIDIn; gl_PrimitiveID = a.length(); EmitVertex(); } EndPrimitive(); }",
    ),
    (
        Core33,
        Geometry,
        "#version 150\nin vec4 a[3];\nlayout(triangles) in;\nin vec4 b[];\nlayout(triangles) in;\nvoid main() { gl_Position = a[2] + b[2]; }",
    ),
    (
        Core33,
        Geometry,
        "#version 150\nin gl_PerVertex { vec4 gl_Position; float gl_ClipDistance[2]; } gl_in[];\nout gl_PerVertex { vec4 gl_Position; };\nvoid main() { gl_Position = gl_in[0].gl_Position * gl_in[1].gl_ClipDistance[1]; }",
    ),
    (
        Compatibility33,
        Geometry,
        "#version 150 compatibility\nlayout(lines) in;\nvoid main() { gl_FrontColor = gl_in[1].gl_FrontColor + gl_in[0].gl_TexCoord[3] + gl_in[0].gl_ClipVertex; gl_TexCoord[0] = gl_ModelViewMatrix[0]; }",
    ),
    (Core33, Fragment, "#version 150\nvoid main() { gl_FragColor = vec4(gl_PrimitiveID); }"),
    (Core33, Fragment, "#version 100\nvoid main() { gl_FragColor = vec4(1.0); }"),
];

#[test]
fn accepted() {
    let mut wrong = String::new();
    for &(context, stage, source) in ACCEPTED {
        if let Err(log) = compiled(context, stage, source) {
            let _ = writeln!(wrong, "{context:?}: {source}\n{log}");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Shaders that a context refuses, and words of the log.
const REFUSED: &[(ContextLanguage, Stage, &str, &str)] = &[
    (Compatibility31, Vertex, "#version 150\nvoid main() {}", "GLSL version 150 is not supported"),
    (
        Core33,
        Vertex,
        "#version 150 compatibility\nvoid main() {}",
        "this context has no compatibility profile",
    ),
    (Core33, Vertex, "#version 330 es\nvoid main() {}", "`es` is no profile"),
    (Core33, Vertex, "#version 140 core\nvoid main() {}", "unexpected `core` after the version"),
    (
        Core33,
        Vertex,
        "#version 330 core core\nvoid main() {}",
        "unexpected `core` after the version",
    ),
    (Core33, Vertex, "#version 140\nvoid main() { gl_Position = gl_Vertex; }", "`gl_Vertex`"),
    (
        Compatibility33,
        Vertex,
        "#version 150\nvoid main() { gl_Position = gl_Vertex; }",
        "`gl_Vertex`",
    ),
    (
        Compatibility33,
        Vertex,
        "#version 330 core\nvoid main() { gl_Position = ftransform(); }",
        "`ftransform`",
    ),
    (
        Core33,
        Vertex,
        "#version 150\n#extension GL_ARB_compatibility : require\nvoid main() {}",
        "extension `GL_ARB_compatibility` is not supported",
    ),
    // Relaxed rules
    (
        Core33,
        Vertex,
        "#version 330\nvoid main() { float a[] = {1.0}; }",
        "expected an expression, found `{`",
    ),
    (
        Core33,
        Vertex,
        "#version 330\n#extension GL_ARB_shading_language_420pack : enable\nvoid main() { vec2 a = {1.0, 2.0, 3.0}; }",
        "vec2 takes a list of 2, not of 3",
    ),
    (
        Core33,
        Vertex,
        "#version 330\n#extension GL_ARB_shading_language_420pack : enable\nvoid main() { float a = {1.0}; }",
        "a list gives no float",
    ),
    (
        Core33,
        Vertex,
        "#version 330\n#extension GL_ARB_shading_language_420pack : enable\nlayout(binding = 2) uniform vec4 a;\nvoid main() {}",
        "only samplers and uniform blocks have a binding",
    ),
    (
        Core33,
        Vertex,
        "#version 330\n#extension GL_ARB_shading_language_420pack : enable\nlayout(binding = 9999) uniform sampler2D a[2];\nvoid main() {}",
        "2 bindings from 9999 on",
    ),
    (
        Core33,
        Vertex,
        "#version 330\n#extension GL_ARB_shading_language_420pack : enable\nlayout(binding = 64) uniform B { vec4 a; };\nvoid main() {}",
        "binding 64: there are 64 bindings of uniform buffers",
    ),
    // Layouts
    (
        Core33,
        Fragment,
        "#version 330\nlayout(depth_less) out float gl_FragDepth;\nvoid main() {}",
        "`depth_less` is no layout",
    ),
    (
        Core33,
        Fragment,
        "#version 330\n#extension GL_ARB_conservative_depth : enable\nlayout(depth_less) out float d;\nvoid main() {}",
        "only gl_FragDepth has one",
    ),
    (
        Core33,
        Fragment,
        "#version 330\n#extension GL_ARB_conservative_depth : enable\nvoid f() { gl_FragDepth = 0.5; }\nlayout(depth_less) out float gl_FragDepth;\nvoid main() {}",
        "`gl_FragDepth` is used before it is redeclared",
    ),
    (
        Core33,
        Fragment,
        "#version 330\nuniform sampler2D t[3];\nuniform int n;\nvoid main() { gl_FragColor = texture(t[n], vec2(0.5)); }",
        "samplers are indexed by constant expressions only",
    ),
    // Blocks
    (
        Core33,
        Vertex,
        "#version 140\nout B { vec4 a; };\nvoid main() {}",
        "blocks of inputs and outputs are not in GLSL 1.40",
    ),
    (
        Core33,
        Vertex,
        "#version 140\nuniform B { vec4 a; } b;\nvoid main() {}",
        "a block has no name behind it in GLSL 1.40",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nin B { vec4 a; };\nvoid main() {}",
        "the vertex stage has no blocks of inputs",
    ),
    (
        Core33,
        Fragment,
        "#version 150\nout B { vec4 a; };\nvoid main() {}",
        "the fragment stage has no blocks of outputs",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nflat out B { vec4 a; };\nvoid main() {}",
        "stands `in` or `out` alone",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { uniform vec4 a; };\nvoid main() {}",
        "a second word that says what the variable is for",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a = vec4(1.0); };\nvoid main() {}",
        "takes no value",
    ),
    (Core33, Vertex, "#version 150\nout B { sampler2D s; };\nvoid main() {}", "must be a uniform"),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x;\nvoid main() { a = vec4(1.0); }",
        "`a` is not declared",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x;\nvoid main() { x.b = vec4(1.0); }",
        "has no member `b`",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x[2];\nvoid main() { x.a = vec4(1.0); }",
        "an index is missing",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x;\nvoid main() { x[0].a = vec4(1.0); }",
        "no array of them",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout B { vec4 a; } x;\nvoid main() { x; }",
        "its members have values",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nvec4 B;\nout B { vec4 a; } x;\nvoid main() {}",
        "`B` is declared already",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nuniform B { vec4 a; } u[2];\nuniform int i;\nvoid main() { gl_Position = u[i].a; }",
        "constant expressions only",
    ),
    (Core33, Vertex, "#version 150\nuniform B { vec4 a; } u[];\nvoid main() {}", "needs a size"),
    (
        Core33,
        Vertex,
        "#version 150\nout gl_PerVertex { vec4 gl_Position; };\nvoid main() { gl_PointSize = 1.0; }",
        "is not in the redeclared `gl_PerVertex`",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout gl_PerVertex { vec4 t; };\nvoid main() {}",
        "no member of `gl_PerVertex`",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nout gl_PerVertex { vec4 gl_Position; } x;\nvoid main() {}",
        "has no name behind it",
    ),
    (
        Core33,
        Vertex,
        "#version 150\nvoid f() { gl_PointSize = 1.0; }\nout gl_PerVertex { vec4 gl_Position; };\nvoid main() {}",
        "is used before `gl_PerVertex` is redeclared",
    ),
    (
        Core33,
        Fragment,
        "#version 330\nlayout(index = 1) out vec4 r;\nvoid main() { r = vec4(1.0); }",
        "an index stands beside a location",
    ),
    (
        Core33,
        Fragment,
        "#version 330\nlayout(location = 0, index = 2) out vec4 r;\nvoid main() { r = vec4(1.0); }",
        "an index is 0 or 1",
    ),
    (
        Core33,
        Fragment,
        "#version 150\nlayout(origin_upper_left) in vec4 gl_FragCoord;\nin vec4 gl_FragCoord;\nvoid main() {}",
        "another layout in the declaration before",
    ),
];

#[test]
fn refused() {
    let mut wrong = String::new();
    for &(context, stage, source, words) in REFUSED {
        match compiled(context, stage, source) {
            Err(log) if log.contains(words) => {}
            Err(log) => _ = writeln!(wrong, "{context:?}: {source}\nexpected {words:?}:\n{log}"),
            Ok(_) => _ = writeln!(wrong, "{context:?}: {source}\nis accepted"),
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Vertex and fragment shaders of version 150, and words of the log of their link; no words: they link.
const PAIRS: &[(&str, &str, &str)] = &[
    (
        "out B { vec4 a; flat int b; } x;\nvoid main() { x.a = vec4(1.0); x.b = 2; gl_Position = x.a; }",
        "in B { vec4 a; flat int b; } y;\nout vec4 r;\nvoid main() { r = y.a * y.b; }",
        "",
    ),
    (
        "out B { vec4 a; };\nvoid main() { a = gl_Position = vec4(1.0); }",
        "in B { vec4 a; } y;\nout vec4 r;\nvoid main() { r = y.a; }",
        "",
    ),
    (
        "struct S { vec4 a; float b[2]; };\nout S s;\nvoid main() { s.b[1] = 1.0; gl_Position = vec4(1.0); }",
        "struct S { vec4 a; float b[2]; };\nin S s;\nout vec4 r;\nvoid main() { r = s.a * s.b[1]; }",
        "",
    ),
    (
        "out B { vec4 a; vec4 b; };\nvoid main() { a = b = gl_Position = vec4(1.0); }",
        "in B { vec4 b; vec4 a; };\nout vec4 r;\nvoid main() { r = a; }",
        "the block `B` has other members",
    ),
    (
        "out B { vec4 a; };\nvoid main() { a = gl_Position = vec4(1.0); }",
        "in B { vec4 a; } y[1];\nout vec4 r;\nvoid main() { r = y[0].a; }",
        "the block `B` is an array of instances in one stage only",
    ),
    (
        "out B { vec4 a; };\nvoid main() { a = gl_Position = vec4(1.0); }",
        "in vec4 a;\nout vec4 r;\nvoid main() { r = a; }",
        "reads `a`, which no vertex shader writes",
    ),
    (
        "uniform B { vec4 a; };\nvoid main() { gl_Position = a; }",
        "uniform B { vec4 a; } u;\nout vec4 r;\nvoid main() { r = u.a; }",
        "another layout in another shader",
    ),
    (
        "out B { float f[]; } x;\nvoid main() { x.f[1] = 1.0; gl_Position = vec4(1.0); }",
        "in B { float f[]; } x;\nout vec4 r;\nvoid main() { r = vec4(x.f[2]); }",
        "is float[2] in the vertex shader and float[3] in the fragment shader",
    ),
];

#[test]
fn pairs() {
    let mut wrong = String::new();
    for (vertex, fragment, words) in PAIRS {
        let shaders = [(Vertex, vertex), (Fragment, fragment)].map(|(stage, source)| {
            compiled(Core33, stage, &format!("#version 150\n{source}"))
                .unwrap_or_else(|log| panic!("{source}\n{log}"))
        });
        let linked = link(&[&shaders[0], &shaders[1]], &Bindings::default());
        if linked.program.is_some() != words.is_empty() || !linked.log.contains(words) {
            let _ = writeln!(wrong, "{vertex}\n{fragment}\nexpected {words:?}:\n{}", linked.log);
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// The instances of an array of uniform blocks are blocks; their members are listed once.
#[test]
fn instances_of_uniform_blocks() {
    let source = "#version 150\nuniform B { vec4 a; float b; } u[2];\nvoid main() { gl_Position = u[1].a * u[0].b; }";
    let shader = compiled(Core33, Vertex, source).unwrap_or_else(|log| panic!("{log}"));
    let program = link(&[&shader], &Bindings::default()).program.expect("it links");
    let blocks: Vec<&str> = program.blocks.iter().map(|block| &*block.name).collect();
    let members: Vec<&str> = program.members.iter().map(|member| &*member.name).collect();
    assert_eq!((blocks, members), (vec!["B[0]", "B[1]"], vec!["B.a", "B.b"]));
    assert_eq!(program.blocks[1].word, program.blocks[0].word.map(|word| word + 5));
}

const VERTEX: &str =
    "in vec4 p;\nout vec4 a;\nflat out int n;\nvoid main() { gl_Position = p; a = p; n = 7; }";
const GEOMETRY: &str = "layout(triangles) in;\nlayout(line_strip, max_vertices = 4) out;\nin vec4 a[];\nflat in int n[];\nout vec4 b;\nvoid main() { b = a[1] * n[2]; gl_Position = gl_in[0].gl_Position; EmitVertex(); EndPrimitive(); }";
const FRAGMENT: &str = "in vec4 b;\nout vec4 r;\nvoid main() { r = b; }";

/// Geometry shaders of version 150 between `VERTEX` and `FRAGMENT`, and words of the log; no words:
/// they link.
const GEOMETRIES: &[(&[&str], &str)] = &[
    (&[GEOMETRY], ""),
    (
        &[
            GEOMETRY,
            "layout(triangles) in;\nlayout(max_vertices = 4) out;\nvoid f() { EmitVertex(); }",
        ],
        "",
    ),
    (&[GEOMETRY, "layout(triangles) in;\nlayout(max_vertices = 3) out;\n"], "different layouts"),
    (&[GEOMETRY, "layout(lines) in;"], "different layouts"),
    (
        &[
            "layout(line_strip, max_vertices = 4) out;\nout vec4 b;\nvoid main() { b = vec4(1.0); EmitVertex(); }",
        ],
        "no geometry shader has the layout of the inputs",
    ),
    (
        &[
            "layout(points) in;\nlayout(points) out;\nout vec4 b;\nvoid main() { b = vec4(1.0); EmitVertex(); }",
        ],
        "how many vertices it emits",
    ),
    (
        &[
            "layout(points) in;\nlayout(max_vertices = 1) out;\nout vec4 b;\nvoid main() { b = vec4(1.0); EmitVertex(); }",
        ],
        "the primitive of the outputs",
    ),
    (
        &[
            "layout(points) in;\nlayout(points, max_vertices = 1) out;\nin vec3 a[];\nout vec4 b;\nvoid main() { b = a[0].xyzz; EmitVertex(); }",
        ],
        "`a` is vec4 in the vertex shader and vec3 in the geometry shader",
    ),
    (
        &[
            "layout(points) in;\nlayout(points, max_vertices = 1) out;\nin vec4 c[];\nout vec4 b;\nvoid main() { b = c[0]; EmitVertex(); }",
        ],
        "the geometry shader reads `c`, which no vertex shader writes",
    ),
    (
        &[
            "layout(points) in;\nlayout(points, max_vertices = 1) out;\nvoid main() { EmitVertex(); }",
        ],
        "the fragment shader reads `b`, which no geometry shader writes",
    ),
    (
        &[
            "layout(points) in;\nlayout(points, max_vertices = 256) out;\nout vec4 b;\nvoid main() { b = gl_Position = vec4(1.0); EmitVertex(); }",
        ],
        "256 vertices of 8 components are 2048",
    ),
    (
        &[GEOMETRY, "in vec4 a[2];\nvec4 f() { return a[0]; }"],
        "`a` has 2 elements, and the primitives have 3 vertices",
    ),
];

fn linked_geometry(geometries: &[&str]) -> Linked {
    let rest = geometries.iter().map(|source| (Geometry, *source));
    let all = [(Vertex, VERTEX), (Fragment, FRAGMENT)].into_iter().chain(rest);
    let shaders: Vec<Shader> = all
        .map(|(stage, source)| {
            compiled(Core33, stage, &format!("#version 150\n{source}"))
                .unwrap_or_else(|log| panic!("{source}\n{log}"))
        })
        .collect();
    link(&shaders.iter().collect::<Vec<_>>(), &Bindings::default())
}

#[test]
fn programs_of_three_stages() {
    let mut wrong = String::new();
    for (geometries, words) in GEOMETRIES {
        let linked = linked_geometry(geometries);
        if linked.program.is_some() != words.is_empty() || !linked.log.contains(words) {
            let _ = writeln!(wrong, "{geometries:?}\nexpected {words:?}:\n{}", linked.log);
        }
        for module in linked.program.iter().flat_map(|program| &program.geometry) {
            module.validate().unwrap_or_else(|error| panic!("{geometries:?}: {error}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn a_geometry_shader_alone_does_not_link() {
    let source = format!("#version 150\n{GEOMETRY}");
    let shader = compiled(Core33, Geometry, &source).unwrap_or_else(|log| panic!("{log}"));
    let linked = link(&[&shader], &Bindings::default());
    assert!(linked.program.is_none() && linked.log.contains("no vertex shader"), "{}", linked.log);
}

#[test]
fn a_geometry_program_emits_what_its_shader_writes() {
    let program = linked_geometry(&[GEOMETRY]).program.expect("it links");
    let module = program.geometry.expect("there is a geometry shader");
    let outputs = module.geometry.as_ref().expect("it has an interface").outputs.clone();
    let compiled = Program::new(&module, |_| true);
    for isa in Isa::executions() {
        let prepared = compiled.prepare(isa, &[0; 64], &[]);
        let mut machine = Machine::default();
        machine.begin(&compiled);
        for (index, input) in compiled.inputs().iter().enumerate() {
            let register = machine.input_mut(index);
            for lane in 0..LANES {
                let value = match input {
                    Input::OfVertex { vertex, output: Output::Position(at) } => {
                        f32::from(*vertex) * 10.0 + f32::from(*at)
                    }
                    // `a` takes four slots; of `n`, the low half comes first.
                    Input::OfVertex { vertex, output: Output::Varying(slot) } => {
                        match slot - VARYING_USER {
                            at @ 0..4 => f32::from(*vertex) * 100.0 + f32::from(at),
                            4 => 7.0,
                            _ => 0.0,
                        }
                    }
                    other => panic!("no value for {other:?}"),
                };
                register[lane] = value.to_bits();
            }
        }
        let run = Invocation {
            isa,
            program: &compiled,
            prepared: &prepared,
            textures: &[],
            active: !0,
            budget: 1_000_000,
        };
        machine.run(run).expect("the shader ends soon");
        assert_eq!(machine.emission().count(3), 1);
        for (word, output) in outputs.iter().enumerate() {
            let value = f32::from_bits(machine.emission().values(0, word)[3]);
            let expected = match output {
                Output::Position(at) => f32::from(*at),
                Output::Varying(slot) => 7.0 * (100.0 + f32::from(slot - VARYING_USER)),
                other => panic!("{other:?} is emitted"),
            };
            assert_eq!(value, expected, "{output:?}");
        }
    }
}

#[test]
fn the_second_color_is_in_the_program() {
    let source = "#version 330\nlayout(location = 0, index = 0) out vec4 a;\nlayout(location = 0, index = 1) out vec4 b;\nvoid main() { a = b = vec4(1.0); }";
    let shader = compiled(Core33, Fragment, source).unwrap_or_else(|log| panic!("{log}"));
    let program = link(&[&shader], &Bindings::default()).program.expect("it links");
    let found = program.outputs.iter().map(|output| (&*output.name, output.color, output.index));
    assert_eq!(found.collect::<Vec<_>>(), [("a", 0, 0), ("b", 0, 1)]);
}

#[test]
fn bindings_are_in_the_program() {
    let head = "#version 330\n#extension GL_ARB_shading_language_420pack : enable\n";
    let source = |binding: u32| {
        format!(
            "{head}layout(binding = {binding}) uniform sampler2D t[2];\nlayout(std140) layout(binding = 5) uniform B {{ vec4 a; }} b[2];\nvoid main() {{ gl_Position = texture(t[0], vec2(0.5)) + texture(t[1], vec2(0.5)) + b[1].a; }}"
        )
    };
    let shader = |stage, source: &str| {
        compiled(Core33, stage, source).unwrap_or_else(|log| panic!("{source}\n{log}"))
    };
    let vertex = shader(Vertex, &source(3));
    let program = link(&[&vertex], &Bindings::default()).program.expect("it links");
    assert_eq!(program.uniforms[0].initial, [3, 4]);
    let bindings: Vec<u32> = program.blocks.iter().map(|block| block.binding).collect();
    assert_eq!(bindings, [5, 6]);
    let other = source(4).replace("gl_Position", "gl_FragColor");
    let linked = link(&[&vertex, &shader(Fragment, &other)], &Bindings::default());
    assert!(linked.log.contains("uniform `t` has the bindings 3 and 4"), "{}", linked.log);
}
