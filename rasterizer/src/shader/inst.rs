//! The register program: flat instructions whose operands are registers of 64 lanes.
//!
//! Control flow is structured code laid out flat. The set of lanes that execute is a mask; each
//! construct owns mask slots that keep lanes until they join again. Leaving a
//! construct (`Break`, `Continue`, `Leave`) is one thing: move the executing lanes to the slot of
//! their target. So a join is a union of two masks, and nothing is ever recomputed.

use super::compute::{Compute, OPERANDS};
use crate::ir::{Access, Axis, FunctionTable};
use std::sync::Arc;
use texunit::plan::SamplePlan;
use texunit::sample::AxisTexels;

/// A register. While lowering: a virtual one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Reg(pub u32);

/// A mask slot: lanes that are inactive until the construct ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Slot(pub u32);

/// An index into the instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Target(pub u32);

/// One step of a register program.
#[derive(Clone, Debug)]
pub(super) enum Inst {
    /// All lanes; unused operands repeat another.
    Compute { what: Compute, out: Reg, args: [Reg; OPERANDS] },
    /// All lanes.
    Move { out: Reg, from: Reg },
    /// Zero in all lanes of `len` registers.
    Zero { out: Reg, len: u32 },
    /// Executing lanes only.
    Store { out: Reg, from: Reg },
    /// All lanes; `out = registers[base + min(index, len - 1)]`.
    LoadAt { out: Reg, base: Reg, len: u32, index: Reg },
    /// Executing lanes only.
    StoreAt { base: Reg, len: u32, index: Reg, from: Reg },
    /// All lanes; `out = uniforms[base + min(index, len - 1)]`.
    UniformAt { out: Reg, base: u32, len: u32, index: Reg },
    /// All lanes.
    Derivative { axis: Axis, out: Reg, from: Reg },
    /// All lanes.
    Tabulated { out: Reg, from: Reg, table: FunctionTable },
    /// All lanes.
    Sample(Box<SampleInst>),
    /// Jumps to `to` when this is 0: a uniform branch.
    Unless { test: Test, to: Target },
    /// Jumps to `to`.
    Jump { to: Target },
    /// The next iteration of a loop that all lanes iterate equally often.
    Repeat { head: Target },
    /// Lanes where the condition is false move to the slot; jumps to `reject` when no lane is left.
    If { condition: Reg, slot: Slot, reject: Target },
    /// The lanes of the slot execute, those of the accepted block move to it.
    Else { slot: Slot, end: Target },
    /// Lanes of the slot join.
    Join { slot: Slot },
    /// Empties the slot.
    Open { slot: Slot },
    /// The executing lanes move to the slot.
    Leave { slot: Slot },
    /// The executing lanes that meet the condition move to the slot.
    LeaveIf { condition: Reg, when: When, slot: Slot },
    /// The executing lanes are discarded.
    Discard,
    /// Executing lanes only: a vertex of these scalars is appended to the lane's.
    EmitVertex(Box<[Reg]>),
    /// Executing lanes only.
    EndPrimitive,
    /// Jumps to `to` when no lane executes.
    SkipEmpty { to: Target },
    /// The loop's next iteration, or its end: then the lanes of `exit` execute.
    EndIteration { head: Target, exit: Slot },
}

/// A word that is the same for every lane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Test {
    /// A word of the preamble: the same in the whole draw.
    Word(u32),
    /// What every lane of this register holds.
    Lanes(Reg),
}

/// Which lanes meet a condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum When {
    /// Those where it is true.
    Holds,
    /// Those where it is false.
    Fails,
}

/// The operands of a texture access.
#[derive(Clone, Debug)]
pub(super) struct SampleInst {
    pub texture: u32,
    pub access: Access,
    pub coords: [Reg; 3],
    pub layer: Option<Reg>,
    pub reference: Option<Reg>,
    pub lod: SampleLod,
    /// The word of alpha where there is no texture.
    pub one: u32,
    /// Components that are not used have no register.
    pub out: [Option<Reg>; 4],
    /// Its number among the lookups that may reuse texel addresses ([`super::repeated_lookups`]).
    pub repeat: Option<u8>,
    /// Whether the texels along the first two axes are computed ([`super::shared_axes`]).
    pub axes: [AxisTexels; 2],
}

/// The source of a sample's level of detail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SampleLod {
    Implicit { bias: Option<Reg> },
    Explicit(Reg),
    Gradient { dx: [Reg; 3], dy: [Reg; 3], bias: Option<Reg> },
}

