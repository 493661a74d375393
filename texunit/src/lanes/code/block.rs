//! The steps of straight code: values that are computed from values.

use std::collections::{HashMap, HashSet};

/// The result of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Value(pub(super) u32);

/// A step. All values are 64 words; floats are words by their bits, truth is all bits of a word or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// What a register holds when the code begins.
    Register(u32),
    /// A splat in all lanes.
    Splat(u32),
    /// A word in all lanes.
    Constant(u32),
    /// The lanes that execute.
    Mask,
    /// An operation on one value.
    Unary(Unary, Value),
    /// An operation on two values.
    Binary(Binary, Value, Value),
    /// The second where the first is true, else the third.
    Select(Value, Value, Value),
}

/// Operations on one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unary {
    /// IEEE square root.
    Sqrt,
    /// To an integer, as a float; keeps the sign of a zero.
    Round(Rounding),
    /// A signed integer to the nearest float.
    IntToFloat,
    /// A float within the range of `i32` to the integer part.
    FloatToInt,
}

/// To which integer a float is rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// The nearest, halves to even.
    Even,
    /// Not above.
    Down,
    /// Not below.
    Up,
    /// Toward zero.
    Zero,
}

/// Operations on two values, on floats, words or integers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Binary {
    /// Floats.
    Add,
    /// Floats.
    Sub,
    /// Floats.
    Mul,
    /// Floats.
    Div,
    /// Floats: the first where it is smaller, else the second.
    Min,
    /// Floats: the first where it is larger, else the second.
    Max,
    /// Floats.
    Compare(Compare),
    /// Words.
    And,
    /// Words.
    Or,
    /// Words.
    Xor,
    /// Wrapping.
    IntAdd,
    /// Wrapping.
    IntSub,
    /// Wrapping.
    IntMul,
    /// Signed.
    IntMin,
    /// Signed.
    IntMax,
    /// Unsigned.
    UintMin,
    /// Unsigned.
    UintMax,
    /// Equal words.
    IntEqual,
    /// Signed.
    IntGreater,
    /// Left, by less than 32.
    ShiftLeft,
    /// Right with zeros, by less than 32.
    ShiftRight,
    /// Right with the sign, by less than 32.
    ShiftRightSigned,
}

/// Comparisons of floats.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Compare {
    /// Neither is NaN, and the first is smaller.
    Less,
    /// Neither is NaN, and the first is not larger.
    LessEqual,
    /// Neither is NaN, and they are equal.
    Equal,
    /// One is NaN, or they are not equal.
    NotEqual,
    /// One is NaN.
    Unordered,
}

/// A value that becomes what a register holds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Write {
    /// After how many steps.
    pub after: usize,
    pub register: u32,
    pub value: Value,
}

/// Straight code: steps, and what they leave in registers.
#[derive(Debug)]
pub struct Block {
    pub(super) steps: Vec<Step>,
    pub(super) writes: Vec<Write>,
    numbers: HashMap<Step, Value>,
    /// What registers hold, of those that were read or written.
    held: HashMap<u32, Value>,
    /// Registers below this hold splats and are not written.
    splats: u32,
    registers: u32,
}

impl Block {
    /// A block without steps. The registers below `splats` hold the splats of the same number.
    pub fn new(splats: u32) -> Self {
        Self {
            steps: Vec::new(),
            writes: Vec::new(),
            numbers: HashMap::new(),
            held: HashMap::new(),
            splats,
            registers: splats,
        }
    }

    /// The value of a step; the same for equal steps.
    ///
    /// # Panics
    /// When a splat is none of the block's: a program addresses no others.
    pub fn value(&mut self, step: Step) -> Value {
        match step {
            Step::Register(register) => {
                self.registers = self.registers.max(register.saturating_add(1))
            }
            Step::Splat(splat) => assert!(splat < self.splats, "splat {splat} of {}", self.splats),
            Step::Constant(_)
            | Step::Mask
            | Step::Unary(..)
            | Step::Binary(..)
            | Step::Select(..) => {}
        }
        let Self { steps, numbers, .. } = self;
        *numbers.entry(step).or_insert_with(|| {
            steps.push(step);
            Value(steps.len() as u32 - 1)
        })
    }

    /// What a register holds.
    pub fn read(&mut self, register: u32) -> Value {
        if register < self.splats {
            return self.value(Step::Splat(register));
        }
        if let Some(value) = self.held.get(&register) {
            return *value;
        }
        let value = self.value(Step::Register(register));
        self.held.insert(register, value);
        value
    }

    /// Puts a value into a register, which holds no splat.
    pub fn write(&mut self, register: u32, value: Value) {
        assert!(register >= self.splats, "register {register} holds a splat");
        self.registers = self.registers.max(register.saturating_add(1));
        self.held.insert(register, value);
        self.writes.push(Write { after: self.steps.len(), register, value });
    }

    /// Drops what nothing reads after the block: writes to registers for which `is_live` does not hold.
    pub fn retain_live(&mut self, is_live: impl Fn(u32) -> bool) {
        self.writes.retain(|write| is_live(write.register));
    }

    /// The last write of each register, in order.
    pub(super) fn last_writes(&self) -> Vec<Write> {
        let mut seen = HashSet::new();
        let mut last: Vec<Write> =
            self.writes.iter().rev().filter(|write| seen.insert(write.register)).copied().collect();
        last.reverse();
        last
    }

    /// The value of what a register held at the beginning, if a step needs it.
    pub(super) fn initial(&self, register: u32) -> Option<Value> {
        self.numbers.get(&Step::Register(register)).copied()
    }

    /// How many registers it addresses.
    pub(super) fn registers(&self) -> u32 {
        self.registers
    }

    /// How many splats it addresses.
    pub(super) fn splats(&self) -> u32 {
        self.splats
    }
}
