//! How long an operation over 64 lanes takes: a shader of value noise, per instruction set.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use rasterizer::ir::{Builder, Input, Interpolation, Op, Output, Stage, Value};
use rasterizer::shader::{Machine, Program, Run};
use std::hint::black_box;
use texunit::lanes::{Isa, U32s};

/// `fract(x · (x + 33.33) · x)`, a hash of a lattice point.
fn hash(b: &mut Builder, x: Value, y: Value) -> Value {
    let (c, d, e) = (b.float(0.1031), b.float(33.33), b.float(0.71));
    let x = b.op(Op::Mul, &[x, c]);
    let y = b.op(Op::Mul, &[y, e]);
    let sum = b.op(Op::Add, &[x, y]);
    let f = b.op(Op::Fract, &[sum]);
    let g = b.op(Op::Add, &[f, d]);
    let h = b.op(Op::Mul, &[f, g]);
    b.op(Op::Fract, &[h])
}

fn mix(b: &mut Builder, from: Value, to: Value, t: Value) -> Value {
    let difference = b.op(Op::Sub, &[to, from]);
    let part = b.op(Op::Mul, &[difference, t]);
    b.op(Op::Add, &[from, part])
}

/// The cubic `t² (3 - 2t)`.
fn smooth(b: &mut Builder, t: Value) -> Value {
    let (two, three) = (b.float(2.0), b.float(3.0));
    let twice = b.op(Op::Mul, &[two, t]);
    let rest = b.op(Op::Sub, &[three, twice]);
    let square = b.op(Op::Mul, &[t, t]);
    b.op(Op::Mul, &[square, rest])
}

/// Six octaves of value noise, and how many operations they are.
fn noise() -> (Program, u64) {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().varyings = vec![Interpolation::Smooth; 2];
    let red = b.output(Output::Color { target: 0, component: 0 });
    let (mut x, mut y) = (b.input(Input::Varying(0)), b.input(Input::Varying(1)));
    let mut sum = b.float(0.0);
    let (one, lacunarity) = (b.float(1.0), b.float(2.03));
    for octave in 0..6 {
        let (fx, fy) = (b.op(Op::Floor, &[x]), b.op(Op::Floor, &[y]));
        let (tx, ty) = (b.op(Op::Sub, &[x, fx]), b.op(Op::Sub, &[y, fy]));
        let (tx, ty) = (smooth(&mut b, tx), smooth(&mut b, ty));
        let (gx, gy) = (b.op(Op::Add, &[fx, one]), b.op(Op::Add, &[fy, one]));
        let corners = [(fx, fy), (gx, fy), (fx, gy), (gx, gy)];
        let corners = corners.map(|(x, y)| hash(&mut b, x, y));
        let low = mix(&mut b, corners[0], corners[1], tx);
        let high = mix(&mut b, corners[2], corners[3], tx);
        let value = mix(&mut b, low, high, ty);
        let weight = b.float(0.5f32.powi(octave));
        let value = b.op(Op::Mul, &[value, weight]);
        sum = b.op(Op::Add, &[sum, value]);
        x = b.op(Op::Mul, &[x, lacunarity]);
        y = b.op(Op::Mul, &[y, lacunarity]);
    }
    b.store(red, sum);
    let module = b.finish();
    let program = Program::new(&module, |_| true);
    (program, module.body.len() as u64)
}

/// 300 additions in a chain.
fn additions() -> (Program, u64) {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().varyings = vec![Interpolation::Smooth; 2];
    let red = b.output(Output::Color { target: 0, component: 0 });
    let (x, mut sum) = (b.input(Input::Varying(0)), b.input(Input::Varying(1)));
    for _ in 0..300 {
        sum = b.op(Op::Add, &[sum, x]);
    }
    b.store(red, sum);
    (Program::new(&b.finish(), |_| true), 300)
}

fn interpreter(criterion: &mut Criterion) {
    for (name, (program, operations)) in [("noise", noise()), ("add", additions())] {
        println!("{name}: {operations} operations; {}", program.describe());
        let mut group = criterion.benchmark_group(name);
        group.throughput(Throughput::Elements(operations));
        for isa in Isa::available() {
            let prepared = program.prepare(isa, &[], &[]);
            let mut machine = Machine::default();
            machine.begin(&program);
            group.bench_function(isa.name(), |bench| {
                bench.iter(|| {
                    for index in 0..program.inputs().len() {
                        *machine.input_mut(index) =
                            U32s::from_fn(|lane| (lane as f32 * 0.37).to_bits());
                    }
                    let run = Run {
                        isa,
                        program: &program,
                        prepared: &prepared,
                        textures: &[],
                        active: !0,
                        budget: u64::MAX,
                    };
                    black_box(machine.run(run)).map(|_| machine.output(0)[0])
                });
            });
        }
    }
}

criterion_group!(benches, interpreter);
criterion_main!(benches);
