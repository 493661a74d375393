//! Programs through GL: what a link gives, keeps and resets, what can be asked of it, and what the
//! calls refuse.

mod attributes;
mod pipelines;
mod uniforms;

use gl_api::*;

fn context() -> Context {
    Context::new(ContextDesc { width: 1, height: 1, ..ContextDesc::default() }).expect("a device")
}

fn shader(c: &mut Context, stage: GLenum, source: &str) -> GLuint {
    let shader = c.create_shader(stage);
    c.shader_source(shader, 1, Strings(vec![source]), &[]);
    c.compile_shader(shader);
    shader
}

/// A program with these vertex and fragment shaders, not linked yet.
fn made(c: &mut Context, vertex: &[&str], fragment: &[&str]) -> GLuint {
    let program = c.create_program();
    for (stage, sources) in [(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, fragment)] {
        for source in sources {
            let shader = shader(c, stage, source);
            c.attach_shader(program, shader);
        }
    }
    program
}

fn asked(c: &mut Context, program: GLuint, pname: GLenum) -> GLint {
    let mut value = [0];
    c.get_programiv(program, pname, &mut value);
    value[0]
}

fn log(c: &mut Context, program: GLuint) -> String {
    let mut text = String::new();
    c.get_program_info_log(program, 4096, &mut [], TextOut::String(&mut text));
    text
}

/// Links it and says whether that worked.
fn links(c: &mut Context, program: GLuint) -> bool {
    c.link_program(program);
    asked(c, program, GL_LINK_STATUS) != 0
}

fn linked(c: &mut Context, vertex: &[&str], fragment: &[&str]) -> GLuint {
    let program = made(c, vertex, fragment);
    assert!(links(c, program), "{}", log(c, program));
    program
}

/// Name, size and type of each active uniform.
fn uniforms(c: &mut Context, program: GLuint) -> Vec<(String, GLint, GLenum)> {
    let count = asked(c, program, GL_ACTIVE_UNIFORMS) as GLuint;
    let one = |index| {
        let (mut name, mut size, mut ty) = (String::new(), [0], [0]);
        let out = TextOut::String(&mut name);
        c.get_active_uniform(program, index, 256, &mut [], &mut size, &mut ty, out);
        (name, size[0], ty[0])
    };
    (0..count).map(one).collect()
}

fn attributes(c: &mut Context, program: GLuint) -> Vec<(String, GLenum)> {
    let count = asked(c, program, GL_ACTIVE_ATTRIBUTES) as GLuint;
    let one = |index| {
        let (mut name, mut ty) = (String::new(), [0]);
        let out = TextOut::String(&mut name);
        c.get_active_attrib(program, index, 256, &mut [], &mut [0], &mut ty, out);
        (name, ty[0])
    };
    (0..count).map(one).collect()
}

/// A program in use with uniforms of each kind.
fn everything(c: &mut Context) -> GLuint {
    let vertex = "attribute vec4 a; void main() { gl_Position = a; }";
    let fragment = "#version 130
uniform float f; uniform int i; uniform uint u; uniform bool b; uniform vec3 v; uniform mat3 m;
uniform sampler2D s; uniform float fa[3]; uniform ivec2 iv; uniform mat2x3 n;
out vec4 color;
void main() {
    float all = f + float(i) + float(u) + float(b) + fa[0] + fa[2] + float(iv.x) + n[0].x;
    color = vec4(m * v, all) + texture(s, v.xy);
}";
    let program = made(c, &[vertex], &[fragment]);
    c.link_program(program);
    assert_eq!(log(c, program), "");
    c.use_program(program);
    program
}

/// The pixel after a triangle over it.
fn drawn(c: &mut Context) -> [u8; 4] {
    c.begin(GL_TRIANGLES);
    for [x, y] in [[-4.0, -4.0], [4.0, -4.0], [0.0, 4.0]] {
        c.vertex_2f(x, y);
    }
    c.end();
    let mut pixel = [0; 4];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    no_error(c);
    pixel
}

