//! What is known of a draw before it runs: uniform values that are 0 or 1, and what textures give. A program that is
//! compiled for them leaves out what they decide: branches, products with 0, lookups that nothing reads then.
//!
//! Only which values are 0 or 1 matters, not what the others are, so that a uniform that changes from draw to draw
//! needs few programs.

use super::optimize::byte_functions;
use super::preamble::Preamble;
use crate::ir::{Access, Expr, Module, Op, Stmt, TRUE, Ty, Value};
use std::sync::Arc;
use texunit::plan::{AlphaFact, ComponentsFact, LookupFacts, SamplePlan};

/// No program looks at more uniform values.
const MAX_SOURCES: usize = 64;

/// The bits of 1.
const ONE: u32 = 0x3f80_0000;

/// A value that is the same in all lanes of a draw, and used by one that is not, or by a branch.
#[derive(Clone, Copy, Debug)]
struct Source {
    value: Value,
    /// Its word of the preamble.
    word: u32,
    ty: Ty,
}

/// What facts of a module are of.
#[derive(Debug, Default)]
pub(crate) struct FactSources {
    values: Vec<Source>,
    /// The texture slots of which the module computes functions that could be tables, bit by slot.
    function_slots: u64,
}

/// What is known of a draw.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Facts {
    /// By source: its word, if it is 0 or 1.
    words: Vec<Option<u32>>,
    /// The texture slots whose lookups give numbers from 0 to 1, bit by slot.
    fractions: u64,
    /// The texture slots whose alpha is 1, bit by slot.
    opaque: u64,
    /// The texture slots whose lookups give bytes over 255, of those that the module computes functions of; bit by slot.
    bytes: u64,
}

impl FactSources {
    /// Those of a module, of which the preamble has the words.
    pub(super) fn of(module: &Module, preamble: &Preamble) -> Self {
        let function_slots = byte_functions::slots(module);
        let mut sources = Self { function_slots, values: Vec::new() };
        module
            .body
            .iter()
            .for_each(|stmt| stmt.walk(&mut |stmt| sources.add(module, preamble, stmt)));
        sources
    }

    fn add(&mut self, module: &Module, preamble: &Preamble, stmt: &Stmt) {
        match stmt {
            Stmt::Eval(value) if preamble.word_of(*value).is_none() => {
                let expr = module.expr(*value);
                if let Expr::Op { op, args } = expr {
                    args[..op.args().len()]
                        .iter()
                        .for_each(|arg| self.add_value(module, preamble, *arg));
                }
            }
            Stmt::If { condition, .. } => self.add_value(module, preamble, *condition),
            Stmt::Store { value, .. } | Stmt::StoreAt { value, .. } => {
                self.add_value(module, preamble, *value);
            }
            Stmt::Eval(_)
            | Stmt::Loop { .. }
            | Stmt::Scope(_)
            | Stmt::Break
            | Stmt::Continue
            | Stmt::Leave
            | Stmt::Discard
            | Stmt::EmitVertex(_)
            | Stmt::EndPrimitive => {}
        }
    }

    fn add_value(&mut self, module: &Module, preamble: &Preamble, value: Value) {
        let is_known = self.values.iter().any(|source| source.value == value);
        if is_known || self.values.len() == MAX_SOURCES || module.constant(value).is_some() {
            return;
        }
        if let Some(word) = preamble.word_of(value) {
            self.values.push(Source { value, word, ty: module.ty(value) });
        }
    }

    /// The facts of a draw with these words of the preamble and these textures, of which the program samples some slots.
    pub fn facts(
        &self,
        words: &[u32],
        slots: &[u32],
        textures: &[Option<Arc<SamplePlan>>],
    ) -> Facts {
        let known = |source: &Source| {
            let bits = words.get(source.word as usize).copied()?;
            let one = match source.ty {
                Ty::F32 => ONE,
                Ty::Bool => TRUE,
                Ty::I32 | Ty::U32 => 1,
            };
            (bits == 0 || bits == one).then_some(bits)
        };
        let mut facts = Facts { words: self.values.iter().map(known).collect(), ..Facts::NONE };
        for &slot in slots.iter().filter(|slot| **slot < u64::BITS) {
            let plan = textures.get(slot as usize).and_then(Option::as_ref);
            let LookupFacts { components, alpha } =
                plan.map_or(LookupFacts::OF_INCOMPLETE, |plan| plan.lookup_facts());
            let (is_fraction, is_byte) = match components {
                ComponentsFact::Bytes => (true, true),
                ComponentsFact::Fractions => (true, false),
                ComponentsFact::Any => (false, false),
            };
            facts.fractions |= u64::from(is_fraction) << slot;
            facts.bytes |= u64::from(is_byte) << slot & self.function_slots;
            facts.opaque |= u64::from(alpha == AlphaFact::One) << slot;
        }
        facts
    }

