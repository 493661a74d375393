//! Colours of every other format, through its row of the table of formats.

use super::super::{blend, logic};
use super::{ColorClass, ColorPlan, store_masked};
use crate::attachment::{decode_color, encode_color};
use crate::desc::Blend;
use crate::output::color::bytes::{BlockColors, clamped};
use texunit::format::{Encoding, Format};
use texunit::lanes::{F32s, Kernel, LANES, Simd, U32s};

/// Blends, packs and writes fragments of any class, block after block.
pub struct WriteTexels<'a> {
    /// What is done.
    pub plan: &'a ColorPlan,
    /// The fragments; integers as their bits.
    pub colors: &'a [BlockColors<'a>],
    /// The blocks of each of the attachment's words; none of a word that its texels do not have.
    pub words: [&'a mut [U32s]; 4],
}

impl Kernel for WriteTexels<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, colors, mut words } = self;
        let mut texels = [U32s::ZERO; 4];
        for &BlockColors { block, color, second, mask } in colors {
            match plan.class {
                ColorClass::Integers => encode_integers(plan.format, color, &mut texels),
                ColorClass::Bytes | ColorClass::Converted => {
                    let mixed;
                    let color = match &plan.blend {
                        None => color,
                        Some(state) => {
                            let [x, y, z, w] = &words;
                            let stored = [x.get(block), y.get(block), z.get(block), w.get(block)];
                            mixed = blended::<S>(state, plan.format, (color, second), stored);
                            mixed.each_ref()
                        }
                    };
                    encode_color::<S>(plan.format, color, &mut texels);
                }
            }
            for (index, blocks) in words.iter_mut().enumerate() {
                let Some(stored) = blocks.get_mut(block) else { continue };
                if let Some(op) = plan.logic_op {
                    logic::apply(op, &mut texels[index], stored);
                }
                // Bits that no field has stay as they were under a logical operation.
                let mut write = plan.write_of(index);
                write.all_bits_written &= plan.logic_op.is_none();
                store_masked(stored, &texels[index], mask, write);
            }
        }
    }
}

/// Fragments blended with the stored texels, one vector for each word of the format.
#[inline(always)]
fn blended<S: Simd>(
    state: &Blend,
    format: Format,
    (color, second): ([&F32s; 4], Option<[&F32s; 4]>),
    stored: [Option<&U32s>; 4],
) -> [F32s; 4] {
    let range = format.info().encoding.range();
    let in_range = |[r, g, b, a]: [&F32s; 4]| match range {
        Some(range) => clamped([r, g, b, a], range),
        None => [*r, *g, *b, *a],
    };
    let source = in_range(color);
    let seconds;
    let second = match second {
        None => blend::NO_SECOND,
        Some(second) => {
            seconds = in_range(second);
            &seconds
        }
    };
    let [x, y, z, w] = stored;
    const NONE: &U32s = &U32s::ZERO;
    let words = [x.unwrap_or(NONE), y.unwrap_or(NONE), z.unwrap_or(NONE), w.unwrap_or(NONE)];
    let destination = decode_color::<S>(format, words);
    blend::blend(state, [&source, second], &destination, range)
}

/// The texels of 64 integer colours, each clamped to the range of its field.
#[inline(always)]
fn encode_integers(format: Format, rgba: [&F32s; 4], out: &mut [U32s; 4]) {
    let is_signed = format.info().encoding == Encoding::Sint;
    for words in &mut out[..format.words()] {
        *words = U32s::ZERO;
    }
    for (channel, &source) in format.base().sources().iter().enumerate() {
        let field = format.field(channel);
        let (values, to) = (rgba[source].as_u32(), &mut out[field.word]);
        if is_signed {
            let high = (field.mask() >> 1) as i32;
            for lane in 0..LANES {
                let value = values[lane] as i32;
                let above = if value > -high - 1 { value } else { -high - 1 };
                let within = if above < high { above } else { high };
                to[lane] |= (within as u32 & field.mask()) << field.shift;
            }
        } else {
            for lane in 0..LANES {
                let value = values[lane];
                let within = if value < field.mask() { value } else { field.mask() };
                to[lane] |= within << field.shift;
            }
        }
    }
}
