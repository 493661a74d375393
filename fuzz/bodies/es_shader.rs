//! Shaders of GLSL ES from a grammar, for the fuzz target `es_shader` and the tests of hostile shaders of OpenGL ES. Their
//! expressions have types that fit, so that most compile and run; some bytes choose a piece that does not fit.

use super::random::Random;
use gl_api::*;

/// A type of the grammar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Type {
    Float,
    Int,
    Bool,
    Vector(usize),
    Matrix,
}

/// The version of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Version {
    Es100,
    Es300,
}

/// A fragment shader that is being written.
struct Writer<'r, 'b> {
    random: &'r mut Random<'b>,
    version: Version,
    /// How many loops and blocks are open.
    depth: usize,
    /// Variables that were declared, and those that are in scope, by number.
    declared: usize,
    variables: Vec<(Type, usize)>,
}

/// A fragment shader.
pub fn shader(random: &mut Random<'_>) -> String {
    let version = random.pick(&[Version::Es100, Version::Es300, Version::Es300]);
    let mut writer = Writer { random, version, depth: 0, declared: 0, variables: Vec::new() };
    let head = match version {
        Version::Es100 => "precision mediump float;\nvarying vec4 v;\n#define color gl_FragColor\n",
        Version::Es300 => {
            "#version 300 es\nprecision highp float;\nin vec4 v;\nlayout(location = 0) out vec4 color;\n"
        }
    };
    let mut text = format!(
        "{head}uniform vec4 u;\nuniform int n;\nuniform mat3 m;\nuniform sampler2D image;\n\
         const float half_ = 0.5;\nstruct S {{ float x; vec3 y; }};\n\
         float f(float a, vec3 b) {{ return a + dot(b, b) * half_; }}\n\
         vec3 g(in vec3 a, inout float b) {{ b += a.x; S s = S(b, a); return s.y * s.x; }}\n\
         void main() {{\n"
    );
    for _ in 0..2 + writer.below(6) {
        text += &writer.statement();
    }
    text + &format!("color = {};\n}}\n", writer.expression(Type::Vector(4), 3))
}

impl Writer<'_, '_> {
    fn below(&mut self, end: usize) -> usize {
        (self.random.next() % end as u64) as usize
    }

    fn name(ty: Type) -> String {
        match ty {
            Type::Float => "float".to_owned(),
            Type::Int => "int".to_owned(),
            Type::Bool => "bool".to_owned(),
            Type::Vector(size) => format!("vec{size}"),
            Type::Matrix => "mat3".to_owned(),
        }
    }

    fn any(&mut self) -> Type {
        match self.below(8) {
            0 | 1 => Type::Float,
            2 => Type::Int,
            3 => Type::Bool,
            4..=6 => Type::Vector(2 + self.below(3)),
            _ => Type::Matrix,
        }
    }

    fn statement(&mut self) -> String {
        // What no rule of the grammar gives.
        const STRANGE: [&str; 6] = [
            "f(1.0);\n",
            "v = u;\n",
            "float q = 1;\n",
            "discard;\n",
            "{;}\n",
            "precision lowp int;\n",
        ];
        match self.below(if self.depth > 3 { 5 } else { 9 }) {
            0..=2 => {
                let ty = self.any();
                let value = self.expression(ty, 3);
                let number = self.declared;
                self.declared += 1;
                self.variables.push((ty, number));
                format!("{} x{number} = {value};\n", Self::name(ty))
            }
            3 => match self.variable() {
                Some((ty, number)) => {
                    let value = self.expression(ty, 3);
                    format!("x{number} = {value};\n")
                }
                None => String::new(),
            },
            4 => {
                let strange = self.random.pick(&STRANGE);
                if self.below(12) == 0 { strange.to_owned() } else { String::new() }
            }
            5 | 6 => {
                let condition = self.expression(Type::Bool, 2);
                let (then, other) = (self.block(""), self.block(""));
                format!("if ({condition}) {then} else {other}\n")
            }
            7 => {
                let (number, bound) = (self.depth, self.random.pick(&["3", "7", "100000", "n"]));
                // Loops of 1.00 have constant bounds in the appendix; DetGL takes others, too.
                let end = self.random.pick(&["", "if (v.x > 0.5) break;", "continue;"]);
                let body = self.block(end);
                format!("for (int i{number} = 0; i{number} < {bound}; i{number}++) {body}\n")
            }
            _ if self.version == Version::Es100 => self.block(""),
            _ => {
                let value = self.expression(Type::Int, 2);
                let (one, other) = (self.block(""), self.block(""));
                let end = self.random.pick(&["break;", ""]);
                format!("switch ({value}) {{ case 0: {one} {end} default: {other} }}\n")
            }
        }
    }