/// What an instruction does with an operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    Read,
    Write,
}

/// By instruction, and for the end of the code: whether any instruction can jump there.
pub(super) fn jump_targets(code: &[Inst]) -> Vec<bool> {
    let mut is_target = vec![false; code.len() + 1];
    for Target(to) in code.iter().filter_map(Inst::target) {
        is_target[to as usize] = true;
    }
    is_target
}

/// The target of a jump, borrowed as the instruction is.
macro_rules! jump_target {
    ($inst:expr) => {
        match $inst {
            Inst::If { reject: to, .. }
            | Inst::Unless { to, .. }
            | Inst::Jump { to }
            | Inst::Else { end: to, .. }
            | Inst::SkipEmpty { to }
            | Inst::Repeat { head: to }
            | Inst::EndIteration { head: to, .. } => Some(to),
            Inst::Compute { .. }
            | Inst::Move { .. }
            | Inst::Zero { .. }
            | Inst::Store { .. }
            | Inst::LoadAt { .. }
            | Inst::StoreAt { .. }
            | Inst::UniformAt { .. }
            | Inst::Derivative { .. }
            | Inst::Tabulated { .. }
            | Inst::Sample(_)
            | Inst::Join { .. }
            | Inst::Open { .. }
            | Inst::Leave { .. }
            | Inst::LeaveIf { .. }
            | Inst::Discard
            | Inst::EmitVertex(_)
            | Inst::EndPrimitive => None,
        }
    };
}

impl Inst {
    /// Visits every register operand, those that are read first.
    pub fn operands(&mut self, f: &mut impl FnMut(&mut Reg, Role)) {
        match self {
            Self::Compute { what, out, args } => {
                let (args, rest) = args.split_at_mut(what.arity());
                args.iter_mut().for_each(|arg| f(arg, Role::Read));
                f(out, Role::Write);
                rest.fill(args[0]);
            }
            Self::Move { out, from }
            | Self::Store { out, from }
            | Self::Derivative { out, from, .. }
            | Self::Tabulated { out, from, .. } => {
                f(from, Role::Read);
                f(out, Role::Write);
            }
            Self::Zero { out, .. } => f(out, Role::Write),
            Self::LoadAt { out, base, index, .. } => {
                f(index, Role::Read);
                f(base, Role::Read);
                f(out, Role::Write);
            }
            Self::StoreAt { base, index, from, .. } => {
                f(index, Role::Read);
                f(from, Role::Read);
                f(base, Role::Write);
            }
            Self::UniformAt { out, index, .. } => {
                f(index, Role::Read);
                f(out, Role::Write);
            }
            Self::Sample(sample) => {
                sample.reads(|reg| f(reg, Role::Read));
                for reg in sample.out.iter_mut().flatten() {
                    f(reg, Role::Write);
                }
            }
            Self::EmitVertex(values) => values.iter_mut().for_each(|reg| f(reg, Role::Read)),
            Self::If { condition, .. }
            | Self::LeaveIf { condition, .. }
            | Self::Unless { test: Test::Lanes(condition), .. } => f(condition, Role::Read),
            Self::Unless { test: Test::Word(_), .. }
            | Self::Jump { .. }
            | Self::Repeat { .. }
            | Self::Else { .. }
            | Self::Join { .. }
            | Self::Open { .. }
            | Self::Leave { .. }
            | Self::Discard
            | Self::EndPrimitive
            | Self::SkipEmpty { .. }
            | Self::EndIteration { .. } => {}
        }
    }

    /// Whether it reads or changes which lanes execute. Stores into some of the lanes and emissions read it.
    pub fn uses_mask(&self) -> bool {
        let is_uniform =
            matches!(self, Self::Unless { .. } | Self::Jump { .. } | Self::Repeat { .. });
        let stores = matches!(self, Self::Store { .. } | Self::StoreAt { .. });
        let emits = matches!(self, Self::EmitVertex(_) | Self::EndPrimitive);
        stores || emits || (self.is_control() && !is_uniform)
    }

    /// Whether it is the end of a loop.
    pub fn repeats(&self) -> bool {
        matches!(self, Self::Repeat { .. } | Self::EndIteration { .. })
    }

    /// Whether it removes lanes from the execution mask of the next instructions.
    pub fn removes_lanes(&self) -> bool {
        matches!(self, Self::Leave { .. } | Self::LeaveIf { .. } | Self::Discard)
    }

