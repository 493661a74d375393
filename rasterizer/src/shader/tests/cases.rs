//! Programs written by hand: control flow, arrays, derivatives, budgets, depth.

use super::{check, run};
use crate::ir::{
    Axis, Block, Builder, Expr, Input, Interpolation, Lod, MAX_NESTING, Module, Op, Output, Stage,
    Stmt, TextureDecl, Ty, Var,
};
use crate::shader::compute::Compute;
use crate::shader::inst::{Inst, Reg};
use crate::shader::{Fusing, MAX_REGISTER_FILES, OverBudget, Program};
use texunit::image::Shape;
use texunit::lanes::{Isa, LANES, U32s, lane_x, lane_y};

const ALL: u64 = !0;

/// A fragment builder with varyings, and the red output.
fn fragment() -> (Builder, Var) {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().varyings = vec![Interpolation::Smooth; 4];
    let red = b.output(Output::Color { target: 0, component: 0 });
    (b, red)
}

fn by_lane(input: Input, lane: usize) -> u32 {
    match input {
        Input::Varying(slot) => (lane as f32 - 20.0 + f32::from(slot)).to_bits(),
        Input::Gradient { .. } => 0,
        other => unreachable!("{other:?}"),
    }
}

/// The red output of each lane on every instruction set.
fn red(module: &Module) -> Vec<f32> {
    module.validate().unwrap();
    let program = Program::new(module, |_| true);
    let mut all = Isa::executions().into_iter().map(|isa| {
        let lanes = run(isa, &program, &[], ALL, 1_000_000, by_lane).unwrap();
        lanes.into_iter().map(|out| out.map_or(f32::NAN, |out| f32::from_bits(out[0]))).collect()
    });
    let first: Vec<f32> = all.next().unwrap();
    assert!(all.all(|other| other == first));
    first
}

/// Straight code of few registers runs for several batches at once; what depends on lanes does not.
#[test]
fn what_has_no_control_flow_runs_in_banks() {
    let (mut b, red) = fragment();
    let x = b.input(Input::Varying(0));
    let value = b.op(Op::Sqrt, &[x]);
    b.store(red, value);
    let straight = b.finish();
    assert_eq!(Program::new(&straight, |_| true).register_files(), MAX_REGISTER_FILES);
    check(&straight, &[], by_lane);

    let (mut b, red) = fragment();
    let x = b.input(Input::Varying(0));
    b.store(red, x);
    let zero = b.float(0.0);
    let condition = b.op(Op::Less, &[x, zero]);
    b.push(Stmt::If { condition, accept: vec![Stmt::Discard], reject: Vec::new() });
    assert_eq!(Program::new(&b.finish(), |_| true).register_files(), 1);
}

struct OneOp<'a>(Op, &'a mut [U32s; 4]);

impl texunit::lanes::Kernel for OneOp<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: texunit::lanes::Simd>(self) {
        let args = std::array::from_fn(|at| Reg(at.min(2) as u32));
        Compute::from(self.0).run::<S>(self.1, &[], Reg(3), &args);
    }
}

#[test]
fn every_operation_is_the_same_on_one_lane_and_on_64_of_every_instruction_set() {
    let corners = [
        0,
        1,
        2,
        31,
        32,
        !0,
        1 << 31,
        i32::MAX as u32,
        0x3f80_0000,
        0xbf80_0000,
        0x7f80_0000,
        0xff80_0000,
        0x7fc0_0000,
        0x4049_0fdb,
        0x0040_0000,
        0x4f00_0000,
        0x5f00_0000,
        0x3eaa_aaab,
    ];
    let boolean = |word: u32| if word & 1 == 0 { 0 } else { !0 };
    for &op in Op::ALL {
        for round in 0..40usize {
            let args: [U32s; 3] = [0, 1, 2].map(|arg| {
                U32s::from_fn(|lane| {
                    // In every fourth round the lanes agree.
                    let at = round * 64 + if round % 4 == 3 { 0 } else { lane };
                    let word =
                        match arg {
                            0 => corners[at % corners.len()],
                            1 => corners[at / corners.len() % corners.len()],
                            _ => (at as u32).wrapping_mul(0x9e37_79b9),
                        } ^ if round > 10 { (at as u32).wrapping_mul(0x85eb_ca6b) } else { 0 };
                    if op.args().get(arg) == Some(&Ty::Bool) { boolean(word) } else { word }
                })
            });
            for isa in Isa::executions() {
                let mut registers = [args[0], args[1], args[2], U32s::ZERO];
                isa.run(OneOp(op, &mut registers));
                let out = &registers[3];
                for lane in 0..LANES {
                    let want = op.eval([args[0][lane], args[1][lane], args[2][lane]]);
                    let (got, want) = (super::any_nan(out[lane]), super::any_nan(want));
                    assert_eq!(got, want, "{} on {} lane {lane}", op.name(), isa.name());
                }
            }
        }
    }
}

