//! The geometry stage: the order of what it emits, strips, numbers of primitives, adjacent vertices, and what transform
//! feedback captures of it.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::adjacency::inputs;
use crate::oracle::painter::{Convention, Mode, Rect, inside};
use crate::probe::{Capture, Captured, Dialect, ProbeError, Stages, mode_enum};
use crate::rng::Rng;
use gl_api::constants::*;

const WHY: &str = "integers pass as they are";

/// Order.
pub const ORDER: Check = Check {
    name: "geometry-order",
    citation: "GL 3.2, 2.12: geometry shader outputs are in the order of the inputs and of their emission",
    what: "the rectangle that each pixel shows, of three strips for each of 40 points, one over the other",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: WHY,
    run: order,
};

/// Strips.
pub const STRIP: Check = Check {
    name: "geometry-strip",
    citation: "GL 3.2, 2.12.2, table 2.12; GLSL 1.50, 7.1: gl_PrimitiveID, gl_PrimitiveIDIn",
    what: "the provoking vertex of each triangle of emitted strips in both conventions, and the number \
           of the primitive that it was emitted for, of two instances",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: WHY,
    run: strip,
};

/// Adjacency.
pub const ADJACENCY: Check = Check {
    name: "geometry-adjacency",
    citation: "GL 3.2, 2.6.1, tables 2.3 and 2.4",
    what: "gl_in of each primitive of 10 modes with 0 to 23 vertices, captured",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: WHY,
    run: adjacency,
};

/// Transform feedback.
pub const FEEDBACK: Check = Check {
    name: "geometry-feedback",
    citation: "GL 3.2, 2.17: strips fall apart into primitives, and no part of one is written",
    what: "line strips of 0 to 5 vertices, two of each point, captured into buffers of all sizes, and \
           the number of lines written",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: WHY,
    run: feedback,
};

const SIZE: usize = 64;

fn pixels() -> Vec<[usize; 2]> {
    (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| [x, y])).collect()
}

/// Words that were read, as values to compare.
fn values(words: Vec<[u32; 4]>) -> Vec<[f64; 4]> {
    words.into_iter().map(|word| word.map(f64::from)).collect()
}

const RECTANGLES: Stages<'_> = Stages {
    vertex: "layout(location = 0) in uvec4 rect; flat out uvec4 place; flat out uint number;
        void main() { place = rect; number = uint(gl_VertexID); }",
    geometry: "layout(points) in; layout(triangle_strip, max_vertices = 12) out;
        flat in uvec4 place[]; flat in uint number[]; flat out uint color;
        void main() {
            for (uint part = 0u; part < 3u; part++) {
                vec2 low = vec2(place[0].xy + uvec2(3u, 2u) * part);
                for (int corner = 0; corner < 4; corner++) {
                    vec2 at = low + vec2(corner & 1, corner >> 1) * vec2(place[0].zw);
                    color = number[0] * 3u + part + 1u;
                    gl_Position = vec4(at / 32.0 - 1.0, 0.0, 1.0);
                    EmitVertex();
                }
                EndPrimitive();
            }
        }",
    fragment: "flat in uint color; out uvec4 result; void main() { result = uvec4(color, 0, 0, 1); }",
};

fn order(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("geometry-order");
    let cases = pixels();
    for scene in 0..harness.cases(16) {
        let rects: Vec<Rect> = (0..40)
            .map(|_| {
                let mut side = |least, most| rng.integer(least, most) as usize;
                Rect { low: [side(0, 48), side(0, 48)], size: [side(1, 24), side(1, 24)] }
            })
            .collect();
        let parts: Vec<Rect> = rects
            .iter()
            .flat_map(|r| {
                [0, 1, 2].map(|k| Rect { low: [r.low[0] + 3 * k, r.low[1] + 2 * k], ..*r })
            })
            .collect();
        let layers = |pixel: [usize; 2]| parts.iter().filter(|rect| rect.has(pixel)).count();
        let several = cases.iter().filter(|pixel| layers(**pixel) > 1).count();
        tally.reach(format!("scene {scene}, pixels under several"), several, cases.len() / 2);
        let expect = |&pixel: &[usize; 2], variant: Variant| {
            let mut over = (1..).zip(&parts).filter(|(_, rect)| rect.has(pixel));
            let shown = if variant.has(Mutation::GeometryOrderReversed) {
                over.next()
            } else if variant.has(Mutation::FirstStripOnly) {
                over.filter(|(number, _)| number % 3 == 1).last()
            } else {
                over.last()
            };
            shown.map_or([0.0; 4], |(number, _)| [f64::from(number), 0.0, 0.0, 1.0])
        };
        harness.compare_with(Dialect::Core, tally, &scene, &cases, expect, |session| {
            session.frame(GL_RGBA32UI, [SIZE; 2], 0)?;
            session.stages(&RECTANGLES)?;
            let words: Vec<u32> = rects
                .iter()
                .flat_map(|r| [r.low[0], r.low[1], r.size[0], r.size[1]].map(|c| c as u32))
                .collect();
            session.word_array(0, 4, &words)?;
            glDrawArrays(GL_POINTS, 0, rects.len());
            session.read_words([SIZE; 2]).map(values)
        })?;
    }
    Ok(())
}

