//! Links: several shaders per stage, and bindings that the application sets before the link.

use gl_api::glsl::{
    Bindings, ContextLanguage, FragmentColor, Linked, Options, Program, Shader, Stage, compile,
    link,
};
use gl_api::interface::VARYING_USER;
use rasterizer::ir::Output;

const VERTEX: &str = "void main() { gl_Position = gl_Vertex; }";
const FRAGMENT: &str = "void main() { gl_FragColor = vec4(1.0); }";

fn shader(stage: Stage, source: &str) -> Shader {
    let compiled = compile(stage, source, &Options::default());
    compiled.shader.unwrap_or_else(|| panic!("{source}\n{}", compiled.log))
}

fn linked(vertex: &[&str], fragment: &[&str], bindings: &Bindings) -> Linked {
    let vertex = vertex.iter().map(|source| shader(Stage::Vertex, source));
    let shaders: Vec<Shader> =
        vertex.chain(fragment.iter().map(|source| shader(Stage::Fragment, source))).collect();
    link(&shaders.iter().collect::<Vec<_>>(), bindings)
}

fn program(vertex: &[&str], fragment: &[&str], bindings: &Bindings) -> Program {
    let linked = linked(vertex, fragment, bindings);
    linked.program.unwrap_or_else(|| panic!("{}", linked.log))
}

/// Whether a link fails with this in its log.
fn fails(vertex: &[&str], fragment: &[&str], because: &str) {
    let linked = linked(vertex, fragment, &Bindings::default());
    assert!(linked.program.is_none(), "{fragment:?} links");
    assert!(linked.log.contains(because), "{because}: {}", linked.log);
}

#[test]
fn several_shaders_make_a_stage() {
    let library =
        "uniform float scale; float count; float f(float a) { count += 1.0; return a * scale; }";
    let main = "uniform float scale; float count; float f(float a);
        void main() { gl_FragColor = vec4(f(1.0), f(2.0), count, scale); }";
    for fragment in [[library, main], [main, library]] {
        let program = program(&[VERTEX], &fragment, &Bindings::default());
        assert_eq!(program.uniforms.len(), 1);
    }
}

#[test]
fn one_stage_is_enough_and_so_is_none() {
    let nothing = program(&[], &[], &Bindings::default());
    assert!(nothing.vertex.is_none() && nothing.fragment.is_none());
    assert!(program(&[], &[FRAGMENT], &Bindings::default()).vertex.is_none());
    assert!(program(&[VERTEX], &[], &Bindings::default()).fragment.is_none());
}

#[test]
fn an_initializer_may_call_a_function_of_another_shader() {
    let main = "#version 120\nfloat f(); float g = f(); void main() { gl_FragColor = vec4(g); }";
    let library = "#version 120\nuniform float u; float f() { return u; }";
    let program = program(&[VERTEX], &[main, library], &Bindings::default());
    assert_eq!(program.uniforms.len(), 1);
    let again = "#version 120\nfloat f(); float g = f();";
    fails(&[VERTEX], &[main, library, again], "`g` has two initial values");
}

/// GLSL 1.40 no longer asks for it; transform feedback may be all that a vertex stage is for.
#[test]
fn a_position_is_needed_before_1_40() {
    fails(&["#version 130\nvoid main() {}"], &[], "never writes gl_Position");
    program(&["#version 140\nvoid main() {}"], &[], &Bindings::default());
}

#[test]
fn what_shaders_of_a_stage_may_not_do() {
    let calls = "void f(); void main() { f(); }";
    fails(&[VERTEX], &["void f() {}", "void f() {}", calls], "defined in two");
    fails(
        &[VERTEX],
        &["void g(); void f() { g(); }", "void f(); void g() { f(); }", calls],
        "itself",
    );
    fails(
        &[VERTEX],
        &["uniform float u;", "uniform vec2 u; void main() { gl_FragColor.xy = u; }"],
        "`u`",
    );
    fails(&[VERTEX], &[FRAGMENT, FRAGMENT], "`main()` is defined in two");
    fails(&[VERTEX], &[calls], "never defined");
    let located = |at| {
        format!(
            "#version 120\n#extension GL_ARB_explicit_attrib_location: enable\n\
             layout(location = {at}) in vec4 a;"
        )
    };
    let main = located(2) + "void main() { gl_Position = a; }";
    fails(&[&main, &located(3)], &[FRAGMENT], "location 2 in one vertex shader and 3 in another");
}

