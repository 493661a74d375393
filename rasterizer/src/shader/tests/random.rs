//! Random modules, for properties that hold for all.

use super::check;
use super::reference::{self, Outcome};
use crate::ir::{
    Block, Builder, Expr, GeometryInput, GeometryInterface, GeometryOutput, Input, Interpolation,
    Op, Output, Stage, Stmt, Ty, Value, Var,
};
use crate::shader::OptimizedModule;
use proptest::prelude::*;

const TYPES: [Ty; 4] = [Ty::F32, Ty::I32, Ty::U32, Ty::Bool];
/// Operations that fused instructions are made of.
const FUSED: [Op; 8] =
    [Op::Add, Op::Sub, Op::Mul, Op::Mul, Op::Fract, Op::Less, Op::SelectF, Op::Max];
const UNIFORMS: u32 = 8;

/// Draws decisions from a list of random numbers; zeros when it is used up.
struct RandomSource<'a>(std::slice::Iter<'a, u32>);

impl RandomSource<'_> {
    fn below(&mut self, count: usize) -> usize {
        self.0.next().map_or(0, |roll| *roll as usize % count)
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }
}

struct Generator<'a> {
    dice: RandomSource<'a>,
    b: Builder,
    scalars: Vec<Var>,
    arrays: Vec<Var>,
    /// The values that can be used here.
    visible: Vec<Value>,
    loops: usize,
    continuing: usize,
    scopes: usize,
    size: usize,
}

/// A valid module made from random numbers. Its loops end, as each counts its turns.
pub fn module(rolls: &[u32]) -> crate::ir::Module {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().uniform_words = UNIFORMS;
    b.module_mut().varyings = vec![Interpolation::Smooth; 4];
    let mut scalars: Vec<Var> =
        (0..3).map(|component| b.output(Output::Color { target: 0, component })).collect();
    let mut arrays = Vec::new();
    for ty in TYPES {
        scalars.extend([b.variable("s", ty), b.variable("s", ty)]);
        arrays.push(b.array("a", ty, 3));
    }
    let mut visible: Vec<Value> = (0..4).map(|slot| b.input(Input::Varying(slot))).collect();
    visible.push(b.input(Input::FrontFacing));
    for word in 0..UNIFORMS {
        visible.push(b.uniform(word, TYPES[word as usize % 4]));
    }
    for ty in TYPES {
        visible.push(b.constant(0, ty));
    }
    visible.extend([b.float(1.0), b.float(-0.0), b.int(1), b.uint(!0), b.boolean(true)]);
    let mut g = Generator {
        dice: RandomSource(rolls.iter()),
        b,
        scalars,
        arrays,
        visible,
        loops: 0,
        continuing: 0,
        scopes: 0,
        size: 0,
    };
    for _ in 0..40 {
        g.stmt();
    }
    // Give the outputs something to depend on.
    for output in 0..3 {
        let value = g.value(Ty::F32);
        let old = g.b.load(g.scalars[output]);
        let sum = g.b.op(Op::Add, &[value, old]);
        g.b.store(g.scalars[output], sum);
    }
    g.b.finish()
}