#[test]
fn derivatives_are_the_differences_within_a_quad() {
    for axis in [Axis::X, Axis::Y] {
        let (mut b, out) = fragment();
        let s = b.input(Input::Varying(0));
        let d = b.derivative(axis, s);
        b.store(out, d);
        let module = b.finish();
        let program = Program::new(&module, |_| true);
        let height = |x: usize, y: usize| (x * x * 3 + y * y * y) as f32;
        for isa in Isa::executions() {
            let input = |_, lane| height(lane_x(lane), lane_y(lane)).to_bits();
            let got = run(isa, &program, &[], ALL, 1000, input).unwrap();
            for (lane, got) in got.iter().enumerate() {
                let (x, y) = (lane_x(lane), lane_y(lane));
                let want = match axis {
                    Axis::X => height(x | 1, y) - height(x & !1, y),
                    Axis::Y => height(x, y | 1) - height(x, y & !1),
                };
                assert_eq!(got.as_ref().unwrap()[0], want.to_bits(), "lane {lane}");
            }
        }
    }
}

#[test]
fn a_slot_without_a_texture_samples_as_opaque_black() {
    let (mut b, red) = fragment();
    let alpha = b.output(Output::Color { target: 0, component: 3 });
    let slot = b.texture(TextureDecl::color(Shape::D2));
    let s = b.input(Input::Varying(0));
    let texel = b.sample(slot, [s; 3], None, Lod::Implicit { bias: None });
    b.store(red, texel[0]);
    b.store(alpha, texel[3]);
    let module = b.finish();
    module.validate().unwrap();
    let program = Program::new(&module, |_| true);
    assert_eq!(program.texture_slots(), &[0]);
    let got = run(Isa::best(), &program, &[], ALL, 1000, by_lane).unwrap();
    assert!(got.iter().all(|out| *out == Some(vec![0, 1f32.to_bits()])));
}

/// `while (true) { if (i >= s) break; i += 1 }`
fn count_up_to_s() -> Module {
    let (mut b, out) = fragment();
    let s = b.input(Input::Varying(0));
    let one = b.float(1.0);
    b.begin();
    let i = b.load(out);
    let over = b.op(Op::LessEqual, &[s, i]);
    b.push(Stmt::If { condition: over, accept: vec![Stmt::Break], reject: vec![] });
    let next = b.op(Op::Add, &[i, one]);
    b.store(out, next);
    let body = b.end();
    b.push(Stmt::Loop { body, continuing: vec![] });
    b.finish()
}

#[test]
fn each_lane_leaves_a_loop_when_it_would_alone() {
    let want: Vec<f32> = (0..LANES).map(|lane| (lane as f32 - 20.0).max(0.0)).collect();
    assert_eq!(red(&count_up_to_s()), want);
    check(&count_up_to_s(), &[], by_lane);
}

#[test]
fn a_loop_that_does_not_end_runs_out_of_budget() {
    let program = Program::new(&count_up_to_s(), |_| true);
    let mut endless = Builder::new(Stage::Fragment);
    endless.push(Stmt::Loop { body: vec![], continuing: vec![] });
    let endless = Program::new(&endless.finish(), |_| true);
    for isa in Isa::executions() {
        let forever = |_, _| f32::INFINITY.to_bits();
        assert_eq!(run(isa, &program, &[], ALL, 10_000, forever), Err(OverBudget));
        assert_eq!(run(isa, &endless, &[], ALL, 10_000, forever), Err(OverBudget));
        assert!(run(isa, &program, &[], ALL, 10_000, by_lane).is_ok());
    }
}

#[test]
fn array_indices_are_clamped_per_lane() {
    let (mut b, out) = fragment();
    let array = b.array("a", Ty::F32, 4);
    let s = b.input(Input::Varying(0));
    let index = b.op(Op::FloatToInt, &[s]);
    let ten = b.float(10.0);
    b.push(Stmt::StoreAt { var: array, index, value: ten });
    let three = b.int(3);
    let last = b.value(Expr::LoadAt { var: array, index: three });
    b.store(out, last);
    let got = red(&b.finish());
    for (lane, got) in got.into_iter().enumerate() {
        // Negative indices reach the last element too; -0.x truncates to 0.
        let index = lane as i32 - 20;
        assert_eq!(got, if (0..3).contains(&index) { 0.0 } else { 10.0 }, "lane {lane}");
    }
}