    /// The module with the values that are known as constants.
    pub fn apply(&self, facts: &Facts, module: &Module) -> Module {
        let mut module = module.clone();
        for (source, bits) in self.values.iter().zip(&facts.words) {
            if let Some(bits) = *bits {
                module.values[source.value.0 as usize] = Expr::Const { bits, ty: source.ty };
            }
        }
        module
    }
}

impl Facts {
    /// Nothing is known.
    pub const NONE: Self = Self { words: Vec::new(), fractions: 0, opaque: 0, bytes: 0 };

    /// Whether nothing is known that a program could be compiled for.
    pub fn is_empty(&self) -> bool {
        self.opaque == 0 && self.bytes == 0 && self.words.iter().all(Option::is_none)
    }

    /// In words.
    pub fn describe(&self) -> String {
        let known = |bits: u32| {
            self.words.iter().flatten().filter(|word| (**word == 0) == (bits == 0)).count()
        };
        format!(
            "compiled for {} uniform values that are 0, {} that are 1, {} textures whose alpha is 1, {} whose texels are \
             bytes",
            known(0),
            known(1),
            self.opaque.count_ones(),
            self.bytes.count_ones()
        )
    }

    /// Whether a value is component 3 of a lookup whose alpha is 1.
    pub fn is_opaque_alpha(&self, module: &Module, sample: Value, component: u8) -> bool {
        component == 3 && self.is_filtered_of(module, sample, self.opaque)
    }

    /// Whether a value is a component of a lookup that gives bytes over 255.
    pub fn is_byte(&self, module: &Module, value: Value) -> bool {
        let Expr::Component { sample, .. } = module.expr(value) else { return false };
        self.is_filtered_of(module, *sample, self.bytes)
    }

    /// Whether a sample is a filtered lookup in one of some slots, bit by slot.
    fn is_filtered_of(&self, module: &Module, sample: Value, slots: u64) -> bool {
        filtered_slot(module, sample).is_some_and(|slot| slots >> slot & 1 == 1)
    }

    /// A bound of a value that is known to be a number from +0 to it: no infinity, no NaN, no negative zero.
    pub fn bound(&self, module: &Module, value: Value) -> Option<f32> {
        self.bound_within(module, value, MAX_DEPTH)
    }

    fn bound_within(&self, module: &Module, value: Value, depth: u32) -> Option<f32> {
        let depth = depth.checked_sub(1)?;
        let of = |value: &Value| self.bound_within(module, *value, depth);
        let bound = match module.expr(value) {
            Expr::Const { bits, ty: Ty::F32 } => {
                let number = f32::from_bits(*bits);
                (number.is_sign_positive() && number.is_finite()).then_some(number)
            }
            Expr::Component { sample, .. } => {
                self.is_filtered_of(module, *sample, self.fractions).then_some(1.0)
            }
            // Rounding is monotonic, so that a bound of exact results bounds rounded ones.
            Expr::Op { op: Op::Mul, args: [a, b, _] } => of(a).zip(of(b)).map(|(a, b)| a * b),
            Expr::Op { op: Op::Add, args: [a, b, _] } => of(a).zip(of(b)).map(|(a, b)| a + b),
            Expr::Op { .. }
            | Expr::Const { .. }
            | Expr::Input(_)
            | Expr::Uniform { .. }
            | Expr::UniformAt { .. }
            | Expr::Load(_)
            | Expr::LoadAt { .. }
            | Expr::Derivative { .. }
            | Expr::Tabulated { .. }
            | Expr::Sample(_) => None,
        };
        bound.filter(|bound| bound.is_finite())
    }
}

/// The texture slot of a sample that is a filtered lookup of numbers, below 64.
pub(super) fn filtered_slot(module: &Module, sample: Value) -> Option<u32> {
    let Expr::Sample(sample) = module.expr(sample) else { return None };
    // Facts are of numbers; components of integers are bits.
    let is_filtered =
        matches!(sample.access, Access::Filter { .. }) && module.component_ty(sample) == Ty::F32;
    Some(sample.texture.0).filter(|slot| is_filtered && *slot < u64::BITS)
}

/// So deep are expressions looked through.
const MAX_DEPTH: u32 = 6;
