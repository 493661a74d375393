//! Arrays with divisors, base vertices, restarts and packed attributes, as transform feedback captures them.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::format::Sign;
use crate::oracle::vertex_array::{Index, element, index, lines};
use crate::probe::{Capture, Captured, Dialect, ProbeError, Session, Stages};
use crate::rng::Rng;
use gl_api::constants::*;

const WHY: &str = "integers pass as they are";

/// Divisors.
pub const DIVISOR: Check = Check {
    name: "instance-divisor",
    citation: "GL 3.3, 2.8.2: floor(instance / divisor)",
    what: "the element of three arrays with random divisors of each vertex of each instance, by \
           arrays and by indices",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: WHY,
    run: divisor,
};

/// Base vertices.
pub const BASE: Check = Check {
    name: "base-vertex",
    citation: "GL 3.3, 2.8.2: glDrawElementsBaseVertex; 2.8.1: the restart index comes first",
    what: "attributes and gl_VertexID of random indices of 8, 16 and 32 bits with positive and negative bases",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: WHY,
    run: |harness, tally| drawn(harness, tally, Strips::Points),
};

/// Restarts.
pub const RESTART: Check = Check {
    name: "primitive-restart",
    citation: "GL 3.3, 2.8.1: primitive restart",
    what: "the lines of strips that restart at random places, also twice in a row and at either end",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: WHY,
    run: |harness, tally| drawn(harness, tally, Strips::Lines),
};

const NUMBERS: Stages<'_> = Stages {
    vertex: "layout(location = 0) in uint a; layout(location = 1) in uint b;
        layout(location = 2) in uint c; flat out uvec4 numbers;
        void main() { numbers = uvec4(a, b, c, gl_InstanceID); }",
    geometry: "",
    fragment: "",
};

fn divisor(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("instance-divisor");
    for round in 0..harness.cases(48) {
        let divisors = [0; 3].map(|_: i32| rng.integer(0, 7) as usize);
        let (vertices, instances) = (rng.integer(1, 5) as usize, rng.integer(1, 29) as usize);
        let by_indices = round % 2 == 1;
        let indices: Vec<u8> = (0..vertices).map(|_| rng.integer(0, 31) as u8).collect();
        let cases: Vec<[usize; 2]> =
            (0..instances).flat_map(|i| (0..vertices).map(move |v| [i, v])).collect();
        // An element of array k is 100 · k + its number.
        let expect = |&[instance, vertex]: &[usize; 2], variant: Variant| {
            let vertex = if by_indices { usize::from(indices[vertex]) } else { vertex };
            let [a, b, c] =
                [0, 1, 2].map(|k| 100 * k + element(divisors[k], vertex, instance, variant));
            [a, b, c, instance].map(|n| n as f64)
        };
        let scene = (divisors, by_indices, vertices, instances);
        harness.compare_with(Dialect::Core, tally, &scene, &cases, expect, |session| {
            let capture = Capture {
                stages: NUMBERS,
                names: &["numbers"],
                primitives: GL_POINTS,
                capacity: 4 * cases.len(),
            };
            let captured = session.captured(&capture, |_| {
                for (k, divisor) in (0..).zip(divisors) {
                    let elements: Vec<u32> = (0..32).map(|element| 100 * k + element).collect();
                    session.word_array(k, 1, &elements)?;
                    glVertexAttribDivisor(k, divisor);
                }
                if by_indices {
                    session.indices(&indices)?;
                    let (mode, ty) = (GL_POINTS, GL_UNSIGNED_BYTE);
                    glDrawElementsInstanced(mode, vertices, ty, BUFFER_OFFSET(0), instances);
                } else {
                    glDrawArraysInstanced(GL_POINTS, 0, vertices, instances);
                }
                Ok(())
            })?;
            let four = |words: &[u32]| std::array::from_fn(|i| f64::from(words[i]));
            Ok(captured.words.chunks_exact(4).map(four).collect())
        })?;
        tally.reach(format!("round {round}, vertices"), cases.len(), 1);
    }
    Ok(())
}

/// What indices are drawn as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Strips {
    Points,
    Lines,
}

/// The type of indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Width {
    Bytes,
    Shorts,
    Words,
}

impl Width {
    fn ty(self) -> u32 {
        match self {
            Self::Bytes => GL_UNSIGNED_BYTE,
            Self::Shorts => GL_UNSIGNED_SHORT,
            Self::Words => GL_UNSIGNED_INT,
        }
    }