    /// Whether it computes values from values of registers, whatever lanes execute: code of such
    /// instructions alone can run for several register files at once.
    pub fn is_straight(&self) -> bool {
        let moves = matches!(self, Self::Move { .. } | Self::Derivative { .. });
        moves || matches!(self, Self::Compute { .. } | Self::Tabulated { .. } | Self::Sample(_))
    }

    /// About how many additions of 64 lanes it takes as long as. The textures are those of the draw.
    pub fn cost(&self, textures: &[Option<Arc<SamplePlan>>]) -> u32 {
        /// One lane after the other.
        const BY_LANE: u32 = 16;
        /// The dispatch of an instruction.
        const DISPATCH: u32 = 1;
        match self {
            Self::Compute { what, .. } => DISPATCH + what.size()[0],
            Self::Sample(sample) => {
                let plan = textures.get(sample.texture as usize).and_then(Option::as_ref);
                DISPATCH + plan.map_or(1, |plan| plan.cost())
            }
            Self::LoadAt { .. } | Self::StoreAt { .. } | Self::UniformAt { .. } => BY_LANE,
            Self::Zero { len, .. } => DISPATCH + len,
            Self::EmitVertex(values) => DISPATCH + values.len() as u32,
            Self::EndPrimitive => BY_LANE,
            Self::Tabulated { table, .. } => DISPATCH + table.cost(),
            Self::Move { .. }
            | Self::Store { .. }
            | Self::Derivative { .. }
            | Self::If { .. }
            | Self::Unless { .. }
            | Self::Jump { .. }
            | Self::Repeat { .. }
            | Self::Else { .. }
            | Self::Join { .. }
            | Self::Open { .. }
            | Self::Leave { .. }
            | Self::LeaveIf { .. }
            | Self::Discard
            | Self::SkipEmpty { .. }
            | Self::EndIteration { .. } => 1 + DISPATCH,
        }
    }

    /// Whether it changes which lanes execute, or is a jump.
    pub fn is_control(&self) -> bool {
        match self {
            Self::If { .. }
            | Self::Unless { .. }
            | Self::Jump { .. }
            | Self::Repeat { .. }
            | Self::Else { .. }
            | Self::Join { .. }
            | Self::Open { .. }
            | Self::Leave { .. }
            | Self::LeaveIf { .. }
            | Self::Discard
            | Self::SkipEmpty { .. }
            | Self::EndIteration { .. } => true,
            Self::Compute { .. }
            | Self::Move { .. }
            | Self::Zero { .. }
            | Self::Store { .. }
            | Self::LoadAt { .. }
            | Self::StoreAt { .. }
            | Self::UniformAt { .. }
            | Self::Derivative { .. }
            | Self::Tabulated { .. }
            | Self::EmitVertex(_)
            | Self::EndPrimitive
            | Self::Sample(_) => false,
        }
    }

    /// The instruction this one can jump to.
    pub fn target(&self) -> Option<Target> {
        jump_target!(self).copied()
    }

    /// As [`Self::target`], to be changed.
    pub fn target_mut(&mut self) -> Option<&mut Target> {
        jump_target!(self)
    }
}

impl SampleInst {
    /// Whether the level of detail comes from the differences within each quad, and matters: where what
    /// is asked for, or the texture of its slot, needs one.
    pub fn reads_neighbours(&self, needs_lod: impl Fn(u32) -> bool) -> bool {
        let matters = match self.access {
            Access::Lod => true,
            Access::Filter { .. } | Access::Fetch { .. } | Access::Size => needs_lod(self.texture),
            Access::Gather { .. } => false,
        };
        matters && matches!(self.lod, SampleLod::Implicit { .. })
    }

    /// Visits the registers that it reads.
    pub fn reads(&mut self, mut f: impl FnMut(&mut Reg)) {
        self.coords.iter_mut().for_each(&mut f);
        self.layer.iter_mut().for_each(&mut f);
        self.reference.iter_mut().for_each(&mut f);
        self.lod.reads(f);
    }
}

impl SampleLod {
    /// Visits the registers that it reads.
    pub fn reads(&mut self, mut f: impl FnMut(&mut Reg)) {
        match self {
            Self::Implicit { bias } => bias.iter_mut().for_each(f),
            Self::Explicit(lod) => f(lod),
            Self::Gradient { dx, dy, bias } => dx.iter_mut().chain(dy).chain(bias).for_each(f),
        }
    }
}
