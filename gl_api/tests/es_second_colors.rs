//! Second colours in OpenGL ES (EXT_blend_func_extended): in both versions of GLSL ES, by layout and by binding.

use gl_api::*;

const HEAD_100: &str =
    "#extension GL_EXT_blend_func_extended : require\nprecision mediump float;\n";
const HEAD_300: &str = "#version 300 es
#extension GL_EXT_blend_func_extended : require
precision mediump float;
";

fn context() -> Context {
    let version = Version::new(3, 0);
    Context::new(ContextDesc {
        api: Api::Es2,
        version,
        width: 4,
        height: 4,
        ..ContextDesc::default()
    })
    .expect("a device")
}

fn compiled(c: &mut Context, stage: GLenum, source: &str) -> (GLuint, String) {
    let shader = c.create_shader(stage);
    c.shader_source(shader, 1, Strings(vec![source]), &[]);
    c.compile_shader(shader);
    let mut log = String::new();
    c.get_shader_info_log(shader, 4096, &mut [], TextOut::String(&mut log));
    (shader, log)
}

/// A program of a fragment shader, in use, linked after `bind`.
fn program(c: &mut Context, fragment: &str, bind: impl Fn(&mut Context, GLuint)) -> GLuint {
    let vertex = match fragment.starts_with("#version 300") {
        true => "#version 300 es\nin vec4 at; void main() { gl_Position = at; }",
        false => "attribute vec4 at; void main() { gl_Position = at; }",
    };
    let program = c.create_program();
    for (stage, source) in [(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, fragment)] {
        let (shader, log) = compiled(c, stage, source);
        assert_eq!(log, "");
        c.attach_shader(program, shader);
    }
    c.bind_attrib_location(program, 0, "at");
    bind(c, program);
    c.link_program(program);
    c.use_program(program);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    program
}

/// Draws over (1, 0.6, 0.2, 1), which is multiplied by the second colour; gives the pixel.
fn blended(c: &mut Context) -> [u8; 4] {
    let corners: Vec<u8> =
        [-1.0f32, -1.0, 3.0, -1.0, -1.0, 3.0].iter().flat_map(|v| v.to_le_bytes()).collect();
    c.enable_vertex_attrib_array(0);
    c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 0, Data::Bytes(&corners));
    c.clear_color(1.0, 0.6, 0.2, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.enable(GL_BLEND);
    c.blend_func(GL_ONE, GL_SRC1_COLOR);
    c.draw_arrays(GL_TRIANGLES, 0, 3);
    let mut pixel = [0; 4];
    c.read_pixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    pixel
}

/// 0.2 + 1 · 0.4, 0 + 0.6 · 1, 0 + 0.2 · 0.
const BLENDED: [u8; 4] = [153, 153, 0, 255];

#[test]
fn both_languages_blend_with_second_colours() {
    let colors = ["vec4(0.2, 0.0, 0.0, 0.5)", "vec4(0.4, 1.0, 0.0, 0.5)"];
    let of_100 = |names: [&str; 2]| {
        let [first, second] = colors;
        format!("{HEAD_100}void main() {{ {} = {first}; {} = {second}; }}", names[0], names[1])
    };
    let none = |_: &mut Context, _: GLuint| {};
    for names in [
        ["gl_FragColor", "gl_SecondaryFragColorEXT"],
        ["gl_FragData[0]", "gl_SecondaryFragDataEXT[gl_MaxDualSourceDrawBuffersEXT - 1]"],
    ] {
        let mut c = context();
        program(&mut c, &of_100(names), none);
        assert_eq!(blended(&mut c), BLENDED, "{names:?}");
    }
    let body = |layouts: [&str; 2]| {
        let [a, b] = layouts;
        let [first, second] = colors;
        format!(
            "{HEAD_300}{a} out vec4 a; {b} out vec4 b; void main() {{ a = {first}; b = {second}; }}"
        )
    };
    let mut c = context();
    let located = body(["layout(location = 0)", "layout(location = 0, index = 1)"]);
    program(&mut c, &located, none);
    assert_eq!(blended(&mut c), BLENDED);
    let mut c = context();
    let bound = program(&mut c, &body(["", ""]), |c, program| {
        c.bind_frag_data_location_indexed(program, 0, 1, "b");
        c.bind_frag_data_location(program, 0, "a");
    });
    assert_eq!(blended(&mut c), BLENDED);
    assert_eq!([c.get_frag_data_index(bound, "a"), c.get_frag_data_index(bound, "b")], [0, 1]);
    assert_eq!(c.get_frag_data_index(bound, "c"), -1);
    let mut most = [0];
    c.get_integerv(GL_MAX_DUAL_SOURCE_DRAW_BUFFERS, &mut most);
    assert_eq!((most, c.get_error()), ([1], GL_NO_ERROR));
}

#[test]
fn names_belong_to_their_version_and_need_the_extension() {
    let es_300 = |body: &str| format!("{HEAD_300}{body}");
    let plain = "#version 300 es\nprecision mediump float;\n";
    for (source, words) in [
        (
            "void main() { gl_SecondaryFragColorEXT = vec4(1.0); }".to_owned(),
            "GL_EXT_blend_func_extended",
        ),
        (
            es_300("void main() { gl_SecondaryFragColorEXT = vec4(1.0); }"),
            "gl_SecondaryFragColorEXT",
        ),
        (format!("{plain}layout(location = 0, index = 1) out vec4 c; void main() {{}}"), "index"),
        (format!("{plain}out vec4 a, b; void main() {{}}"), "no location"),
        (es_300("layout(location = 0, index = 2) out vec4 c; void main() {}"), "0 or 1"),
        (
            format!(
                "{HEAD_100}void main() {{ gl_FragColor = vec4(0.0); gl_SecondaryFragDataEXT[0] = vec4(0.0); }}"
            ),
            "both written",
        ),
    ] {
        let mut c = context();
        let (shader, log) = compiled(&mut c, GL_FRAGMENT_SHADER, &source);
        let mut status = [9];
        c.get_shaderiv(shader, GL_COMPILE_STATUS, &mut status);
        assert_eq!(status[0], 0, "{source}");
        assert!(log.contains(words), "{log}");
    }
}