    fn bytes(self, words: &[u32]) -> Vec<u8> {
        let size = match self {
            Self::Bytes => 1,
            Self::Shorts => 2,
            Self::Words => 4,
        };
        words.iter().flat_map(|word| word.to_le_bytes().into_iter().take(size)).collect()
    }
}

/// Elements of the array; indices are such that any base keeps them inside.
const ELEMENTS: u32 = 240;

const VERTEX: Stages<'_> = Stages {
    vertex: "layout(location = 0) in uint element; flat out uvec2 numbers;
        void main() { numbers = uvec2(element, gl_VertexID); }",
    geometry: "",
    fragment: "",
};

fn drawn(harness: &Harness, tally: &mut Tally, strips: Strips) -> Result<(), ProbeError> {
    let mut rng = Rng::named("drawn");
    let mut restarts = 0;
    let rounds = harness.cases(48).max(6);
    for round in 0..rounds {
        let width = [Width::Bytes, Width::Shorts, Width::Words][round % 3];
        let base = match strips {
            Strips::Points => rng.integer(-90, 90),
            Strips::Lines => rng.pick(&[0, 0, 7]),
        };
        let restart = match strips {
            Strips::Points if round % 2 == 0 => None,
            // Twice the base below the restart index lies an index that would be it with the base.
            Strips::Points | Strips::Lines => Some(120),
        };
        let mut words: Vec<u32> = (0..40).map(|_| rng.integer(90, 149) as u32).collect();
        if let Some(restart) = restart {
            for place in [0, 7, 8, 20, 39] {
                words[place] = restart;
            }
            // What the base makes the restart index of is none.
            let shifted = i64::from(restart) - base;
            if (90..150).contains(&shifted) {
                words[3] = shifted as u32;
            }
        }
        restarts += words.iter().filter(|word| restart == Some(**word)).count();
        let expected = |variant: Variant| -> Vec<u32> {
            let indices: Vec<Index> =
                words.iter().map(|&word| index(word, base, restart, variant)).collect();
            let numbers: Vec<i64> = match strips {
                Strips::Lines => lines(&indices, variant).into_flattened(),
                Strips::Points => indices
                    .iter()
                    .filter_map(|index| match index {
                        Index::Vertex(vertex) => Some(*vertex),
                        Index::Restart => None,
                    })
                    .collect(),
            };
            let both = numbers.iter().flat_map(|&number| {
                // Element n is n + 1000.
                [(number + 1000) as u32, number as u32]
            });
            both.collect()
        };
        let cases: Vec<usize> = (0..4 * words.len()).collect();
        let expect = |&at: &usize, variant: Variant| {
            let word = expected(variant).get(at).copied().unwrap_or(Captured::UNTOUCHED);
            [word.into(), 0.0, 0.0, 0.0]
        };
        let scene = (width, base, restart);
        harness.compare_with(Dialect::Core, tally, &scene, &cases, expect, |session| {
            let (primitives, mode) = match strips {
                Strips::Points => (GL_POINTS, GL_POINTS),
                Strips::Lines => (GL_LINES, GL_LINE_STRIP),
            };
            let capture =
                Capture { stages: VERTEX, names: &["numbers"], primitives, capacity: cases.len() };
            let captured = session.captured(&capture, |_| {
                let elements: Vec<u32> = (0..ELEMENTS).map(|element| element + 1000).collect();
                session.word_array(0, 1, &elements)?;
                session.indices(&width.bytes(&words))?;
                set_restart(session, restart)?;
                let (count, ty, offset) = (words.len(), width.ty(), BUFFER_OFFSET(0));
                if round % 2 == 0 {
                    glDrawElementsBaseVertex(mode, count, ty, offset, base);
                } else {
                    glDrawRangeElementsBaseVertex(mode, 90, 149, count, ty, offset, base);
                }
                Ok(())
            })?;
            Ok(captured.words.into_iter().map(|word| [word.into(), 0.0, 0.0, 0.0]).collect())
        })?;
    }
    tally.reach("restarts", restarts, rounds * 2);
    Ok(())
}

fn set_restart(session: &Session, restart: Option<u32>) -> Result<(), ProbeError> {
    if let Some(restart) = restart {
        glEnable(GL_PRIMITIVE_RESTART);
        glPrimitiveRestartIndex(restart);
    }
    session.check("setting the restart index")
}

