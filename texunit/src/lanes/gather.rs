//! Gathers: the largest index of the batch is checked once, then 64 words are read unchecked.

pub(super) mod rows;
pub(super) mod sixteen;
mod sources;
#[cfg(target_arch = "x86_64")]
pub(super) mod x86;

pub use sources::Sources;

use super::isa::Baseline;
use super::{F32s, Kernel, LANES, Simd, U32s};

/// Panics unless `size` bytes at `index * scale` lie inside `len` bytes in every lane, and every
/// byte offset fits the signed 32 bits that the instructions take.
#[inline(always)]
pub(super) fn check<S: Simd>(len: usize, indices: &U32s, scale: u64, size: u64) {
    let reached = (len as u64).min(i32::MAX as u64);
    // The first index that is too large, if there is room for any.
    let bound = reached.checked_sub(size).map_or(0, |last| last / scale + 1);
    assert!(S::below(indices, bound as u32), "gather at {} of {len} bytes", S::largest(indices));
}

/// [`Simd::gather`].
pub struct Words<'a> {
    pub bytes: &'a [u8],
    pub offsets: &'a U32s,
}

impl Kernel for Words<'_> {
    type Output = U32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> U32s {
        S::gather_inline(self.bytes, self.offsets)
    }
}

/// [`Simd::gather_pairs`].
pub struct Pairs<'a> {
    pub bytes: &'a [u8],
    pub offsets: &'a U32s,
}

impl Kernel for Pairs<'_> {
    type Output = [U32s; 2];
    #[inline(always)]
    fn run<S: Simd>(self) -> [U32s; 2] {
        S::gather_pairs_inline(self.bytes, self.offsets)
    }
}

/// [`Simd::gather_from`].
pub struct WordsFrom<'a> {
    pub sources: &'a Sources<'a>,
    pub numbers: &'a U32s,
    pub offsets: &'a U32s,
}

impl Kernel for WordsFrom<'_> {
    type Output = U32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> U32s {
        let addresses = self.sources.addresses(self.numbers, self.offsets, (4, None));
        // SAFETY: `addresses` saw that these four bytes are inside their slices.
        unsafe { addresses.words() }
    }
}

/// [`Simd::gather_quads_from`].
pub struct QuadsFrom<'a> {
    pub sources: &'a Sources<'a>,
    pub numbers: &'a U32s,
    pub offsets: &'a U32s,
    pub apart: &'a U32s,
    pub out: &'a mut [U32s; 4],
}

impl Kernel for QuadsFrom<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { sources, numbers, offsets, apart, out: [a, b, c, d] } = self;
        let addresses = sources.addresses(numbers, offsets, (8, Some(apart)));
        // SAFETY: `addresses` saw that these eight bytes, and those that are `apart` further, are inside their slices.
        unsafe {
            addresses.pairs(None, [a, b]);
            addresses.pairs(Some(apart), [c, d]);
        }
    }
}

/// A byte of each word.
#[inline(always)]
pub(super) fn bytes(words: &U32s, shift: u32) -> U32s {
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        out[lane] = words[lane] >> (shift & 31) & 0xFF;
    }
    out
}

// Those of the baseline are not inlined: they need no instruction set, and are used in many word_offsets.

#[inline(never)]
pub(super) fn scalar(bytes: &[u8], offsets: &U32s) -> U32s {
    check::<Baseline>(bytes.len(), offsets, 1, 4);
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        // SAFETY: `check` saw that these four bytes are inside `bytes`.
        out[lane] = u32::from_le(unsafe {
            bytes.as_ptr().add(offsets[lane] as usize).cast::<u32>().read_unaligned()
        });
    }
    out
}

#[inline(never)]
pub(super) fn scalar_pairs(bytes: &[u8], offsets: &U32s) -> [U32s; 2] {
    check::<Baseline>(bytes.len(), offsets, 1, 8);
    let mut out = [U32s::ZERO; 2];
    for lane in 0..LANES {
        // SAFETY: `check` saw that these eight bytes are inside `bytes`.
        let pair = u64::from_le(unsafe {
            bytes.as_ptr().add(offsets[lane] as usize).cast::<u64>().read_unaligned()
        });
        out[0][lane] = pair as u32;
        out[1][lane] = (pair >> 32) as u32;
    }
    out
}

#[inline(never)]
pub(super) fn scalar_fours(bytes: &[u8], offsets: &U32s) -> [U32s; 4] {
    check::<Baseline>(bytes.len(), offsets, 1, 16);
    let mut out = [U32s::ZERO; 4];
    for lane in 0..LANES {
        // SAFETY: `check` saw that these sixteen bytes are inside `bytes`.
        let four = unsafe {
            bytes.as_ptr().add(offsets[lane] as usize).cast::<[u32; 4]>().read_unaligned()
        };
        for (out, word) in out.iter_mut().zip(four) {
            out[lane] = u32::from_le(word);
        }
    }
    out
}