impl Generator<'_> {
    fn value(&mut self, ty: Ty) -> Value {
        let all: Vec<Value> =
            self.visible.iter().copied().filter(|v| self.b.module().ty(*v) == ty).collect();
        // Mostly recent ones, so that chains grow.
        let recent = all.len().saturating_sub(6);
        if self.dice.below(3) > 0 { self.dice.of(&all[recent..]) } else { self.dice.of(&all) }
    }

    fn var(&mut self, array: bool) -> Var {
        if array { self.dice.of(&self.arrays.clone()) } else { self.dice.of(&self.scalars.clone()) }
    }

    fn index(&mut self) -> Value {
        let ty = self.dice.of(&[Ty::I32, Ty::U32]);
        self.value(ty)
    }

    fn block(&mut self) -> Block {
        let outside = self.visible.len();
        self.b.begin();
        for _ in 0..self.dice.below(6) {
            self.stmt();
        }
        if self.dice.below(4) == 0 {
            self.jump();
        }
        self.visible.truncate(outside);
        self.b.end()
    }

    fn jump(&mut self) {
        let stmt = match self.dice.below(5) {
            0 if self.loops > 0 => Stmt::Break,
            1 if self.loops > 0 && self.continuing == 0 => Stmt::Continue,
            2 | 3 if self.scopes > 0 => Stmt::Leave,
            4 if self.dice.below(4) == 0 => Stmt::Discard,
            _ => return,
        };
        self.b.push(stmt);
    }

    fn stmt(&mut self) {
        self.size += 1;
        if self.size > 300 {
            return;
        }
        match self.dice.below(20) {
            0..=8 => {
                let op = if self.dice.below(3) == 0 {
                    self.dice.of(&FUSED)
                } else {
                    self.dice.of(Op::ALL)
                };
                let mut args: Vec<Value> = op.args().iter().map(|ty| self.value(*ty)).collect();
                // What `ModNear` becomes may count on the inverse.
                if let (Op::ModNear | Op::ModPositive, [_, b, inverse]) = (op, &mut args[..]) {
                    let one = self.b.float(1.0);
                    *inverse = self.b.op(Op::Div, &[one, *b]);
                }
                let value = self.b.op(op, &args);
                self.visible.push(value);
            }
            9..=10 => {
                let var = self.var(false);
                let value = self.b.load(var);
                self.visible.push(value);
            }
            11..=12 => {
                let var = self.var(false);
                let ty = self.b.module().variable(var).ty;
                let value = self.value(ty);
                self.b.store(var, value);
            }
            13 => {
                let (var, index) = (self.var(true), self.index());
                let value = self.b.value(Expr::LoadAt { var, index });
                self.visible.push(value);
            }
            14 => {
                let (var, index) = (self.var(true), self.index());
                let ty = self.b.module().variable(var).ty;
                let value = self.value(ty);
                self.b.push(Stmt::StoreAt { var, index, value });
            }
            15 => {
                let (index, ty) = (self.index(), self.dice.of(&TYPES[..3]));
                let value = self.b.value(Expr::UniformAt { base: 2, len: 5, index, ty });
                self.visible.push(value);
            }
            16..=17 => {
                let condition = self.value(Ty::Bool);
                let (accept, reject) = (self.block(), self.block());
                self.b.push(Stmt::If { condition, accept, reject });
            }
            18 => self.counted_loop(),
            _ => {
                self.scopes += 1;
                // Breaks do not leave a function.
                let (loops, continuing) = (self.loops, self.continuing);
                (self.loops, self.continuing) = (0, 0);
                let body = self.block();
                (self.loops, self.continuing) = (loops, continuing);
                self.scopes -= 1;
                self.b.push(Stmt::Scope(body));
            }
        }
    }

    fn counted_loop(&mut self) {
        let counter = self.b.variable("turns", Ty::I32);
        let zero = self.b.int(0);
        self.b.store(counter, zero);
        let continuing = std::mem::take(&mut self.continuing);
        self.loops += 1;
        self.b.begin();
        let turns = self.b.load(counter);
        let one = self.b.int(1);
        let next = self.b.op(Op::IAdd, &[turns, one]);
        self.b.store(counter, next);
        let limit = self.value(Ty::I32);
        let three = self.b.int(3);
        let limit = self.b.op(Op::IMin, &[limit, three]);
        let over = self.b.op(Op::ILess, &[limit, turns]);
        self.b.push(Stmt::If { condition: over, accept: vec![Stmt::Break], reject: vec![] });
        let inner = self.block();
        for stmt in inner {
            self.b.push(stmt);
        }
        let body = self.b.end();
        self.continuing = 1;
        let continuing_block = self.block();
        self.continuing = continuing;
        self.loops -= 1;
        self.b.push(Stmt::Loop { body, continuing: continuing_block });
    }
}

/// Words that reach the corners of every type.
fn word(seed: u32, lane: usize) -> u32 {
    let hash = (seed ^ (lane as u32).wrapping_mul(0x9e37_79b9)).wrapping_mul(0x85eb_ca6b);
    let hash = (hash ^ hash >> 13).wrapping_mul(0xc2b2_ae35);
    match hash >> 28 {
        0..=6 => ((hash & 0xffff) as f32 / 1024.0 - 16.0).to_bits(),
        7..=9 => hash & 7,
        10 => 0,
        11 => f32::INFINITY.to_bits(),
        12 => (-0.0f32).to_bits(),
        _ => hash,
    }
}

/// The uniform words, of which every fourth is of each type.
fn uniforms(seed: u32) -> Vec<u32> {
    let of = |at: usize| match TYPES[at % 4] {
        Ty::Bool => {
            if word(seed, at) & 1 == 0 {
                0
            } else {
                crate::ir::TRUE
            }
        }
        Ty::F32 | Ty::I32 | Ty::U32 => word(seed, at),
    };
    (0..UNIFORMS as usize).map(of).collect()
}

