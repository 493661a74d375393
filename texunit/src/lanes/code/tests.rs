//! Code against the same operations in plain Rust, on every instruction set that has a code generator.

use super::{Binary, Block, Code, Compare, Rounding, Step, Unary, Value};
use crate::lanes::{Isa, LANES, U32s};

const BINARY: &[Binary] = &[
    Binary::Add,
    Binary::Sub,
    Binary::Mul,
    Binary::Div,
    Binary::Min,
    Binary::Max,
    Binary::Compare(Compare::Less),
    Binary::Compare(Compare::LessEqual),
    Binary::Compare(Compare::Equal),
    Binary::Compare(Compare::NotEqual),
    Binary::Compare(Compare::Unordered),
    Binary::And,
    Binary::Or,
    Binary::Xor,
    Binary::IntAdd,
    Binary::IntSub,
    Binary::IntMul,
    Binary::IntMin,
    Binary::IntMax,
    Binary::UintMin,
    Binary::UintMax,
    Binary::IntEqual,
    Binary::IntGreater,
    Binary::ShiftLeft,
    Binary::ShiftRight,
    Binary::ShiftRightSigned,
];

const UNARY: &[Unary] = &[
    Unary::Sqrt,
    Unary::Round(Rounding::Even),
    Unary::Round(Rounding::Down),
    Unary::Round(Rounding::Up),
    Unary::Round(Rounding::Zero),
    Unary::IntToFloat,
    Unary::FloatToInt,
];

fn truth(holds: bool) -> u32 {
    if holds { !0 } else { 0 }
}

fn binary(op: Binary, a: u32, b: u32) -> u32 {
    let (x, y) = (f32::from_bits(a), f32::from_bits(b));
    let (i, j) = (a as i32, b as i32);
    match op {
        Binary::Add => (x + y).to_bits(),
        Binary::Sub => (x - y).to_bits(),
        Binary::Mul => (x * y).to_bits(),
        Binary::Div => (x / y).to_bits(),
        Binary::Min => (if x < y { x } else { y }).to_bits(),
        Binary::Max => (if x > y { x } else { y }).to_bits(),
        Binary::Compare(Compare::Less) => truth(x < y),
        Binary::Compare(Compare::LessEqual) => truth(x <= y),
        Binary::Compare(Compare::Equal) => truth(x == y),
        Binary::Compare(Compare::NotEqual) => truth(x != y),
        Binary::Compare(Compare::Unordered) => truth(x.is_nan() || y.is_nan()),
        Binary::And => a & b,
        Binary::Or => a | b,
        Binary::Xor => a ^ b,
        Binary::IntAdd => a.wrapping_add(b),
        Binary::IntSub => a.wrapping_sub(b),
        Binary::IntMul => a.wrapping_mul(b),
        Binary::IntMin => i.min(j) as u32,
        Binary::IntMax => i.max(j) as u32,
        Binary::UintMin => a.min(b),
        Binary::UintMax => a.max(b),
        Binary::IntEqual => truth(a == b),
        Binary::IntGreater => truth(i > j),
        Binary::ShiftLeft => a << (b & 31),
        Binary::ShiftRight => a >> (b & 31),
        Binary::ShiftRightSigned => (i >> (b & 31)) as u32,
    }
}

fn unary(op: Unary, a: u32) -> u32 {
    let x = f32::from_bits(a);
    match op {
        Unary::Sqrt => x.sqrt().to_bits(),
        Unary::Round(Rounding::Even) => x.round_ties_even().to_bits(),
        Unary::Round(Rounding::Down) => x.floor().to_bits(),
        Unary::Round(Rounding::Up) => x.ceil().to_bits(),
        Unary::Round(Rounding::Zero) => x.trunc().to_bits(),
        Unary::IntToFloat => (a as i32 as f32).to_bits(),
        // Out of range: the processor's word, which no caller asks for.
        Unary::FloatToInt if (-2_147_483_648.0..2_147_483_648.0).contains(&x) => x as i32 as u32,
        Unary::FloatToInt => 0x8000_0000,
    }
}

/// Numbers of every kind, beside those that look random.
fn word(seed: u32, lane: usize) -> u32 {
    const SPECIAL: [u32; 12] = [
        0,
        0x8000_0000,
        0x7f80_0000,
        0xff80_0000,
        0x7fc0_0000,
        1,
        0x8000_0001,
        0x3f00_0000,
        0xbfc0_0000,
        0x4f00_0000,
        0x7f7f_ffff,
        !0,
    ];
    let mut x = seed.wrapping_mul(0x9e37_79b9) ^ (lane as u32).wrapping_mul(0x85eb_ca6b);
    x ^= x >> 15;
    x = x.wrapping_mul(0x2c1b_3c6d);
    x ^= x >> 12;
    match x % 3 {
        0 => SPECIAL[(x >> 8) as usize % SPECIAL.len()],
        1 => ((x >> 4) as f32 / 1e6 - 134.0).to_bits(),
        _ => x,
    }
}