#[test]
fn a_uniform_is_one_in_both_stages() {
    let vertex = "#version 120\nuniform float u = 2.0; void main() { gl_Position = vec4(u); }";
    let fragment = "#version 120\nuniform float u; void main() { gl_FragColor = vec4(u); }";
    let program = program(&[vertex], &[fragment], &Bindings::default());
    assert_eq!(program.uniforms.len(), 1);
    assert_eq!(program.uniforms[0].initial, [2.0f32.to_bits()]);
    let other = fragment.replace("uniform float u", "uniform float u = 3.0");
    fails(&[vertex], &[&other], "two initial values");
}

#[test]
fn structures_and_arrays_of_uniforms_are_listed_member_by_member() {
    let fragment = "struct S { vec2 a; float b[2]; }; uniform S s[2]; uniform mat2 m[3];
        void main() { gl_FragColor = vec4(s[1].a, s[0].b[1], m[2][0].x); }";
    let program = program(&[VERTEX], &[fragment], &Bindings::default());
    let names: Vec<(&str, Option<u32>, u32)> =
        program.uniforms.iter().map(|u| (&*u.name, u.array, u.location)).collect();
    let expected = [
        ("s[0].a", None, 0),
        ("s[0].b", Some(2), 1),
        ("s[1].a", None, 3),
        ("s[1].b", Some(2), 4),
        ("m", Some(3), 6),
    ];
    assert_eq!(names, expected);
}

/// GL 4.3, section 7.3.1: an entry for each element of an array of arrays, up to the last that is
/// used, as of an array of structures.
#[test]
fn arrays_of_arrays_of_uniforms_are_listed_by_their_outer_elements() {
    let fragment = "#version 120\n#extension GL_ARB_arrays_of_arrays : enable
        struct S { vec2 a; float[2] b[3]; }; uniform S s[1][2]; uniform float[4] t[3];
        uniform sampler2D images[2][2]; uniform vec4 u[2][1][3]; uniform int i;
        void main() { gl_FragColor = vec4(s[0][1].a, s[0][i].b[2][1], t[1][2]) + u[i][0][0]
            + texture2D(images[1][0], vec2(0.5)); }";
    let program = program(&[VERTEX], &[fragment], &Bindings::default());
    let names: Vec<(&str, Option<u32>, u32, u32)> =
        program.uniforms.iter().map(|u| (&*u.name, u.array, u.location, u.word)).collect();
    let expected = [
        ("s[0][0].a", None, 0, 0),
        ("s[0][0].b[0]", Some(2), 1, 2),
        ("s[0][0].b[1]", Some(2), 3, 4),
        ("s[0][0].b[2]", Some(2), 5, 6),
        ("s[0][1].a", None, 7, 8),
        ("s[0][1].b[0]", Some(2), 8, 10),
        ("s[0][1].b[1]", Some(2), 10, 12),
        ("s[0][1].b[2]", Some(2), 12, 14),
        ("t[0]", Some(4), 14, 16),
        ("t[1]", Some(4), 18, 20),
        ("images[0]", Some(2), 22, 28),
        ("images[1]", Some(2), 24, 30),
        ("u[0][0]", Some(3), 26, 32),
        ("u[1][0]", Some(3), 29, 44),
        ("i", None, 32, 56),
    ];
    assert_eq!(names, expected);
    assert_eq!(program.samplers.iter().map(|sampler| sampler.word).collect::<Vec<_>>(), [30]);
}

