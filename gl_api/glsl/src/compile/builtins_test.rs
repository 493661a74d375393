//! Every row of the table of built-ins, compiled and linked: a shader has it in the versions and
//! with the extensions that the row names, and in no other.

use crate::builtins::function::{self, FunctionRow, Lowering};
use crate::builtins::texture_lookup::{Lookup, TexelOffset};
use crate::builtins::variable::{self, Access, Builtin, BuiltinVariable};
use crate::language::{Availability, Behaviour, Extension, Language, Stages, Version, stage_name};
use crate::types::{Scalar, Type};
use crate::{Bindings, ContextLanguage, Options, Stage, compile, link};
use std::collections::BTreeSet;

/// A version with extensions, and the first lines of a shader in it.
struct Dialect {
    language: Language,
    header: String,
}

impl Dialect {
    /// A version with these extensions and no other: rectangles, which are there unasked, are
    /// disabled.
    fn new(version: Version, extensions: &[Extension]) -> Self {
        let mut language = Language::from(version);
        let es = if version == Version::Es300 { " es" } else { "" };
        let mut header = format!("#version {}{es}\n", version.number());
        let rectangles = Extension::TextureRectangle;
        if rectangles.is_in(version) && !extensions.contains(&rectangles) {
            language.set(rectangles, Behaviour::Disable);
            header += &format!("#extension {} : disable\n", rectangles.name());
        }
        for extension in extensions.iter().filter(|extension| extension.is_in(version)) {
            language.set(*extension, Behaviour::Enable);
            header += &format!("#extension {} : enable\n", extension.name());
        }
        if version.is_es() {
            let samplers = Type::names(language).filter(|name| name.contains("sampler"));
            for name in samplers.chain(["float"]) {
                header += &format!("precision mediump {name};\n");
            }
        }
        Self { language, header }
    }

    /// Whether it has a type.
    fn has_type(&self, ty: &Type) -> bool {
        Type::named(&ty.to_string(), self.language).is_some()
    }
}

/// The dialects in which a row with these types may be there or not: each version without
/// extensions, and with each of the extensions that add it.
fn dialects(availability: Availability, types: &[&Type]) -> Vec<Dialect> {
    let of_types = types.iter().filter_map(|ty| Type::availability(&ty.to_string()));
    let of_types: Vec<Extension> = of_types.flat_map(Availability::extensions).collect();
    let mut sets = vec![Vec::new(), of_types.clone()];
    sets.extend(availability.extensions().map(|extension| {
        let mut set = of_types.clone();
        set.push(extension);
        set
    }));
    let all = Version::ALL.into_iter();
    all.flat_map(|version| sets.iter().map(move |set| Dialect::new(version, set))).collect()
}

/// What compiling and linking one shader gives.
enum Outcome {
    Refused,
    /// With the log of the compiler.
    Linked(String),
}

fn outcome(stage: Stage, source: &str) -> Outcome {
    let options = Options { context: ContextLanguage::Compatibility33, ..Options::default() };
    let compiled = compile(stage, source, &options);
    let Some(shader) = compiled.shader else { return Outcome::Refused };
    let linked = link(&[&shader], &Bindings::default());
    assert!(linked.program.is_some(), "{source}\n{}", linked.log);
    Outcome::Linked(compiled.log)
}

/// A shader whose `main` runs `body`.
fn shader(dialect: &Dialect, stage: Stage, globals: &str, body: &str) -> String {
    let position = match stage {
        Stage::Vertex => "gl_Position = vec4(0.0);",
        Stage::Geometry | Stage::Fragment => "",
    };
    format!("{}{globals}void main() {{ {position} {body} }}\n", dialect.header)
}

fn stages(stages: Stages) -> Vec<Stage> {
    [Stage::Vertex, Stage::Fragment].into_iter().filter(|stage| stages.has(*stage)).collect()
}

/// A call of a function, its arguments unknown to the compiler but for offsets.
fn call(row: &FunctionRow, parameters: &[Type], result: &Type) -> (String, String) {
    let (mut globals, mut locals, mut arguments) = (String::new(), String::new(), Vec::new());
    for (number, ty) in parameters.iter().enumerate() {
        let last = number + 1 == parameters.len();
        let integer = ty.scalar() == Some(Scalar::Int);
        let is_offset = integer
            && match row.lowering {
                Lowering::Texture(Lookup::Sample(..)) => true,
                Lowering::Texture(
                    Lookup::Gather(TexelOffset::Constant) | Lookup::Fetch(TexelOffset::Constant),
                ) => last,
                _ => false,
            };
        if is_offset {
            arguments.push(format!("{ty}(0)"));
        } else if row.writes() && last {
            locals += &format!("{ty} whole;");
            arguments.push("whole".to_owned());
        } else {
            globals += &format!("uniform {ty} a{number};\n");
            arguments.push(format!("a{number}"));
        }
    }
    (globals, format!("{locals} {result} r = {}({});", row.name, arguments.join(", ")))
}