const NAN: u32 = 0x7fc0_0000;

/// The word, of all NaNs the same.
fn normal(word: u32) -> u32 {
    if f32::from_bits(word).is_nan() { NAN } else { word }
}

fn targets() -> Vec<Isa> {
    Isa::available().into_iter().filter(|isa| Code::compile(*isa, &[]).is_some()).collect()
}

/// Blocks of 60 random steps, some with more values alive than the processor has registers.
#[test]
fn code_gives_the_words_of_its_steps() {
    let mut compared = 0;
    for isa in targets() {
        for seed in 0..400u32 {
            compared += check(isa, seed);
        }
    }
    let expected = if targets().is_empty() { 0 } else { 100_000 };
    assert!(compared >= expected, "{compared} words");
}

fn check(isa: Isa, seed: u32) -> usize {
    const SPLATS: u32 = 5;
    const INPUTS: u32 = 9;
    const OUTPUTS: u32 = 30;
    let mut random =
        (0..).map(|at| word(seed.wrapping_add(77), at) ^ (at as u32).wrapping_mul(0x0123_4567));
    let mut below = |count: usize| random.next().unwrap_or(0) as usize % count;
    let splats: Vec<f32> =
        (0..SPLATS).map(|at| f32::from_bits(normal(word(seed, 1000 + at as usize)))).collect();
    let mut registers: Vec<U32s> = (0..SPLATS + INPUTS + OUTPUTS)
        .map(|at| match splats.get(at as usize) {
            Some(splat) => U32s::splat(splat.to_bits()),
            None => U32s::from_fn(|lane| normal(word(seed ^ at << 8, lane))),
        })
        .collect();
    let mask = U32s::from_fn(|lane| truth(word(seed, lane).is_multiple_of(3)));
    let mut block = Block::new(SPLATS);
    let mut held = registers.clone();
    let mut values: Vec<(Value, U32s)> = vec![(block.value(Step::Mask), mask)];
    let random_word = word(seed, 4711);
    values.push((block.value(Step::Constant(random_word)), U32s::splat(random_word)));
    for _ in 0..60 {
        let register = below((SPLATS + INPUTS) as usize);
        let pick = |at: usize, values: &[(Value, U32s)]| values[at % values.len()];
        let (value, words) = match below(7) {
            0 | 1 => (block.read(register as u32), held[register]),
            2 => {
                let op = UNARY[below(UNARY.len())];
                let (a, x) = pick(below(1000), &values);
                let words = U32s::from_fn(|lane| unary(op, x[lane]));
                (block.value(Step::Unary(op, a)), words)
            }
            3 => {
                let [(m, x), (b, y), (c, z)] = [(); 3].map(|()| pick(below(1000), &values));
                let zero = block.value(Step::Constant(0));
                let condition = block.value(Step::Binary(Binary::IntGreater, m, zero));
                let words = U32s::from_fn(|at| if x[at] as i32 > 0 { y[at] } else { z[at] });
                (block.value(Step::Select(condition, b, c)), words)
            }
            _ => {
                let op = BINARY[below(BINARY.len())];
                let (a, x) = pick(below(1000), &values);
                let (mut b, mut y) = pick(below(1000), &values);
                if matches!(op, Binary::ShiftLeft | Binary::ShiftRight | Binary::ShiftRightSigned) {
                    let low = block.value(Step::Constant(31));
                    b = block.value(Step::Binary(Binary::And, b, low));
                    y = U32s::from_fn(|lane| y[lane] & 31);
                }
                let words = U32s::from_fn(|lane| binary(op, x[lane], y[lane]));
                (block.value(Step::Binary(op, a, b)), words)
            }
        };
        // Which of two NaNs an operation gives is not defined: integers are to see one NaN alone.
        let nan = block.value(Step::Constant(NAN));
        let unordered = Binary::Compare(Compare::Unordered);
        let is_nan = block.value(Step::Binary(unordered, value, value));
        let value = block.value(Step::Select(is_nan, nan, value));
        let words = U32s::from_fn(|lane| normal(words[lane]));
        values.push((value, words));
        let register = SPLATS as usize + below((INPUTS + OUTPUTS) as usize);
        block.write(register as u32, value);
        held[register] = words;
    }
    let Some(code) = Code::compile(isa, &[block]) else { return 0 };
    code.run(0, &mut registers, &splats, &mask);
    for (number, (found, wanted)) in registers.iter().zip(&held).enumerate() {
        for lane in 0..LANES {
            let (found, wanted) = (normal(found[lane]), normal(wanted[lane]));
            assert_eq!(found, wanted, "{} seed {seed} register {number} lane {lane}", isa.name());
        }
    }
    registers.len() * LANES
}
