//! Uniform loops, which run without masks.

use super::check;
use crate::ir::{
    Builder, Expr, Input, Interpolation, Module, Op, Output, Stage, Stmt, Ty, Value, Var,
};
use crate::shader::Program;
use crate::shader::inst::Inst;

/// A module with one varying, one uniform word and one output.
fn fragment() -> (Builder, Var) {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().varyings = vec![Interpolation::Smooth];
    b.module_mut().uniform_words = 1;
    let out = b.output(Output::Color { target: 0, component: 0 });
    (b, out)
}

/// `for (i = 0; i < uniform; i++) { if (leave < i) break; out += s }`, without the break where there
/// is no `leave`.
fn loop_of(b: &mut Builder, out: Var, leave: Option<Value>) {
    let i = b.variable("i", Ty::I32);
    let (zero, one) = (b.int(0), b.int(1));
    let limit = b.uniform(0, Ty::I32);
    b.store(i, zero);
    b.begin();
    let at = b.load(i);
    let inside = b.op(Op::ILess, &[at, limit]);
    b.push(Stmt::If { condition: inside, accept: vec![], reject: vec![Stmt::Break] });
    if let Some(leave) = leave {
        let float = b.op(Op::IntToFloat, &[at]);
        let over = b.op(Op::Less, &[leave, float]);
        b.push(Stmt::If { condition: over, accept: vec![Stmt::Break], reject: vec![] });
    }
    let s = b.input(Input::Varying(0));
    let old = b.load(out);
    let new = b.op(Op::Add, &[old, s]);
    b.store(out, new);
    let body = b.end();
    b.begin();
    let at = b.load(i);
    let next = b.op(Op::IAdd, &[at, one]);
    b.store(i, next);
    let continuing = b.end();
    b.push(Stmt::Loop { body, continuing });
}

fn below_zero(b: &mut Builder) -> Value {
    let s = b.input(Input::Varying(0));
    let zero = b.float(0.0);
    b.op(Op::Less, &[s, zero])
}

fn check_turns(module: &Module) -> Program {
    for turns in [0, 1, 5, -3_i32 as u32] {
        check(module, &[turns], |_, lane| (lane as f32 / 8.0 - 4.0).to_bits());
    }
    Program::new(module, |_| true)
}

fn repeats(program: &Program) -> bool {
    program.code.iter().any(|inst| matches!(inst, Inst::Repeat { .. }))
}

#[test]
fn a_loop_with_a_uniform_bound_looks_at_no_mask() {
    let (mut b, out) = fragment();
    loop_of(&mut b, out, None);
    let program = check_turns(&b.finish());
    assert!(!program.masked, "{:?}", program.code);
}

#[test]
fn a_loop_that_each_lane_leaves_on_its_own_does() {
    let (mut b, out) = fragment();
    let s = b.input(Input::Varying(0));
    loop_of(&mut b, out, Some(s));
    let program = check_turns(&b.finish());
    assert!(program.masked && !repeats(&program), "{:?}", program.code);
}

#[test]
fn iterations_are_uniform_in_a_branch_and_behind_an_early_return() {
    let (mut b, out) = fragment();
    let condition = below_zero(&mut b);
    b.begin();
    loop_of(&mut b, out, None);
    let accept = b.end();
    b.push(Stmt::If { condition, accept, reject: vec![] });
    assert!(repeats(&check_turns(&b.finish())));

    let (mut b, out) = fragment();
    b.begin();
    let condition = below_zero(&mut b);
    b.push(Stmt::If { condition, accept: vec![Stmt::Leave], reject: vec![] });
    loop_of(&mut b, out, None);
    let body = b.end();
    b.push(Stmt::Scope(body));
    assert!(repeats(&check_turns(&b.finish())));
}

/// A lane that was away from a store reads what it had before.
#[test]
fn what_is_read_outside_of_a_branch_is_not_uniform() {
    let (mut b, out) = fragment();
    let kept = b.variable("kept", Ty::F32);
    let condition = below_zero(&mut b);
    let one = b.float(1.0);
    let accept = vec![Stmt::Store { var: kept, value: one }];
    b.push(Stmt::If { condition, accept, reject: vec![] });
    let value = b.value(Expr::Load(kept));
    b.store(out, value);
    check_turns(&b.finish());
}

/// The counter of an inner loop is live across iterations of the outer one, in which some lanes
/// skip it.
#[test]
fn what_is_repeated_in_a_loop_is_not_uniform() {
    let (mut b, out) = fragment();
    let turns = b.variable("turns", Ty::I32);
    let seen = b.variable("seen", Ty::I32);
    let one = b.int(1);
    let limit = b.uniform(0, Ty::I32);
    b.begin();
    let at = b.load(turns);
    let over = b.op(Op::ILessEqual, &[limit, at]);
    b.push(Stmt::If { condition: over, accept: vec![Stmt::Break], reject: vec![] });
    let s = b.input(Input::Varying(0));
    let float = b.op(Op::IntToFloat, &[at]);
    let condition = b.op(Op::Less, &[s, float]);
    b.begin();
    let before = b.load(seen);
    let after = b.op(Op::IAdd, &[before, one]);
    b.store(seen, after);
    let float = b.op(Op::IntToFloat, &[after]);
    let old = b.load(out);
    let new = b.op(Op::Add, &[old, float]);
    b.store(out, new);
    let accept = b.end();
    b.push(Stmt::If { condition, accept, reject: vec![] });
    let next = b.op(Op::IAdd, &[at, one]);
    b.store(turns, next);
    let body = b.end();
    b.push(Stmt::Loop { body, continuing: vec![] });
    assert!(repeats(&check_turns(&b.finish())));
}
