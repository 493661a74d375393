//! Attributes of vertices: conversion of integers, types of arrays; and what transform feedback writes.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::painter::{Convention, Mode, primitives};
use crate::probe::{Capture, Dialect, ProbeError, Stages, mode_enum};
use crate::rng::Rng;
use gl_api::constants::*;

/// Colours and normals of integers.
pub const CURRENT: Check = Check {
    name: "color-types",
    citation: "GL 2.1, 2.14, table 2.9: (2c + 1)/(2^b − 1) of signed, c/(2^b − 1) of unsigned integers",
    what: "current colours, secondary colours and normals after calls of every integer type, random and extreme numbers",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: "one rounding of the exact fraction to f32",
    run: current,
};

/// Arrays of every type.
pub const ARRAYS: Check = Check {
    name: "attribute-types",
    citation: "GL 3.3, 2.8 and 2.10, equations 2.1 and 2.2; missing components are 0, 0, 1",
    what: "attributes of nine types, normalized or not, of one to four components, with strides, as feedback writes them",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: "one rounding of the exact fraction to f32",
    run: arrays,
};

/// Transform feedback into several buffers.
pub const FEEDBACK: Check = Check {
    name: "transform-feedback",
    citation: "GL 3.0, 2.15: GL_SEPARATE_ATTRIBS: whole primitives while all buffers have room; strips fall apart",
    what: "words of two buffers, of which one is smaller, after draws of seven modes, and what queries count",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers",
    run: feedback,
};

/// Signed or unsigned integers of so many bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Integer {
    Signed(u32),
    Unsigned(u32),
}

impl Integer {
    const ALL: [Self; 6] = [
        Self::Signed(8),
        Self::Unsigned(8),
        Self::Signed(16),
        Self::Unsigned(16),
        Self::Signed(32),
        Self::Unsigned(32),
    ];

    /// A random or extreme one.
    fn random(self, rng: &mut Rng) -> i64 {
        let (low, high) = match self {
            Self::Signed(bits) => (-(1i64 << (bits - 1)), (1i64 << (bits - 1)) - 1),
            Self::Unsigned(bits) => (0, (1i64 << bits) - 1),
        };
        match rng.integer(0, 5) {
            0 => low,
            1 => high,
            2 => 0,
            _ => rng.integer(low, high),
        }
    }

    fn fraction(self, c: i64, variant: Variant) -> f64 {
        let c = c as f64;
        match self {
            Self::Signed(bits) if variant.has(Mutation::SignedWithoutHalf) => {
                (c / ((1i64 << (bits - 1)) - 1) as f64).max(-1.0)
            }
            Self::Signed(bits) => (2.0 * c + 1.0) / ((1i64 << bits) - 1) as f64,
            Self::Unsigned(bits) if variant.has(Mutation::UnormOfPowerOfTwo) => {
                c / (1i64 << bits) as f64
            }
            Self::Unsigned(bits) => c / ((1i64 << bits) - 1) as f64,
        }
    }
}

/// What a call sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Set {
    Color3,
    Color4,
    Secondary,
    Normal,
}

fn current(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("color-types");
    for integer in Integer::ALL {
        for set in [Set::Color3, Set::Color4, Set::Secondary, Set::Normal] {
            if set == Set::Normal && matches!(integer, Integer::Unsigned(_)) {
                continue;
            }
            let cases: Vec<[i64; 4]> = (0..harness.cases(128))
                .map(|_| [0; 4].map(|_: i32| integer.random(&mut rng)))
                .collect();
            let expect = |case: &[i64; 4], variant: Variant| {
                let [x, y, z, w] = case.map(|c| integer.fraction(c, variant));
                match set {
                    Set::Color3 => [x, y, z, 1.0],
                    Set::Color4 => [x, y, z, w],
                    Set::Secondary | Set::Normal => [x, y, z, 0.0],
                }
            };
            harness.compare(tally, &(integer, set), &cases, expect, |session| {
                let mut found = Vec::new();
                for case in &cases {
                    call(set, integer, *case);
                    let mut value = [0.0f32; 4];
                    match set {
                        Set::Color3 | Set::Color4 => glGetFloatv(GL_CURRENT_COLOR, &mut value),
                        Set::Secondary => {
                            glGetFloatv(GL_CURRENT_SECONDARY_COLOR, &mut value);
                            value[3] = 0.0;
                        }
                        Set::Normal => glGetFloatv(GL_CURRENT_NORMAL, &mut value[..3]),
                    }
                    found.push(value.map(f64::from));
                }
                session.check("setting current values")?;
                Ok(found)
            })?;
        }
    }
    Ok(())
}

