//! Colours of bytes in the order red, green, blue, alpha.

use super::super::blend;
use super::{ColorPlan, OpaqueBlocks, store_masked};
use crate::attachment::{WordPlane, are_equal};
use crate::desc::{Blend, BlendEquation, BlendFactor};
use crate::sizes::MAX_SAMPLES;
use texunit::format::convert::byte_channel;
use texunit::format::{Encoding, Format};
use texunit::lanes::{F32s, Kernel, LANES, PerLane, Simd, U32s, math};

/// The colours of 64 fragments and where they go.
#[derive(Clone, Copy)]
pub struct BlockColors<'a> {
    /// Which block of the words that are written.
    pub block: usize,
    /// Red, green, blue, alpha of each fragment.
    pub color: [&'a F32s; 4],
    /// Their second colour, if blending reads it.
    pub second: Option<[&'a F32s; 4]>,
    /// Which fragments there are.
    pub mask: u64,
}

/// Blends, packs and writes fragments of [`crate::output::ColorClass::Bytes`], block after block.
pub struct WriteBytes<'a> {
    /// What is done.
    pub plan: &'a ColorPlan,
    /// The fragments.
    pub colors: &'a [BlockColors<'a>],
    /// The attachment's words.
    pub blocks: &'a mut [U32s],
}

impl Kernel for WriteBytes<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, colors, blocks } = self;
        for &BlockColors { block, color, second, mask } in colors {
            let stored = &mut blocks[block];
            let word = word::<S>(plan, (color, second), stored);
            store_masked(stored, &word, mask, plan.write_of(0));
        }
    }
}

/// What fragments store over what is stored.
#[inline(always)]
fn word<S: Simd>(
    plan: &ColorPlan,
    (color, second): ([&F32s; 4], Option<[&F32s; 4]>),
    stored: &U32s,
) -> U32s {
    match &plan.blend {
        Some(_) if plan.opaque == OpaqueBlocks::Replaced && is_opaque::<S>(color[3]) => {
            pack(|lane, channel| color[channel][lane])
        }
        None => pack(|lane, channel| color[channel][lane]),
        Some(state) => blended_bytes(state, plan.format, (color, second), stored),
    }
}

/// Whether alpha is 1 once it is clamped, in all lanes.
#[inline(always)]
fn is_opaque<S: Simd>(alpha: &F32s) -> bool {
    let mut below = U32s::ZERO;
    for lane in 0..LANES {
        // NaN is clamped to 0.
        below[lane] = if alpha[lane] >= 1.0 { 0 } else { !0 };
    }
    !S::any(&below)
}

/// The words of an attachment at 64 fragments, by sample.
pub trait SampleWords {
    /// Those of a sample.
    fn sample(&mut self, sample: usize) -> &mut U32s;
}

/// Words that were loaded.
impl SampleWords for &mut [U32s; MAX_SAMPLES] {
    #[inline(always)]
    fn sample(&mut self, sample: usize) -> &mut U32s {
        &mut self[sample % MAX_SAMPLES]
    }
}

/// A block of the plane of each sample.
pub struct BlockOfPlanes<'a> {
    /// The planes by sample.
    pub planes: &'a mut [WordPlane],
    /// Which block: one with words of its own in the planes of all samples that are written.
    pub block: usize,
}

impl SampleWords for BlockOfPlanes<'_> {
    #[inline(always)]
    fn sample(&mut self, sample: usize) -> &mut U32s {
        &mut self.planes[sample].materialized_blocks()[self.block]
    }
}

/// Blends, packs and writes the samples of 64 fragments, which share colours: the words are computed once, and again only
/// where a sample stores other words than the one before.
pub struct WriteSampledBytes<'a, W> {
    /// What is done.
    pub plan: &'a ColorPlan,
    /// The colours.
    pub colors: BlockColors<'a>,
    /// Which fragments there are, by sample.
    pub masks: &'a [u64],
    /// The attachment's words.
    pub words: W,
}

impl<W: SampleWords> Kernel for WriteSampledBytes<'_, W> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, colors: BlockColors { color, second, .. }, masks, mut words } = self;
        let (mut before, mut new) = (U32s::ZERO, U32s::ZERO);
        let mut is_computed = false;
        for (sample, &mask) in masks.iter().enumerate() {
            if mask == 0 {
                continue;
            }
            let stored = words.sample(sample);
            let is_same = is_computed && (plan.blend.is_none() || are_equal::<S>(&before, stored));
            if !is_same {
                before = *stored;
                new = word::<S>(plan, (color, second), stored);
                is_computed = true;
            }
            store_masked(stored, &new, mask, plan.write_of(0));
        }
    }
}

