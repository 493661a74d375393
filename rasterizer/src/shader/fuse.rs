//! Several operations as one instruction: trees of the table of [`super::compute`] are looked for in the code, from
//! their last operation backwards.

use super::compute::{Compute, OPERANDS, OperandStorage, Tree};
use super::inst::{Inst, Reg, Role};
use super::lower::{Lowered, RegisterContent};
use crate::ir::Op;

/// Replaces trees of operations by fused instructions. The code is over virtual registers, each
/// temporary written once.
pub(super) fn run(lowered: &mut Lowered) {
    let mut definitions = Definitions::of(lowered);
    for at in (0..lowered.code.len()).rev() {
        let Inst::Compute { out, .. } = lowered.code[at] else { continue };
        if definitions.is_fused[at] {
            continue;
        }
        let best = Compute::TREES.iter().find_map(|(what, tree)| {
            let mut found = TreeMatch::default();
            let fits = found.node(&lowered.code, &definitions, at, tree);
            (fits && found.is_whole(&lowered.code, &definitions)).then_some((*what, found))
        });
        if let Some((what, found)) = best {
            let first = found.operands.iter().flatten().next().copied().unwrap_or(out);
            let args = found.operands.map(|operand| operand.unwrap_or(first));
            lowered.code[at] = Inst::Compute { what, out, args };
            for inner in found.inner {
                definitions.is_fused[inner] = true;
            }
        }
    }
    super::allocate::compact(lowered, &definitions.is_fused);
}

/// The definition of each temporary, and how often it is read.
struct Definitions {
    /// By virtual register.
    of: Vec<Option<usize>>,
    reads: Vec<u32>,
    /// By virtual register: whether it holds one value in all lanes.
    is_uniform: Vec<bool>,
    /// By instruction: the number of jumps, and places that are jumped to, before it.
    block: Vec<u32>,
    /// By instruction: whether it is fused into another.
    is_fused: Vec<bool>,
}

impl Definitions {
    fn of(lowered: &mut Lowered) -> Self {
        let count = lowered.contents.len();
        let (mut of, mut reads) = (vec![None; count], vec![0; count]);
        let mut block = Vec::with_capacity(lowered.code.len());
        let mut blocks = 0;
        for (at, inst) in lowered.code.iter_mut().enumerate() {
            // Whatever is jumped to stands behind or at one of these.
            blocks += u32::from(inst.is_control());
            block.push(blocks);
            inst.operands(&mut |reg, role| match role {
                Role::Read => reads[reg.0 as usize] += 1,
                Role::Write => {
                    if lowered.contents[reg.0 as usize] == RegisterContent::Temp {
                        of[reg.0 as usize] = Some(at);
                    }
                }
            });
        }
        let is_uniform = lowered
            .contents
            .iter()
            .map(|content| matches!(content, RegisterContent::Splat { .. }))
            .collect();
        Self { of, reads, is_uniform, block, is_fused: vec![false; lowered.code.len()] }
    }

    /// The operation of the same straight run of code that makes `reg`.
    fn definition(&self, reg: Reg, reader: usize) -> Option<usize> {
        let at = self.of[reg.0 as usize]?;
        (!self.is_fused[at] && self.block[at] == self.block[reader]).then_some(at)
    }
}

/// A tree that is being recognized.
#[derive(Clone, Debug, Default)]
struct TreeMatch {
    operands: [Option<Reg>; OPERANDS],
    /// The instructions that become part of the one at the root, once for each time they are read.
    inner: Vec<usize>,
}

impl TreeMatch {
    /// Whether the instruction at `at` is this tree's root.
    fn node(&mut self, code: &[Inst], definitions: &Definitions, at: usize, tree: &Tree) -> bool {
        let Tree::Node(wanted, trees) = tree else { return false };
        let Inst::Compute { what, args, .. } = &code[at] else { return false };
        if *what != Compute::from(*wanted) {
            return false;
        }
        let before = self.clone();
        if self.all(code, definitions, at, &args[..trees.len()], trees) {
            return true;
        }
        *self = before;
        // Which of two NaN comes out of a sum or product is the only thing their order decides.
        matches!(wanted, Op::Add | Op::Mul)
            && self.all(code, definitions, at, &[args[1], args[0]], trees)
    }

