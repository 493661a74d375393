//! Colours from shader outputs to attachment words.

use super::blend;
use crate::driver::Blend;
use texunit::lanes::{F32s, Kernel, LANES, Simd, U32s, math};

/// What a draw does to one colour attachment.
#[derive(Clone, Debug, PartialEq)]
pub struct ColorPlan {
    /// Which attachment.
    pub target: usize,
    /// The program outputs of red, green, blue, alpha; a component that is not written is 0, alpha 1.
    pub outputs: [Option<usize>; 4],
    /// Blending, if any.
    pub blend: Option<Blend>,
    /// Bits of the word that are written.
    pub write_mask: u32,
}

/// All ones in the lanes of a mask.
#[inline(always)]
pub fn expand_mask(mask: u64) -> U32s {
    let halves = [mask as u32, (mask >> 32) as u32];
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        out[lane] = if halves[lane / 32] & 1 << (lane % 32) != 0 { !0 } else { 0 };
    }
    out
}

/// The mask of the lanes that are not zero.
#[inline(always)]
pub fn pack_mask(lanes: &U32s) -> u64 {
    let mut bytes = [0_u8; LANES];
    for lane in 0..LANES {
        bytes[lane] = u8::from(lanes[lane] != 0);
    }
    let mut mask = 0;
    for (index, eight) in bytes.as_chunks::<8>().0.iter().enumerate() {
        // Moves bit 0 of byte `i` to bit `56 + i`.
        let gathered = u64::from_le_bytes(*eight).wrapping_mul(0x0102_0408_1020_4080) >> 56;
        mask |= gathered << (8 * index);
    }
    mask
}

/// An RGBA colour as an attachment word, clamped and rounded to nearest (GL 2.1, section 2.14.9).
pub fn color_word(color: [f32; 4]) -> u32 {
    u32::from_le_bytes(color.map(|c| unorm8(c) as u8))
}

/// `[0, 1]` to 0 … 255, rounded to nearest; NaN gives 0.
#[inline(always)]
fn unorm8(c: f32) -> i32 {
    math::to_i32(math::clamp(c, 0.0, 1.0) * 255.0 + 0.5)
}

/// Blends, packs and writes 64 fragments.
pub struct WriteColor<'a> {
    /// What is done.
    pub plan: &'a ColorPlan,
    /// Red, green, blue, alpha of each fragment.
    pub color: [&'a F32s; 4],
    /// The attachment's words.
    pub stored: &'a mut U32s,
    /// Which fragments there are.
    pub mask: u64,
}

impl Kernel for WriteColor<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, color, stored, mask } = self;
        let mut word = U32s::ZERO;
        match &plan.blend {
            None => {
                for (channel, values) in color.into_iter().enumerate() {
                    for lane in 0..LANES {
                        word[lane] |= (unorm8(values[lane]) as u32) << (8 * channel);
                    }
                }
            }
            Some(state) => {
                let source = color.map(|values| {
                    let mut clamped = F32s::ZERO;
                    for lane in 0..LANES {
                        clamped[lane] = math::clamp(values[lane], 0.0, 1.0);
                    }
                    clamped
                });
                let mut destination = [F32s::ZERO; 4];
                for (channel, out) in destination.iter_mut().enumerate() {
                    for lane in 0..LANES {
                        out[lane] = (stored[lane] >> (8 * channel) & 0xFF) as i32 as f32 / 255.0;
                    }
                }
                let blended = blend::blend(state, &source, &destination);
                for (channel, values) in blended.iter().enumerate() {
                    for lane in 0..LANES {
                        word[lane] |= (unorm8(values[lane]) as u32) << (8 * channel);
                    }
                }
            }
        }
        if mask == !0 && plan.write_mask == !0 {
            *stored = word;
            return;
        }
        let covered = expand_mask(mask);
        for lane in 0..LANES {
            let write = covered[lane] & plan.write_mask;
            stored[lane] = (word[lane] & write) | (stored[lane] & !write);
        }
    }
}