fn call(set: Set, integer: Integer, [x, y, z, w]: [i64; 4]) {
    macro_rules! calls {
        ($ty:ty, $three:ident, $four:ident, $secondary:ident) => {{
            let [x, y, z, w] = [x as $ty, y as $ty, z as $ty, w as $ty];
            match set {
                Set::Color3 => $three(x, y, z),
                Set::Color4 => $four(x, y, z, w),
                Set::Secondary => $secondary(x, y, z),
                Set::Normal => {}
            }
        }};
    }
    match integer {
        Integer::Signed(8) => {
            calls!(i8, glColor3b, glColor4b, glSecondaryColor3b);
            if set == Set::Normal {
                glNormal3b(x as i8, y as i8, z as i8);
            }
        }
        Integer::Signed(16) => {
            calls!(i16, glColor3s, glColor4s, glSecondaryColor3s);
            if set == Set::Normal {
                glNormal3s(x as i16, y as i16, z as i16);
            }
        }
        Integer::Signed(_) => {
            calls!(i32, glColor3i, glColor4i, glSecondaryColor3i);
            if set == Set::Normal {
                glNormal3i(x as i32, y as i32, z as i32);
            }
        }
        Integer::Unsigned(8) => calls!(u8, glColor3ub, glColor4ub, glSecondaryColor3ub),
        Integer::Unsigned(16) => calls!(u16, glColor3us, glColor4us, glSecondaryColor3us),
        Integer::Unsigned(_) => calls!(u32, glColor3ui, glColor4ui, glSecondaryColor3ui),
    }
}

/// The type of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ArrayType {
    Integer(Integer),
    Half,
    Single,
    Double,
}

impl ArrayType {
    fn name(self) -> u32 {
        match self {
            Self::Integer(Integer::Signed(8)) => GL_BYTE,
            Self::Integer(Integer::Signed(16)) => GL_SHORT,
            Self::Integer(Integer::Signed(_)) => GL_INT,
            Self::Integer(Integer::Unsigned(8)) => GL_UNSIGNED_BYTE,
            Self::Integer(Integer::Unsigned(16)) => GL_UNSIGNED_SHORT,
            Self::Integer(Integer::Unsigned(_)) => GL_UNSIGNED_INT,
            Self::Half => GL_HALF_FLOAT,
            Self::Single => GL_FLOAT,
            Self::Double => GL_DOUBLE,
        }
    }

    /// A number, and its bytes.
    fn random(self, rng: &mut Rng) -> (f64, i64, Vec<u8>) {
        match self {
            Self::Integer(integer) => {
                let c = integer.random(rng);
                let bytes = match integer {
                    Integer::Signed(bits) | Integer::Unsigned(bits) => bits as usize / 8,
                };
                (c as f64, c, c.to_ne_bytes()[..bytes].to_vec())
            }
            Self::Half => {
                // Sign, an exponent of a normal number, and a mantissa.
                let (sign, e, m) = (rng.integer(0, 1), rng.integer(1, 30), rng.integer(0, 1023));
                let value = (1.0 + m as f64 / 1024.0) * 2f64.powi(e as i32 - 15);
                let bits = (sign << 15 | e << 10 | m) as u16;
                (if sign == 1 { -value } else { value }, 0, bits.to_ne_bytes().to_vec())
            }
            Self::Single => {
                let x = rng.real(-1e6, 1e6);
                (f64::from(x), 0, x.to_ne_bytes().to_vec())
            }
            Self::Double => {
                let x = f64::from(rng.real(-1.0, 1.0)) * 1.000_000_1;
                (x, 0, x.to_ne_bytes().to_vec())
            }
        }
    }
}

fn arrays(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("attribute-types");
    let types: Vec<ArrayType> = Integer::ALL
        .map(ArrayType::Integer)
        .into_iter()
        .chain([ArrayType::Half, ArrayType::Single, ArrayType::Double])
        .collect();
    for of in types {
        for (size, normalized) in [(1, false), (2, true), (3, true), (4, false), (4, true)] {
            let count = harness.cases(64);
            let values: Vec<Vec<(f64, i64, Vec<u8>)>> =
                (0..count).map(|_| (0..size).map(|_| of.random(&mut rng)).collect()).collect();
            // Unused bytes lie between elements, in units of eight.
            let gap = 8 * rng.integer(0, 2) as usize;
            let cases: Vec<usize> = (0..count).collect();
            let expect = |&k: &usize, variant: Variant| {
                let mut out = [0.0, 0.0, 0.0, 1.0];
                for (out, (value, code, _)) in out.iter_mut().zip(&values[k]) {
                    *out = match of {
                        ArrayType::Integer(integer) if normalized => {
                            integer.fraction(*code, variant)
                        }
                        ArrayType::Integer(_)
                        | ArrayType::Half
                        | ArrayType::Single
                        | ArrayType::Double => *value,
                    };
                }
                if variant.has(Mutation::MissingComponentsZero) && size < 4 {
                    out[3] = 0.0;
                }
                out
            };
            harness.compare_with(
                Dialect::Core,
                tally,
                &(of, size, normalized),
                &cases,
                expect,
                |session| {
                    let element: usize = values[0].iter().map(|(_, _, bytes)| bytes.len()).sum();
                    let stride = element.next_multiple_of(8) + gap;
                    let mut memory = vec![0xabu8; stride * count];
                    for (k, vertex) in values.iter().enumerate() {
                        let bytes: Vec<u8> =
                            vertex.iter().flat_map(|(_, _, b)| b.clone()).collect();
                        memory[k * stride..][..bytes.len()].copy_from_slice(&bytes);
                    }
                    let vertex = "layout(location = 0) in vec4 given; out vec4 kept;
                    void main() { kept = given; gl_Position = vec4(0.0); }";
                    let stages = Stages { vertex, geometry: "", fragment: "" };
                    let capture = Capture {
                        stages,
                        names: &["kept"],
                        primitives: GL_POINTS,
                        capacity: 4 * count,
                    };
                    let captured = session.captured(&capture, |_| {
                        let mut buffer = 0u32;
                        glGenBuffers(1, &mut buffer);
                        glBindBuffer(GL_ARRAY_BUFFER, buffer);
                        glBufferData(GL_ARRAY_BUFFER, memory.len(), &memory, GL_STATIC_DRAW);
                        glVertexAttribPointer(
                            0,
                            size,
                            of.name(),
                            normalized,
                            stride,
                            BUFFER_OFFSET(0),
                        );
                        glEnableVertexAttribArray(0);
                        glDrawArrays(GL_POINTS, 0, count);
                        session.check("drawing arrays")
                    })?;
                    let four = captured.words.chunks_exact(4);
                    Ok(four
                        .map(|w| [0, 1, 2, 3].map(|i: usize| f64::from(f32::from_bits(w[i]))))
                        .collect())
                },
            )?;
        }
    }
    Ok(())
}

