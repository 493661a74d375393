//! Moves of bits between pixel layouts whose numbers are encoded alike, without conversion.

use super::numbers::Write;
use super::{NumberEncoding, PixelLayout};
use crate::format::Field;
use crate::lanes::{F64s, Isa, Kernel, LANES, Simd, U32s};

/// The source of a number of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The number of this field.
    Field(usize),
    /// 0.
    Zero,
    /// 1.
    One,
}

/// Bits of a word: rotated to the left, then masked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct FieldMove {
    from: usize,
    to: usize,
    rotation: u32,
    mask: u32,
}

/// The moves that make the words of one layout from those of another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BitMoves {
    moves: Vec<FieldMove>,
    /// Constant bits of each word.
    constant: [u32; 4],
    is_copy: bool,
}

/// Whether the bits of a number are the same in both encodings, for fields of the same width.
fn is_same(from: NumberEncoding, to: NumberEncoding) -> bool {
    match (from, to) {
        // Stored depths are in range.
        (NumberEncoding::Depth, NumberEncoding::Float) => true,
        (
            NumberEncoding::Unorm
            | NumberEncoding::Fixed
            | NumberEncoding::Snorm
            | NumberEncoding::Srgb
            | NumberEncoding::Uint
            | NumberEncoding::Sint
            | NumberEncoding::SnormSteps
            | NumberEncoding::Float
            | NumberEncoding::Depth
            | NumberEncoding::SharedExponent,
            to,
        ) => from == to,
    }
}

impl BitMoves {
    /// Each number of `to` from its source; `None` where a number has other bits than in `from`.
    pub fn new(
        isa: Isa,
        from: &PixelLayout,
        to: &PixelLayout,
        sources: [Source; 4],
    ) -> Option<Self> {
        let mut ones = None;
        let mut out = Self { moves: Vec::new(), constant: [0; 4], is_copy: false };
        for (&(field, code), source) in to.fields().iter().zip(sources) {
            match source {
                Source::Field(index) => {
                    let &(old, old_code) = from.fields().get(index)?;
                    if old.bits != field.bits || !is_same(old_code, code) {
                        return None;
                    }
                    // Its exponent belongs to the others, too.
                    if code == NumberEncoding::SharedExponent && old != field {
                        return None;
                    }
                    out.add(old, field);
                }
                Source::Zero | Source::One if code == NumberEncoding::SharedExponent => {
                    return None;
                }
                Source::Zero => {}
                Source::One => {
                    let ones = ones.get_or_insert_with(|| constants(isa, to));
                    out.constant[field.word] |= ones[field.word] & field.mask() << field.shift;
                }
            }
        }
        if let Some((field, _)) = to.shared_exponent() {
            out.add(Field { shift: 27, bits: 5, ..field }, Field { shift: 27, bits: 5, ..field });
        }
        let whole = |word: usize| FieldMove { from: word, to: word, rotation: 0, mask: to.mask() };
        out.is_copy = from.lies_as(to)
            && out.moves.len() == to.words()
            && (0..to.words()).all(|word| out.moves.contains(&whole(word)));
        Some(out)
    }

    /// A field to another of its width.
    fn add(&mut self, from: Field, to: Field) {
        let rotation = to.shift.wrapping_sub(from.shift) % 32;
        let mask = to.mask() << to.shift;
        let same = |old: &&mut FieldMove| {
            (old.from, old.to, old.rotation) == (from.word, to.word, rotation)
        };
        match self.moves.iter_mut().find(same) {
            Some(old) => old.mask |= mask,
            None => self.moves.push(FieldMove { from: from.word, to: to.word, rotation, mask }),
        }
    }

    /// Whether all bytes stay where they are.
    pub fn is_copy(&self) -> bool {
        self.is_copy
    }

    /// The words of 64 pixels from those that they come from.
    pub(super) fn run(&self, isa: Isa, words: &[U32s; 4], out: &mut [U32s; 4]) {
        for (out, constant) in out.iter_mut().zip(self.constant) {
            *out = U32s::splat(constant);
        }
        for &step in &self.moves {
            isa.run(RotateWords { step, words: &words[step.from], out: &mut out[step.to] });
        }
    }
}

struct RotateWords<'a> {
    step: FieldMove,
    words: &'a U32s,
    out: &'a mut U32s,
}

impl Kernel for RotateWords<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let FieldMove { rotation, mask, .. } = self.step;
        for lane in 0..LANES {
            self.out[lane] |= self.words[lane].rotate_left(rotation) & mask;
        }
    }
}

/// The words of a pixel whose numbers are all 1.
fn constants(isa: Isa, record: &PixelLayout) -> [u32; 4] {
    let ones = F64s::splat(1.0);
    let mut words = [U32s::ZERO; 4];
    isa.run(Write { record, numbers: [&ones; 4], out: &mut words });
    words.map(|words| words[0])
}

/// Converts all pixels of `from` to the layout of `to`.
pub fn move_all(
    isa: Isa,
    moves: &BitMoves,
    from: (&PixelLayout, &[u8]),
    to: (&PixelLayout, &mut [u8]),
) {
    let ((from_record, from), (to_record, to)) = (from, to);
    if moves.is_copy() {
        to.copy_from_slice(from);
        return;
    }
    let (mut words, mut moved) = ([U32s::ZERO; 4], [U32s::ZERO; 4]);
    let runs = from.chunks(LANES * from_record.bytes());
    for (from, to) in runs.zip(to.chunks_mut(LANES * to_record.bytes())) {
        from_record.load(isa, from, &mut words);
        moves.run(isa, &words, &mut moved);
        to_record.store(isa, &mut moved, to);
    }
}
