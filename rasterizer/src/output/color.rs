//! Colours from shader outputs to attachment words.
//!
//! Bytes in the order red, green, blue, alpha have a kernel of their own; every other format goes
//! through its row of the table of formats.

use super::mask::expand_mask;
use super::{blend, logic};
use crate::attachment::{Old, WordMask, all_bits, decode_color, encode_color};
use crate::desc::{Blend, BlendEquation, BlendFactor, LogicOp};
use texunit::format::convert::byte_channel;
use texunit::format::{BaseFormat, Encoding, Format};
use texunit::lanes::{F32s, Kernel, LANES, PerLane, Simd, U32s, math};

/// What a draw does to one colour attachment.
#[derive(Clone, Debug, PartialEq)]
pub struct ColorPlan {
    /// Which attachment.
    pub target: usize,
    /// The program outputs of red, green, blue, alpha; a component that is not written is 0, alpha 1.
    pub outputs: [Option<usize>; 4],
    /// How texels are written: the format of the attachment, or the linear one of the same bits.
    pub format: Format,
    /// Which kernel writes them.
    pub class: ColorClass,
    /// Blending, if any.
    pub blend: Option<Blend>,
    /// The logical operation, if any.
    pub logic_op: Option<LogicOp>,
    /// Bits of the words that are written.
    pub write: WordMask,
    /// Whether these are all that there are.
    pub whole: bool,
}

/// How the texels of a format are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColorClass {
    /// Bytes: red in the lowest, then green, blue, alpha, as far as there are any.
    Bytes,
    /// Numbers, through the table of formats.
    Numbers,
    /// Integers, which are neither blended nor converted.
    Integers,
}

impl ColorClass {
    fn of(format: Format) -> Self {
        let in_order = match format.base() {
            BaseFormat::Red
            | BaseFormat::Rg
            | BaseFormat::Rgb
            | BaseFormat::Rgba
            | BaseFormat::Luminance => true,
            BaseFormat::Alpha
            | BaseFormat::LuminanceAlpha
            | BaseFormat::Intensity
            | BaseFormat::Depth => false,
        };
        if format.is_integer() {
            Self::Integers
        } else if in_order && format.is_bytes() {
            Self::Bytes
        } else {
            Self::Numbers
        }
    }
}

impl ColorPlan {
    /// What a component is that no program writes: 0, alpha 1.
    #[inline]
    pub fn unwritten(&self, component: usize) -> &'static F32s {
        const ZERO: &F32s = &F32s::ZERO;
        const ONE: &F32s = &F32s::splat(1.0);
        const ONE_INTEGER: &F32s = &F32s::splat(f32::from_bits(1));
        match (component, self.class) {
            (3, ColorClass::Integers) => ONE_INTEGER,
            (3, ColorClass::Bytes | ColorClass::Numbers) => ONE,
            (_, _) => ZERO,
        }
    }

    /// Whether what is written depends on what is stored.
    pub fn old(&self) -> Old {
        let is_read = self.blend.is_some() || self.logic_op.is_some() || !self.whole;
        if is_read { Old::Read } else { Old::Ignored }
    }

    /// [`Self::old`] of a block of which the fragments of a mask are written.
    pub fn old_under(&self, mask: u64) -> Old {
        if mask == !0 { self.old() } else { Old::Read }
    }

    /// The bits that are written of a word of each texel.
    #[inline(always)]
    pub const fn write_of(&self, word: usize) -> Write {
        Write { mask: self.write[word], whole: self.whole }
    }

    /// What is done to an attachment that is written as `format`.
    pub fn new(
        target: usize,
        outputs: [Option<usize>; 4],
        format: Format,
        write: WordMask,
        blend: Option<Blend>,
        logic_op: Option<LogicOp>,
    ) -> Self {
        let is_fixed = match format.info().encoding {
            Encoding::Unorm | Encoding::Snorm | Encoding::Uint | Encoding::Sint => true,
            Encoding::Srgb
            | Encoding::Float
            | Encoding::SharedExponent
            | Encoding::Block(_)
            | Encoding::SrgbBlock(_) => false,
        };
        // A logical operation takes the place of blending (GL 2.1, section 4.1.10), and does
        // nothing to floats.
        let logic_op = logic_op.filter(|_| is_fixed);
        let blend = blend.filter(|_| !format.is_integer() && logic_op.is_none());
        let class = match ColorClass::of(format) {
            ColorClass::Bytes if logic_op.is_some() => ColorClass::Numbers,
            class => class,
        };
        let whole = write == all_bits(format);
        Self { target, outputs, format, class, blend, logic_op, write, whole }
    }
}

