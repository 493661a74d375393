//! What a draw computes once: values that depend on constants and uniform words only.
//!
//! Such a value is one word, not 64: the preamble is a list of scalar steps, each giving a word.
//! Operations are pure and total, so a value can move here from under any control flow.

use crate::ir::{Expr, FunctionTable, Module, Op, Value};
use std::collections::HashMap;

/// A word of the preamble, computed from words before it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Step {
    Const(u32),
    Uniform(u32),
    UniformAt { base: u32, len: u32, index: u32 },
    Op { op: Op, args: [u32; 3] },
    Tabulated { table: FunctionTable, of: u32 },
}

/// The steps, and which value of the module each is.
#[derive(Debug, Default)]
pub(super) struct Preamble {
    steps: Vec<Step>,
    known: HashMap<Step, u32>,
    of_value: HashMap<Value, u32>,
}

/// The word of a draw's uniform words that an index reaches. Words that are missing are zero.
pub(super) fn uniform_at(uniforms: &[u32], base: u32, len: u32, index: u32) -> u32 {
    let word = u64::from(base) + u64::from(index.min(len - 1));
    usize::try_from(word).ok().and_then(|word| uniforms.get(word)).copied().unwrap_or(0)
}

impl Preamble {
    /// The word of `value`, if it is the same in every lane of the draw. The operands of an
    /// operation are looked up, so values are asked for in the order of their evaluation.
    pub fn word(&mut self, module: &Module, value: Value) -> Option<u32> {
        if let Some(&word) = self.of_value.get(&value) {
            return Some(word);
        }
        let step = match module.expr(value) {
            Expr::Const { bits, .. } => Step::Const(*bits),
            Expr::Uniform { word, .. } => Step::Uniform(*word),
            Expr::UniformAt { base, len, index, .. } => {
                Step::UniformAt { base: *base, len: *len, index: self.operand(module, *index)? }
            }
            Expr::Op { op, args } => {
                let mut words = [0; 3];
                for (word, arg) in words.iter_mut().zip(&args[..op.args().len()]) {
                    *word = self.operand(module, *arg)?;
                }
                Step::Op { op: *op, args: words }
            }
            Expr::Tabulated { value, table } => {
                Step::Tabulated { table: table.clone(), of: self.operand(module, *value)? }
            }
            Expr::Input(_)
            | Expr::Load(_)
            | Expr::LoadAt { .. }
            | Expr::Derivative { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => return None,
        };
        let word = self.step(step);
        self.of_value.insert(value, word);
        Some(word)
    }

    /// The word of a value that was asked for before, if it has one.
    pub fn word_of(&self, value: Value) -> Option<u32> {
        self.of_value.get(&value).copied()
    }

    /// The word of a constant.
    pub fn constant(&mut self, bits: u32) -> u32 {
        self.step(Step::Const(bits))
    }

    fn step(&mut self, step: Step) -> u32 {
        *self.known.entry(step).or_insert_with_key(|step| {
            self.steps.push(step.clone());
            self.steps.len() as u32 - 1
        })
    }

    /// As [`Self::word`], without going deeper than constants and uniform words.
    fn operand(&mut self, module: &Module, value: Value) -> Option<u32> {
        match module.expr(value) {
            Expr::Const { .. } | Expr::Uniform { .. } => self.word(module, value),
            Expr::Input(_)
            | Expr::UniformAt { .. }
            | Expr::Load(_)
            | Expr::LoadAt { .. }
            | Expr::Op { .. }
            | Expr::Derivative { .. }
            | Expr::Tabulated { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => self.of_value.get(&value).copied(),
        }
    }

    /// Every word, given the draw's uniform words.
    pub fn run(&self, uniforms: &[u32]) -> Vec<u32> {
        let mut words = Vec::with_capacity(self.steps.len());
        for step in &self.steps {
            words.push(match step {
                Step::Const(bits) => *bits,
                &Step::Uniform(word) => uniforms.get(word as usize).copied().unwrap_or(0),
                &Step::UniformAt { base, len, index } => {
                    uniform_at(uniforms, base, len, words[index as usize])
                }
                Step::Op { op, args } => op.eval(args.map(|word| words[word as usize])),
                Step::Tabulated { table, of } => table.word(f32::from_bits(words[*of as usize])),
            });
        }
        words
    }

    /// Whether any word depends on uniform words.
    pub fn reads_uniforms(&self) -> bool {
        self.steps.iter().any(|step| match step {
            Step::Uniform(_) | Step::UniformAt { .. } => true,
            Step::Const(_) | Step::Op { .. } | Step::Tabulated { .. } => false,
        })
    }

    /// How many operations the draw does once instead of once a batch.
    pub fn operations(&self) -> usize {
        self.steps
            .iter()
            .filter(|step| match step {
                Step::Op { .. } | Step::UniformAt { .. } | Step::Tabulated { .. } => true,
                Step::Const(_) | Step::Uniform(_) => false,
            })
            .count()
    }
}
