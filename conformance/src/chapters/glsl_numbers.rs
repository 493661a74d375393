//! GLSL: integers, conversions, comparisons, simple functions and matrices.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::{Mutation, Variant};
use crate::oracle::glsl::{self, IntegerOp};
use crate::oracle::glsl_matrix::MatrixFunction;
use crate::probe::ProbeError;
use crate::rng::Rng;

/// Arithmetic of integers.
pub const ARITHMETIC: Check = Check {
    name: "glsl-integer-arithmetic",
    citation: "GLSL 1.30, 4.1.3 and 5.9: 32 bits, results wrap round; quotients are truncated",
    what: "+, -, *, /, % and ~ of random and extreme int and uint",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers",
    run: |harness, tally| integers(harness, tally, IntegerOp::ARITHMETIC),
};

/// Bits of integers.
pub const BITS: Check = Check {
    name: "glsl-integer-bits",
    citation: "GLSL 1.30, 5.9: <<, >> (with the sign of an int), &, |, ^",
    what: "shifts by 0 to 31 and operations on bits of random and extreme int and uint",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers",
    run: |harness, tally| integers(harness, tally, IntegerOp::BITS),
};

/// Comparisons of integers.
pub const COMPARISONS: Check = Check {
    name: "glsl-integer-compare",
    citation: "GLSL 1.30, 5.9 and 8.3: comparisons, abs, sign, min, max, clamp of int and uint",
    what: "random, extreme and equal int and uint",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers",
    run: |harness, tally| integers(harness, tally, IntegerOp::ORDER),
};

/// Conversions.
pub const CONVERSIONS: Check = Check {
    name: "glsl-conversions",
    citation: "GLSL 1.30, 5.4.1: int and uint of a float drop the fraction; bool is x != 0",
    what: "floats within the range of int and uint, and back, and bool of each",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers, and floats that are integers",
    run: conversions,
};

/// Comparisons of vectors.
pub const RELATIONAL: Check = Check {
    name: "glsl-relational",
    citation: "GLSL 1.20, 8.6: lessThan to notEqual, any, all, not; 8.3: step, isnan, isinf",
    what: "random vectors with equal components, zeros of both signs, infinities and NaN",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "true or false",
    run: relational,
};

/// Functions that select.
pub const SELECTING: Check = Check {
    name: "glsl-selecting",
    citation: "GLSL 1.20, 8.3 and 8.4: abs, sign, min, max, clamp, step; GLSL 1.30: modf; faceforward",
    what: "random floats and equal ones, every component",
    unit: Unit::Ulp,
    tolerance: 0.0,
    why: "one of the arguments, or an exact difference",
    run: selecting,
};

/// Products of matrices.
pub const PRODUCTS: Check = Check {
    name: "glsl-matrix-product",
    citation: "GLSL 1.20, 5.10: m · v, v · m, m · m, of 4×4 and of 2×4 and 4×2 matrices; matrixCompMult",
    what: "random matrices of small fractions",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "every sum is exact in f32",
    run: |harness, tally| matrices(harness, tally, MatrixFunction::PRODUCTS),
};

/// Transposes.
pub const TRANSPOSE: Check = Check {
    name: "glsl-transpose",
    citation: "GLSL 1.20, 8.5: transpose, outerProduct(c, r) = c · rᵀ",
    what: "random matrices and vectors of small fractions",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "elements as they are, and exact products",
    run: |harness, tally| matrices(harness, tally, MatrixFunction::TRANSPOSES),
};

/// Determinants.
pub const DETERMINANT: Check = Check {
    name: "glsl-determinant",
    citation: "GLSL 1.50, 8.5: determinant",
    what: "random matrices of 2, 3 and 4 columns of small fractions",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "fractions so small that every product and sum is exact in f32",
    run: |harness, tally| matrices(harness, tally, MatrixFunction::DETERMINANTS),
};

