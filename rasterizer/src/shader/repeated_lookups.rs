//! Lookups at the same points as the one before: a surface has its colours, normals and gloss in textures of one size.
//! Where the textures of a draw share texel addresses, these and the levels of detail are computed once.

use super::inst::{Inst, Reg, Role, SampleInst};
use crate::ir::Access;
use std::sync::Arc;
use texunit::plan::SamplePlan;
use texunit::sample::Addresses;

/// Two lookups with nothing in between that changes what the second one reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Repeat {
    /// The texture slots of both.
    textures: [u32; 2],
}

impl Repeat {
    /// The second lookup, if it has the same operands as the one before.
    pub(super) fn of(before: &SampleInst, sample: &SampleInst) -> Option<Self> {
        let textures = [before.texture, sample.texture];
        repeats(sample, before).then_some(Self { textures })
    }

    /// Whether the second lookup computes or reuses texel addresses, in a draw with these textures.
    pub(crate) fn addresses(&self, textures: &[Option<Arc<SamplePlan>>]) -> Addresses {
        let texture = |slot: u32| textures.get(slot as usize)?.as_ref();
        let [before, this] = self.textures.map(texture);
        match before.zip(this) {
            Some((before, this)) if this.shares_addresses_with(before) => Addresses::Reuse,
            Some(_) | None => Addresses::Compute,
        }
    }
}

/// The most repeated lookups: each has a bit in a word.
const MOST: usize = u64::BITS as usize;

/// Marks the lookups of straight code that repeat the one before; gives them in order.
pub(super) fn find(code: &mut [Inst]) -> Vec<Repeat> {
    let mut found = Vec::new();
    if !code.iter().all(Inst::is_straight) {
        return found;
    }
    let mut before: Option<SampleInst> = None;
    for inst in code {
        if let Inst::Sample(sample) = inst {
            let repeat = before.as_ref().and_then(|before| Repeat::of(before, sample));
            if let Some(repeat) = repeat.filter(|_| found.len() < MOST) {
                sample.repeat = Some(found.len() as u8);
                found.push(repeat);
            }
            before = Some(SampleInst::clone(sample));
        }
        inst.operands(&mut |reg, role| {
            if role == Role::Write && before.as_mut().is_some_and(|before| reads(before, *reg)) {
                before = None;
            }
        });
    }
    found
}

/// Whether a lookup has the same operands as the one before.
fn repeats(sample: &SampleInst, before: &SampleInst) -> bool {
    match (sample.access, before.access) {
        (Access::Filter { offset }, Access::Filter { offset: same }) if offset == same => {
            sample.coords == before.coords && sample.lod == before.lod
        }
        (
            Access::Filter { .. }
            | Access::Fetch { .. }
            | Access::Gather { .. }
            | Access::Size
            | Access::Lod,
            _,
        ) => false,
    }
}

fn reads(sample: &mut SampleInst, wanted: Reg) -> bool {
    let mut found = false;
    sample.reads(|reg| found |= *reg == wanted);
    found
}

/// The pairs whose textures share texel addresses, bit by number.
pub(super) fn reused_addresses(repeats: &[Repeat], textures: &[Option<Arc<SamplePlan>>]) -> u64 {
    let bit = |(number, repeat): (usize, &Repeat)| {
        u64::from(repeat.addresses(textures) == Addresses::Reuse) << number
    };
    repeats.iter().enumerate().map(bit).sum()
}