/// Packed attributes.
pub const PACKED: Check = Check {
    name: "packed-attribute",
    citation: "GL 3.3, 2.8 and equations 2.2 and 2.3; OpenGL ES 3.0, equation 2.2: 2_10_10_10_REV",
    what: "the four components of random and extreme words, signed and unsigned, normalized or not, in \
           arrays of OpenGL and of OpenGL ES",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: "one rounding of the exact fraction to f32",
    run: packed,
};

/// Component `i` of a word: three of ten bits from the lowest, and one of two.
fn component(word: u32, i: usize, sign: Sign, variant: Variant) -> (f64, f64) {
    let i = if variant.has(Mutation::PackedReversed) { 3 - i } else { i };
    let (shift, bits) = [(0, 10), (10, 10), (20, 10), (30, 2)][i];
    let field = word >> shift & ((1 << bits) - 1);
    let value = if sign == Sign::Signed && field >> (bits - 1) == 1 {
        f64::from(field) - f64::from(1u32 << bits)
    } else {
        f64::from(field)
    };
    (value, f64::from(bits))
}

fn packed(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("packed-attribute");
    for dialect in [Dialect::Core, Dialect::Es] {
        for (sign, normalized) in [
            (Sign::Unsigned, false),
            (Sign::Unsigned, true),
            (Sign::Signed, false),
            (Sign::Signed, true),
        ] {
            let cases: Vec<u32> = (0..harness.cases(1024))
                .map(|i| {
                    let random = rng.integer(0, u32::MAX.into()) as u32;
                    // Each field at the ends of its range.
                    let mut end = |bits: u32| rng.pick(&[0, 1, (1 << bits) - 1, 1 << (bits - 1)]);
                    let ends = end(10) | end(10) << 10 | end(10) << 20 | end(2) << 30;
                    if i % 2 == 0 { random } else { ends }
                })
                .collect();
            let expect = |&word: &u32, variant: Variant| {
                std::array::from_fn(|i| {
                    let (c, bits) = component(word, i, sign, variant);
                    let of_textures =
                        (dialect == Dialect::Es) != variant.has(Mutation::SignedWithoutHalf);
                    match (normalized, sign) {
                        (false, _) => c,
                        (true, Sign::Unsigned) => c / (bits.exp2() - 1.0),
                        (true, Sign::Signed) if of_textures => {
                            (c / ((bits - 1.0).exp2() - 1.0)).max(-1.0)
                        }
                        (true, Sign::Signed) => (2.0 * c + 1.0) / (bits.exp2() - 1.0),
                    }
                })
            };
            let scene = (dialect, sign, normalized);
            harness.compare_with(dialect, tally, &scene, &cases, expect, |session| {
                let ty = match sign {
                    Sign::Signed => GL_INT_2_10_10_10_REV,
                    Sign::Unsigned => GL_UNSIGNED_INT_2_10_10_10_REV,
                };
                session.frame(GL_RGBA32F, [64, cases.len().div_ceil(64)], 0)?;
                let program = session.stages(&ATTRIBUTE)?;
                session.word_array(1, 1, &cases)?;
                glVertexAttribPointer(0, 4, ty, normalized, 0, BUFFER_OFFSET(0));
                glEnableVertexAttribArray(0);
                let height = cases.len().div_ceil(64) as f32;
                glUniform1f(glGetUniformLocation(program, "height"), height);
                glDrawArrays(GL_POINTS, 0, cases.len());
                let mut values = session.read_floats([64, cases.len().div_ceil(64)])?;
                values.truncate(cases.len());
                Ok(values)
            })?;
        }
    }
    Ok(())
}

/// Vertex `n` is the pixel in column `n mod 64` of row `n / 64`.
const ATTRIBUTE: Stages<'_> = Stages {
    vertex: "layout(location = 0) in vec4 fields; flat out vec4 value; uniform float height;
        void main() {
            value = fields;
            vec2 pixel = vec2(gl_VertexID % 64, gl_VertexID / 64) + 0.5;
            gl_Position = vec4(pixel / vec2(64.0, height) * 2.0 - 1.0, 0.0, 1.0);
            gl_PointSize = 1.0;
        }",
    geometry: "",
    fragment: "flat in vec4 value; out vec4 result; void main() { result = value; }",
};
