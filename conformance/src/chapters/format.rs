//! Texel formats: every row of the table is stored, sampled and read back.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::format::{self, Base, Encoding};
use crate::oracle::format_table::{FORMATS, INTEGER_FORMATS};
use crate::probe::{ProbeError, TexelRow};
use crate::rng::Rng;
use gl_api::constants::enum_name;

/// Stored and sampled.
pub const SAMPLED: Check = Check {
    name: "format",
    citation: "GL 2.1, tables 3.15, 3.16 and 3.20; the formats' extensions",
    what: "a random colour stored in each internal format and sampled by a shader",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: "one rounding of the exact fraction to f32; the table of sRGB is of constants that are rounded once",
    run: |harness, tally| run(harness, tally, ReadPath::Sampled),
};

/// Stored and queried.
pub const QUERIED: Check = Check {
    name: "format-readback",
    citation: "GL 2.1, 6.1.4 and table 6.1",
    what: "a random colour stored in each internal format and read by glGetTexImage as floats",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: "one rounding of the exact fraction to f32",
    run: |harness, tally| run(harness, tally, ReadPath::Queried),
};

/// Integers.
pub const INTEGERS: Check = Check {
    name: "format-integer",
    citation: "EXT_texture_integer, 3.8.1 and 6.1.4",
    what: "integers inside and outside of the range of each integer format, read back",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers are stored as they are",
    run: integers,
};

/// How texels are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ReadPath {
    Sampled,
    Queried,
}

const WIDTH: usize = 64;

fn run(harness: &Harness, tally: &mut Tally, side: ReadPath) -> Result<(), ProbeError> {
    let mut rng = Rng::named("format");
    for &(internal, base, encoding) in FORMATS {
        let cases: Vec<[f32; 4]> = (0..harness.cases(WIDTH * 4))
            .map(|_| [0; 4].map(|_| number(&mut rng, base, encoding)))
            .collect();
        let expect = |case: &[f32; 4], variant: Variant| {
            let channels = format::stored(base, encoding, case.map(f64::from), variant);
            match side {
                ReadPath::Sampled => {
                    base.sampled(format::linear(base, encoding, channels, variant), variant)
                }
                ReadPath::Queried => base.queried(channels, variant),
            }
        };
        harness.compare(tally, &enum_name(internal), &cases, expect, |session| {
            let row = TexelRow { internal, is_depth: base == Base::Depth, texels: &cases };
            session.texel_row(&row)?;
            match side {
                ReadPath::Sampled => {
                    let width = cases.len() as f32;
                    let at = |i: usize| [(i as f32 + 0.5) / width, 0.5, 0.0, 1.0];
                    let inputs: Vec<_> =
                        (0..cases.len()).map(|i| [at(i), [0.0; 4], [0.0; 4]]).collect();
                    let body = "uniform sampler2D image;\
                                vec4 value() { return texture2D(image, a.xy); }";
                    session.field(body, 4, &inputs)
                }
                ReadPath::Queried => session.query_texel_row(&row),
            }
        })?;
    }
    Ok(())
}

/// A number inside or somewhat outside of the range, not near the middle between two codes, where
/// either may be taken.
fn number(rng: &mut Rng, base: Base, encoding: Encoding) -> f32 {
    loop {
        let x = match encoding {
            Encoding::Unorm(_) | Encoding::Srgb => rng.real(-0.25, 1.25),
            Encoding::Snorm(_) => rng.real(-1.25, 1.25),
            Encoding::Half
            | Encoding::Single
            | Encoding::PackedFloat
            | Encoding::SharedExponent => {
                if base == Base::Depth {
                    return rng.real(0.0, 1.0);
                }
                let scale = (rng.real(-18.0, 15.5)).exp2();
                return rng.real(-1.0, 1.0) * scale;
            }
            Encoding::Integer(..) => return rng.real(-300.0, 300.0).round(),
        };
        let bits: &[u32] = match &encoding {
            Encoding::Unorm(bits) => bits,
            Encoding::Snorm(8) => &[7],
            Encoding::Snorm(_) => &[15],
            _ => &[8],
        };
        let is_clear = |&bits: &u32| {
            let scaled = f64::from(x) * ((1u64 << bits) - 1) as f64;
            (scaled - scaled.floor() - 0.5).abs() > 0.01
        };
        if bits.iter().all(is_clear) {
            return x;
        }
    }
}

fn integers(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("integers");
    for &(internal, base, encoding) in INTEGER_FORMATS {
        let Encoding::Integer(bits, sign) = encoding else { continue };
        let reach = 1i64 << bits;
        let [low, high] = match sign {
            format::Sign::Signed => [i64::from(i32::MIN), i64::from(i32::MAX)],
            format::Sign::Unsigned => [0, i64::from(u32::MAX)],
        };
        let cases: Vec<[i64; 4]> = (0..harness.cases(256))
            .map(|_| [0; 4].map(|_: i32| rng.integer(-reach, reach).clamp(low, high)))
            .collect();
        let expect = |case: &[i64; 4], variant: Variant| {
            let channels = format::stored(base, encoding, case.map(|c| c as f64), variant);
            base.queried(channels, variant)
        };
        harness.compare(tally, &enum_name(internal), &cases, expect, |session| {
            session.integer_row(internal, sign, &cases)
        })?;
    }
    Ok(())
}

/// No two rows of a table have the same name.
#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_there_once() {
        let mut names: Vec<u32> = FORMATS.iter().chain(INTEGER_FORMATS).map(|row| row.0).collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
