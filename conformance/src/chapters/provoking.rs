//! Flat values, of the vertex that provokes.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::painter::{Convention, Mode, inside, primitives};
use crate::probe::{Dialect, ProbeError, Stages, mode_enum};
use gl_api::constants::*;

/// Flat values.
pub const FLAT: Check = Check {
    name: "provoking-flat",
    citation: "GL 3.2, 2.18 and table 2.12",
    what: "the flat value of each pixel of each primitive of all 14 modes, in both conventions",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers pass as they are",
    run,
};

const MODES: [Mode; 14] = [
    Mode::Points,
    Mode::Lines,
    Mode::LineStrip,
    Mode::LineLoop,
    Mode::Triangles,
    Mode::TriangleStrip,
    Mode::TriangleFan,
    Mode::LinesAdjacency,
    Mode::LineStripAdjacency,
    Mode::TrianglesAdjacency,
    Mode::TriangleStripAdjacency,
    Mode::Quads,
    Mode::QuadStrip,
    Mode::Polygon,
];

const SIZE: [usize; 2] = [64, 24];

/// The window coordinates of the vertices: along a row for points and lines, a zigzag for strips, a ring for fans.
fn vertices(mode: Mode) -> Vec<[f64; 2]> {
    let row = || (0..12).map(|i| [5.0 * i as f64 + 0.5, 3.5]).collect::<Vec<_>>();
    let zigzag =
        |count| (0..count).map(|i| [4.0 * i as f64, (1 + 5 * (i % 2)) as f64]).collect::<Vec<_>>();
    match mode {
        Mode::Points
        | Mode::Lines
        | Mode::LineStrip
        | Mode::LineLoop
        | Mode::LinesAdjacency
        | Mode::LineStripAdjacency => row(),
        Mode::Triangles | Mode::TriangleStrip => zigzag(15),
        // Those at even places are the corners, the others are not drawn.
        Mode::TrianglesAdjacency | Mode::TriangleStripAdjacency => {
            let corners = zigzag(15);
            corners.into_iter().flat_map(|corner| [corner, [1.0, 20.0]]).collect()
        }
        Mode::TriangleFan | Mode::Polygon => vec![
            [20.0, 2.0],
            [44.0, 3.0],
            [57.0, 8.0],
            [59.0, 15.0],
            [48.0, 21.0],
            [31.0, 23.0],
            [13.0, 20.0],
            [5.0, 11.0],
        ],
        Mode::Quads => (0..4)
            .flat_map(|i| {
                let x = 16.0 * i as f64;
                [[x, 1.0], [x + 11.0, 3.0], [x + 14.0, 16.0], [x + 1.0, 19.0]]
            })
            .collect(),
        Mode::QuadStrip => {
            (0..8).flat_map(|i| [[8.0 * i as f64, 1.0], [8.0 * i as f64 + 1.0, 14.0]]).collect()
        }
    }
}

/// What a primitive does to a pixel: `None` where an edge passes its centre.
fn covers(corners: &[[f64; 2]], [x, y]: [usize; 2]) -> Option<bool> {
    let at = [x as f64 + 0.5, y as f64 + 0.5];
    match corners {
        [point] => Some(*point == at),
        // A line between centres of a row: the pixel where it ends is not drawn (diamond exit, section 3.5.1).
        [from, to] => {
            let between = if from[0] < to[0] {
                from[0] <= at[0] && at[0] < to[0]
            } else {
                to[0] < at[0] && at[0] <= from[0]
            };
            Some(between && at[1] == from[1])
        }
        [first, rest @ ..] => {
            let mut any = false;
            for pair in rest.windows(2) {
                any |= inside([*first, pair[0], pair[1]], at)?;
            }
            Some(any)
        }
        [] => Some(false),
    }
}

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    for mode in MODES {
        let corners = vertices(mode);
        for convention in [Convention::First, Convention::Last] {
            let all = primitives(mode, corners.len(), convention);
            let other = match convention {
                Convention::First => Convention::Last,
                Convention::Last => Convention::First,
            };
            let swapped = primitives(mode, corners.len(), other);
            let hit = |(names, _): &(Vec<usize>, usize), pixel: [usize; 2]| {
                let corners: Vec<_> = names.iter().map(|&name| corners[name]).collect();
                covers(&corners, pixel)
            };
            let every = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| [x, y]));
            // Edges that pass a pixel's centre are another check's matter.
            let cases: Vec<[usize; 2]> =
                every.filter(|&pixel| all.iter().all(|p| hit(p, pixel).is_some())).collect();
            let shown = |pixel: [usize; 2], all: &[(Vec<usize>, usize)]| {
                all.iter().rev().find(|p| hit(p, pixel) == Some(true)).map(|(_, vertex)| *vertex)
            };
            let drawn = cases.iter().filter(|&&pixel| shown(pixel, &all).is_some()).count();
            let whole = SIZE[0] * SIZE[1];
            tally.reach(
                format!("{mode:?}, pixels that no edge passes"),
                cases.len(),
                whole * 9 / 10,
            );
            tally.reach(
                format!("{mode:?}, pixels that are drawn"),
                drawn,
                if mode == Mode::Points { 12 } else { 15 },
            );
            let expect = |&pixel: &[usize; 2], variant: Variant| {
                let all =
                    if variant.has(Mutation::ProvokingConventionSwapped) { &swapped } else { &all };
                let vertex = shown(pixel, all).map(|vertex| {
                    let fan = mode == Mode::TriangleFan && convention == Convention::First;
                    if fan && variant.has(Mutation::FanProvokedByCentre) { 0 } else { vertex }
                });
                vertex.map_or([0.0; 4], |vertex| [vertex as f64 + 1.0, 0.0, 0.0, 1.0])
            };
            let scene = (mode, convention);
            harness.compare_with(
                Dialect::Compatibility,
                tally,
                &scene,
                &cases,
                expect,
                |session| {
                    session.frame(GL_RGBA32UI, SIZE, 0)?;
                    session.stages(&Stages {
                        vertex: "layout(location = 0) in vec2 at; flat out uint name;
                        void main() {
                            name = uint(gl_VertexID) + 1u;
                            gl_Position = vec4(at / vec2(32.0, 12.0) - 1.0, 0.0, 1.0);
                        }",
                        geometry: "",
                        fragment: "flat in uint name; out uvec4 result;
                        void main() { result = uvec4(name, 0, 0, 1); }",
                    })?;
                    let places: Vec<f32> =
                        corners.as_flattened().iter().map(|&c| c as f32).collect();
                    session.float_array(0, 2, &places)?;
                    glProvokingVertex(match convention {
                        Convention::First => GL_FIRST_VERTEX_CONVENTION,
                        Convention::Last => GL_LAST_VERTEX_CONVENTION,
                    });
                    glDrawArrays(mode_enum(mode), 0, corners.len());
                    let words = session.read_words(SIZE)?;
                    Ok(cases.iter().map(|[x, y]| words[y * SIZE[0] + x].map(f64::from)).collect())
                },
            )?;
        }
    }
    Ok(())
}