/// Stores words of 64 fragments in each of their samples.
pub struct StoreSamples<'a> {
    /// What is done.
    pub plan: &'a ColorPlan,
    /// The words.
    pub word: &'a U32s,
    /// Which fragments there are, by sample.
    pub masks: &'a [u64],
    /// The attachment's words.
    pub words: BlockOfPlanes<'a>,
}

impl Kernel for StoreSamples<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, word, masks, mut words } = self;
        for (sample, &mask) in masks.iter().enumerate() {
            if mask != 0 {
                store_masked(words.sample(sample), word, mask, plan.write_of(0));
            }
        }
    }
}

/// Four bytes of each lane.
#[inline(always)]
fn pack(color: impl Fn(usize, usize) -> f32) -> U32s {
    pack_colors(&Colors(color))
}

/// [`pack`] of what lies in [0, 1], give or take its last bits.
#[inline(always)]
fn pack_units(color: impl Fn(usize, usize) -> f32) -> U32s {
    pack_colors(&Units(color))
}

struct Colors<F>(F);

struct Units<F>(F);

impl<F: Fn(usize, usize) -> f32> Color for Colors<F> {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        (self.0)(lane, channel)
    }
}

impl<F: Fn(usize, usize) -> f32> Color for Units<F> {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        (self.0)(lane, channel)
    }
    #[inline(always)]
    fn byte(&self, lane: usize, channel: usize) -> u32 {
        math::unit_byte(self.channel(lane, channel))
    }
}

/// Colours of 64 fragments. (A closure that is long would become a function of its own.)
pub trait Color {
    /// Red, green, blue or alpha of a lane.
    fn channel(&self, lane: usize, channel: usize) -> f32;

    /// The same to the nearest byte.
    #[inline(always)]
    fn byte(&self, lane: usize, channel: usize) -> u32 {
        math::byte(self.channel(lane, channel))
    }
}

/// Four bytes of each lane.
#[inline(always)]
pub fn pack_colors(color: &impl Color) -> U32s {
    U32s::of(Packed(color))
}

/// Four bytes of a lane.
struct Packed<'a, C>(&'a C);

impl<C: Color> PerLane<u32> for Packed<'_, C> {
    #[inline(always)]
    fn at(&self, lane: usize) -> u32 {
        let [r, g] = [self.0.byte(lane, 0), self.0.byte(lane, 1)];
        let [b, a] = [self.0.byte(lane, 2), self.0.byte(lane, 3)];
        r | g << 8 | b << 16 | a << 24
    }
}

/// Fragments blended with the bytes that are stored. The usual ways in one loop, the others factor by
/// factor.
#[inline(always)]
fn blended_bytes(
    state: &Blend,
    format: Format,
    (color, second): ([&F32s; 4], Option<[&F32s; 4]>),
    stored: &U32s,
) -> U32s {
    use BlendFactor::{DstColor, One, OneMinusSrcAlpha, SrcAlpha, SrcColor, Zero};
    let channels = format.channels();
    let source = |lane: usize, channel: usize| math::clamp(color[channel][lane], 0.0, 1.0);
    let destination = |lane: usize, channel: usize| match channel {
        3 if channels < 4 => 1.0,
        _ => byte_channel(stored[lane], channel),
    };
    // Of source, destination and source alpha.
    let each = Each { source, destination };
    let alike = state.src[0] == state.src[1] && state.dst[0] == state.dst[1];
    if alike && state.equation == [BlendEquation::Add; 2] {
        match (state.src[0], state.dst[0]) {
            (SrcAlpha, OneMinusSrcAlpha) => {
                return each.blend_units(|s, d, a| s * a + d * (1.0 - a));
            }
            (One, OneMinusSrcAlpha) => return each.blend(|s, d, a| s + d * (1.0 - a)),
            (SrcAlpha, One) => return each.blend(|s, d, a| s * a + d),
            (One, One) => return each.blend(|s, d, _| s + d),
            (DstColor, Zero) | (Zero, SrcColor) => return each.blend_units(|s, d, _| s * d),
            (_, _) => {}
        }
    }
    let mut sources = [F32s::ZERO; 4];
    let mut destinations = [F32s::ZERO; 4];
    for channel in 0..4 {
        for lane in 0..LANES {
            sources[channel][lane] = source(lane, channel);
            destinations[channel][lane] = destination(lane, channel);
        }
    }
    let seconds;
    let second = match second {
        None => blend::NO_SECOND,
        Some(second) => {
            seconds = clamped(second, Encoding::UNIT);
            &seconds
        }
    };
    let blended = blend::blend(state, [&sources, second], &destinations, Some(Encoding::UNIT));
    pack(|lane, channel| blended[channel][lane])
}