fn no_error(c: &mut Context) {
    let messages: Vec<String> = c.messages().iter().map(ToString::to_string).collect();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{messages:?}");
}

const PASS: &str = "void main() { gl_Position = gl_Vertex; gl_FrontColor = gl_Color; }";
const TINT: &str = "uniform vec4 tint; void main() { gl_FragColor = tint; }";

#[test]
fn one_stage_stands_beside_the_fixed_function() {
    let mut c = context();
    c.color_3f(0.0, 1.0, 0.0);
    let vertex = linked(&mut c, &[PASS], &[]);
    c.use_program(vertex);
    assert_eq!(drawn(&mut c), [0, 255, 0, 255]);
    let fragment = linked(&mut c, &[], &["void main() { gl_FragColor = gl_Color.yxzw; }"]);
    c.use_program(fragment);
    assert_eq!(drawn(&mut c), [255, 0, 0, 255]);
}

#[test]
fn several_shaders_make_a_stage() {
    let mut c = context();
    let half = "vec4 f(); void main() { gl_FragColor = f(); }";
    let program = linked(&mut c, &[PASS], &[half, "vec4 f() { return vec4(1, 0, 1, 1); }"]);
    c.use_program(program);
    assert_eq!(drawn(&mut c), [255, 0, 255, 255]);
}

#[test]
fn a_failed_link_leaves_what_is_in_use_until_another_is_used() {
    let mut c = context();
    let program = linked(&mut c, &[PASS], &[TINT]);
    c.use_program(program);
    let tint = c.get_uniform_location(program, "tint");
    c.uniform_4f(tint, 1.0, 0.0, 0.0, 1.0);
    let broken = shader(&mut c, GL_FRAGMENT_SHADER, "void main() { gl_FragColor = vec4(0.0); }");
    c.attach_shader(program, broken);
    assert!(!links(&mut c, program));
    assert!(log(&mut c, program).contains("main"));
    assert_eq!(asked(&mut c, program, GL_ACTIVE_UNIFORMS), 0);
    assert_eq!(drawn(&mut c), [255, 0, 0, 255]);
    c.uniform_4f(tint, 0.0, 0.0, 1.0, 1.0);
    assert_eq!(drawn(&mut c), [0, 0, 255, 255], "its uniforms are part of the state too");
    c.use_program(program);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION, "it is not linked");
    c.use_program(0);
    c.detach_shader(program, broken);
    assert!(links(&mut c, program), "{}", log(&mut c, program));
    c.use_program(program);
    assert_eq!(drawn(&mut c), [0; 4], "a link resets uniforms");
}

/// ARB_ES2_compatibility: floats of IEEE 754 and integers of 32 bits, whatever precision is asked for.
#[test]
fn every_precision_is_the_highest() {
    let mut c = context();
    c.release_shader_compiler();
    for stage in [GL_VERTEX_SHADER, GL_FRAGMENT_SHADER] {
        for (numbers, expected, bits) in [
            ([GL_LOW_FLOAT, GL_MEDIUM_FLOAT, GL_HIGH_FLOAT], [127, 127], 23),
            ([GL_LOW_INT, GL_MEDIUM_INT, GL_HIGH_INT], [31, 30], 0),
        ] {
            for precision in numbers {
                let (mut range, mut found) = ([0; 2], [9]);
                c.get_shader_precision_format(stage, precision, &mut range, &mut found);
                assert_eq!((range, found), (expected, [bits]), "{}", enum_name(precision));
            }
        }
    }
    let mut none = [7];
    c.get_integerv(GL_SHADER_BINARY_FORMATS, &mut none[..0]);
    assert_eq!(none, [7]);
    no_error(&mut c);
}