    fn all(
        &mut self,
        code: &[Inst],
        definitions: &Definitions,
        reader: usize,
        args: &[Reg],
        trees: &[Tree],
    ) -> bool {
        args.iter().zip(trees).all(|(&reg, tree)| match tree {
            Tree::Operand(operand, storage) => {
                let fits =
                    *storage == OperandStorage::PerLane || definitions.is_uniform[reg.0 as usize];
                fits && *self.operands[*operand].get_or_insert(reg) == reg
            }
            Tree::Node(..) => definitions.definition(reg, reader).is_some_and(|at| {
                let is_repeated = self.inner.contains(&at);
                self.inner.push(at);
                let read = self.inner.len();
                let fits = self.node(code, definitions, at, tree);
                if is_repeated {
                    self.inner.truncate(read);
                }
                fits
            }),
        })
    }

    /// Whether nothing else reads what the tree takes in. Of a node that occurs twice, an operation may be a node the one
    /// time and an operand the other time: the operand would have no value.
    fn is_whole(&self, code: &[Inst], definitions: &Definitions) -> bool {
        self.inner.iter().all(|inner| {
            let reads = self.inner.iter().filter(|other| *other == inner).count();
            matches!(code[*inner], Inst::Compute { out, .. }
                if definitions.reads[out.0 as usize] as usize == reads
                    && !self.operands.contains(&Some(out)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{Builder, Input, Interpolation, Output, Stage, Ty, Value};
    use crate::shader::Program;
    use crate::shader::tests::check;

    fn build(b: &mut Builder, tree: &Tree) -> Value {
        match tree {
            Tree::Operand(operand, OperandStorage::PerLane) => {
                b.input(Input::Varying(*operand as u16))
            }
            Tree::Operand(operand, OperandStorage::Uniform) => b.uniform(*operand as u32, Ty::F32),
            Tree::Node(op, trees) => {
                let args: Vec<Value> = trees.iter().map(|tree| build(b, tree)).collect();
                b.op(*op, &args)
            }
        }
    }

    /// `y + y` of `y = a (C - a)` looks like a mix of `a` and `C - a`, which is in it, too.
    #[test]
    fn what_is_taken_in_is_no_operand() {
        let mut b = Builder::new(Stage::Fragment);
        b.module_mut().varyings = vec![Interpolation::Smooth];
        let (a, c) = (b.input(Input::Varying(0)), b.uniform(0, Ty::F32));
        let rest = b.op(Op::Sub, &[c, a]);
        let product = b.op(Op::Mul, &[rest, a]);
        let twice = b.op(Op::Add, &[product, product]);
        let red = b.output(Output::Color { target: 0, component: 0 });
        b.store(red, twice);
        check(&b.finish(), &[1.0_f32.to_bits()], |_, lane| (lane as f32 / 8.0).to_bits());
    }

    #[test]
    fn every_tree_is_found_and_gives_what_its_operations_give() {
        for (what, tree) in Compute::TREES {
            let mut b = Builder::new(Stage::Fragment);
            b.module_mut().varyings = vec![Interpolation::Smooth; OPERANDS];
            let value = build(&mut b, tree);
            let red = b.output(Output::Color { target: 0, component: 0 });
            b.store(red, value);
            let module = b.finish();
            let program = Program::new(&module, |_| true);
            assert_eq!(program.code.len(), 1, "{what:?}: {:?}", program.code);
            let corners = [0.0, -0.0, 1.0, -2.5, 3.75, 1e30, -1e-30, f32::INFINITY, f32::NAN];
            let uniforms = [7.0_f32, -1.5, 0.25, 3.0, 289.0, 2.5, 0.0, -40.0].map(f32::to_bits);
            check(&module, &uniforms, |input, lane| match input {
                Input::Varying(slot) => {
                    let roll = (lane * 7 + 3) * (usize::from(slot) * 5 + 2);
                    match corners.get(roll % 16) {
                        Some(corner) => corner.to_bits(),
                        None => (roll as f32 / 37.0 - 4.0).to_bits(),
                    }
                }
                other => unreachable!("{other:?}"),
            });
        }
    }
}
