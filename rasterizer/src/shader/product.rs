//! Programs that compute a product: each colour is one or several texels times at most one more factor, as most
//! fixed-function texturing does. `raster/texel_product.rs` multiplies the texels without the interpreter, by the
//! same numbers in the same order.

use super::allocate::Layout;
use super::compute::{Compute, OPERANDS};
use super::inst::{Inst, Reg, Role, SampleInst, SampleLod};
use super::repeated_lookups::Repeat;
use crate::ir::{Access, Output};

/// The most instructions before the lookups; programs with more use the interpreter.
const MAX_CODE_BEFORE: usize = 16;

/// What a product is made of.
#[derive(Debug)]
pub struct TexelProduct {
    /// The first factors of red, green, blue and alpha; `None` is 1.
    pub(super) factors: [Option<Reg>; 4],
    /// The lookups in the order in which they are multiplied.
    pub(super) lookups: Vec<SampleInst>,
    /// The code that computes the factors and the operands of the lookups from splats and inputs.
    pub(super) before: Vec<Inst>,
    /// The part of `before` that the factors need.
    pub(super) before_factors: Vec<Inst>,
    /// The part of `before` that the lookups need.
    pub(super) before_lookups: Vec<Inst>,
    /// Which inputs of the program its factors depend on.
    pub factor_inputs: Vec<usize>,
    /// Which inputs of the program its lookups depend on.
    pub lookup_inputs: Vec<usize>,
    /// Which of them its levels of detail depend on, if they depend on nothing else, and nothing else on them:
    /// not on the differences of coordinates.
    pub lod_inputs: Option<Vec<usize>>,
}

/// A part of the code before the lookups.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProductCode {
    /// What the factors need.
    Factors,
    /// What the lookups need.
    Lookups,
    /// All of it.
    Whole,
}

impl TexelProduct {
    /// What straight code computes, if that is a product, and if there are four colours and nothing else. Gives the
    /// layout the registers that it needs.
    pub(super) fn of(
        code: &[Inst],
        layout: &mut Layout,
        mut outputs: impl Iterator<Item = Output>,
    ) -> Option<Self> {
        let mut matcher =
            ProductMatcher { first_written: layout.first_written, ..ProductMatcher::default() };
        for inst in code {
            matcher.add(inst)?;
        }
        let mut colors = [const { None }; 4];
        for &reg in &layout.outputs {
            match (outputs.next()?, matcher.value(Reg(reg))?) {
                (Output::Color { target: 0, component }, Value::TexelProduct(product)) => {
                    colors[usize::from(component)] = Some(product);
                }
                (_, _) => return None,
            }
        }
        let [Some(r), Some(g), Some(b), Some(a)] = colors else { return None };
        let colors = [r, g, b, a];
        let lookups = colors[0].lookups.clone();
        let belongs = |(component, color): (usize, &TexelTerm)| {
            color.component == component && color.lookups == lookups
        };
        if !colors.iter().enumerate().all(belongs) {
            return None;
        }
        let factors = colors.each_ref().map(|color| color.factor);
        let lookups: Vec<SampleInst> =
            lookups.iter().map(|&at| matcher.lookups[at].clone()).collect();
        let read_by_lookups: Vec<Reg> = lookups.iter().flat_map(read_by).collect();
        layout.registers = layout.registers.max(layout.first_written + matcher.before.len() as u32);
        let read_by_factors: Vec<Reg> = factors.into_iter().flatten().collect();
        let before_factors = needed(&matcher.before, read_by_factors.clone());
        let before_lookups = needed(&matcher.before, read_by_lookups.clone());
        let of = |read: Vec<Reg>| inputs(layout, read.clone(), &needed(&matcher.before, read));
        let mut read_by_others = read_by_factors.clone();
        read_by_others.extend(lookups.iter().flat_map(|sample| sample.coords));
        let read_by_others = of(read_by_others);
        let mut read_by_lods = Vec::new();
        for sample in &lookups {
            sample.lod.clone().reads(|reg| read_by_lods.push(*reg));
        }
        let lod_inputs = of(read_by_lods);
        let are_separate = lod_inputs.iter().all(|input| !read_by_others.contains(input))
            && lookups.iter().all(|sample| !matches!(sample.lod, SampleLod::Implicit { .. }));
        let lod_inputs = are_separate.then_some(lod_inputs);
        Some(Self {
            factor_inputs: inputs(layout, read_by_factors, &before_factors),
            lookup_inputs: inputs(layout, read_by_lookups, &before_lookups),
            lod_inputs,
            before: matcher.before,
            before_factors,
            before_lookups,
            factors,
            lookups,
        })
    }

