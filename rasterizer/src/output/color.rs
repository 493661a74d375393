//! Colours from shader outputs to attachment words.
//!
//! Bytes in the order red, green, blue, alpha have a kernel of their own; every other format goes
//! through its row of the table of formats.

mod bytes;
mod texels;

pub use bytes::{
    BlockColors, BlockOfPlanes, Color, StoreSamples, WriteBytes, WriteSampledBytes, pack_colors,
};
pub use texels::WriteTexels;

use crate::attachment::{LoadOp, WordMask, all_bits, expand_mask};
use crate::desc::{Blend, LogicOp};
use texunit::format::{BaseFormat, Encoding, Format};
use texunit::lanes::{F32s, LANES, U32s};

/// What a draw does to one colour attachment.
#[derive(Clone, Debug, PartialEq)]
pub struct ColorPlan {
    /// Which attachment.
    pub target: usize,
    /// The program outputs of red, green, blue, alpha; a component that is not written is 0, alpha 1.
    pub outputs: [Option<usize>; 4],
    /// The program outputs of the second colour, if blending reads it; a component that is not written is 0.
    pub second: Option<[Option<usize>; 4]>,
    /// How texels are written: the format of the attachment, or the linear one of the same bits.
    pub format: Format,
    /// Which kernel writes them.
    pub class: ColorClass,
    /// Blending, if any.
    pub blend: Option<Blend>,
    /// How blocks of opaque fragments are blended.
    pub opaque: OpaqueBlocks,
    /// The logical operation, if any.
    pub logic_op: Option<LogicOp>,
    /// Bits of the words that are written.
    pub write: WordMask,
    /// Whether these are all bits of the format.
    pub all_bits_written: bool,
}

/// How 64 fragments are blended whose alpha is 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OpaqueBlocks {
    /// As any others.
    #[default]
    Blended,
    /// They replace what is stored: the formula leaves nothing of it.
    Replaced,
}

/// How the texels of a format are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColorClass {
    /// Bytes: red in the lowest, then green, blue, alpha, as far as there are any.
    Bytes,
    /// Numbers that the table of formats converts.
    Converted,
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
            Self::Converted
        }
    }
}

impl ColorPlan {
    /// Whether what was there before has no effect.
    pub fn overwrites(&self) -> bool {
        self.blend.is_none() && self.logic_op.is_none() && self.all_bits_written
    }

    /// What a component is that no program writes: 0, alpha 1.
    #[inline]
    pub fn unwritten(&self, component: usize) -> &'static F32s {
        const ZERO: &F32s = &F32s::ZERO;
        const ONE: &F32s = &F32s::splat(1.0);
        const ONE_INTEGER: &F32s = &F32s::splat(f32::from_bits(1));
        match (component, self.class) {
            (3, ColorClass::Integers) => ONE_INTEGER,
            (3, ColorClass::Bytes | ColorClass::Converted) => ONE,
            (_, _) => ZERO,
        }
    }

    /// The second colour, if blending reads it, of the outputs of a program.
    #[inline(always)]
    pub fn second_color<'a>(&self, output: impl Fn(usize) -> &'a F32s) -> Option<[&'a F32s; 4]> {
        self.second.map(|outputs| outputs.map(|at| at.map_or(&F32s::ZERO, &output)))
    }

    /// Whether the stored texels are read: by blending, by a logical operation, or as the write mask keeps bits.
    pub fn load_op(&self) -> LoadOp {
        let is_read = self.blend.is_some() || self.logic_op.is_some() || !self.all_bits_written;
        if is_read { LoadOp::Load } else { LoadOp::DontCare }
    }

    /// [`Self::load_op`] of a block of which the fragments of a mask are written.
    pub fn load_op_for_mask(&self, mask: u64) -> LoadOp {
        if mask == !0 { self.load_op() } else { LoadOp::Load }
    }

    /// The bits that are written of a word of each texel.
    #[inline(always)]
    pub const fn write_of(&self, word: usize) -> Write {
        Write { mask: self.write[word], all_bits_written: self.all_bits_written }
    }

    /// What is done to an attachment that is written as `format`.
    pub fn new(
        target: usize,
        [outputs, second]: [[Option<usize>; 4]; 2],
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
            ColorClass::Bytes if logic_op.is_some() => ColorClass::Converted,
            class => class,
        };
        let all_bits_written = write == all_bits(format);
        let second = blend.is_some_and(|blend| blend.reads_second_color()).then_some(second);
        let opaque = OpaqueBlocks::Blended;
        Self {
            target,
            outputs,
            second,
            format,
            class,
            blend,
            opaque,
            logic_op,
            write,
            all_bits_written,
        }
    }
}

/// Which bits of a word are written.
#[derive(Clone, Copy, Debug)]
pub struct Write {
    /// The bits that are written.
    pub mask: u32,
    /// Whether these are all bits of the format.
    pub all_bits_written: bool,
}

/// Stores `new` in the fragments of a mask, through the write mask.
#[inline(always)]
pub fn store_masked(stored: &mut U32s, new: &U32s, mask: u64, write: Write) {
    if mask == !0 && write.all_bits_written {
        *stored = *new;
        return;
    }
    let covered = expand_mask(mask);
    for lane in 0..LANES {
        let write = covered[lane] & write.mask;
        stored[lane] = (new[lane] & write) | (stored[lane] & !write);
    }
}