/// Colours clamped to a range.
#[inline(always)]
pub fn clamped([r, g, b, a]: [&F32s; 4], [low, high]: [f32; 2]) -> [F32s; 4] {
    let mut out = [*r, *g, *b, *a];
    for values in &mut out {
        for lane in 0..LANES {
            values[lane] = math::clamp(values[lane], low, high);
        }
    }
    out
}

/// Blends 64 fragments of bytes in one loop: lane and channel to the numbers that are blended.
struct Each<S, D> {
    source: S,
    destination: D,
}

impl<S: Fn(usize, usize) -> f32, D: Fn(usize, usize) -> f32> Each<S, D> {
    #[inline(always)]
    fn blend(&self, f: impl Fn(f32, f32, f32) -> f32) -> U32s {
        pack(|lane, channel| {
            let alpha = (self.source)(lane, 3);
            f((self.source)(lane, channel), (self.destination)(lane, channel), alpha)
        })
    }

    /// [`Self::blend`] of what stays in [0, 1].
    #[inline(always)]
    fn blend_units(&self, f: impl Fn(f32, f32, f32) -> f32) -> U32s {
        pack_units(|lane, channel| {
            let alpha = (self.source)(lane, 3);
            f((self.source)(lane, channel), (self.destination)(lane, channel), alpha)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use texunit::lanes::Isa;

    struct Blended<'a>(&'a Blend, Format, [&'a F32s; 4], &'a U32s);

    impl Kernel for Blended<'_> {
        type Output = U32s;
        #[inline(always)]
        fn run<S: Simd>(self) -> U32s {
            blended_bytes(self.0, self.1, (self.2, None), self.3)
        }
    }

    /// The usual ways to blend are the general one: colours of all kinds over all bytes.
    #[test]
    fn blending_in_one_loop_is_blending_factor_by_factor() {
        use BlendFactor::{DstColor, One, OneMinusSrcAlpha, SrcAlpha, SrcColor, Zero};
        let usual = [
            (SrcAlpha, OneMinusSrcAlpha),
            (One, OneMinusSrcAlpha),
            (SrcAlpha, One),
            (One, One),
            (DstColor, Zero),
            (Zero, SrcColor),
            (Zero, One),
        ];
        for (src, dst) in usual {
            let equation = [BlendEquation::Add; 2];
            let state = Blend { equation, src: [src; 2], dst: [dst; 2], constant: [0.0; 4] };
            for round in 0..64_u32 {
                let channel = |channel: u32| {
                    F32s::from_fn(|lane| {
                        let at = round * 64 + lane as u32;
                        (at.wrapping_mul(2_654_435_761 + channel) >> 20) as f32 / 4000.0 - 0.01
                    })
                };
                let color = [0, 1, 2, 3].map(channel);
                let stored =
                    U32s::from_fn(|lane| (round * 64 + lane as u32).wrapping_mul(0x0104_0307));
                for format in [Format::Rgba8, Format::R8] {
                    let clamped = color
                        .map(|channel| F32s::from_fn(|lane| math::clamp(channel[lane], 0.0, 1.0)));
                    let old = [0, 1, 2, 3].map(|channel: usize| {
                        F32s::from_fn(|lane| match channel {
                            3 if format == Format::R8 => 1.0,
                            _ => (stored[lane] >> (8 * channel) & 0xFF) as f32 / 255.0,
                        })
                    });
                    let sources = [&clamped, blend::NO_SECOND];
                    let general = blend::blend(&state, sources, &old, Some(Encoding::UNIT));
                    let expected = pack(|lane, channel| general[channel][lane]);
                    for isa in Isa::available() {
                        let got = isa.run(Blended(&state, format, color.each_ref(), &stored));
                        assert_eq!(got, expected, "{src:?} {dst:?} {format:?} {}", isa.name());
                    }
                }
            }
        }
    }
}
