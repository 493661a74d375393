//! The uniform words of a program: state, and rows of four for everything else.

use super::program::{Parameter, Word};
use crate::interface::{StateBinding, StateVar};
use rasterizer::ir::{Builder, Ty, Value};

/// The source of the words of a row at a draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Row {
    /// `program.env[n]`.
    Env(u16),
    /// `program.local[n]`.
    Local(u16),
    /// Other words of the program, which are state; `None` keeps what is there.
    Words([Option<u32>; 4]),
}

/// The words of a program.
#[derive(Clone, Debug, Default)]
pub(crate) struct Layout {
    /// What the words are before anything is filled in.
    pub initial: Vec<u32>,
    pub state: Vec<StateBinding>,
    /// Rows, by their first words.
    pub rows: Vec<(u32, Row)>,
    /// The rows of parameters that no array holds.
    single: Vec<(u32, Row)>,
    /// The arrays that are there, by number, and their first words.
    arrays: Vec<(u16, u32)>,
}

impl Layout {
    /// How many words there are.
    pub fn len(&self) -> u32 {
        self.initial.len() as u32
    }

    fn add(&mut self, count: u32) -> u32 {
        let first = self.len();
        self.initial.resize((first + count) as usize, 0);
        first
    }

    /// The first word of a piece of state.
    pub fn state(&mut self, var: StateVar) -> u32 {
        match self.state.iter().find(|binding| binding.var == var) {
            Some(binding) => binding.word,
            None => {
                let word = self.add(var.words());
                self.state.push(StateBinding { var, word });
                word
            }
        }
    }

    /// A word that never changes.
    pub fn constant(&mut self, value: u32) -> u32 {
        let word = self.add(1);
        self.initial[word as usize] = value;
        word
    }

    /// The row of a parameter that no array holds.
    fn single(&mut self, row: Row) -> u32 {
        if let Some((word, _)) = self.single.iter().find(|(_, known)| *known == row) {
            return *word;
        }
        let word = self.add(4);
        self.rows.push((word, row));
        self.single.push((word, row));
        word
    }

    /// A parameter that is named by a constant.
    pub fn parameter(&mut self, b: &mut Builder, parameter: Parameter) -> [Value; 4] {
        let first = match parameter {
            Parameter::Constant(values) => return values.map(|value| b.float(value)),
            Parameter::State(words) => {
                return words.map(|word| match word {
                    Word::Of(var, word) => {
                        let first = self.state(var);
                        b.uniform(first + u32::from(word), Ty::F32)
                    }
                    Word::Is(value) => b.float(value),
                });
            }
            Parameter::Env(number) => self.single(Row::Env(number)),
            Parameter::Local(number) => self.single(Row::Local(number)),
        };
        [0, 1, 2, 3].map(|component| b.uniform(first + component, Ty::F32))
    }

    /// The first word of an array, whose rows follow one another.
    pub fn array(&mut self, number: u16, elements: &[Parameter]) -> u32 {
        if let Some((_, word)) = self.arrays.iter().find(|(known, _)| *known == number) {
            return *word;
        }
        let first = self.add(4 * elements.len() as u32);
        self.arrays.push((number, first));
        for (word, element) in (first..).step_by(4).zip(elements) {
            let (row, numbers) = match *element {
                Parameter::Constant(values) => (None, values.map(Some)),
                Parameter::Env(number) => (Some(Row::Env(number)), [None; 4]),
                Parameter::Local(number) => (Some(Row::Local(number)), [None; 4]),
                Parameter::State(words) => {
                    let from = words.map(|word| match word {
                        Word::Of(var, word) => Some(self.state(var) + u32::from(word)),
                        Word::Is(_) => None,
                    });
                    let numbers = words.map(|word| match word {
                        Word::Of(..) => None,
                        Word::Is(value) => Some(value),
                    });
                    (Some(Row::Words(from)), numbers)
                }
            };
            self.rows.extend(row.map(|row| (word, row)));
            for (at, value) in numbers.into_iter().enumerate() {
                if let Some(value) = value {
                    self.initial[word as usize + at] = value.to_bits();
                }
            }
        }
        first
    }
}