#[test]
fn attributes_go_where_they_are_bound() {
    let mut c = context();
    let two = "attribute vec4 a; attribute mat3 m; attribute float f;
        void main() { gl_Position = a + vec4(m * vec3(f), 1.0); }";
    let program = made(&mut c, &[two], &[]);
    c.bind_attrib_location(program, 1, "m");
    c.bind_attrib_location(program, 9, "unknown");
    assert!(links(&mut c, program));
    let of = |c: &mut Context, name| c.get_attrib_location(program, name);
    assert_eq!(["a", "m", "f"].map(|name| of(&mut c, name)), [0, 1, 4]);
    c.bind_attrib_location(program, 7, "a");
    assert_eq!(of(&mut c, "a"), 0, "until the next link");
    c.bind_attrib_location(program, 7, "f");
    assert!(links(&mut c, program), "aliases are allowed: {}", log(&mut c, program));
    assert_eq!((of(&mut c, "a"), of(&mut c, "f")), (7, 7));
    c.bind_attrib_location(program, 14, "m");
    assert!(!links(&mut c, program), "a matrix takes three");
    assert!(log(&mut c, program).contains("does not fit"));
    let both = "attribute vec4 a; void main() { gl_Position = a + gl_Vertex; }";
    let program = made(&mut c, &[both], &[]);
    c.bind_attrib_location(program, 0, "a");
    assert!(!links(&mut c, program));
    assert!(log(&mut c, program).contains("gl_Vertex"));
    no_error(&mut c);
}

#[test]
fn fragment_outputs_go_where_they_are_bound() {
    let mut c = context();
    let source = "#version 130
out vec4 first; out vec4 second; void main() { first = vec4(0.0); second = vec4(1.0); }";
    let program = made(&mut c, &[PASS], &[source]);
    c.bind_frag_data_location(program, 0, "second");
    assert!(links(&mut c, program), "{}", log(&mut c, program));
    let of = |c: &mut Context, name| c.get_frag_data_location(program, name);
    assert_eq!(["first", "second", "third"].map(|name| of(&mut c, name)), [1, 0, -1]);
    c.use_program(program);
    assert_eq!(drawn(&mut c), [255; 4]);
    c.bind_frag_data_location(program, 0, "first");
    assert!(!links(&mut c, program), "two outputs for one colour");
    assert!(log(&mut c, program).contains("bound to colour 0"));
}

#[test]
fn limits_are_said_by_the_linker() {
    let mut c = context();
    let fragment = "void main() { gl_FragColor = v[0] + v[40]; }";
    let varyings = format!("varying vec4 v[41]; {fragment}");
    let writes = "varying vec4 v[41]; void main() { gl_Position = v[0] = v[40] = vec4(1.0); }";
    let arrays: String = (0..17).map(|i| format!("uniform vec4 u{i}[16384];\n")).collect();
    let named: String = (0..17).map(|i| format!("+ u{i}[0]")).collect();
    let uniforms = format!("{arrays} void main() {{ gl_Position = vec4(0.0) {named}; }}");
    let attributes: String = (0..17).map(|i| format!("attribute float a{i};\n")).collect();
    let sum: String = (0..17).map(|i| format!("+ a{i}")).collect();
    let many = format!("{attributes} void main() {{ gl_Position = vec4(0.0 {sum}); }}");
    let rows: [(&[&str], &[&str], &str); 3] = [
        (&[writes], &[&varyings], "pass between the stages"),
        (&[&uniforms], &[], "components"),
        (&[&many], &[], "finds no location"),
    ];
    for (vertex, fragment, words) in rows {
        let program = made(&mut c, vertex, fragment);
        assert!(!links(&mut c, program), "{words}");
        assert!(log(&mut c, program).contains(words), "{words}: {}", log(&mut c, program));
    }
}

