//! How long each operation takes over 64 lanes, in nanoseconds, per instruction set.
//!
//! `cargo bench -p rasterizer --bench interpreter [names…]`. Each number is the time of a program
//! of a hundred such operations in a chain, by a hundred, the fastest of many runs.

use rasterizer::ir::{Builder, Input, Interpolation, Op, Output, Stage, Ty, Value};
use rasterizer::shader::{Invocation, Machine, Program};
use std::time::Instant;
use texunit::lanes::{Isa, U32s};

const CHAIN: u32 = 100;
const RUNS: usize = 60;
/// Runs that are timed together.
const TOGETHER: u32 = 20;

/// A value of a type, from a varying.
fn of_type(b: &mut Builder, ty: Ty, slot: u16) -> Value {
    let x = b.input(Input::Varying(slot));
    let one = b.float(1.0);
    match ty {
        Ty::F32 => x,
        Ty::I32 => b.op(Op::FloatToInt, &[x]),
        Ty::U32 => b.op(Op::FloatToUint, &[x]),
        Ty::Bool => b.op(Op::Less, &[x, one]),
    }
}

/// `op` of itself of itself…, and where the result has another type, of changing operands.
fn chain(op: Op) -> Program {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().varyings = vec![Interpolation::Smooth; 4];
    let mut args: Vec<Value> =
        op.args().iter().enumerate().map(|(slot, ty)| of_type(&mut b, *ty, slot as u16)).collect();
    let mut last = args[0];
    for turn in 0..CHAIN {
        last = b.op(op, &args);
        let at = turn as usize % args.len();
        if op.args()[at] == op.result() {
            args[at] = last;
        } else if let Some(at) = op.args().iter().position(|ty| *ty == op.result()) {
            args[at] = last;
        }
    }
    let value = match op.result() {
        Ty::F32 => last,
        Ty::I32 => b.op(Op::IntToFloat, &[last]),
        Ty::U32 => b.op(Op::UintToFloat, &[last]),
        Ty::Bool => b.op(Op::BoolToFloat, &[last]),
    };
    let red = b.output(Output::Color { target: 0, component: 0 });
    b.store(red, value);
    Program::new(&b.finish(), |_| true)
}

fn nanoseconds(isa: Isa, program: &Program) -> f64 {
    let prepared = program.prepare(isa, &[], &[]);
    let mut machine = Machine::default();
    machine.begin(program);
    for index in 0..program.inputs().len() {
        let input = machine.input_mut(index);
        *input = U32s::from_fn(|lane| (lane as f32 * 0.37 + index as f32 + 0.5).to_bits());
    }
    let run = Invocation {
        isa,
        program,
        prepared: &prepared,
        textures: &[],
        active: !0,
        budget: u64::MAX,
    };
    let times = (0..RUNS).map(|_| {
        let start = Instant::now();
        for _ in 0..TOGETHER {
            machine.run(run).expect("the budget is endless");
        }
        start.elapsed()
    });
    let fastest = times.min().unwrap_or_default();
    fastest.as_secs_f64() * 1e9 / f64::from(TOGETHER)
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|arg| !arg.starts_with('-')).collect();
    let isas = Isa::executions();
    print!("{:<16}", "operation");
    isas.iter().for_each(|isa| print!("{:>10}", isa.name()));
    println!();
    for &op in Op::ALL {
        if !words.is_empty() && !words.iter().any(|word| op.name().contains(word)) {
            continue;
        }
        // Its chain folds away, or what it gives is of no use to it.
        let folds = matches!(op, Op::Not | Op::BitNot | Op::Neg | Op::INeg);
        let repeats = op.args().contains(&op.result()) && !folds;
        if repeats {
            let program = chain(op);
            print!("{:<16}", op.name());
            for &isa in &isas {
                print!("{:>10.1}", nanoseconds(isa, &program) / f64::from(CHAIN));
            }
            println!();
        }
    }
}