#[test]
fn outputs_that_nobody_reads_take_their_inputs_with_them() {
    let mut b = Builder::new(Stage::Vertex);
    for slot in 0..4 {
        let value = b.input(Input::Attribute { location: slot, component: 0 });
        let out = b.output(Output::Varying(u16::from(slot)));
        b.store(out, value);
    }
    let module = b.finish();
    let program = Program::new(&module, |output| output == Output::Varying(2));
    assert_eq!(program.inputs(), &[Input::Attribute { location: 2, component: 0 }]);
    assert!(program.outputs().eq([Output::Varying(2)]));
}

#[test]
fn what_depends_on_uniform_words_only_is_computed_once_per_draw() {
    let (mut b, out) = fragment();
    let (u, s) = (b.uniform(0, Ty::F32), b.input(Input::Varying(0)));
    let root = b.op(Op::Sqrt, &[u]);
    let sine = b.op(Op::Sin, &[root]);
    let product = b.op(Op::Mul, &[sine, s]);
    b.store(out, product);
    let program = Program::new(&b.finish(), |_| true);
    assert_eq!(program.code.len(), 1, "{}", program.describe());
    assert!(program.describe().contains("2 values once per draw"), "{}", program.describe());
}

/// `if (u) out = sqrt(s)… else if (s < 0) leave; out += 1`, in a scope; too long for selects.
fn branch_on_a_uniform() -> Module {
    let (mut b, out) = fragment();
    b.module_mut().uniform_words = 1;
    let (u, s) = (b.uniform(0, Ty::Bool), b.input(Input::Varying(0)));
    let (zero, one) = (b.float(0.0), b.float(1.0));
    let long = |b: &mut Builder, op| {
        b.begin();
        let value = (0..20).fold(s, |value, _| b.op(op, &[value]));
        b.store(out, value);
        b.end()
    };
    let accept = long(&mut b, Op::Sqrt);
    let mut reject = long(&mut b, Op::Floor);
    b.begin();
    let below = b.op(Op::Less, &[s, zero]);
    b.push(Stmt::If { condition: below, accept: vec![Stmt::Leave], reject: vec![] });
    reject.extend(b.end());
    b.begin();
    b.push(Stmt::If { condition: u, accept, reject });
    let old = b.load(out);
    let sum = b.op(Op::Add, &[old, one]);
    b.store(out, sum);
    let body = b.end();
    b.push(Stmt::Scope(body));
    b.finish()
}

#[test]
fn a_branch_on_a_uniform_looks_at_no_mask() {
    let module = branch_on_a_uniform();
    check(&module, &[0], by_lane);
    check(&module, &[!0], by_lane);
    for program in [Program::new(&module, |_| true), Program::lowered(&module, Fusing::Off)] {
        assert!(program.code.iter().any(|inst| matches!(inst, Inst::Unless { .. })));
    }
}

/// The state `x` of `while (x < s) { x = x + x + 1; turns++ }` is the loop's own, its turns are not.
#[test]
fn what_only_a_loop_reads_is_stored_without_a_mask() {
    let (mut b, turns) = fragment();
    let x = b.variable("x", Ty::F32);
    let s = b.input(Input::Varying(0));
    let one = b.float(1.0);
    b.begin();
    let old = b.load(x);
    let over = b.op(Op::LessEqual, &[s, old]);
    b.push(Stmt::If { condition: over, accept: vec![Stmt::Break], reject: vec![] });
    let twice = b.op(Op::Add, &[old, old]);
    let next = b.op(Op::Add, &[twice, one]);
    b.store(x, next);
    let count = b.load(turns);
    let count = b.op(Op::Add, &[count, one]);
    b.store(turns, count);
    let body = b.end();
    b.push(Stmt::Loop { body, continuing: vec![] });
    let module = b.finish();
    check(&module, &[], by_lane);
    let program = Program::new(&module, |_| true);
    let masked = program.code.iter().filter(|inst| matches!(inst, Inst::Store { .. })).count();
    assert_eq!(masked, 1, "{:?}", program.code);
}

/// A later loop reads what an earlier one stores: lanes that left the earlier one keep theirs.
#[test]
fn what_another_loop_reads_is_stored_under_the_mask() {
    let (mut b, out) = fragment();
    let x = b.variable("x", Ty::F32);
    let i = b.variable("i", Ty::F32);
    let s = b.input(Input::Varying(0));
    let (zero, one) = (b.float(0.0), b.float(1.0));
    for reads in [false, true] {
        b.store(i, zero);
        b.begin();
        let at = b.load(i);
        let over = b.op(Op::LessEqual, &[s, at]);
        b.push(Stmt::If { condition: over, accept: vec![Stmt::Break], reject: vec![] });
        if reads {
            let last = b.load(x);
            b.store(out, last);
        } else {
            b.store(x, at);
        }
        let next = b.op(Op::Add, &[at, one]);
        b.store(i, next);
        let body = b.end();
        b.push(Stmt::Loop { body, continuing: vec![] });
    }
    check(&b.finish(), &[], by_lane);
}

