//! Lookups in one texture with the same s, or the same t: the taps of a filter are columns times rows. The texels along an
//! axis are computed once.

use super::inst::{Inst, Reg, Role, jump_targets};
use crate::ir::Access;
use texunit::sample::{AxisTexels, KEPT_AXES};

/// The texels of a lookup along an axis.
#[derive(Clone, Copy, PartialEq, Eq)]
struct AxisOfLookup {
    texture: u32,
    axis: usize,
    coordinate: Reg,
}

/// One that later lookups can share.
struct Known {
    of: AxisOfLookup,
    /// The instruction that computes it.
    at: usize,
    /// What it is kept under, once something shares it.
    number: Option<u8>,
}

/// The most axes that are remembered: the work of an instruction.
const MAX_KNOWN: usize = 64;

/// Marks the lookups whose texels along an axis are kept or reused; returns whether there are any.
pub(super) fn mark(code: &mut [Inst]) -> bool {
    let is_target = jump_targets(code);
    let mut known: Vec<Known> = Vec::new();
    let mut numbers = 0..KEPT_AXES as u8;
    for at in 0..code.len() {
        if is_target[at] || code[at].is_control() {
            known.clear();
        }
        for axis in [0, 1] {
            let Some(of) = AxisOfLookup::of(&code[at], axis) else { continue };
            let Some(found) = known.iter_mut().find(|known| known.of == of) else {
                if known.len() == MAX_KNOWN {
                    known.remove(0);
                }
                known.push(Known { of, at, number: None });
                continue;
            };
            let Some(number) = found.number.or_else(|| numbers.next()) else { continue };
            found.number = Some(number);
            let first = found.at;
            set(&mut code[first], axis, AxisTexels::Keep(number));
            set(&mut code[at], axis, AxisTexels::Reuse(number));
        }
        code[at].operands(&mut |register, role| {
            if role == Role::Write {
                known.retain(|known| known.of.coordinate != *register);
            }
        });
        // Arrays have more registers than their first.
        if matches!(code[at], Inst::Zero { .. } | Inst::StoreAt { .. }) {
            known.clear();
        }
    }
    numbers.start > 0
}

impl AxisOfLookup {
    fn of(inst: &Inst, axis: usize) -> Option<Self> {
        let Inst::Sample(sample) = inst else { return None };
        match sample.access {
            Access::Filter { offset: [0, 0, 0] } => {
                let (texture, coordinate) = (sample.texture, sample.coords[axis]);
                Some(Self { texture, axis, coordinate })
            }
            Access::Filter { .. }
            | Access::Fetch { .. }
            | Access::Gather { .. }
            | Access::Size
            | Access::Lod => None,
        }
    }
}

fn set(inst: &mut Inst, axis: usize, texels: AxisTexels) {
    if let Inst::Sample(sample) = inst {
        sample.axes[axis] = texels;
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Program, inst::SampleInst};
    use super::*;
    use crate::ir::{Builder, Input, Interpolation, Lod, Op, Output, Stage, TextureDecl};
    use texunit::image::Shape;

    /// The lookups of a grid of three columns and two rows, in two textures.
    fn grid() -> Vec<SampleInst> {
        let mut b = Builder::new(Stage::Fragment);
        b.module_mut().varyings = vec![Interpolation::Smooth; 2];
        let [s, t] = [0, 1].map(|slot| b.input(Input::Varying(slot)));
        let textures = [0; 2].map(|_| b.texture(TextureDecl::color(Shape::D2)));
        let mut sum = b.float(0.0);
        for texture in textures {
            for row in 0..2 {
                for column in 0..3 {
                    let [x, y] = [(s, column), (t, row)].map(|(value, step)| {
                        let step = b.float(step as f32 / 8.0);
                        b.op(Op::Add, &[value, step])
                    });
                    let lod = Lod::Implicit { bias: None };
                    let [red, ..] = b.sample(texture, [x, y, x], None, lod);
                    sum = b.op(Op::Add, &[sum, red]);
                }
            }
        }
        let out = b.output(Output::Color { target: 0, component: 0 });
        b.store(out, sum);
        let program = Program::new(&b.finish(), |_| true);
        let lookups = program.code.into_iter().filter_map(|inst| match inst {
            Inst::Sample(sample) => Some(*sample),
            _ => None,
        });
        lookups.collect()
    }

    #[test]
    fn each_column_and_row_of_a_texture_is_computed_once() {
        let lookups = grid();
        assert_eq!(lookups.len(), 12);
        let axes = || lookups.iter().flat_map(|lookup| lookup.axes);
        let count = |wanted: fn(&AxisTexels) -> bool| axes().filter(wanted).count();
        assert_eq!(count(|axis| matches!(axis, AxisTexels::Keep(_))), 2 * (3 + 2));
        assert_eq!(count(|axis| matches!(axis, AxisTexels::Reuse(_))), 24 - 2 * (3 + 2));
        for (at, lookup) in lookups.iter().enumerate() {
            for (axis, texels) in lookup.axes.into_iter().enumerate() {
                let AxisTexels::Reuse(number) = texels else { continue };
                let keeper = lookups[..at]
                    .iter()
                    .rev()
                    .find(|keeper| keeper.axes[axis] == AxisTexels::Keep(number))
                    .expect("what is reused was kept");
                assert_eq!(keeper.texture, lookup.texture);
                assert_eq!(keeper.coords[axis], lookup.coords[axis]);
            }
        }
    }
}
