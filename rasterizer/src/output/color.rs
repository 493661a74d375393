//! Colours from shader outputs to attachment words.
//!
//! Bytes in the order red, green, blue, alpha have a kernel of their own; every other format goes
//! through its row of the table of formats.

use super::encode::{decode_color, encode_color, unorm};
use super::mask::expand_mask;
use super::{blend, logic};
use crate::driver::{Blend, LogicOp};
use crate::target::{WordMask, all_bits};
use texunit::format::{BaseFormat, Encoding, Format};
use texunit::lanes::{F32s, Kernel, LANES, Simd, U32s, math};

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

/// `new` in the fragments of a mask, through the write mask.
#[inline(always)]
fn put(stored: &mut U32s, new: &U32s, mask: u64, write: u32, whole: bool) {
    if mask == !0 && whole {
        *stored = *new;
        return;
    }
    let covered = expand_mask(mask);
    for lane in 0..LANES {
        let write = covered[lane] & write;
        stored[lane] = (new[lane] & write) | (stored[lane] & !write);
    }
}

/// Blends, packs and writes 64 fragments of [`ColorClass::Bytes`].
pub struct WriteBytes<'a> {
    /// What is done.
    pub plan: &'a ColorPlan,
    /// Red, green, blue, alpha of each fragment.
    pub color: [&'a F32s; 4],
    /// The attachment's words.
    pub stored: &'a mut U32s,
    /// Which fragments there are.
    pub mask: u64,
}

impl Kernel for WriteBytes<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, color, stored, mask } = self;
        let mut word = U32s::ZERO;
        match &plan.blend {
            None => {
                for (channel, values) in color.into_iter().enumerate() {
                    for lane in 0..LANES {
                        word[lane] |= unorm(values[lane], 255.0) << (8 * channel);
                    }
                }
            }
            Some(state) => {
                let mut source = [F32s::ZERO; 4];
                for channel in 0..4 {
                    for lane in 0..LANES {
                        source[channel][lane] = math::clamp(color[channel][lane], 0.0, 1.0);
                    }
                }
                let mut destination = [F32s::ZERO; 4];
                let channels = plan.format.channels();
                for (channel, out) in destination.iter_mut().enumerate().take(channels) {
                    for lane in 0..LANES {
                        out[lane] = (stored[lane] >> (8 * channel) & 0xFF) as i32 as f32 / 255.0;
                    }
                }
                if channels < 4 {
                    destination[3] = F32s::splat(1.0);
                }
                let blended = blend::blend(state, &source, &destination, blend::UNIT);
                for (channel, values) in blended.iter().enumerate() {
                    for lane in 0..LANES {
                        word[lane] |= unorm(values[lane], 255.0) << (8 * channel);
                    }
                }
            }
        }
        put(stored, &word, mask, plan.write[0], plan.whole);
    }
}

/// Blends, packs and writes 64 fragments of any class.
pub struct WriteTexels<'a> {
    /// What is done.
    pub plan: &'a ColorPlan,
    /// Red, green, blue, alpha of each fragment; integers as their bits.
    pub color: [&'a F32s; 4],
    /// The attachment's words.
    pub stored: &'a mut [U32s; 4],
    /// Which fragments there are.
    pub mask: u64,
}

impl Kernel for WriteTexels<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, color, stored, mask } = self;
        let [r, g, b, a] = color;
        let source = [*r, *g, *b, *a];
        let mut words = match plan.class {
            ColorClass::Integers => encode_integers(plan.format, &source),
            ColorClass::Bytes | ColorClass::Numbers => match &plan.blend {
                None => encode_color(plan.format, &source),
                Some(state) => {
                    let range = blend::range(plan.format);
                    let mut clamped = source;
                    if let Some([low, high]) = range {
                        for values in &mut clamped {
                            for lane in 0..LANES {
                                values[lane] = math::clamp(values[lane], low, high);
                            }
                        }
                    }
                    let destination = decode_color::<S>(plan.format, stored);
                    encode_color(plan.format, &blend::blend(state, &clamped, &destination, range))
                }
            },
        };
        for index in 0..4 {
            if plan.write[index] == 0 {
                continue;
            }
            if let Some(op) = plan.logic_op {
                logic::apply(op, &mut words[index], &stored[index]);
            }
            // Bits that no field has stay as they were under a logical operation.
            let whole = plan.whole && plan.logic_op.is_none();
            put(&mut stored[index], &words[index], mask, plan.write[index], whole);
        }
    }
}

/// The texels of 64 integer colours, each clamped to what its field can hold.
#[inline(always)]
fn encode_integers(format: Format, rgba: &[F32s; 4]) -> [U32s; 4] {
    let info = format.info();
    let is_signed = info.encoding == Encoding::Sint;
    let mut out = [U32s::ZERO; 4];
    for (channel, &source) in format.base().sources().iter().enumerate() {
        let field = info.fields[channel];
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
    out
}