/// Which bits of a word are written.
#[derive(Clone, Copy, Debug)]
pub struct Write {
    /// These.
    pub mask: u32,
    /// Whether they are all that there are.
    pub whole: bool,
}

/// `new` in the fragments of a mask, through the write mask.
#[inline(always)]
pub fn put(stored: &mut U32s, new: &U32s, mask: u64, write: Write) {
    if mask == !0 && write.whole {
        *stored = *new;
        return;
    }
    let covered = expand_mask(mask);
    for lane in 0..LANES {
        let write = covered[lane] & write.mask;
        stored[lane] = (new[lane] & write) | (stored[lane] & !write);
    }
}

/// The colours of 64 fragments and where they go.
#[derive(Clone, Copy)]
pub struct BlockColors<'a> {
    /// Which block of the words that are written.
    pub block: usize,
    /// Red, green, blue, alpha of each fragment.
    pub color: [&'a F32s; 4],
    /// Which fragments there are.
    pub mask: u64,
}

/// Blends, packs and writes fragments of [`ColorClass::Bytes`], block after block.
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
        for &BlockColors { block, color, mask } in colors {
            let stored = &mut blocks[block];
            let word = match &plan.blend {
                None => pack(|lane, channel| color[channel][lane]),
                Some(state) => blended_bytes(state, plan.format, color, stored),
            };
            put(stored, &word, mask, plan.write_of(0));
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
fn blended_bytes(state: &Blend, format: Format, color: [&F32s; 4], stored: &U32s) -> U32s {
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
    let blended = blend::blend(state, &sources, &destinations, Some(Encoding::UNIT));
    pack(|lane, channel| blended[channel][lane])
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
        for &BlockColors { block, color, mask } in colors {
            match plan.class {
                ColorClass::Integers => encode_integers(plan.format, color, &mut texels),
                ColorClass::Bytes | ColorClass::Numbers => {
                    let mixed;
                    let color = match &plan.blend {
                        None => color,
                        Some(state) => {
                            let [x, y, z, w] = &words;
                            let stored = [x.get(block), y.get(block), z.get(block), w.get(block)];
                            mixed = blended::<S>(state, plan.format, color, stored);
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
                write.whole &= plan.logic_op.is_none();
                put(stored, &texels[index], mask, write);
            }
        }
    }
}

/// Fragments blended with the texels that are stored, of which there are as many words as the format has.
#[inline(always)]
fn blended<S: Simd>(
    state: &Blend,
    format: Format,
    color: [&F32s; 4],
    stored: [Option<&U32s>; 4],
) -> [F32s; 4] {
    let range = format.info().encoding.range();
    let [r, g, b, a] = color;
    let mut clamped = [*r, *g, *b, *a];
    if let Some([low, high]) = range {
        for values in &mut clamped {
            for lane in 0..LANES {
                values[lane] = math::clamp(values[lane], low, high);
            }
        }
    }
    let [x, y, z, w] = stored;
    const NONE: &U32s = &U32s::ZERO;
    let words = [x.unwrap_or(NONE), y.unwrap_or(NONE), z.unwrap_or(NONE), w.unwrap_or(NONE)];
    let destination = decode_color::<S>(format, words);
    blend::blend(state, &clamped, &destination, range)
}

/// The texels of 64 integer colours, each clamped to what its field can hold: as many words as the format
/// has.
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

#[cfg(test)]
mod tests {
    use super::*;
    use texunit::lanes::Isa;

    struct Blended<'a>(&'a Blend, Format, [&'a F32s; 4], &'a U32s);

    impl Kernel for Blended<'_> {
        type Output = U32s;
        #[inline(always)]
        fn run<S: Simd>(self) -> U32s {
            blended_bytes(self.0, self.1, self.2, self.3)
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
                    let general = blend::blend(&state, &clamped, &old, Some(Encoding::UNIT));
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
