//! Numbers against their definitions in `f64`, there and back, on every instruction set.

use super::*;
use crate::format::{Field, Format};
use crate::lanes::{F64s, Isa, LANES};

/// One number in a word of its own.
fn single(size: usize, shift: u32, bits: u32, code: NumberEncoding) -> PixelLayout {
    PixelLayout::packed(size, 1, ByteOrder::Little, &[(Field { word: 0, shift, bits }, code)])
}

/// Words of so many bytes, the lowest bits of noise and of the ends.
fn words(bits: u32) -> Vec<u32> {
    let mask = u32::MAX >> (32 - bits);
    if bits <= 16 {
        return (0..=mask).collect();
    }
    let noise = (0..6000_u32).map(|i| i.wrapping_mul(0x9E37_79B9) ^ i << 7);
    noise
        .chain([0, 1, mask >> 1, (mask >> 1) + 1, mask - 1, mask])
        .map(|word| word & mask)
        .collect()
}

/// What the bits of a field are, from the text of the specifications.
fn oracle(code: NumberEncoding, bits: u32, word: u32) -> f64 {
    let full = f64::from(bits).exp2();
    let c = f64::from(word);
    let signed = if 2.0 * c >= full { c - full } else { c };
    let float = |mantissa: u32| {
        let (exponent, m) = (word >> mantissa & 31, f64::from(word % (1 << mantissa)));
        let m = m / f64::from(mantissa).exp2();
        match exponent {
            0 => m * (-14_f64).exp2(),
            31 if m == 0.0 => f64::INFINITY,
            31 => f64::NAN,
            _ => (1.0 + m) * (f64::from(exponent) - 15.0).exp2(),
        }
    };
    match code {
        NumberEncoding::Unorm => c / (full - 1.0),
        NumberEncoding::Fixed => (2.0 * signed + 1.0) / (full - 1.0),
        NumberEncoding::Snorm => (signed / (full / 2.0 - 1.0)).max(-1.0),
        NumberEncoding::Srgb => {
            let c = c / 255.0;
            let light = if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
            f64::from(light as f32)
        }
        NumberEncoding::Uint => c,
        NumberEncoding::Sint => signed,
        NumberEncoding::SnormSteps => signed.max(1.0 - full / 2.0),
        NumberEncoding::Float | NumberEncoding::Depth => match bits {
            32 => f32::from_bits(word).into(),
            16 => float(10) * if word >> 15 == 1 { -1.0 } else { 1.0 },
            11 => float(6),
            _ => float(5),
        },
        NumberEncoding::SharedExponent => unreachable!("a word of its own, below"),
    }
}

const CASES: [(NumberEncoding, &[u32]); 9] = [
    (NumberEncoding::Unorm, &[1, 2, 3, 4, 5, 6, 8, 10, 16, 24, 32]),
    (NumberEncoding::Fixed, &[8, 16, 32]),
    (NumberEncoding::Snorm, &[8, 16, 32]),
    (NumberEncoding::Srgb, &[8]),
    (NumberEncoding::Uint, &[2, 8, 10, 16, 32]),
    (NumberEncoding::Sint, &[8, 16, 32]),
    (NumberEncoding::SnormSteps, &[8, 16]),
    (NumberEncoding::Float, &[10, 11, 16, 32]),
    (NumberEncoding::Depth, &[32]),
];

/// Numbers of one field, 64 at a time, on an instruction set.
fn read_all(isa: Isa, record: &PixelLayout, bytes: &[u8]) -> Vec<f64> {
    let mut out = [F64s::ZERO; 4];
    let mut numbers = Vec::new();
    for run in bytes.chunks(LANES * record.bytes()) {
        read(isa, record, run, &mut out);
        numbers.extend_from_slice(&out[0].0[..run.len() / record.bytes()]);
    }
    numbers
}

fn write_all(isa: Isa, record: &PixelLayout, numbers: &[f64]) -> Vec<u32> {
    let mut out = Vec::new();
    for run in numbers.chunks(LANES) {
        let mut batch = F64s::ZERO;
        batch.0[..run.len()].copy_from_slice(run);
        let mut bytes = vec![0; run.len() * 4];
        write(isa, record, [&batch; 4], &mut bytes);
        out.extend(bytes.as_chunks::<4>().0.iter().map(|&word| u32::from_le_bytes(word)));
    }
    out
}

