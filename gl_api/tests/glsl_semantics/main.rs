//! Results of shaders: they run on the interpreter, and are compared with values computed by hand.
//!
//! Every row is the body of a `main` that sets `r`. It runs in the fragment stage and, unless it uses
//! something that only this stage has, in the vertex stage. It can use
//! `u = (1, 2, 3, 4)`, `k = 2`, `yes = true`, `list = {10, 20, 30, 40}`, `m` with the elements 1 to
//! 16 column by column, and `x = gl_FragCoord.x`, which is 3.5 in the lane that is checked.
//! Lanes are the pixels of an 8 by 8 block, quads by planes (see `texunit::lanes`).

mod arrays;
mod corners;
mod data;
mod extremes;
mod functions;
mod language;
mod names;
mod preprocessor;
mod state;
mod versions;

use gl_api::glsl::{Bindings, ContextLanguage, Options, Stage, compile, link};
use rasterizer::ir::{Input, Output};
use rasterizer::shader::{Invocation, Machine, Program};
use texunit::lanes::{Isa, LANES};

/// The lane that is checked: column 3, row 0.
const LANE: usize = 17;

/// The column of a lane in its block.
fn column(lane: usize) -> usize {
    lane % 4 * 2 + lane / 16 % 2
}

/// The version, declarations, the body, and the expected `r`.
struct Row(u32, &'static str, &'static str, [f32; 4]);

/// Every row.
fn table() -> impl Iterator<Item = &'static Row> {
    let tables = [
        arrays::TABLE,
        corners::TABLE,
        data::TABLE,
        functions::TABLE,
        language::TABLE,
        names::TABLE,
        preprocessor::TABLE,
        state::TABLE,
        versions::TABLE,
    ];
    tables.into_iter().flatten()
}

/// Names that only the fragment stage has.
const OF_FRAGMENTS: [&str; 4] = ["gl_Frag", "discard", "dFd", "fwidth"];

/// The stages that a row runs in.
fn stages(row: &Row) -> &'static [Stage] {
    let lacks = |word: &&str| row.1.contains(*word) || row.2.contains(*word);
    match OF_FRAGMENTS.iter().any(lacks) {
        true => &[Stage::Fragment],
        false => &[Stage::Fragment, Stage::Vertex],
    }
}

fn source(row: &Row, stage: Stage) -> String {
    let Row(version, declarations, body, _) = row;
    let (input, x, result) = match stage {
        Stage::Vertex => ("attribute float place;", "place", "gl_Position"),
        Stage::Geometry | Stage::Fragment => ("", "gl_FragCoord.x", "gl_FragColor"),
    };
    format!(
        "#version {version}
{declarations}
uniform vec4 u; uniform int k; uniform bool yes; uniform float list[4]; uniform mat4 m;
{input}
void main() {{
    float x = {x};
    vec4 r = vec4(0.0);
    {body}
    {result} = r;
}}
"
    )
}

/// The program of a row and its uniform words, or the log.
fn program(row: &Row, stage: Stage) -> Result<(rasterizer::ir::Module, Vec<u32>), String> {
    let source = source(row, stage);
    let options = Options { context: ContextLanguage::Compatibility33, ..Options::default() };
    let compiled = compile(stage, &source, &options);
    let shader = compiled.shader.ok_or_else(|| format!("{source}\n{}", compiled.log))?;
    let linked = link(&[&shader], &Bindings::default());
    let program = linked.program.ok_or_else(|| format!("{source}\n{}", linked.log))?;
    let mut words = vec![0; program.words as usize];
    for uniform in &program.uniforms {
        let value: Vec<u32> = match uniform.name.as_str() {
            "u" => [1.0f32, 2.0, 3.0, 4.0].map(f32::to_bits).into(),
            "k" => vec![2],
            "yes" => vec![rasterizer::ir::TRUE],
            "list" => [10.0f32, 20.0, 30.0, 40.0].map(f32::to_bits).into(),
            "m" => (1..=16u8).map(|i| f32::from(i).to_bits()).collect(),
            _ => uniform.initial.clone(),
        };
        words[uniform.word as usize..][..value.len()].copy_from_slice(&value);
    }
    let module = match stage {
        Stage::Vertex => program.vertex,
        Stage::Geometry | Stage::Fragment => program.fragment,
    };
    Ok((module.expect("the stage was linked"), words))
}

/// The component of `r` that an output is.
fn component(output: Output) -> Option<usize> {
    match output {
        Output::Color { target: 0, component } | Output::Position(component) => {
            Some(component.into())
        }
        _ => None,
    }
}

/// The result of a row in the lane that is checked.
fn run(isa: Isa, program: &Program, words: &[u32]) -> [f32; 4] {
    let prepared = program.prepare(isa, words, &[]);
    let mut machine = Machine::default();
    machine.begin(program);
    for (index, input) in program.inputs().iter().enumerate() {
        let register = machine.input_mut(index);
        for lane in 0..LANES {
            let value = match input {
                Input::FragCoord(0) | Input::Attribute { component: 0, .. } => {
                    0.5 + column(lane) as f32
                }
                other => panic!("no value for {other:?}"),
            };
            register[lane] = value.to_bits();
        }
    }
    let run = Invocation {
        isa,
        program,
        prepared: &prepared,
        textures: &[],
        active: !0,
        budget: 1_000_000,
    };
    machine.run(run).expect("the shaders end soon");
    let mut found = [0.0; 4];
    for (index, output) in program.outputs().enumerate() {
        if let Some(component) = component(output) {
            found[component] = f32::from_bits(machine.output(index)[LANE]);
        }
    }
    found
}

#[test]
fn values() {
    let mut wrong = String::new();
    for row in table() {
        for &stage in stages(row) {
            let (module, words) = match program(row, stage) {
                Ok(program) => program,
                Err(log) => {
                    wrong.push_str(&log);
                    continue;
                }
            };
            if let Err(error) = module.validate() {
                panic!("{}\n{error}", source(row, stage));
            }
            let program = Program::new(&module, |output| component(output).is_some());
            for isa in Isa::executions() {
                let found = run(isa, &program, &words);
                if found != row.3 {
                    let (body, expected) = (row.2, row.3);
                    wrong.push_str(&format!(
                        "{stage:?}: {body}\nexpected {expected:?}, found {found:?}\n"
                    ));
                    break;
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn the_table_is_large() {
    assert!(table().count() >= 300, "{}", table().count());
}