const MODES: [Mode; 7] = [
    Mode::Points,
    Mode::Lines,
    Mode::LineStrip,
    Mode::LineLoop,
    Mode::Triangles,
    Mode::TriangleStrip,
    Mode::TriangleFan,
];

fn feedback(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("transform-feedback");
    for (round, mode) in (0..harness.cases(28).max(7)).map(|round| (round, MODES[round % 7])) {
        let (count, room) = (rng.integer(0, 19) as usize, rng.integer(1, 40) as usize);
        let corners = match mode {
            Mode::Points => 1,
            Mode::Lines | Mode::LineStrip | Mode::LineLoop => 2,
            _ => 3,
        };
        let mut all = primitives(mode, count, Convention::Last);
        if mode == Mode::TriangleStrip {
            // Odd triangles are turned, so that all have one winding.
            all.iter_mut().skip(1).step_by(2).for_each(|(corners, _)| corners.swap(0, 1));
        }
        // A word of each of the vertices in either buffer, then the counts.
        let cases: Vec<usize> = (0..64).collect();
        let expect = |&k: &usize, variant: Variant| {
            let fits = if variant.has(Mutation::PartOfPrimitiveWritten) {
                usize::MAX
            } else {
                room / corners
            };
            let written: Vec<usize> = all.iter().take(fits).flat_map(|(v, _)| v.clone()).collect();
            let word = written.get(k).filter(|_| k < room);
            let first = word.map_or(9999.0, |v| (v * 3 + 1) as f64);
            let second = word.map_or(9999.0, |v| (v * v) as f64);
            [first, second, all.len().min(room / corners) as f64, all.len() as f64]
        };
        harness.compare(tally, &(round, mode, count, room), &cases, expect, |session| {
            let vertex = "out float first, second;
                void main() {
                    first = float(gl_VertexID * 3 + 1); second = float(gl_VertexID * gl_VertexID);
                    gl_Position = vec4(0.0);
                }";
            let name = session.feedback_program(vertex, &["first", "second"])?;
            glUseProgram(name);
            let mut buffers = [0u32; 2];
            glGenBuffers(2, &mut buffers);
            let untouched = [9999.0f32; 64];
            for (index, buffer) in buffers.into_iter().enumerate() {
                glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer);
                glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 256, &untouched, GL_STATIC_READ);
                let size = if index == 1 { 4 * room } else { 256 };
                glBindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, index, buffer, 0, size);
            }
            let mut queries = [0u32; 2];
            glGenQueries(2, &mut queries);
            glEnable(GL_RASTERIZER_DISCARD);
            glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, queries[0]);
            glBeginQuery(GL_PRIMITIVES_GENERATED, queries[1]);
            glBeginTransformFeedback([GL_POINTS, GL_LINES, GL_TRIANGLES][corners - 1]);
            glDrawArrays(mode_enum(mode), 0, count);
            glEndTransformFeedback();
            glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
            glEndQuery(GL_PRIMITIVES_GENERATED);
            glDisable(GL_RASTERIZER_DISCARD);
            let counts = queries.map(|query| {
                let mut count = 0u32;
                glGetQueryObjectuiv(query, GL_QUERY_RESULT, &mut count);
                f64::from(count)
            });
            let words = buffers.map(|buffer| {
                let mut words = [0.0f32; 64];
                glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer);
                glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 256, &mut words);
                words.map(f64::from)
            });
            session.check("capturing into two buffers")?;
            Ok((0..64).map(|k| [words[0][k], words[1][k], counts[0], counts[1]]).collect())
        })?;
    }
    Ok(())
}