    /// Statements in braces; what they declare is out of scope behind them.
    fn block(&mut self, end: &str) -> String {
        let scope = self.variables.len();
        self.depth += 1;
        let body: String = (0..1 + self.below(2)).map(|_| self.statement()).collect();
        self.depth -= 1;
        self.variables.truncate(scope);
        format!("{{\n{body}{end}}}")
    }

    fn variable(&mut self) -> Option<(Type, usize)> {
        if self.variables.is_empty() {
            return None;
        }
        let chosen = self.below(self.variables.len());
        Some(self.variables[chosen])
    }

    fn expression(&mut self, ty: Type, depth: usize) -> String {
        if let Some((found, number)) = self.variable()
            && found == ty
            && self.below(2) == 0
        {
            return format!("x{number}");
        }
        if depth == 0 {
            return self.leaf(ty);
        }
        let choice = self.below(8);
        let mut of = |ty: Type| self.expression(ty, depth - 1);
        match (ty, choice) {
            (Type::Bool, 0..=3) => format!("({} < {})", of(Type::Float), of(Type::Float)),
            (Type::Bool, 4) => format!("({} && !{})", of(Type::Bool), of(Type::Bool)),
            (Type::Bool, _) => format!("({} == {})", of(Type::Int), of(Type::Int)),
            (Type::Int, 0..=2) => format!("({} + {})", of(Type::Int), of(Type::Int)),
            (Type::Int, 3) => format!("({} / (n + {}))", of(Type::Int), of(Type::Int)),
            (Type::Int, 4) => format!("int({})", of(Type::Float)),
            (Type::Int, _) => {
                format!("({} ? {} : {})", of(Type::Bool), of(Type::Int), of(Type::Int))
            }
            (Type::Float, 0) => format!("f({}, {})", of(Type::Float), of(Type::Vector(3))),
            (Type::Float, 1) => format!("dot({}, {})", of(Type::Vector(4)), of(Type::Vector(4))),
            (Type::Float, 2) => format!("pow({}, {})", of(Type::Float), of(Type::Float)),
            (Type::Float, 3) => format!("{}.y", of(Type::Vector(2))),
            (Type::Float, 4) => format!("{}[n + {}]", of(Type::Vector(3)), of(Type::Int)),
            (Type::Float, 5) => format!("float({})", of(Type::Int)),
            (Type::Vector(4), 0) => format!("texture_({})", of(Type::Vector(2))).replace(
                "texture_(",
                match self.version {
                    Version::Es100 => "texture2D(image, ",
                    Version::Es300 => "texture(image, ",
                },
            ),
            (Type::Vector(4), 1) => format!("vec4({}, {})", of(Type::Vector(3)), of(Type::Float)),
            (Type::Vector(3), 0) => format!("({} * {})", of(Type::Matrix), of(Type::Vector(3))),
            (Type::Vector(3), 1) => format!("{}[n + {}]", of(Type::Matrix), of(Type::Int)),
            (Type::Vector(2), 0) => format!("{}.wx", of(Type::Vector(4))),
            (Type::Vector(_), 2) => format!("normalize({})", of(ty)),
            (Type::Vector(size), 3) => format!("vec{size}({})", of(Type::Float)),
            (Type::Vector(_), 4) => format!("mix({}, {}, {})", of(ty), of(ty), of(Type::Float)),
            (Type::Matrix, 0..=3) => format!("({} * {})", of(ty), of(ty)),
            (Type::Matrix, 4) => format!("mat3({})", of(Type::Float)),
            (Type::Float | Type::Vector(_) | Type::Matrix, _) => {
                let (a, b) = (of(ty), of(ty));
                let operator = self.random.pick(&["+", "-", "/", "*"]);
                format!("({a} {operator} {b})")
            }
        }
    }