/// Points and instances of the strips; vertices of the longest.
const POINTS: usize = 5;
const LONGEST: usize = 13;

fn strip(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let cases = pixels();
    // Triangle i of a strip lies between its vertices i to i + 2, of which every other is 5 pixels higher. A pixel's
    // centre is never on an edge, since 5x = 4y has no solution in odd halves.
    let corner = |row: usize, i: usize| [4.0 * i as f64, (6 * row + 5 * (i % 2)) as f64];
    for vertices in [3, 4, LONGEST] {
        for convention in [Convention::First, Convention::Last] {
            let shown = |[x, y]: [usize; 2]| {
                let at = [x as f64 + 0.5, y as f64 + 0.5];
                let rows = 0..2 * POINTS;
                let triangles = rows.flat_map(|row| (0..vertices - 2).map(move |i| (row, i)));
                triangles.into_iter().find(|&(row, i)| {
                    inside([0, 1, 2].map(|k| corner(row, i + k)), at) == Some(true)
                })
            };
            let drawn = cases.iter().filter(|pixel| shown(**pixel).is_some()).count();
            tally.reach(
                format!("{vertices} vertices, pixels that are drawn"),
                drawn,
                2 * POINTS * (vertices - 2) * 8,
            );
            let expect = |&pixel: &[usize; 2], variant: Variant| {
                let Some((row, i)) = shown(pixel) else { return [0.0; 4] };
                let first = (convention == Convention::First)
                    != variant.has(Mutation::ProvokingConventionSwapped);
                let vertex = if first { i } else { i + 2 };
                let primitive = if variant.has(Mutation::PrimitivesOfAllInstances) {
                    row
                } else {
                    row % POINTS
                };
                let [vertex, primitive] = [vertex, primitive].map(|n| n as f64);
                [vertex + 1.0, 100.0 * primitive + vertex, (row / POINTS) as f64, 1.0]
            };
            harness.compare_with(
                Dialect::Core,
                tally,
                &(vertices, convention),
                &cases,
                expect,
                |session| {
                    session.frame(GL_RGBA32UI, [SIZE; 2], 0)?;
                    let program = session.stages(&STRIPS)?;
                    glUniform1i(glGetUniformLocation(program, "vertices"), vertices as i32);
                    glProvokingVertex(match convention {
                        Convention::First => GL_FIRST_VERTEX_CONVENTION,
                        Convention::Last => GL_LAST_VERTEX_CONVENTION,
                    });
                    glDrawArraysInstanced(GL_POINTS, 0, POINTS, 2);
                    session.read_words([SIZE; 2]).map(values)
                },
            )?;
        }
    }
    Ok(())
}

const STRIPS: Stages<'_> = Stages {
    vertex: "flat out ivec2 name; void main() { name = ivec2(gl_VertexID, gl_InstanceID); }",
    geometry: "layout(points) in; layout(triangle_strip, max_vertices = 16) out;
        flat in ivec2 name[]; flat out ivec2 color; uniform int vertices;
        void main() {
            int row = name[0].x + 5 * name[0].y;
            for (int i = 0; i < vertices; i++) {
                vec2 at = vec2(4 * i, 6 * row + 5 * (i & 1));
                color = ivec2(i + 1, name[0].y);
                gl_PrimitiveID = 100 * gl_PrimitiveIDIn + i;
                gl_Position = vec4(at / 32.0 - 1.0, 0.0, 1.0);
                EmitVertex();
            }
        }",
    fragment: "flat in ivec2 color; out uvec4 result;
        void main() { result = uvec4(color.x, gl_PrimitiveID, color.y, 1); }",
};

/// Modes, the input of the geometry shader, and its vertices.
const MODES: [(Mode, &str, usize); 10] = [
    (Mode::Points, "points", 1),
    (Mode::Lines, "lines", 2),
    (Mode::LineStrip, "lines", 2),
    (Mode::LineLoop, "lines", 2),
    (Mode::Triangles, "triangles", 3),
    (Mode::TriangleFan, "triangles", 3),
    (Mode::LinesAdjacency, "lines_adjacency", 4),
    (Mode::LineStripAdjacency, "lines_adjacency", 4),
    (Mode::TrianglesAdjacency, "triangles_adjacency", 6),
    (Mode::TriangleStripAdjacency, "triangles_adjacency", 6),
];