#[test]
fn numbers_are_what_the_specifications_say_and_read_back() {
    for (code, widths) in CASES {
        for &bits in widths {
            for shift in [0, (32 - bits) / 2, 32 - bits] {
                let record = single(4, shift, bits, code);
                let words = words(bits);
                let noise = if bits == 32 {
                    0
                } else {
                    !((u32::MAX >> (32 - bits)) << shift) & 0xA5C3_5A3C
                };
                let bytes: Vec<u8> =
                    words.iter().flat_map(|word| (word << shift | noise).to_le_bytes()).collect();
                for isa in Isa::available() {
                    let numbers = read_all(isa, &record, &bytes);
                    let back = write_all(isa, &record, &numbers);
                    for ((&word, &number), back) in words.iter().zip(&numbers).zip(back) {
                        let want = oracle(code, bits, word);
                        let context = format!("{code:?} {bits} {word:#x} {}", isa.name());
                        assert!(
                            number == want || number.is_nan() && want.is_nan(),
                            "{context}: {number} {want}"
                        );
                        // -1 has two forms, NaN many; depths are clamped.
                        let twice =
                            matches!(code, NumberEncoding::Snorm | NumberEncoding::SnormSteps)
                                && word == 1 << (bits - 1);
                        let held =
                            code == NumberEncoding::Depth && !(0..=0x3F80_0000).contains(&word);
                        if !twice && !held && !number.is_nan() {
                            assert_eq!(back, word << shift, "{context}");
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn numbers_go_to_the_nearest_and_clamp() {
    let odd = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        -0.0,
        1e300,
        -1e300,
        0.5,
        -0.5,
        1.0,
        -1.0,
        1e-310,
    ];
    let noise = (0..4000_u64).map(|i| {
        let bits = i.wrapping_mul(0x9E37_79B9_7F4A_7C15);
        f64::from_bits(bits & 0x800F_FFFF_FFFF_FFFF | (1000 + bits % 60) << 52)
    });
    let numbers: Vec<f64> = odd.into_iter().chain(noise).collect();
    let even = f64::round_ties_even;
    for (code, widths) in CASES {
        for &bits in widths {
            let mask = u32::MAX >> (32 - bits);
            let (all, high) = (f64::from(mask), f64::from(mask >> 1));
            let nearest = |x: f64| -> Option<i64> {
                let number = if x.is_nan() { 0.0 } else { x };
                match code {
                    NumberEncoding::Unorm => Some(even(number.clamp(0.0, 1.0) * all) as i64),
                    NumberEncoding::Fixed => {
                        Some(even((number.clamp(-1.0, 1.0) * all - 1.0) / 2.0) as i64)
                    }
                    NumberEncoding::Snorm => Some(even(number.clamp(-1.0, 1.0) * high) as i64),
                    NumberEncoding::Uint => Some(even(number.clamp(0.0, all)) as i64),
                    NumberEncoding::Sint | NumberEncoding::SnormSteps => {
                        Some(even(number.clamp(-high - 1.0, high)) as i64)
                    }
                    NumberEncoding::Depth => Some((number as f32).clamp(0.0, 1.0).to_bits().into()),
                    // Their own tests are in `format`.
                    NumberEncoding::Srgb
                    | NumberEncoding::Float
                    | NumberEncoding::SharedExponent => None,
                }
            };
            for isa in Isa::available() {
                let got = write_all(isa, &single(4, 0, bits, code), &numbers);
                for (&number, got) in numbers.iter().zip(got) {
                    let Some(want) = nearest(number) else { continue };
                    let want =
                        if code == NumberEncoding::Depth && want == 0x8000_0000 { 0 } else { want };
                    let got =
                        if code == NumberEncoding::Depth && got == 0x8000_0000 { 0 } else { got };
                    assert_eq!(
                        got,
                        want as u32 & mask,
                        "{code:?} {bits} {number:e} {}",
                        isa.name()
                    );
                }
            }
        }
    }
}

#[test]
fn every_record_has_the_words_of_its_bytes_in_either_order() {
    let bytes: Vec<u8> = (0..=255).cycle().take(64 * 16).map(|byte: u8| byte ^ 0x35).collect();
    for size in [1, 2, 4] {
        for count in 1..=4 {
            for order in [ByteOrder::Little, ByteOrder::Big] {
                let record = PixelLayout::uniform(count, size, NumberEncoding::Uint, order);
                assert_eq!(record.bytes(), count * size);
                let isas = Isa::available();
                for (isa, pixels) in isas.iter().flat_map(|&isa| [1, 5, 64].map(|n| (isa, n))) {
                    let bytes = &bytes[..pixels * record.bytes()];
                    let mut numbers = [F64s::ZERO; 4];
                    read(isa, &record, bytes, &mut numbers);
                    for (pixel, lane) in bytes.chunks_exact(record.bytes()).zip(0..) {
                        for (element, number) in pixel.chunks_exact(size).zip(&numbers) {
                            let from = |word: u64, &byte: &u8| word << 8 | u64::from(byte);
                            let want = match order {
                                ByteOrder::Big => element.iter().fold(0, from),
                                ByteOrder::Little => element.iter().rev().fold(0, from),
                            };
                            assert_eq!(number[lane], want as f64);
                        }
                    }
                    let mut back = vec![0xEE; bytes.len()];
                    write(isa, &record, numbers.each_ref(), &mut back);
                    assert_eq!(back, bytes, "{record:?}");
                }
            }
        }
    }
}

/// Where nothing is done to them, numbers that are moved are those that are read and written.
#[test]
fn moves_are_what_reading_and_writing_gives() {
    let noise: Vec<u8> =
        (0..67 * 16_u32).map(|i| (i.wrapping_mul(0x9E37_79B9) >> 24) as u8).collect();
    let sources = [
        [0, 1, 2, 3].map(Source::Field),
        [2, 1, 0, 3].map(Source::Field),
        [Source::Field(0), Source::Zero, Source::One, Source::One],
        [Source::One, Source::Field(0), Source::Field(1), Source::Zero],
    ];
    let (zero, one) = (F64s::ZERO, F64s::splat(1.0));
    let (mut found, mut copies) = (0, 0);
    let records: Vec<PixelLayout> = Format::ALL
        .into_iter()
        .filter(|format| format.block().is_none())
        .map(PixelLayout::of)
        .chain(
            [1, 2, 4]
                .map(|size| PixelLayout::uniform(4, size, NumberEncoding::Unorm, ByteOrder::Big)),
        )
        .collect();
    // NaN and what is written otherwise than it was read: -1 in signed fractions, an exponent that is not shared
    // as written.
    let settled = |record: &PixelLayout| {
        let mut bytes = noise[..67 * record.bytes()].to_vec();
        let mut again = bytes.clone();
        for (from, to) in
            bytes.chunks(64 * record.bytes()).zip(again.chunks_mut(64 * record.bytes()))
        {
            let mut numbers = [F64s::ZERO; 4];
            read(Isa::BASELINE, record, from, &mut numbers);
            for number in numbers.iter_mut().flat_map(|numbers| &mut numbers.0) {
                *number = if number.is_nan() { 0.0 } else { *number };
            }
            write(Isa::BASELINE, record, numbers.each_ref(), to);
        }
        bytes.copy_from_slice(&again);
        bytes
    };
    for from in &records {
        let bytes = settled(from);
        for to in &records {
            for sources in sources {
                for isa in Isa::available() {
                    let Some(moves) = BitMoves::new(isa, from, to, sources) else { continue };
                    let mut got = vec![9; 67 * to.bytes()];
                    move_all(isa, &moves, (from, &bytes), (to, &mut got));
                    let mut want = vec![8; 67 * to.bytes()];
                    let runs = bytes.chunks(64 * from.bytes());
                    for (from_run, to_run) in runs.zip(want.chunks_mut(64 * to.bytes())) {
                        let mut numbers = [F64s::ZERO; 4];
                        read(isa, from, from_run, &mut numbers);
                        let numbers = sources.map(|source| match source {
                            Source::Field(index) => &numbers[index],
                            Source::Zero => &zero,
                            Source::One => &one,
                        });
                        write(isa, to, numbers, to_run);
                    }
                    assert_eq!(got, want, "{from:?} {to:?} {sources:?} {}", isa.name());
                    found += 1;
                    copies += u32::from(moves.is_copy());
                }
            }
        }
    }
    assert!(found > 3000 && copies > 100, "{found} {copies}");
}

#[test]
fn colours_with_a_common_exponent_read_back() {
    let record = PixelLayout::of(Format::Rgb9E5);
    let words: Vec<u32> = (0..u32::MAX).step_by(1_048_573).collect();
    for words in words.chunks(LANES) {
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        for isa in Isa::available() {
            let mut numbers = [F64s::ZERO; 4];
            read(isa, &record, &bytes, &mut numbers);
            for (lane, word) in words.iter().enumerate() {
                let scale = (f64::from(word >> 27) - 24.0).exp2();
                for (channel, numbers) in numbers.iter().enumerate().take(3) {
                    let mantissa = f64::from(word >> (9 * channel) & 0x1FF);
                    assert_eq!(numbers[lane], mantissa * scale, "{word:#x}");
                }
            }
            let (mut back, mut again) = (vec![0; bytes.len()], numbers);
            write(isa, &record, numbers.each_ref(), &mut back);
            read(isa, &record, &back, &mut again);
            assert_eq!(again[..3], numbers[..3]);
        }
    }
}

#[test]
fn means_are_linear_along_both_axes() {
    let value = |x: usize, y: usize| [0, 1, 2, 3].map(|c| (x * (c + 1) + 3 * y) as f64);
    let rows = [0, 1].map(|y| (0..9).map(|x| value(x, y)).collect::<Vec<_>>());
    let taps: Vec<Tap> =
        (0..64).map(|i| Tap { pixels: [i % 8, i % 8 + 1], weight: (i % 5) as f64 / 4.0 }).collect();
    for isa in Isa::available() {
        let mut out = [F64s::ZERO; 4];
        means(isa, [&rows[0], &rows[1]], &taps, 0.25, &mut out);
        for (lane, tap) in taps.iter().enumerate() {
            for (channel, out) in out.iter().enumerate() {
                let x = tap.pixels[0] as f64 + tap.weight;
                assert_eq!(out[lane], x * (channel + 1) as f64 + 0.75, "{}", isa.name());
            }
        }
    }
}

#[test]
fn numbers_are_changed_as_is_said() {
    let odd =
        [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 0.5, -0.5, 1.5, -1.5, 254.5, 1e300];
    let number = |lane: usize| match odd.get(lane) {
        Some(&number) => number,
        None => (lane as f64 - 30.0) * 4.25,
    };
    let mut numbers = F64s::ZERO;
    (0..LANES).for_each(|lane| numbers[lane] = number(lane));
    let whole = |low: f64, high: f64| NumberTransform::Whole { low, high };
    type Case = (NumberTransform, fn(f64) -> f64);
    let cases: [Case; 6] = [
        (NumberTransform::Linear { scale: 0.3, bias: -2.0 }, |x| x * 0.3 - 2.0),
        (NumberTransform::Clamp, |x| x.clamp(0.0, 1.0)),
        (NumberTransform::Float, |x| f64::from(x as f32)),
        (NumberTransform::Ratio { over: 3.0, times: 7.0 }, |x| x / 3.0 * 7.0),
        (whole(0.0, 255.0), |x| (x + 0.5).floor().clamp(0.0, 255.0)),
        (whole(-128.0, 127.0), |x| (x + 0.5).floor().clamp(-128.0, 127.0)),
    ];
    for isa in Isa::available() {
        let mut out = F64s::ZERO;
        for (what, want) in cases {
            transform(isa, what, &numbers, &mut out);
            for lane in 0..LANES {
                let want = match (what, want(number(lane))) {
                    (NumberTransform::Whole { low, .. }, nan) if nan.is_nan() => low,
                    (_, want) => want,
                };
                let is_same = out[lane] == want || out[lane].is_nan() && want.is_nan();
                assert!(is_same, "{what:?} {}: {} {want}", number(lane), out[lane]);
            }
        }
        (0..LANES).for_each(|lane| numbers[lane] = (4 * lane) as f64);
        transform(isa, NumberTransform::SevenBits, &numbers, &mut out);
        (0..LANES).for_each(|lane| assert_eq!(out[lane], (4 * lane % 128) as f64));
        let mut sums = numbers;
        add(isa, 0.75, &out.0, &mut sums.0);
        let want = |lane: usize| 4.0 * lane as f64 + 0.75 * (4 * lane % 128) as f64;
        (0..LANES).for_each(|lane| assert_eq!(sums[lane], want(lane)));
        (0..LANES).for_each(|lane| numbers[lane] = number(lane));
    }
}
