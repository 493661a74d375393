//! Vector registers for the values of a block, and its code.
//!
//! One pass in the order of the steps. A value is in a vector register from its step to its last use; where registers
//! run out, the value whose next use is farthest leaves its register. It comes back from where it was loaded, from the
//! register that holds it since, or from a slot on the stack.

use super::Target;
use super::block::{Block, Step, Value, Write};
use super::encode::{Assembler, Location, Source, Vector};

/// Slots on the stack. They stay within the page that a function may touch without a probe.
const MAX_SPILLS: u32 = 32;

/// Where a value is.
#[derive(Clone, Debug, Default)]
struct Placement {
    vector: Option<Vector>,
    memory: Option<Location>,
    /// The positions of its uses, the next one last.
    uses: Vec<u32>,
}

struct Compiler<'a> {
    block: &'a Block,
    writes: &'a [Write],
    assembler: Assembler,
    /// By step.
    values: Vec<Placement>,
    /// By vector register.
    occupants: Vec<Option<Value>>,
    /// Vector registers that the current step reads.
    pinned: Vec<Vector>,
    spills: u32,
}

/// Appends the code of a block.
pub fn compile(block: &Block, target: Target, bytes: &mut Vec<u8>) -> Option<()> {
    let writes = block.last_writes();
    let mut compiler = Compiler::new(block, &writes, target);
    let mut head = compiler.run(0)?;
    let spills = compiler.spills;
    if spills > 0 {
        // How many slots it needs is known only afterwards.
        compiler = Compiler::new(block, &writes, target);
        head = compiler.run(spills)?;
    }
    bytes.extend(compiler.assembler.end(head, spills)?);
    Some(())
}

impl<'a> Compiler<'a> {
    fn new(block: &'a Block, writes: &'a [Write], target: Target) -> Self {
        Self {
            block,
            writes,
            assembler: Assembler::new(target),
            values: uses(block, writes),
            occupants: vec![None; usize::from(target.vectors())],
            pinned: Vec::new(),
            spills: 0,
        }
    }

    fn run(&mut self, spills: u32) -> Option<u64> {
        let head = self.assembler.begin(spills)?;
        let mut writes = self.writes.iter().peekable();
        for (at, step) in self.block.steps.iter().enumerate() {
            while let Some(write) = writes.next_if(|write| write.after <= at) {
                self.write(write.register, write.value)?;
            }
            if !self.values[at].uses.is_empty() {
                self.step(Value(at as u32), *step)?;
            }
        }
        for write in writes {
            self.write(write.register, write.value)?;
        }
        (self.spills <= MAX_SPILLS).then_some(head)
    }

    fn step(&mut self, value: Value, step: Step) -> Option<()> {
        match step {
            Step::Register(register) => self.is_at(value, Location::Register(register)),
            Step::Splat(splat) => self.is_at(value, Location::Splat(splat)),
            Step::Mask => self.is_at(value, Location::Mask),
            // Made where it is used.
            Step::Constant(_) => {}
            Step::Unary(op, a) => {
                let from = self.operand(a)?;
                self.used(a);
                let to = self.result(value)?;
                self.assembler.unary(op, to, from)?;
            }
            Step::Binary(op, a, b) => {
                let from = self.operand(a)?;
                let source = self.source(b)?;
                self.used(a);
                self.used(b);
                let to = self.result(value)?;
                self.assembler.binary(op, to, from, source)?;
            }
            Step::Select(mask, b, c) => {
                let [mask_vector, b_vector, c_vector] =
                    [self.operand(mask)?, self.operand(b)?, self.operand(c)?];
                // The result may take the place of the mask alone.
                self.used(mask);
                let to = self.result(value)?;
                self.used(b);
                self.used(c);
                self.assembler.select(to, mask_vector, b_vector, c_vector)?;
            }
        }
        self.pinned.clear();
        Some(())
    }

    fn is_at(&mut self, value: Value, location: Location) {
        self.values[value.0 as usize].memory = Some(location);
    }

    /// The vector register of an operand, loaded if it is not there.
    fn operand(&mut self, value: Value) -> Option<Vector> {
        let placement = &self.values[value.0 as usize];
        let vector = match placement.vector {
            Some(vector) => vector,
            None => {
                let memory = placement.memory;
                let vector = self.vacant()?;
                match (memory, self.block.steps[value.0 as usize]) {
                    (_, Step::Constant(word)) => self.assembler.constant(vector, word)?,
                    (Some(memory), _) => self.assembler.load(vector, memory)?,
                    (None, _) => return None,
                }
                self.occupy(vector, value);
                vector
            }
        };
        self.pinned.push(vector);
        Some(vector)
    }