#[test]
fn arrays_of_arrays_pass_between_the_stages_and_to_colours() {
    let head = "#version 130\n#extension GL_ARB_arrays_of_arrays : enable\n";
    let vertex = |declared: &str| {
        format!("{head}out {declared}; void main() {{ v[1][0] = gl_Position = gl_Vertex; }}")
    };
    let fragment = |declared: &str| {
        format!(
            "{head}in {declared}; out vec2 first; out vec4[2] c[3];
            void main() {{ c[2][1] = c[0][0] = v[1][0]; first = vec2(1); }}"
        )
    };
    let (outer, inner) = ("vec4 v[3][2]", "vec4[2] v[3]");
    for (written, read) in
        [(outer, inner), (inner, outer), ("vec4 v[][2]", outer), (outer, "vec4[][2] v")]
    {
        let program = program(&[&vertex(written)], &[&fragment(read)], &Bindings::default());
        assert_eq!(program.varyings, [(VARYING_USER, 24, "v".to_owned())], "{written}, {read}");
        let found = program.outputs.iter().map(|output| (&*output.name, output.color));
        assert_eq!(found.collect::<Vec<_>>(), [("first", 0), ("c", 1)]);
        let outputs = program.fragment.expect("a fragment stage was linked").outputs;
        let last = Output::Color { target: 6, component: 3 };
        assert!(outputs.iter().any(|(output, _)| *output == last), "{outputs:?}");
    }
    fails(&[&vertex(outer)], &[&fragment("vec4[3] v[2]")], "`v` is vec4[3][2] in the vertex");
    fails(&[&vertex(outer)], &[&fragment("vec4 v[2][2][2]").replace("v[1][0]", "v[1][0][0]")], "v");
    let two = "float[2][2] f(); void main() { gl_FragColor = vec4(f()[1][0]); }";
    let body = "float[2][2] f() { return float[][](float[](1., 2.), float[](3., 4.)); }";
    let shaders = [two, body].map(|source| format!("{head}{source}"));
    program(&[VERTEX], &[&shaders[0], &shaders[1]], &Bindings::default());
}

/// GL 2.1, section 2.15.3: the size of an array is the highest index used, plus one.
#[test]
fn arrays_of_uniforms_end_with_their_last_element_that_is_used() {
    let vertex =
        "uniform float a[9]; uniform vec4 b[9], c[9]; float whole(float v[9]) { return v[8]; }
        uniform float d[9]; uniform int i;
        void main() { gl_Position = b[3] + vec4(a[1], a[0], c[i].x, whole(d)); }";
    let fragment = "struct S { vec2 x; float y; }; uniform S s[5]; uniform float a[9];
        void main() { gl_FragColor = vec4(s[1].x, a[4], gl_LightSource[2].spotCutoff); }";
    let program = program(&[vertex], &[fragment], &Bindings::default());
    let size = |name: &str| program.uniforms.iter().find(|u| u.name == name).map(|u| u.array);
    for (name, expected) in [
        ("a", Some(Some(5))),
        ("b", Some(Some(4))),
        ("c", Some(Some(9))),
        ("d", Some(Some(9))),
        ("s[0].y", Some(None)),
        ("s[1].x", Some(None)),
        ("s[2].x", None),
    ] {
        assert_eq!(size(name), expected, "{name}");
    }
    let lights = program.builtin_uniforms.iter().filter(|u| u.name.ends_with(".spotCutoff"));
    assert_eq!(lights.count(), 3);
}

#[test]
fn attributes_go_where_they_are_bound_and_the_others_around_them() {
    let vertex = "attribute vec4 a; attribute mat3 b; attribute float c;
        void main() { gl_Position = a + vec4(b[0], c); }";
    let mut bindings = Bindings::default();
    bindings.attributes.insert("c".to_owned(), 1);
    bindings.attributes.insert("unknown".to_owned(), 0);
    let program = program(&[vertex], &[FRAGMENT], &bindings);
    let found: Vec<(&str, u8)> =
        program.attributes.iter().map(|a| (&*a.name, a.location)).collect();
    assert_eq!(found, [("a", 0), ("b", 2), ("c", 1)]);
    bindings.attributes.insert("b".to_owned(), 14);
    assert!(linked(&[vertex], &[FRAGMENT], &bindings).program.is_none());
}

#[test]
fn fragment_outputs_go_where_they_are_bound() {
    let fragment = "#version 130\nout vec4 a; out vec2 b; void main() { a = vec4(1.0); b = a.xy; }";
    let mut bindings = Bindings::default();
    bindings.frag_data.insert("a".to_owned(), color(3, 0));
    let program = program(&[VERTEX], &[fragment], &bindings);
    let outputs = &program.fragment.expect("a fragment stage was linked").outputs;
    let has = |target, component| {
        outputs.iter().any(|(output, _)| *output == Output::Color { target, component })
    };
    assert!(has(3, 3) && has(0, 1) && !has(0, 2) && !has(1, 0));
    bindings.frag_data.insert("b".to_owned(), color(3, 0));
    assert!(linked(&[VERTEX], &[fragment], &bindings).program.is_none());
}