/// `depth` nested branches.
fn nested(depth: usize) -> Module {
    let (mut b, out) = fragment();
    let s = b.input(Input::Varying(0));
    let zero = b.float(0.0);
    let condition = b.op(Op::Less, &[zero, s]);
    let mut block: Block = vec![Stmt::Store { var: out, value: s }];
    for _ in 0..depth {
        block = vec![Stmt::If { condition, accept: block, reject: vec![] }];
    }
    block.into_iter().for_each(|stmt| b.push(stmt));
    b.finish()
}

#[test]
fn blocks_nest_as_deep_as_the_limit_and_no_deeper() {
    check(&nested(MAX_NESTING - 1), &[], by_lane);
    let error = nested(MAX_NESTING).validate().unwrap_err();
    assert!(error.0.contains("nest deeper"), "{error}");
}

/// `for (i = 0; i < turns; i++) { if (s < i) out += i; else out -= 1 }`, nested in itself `depth` times.
fn counted(turns: i32, depth: usize) -> Module {
    let (mut b, out) = fragment();
    let s = b.input(Input::Varying(0));
    let (one, one_float) = (b.int(1), b.float(1.0));
    let limit = b.int(turns);
    let mut block = None;
    for _ in 0..depth {
        let i = b.variable("i", Ty::I32);
        let zero = b.int(0);
        b.begin();
        let at = b.load(i);
        let inside = b.op(Op::ILess, &[at, limit]);
        b.push(Stmt::If { condition: inside, accept: vec![], reject: vec![Stmt::Break] });
        let float = b.op(Op::IntToFloat, &[at]);
        let below = b.op(Op::Less, &[s, float]);
        let mut side = |op, by| {
            b.begin();
            let old = b.load(out);
            let new = b.op(op, &[old, by]);
            b.store(out, new);
            b.end()
        };
        let (accept, reject) = (side(Op::Add, float), side(Op::Sub, one_float));
        b.push(Stmt::If { condition: below, accept, reject });
        if let Some(inner) = block.take() {
            b.push(inner);
        }
        let body = b.end();
        b.begin();
        let at = b.load(i);
        let next = b.op(Op::IAdd, &[at, one]);
        b.store(i, next);
        let continuing = b.end();
        b.begin();
        b.store(i, zero);
        b.push(Stmt::Loop { body, continuing });
        block = Some(Stmt::Scope(b.end()));
    }
    block.into_iter().for_each(|stmt| b.push(stmt));
    b.finish()
}

#[test]
fn counted_loops_become_straight_code_within_bounds() {
    for (turns, depth, straight) in [(0, 1, true), (5, 1, true), (4, 2, true), (10_000, 1, false)] {
        let module = counted(turns, depth);
        check(&module, &[], by_lane);
        let program = Program::new(&module, |_| true);
        let jumps = program.code.iter().any(Inst::is_control);
        assert_eq!(!jumps, straight, "{turns} turns: {}", program.describe());
    }
    // However deep, the code stays small.
    let program = Program::new(&counted(30, 4), |_| true);
    assert!(program.code.len() < 100_000, "{}", program.describe());
}

/// A zero that is added goes where no -0 can come, and only there.
#[test]
fn a_zero_is_added_to_what_may_be_minus_zero() {
    let inputs = |_, lane: usize| {
        let x = [-0.0, 0.0, -0.25, 0.75, -1.0, f32::INFINITY, f32::NAN, -1e-40];
        x[lane % x.len()].to_bits()
    };
    let none = [Op::Floor, Op::Ceil, Op::Trunc];
    for (op, kept) in none.map(|op| (op, 0)).into_iter().chain([(Op::RoundEven, 1), (Op::Neg, 1)]) {
        let (mut b, red) = fragment();
        let x = b.input(Input::Varying(0));
        let (value, zero) = (b.op(op, &[x]), b.float(0.0));
        let sum = b.op(Op::Add, &[zero, value]);
        b.store(red, sum);
        let module = b.finish();
        check(&module, &[], inputs);
        let program = Program::new(&module, |_| true);
        let is_sum = |inst: &&Inst| {
            matches!(inst, Inst::Compute { what: Compute::Add | Compute::AddUniform, .. })
        };
        assert_eq!(program.code.iter().filter(is_sum).count(), kept, "{op:?}");
    }
}