fn adjacency(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let step = if harness.cases(16) == 1 { 5 } else { 1 };
    for (mode, input, corners) in MODES {
        let mut primitives = 0;
        for count in (0..24).step_by(step) {
            let cases: Vec<usize> = (0..24).collect();
            let slots = |number: usize, variant: Variant| -> Vec<f64> {
                let all = inputs(mode, count, variant);
                let Some(vertices) = all.get(number) else {
                    return vec![f64::from(Captured::UNTOUCHED); 7];
                };
                let mut slots: Vec<f64> = vertices.iter().map(|&vertex| vertex as f64).collect();
                slots.resize(6, 77.0);
                slots.push(number as f64);
                slots
            };
            primitives += inputs(mode, count, Variant::CORRECT).len();
            // Seven words a primitive: both halves are compared as one row of four and one of three.
            let rows: Vec<[usize; 2]> =
                cases.iter().flat_map(|&number| [[number, 0], [number, 4]]).collect();
            let expect = |&[number, first]: &[usize; 2], variant: Variant| {
                let slots = slots(number, variant);
                std::array::from_fn(|i| slots.get(first + i).copied().unwrap_or(0.0))
            };
            harness.compare_with(
                Dialect::Core,
                tally,
                &(mode, count),
                &rows,
                expect,
                |session| {
                    let geometry = format!(
                        "layout({input}) in; layout(points, max_vertices = 1) out;
                    flat in uint number[]; flat out uint names[7];
                    void main() {{
                        for (int i = 0; i < 6; i++) names[i] = 77u;
                        for (int i = 0; i < {corners}; i++) names[i] = number[i];
                        names[6] = uint(gl_PrimitiveIDIn);
                        EmitVertex();
                    }}"
                    );
                    let vertex =
                        "flat out uint number; void main() { number = uint(gl_VertexID); }";
                    let capture = Capture {
                        stages: Stages { vertex, geometry: &geometry, fragment: "" },
                        names: &["names"],
                        primitives: GL_POINTS,
                        capacity: 7 * 24,
                    };
                    let captured = session.captured(&capture, |_| {
                        glDrawArrays(mode_enum(mode), 0, count);
                        Ok(())
                    })?;
                    let word = |at: usize| f64::from(captured.words[at]);
                    Ok(rows
                        .iter()
                        .map(|&[number, first]| {
                            std::array::from_fn(|i| {
                                if first + i < 7 { word(7 * number + first + i) } else { 0.0 }
                            })
                        })
                        .collect())
                },
            )?;
        }
        tally.reach(format!("{mode:?}, primitives"), primitives, 6);
    }
    Ok(())
}

/// Vertices of each of a point's two strips.
fn strips(point: usize) -> [usize; 2] {
    [point % 6, (point * 5 + 3) % 6]
}

fn feedback(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    const POINTS: usize = 12;
    let mut lines = Vec::new();
    let mut joined = Vec::new();
    for point in 0..POINTS {
        let mut before = None;
        for (part, vertices) in strips(point).into_iter().enumerate() {
            let names: Vec<u32> =
                (0..vertices).map(|i| (100 * point + 10 * part + i) as u32).collect();
            if let (Some(before), Some(&first)) = (before, names.first()) {
                joined.push([before, first]);
            }
            lines.extend(names.windows(2).map(|pair| [pair[0], pair[1]]));
            joined.extend(names.windows(2).map(|pair| [pair[0], pair[1]]));
            before = names.last().copied();
        }
    }
    tally.reach("lines", lines.len(), 2 * POINTS);
    let all = 2 * lines.len() + 4;
    let step = if harness.cases(16) == 1 { 7 } else { 1 };
    for capacity in (1..=all).step_by(step) {
        // The last case is the number of lines.
        let cases: Vec<usize> = (0..=capacity).collect();
        let expect = |&at: &usize, variant: Variant| {
            let lines = if variant.has(Mutation::StripsJoined) { &joined } else { &lines };
            let fitting = lines.len().min(capacity / 2);
            let words =
                if variant.has(Mutation::PartOfPrimitiveWritten) { capacity } else { 2 * fitting };
            let value = if at == capacity {
                fitting as u32
            } else if at < words {
                lines.as_flattened().get(at).copied().unwrap_or(Captured::UNTOUCHED)
            } else {
                Captured::UNTOUCHED
            };
            [value.into(), 0.0, 0.0, 0.0]
        };
        harness.compare_with(Dialect::Core, tally, &capacity, &cases, expect, |session| {
            let capture =
                Capture { stages: LINES, names: &["number"], primitives: GL_LINES, capacity };
            let captured = session.captured(&capture, |_| {
                glDrawArrays(GL_POINTS, 0, POINTS);
                Ok(())
            })?;
            let words = captured.words.into_iter().chain([captured.written]);
            Ok(words.map(|word| [word.into(), 0.0, 0.0, 0.0]).collect())
        })?;
    }
    Ok(())
}

const LINES: Stages<'_> = Stages {
    vertex: "flat out int point; void main() { point = gl_VertexID; }",
    geometry: "layout(points) in; layout(line_strip, max_vertices = 12) out;
        flat in int point[]; flat out uint number;
        void main() {
            for (int part = 0; part < 2; part++) {
                int vertices = part == 0 ? point[0] % 6 : (point[0] * 5 + 3) % 6;
                for (int i = 0; i < vertices; i++) {
                    number = uint(100 * point[0] + 10 * part + i);
                    EmitVertex();
                }
                EndPrimitive();
            }
        }",
    fragment: "",
};