    /// The textures' slots.
    pub fn textures(&self) -> impl Iterator<Item = u32> {
        self.lookups.iter().map(|sample| sample.texture)
    }

    /// The texture's slot of a lookup.
    #[inline(always)]
    pub fn texture(&self, at: usize) -> usize {
        self.lookups[at].texture as usize
    }

    /// The pair of a lookup and the one before, if both have the same operands.
    pub(crate) fn repeat(&self, at: usize) -> Option<Repeat> {
        match &self.lookups[..=at] {
            [.., before, here] => Repeat::of(before, here),
            [_] | [] => None,
        }
    }

    /// How many lookups there are, at least one.
    pub fn lookups(&self) -> usize {
        self.lookups.len()
    }
}

/// What a register holds.
#[derive(Clone, Debug)]
enum Value {
    /// A splat, an input, or a number computed before the lookups.
    Number(Reg),
    TexelProduct(TexelTerm),
}

/// Lookups and a factor.
#[derive(Clone, Debug)]
struct TexelTerm {
    factor: Option<Reg>,
    /// By number.
    lookups: Vec<usize>,
    /// Of all lookups.
    component: usize,
}

impl TexelTerm {
    /// The lookup, if it is a lookup by itself.
    fn texel(&self) -> Option<usize> {
        match (self.factor, &self.lookups[..]) {
            (None, [lookup]) => Some(*lookup),
            (_, _) => None,
        }
    }

    /// Times a lookup by itself.
    fn multiplied(mut self, other: &Self) -> Option<Self> {
        let lookup = other.texel()?;
        let is_new = !self.lookups.contains(&lookup);
        self.lookups.push(lookup);
        (is_new && self.component == other.component).then_some(self)
    }
}

/// A program so far, its parts sorted.
#[derive(Default)]
struct ProductMatcher {
    /// The first register that the program writes; those below are splats and inputs.
    first_written: u32,
    /// What the registers hold that it has written.
    written: Vec<(Reg, Value)>,
    /// Instructions before the lookups. Each has a register of its own, from `first_written` on.
    before: Vec<Inst>,
    lookups: Vec<SampleInst>,
}

impl ProductMatcher {
    /// Adds the next instruction; `None` if the program is no product.
    fn add(&mut self, inst: &Inst) -> Option<()> {
        if let Inst::Sample(sample) = inst {
            return self.add_lookup(sample);
        }
        // Nothing else is part of a product.
        let (out, value) = if let Inst::Compute { what, out, args } = *inst {
            (out, self.compute(what, args)?)
        } else if let Inst::Move { out, from } = *inst {
            (out, self.value(from)?)
        } else {
            return None;
        };
        self.set(out, value);
        Some(())
    }

    fn add_lookup(&mut self, sample: &SampleInst) -> Option<()> {
        let filters = sample.access == Access::Filter { offset: [0; 3] };
        if !filters || sample.layer.is_some() || sample.reference.is_some() {
            return None;
        }
        let mut moved = sample.clone();
        let mut are_numbers = true;
        moved.reads(|reg| match self.value(*reg) {
            Some(Value::Number(number)) => *reg = number,
            Some(Value::TexelProduct(_)) | None => are_numbers = false,
        });
        if !are_numbers {
            return None;
        }
        let number = self.lookups.len();
        self.lookups.push(moved);
        for (component, out) in sample.out.iter().enumerate() {
            let term = TexelTerm { factor: None, lookups: vec![number], component };
            out.iter().for_each(|&out| self.set(out, Value::TexelProduct(term.clone())));
        }
        Some(())
    }