#[test]
fn validation_sees_what_a_draw_would_refuse() {
    let mut c = context();
    let source = "uniform sampler2D flat_; uniform samplerCube cube; void main() {
        gl_FragColor = texture2D(flat_, vec2(0.0)) + textureCube(cube, vec3(1.0)); }";
    let program = made(&mut c, &[PASS], &[source]);
    c.validate_program(program);
    assert_eq!(asked(&mut c, program, GL_VALIDATE_STATUS), 0);
    assert!(log(&mut c, program).contains("is not linked"));
    assert!(links(&mut c, program));
    c.validate_program(program);
    assert_eq!(asked(&mut c, program, GL_VALIDATE_STATUS), 0, "both samplers are 0");
    let text = log(&mut c, program);
    assert!(text.contains("\"cube\"") && text.contains("glUniform1i"), "{text}");
    c.use_program(program);
    no_error(&mut c);
    c.begin(GL_POINTS);
    c.vertex_2f(0.0, 0.0);
    c.end();
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    let cube = c.get_uniform_location(program, "cube");
    c.uniform_1i(cube, 1);
    c.validate_program(program);
    assert_eq!(asked(&mut c, program, GL_VALIDATE_STATUS), 1);
    assert_eq!(log(&mut c, program), "");
}

#[test]
fn what_is_deleted_stays_while_it_is_needed() {
    let mut c = context();
    let program = linked(&mut c, &[PASS], &[TINT]);
    let mut shaders = [0; 3];
    let mut count = [0];
    c.get_attached_shaders(program, 3, &mut count, &mut shaders);
    assert_eq!(count, [2]);
    c.get_attached_shaders(program, 1, &mut count, &mut [0; 3]);
    assert_eq!(count, [1]);
    let vertex = shaders[0];
    c.delete_shader(vertex);
    assert!(c.is_shader(vertex), "a program holds it");
    let mut doomed = [0];
    c.get_shaderiv(vertex, GL_DELETE_STATUS, &mut doomed);
    assert_eq!(doomed, [1]);
    c.use_program(program);
    c.delete_program(program);
    assert!(c.is_program(program), "it is in use");
    assert_eq!(asked(&mut c, program, GL_DELETE_STATUS), 1);
    assert_eq!(drawn(&mut c), [0; 4]);
    c.use_program(0);
    assert!(!c.is_program(program) && !c.is_shader(vertex));
    assert!(c.is_shader(shaders[1]), "that one was not deleted");
    c.delete_program(0);
    c.delete_shader(0);
    assert!(!c.is_program(0) && !c.is_shader(0) && !c.is_shader(program));
    no_error(&mut c);
}

#[test]
fn sources_are_joined_and_read_back() {
    let mut c = context();
    let shader = c.create_shader(GL_FRAGMENT_SHADER);
    c.shader_source(shader, 3, Strings(vec!["void main", "() {xx", "}"]), &[-1, 4]);
    let (mut text, mut length) = (String::new(), [0]);
    c.get_shader_source(shader, 99, &mut length, TextOut::String(&mut text));
    assert_eq!((text.as_str(), length), ("void main() {}", [14]));
    let mut bytes = [1; 8];
    c.get_shader_source(shader, 5, &mut length, TextOut::Bytes(&mut bytes));
    assert_eq!((bytes, length), ([b'v', b'o', b'i', b'd', 0, 1, 1, 1], [4]));
    let mut known = [0];
    c.get_shaderiv(shader, GL_SHADER_SOURCE_LENGTH, &mut known);
    assert_eq!(known, [15]);
    no_error(&mut c);
}

#[test]
fn a_program_without_shaders_leaves_everything_to_the_fixed_function() {
    let mut c = context();
    let empty = linked(&mut c, &[], &[]);
    c.use_program(empty);
    c.color_4f(1.0, 0.0, 1.0, 1.0);
    assert_eq!(drawn(&mut c), [255, 0, 255, 255]);
    no_error(&mut c);
}

#[test]
fn a_shader_that_did_not_compile_does_not_link() {
    let mut c = context();
    let program = made(&mut c, &["void main() { nothing }"], &[]);
    c.link_program(program);
    assert!(log(&mut c, program).contains("is not compiled"));
    shader(&mut c, GL_VERTEX_SHADER, "");
    no_error(&mut c);
}
