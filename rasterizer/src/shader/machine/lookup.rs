//! Texture accesses of the interpreter.

use super::super::Invocation;
use super::super::inst::{Reg, SampleInst, SampleLod};
use super::Machine;
use crate::ir::Access;
use texunit::lanes::{F32s, LANES, Simd, U32s};
use texunit::sample::{Lod, Points};

impl Machine {
    /// Samples for a register file.
    #[inline(always)]
    pub(super) fn sample<S: Simd>(
        &mut self,
        file: usize,
        invocation: &Invocation<'_>,
        sample: &SampleInst,
    ) {
        let plan = invocation.textures.get(sample.texture as usize).and_then(Option::as_ref);
        let registers = &mut self.registers[file * self.file..];
        let scratch = &mut self.lookup_scratch[file * self.scratch_stride];
        if let (Access::Filter { offset: [0, 0, 0] }, Some(plan)) = (sample.access, plan) {
            let [s, t, _] = sample.coords.map(|reg| reg.0 as usize);
            let out = sample.out.map(|reg| reg.map(|reg| reg.0 as usize));
            let axes = (sample.axes, &mut *scratch);
            if plan.sample_registers::<S>(registers, [s, t], axes, out).is_ok() {
                return;
            }
        }
        match plan.filter(|plan| plan.incomplete().is_none()) {
            Some(plan) => {
                let reg = |reg: Reg| registers[reg.0 as usize].as_f32();
                let lod = lod(registers, sample);
                let coords = sample.coords.map(reg);
                let (layer, reference) = (sample.layer.map(reg), sample.reference.map(reg));
                let out = &mut scratch.lanes;
                match (sample.access, lod) {
                    (Access::Fetch { offset }, Lod::Explicit(level)) => {
                        let texel = coords.map(|c| c.as_u32().as_i32());
                        plan.fetch(invocation.isa, texel, level.as_u32().as_i32(), offset, out);
                    }
                    (Access::Size, Lod::Explicit(level)) => {
                        let size = plan.size(level.as_u32().as_i32());
                        *out[3].as_u32_mut() = U32s::splat(plan.level_count());
                        for (out, size) in out.iter_mut().zip(&size) {
                            let out = out.as_u32_mut();
                            for lane in 0..LANES {
                                out[lane] = size[lane] as u32;
                            }
                        }
                    }
                    (Access::Gather { offset }, _) => {
                        let points = Points { coords, layer, reference };
                        plan.gather(invocation.isa, points, offset, out);
                    }
                    (Access::Lod, lod) => {
                        let [level, lambda, rest @ ..] = out;
                        let mut found = [F32s::ZERO; 2];
                        plan.query_lod(invocation.isa, coords, lod, &mut found);
                        [*level, *lambda] = found;
                        *rest = [F32s::ZERO; 2];
                    }
                    (Access::Filter { offset }, lod) => {
                        let points = Points { coords, layer, reference };
                        let addresses = invocation.prepared.addresses(sample);
                        plan.sample_offset(invocation.isa, points, offset, lod, addresses, scratch);
                    }
                    // Validation wants a level for these.
                    (Access::Fetch { .. } | Access::Size, Lod::Implicit { .. })
                    | (Access::Fetch { .. } | Access::Size, Lod::Gradient { .. }) => {
                        *out = [F32s::ZERO; 4];
                    }
                }
            }
            // GL 2.1, section 3.11.2: what is not there or not complete is (0, 0, 0, 1).
            None => {
                let black = [0, 0, 0, sample.one];
                scratch.lanes = black.map(|c| F32s::splat(f32::from_bits(c)));
            }
        }
        for (out, texel) in sample.out.iter().zip(&scratch.lanes) {
            if let Some(out) = out {
                registers[out.0 as usize] = *texel.as_u32();
            }
        }
    }
}

/// The source of the level of detail of a sample.
#[inline(always)]
pub(super) fn lod<'a>(registers: &'a [U32s], sample: &SampleInst) -> Lod<'a> {
    let reg = |reg: Reg| registers[reg.0 as usize].as_f32();
    match sample.lod {
        SampleLod::Implicit { bias } => Lod::Implicit { bias: bias.map(reg) },
        SampleLod::Explicit(lod) => Lod::Explicit(reg(lod)),
        SampleLod::Gradient { dx, dy, bias } => {
            Lod::Gradient { dx: dx.map(reg), dy: dy.map(reg), bias: bias.map(reg) }
        }
    }
}