/// Inverses.
pub const INVERSE: Check = Check {
    name: "glsl-inverse",
    citation: "GLSL 1.40, 8.5: inverse",
    what: "random matrices of 2, 3 and 4 columns with determinants of at least 1",
    unit: Unit::FullScale,
    tolerance: 1.5 / (1 << 21) as f64,
    why: "f32: exact cofactors, and quotients up to 8 that are rounded by 2^-22, twice",
    run: |harness, tally| matrices(harness, tally, MatrixFunction::INVERSES),
};

const EXTREMES: [u32; 8] = [0, 1, 2, u32::MAX, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, 31];

/// Pairs of words.
fn pairs(rng: &mut Rng, count: usize) -> Vec<[u32; 2]> {
    let mut word = |k: usize| match k % 3 {
        0 => rng.pick(&EXTREMES),
        1 => rng.integer(-9, 9) as u32,
        _ => u32::from_le_bytes([rng.byte(), rng.byte(), rng.byte(), rng.byte()]),
    };
    (0..count).map(|k| if k % 16 == 7 { [word(k); 2] } else { [word(k), word(k / 3)] }).collect()
}

fn integers(harness: &Harness, tally: &mut Tally, ops: &[IntegerOp]) -> Result<(), ProbeError> {
    let mut rng = Rng::named("glsl-integers");
    for &op in ops {
        let mut cases = pairs(&mut rng, harness.cases(1024));
        cases.retain(|&[a, b]| op.is_defined(a, b));
        tally.reach(format!("defined cases of {op:?}"), cases.len(), harness.cases(1024) / 4);
        let expect = |&[a, b]: &[u32; 2], variant: Variant| {
            let [signed, unsigned] = op.apply(a, b, variant);
            [f64::from(signed), f64::from(unsigned), 0.0, 0.0]
        };
        harness.compare(tally, &op, &cases, expect, |session| {
            let body = format!(
                "uvec4 value(uvec4 words, uvec4 unused) {{
                    uvec4 result = uvec4(0u);
                    {{ int a = int(words.x), b = int(words.y); result.x = uint({signed}); }}
                    {{ uint a = words.x, b = words.y; result.y = uint({unsigned}); }}
                    return result;
                }}",
                signed = op.glsl()[0],
                unsigned = op.glsl()[1],
            );
            let inputs: Vec<_> = cases.iter().map(|[a, b]| [[*a, *b, 0, 0], [0; 4]]).collect();
            Ok(session.words(&body, &inputs)?.into_iter().map(|word| word.map(f64::from)).collect())
        })?;
    }
    Ok(())
}

fn conversions(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("glsl-conversions");
    // Floats with fractions, and integers of at most 24 bits.
    let cases: Vec<[f32; 2]> = (0..harness.cases(4096))
        .map(|k| {
            let reach = [4.0, 1000.0, 2e9][k % 3];
            let x = if k % 7 == 0 { 0.0 } else { rng.real(-reach, reach) };
            [x, rng.integer(-(1 << 24), 1 << 24) as f32]
        })
        .collect();
    let expect = |&[x, i]: &[f32; 2], variant: Variant| {
        let [x, i] = [x, i].map(f64::from);
        let whole =
            |x: f64| if variant.has(Mutation::ConversionRounds) { x.round() } else { x.trunc() };
        // int of x, uint of |x|, the bools of both, and the integer again as a float.
        let bools = u32::from(x != 0.0) + 2 * u32::from(i != 0.0);
        [whole(x), whole(x.abs()), f64::from(bools), i]
    };
    harness.compare(tally, &"floats", &cases, expect, |session| {
        let body = "uvec4 value(uvec4 a, uvec4 unused) {
                float x = uintBitsToFloat(a.x), back = uintBitsToFloat(a.y);
                uint bools = uint(bool(x)) + 2u * uint(bool(int(back)));
                return uvec4(uint(int(x)), uint(abs(x)), bools, floatBitsToUint(float(int(back))));
            }";
        let inputs: Vec<_> =
            cases.iter().map(|[x, i]| [[x.to_bits(), i.to_bits(), 0, 0], [0; 4]]).collect();
        let words = session.words(body, &inputs)?;
        let value = |[a, b, c, d]: [u32; 4]| {
            [f64::from(a as i32), f64::from(b), f64::from(c), f64::from(f32::from_bits(d))]
        };
        Ok(words.into_iter().map(value).collect())
    })
}

