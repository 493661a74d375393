//! What shaders compute: fragment shaders run on the interpreter, checked against values worked
//! out by hand.
//!
//! Every row is the body of a `main` that sets `r`. It can use
//! `u = (1, 2, 3, 4)`, `k = 2`, `yes = true`, `list = {10, 20, 30, 40}`, `m` with the elements 1 to
//! 16 column by column, and `x = gl_FragCoord.x`, which is 3.5 in the lane that is looked at.
//! Lanes are the pixels of an 8 by 8 block, quads by planes (see `texunit::lanes`).

mod data;
mod functions;
mod language;
mod preprocessor;
mod state;

use gl_api::glsl::{Bindings, Options, Stage, compile, link};
use rasterizer::ir::{Input, Output};
use rasterizer::shader::{Machine, Program, Run};
use texunit::lanes::{Isa, LANES};

/// The lane that is looked at: the one of column 3, row 0.
const LANE: usize = 17;

/// The column of a lane in its block.
fn column(lane: usize) -> usize {
    lane % 4 * 2 + lane / 16 % 2
}

/// The version, declarations, the body, and `r` at its end.
struct Row(u32, &'static str, &'static str, [f32; 4]);

/// Every row.
fn table() -> impl Iterator<Item = &'static Row> {
    let tables =
        [data::TABLE, functions::TABLE, language::TABLE, preprocessor::TABLE, state::TABLE];
    tables.into_iter().flatten()
}

fn source(row: &Row) -> String {
    let Row(version, declarations, body, _) = row;
    format!(
        "#version {version}
{declarations}
uniform vec4 u; uniform int k; uniform bool yes; uniform float list[4]; uniform mat4 m;
void main() {{
    float x = gl_FragCoord.x;
    vec4 r = vec4(0.0);
    {body}
    gl_FragColor = r;
}}
"
    )
}

/// The fragment program of a row and its uniform words, or the log.
fn program(row: &Row) -> Result<(rasterizer::ir::Module, Vec<u32>), String> {
    let source = source(row);
    let compiled = compile(Stage::Fragment, &source, &Options::default());
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
            other => panic!("no value for {other}"),
        };
        words[uniform.word as usize..][..value.len()].copy_from_slice(&value);
    }
    let module = program.fragment.expect("a fragment stage was linked");
    Ok((module, words))
}

#[test]
fn values() {
    let mut wrong = String::new();
    for row in table() {
        let (module, words) = match program(row) {
            Ok(program) => program,
            Err(log) => {
                wrong.push_str(&log);
                continue;
            }
        };
        if let Err(error) = module.validate() {
            panic!("{}\n{error}", source(row));
        }
        let program =
            Program::new(&module, |output| matches!(output, Output::Color { target: 0, .. }));
        for isa in Isa::available() {
            let prepared = program.prepare(isa, &words, &[]);
            let mut machine = Machine::default();
            machine.begin(&program);
            for (index, input) in program.inputs().iter().enumerate() {
                let register = machine.input_mut(index);
                for lane in 0..LANES {
                    let value = match input {
                        Input::FragCoord(0) => 0.5 + column(lane) as f32,
                        other => panic!("no value for {other:?}"),
                    };
                    register[lane] = value.to_bits();
                }
            }
            let run = Run {
                isa,
                program: &program,
                prepared: &prepared,
                textures: &[],
                active: !0,
                budget: 1_000_000,
            };
            machine.run(run).expect("the shaders end soon");
            let mut found = [0.0; 4];
            for (index, output) in program.outputs().iter().enumerate() {
                if let Output::Color { target: 0, component } = output {
                    found[usize::from(*component)] = f32::from_bits(machine.output(index)[LANE]);
                }
            }
            if found != row.3 {
                wrong.push_str(&format!("{}\nexpected {:?}, found {found:?}\n", row.2, row.3));
                break;
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn the_table_is_large() {
    assert!(table().count() >= 300, "{}", table().count());
}

#[test]
fn table_is_valid_ir() {
    for row in table() {
        if let Ok((module, _)) = program(row) {
            assert_eq!(module.validate(), Ok(()), "{}", source(row));
        }
    }
}