fn color(location: u8, index: u8) -> FragmentColor {
    FragmentColor { location, index }
}

#[test]
fn a_second_colour_is_there_of_one_draw_buffer() {
    const HEAD: &str = "#version 130\n#extension GL_ARB_explicit_attrib_location : require\n";
    let fragment = |a: &str, b: &str| {
        format!("{HEAD}{a} out vec4 a; {b} out vec3 b; void main() {{ a = vec4(1.0); b = a.xyz; }}")
    };
    let second = "layout(location = 0, index = 1)";
    let vertex = "#version 130\nvoid main() { gl_Position = vec4(0.0); }";
    let outputs = |fragment: &str, bindings: &Bindings| {
        let program = program(&[vertex], &[fragment], bindings);
        let found =
            program.outputs.iter().map(|o| (o.name.clone(), o.color, o.index)).collect::<Vec<_>>();
        let module = program.fragment.expect("a fragment stage was linked");
        let seconds =
            module.outputs.iter().filter(|(output, _)| matches!(output, Output::SecondColor(_)));
        (found, seconds.count())
    };
    let at = |name: &str, color: u8, index: u8| (name.to_owned(), color, index);
    let mut bindings = Bindings::default();
    let (found, count) = outputs(&fragment("", second), &bindings);
    assert_eq!((found, count), (vec![at("a", 0, 0), at("b", 0, 1)], 3));
    // What the shader says goes before what was bound, its index too.
    bindings.frag_data.insert("a".into(), color(0, 1));
    let (found, count) = outputs(&fragment("layout(location = 0)", second), &bindings);
    assert_eq!((found, count), (vec![at("a", 0, 0), at("b", 0, 1)], 3));
    let (found, count) = outputs(&fragment("", ""), &bindings);
    assert_eq!((found, count), (vec![at("a", 0, 1), at("b", 0, 0)], 4));
    // No two outputs of one colour, and no second colour of other buffers.
    fails(&[vertex], &[&fragment(second, second)], "two outputs are bound to colour 0 of index 1");
    let far = "layout(location = 1, index = 1)";
    fails(&[vertex], &[&fragment("", far)], "GL_MAX_DUAL_SOURCE_DRAW_BUFFERS");
    let pair =
        fragment("", second).replace("vec3 b;", "vec3 b[2];").replace("b = a.xyz", "b[1] = a.xyz");
    fails(&[vertex], &[&pair], "GL_MAX_DUAL_SOURCE_DRAW_BUFFERS");
    for wrong in ["layout(location = 0, index = 2)", "layout(index = 1)"] {
        let source = fragment("", wrong);
        assert!(compile(Stage::Fragment, &source, &Options::default()).shader.is_none(), "{wrong}");
    }
}

#[test]
fn clip_distances_and_clip_vertex_reach_the_clipper() {
    let count = |source: &str| {
        let program = program(&[source], &[FRAGMENT], &Bindings::default());
        let outputs = program.vertex.expect("a vertex stage was linked").outputs;
        outputs.iter().filter(|(output, _)| matches!(output, Output::ClipDistance(_))).count()
    };
    assert_eq!(count("void main() { gl_Position = gl_ClipVertex = gl_Vertex; }"), 8);
    let distance =
        "#version 130\nvoid main() { gl_Position = gl_Vertex; gl_ClipDistance[1] = 1.0; }";
    assert_eq!(count(distance), 2);
    assert_eq!(count(&distance.replace("void", "out float gl_ClipDistance[5]; void")), 5);
}

#[test]
fn stages_agree_on_what_they_hand_on() {
    let vertex = "#version 130\nflat out int i; smooth out vec2 v;
        void main() { i = 1; v = vec2(2.0); gl_Position = vec4(v, v); }";
    let read = |declared: &str, value: &str| {
        format!("#version 130\n{declared} out vec4 c; void main() {{ c = vec4({value}); }}")
    };
    let fine = read("flat in int i; in vec2 v;", "i, v, 1");
    program(&[vertex], &[&fine], &Bindings::default());
    fails(&[vertex], &[&read("noperspective in vec2 v;", "v, v")], "noperspective");
    fails(&[vertex], &[&read("in vec3 v;", "v, 1")], "vec3");
    fails(&[vertex], &[&read("in vec3 w;", "w, 1")], "no vertex shader writes");
    let many = "varying vec4 v[17]; void main() { gl_FragColor = v[16]; }";
    fails(&["varying vec4 v[17]; void main() { v[0] = gl_Vertex; }"], &[many], "more than 64");
}

