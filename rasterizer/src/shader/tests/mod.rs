//! Whole programs: against a scalar reference, on every instruction set, optimized or not.

mod cases;
mod facts;
mod random;
mod reference;
mod repeated_lookups;
mod uniform_loops;

use super::{Fusing, Invocation, LevelOfDetail, Machine, OptimizedModule, OverBudget, Program};
use crate::ir::{Input, Module};
use reference::Outcome;
use texunit::lanes::{Isa, LANES, U32s};

/// What the machine makes of a module: by lane, its outputs, or nothing where it was discarded.
fn run(
    isa: Isa,
    program: &Program,
    uniforms: &[u32],
    active: u64,
    budget: u64,
    input: impl Fn(Input, usize) -> u32,
) -> Result<Vec<Option<Vec<u32>>>, OverBudget> {
    let prepared = program.prepare(isa, uniforms, &[]);
    let mut machine = Machine::default();
    machine.begin(program);
    for (index, wanted) in program.inputs().iter().enumerate() {
        *machine.input_mut(index) = U32s::from_fn(|lane| input(*wanted, lane));
    }
    let kept = machine.run(Invocation {
        isa,
        program,
        prepared: &prepared,
        textures: &[],
        active,
        budget,
    })?;
    Ok((0..LANES)
        .map(|lane| {
            (kept >> lane & 1 != 0).then(|| {
                (0..program.outputs().len())
                    .map(|index| any_nan(machine.output(index)[lane]))
                    .chain(emitted(program, &machine, lane))
                    .collect()
            })
        })
        .collect())
}

/// What a lane emitted: of each vertex whether it begins a strip, and its scalars.
fn emitted(program: &Program, machine: &Machine, lane: usize) -> Vec<u32> {
    let Some(interface) = program.geometry() else { return Vec::new() };
    let emission = machine.emission();
    let mut words = Vec::new();
    for vertex in 0..emission.count(lane) {
        words.push(emission.begins_strip(lane, vertex).into());
        words.extend(
            (0..interface.outputs.len()).map(|at| any_nan(emission.values(vertex, at)[lane])),
        );
    }
    words
}

/// One word for all NaN: which one an operation gives is left open by IEEE and by Rust, and no
/// operation of the IR tells them apart.
fn any_nan(word: u32) -> u32 {
    if f32::from_bits(word).is_nan() { f32::NAN.to_bits() } else { word }
}

/// Holds optimized and unoptimized programs on every instruction set to the reference.
pub(super) fn check(module: &Module, uniforms: &[u32], input: impl Fn(Input, usize) -> u32 + Copy) {
    module.validate().unwrap_or_else(|error| panic!("{error}\n{module}"));
    let active = 0xffff_0f0f_ffff_fff1;
    let want: Vec<Outcome> = (0..LANES)
        .map(|lane| reference::run(module, uniforms, 20_000, |wanted| input(wanted, lane)))
        .collect();
    if want.iter().any(|outcome| matches!(outcome, Outcome::Endless)) {
        return;
    }
    let mut programs = vec![
        Program::lowered(module, Fusing::Off),
        Program::lowered(module, Fusing::On),
        Program::new(module, |_| true),
    ];
    programs.extend(specialized(module, uniforms));
    for program in programs {
        for isa in Isa::executions() {
            let got = run(isa, &program, uniforms, active, 10_000_000, input).unwrap();
            for lane in (0..LANES).filter(|lane| active >> lane & 1 != 0) {
                let want = match &want[lane] {
                    Outcome::Done(outputs) => Some(outputs),
                    Outcome::Discarded | Outcome::Endless => None,
                };
                assert_eq!(got[lane].as_ref(), want, "{} lane {lane}\n{module}", isa.name());
            }
            if program.register_files() > 1 {
                for (file, got) in run_files(isa, &program, uniforms, input).iter().enumerate() {
                    for (lane, got) in got.iter().enumerate() {
                        let want = &want[(lane + file) % LANES];
                        let Outcome::Done(want) = want else { panic!("{want:?}\n{module}") };
                        assert_eq!(got, want, "{} file {file} lane {lane}\n{module}", isa.name());
                    }
                }
            }
        }
    }
}

/// The program of a module for draws with these uniform words, if they leave anything out.
pub(super) fn specialized(module: &Module, uniforms: &[u32]) -> Option<Program> {
    let mut optimized = OptimizedModule::new(module, |_| true);
    optimized.finish(LevelOfDetail::Polygons);
    let (program, finished) = optimized.lower();
    let sources = program.fact_sources(&finished);
    let facts = program.facts(&sources, Some(&program.prepare(Isa::BASELINE, uniforms, &[])), &[]);
    program.specialized(&finished, &sources, &facts)
}

/// What each register file makes of a module: by lane, its outputs. The inputs of a register file's lane are those of
/// the lane as many further on as there are files before it.
fn run_files(
    isa: Isa,
    program: &Program,
    uniforms: &[u32],
    input: impl Fn(Input, usize) -> u32,
) -> Vec<Vec<Vec<u32>>> {
    let prepared = &program.prepare(isa, uniforms, &[]);
    let mut machine = Machine::default();
    machine.begin(program);
    for file in 0..program.register_files() {
        for (index, wanted) in program.inputs().iter().enumerate() {
            let lanes = U32s::from_fn(|lane| input(*wanted, (lane + file) % LANES));
            machine.inputs_of(file)[index] = lanes;
        }
    }
    let invocation =
        Invocation { isa, program, prepared, textures: &[], active: !0, budget: 10_000_000 };
    machine.run_files(invocation, program.register_files()).expect("the budget is large");
    let of = |file, lane: usize| {
        let outputs = 0..program.outputs().len();
        outputs.map(|index| any_nan(machine.output_of(file, index)[lane])).collect()
    };
    (0..program.register_files())
        .map(|file| (0..LANES).map(|lane| of(file, lane)).collect())
        .collect()
}
