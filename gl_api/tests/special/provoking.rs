//! Which vertex a primitive has its flat colour of: `ARB_provoking_vertex`.

use super::{context, fine, pixel};
use gl_api::*;

/// A kind of primitives, how many vertices, and for each primitive a point within it (in pixels)
/// and the vertices that the conventions choose, the first and the last.
type Case = (GLenum, i32, &'static [([i32; 2], usize, usize)]);

/// The vertices lie in two rows, from left to right: 0 below, 1 above it, 2 below, two pixels on.
const ZIGZAG: &[Case] = &[
    (GL_TRIANGLES, 6, &[([0, 0], 0, 2), ([3, 3], 3, 5)]),
    (GL_TRIANGLE_STRIP, 6, &[([0, 0], 0, 2), ([1, 3], 1, 3), ([2, 0], 2, 4), ([3, 3], 3, 5)]),
    (GL_QUAD_STRIP, 6, &[([0, 1], 0, 3), ([1, 3], 0, 3), ([2, 1], 2, 5), ([3, 2], 2, 5)]),
    (GL_LINES, 4, &[([0, 1], 0, 1), ([2, 1], 2, 3)]),
];

/// The vertices go around: right below, right above, left above, left below.
const AROUND: &[Case] = &[
    (GL_TRIANGLE_FAN, 4, &[([2, 2], 1, 2), ([1, 1], 2, 3)]),
    (GL_QUADS, 4, &[([2, 2], 0, 3), ([1, 1], 0, 3), ([1, 2], 0, 3), ([2, 1], 0, 3)]),
    (GL_POLYGON, 4, &[([2, 2], 0, 0), ([1, 1], 0, 0)]),
    (GL_LINE_STRIP, 3, &[([3, 1], 0, 1), ([2, 3], 1, 2)]),
    (GL_LINE_LOOP, 4, &[([3, 1], 0, 1), ([2, 3], 1, 2), ([0, 2], 2, 3), ([1, 0], 3, 0)]),
];

fn zigzag(vertex: usize) -> [f32; 2] {
    [(vertex / 2 * 2) as f32 + 0.25, (vertex % 2 * 4) as f32]
}

/// A square through the centres of pixels.
fn around(vertex: usize) -> [f32; 2] {
    [[3.5, 0.5], [3.5, 3.5], [0.5, 3.5], [0.5, 0.5]][vertex]
}

/// The red of a vertex.
fn red(vertex: usize) -> u8 {
    20 * (vertex as u8 + 1)
}

fn prepared() -> Context {
    let mut c = context(5, 4);
    c.ortho(0.0, 5.0, 0.0, 4.0, -1.0, 1.0);
    c.shade_model(GL_FLAT);
    c
}

fn draw(c: &mut Context, mode: GLenum, count: i32, place: fn(usize) -> [f32; 2]) {
    c.begin(mode);
    for vertex in 0..count as usize {
        c.color_3ub(red(vertex), 0, 0);
        c.vertex_2fv(&place(vertex));
    }
    c.end();
}

/// The colours of what feedback gives, one a primitive.
fn fed(c: &mut Context, mode: GLenum, count: i32, place: fn(usize) -> [f32; 2]) -> Vec<u8> {
    c.feedback_buffer(1024, GL_3D_COLOR, DataOut::Null);
    c.render_mode(GL_FEEDBACK);
    draw(c, mode, count, place);
    c.render_mode(GL_RENDER);
    fine(c);
    let (mut at, mut reds) = (0, Vec::new());
    let values = c.feedback();
    while let Some(token) = values.get(at) {
        let (head, corners) = match *token as GLenum {
            GL_POLYGON_TOKEN => (2, values[at + 1] as usize),
            GL_LINE_TOKEN | GL_LINE_RESET_TOKEN => (1, 2),
            other => panic!("{other}"),
        };
        let own = (0..corners).map(|corner| values[at + head + 7 * corner + 3]);
        let own: Vec<u8> = own.map(|red| (red * 255.0).round() as u8).collect();
        assert!(own.iter().all(|red| *red == own[0]), "{own:?}");
        reds.push(own[0]);
        at += head + 7 * corners;
    }
    reds
}

#[test]
fn flat_colours_are_of_the_vertex_that_the_convention_chooses() {
    let cases = ZIGZAG.iter().map(|case| (case, zigzag as fn(usize) -> [f32; 2]));
    let cases = cases.chain(AROUND.iter().map(|case| (case, around as _)));
    for (&(mode, count, parts), place) in cases {
        for convention in [GL_FIRST_VERTEX_CONVENTION, GL_LAST_VERTEX_CONVENTION] {
            let mut c = prepared();
            c.provoking_vertex(convention);
            draw(&mut c, mode, count, place);
            let first = convention == GL_FIRST_VERTEX_CONVENTION;
            let chosen = |&(_, a, b): &(_, usize, usize)| red(if first { a } else { b });
            for part in parts {
                let [x, y] = part.0;
                let found = pixel(&mut c, x, y)[0];
                let name = format!("{} {} {part:?}", enum_name(mode), enum_name(convention));
                assert_eq!(found, chosen(part), "{name}");
            }
            // Each primitive once: the parts of a quadrilateral are one.
            let mut want: Vec<u8> = parts.iter().map(chosen).collect();
            match mode {
                GL_QUADS | GL_QUAD_STRIP | GL_POLYGON => want.dedup(),
                _ => {}
            }
            assert_eq!(fed(&mut c, mode, count, place), want, "{}", enum_name(mode));
        }
    }
}

#[test]
fn outlines_have_the_colour_of_their_polygon() {
    let mut c = prepared();
    c.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
    for (convention, vertex) in [(GL_FIRST_VERTEX_CONVENTION, 0), (GL_LAST_VERTEX_CONVENTION, 3)] {
        c.provoking_vertex(convention);
        c.clear(GL_COLOR_BUFFER_BIT);
        draw(&mut c, GL_QUADS, 4, around);
        for [x, y] in [[3, 1], [2, 3], [0, 2], [1, 0]] {
            assert_eq!(pixel(&mut c, x, y)[0], red(vertex), "{x} {y}");
        }
        // No diagonal is an edge.
        for [x, y] in [[1, 1], [1, 2], [2, 1], [2, 2]] {
            assert_eq!(pixel(&mut c, x, y)[0], 0, "{x} {y}");
        }
    }
}