#[test]
fn locations_that_shaders_say_go_before_those_that_were_bound() {
    let head = "#version 130\n#extension GL_ARB_explicit_attrib_location : require\n";
    let vertex = format!(
        "{head}layout(location = 3) in vec4 a; layout(location = 5) in mat2 b; in float c;
        void main() {{ gl_Position = a + vec4(b[0], b[1]) + c; }}"
    );
    let fragment = format!(
        "{head}layout(location = 2) out vec4 late; out vec4 pair[2]; out vec4 next;
        void main() {{ late = pair[0] = next = vec4(1.0); pair[1] = vec4(2.0); }}"
    );
    let mut bindings = Bindings::default();
    bindings.attributes.insert("a".into(), 9);
    bindings.frag_data.insert("late".into(), color(0, 0));
    let program = program(&[&vertex], &[&fragment], &bindings);
    let found: Vec<(&str, u8)> =
        program.attributes.iter().map(|a| (a.name.as_str(), a.location)).collect();
    assert_eq!(found, [("a", 3), ("b", 5), ("c", 0)]);
    let found: Vec<(&str, u8)> =
        program.outputs.iter().map(|output| (&*output.name, output.color)).collect();
    assert_eq!(found, [("late", 2), ("pair", 0), ("next", 3)]);
    let twice = fragment.replace("out vec4 next", "layout(location = 2) out vec4 next");
    fails(&[&vertex], &[&twice], "two outputs are bound to colour 2");
    let far = vertex.replace("= 3", "= 0x7fffffff");
    fails(&[&far], &[&fragment], "does not fit below");
}

#[test]
fn what_has_no_location_is_given_none() {
    let head = "#extension GL_ARB_explicit_attrib_location : enable\n";
    for (stage, source) in [
        (Stage::Vertex, "layout(location = 0) out vec4 a;"),
        (Stage::Fragment, "layout(location = 0) in vec4 a;"),
        (Stage::Vertex, "layout(location = 0) attribute vec4 a;"),
        (Stage::Vertex, "layout(location = 0) uniform vec4 a;"),
        (Stage::Vertex, "layout(location = 1.0) in vec4 a;"),
        (Stage::Vertex, "layout(location = 1 + 1) in vec4 a;"),
        (Stage::Fragment, "layout(index = 1) out vec4 a;"),
    ] {
        let source = format!("{head}{source}\nvoid main() {{ }}");
        let compiled = compile(stage, &source, &Options::default());
        assert!(compiled.shader.is_none(), "{source}");
        assert!(compiled.log.contains("location"), "{source}\n{}", compiled.log);
    }
}

/// An input that nothing writes is zero beside the fixed vertex stage, and a query of the level of
/// detail is of the fragment stage.
#[test]
fn a_fragment_stage_alone_may_read_what_nobody_writes() {
    let source = "varying vec4 v; void main() { gl_FragColor = v; }";
    let program = program(&[], &[source], &Bindings::default());
    assert!(program.fragment.is_some_and(|module| module.validate().is_ok()));
    let query = "#extension GL_ARB_texture_query_lod : enable
        uniform sampler2D t; void main() { gl_FragColor = textureQueryLOD(t, vec2(0.5)).xyxy; }";
    assert!(compile(Stage::Fragment, query, &Options::default()).shader.is_some());
    assert!(compile(Stage::Vertex, query, &Options::default()).shader.is_none());
}

#[test]
fn a_misspelt_varying_is_suggested() {
    let vertex =
        "varying vec2 texCoord; void main() { texCoord = vec2(0); gl_Position = gl_Vertex; }";
    let reads = |name: &str| {
        format!("varying vec2 {name}; void main() {{ gl_FragColor = vec4({name}, 0, 1); }}")
    };
    let suggested = "reads `texcoord`, which no vertex shader writes; did you mean `texCoord`?";
    fails(&[vertex], &[&reads("texcoord")], suggested);
    fails(&[vertex], &[&reads("normal")], "reads `normal`, which no vertex shader writes (GLSL");
}

/// `layout(location = n)` of uniforms (ARB_explicit_uniform_location).
const LOCATIONS: &str = "#version 130
    #extension GL_ARB_explicit_attrib_location : require
    #extension GL_ARB_explicit_uniform_location : require\n";

