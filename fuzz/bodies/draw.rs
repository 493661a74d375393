//! Runs any text as a shader, for the fuzz target `draw` and the tests of hostile shaders.

use gl_api::glsl::{Bindings, Options, Stage, compile, link};
use rasterizer::ir::Module;
use rasterizer::shader::{Invocation, Machine, Program};
use texunit::lanes::Isa;

/// Compiles a text as a fragment shader, links it and runs it.
pub fn link_and_run(source: &str) {
    let Some(shader) = compile(Stage::Fragment, source, &Options::default()).shader else { return };
    if let Some(program) = link(&[&shader], &Bindings::default()).program
        && let Some(module) = &program.fragment
    {
        run(module, program.words);
    }
}

/// Runs a stage over 64 lanes, on inputs of all types. The result does not matter, only that it terminates.
fn run(module: &Module, words: u32) {
    module.validate().expect("what the linker gives is valid");
    let program = Program::new(module, |_| true);
    let isa = Isa::available()[0];
    let words: Vec<u32> = (0..words).map(|word| word.wrapping_mul(0x9e37_79b9)).collect();
    let textures = vec![None; module.textures.len()];
    let prepared = program.prepare(isa, &words, &textures);
    let mut machine = Machine::default();
    machine.begin(&program);
    for index in 0..program.inputs().len() {
        let register = machine.input_mut(index);
        for (lane, word) in register.0.iter_mut().enumerate() {
            *word = (lane as u32).wrapping_mul(0x85eb_ca6b);
        }
    }
    let invocation = Invocation {
        isa,
        program: &program,
        prepared: &prepared,
        textures: &textures,
        active: !0,
        budget: 20_000,
    };
    let _ = machine.run(invocation);
}
