//! Programs that are compiled for uniform values of 0 and 1.

use super::super::inst::Inst;
use super::{check, specialized};
use crate::ir::{
    Builder, FunctionTable, Input, Interpolation, Lod, Module, Op, Output, Stage, Stmt, TRUE,
    TextureDecl, Ty, Var,
};
use texunit::image::Shape;

/// A module with one varying, two uniform words and one output.
fn fragment() -> (Builder, Var) {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().varyings = vec![Interpolation::Smooth];
    b.module_mut().uniform_words = 2;
    let out = b.output(Output::Color { target: 0, component: 0 });
    (b, out)
}

fn varying(_: Input, lane: usize) -> u32 {
    (lane as f32 / 8.0 - 4.0).to_bits()
}

/// `out = s; if (uniform) out = sin(sin(… s))`.
fn branch() -> Module {
    let (mut b, out) = fragment();
    let s = b.input(Input::Varying(0));
    b.store(out, s);
    let condition = b.uniform(0, Ty::Bool);
    b.begin();
    let mut value = s;
    for _ in 0..4 {
        value = b.op(Op::Sin, &[value]);
    }
    b.store(out, value);
    let accept = b.end();
    b.push(Stmt::If { condition, accept, reject: vec![] });
    b.finish()
}

/// `out = sin(s · uniform 0) + uniform 1`.
fn product() -> Module {
    let (mut b, out) = fragment();
    let s = b.input(Input::Varying(0));
    let [factor, offset] = [0, 1].map(|word| b.uniform(word, Ty::F32));
    let product = b.op(Op::Mul, &[s, factor]);
    let sine = b.op(Op::Sin, &[product]);
    let sum = b.op(Op::Add, &[sine, offset]);
    b.store(out, sum);
    b.finish()
}

#[test]
fn a_branch_that_no_lane_takes_is_left_out() {
    let module = branch();
    let left = [0, TRUE].map(|word| {
        check(&module, &[word, 0], varying);
        specialized(&module, &[word, 0]).map(|program| program.code.len())
    });
    let [Some(none), Some(taken)] = left else { panic!("{left:?}") };
    assert!(none < taken, "{left:?}");
}

/// A product with 0 keeps infinities and signs, a sum with 0 the sign of zero; a product with 1 is left out.
#[test]
fn products_and_sums_are_left_out_where_they_change_no_bit() {
    let module = product();
    let [zero, one, minus_zero, other] = [0.0_f32, 1.0, -0.0, 0.7].map(f32::to_bits);
    for factor in [zero, one, minus_zero, other] {
        for offset in [zero, one, minus_zero, other] {
            check(&module, &[factor, offset], varying);
            let infinite =
                |_: Input, lane: usize| [f32::INFINITY, f32::NAN, -0.0, 0.0][lane % 4].to_bits();
            check(&module, &[factor, offset], infinite);
            let is_smaller = specialized(&module, &[factor, offset]).is_some();
            assert_eq!(is_smaller, factor == one, "{factor:x} {offset:x}");
        }
    }
}

/// `pow(texel, exponent)` and `pow(texel, texel)`, of one lookup.
fn powers_of_texels() -> (Module, usize) {
    let (mut b, out) = fragment();
    let s = b.input(Input::Varying(0));
    let texture = b.texture(TextureDecl::color(Shape::D2));
    let [texel, ..] = b.sample(texture, [s; 3], None, Lod::Implicit { bias: None });
    let exponents = [b.float(2.2), b.float(0.3), texel, s];
    let mut sum = texel;
    for exponent in exponents {
        let power = b.op(Op::Pow, &[texel, exponent]);
        sum = b.op(Op::Add, &[sum, power]);
    }
    b.store(out, sum);
    // That of `s` is none of the texel alone.
    (b.finish(), exponents.len() - 1)
}

#[test]
fn powers_of_bytes_are_tables() {
    let (module, tables) = powers_of_texels();
    // A slot without a texture gives 0 and 1.
    let program = specialized(&module, &[]).expect("it is another program");
    let found = program
        .code
        .iter()
        .filter(|inst| matches!(inst, Inst::Tabulated { table: FunctionTable::OfByte(_), .. }))
        .count();
    assert_eq!(found, tables);
}