const SPECIAL: [f32; 6] = [0.0, -0.0, 1.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];

fn relational(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("glsl-relational");
    let cases: Vec<[[f32; 4]; 2]> = (0..harness.cases(2048))
        .map(|_| {
            let mut one = |same: Option<f32>| match (rng.integer(0, 3), same) {
                (0, _) => rng.pick(&SPECIAL),
                (1, Some(x)) => x,
                _ => rng.real(-2.0, 2.0),
            };
            let a = [0; 4].map(|_: i32| one(None));
            [a, a.map(|x| one(Some(x)))]
        })
        .collect();
    let expect = |[a, b]: &[[f32; 4]; 2], variant: Variant| {
        let [a, b] = [a, b].map(|v| v.map(f64::from));
        glsl::relational(a, b, variant).map(f64::from)
    };
    harness.compare(tally, &"vectors", &cases, expect, |session| {
        let body = "
            uint bits(bvec4 b) {
                return uint(b.x) | uint(b.y) << 1 | uint(b.z) << 2 | uint(b.w) << 3;
            }
            uvec4 value(uvec4 a, uvec4 b) {
                vec4 x = uintBitsToFloat(a), y = uintBitsToFloat(b);
                bvec4 less = lessThan(x, y);
                return uvec4(
                    bits(less) | bits(lessThanEqual(x, y)) << 4 | bits(greaterThan(x, y)) << 8
                        | bits(greaterThanEqual(x, y)) << 12,
                    bits(equal(x, y)) | bits(notEqual(x, y)) << 4 | bits(not(less)) << 8,
                    uint(any(less)) | uint(all(less)) << 1 | uint(x == y) << 2 | uint(x != y) << 3,
                    bits(isnan(x)) | bits(isinf(x)) << 4);
            }";
        let inputs: Vec<_> = cases.iter().map(|case| case.map(|v| v.map(f32::to_bits))).collect();
        Ok(session.words(body, &inputs)?.into_iter().map(|word| word.map(f64::from)).collect())
    })
}

fn selecting(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("glsl-selecting");
    for &function in glsl::SELECTING {
        let cases: Vec<[[f32; 4]; 2]> = (0..harness.cases(512))
            .map(|_| {
                let a = [0; 4].map(|_: i32| rng.real(-3.0, 3.0));
                let equal = rng.integer(0, 4) == 0;
                let b = a.map(|x| if equal { x } else { rng.real(-3.0, 3.0) });
                [a, b]
            })
            .collect();
        let expect = |[a, b]: &[[f32; 4]; 2], variant: Variant| {
            function.apply(a.map(f64::from), b.map(f64::from), variant)
        };
        harness.compare(tally, &function, &cases, expect, |session| {
            let body = format!("vec4 value(vec4 a, vec4 b) {{ {} }}", function.glsl());
            session.float_words(&body, &cases)
        })?;
    }
    Ok(())
}

fn matrices(harness: &Harness, tally: &mut Tally, of: &[MatrixFunction]) -> Result<(), ProbeError> {
    let mut rng = Rng::named("glsl-matrices");
    for &function in of {
        let cases: Vec<[[f32; 4]; 2]> = std::iter::repeat_with(|| {
            [0; 2].map(|_: i32| [0; 4].map(|_: i32| rng.dyadic(-2.0, 2.0, 1.0 / 16.0)))
        })
        .filter(|[a, b]| function.is_stable(a.map(f64::from), b.map(f64::from)))
        .take(harness.cases(512))
        .collect();
        for column in 0..function.columns() {
            let expect = |[a, b]: &[[f32; 4]; 2], variant: Variant| {
                function.column(column, a.map(f64::from), b.map(f64::from), variant)
            };
            harness.compare(tally, &(function, column), &cases, expect, |session| {
                let body = format!(
                    "vec4 value(vec4 a, vec4 b) {{
                        mat4 m = mat4(a, b, a.yzwx * 0.5 + b, b.wzyx - a);
                        {}
                    }}",
                    function.glsl(column)
                );
                session.float_words(&body, &cases)
            })?;
        }
    }
    Ok(())
}