    /// The second operand of an operation: from memory if it is used nowhere else.
    fn source(&mut self, value: Value) -> Option<Source> {
        let placement = &self.values[value.0 as usize];
        match (placement.vector, placement.memory) {
            (None, Some(memory)) if placement.uses.len() == 1 && self.assembler.folds(memory) => {
                Some(Source::Memory(memory))
            }
            (Some(_) | None, _) => self.operand(value).map(Source::Vector),
        }
    }

    /// Counts a use; after the last one the vector register is free.
    fn used(&mut self, value: Value) {
        let placement = &mut self.values[value.0 as usize];
        placement.uses.pop();
        if placement.uses.is_empty()
            && let Some(vector) = placement.vector.take()
        {
            self.occupants[usize::from(vector.0)] = None;
            self.pinned.retain(|pinned| *pinned != vector);
        }
    }

    fn result(&mut self, value: Value) -> Option<Vector> {
        let vector = self.vacant()?;
        self.occupy(vector, value);
        Some(vector)
    }

    fn occupy(&mut self, vector: Vector, value: Value) {
        self.occupants[usize::from(vector.0)] = Some(value);
        self.values[value.0 as usize].vector = Some(vector);
    }

    /// A vector register that is free, or freed.
    fn vacant(&mut self) -> Option<Vector> {
        if let Some(free) = self.occupants.iter().position(Option::is_none) {
            return Some(Vector(free as u8));
        }
        let next_use = |value: &Value| self.values[value.0 as usize].uses.last().copied();
        let vectors = self.occupants.iter().enumerate();
        let candidates = vectors.filter_map(|(number, occupant)| {
            let vector = Vector(number as u8);
            let value = occupant.filter(|_| !self.pinned.contains(&vector))?;
            Some((next_use(&value), vector, value))
        });
        let (_, vector, value) = candidates.max_by_key(|&(next, ..)| next)?;
        let placement = &mut self.values[value.0 as usize];
        placement.vector = None;
        let is_constant = matches!(self.block.steps[value.0 as usize], Step::Constant(_));
        if placement.memory.is_none() && !is_constant {
            let slot = Location::Spill(self.spills);
            placement.memory = Some(slot);
            self.spills += 1;
            self.assembler.store(slot, vector)?;
        }
        self.occupants[usize::from(vector.0)] = None;
        Some(vector)
    }

    fn write(&mut self, register: u32, value: Value) -> Option<()> {
        let location = Location::Register(register);
        // Another value that is to be loaded from there is loaded before.
        if let Some(old) = self.block.initial(register) {
            let at = old.0 as usize;
            let placement = &self.values[at];
            if old != value && !placement.uses.is_empty() {
                if placement.vector.is_none() && placement.memory == Some(location) {
                    self.operand(old)?;
                }
                if self.values[at].memory == Some(location) {
                    self.values[at].memory = None;
                }
            }
        }
        let vector = self.operand(value)?;
        self.assembler.store(location, vector)?;
        self.values[value.0 as usize].memory = Some(location);
        self.used(value);
        self.pinned.clear();
        Some(())
    }
}

/// The uses of each value by steps and writes that are needed.
fn uses(block: &Block, writes: &[Write]) -> Vec<Placement> {
    let mut placements = vec![Placement::default(); block.steps.len()];
    // From the last step to the first, so that the next use comes to stand last.
    let mut writes = writes.iter().rev().peekable();
    let mut position = u32::MAX;
    for at in (0..block.steps.len()).rev() {
        while let Some(write) = writes.next_if(|write| write.after > at) {
            placements[write.value.0 as usize].uses.push(position);
            position -= 1;
        }
        if placements[at].uses.is_empty() {
            continue;
        }
        let operands = match block.steps[at] {
            Step::Register(_) | Step::Splat(_) | Step::Constant(_) | Step::Mask => continue,
            Step::Unary(_, a) => [Some(a), None, None],
            Step::Binary(_, a, b) => [Some(a), Some(b), None],
            Step::Select(a, b, c) => [Some(a), Some(b), Some(c)],
        };
        for value in operands.into_iter().flatten() {
            placements[value.0 as usize].uses.push(position);
        }
        position -= 1;
    }
    placements
}