    fn leaf(&mut self, ty: Type) -> String {
        match ty {
            Type::Float => {
                self.random.pick(&["u.x", "v.y", "0.0", "1e38", "-1.5", "gl_FragCoord.x", "half_"])
            }
            Type::Int => self.random.pick(&["n", "0", "-1", "2147483647", "3"]),
            Type::Bool => self.random.pick(&["true", "false", "(n > 1)", "gl_FrontFacing"]),
            Type::Vector(2) => self.random.pick(&["u.xy", "v.zw", "gl_PointCoord", "vec2(0.0)"]),
            Type::Vector(3) => self.random.pick(&["u.xyz", "v.www", "vec3(1.0, 2.0, 3.0)"]),
            Type::Vector(_) => self.random.pick(&["u", "v", "vec4(1.0)", "gl_FragCoord"]),
            Type::Matrix => self.random.pick(&["m", "mat3(2.0)"]),
        }
        .to_owned()
    }
}

/// What became of a shader.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    Refused,
    Drawn,
}

/// Gives the uniforms of the grammar values that differ, and `image` texels that do.
fn set_uniforms(c: &mut Context, program: GLuint) {
    let [u, n, m] = ["u", "n", "m"].map(|name| c.get_uniform_location(program, name));
    c.uniform_4fv(u, 1, &[0.25, -1.5, 2.5, 0.75]);
    c.uniform_1i(n, 4);
    c.uniform_matrix_3fv(m, 1, false, &[0.5, 0.25, -1.0, 2.0, 0.75, 0.0, -0.5, 1.0, 1.5]);
    const SIDE: GLsizei = 4;
    let texels: Vec<u8> = (0..SIDE * SIDE * 4).map(|at| (at * 73 % 251) as u8).collect();
    let (rgba, data) = (GL_RGBA as GLint, Data::Bytes(&texels));
    c.tex_image_2d(GL_TEXTURE_2D, 0, rgba, SIDE, SIDE, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
    c.generate_mipmap(GL_TEXTURE_2D);
}

/// Compiles a fragment shader in a context of OpenGL ES, links and draws with it; it is refused with a log, or the draw ends.
pub fn draw(c: &mut Context, fragment: &str) -> Fate {
    let vertex = if fragment.starts_with("#version 300 es") {
        "#version 300 es\nin vec4 at; out vec4 v; void main() { v = at; gl_Position = at; }"
    } else {
        "attribute vec4 at; varying vec4 v; void main() { v = at; gl_Position = at; }"
    };
    let program = c.create_program();
    for (stage, source) in [(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, fragment)] {
        let shader = c.create_shader(stage);
        c.shader_source(shader, 1, Strings(vec![source]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
        c.delete_shader(shader);
    }
    c.bind_attrib_location(program, 0, "at");
    c.link_program(program);
    let mut linked = [0];
    c.get_programiv(program, GL_LINK_STATUS, &mut linked);
    if linked[0] == 0 {
        let mut log = String::new();
        c.get_program_info_log(program, 1 << 16, &mut [], TextOut::String(&mut log));
        assert!(!log.is_empty(), "a program is refused without a reason:\n{fragment}");
        c.delete_program(program);
        return Fate::Refused;
    }
    c.use_program(program);
    set_uniforms(c, program);
    let corners = [-1.0_f32, -1.0, 0.0, 1.0, 3.0, -1.0, 0.5, 1.0, -1.0, 3.0, 0.0, 1.0];
    c.enable_vertex_attrib_array(0);
    c.vertex_attrib_pointer(0, 4, GL_FLOAT, false, 0, corners[..].arg());
    c.draw_arrays(GL_TRIANGLES, 0, 3);
    c.finish();
    c.use_program(0);
    c.delete_program(program);
    Fate::Drawn
}