/// A geometry module like a fragment module: it emits what this stores, and ends strips where this discards.
fn emitting(mut module: crate::ir::Module) -> crate::ir::Module {
    fn block(stmts: Block, variables: &[crate::ir::Variable]) -> Block {
        let mut out = Block::new();
        for stmt in stmts {
            let nested = |stmts| block(stmts, variables);
            let stmt = match stmt {
                Stmt::If { condition, accept, reject } => {
                    Stmt::If { condition, accept: nested(accept), reject: nested(reject) }
                }
                Stmt::Loop { body, continuing } => {
                    Stmt::Loop { body: nested(body), continuing: nested(continuing) }
                }
                Stmt::Scope(body) => Stmt::Scope(nested(body)),
                Stmt::Discard => Stmt::EndPrimitive,
                Stmt::Store { var, value } => {
                    if variables[var.0 as usize].ty == Ty::F32 {
                        out.push(Stmt::EmitVertex(vec![value, Value(0)]));
                    }
                    Stmt::Store { var, value }
                }
                other => other,
            };
            out.push(stmt);
        }
        out
    }
    module.stage = Stage::Geometry;
    module.geometry = Some(GeometryInterface {
        input: GeometryInput::Lines,
        output: GeometryOutput::LineStrip,
        max_vertices: 7,
        outputs: vec![Output::Position(0), Output::Varying(3)],
    });
    module.varyings.clear();
    module.outputs.clear();
    for value in &mut module.values {
        match value {
            Expr::Input(Input::Varying(slot)) => {
                let output = Output::Varying(*slot);
                *value = Expr::Input(Input::OfVertex { vertex: (*slot % 2) as u8, output });
            }
            Expr::Input(Input::FrontFacing) => {
                *value = Expr::Const { bits: crate::ir::TRUE, ty: Ty::Bool };
            }
            _ => {}
        }
    }
    module.body = block(std::mem::take(&mut module.body), &module.variables);
    module
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_program_agrees_with_the_reference(
        rolls in proptest::collection::vec(any::<u32>(), 50..900),
        seed in any::<u32>(),
    ) {
        let uniforms = uniforms(seed);
        check(&module(&rolls), &uniforms, |input, lane| match input {
            Input::FrontFacing => if word(seed, lane + 1000) & 1 == 0 { 0 } else { crate::ir::TRUE },
            Input::Varying(slot) => word(seed, lane * 8 + usize::from(slot)),
            other => unreachable!("{other:?}"),
        });
    }

    #[test]
    fn every_geometry_program_emits_what_the_reference_emits(
        rolls in proptest::collection::vec(any::<u32>(), 50..900),
        seed in any::<u32>(),
    ) {
        let uniforms = uniforms(seed);
        check(&emitting(module(&rolls)), &uniforms, |input, lane| match input {
            Input::OfVertex { output: Output::Varying(slot), .. } => {
                word(seed, lane * 8 + usize::from(slot))
            }
            other => unreachable!("{other:?}"),
        });
    }

    #[test]
    fn what_moves_to_the_vertices_is_computed_there_as_it_was(
        rolls in proptest::collection::vec(any::<u32>(), 50..900),
        seed in any::<u32>(),
    ) {
        let uniforms = uniforms(seed);
        let given = |slot: u16| word(seed, 8 + usize::from(slot));
        let fragment = module(&rolls);
        let mut draft = OptimizedModule::new(&fragment, |_| true);
        let Some(vertex) = draft.hoist_to_vertex(&passing()) else { return Ok(()) };
        vertex.validate().unwrap();
        draft.module.validate().unwrap();
        let brought = reference::run(&vertex, &uniforms, 20_000, |input| match input {
            Input::Attribute { location, .. } => given(location.into()),
            other => unreachable!("{other:?}"),
        });
        let Outcome::Done(brought) = brought else { panic!("{brought:?}") };
        let [want, got] = [&fragment, &draft.module].map(|module| {
            reference::run(module, &uniforms, 20_000, |input| match input {
                Input::FrontFacing => crate::ir::TRUE,
                Input::Varying(slot) => {
                    let written = |(output, _): &(Output, Var)| *output == Output::Varying(slot);
                    brought[vertex.outputs.iter().position(written).unwrap()]
                }
                other => unreachable!("{other:?}"),
            })
        });
        if ![&want, &got].contains(&&Outcome::Endless) {
            prop_assert_eq!(want, got);
        }
    }
}

/// A vertex module that passes attributes on.
fn passing() -> crate::ir::Module {
    let mut b = Builder::new(Stage::Vertex);
    for slot in 0..4 {
        let value = b.input(Input::Attribute { location: slot, component: 0 });
        let out = b.output(Output::Varying(slot.into()));
        b.store(out, value);
    }
    b.finish()
}