    /// What an instruction makes of its operands.
    fn compute(&mut self, what: Compute, args: [Reg; OPERANDS]) -> Option<Value> {
        let mut numbers = args;
        let (read, rest) = numbers.split_at_mut(what.arity());
        let are_numbers = read.iter_mut().all(|arg| match self.value(*arg) {
            Some(Value::Number(number)) => {
                *arg = number;
                true
            }
            Some(Value::TexelProduct(_)) | None => false,
        });
        if are_numbers {
            rest.fill(read[0]);
            return self.number(what, numbers);
        }
        // Trees that end in a product are taken apart.
        let [a, b, c, d, ..] = args;
        let (first, last) = if matches!(what, Compute::Mul | Compute::MulUniform) {
            (self.value(a)?, b)
        } else if what == Compute::MulMul {
            (self.compute(Compute::Mul, padded([a, b, b]))?, c)
        } else if what == Compute::ClampMul {
            (self.compute(Compute::Clamp, padded([a, b, c]))?, d)
        } else {
            return None;
        };
        self.product(first, self.value(last)?)
    }

    /// Computes a number before the lookups.
    fn number(&mut self, what: Compute, args: [Reg; OPERANDS]) -> Option<Value> {
        if self.before.len() == MAX_CODE_BEFORE {
            return None;
        }
        let out = Reg(self.first_written + self.before.len() as u32);
        self.before.push(Inst::Compute { what, out, args });
        Some(Value::Number(out))
    }

    /// The product of two values that are not both numbers, in any order.
    fn product(&self, first: Value, second: Value) -> Option<Value> {
        let product = match (first, second) {
            (Value::Number(factor), Value::TexelProduct(term))
            | (Value::TexelProduct(term), Value::Number(factor)) => {
                let is_first = term.factor.is_none() && term.lookups.len() == 1;
                is_first.then_some(TexelTerm { factor: Some(factor), ..term })
            }
            (Value::TexelProduct(first), Value::TexelProduct(second)) => match second.texel() {
                Some(_) => first.multiplied(&second),
                None => second.multiplied(&first),
            },
            (Value::Number(_), Value::Number(_)) => None,
        };
        product.map(Value::TexelProduct)
    }

    fn value(&self, reg: Reg) -> Option<Value> {
        if reg.0 < self.first_written {
            return Some(Value::Number(reg));
        }
        let written = self.written.iter().find(|(written, _)| *written == reg);
        written.map(|(_, value)| value.clone())
    }

    fn set(&mut self, reg: Reg, value: Value) {
        self.written.retain(|(written, _)| *written != reg);
        self.written.push((reg, value));
    }
}

/// Unused operands repeat the last.
fn padded(args: [Reg; 3]) -> [Reg; OPERANDS] {
    std::array::from_fn(|at| args[at.min(2)])
}

/// The registers that a lookup reads.
fn read_by(sample: &SampleInst) -> Vec<Reg> {
    let mut read = Vec::new();
    sample.clone().reads(|reg| read.push(*reg));
    read
}

/// The registers that an instruction reads.
fn operands(inst: &Inst) -> Vec<Reg> {
    let mut read = Vec::new();
    inst.clone().operands(&mut |reg, role| {
        if role == Role::Read {
            read.push(*reg);
        }
    });
    read
}

/// The instructions that these registers depend on. Each writes a register of its own.
fn needed(code: &[Inst], mut wanted: Vec<Reg>) -> Vec<Inst> {
    let mut needed = Vec::new();
    for inst in code.iter().rev() {
        let mut is_wanted = false;
        inst.clone().operands(&mut |reg, role| {
            is_wanted |= role == Role::Write && wanted.contains(reg);
        });
        if is_wanted {
            wanted.extend(operands(inst));
            needed.push(inst.clone());
        }
    }
    needed.reverse();
    needed
}

/// The inputs among these registers and those that the code reads, as numbers of inputs.
fn inputs(layout: &Layout, registers: Vec<Reg>, code: &[Inst]) -> Vec<usize> {
    let read = registers.into_iter().chain(code.iter().flat_map(operands));
    let is_input = |reg: &Reg| (layout.inputs..layout.first_written).contains(&reg.0);
    read.filter(is_input).map(|reg| (reg.0 - layout.inputs) as usize).collect()
}