/// Whether a function is there only as a warning says: `abs` and the like of integers.
fn is_lenient(log: &str) -> bool {
    log.contains("of integers is not in GLSL")
}

/// Whether a row of these parameters is there: those of one function can differ in stages and versions.
fn is_in_some_row(row: &FunctionRow, stage: Stage, language: Language) -> bool {
    let alike = function::named(&row.name).filter(|other| other.parameters == row.parameters);
    let mut there = alike.filter(|other| language.has(other.availability));
    there.any(|other| other.stages.has(stage))
}

#[test]
fn functions_are_where_the_table_says() {
    for row in function::all() {
        for (parameters, result) in row.signatures() {
            let types: Vec<&Type> = parameters.iter().chain([&result]).collect();
            let (globals, body) = call(row, &parameters, &result);
            let mut linked = BTreeSet::new();
            for dialect in dialects(row.availability, &types) {
                if !types.iter().all(|ty| dialect.has_type(ty)) {
                    continue;
                }
                for stage in stages(row.stages) {
                    let source = shader(&dialect, stage, &globals, &body);
                    let expected = is_in_some_row(row, stage, dialect.language);
                    match outcome(stage, &source) {
                        Outcome::Linked(log) if !is_lenient(&log) => {
                            assert!(expected, "accepted:\n{source}");
                            linked.insert(stage_name(stage));
                        }
                        Outcome::Linked(_) | Outcome::Refused => {
                            assert!(!expected, "refused:\n{source}");
                        }
                    }
                }
                for stage in [Stage::Vertex, Stage::Fragment] {
                    if !row.stages.has(stage) && !is_in_some_row(row, stage, dialect.language) {
                        let source = shader(&dialect, stage, &globals, &body);
                        let refused = matches!(outcome(stage, &source), Outcome::Refused);
                        assert!(refused, "accepted:\n{source}");
                    }
                }
            }
            assert_eq!(
                linked.len(),
                stages(row.stages).len(),
                "no version has {} {body}",
                row.name
            );
        }
    }
}

/// A scalar, vector or matrix of a variable, and its type.
fn leaf(known: &BuiltinVariable) -> (String, Type) {
    let (mut name, mut ty) = (known.row.name.to_owned(), known.ty.clone());
    loop {
        match ty {
            Type::Array(element, _) => {
                name += "[0]";
                ty = *element;
            }
            Type::Struct(of) => {
                let (field, member) = &of.fields[0];
                name += &format!(".{field}");
                ty = member.clone();
            }
            Type::Vector(..) | Type::Matrix(..) | Type::Void | Type::Sampler(_) | Type::Error => {
                return (name, ty);
            }
        }
    }
}

#[test]
fn variables_are_where_the_table_says() {
    for known in variable::all() {
        let row = known.row;
        let (name, ty) = leaf(known);
        let is_constant = matches!(row.builtin, Builtin::Limit(_));
        let read = if is_constant {
            format!("const {ty} r = {name};")
        } else {
            format!("{ty} r = {name};")
        };
        for stage in stages(row.stages) {
            let mut linked = 0;
            for dialect in dialects(row.availability, &[&ty]) {
                let expected = dialect.language.has(row.availability);
                let source = shader(&dialect, stage, "", &read);
                match outcome(stage, &source) {
                    Outcome::Linked(_) => {
                        assert!(expected, "accepted:\n{source}");
                        linked += 1;
                    }
                    Outcome::Refused => assert!(!expected, "refused:\n{source}"),
                }
                let write = format!("{name} = {ty}(0);");
                let source = shader(&dialect, stage, "", &write);
                let is_written = matches!(outcome(stage, &source), Outcome::Linked(_));
                let is_writable = expected && row.access == Access::ReadWrite;
                assert_eq!(is_written, is_writable, "{source}");
            }
            assert!(linked > 0, "no version has {}", row.name);
        }
    }
}