#[inline(never)]
pub(super) fn scalar_f32(table: &[f32], indices: &U32s) -> F32s {
    check::<Baseline>(size_of_val(table), indices, 4, 4);
    let mut out = F32s::ZERO;
    for lane in 0..LANES {
        // SAFETY: `check` saw that this element is inside `table`.
        out[lane] = unsafe { *table.as_ptr().add(indices[lane] as usize) };
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::Isa;

    struct Table<'a>(&'a [f32], &'a U32s);
    impl Kernel for Table<'_> {
        type Output = F32s;
        #[inline(always)]
        fn run<S: Simd>(self) -> F32s {
            S::gather_f32(self.0, self.1)
        }
    }

    /// A gather operation, outlined and inlined.
    #[derive(Clone, Copy, Debug)]
    enum GatherOp {
        Words,
        Pairs,
        Fours,
        /// Of pairs that are one behind the other.
        Quads,
        /// From several slices, which are the same.
        WordsFrom,
        QuadsFrom,
    }

    /// What each reads of a lane, in bytes.
    const SIZES: [(GatherOp, usize); 6] = [
        (GatherOp::Words, 4),
        (GatherOp::Pairs, 8),
        (GatherOp::Fours, 16),
        (GatherOp::Quads, 16),
        (GatherOp::WordsFrom, 4),
        (GatherOp::QuadsFrom, 16),
    ];

    /// Which slice a lane reads.
    fn numbers() -> U32s {
        U32s::from_fn(|lane| [0, 7, Sources::ROOM as u32 - 1][lane % 3])
    }

    struct Gather<'a>(GatherOp, &'a [u8], &'a U32s);
    impl Kernel for Gather<'_> {
        type Output = Vec<U32s>;
        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let Self(op, bytes, offsets) = self;
            match op {
                GatherOp::Words => {
                    vec![S::gather(bytes, offsets), S::gather_inline(bytes, offsets)]
                }
                GatherOp::Pairs => {
                    [S::gather_pairs(bytes, offsets), S::gather_pairs_inline(bytes, offsets)]
                        .concat()
                }
                GatherOp::Fours => S::gather_fours(bytes, offsets).to_vec(),
                GatherOp::Quads => {
                    let mut out = [U32s::ZERO; 4];
                    S::gather_quads(bytes, offsets, 8, &mut out);
                    out.to_vec()
                }
                GatherOp::WordsFrom | GatherOp::QuadsFrom => {
                    let (mut sources, numbers) = (Sources::empty(), numbers());
                    numbers.0.iter().for_each(|&number| sources.set(number as usize, bytes));
                    if matches!(op, GatherOp::WordsFrom) {
                        return vec![S::gather_from(&sources, &numbers, offsets)];
                    }
                    let (mut out, apart) = ([U32s::ZERO; 4], U32s::splat(8));
                    S::gather_quads_from(&sources, &numbers, offsets, &apart, &mut out);
                    out.to_vec()
                }
            }
        }
    }

    #[test]
    fn every_instruction_set_gathers_the_same_unaligned_words() {
        let bytes: Vec<u8> = (0..1024u32).map(|i| (i * 37 + i / 7) as u8).collect();
        let offsets = U32s::from_fn(|lane| (lane as u32 * 131) % 1009);
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
        // The byte offsets of the words in each returned batch.
        let ops: [(GatherOp, &[usize]); 6] = [
            (GatherOp::Words, &[0, 0]),
            (GatherOp::Pairs, &[0, 4, 0, 4]),
            (GatherOp::Fours, &[0, 4, 8, 12]),
            (GatherOp::Quads, &[0, 4, 8, 12]),
            (GatherOp::WordsFrom, &[0]),
            (GatherOp::QuadsFrom, &[0, 4, 8, 12]),
        ];
        for isa in Isa::available() {
            for (op, word_offsets) in ops {
                let got = isa.run(Gather(op, &bytes, &offsets));
                assert_eq!(got.len(), word_offsets.len());
                for (words, offset) in got.iter().zip(word_offsets) {
                    for lane in 0..LANES {
                        let want = word(offsets[lane] as usize + offset);
                        assert_eq!(words[lane], want, "{} {op:?} lane {lane}", isa.name());
                    }
                }
            }
        }
    }

    #[test]
    #[cfg_attr(target_family = "wasm", ignore = "a panic ends the program there")]
    fn a_gather_outside_its_slice_panics_on_every_instruction_set() {
        let bytes = [0; 64];
        for isa in Isa::available() {
            let ops = [
                (GatherOp::Words, 60),
                (GatherOp::Pairs, 56),
                (GatherOp::Fours, 48),
                (GatherOp::Quads, 48),
                (GatherOp::WordsFrom, 60),
                (GatherOp::QuadsFrom, 48),
            ];
            for (op, last) in ops {
                let mut offsets = U32s::ZERO;
                offsets[63] = last;
                isa.run(Gather(op, &bytes, &offsets));
                for bad in [last + 1, 64, u32::MAX, 1 << 31] {
                    offsets[63] = bad;
                    let run = std::panic::catch_unwind(|| isa.run(Gather(op, &bytes, &offsets)));
                    assert!(run.is_err(), "{} {op:?} took offset {bad}", isa.name());
                }
            }
        }
    }

    /// A gather whose lanes have these numbers of slices and distances.
    struct From<'a>(&'a Sources<'a>, &'a U32s, &'a U32s);
    impl Kernel for From<'_> {
        type Output = [U32s; 5];
        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let Self(sources, numbers, apart) = self;
            let word = S::gather_from(sources, numbers, &U32s::ZERO);
            let mut out = [U32s::ZERO; 4];
            S::gather_quads_from(sources, numbers, &U32s::ZERO, apart, &mut out);
            let [a, b, c, d] = out;
            [word, a, b, c, d]
        }
    }

    #[test]
    fn each_lane_gathers_from_its_own_slice_at_its_own_distance() {
        let slices: Vec<Vec<u8>> =
            (0..5).map(|n: u8| (0..40 + n).map(|i| i + 50 * n).collect()).collect();
        let mut sources = Sources::empty();
        for (number, slice) in slices.iter().enumerate() {
            sources.set(number, slice);
        }
        sources.set(Sources::ROOM, &slices[0]);
        let numbers = U32s::from_fn(|lane| lane as u32 % 5);
        let apart = U32s::from_fn(|lane| lane as u32 % 33);
        for isa in Isa::available() {
            let got = isa.run(From(&sources, &numbers, &apart));
            for lane in 0..LANES {
                let (slice, up) = (&slices[lane % 5], lane % 33);
                for (words, at) in got.iter().zip([0, 0, 4, up, up + 4]) {
                    let want = u32::from_le_bytes(slice[at..at + 4].try_into().unwrap());
                    assert_eq!(words[lane], want, "{} lane {lane} at {at}", isa.name());
                }
            }
        }
    }

    #[test]
    #[cfg_attr(target_family = "wasm", ignore = "a panic ends the program there")]
    fn a_gather_from_no_slice_or_too_far_up_panics() {
        let bytes = [0; 40];
        let mut sources = Sources::empty();
        sources.set(3, &bytes);
        for isa in Isa::available() {
            let run = |number: u32, up: u32| {
                let (mut numbers, mut apart) = (U32s::splat(3), U32s::splat(32));
                (numbers[40], apart[41]) = (number, up);
                std::panic::catch_unwind(|| isa.run(From(&sources, &numbers, &apart)))
            };
            assert!(run(3, 32).is_ok());
            let room = Sources::ROOM as u32;
            for (number, up) in
                [(2, 32), (room, 32), (room + 3, 32), (u32::MAX, 32), (3, 33), (3, u32::MAX)]
            {
                assert!(run(number, up).is_err(), "{} took slice {number}, {up}", isa.name());
            }
        }
    }

    // Here and below, separate allocations, so that Miri detects a read past the end.

    #[test]
    fn a_gather_takes_the_last_bytes() {
        for isa in Isa::available() {
            for (op, size) in SIZES {
                for begin in [0, 1, 3] {
                    let bytes = vec![7_u8; begin + size].into_boxed_slice();
                    let got = isa.run(Gather(op, &bytes, &U32s::splat(begin as u32)));
                    assert!(got.iter().all(|words| *words == U32s::splat(0x0707_0707)));
                }
            }
            let table = vec![2.5; 3].into_boxed_slice();
            assert_eq!(isa.run(Table(&table, &U32s::splat(2))), F32s::splat(2.5));
        }
    }

    #[test]
    #[cfg_attr(target_family = "wasm", ignore = "a panic ends the program there")]
    fn a_gather_takes_none_of_too_few_bytes() {
        for isa in Isa::available() {
            for (op, size) in SIZES {
                for length in [0, size - 1] {
                    let bytes = vec![0_u8; length].into_boxed_slice();
                    let run = std::panic::catch_unwind(|| isa.run(Gather(op, &bytes, &U32s::ZERO)));
                    assert!(run.is_err(), "{} {op:?} of {length} bytes", isa.name());
                }
            }
            let table = vec![2.5; 3].into_boxed_slice();
            for index in [3, u32::MAX / 4 + 1, u32::MAX] {
                let indices = U32s::splat(index);
                let run = std::panic::catch_unwind(|| isa.run(Table(&table, &indices)));
                assert!(run.is_err(), "{} took index {index} of 3", isa.name());
            }
        }
    }
}
