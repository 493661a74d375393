//! `packSnorm2x16` and its family.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::packing::Packing;
use crate::probe::{Dialect, ProbeError};
use crate::rng::Rng;

const PACK_WHY: &str = "0.5: a number is rounded to the next code, either at the middle; 2^-8: the f32 product before \
                        that, below 2^16, is rounded to 2^-24 of itself";
const PACK_TOLERANCE: f64 = 0.5 + 1.0 / 256.0;

const fn pack(name: &'static str, what: &'static str, run: Run) -> Check {
    Check {
        name,
        citation: "GLSL ES 3.00, 8.4",
        what,
        unit: Unit::Codes,
        tolerance: PACK_TOLERANCE,
        why: PACK_WHY,
        run,
    }
}

/// `tolerance` is 0.5 ULP where a fraction is rounded, none where halves are numbers of f32.
const fn unpack(name: &'static str, what: &'static str, tolerance: f64, run: Run) -> Check {
    Check {
        name,
        citation: "GLSL ES 3.00, 8.4",
        what,
        unit: Unit::Ulp,
        tolerance,
        why: "one rounding of the exact fraction to f32; halves are f32",
        run,
    }
}

type Run = fn(&Harness, &mut Tally) -> Result<(), ProbeError>;

/// All of them.
pub const ALL: [Check; 6] = [
    pack("pack-snorm", "round(clamp(c, -1, 1) · 32767) of numbers in and out of range", |h, t| {
        packed(h, t, Packing::Snorm)
    }),
    pack("pack-unorm", "round(clamp(c, 0, 1) · 65535) of numbers in and out of range", |h, t| {
        packed(h, t, Packing::Unorm)
    }),
    Check {
        tolerance: 0.0,
        why: "the nearest half, ties to even",
        ..pack("pack-half", "ties, denormals, overflow, infinities and NaN as halves", |h, t| {
            packed(h, t, Packing::Half)
        })
    },
    unpack("unpack-snorm", "clamp(f / 32767, -1, 1) of all codes", 0.5, |h, t| {
        unpacked(h, t, Packing::Snorm)
    }),
    unpack("unpack-unorm", "f / 65535 of all codes", 0.5, |h, t| unpacked(h, t, Packing::Unorm)),
    unpack("unpack-half", "all halves, denormals, infinities and NaN among them", 0.0, |h, t| {
        unpacked(h, t, Packing::Half)
    }),
];

fn packed(harness: &Harness, tally: &mut Tally, packing: Packing) -> Result<(), ProbeError> {
    let mut rng = Rng::named(packing.name());
    let cases: Vec<[f32; 2]> =
        (0..harness.cases(16384)).map(|_| [0; 2].map(|_: i32| number(&mut rng, packing))).collect();
    let end = |c: &f32| c.abs() > 1.0;
    let beyond = cases.as_flattened().iter().filter(|c| end(c)).count();
    tally.reach("numbers out of [-1, 1]", beyond, cases.len() / 8);
    let expect = |case: &[f32; 2], variant: Variant| {
        let [a, b] = Packing::halves(case.map(|c| packing.code(c.into(), variant)), variant);
        [a, b, 0.0, 0.0]
    };
    let scene = packing.name();
    harness.compare_with(Dialect::Es, tally, &scene, &cases, expect, |session| {
        let inputs: Vec<_> =
            cases.iter().map(|c| [[c[0].to_bits(), c[1].to_bits(), 0, 0], [0; 4]]).collect();
        let body = format!(
            "uvec4 value(uvec4 a, uvec4 b) {{
                 return uvec4(pack{scene}(uintBitsToFloat(a.xy)), 0u, 0u, 0u);
             }}"
        );
        let code = |half: u32| match packing {
            Packing::Snorm => f64::from(half as u16 as i16),
            Packing::Unorm => f64::from(half & 0xffff),
            // There are many NaN of either sign, and each will do.
            Packing::Half if half & 0x7fff > 0x7c00 => f64::from(0x7e00),
            Packing::Half => f64::from(half & 0xffff),
        };
        let words = session.words(&body, &inputs)?;
        Ok(words.into_iter().map(|[w, ..]| [code(w), code(w >> 16), 0.0, 0.0]).collect())
    })
}

fn number(rng: &mut Rng, packing: Packing) -> f32 {
    match packing {
        Packing::Snorm | Packing::Unorm => match rng.integer(0, 7) {
            0 => rng.pick(&[-1.0, 1.0, 0.0, -0.0, 1e30, -1e30, f32::INFINITY, -1e-42]),
            1 => rng.real(-3.0, 3.0),
            2 => rng.real(-40.0, 0.0).exp2(),
            _ => rng.real(-1.2, 1.2),
        },
        Packing::Half => {
            let code = rng.integer(0, 0x7bff) as u32;
            // A half, and the middle between it and the next, or a little beside that.
            let (exponent, mantissa) = (code >> 10, (code & 1023) as f32);
            let (base, step) = if exponent == 0 {
                (0.0, (-24f32).exp2())
            } else {
                let step = (exponent as f32 - 25.0).exp2();
                (1024.0 * step, step)
            };
            let x = base + (mantissa + rng.pick(&[0.0, 0.5, 0.5, 0.498, 0.502, 0.25])) * step;
            let special = [f32::NAN, f32::INFINITY, 65504.0, 65519.99, 65520.0, 1e30, 1e-40];
            let x = if rng.integer(0, 15) == 0 { rng.pick(&special) } else { x };
            if rng.integer(0, 1) == 0 { x } else { -x }
        }
    }
}

fn unpacked(harness: &Harness, tally: &mut Tally, packing: Packing) -> Result<(), ProbeError> {
    // Every code is in a lower half and in a higher one.
    let stride = 65536 / harness.cases(65536).min(65536);
    let cases: Vec<u32> = (0..65536u32)
        .step_by(stride)
        .map(|code| code | code.wrapping_mul(0x9e37).wrapping_add(0x8000) << 16)
        .collect();
    let least = if stride == 1 { 65536 } else { 65536 / 16 };
    tally.reach("codes", cases.len(), least);
    let expect = |&word: &u32, variant: Variant| {
        let halves = Packing::halves([word as u16, (word >> 16) as u16], variant);
        let [a, b] = halves.map(|code| packing.component(code, variant));
        [a, b, 0.0, 0.0]
    };
    let scene = packing.name();
    harness.compare_with(Dialect::Es, tally, &scene, &cases, expect, |session| {
        let inputs: Vec<_> = cases.iter().map(|&word| [[word, 0, 0, 0], [0; 4]]).collect();
        let body = format!(
            "uvec4 value(uvec4 a, uvec4 b) {{
                 return uvec4(floatBitsToUint(unpack{scene}(a.x)), 0u, 0u);
             }}"
        );
        let words = session.words(&body, &inputs)?;
        let float = |word: u32| f64::from(f32::from_bits(word));
        Ok(words.into_iter().map(|[a, b, ..]| [float(a), float(b), 0.0, 0.0]).collect())
    })
}