#[test]
fn uniforms_have_the_locations_that_they_declare() {
    let vertex = format!(
        "{LOCATIONS} struct S {{ float a[2]; vec2 b; }};
        layout(location = 3) uniform S s[2]; uniform float free[4]; uniform vec4 other;
        void main() {{ gl_Position = other + s[0].a[1] + s[1].b.x + free[3]; }}"
    );
    let fragment = format!(
        "{LOCATIONS} layout(location = 20) uniform vec4 unused; layout(location = 1) uniform vec4 c;
        uniform vec4 other; void main() {{ gl_FragColor = c + other; }}"
    );
    let program = program(&[&vertex], &[&fragment], &Bindings::default());
    let mut found: Vec<(&str, u32)> =
        program.uniforms.iter().map(|uniform| (&*uniform.name, uniform.location)).collect();
    found.sort_unstable();
    // Each element of each member has a location; uniforms without an explicit one get unused locations.
    let wanted = [
        ("c", 1),
        ("free", 9),
        ("other", 0),
        ("s[0].a", 3),
        ("s[0].b", 5),
        ("s[1].a", 6),
        ("s[1].b", 8),
    ];
    let others = |(name, _): &&(&str, u32)| *name != "other" && *name != "free";
    assert_eq!(
        found.iter().filter(others).collect::<Vec<_>>(),
        wanted.iter().filter(others).collect::<Vec<_>>()
    );
    for (name, count) in [("free", 4), ("other", 1)] {
        let (_, first) = found.iter().find(|row| row.0 == name).expect("it is active");
        let taken = [1..2, 3..9, 20..21];
        let is_free = taken.iter().all(|range| first + count <= range.start || *first >= range.end);
        assert!(is_free, "{name} at {first}");
    }
    assert!(program.is_explicit_location(20) && !program.is_explicit_location(19));
}

#[test]
fn explicit_locations_must_not_overlap() {
    let fragment = |declarations: &str| {
        format!("{LOCATIONS} {declarations} void main() {{ gl_FragColor = vec4(1.0); }}")
    };
    for (declarations, because) in [
        (
            "layout(location = 1) uniform float a[3]; layout(location = 3) uniform float b;",
            "uniforms `a` and `b` both have location 3",
        ),
        ("layout(location = 65535) uniform float a[2];", "65535 to 65536"),
    ] {
        fails(&[VERTEX], &[&fragment(declarations)], because);
    }
    let twice = |location| fragment(&format!("layout(location = {location}) uniform float a;"));
    let vertex = twice(1).replace("gl_FragColor", "gl_Position");
    fails(&[&vertex], &[&twice(2)], "uniform `a` has the locations 1 and 2");
    program(&[&vertex], &[&twice(1)], &Bindings::default());
}

#[test]
fn outputs_beyond_the_last_colour_fail_whether_used_or_not() {
    let vertex = "#version 330\nvoid main() { gl_Position = vec4(0.0); }";
    for body in ["", "a = vec4(1.0);"] {
        for (declaration, is_fine) in [
            ("layout(location = 7) out vec4 a;", true),
            ("layout(location = 8) out vec4 a;", false),
            ("layout(location = 6) out vec4 a[2];", true),
            ("layout(location = 7) out vec4 a[2];", false),
            ("layout(location = 0, index = 1) out vec4 a;", true),
            ("layout(location = 1, index = 1) out vec4 a;", false),
        ] {
            let body =
                if declaration.contains('[') { body.replace("a =", "a[1] =") } else { body.into() };
            let fragment = format!("#version 330\n{declaration}\nvoid main() {{ {body} }}");
            let options = Options { context: ContextLanguage::Core33, ..Options::default() };
            let shaders = [(Stage::Vertex, vertex), (Stage::Fragment, fragment.as_str())].map(
                |(stage, source)| {
                    let compiled = compile(stage, source, &options);
                    compiled.shader.unwrap_or_else(|| panic!("{source}\n{}", compiled.log))
                },
            );
            let linked = link(&shaders.each_ref(), &Bindings::default());
            assert_eq!(linked.program.is_some(), is_fine, "{fragment}\n{}", linked.log);
            assert_eq!(
                linked.log.contains("output `a` is bound to colour"),
                !is_fine,
                "{}",
                linked.log
            );
        }
    }
}
