//! Pixels as numbers and back, 64 at a time.

use super::layout::{ByteOrder, Load, PixelLayout, Store};
use super::number::{self, NumberEncoding};
use crate::lanes::{F32s, F64s, Isa, Kernel, Simd, U32s};

/// The numbers of 64 pixels: a batch per field of the layout.
pub type Numbers = [F64s; 4];

struct Read<'a> {
    record: &'a PixelLayout,
    words: &'a [U32s; 4],
    out: &'a mut Numbers,
}

impl Kernel for Read<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        for (&(field, code), out) in self.record.fields().iter().zip(self.out) {
            code.read(field, &self.words[field.word], out);
        }
    }
}

pub(super) struct Write<'a> {
    pub record: &'a PixelLayout,
    pub numbers: [&'a F64s; 4],
    pub out: &'a mut [U32s; 4],
}

impl Kernel for Write<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        for (&(field, code), numbers) in self.record.fields().iter().zip(self.numbers) {
            code.write(field, numbers, &mut self.out[field.word]);
        }
        if let Some((field, _)) = self.record.shared_exponent() {
            number::write_shared_exponent(self.numbers, &mut self.out[field.word]);
        }
    }
}

/// The numbers of up to 64 pixels, tightly packed in `bytes`. Fields that the layout
/// does not have, and lanes without a pixel, are undefined.
pub fn read(isa: Isa, record: &PixelLayout, bytes: &[u8], out: &mut Numbers) {
    let mut words = [U32s::ZERO; 4];
    record.load(isa, bytes, &mut words);
    isa.run(Read { record, words: &words, out });
}

/// [`read`] within a kernel.
#[inline(always)]
pub(crate) fn read_by<S: Simd>(record: &PixelLayout, bytes: &[u8], out: &mut Numbers) {
    let mut words = [U32s::ZERO; 4];
    S::outlined(Load { record, bytes, words: &mut words });
    S::outlined(Read { record, words: &words, out });
}

/// [`write`] within a kernel.
#[inline(always)]
pub(crate) fn write_by<S: Simd>(record: &PixelLayout, numbers: [&F64s; 4], bytes: &mut [u8]) {
    let mut words = [U32s::ZERO; 4];
    S::outlined(Write { record, numbers, out: &mut words });
    S::outlined(Store { record, words: &mut words, bytes });
}

/// Up to 64 pixels with these numbers into `bytes`, tightly packed: clamped to the range of each field, and
/// rounded to nearest, halves to even.
pub fn write(isa: Isa, record: &PixelLayout, numbers: [&F64s; 4], bytes: &mut [u8]) {
    let mut words = [U32s::ZERO; 4];
    isa.run(Write { record, numbers, out: &mut words });
    record.store(isa, &mut words, bytes);
}

/// Up to 64 pixels of four `f32` each into `bytes`, tightly packed.
pub fn write_floats(isa: Isa, channels: [&F32s; 4], bytes: &mut [u8]) {
    let record = PixelLayout::uniform(4, 4, NumberEncoding::Float, ByteOrder::Little);
    let mut words = channels.map(|channel| *channel.as_u32());
    record.store(isa, &mut words, bytes);
}
