//! Outlines of polygons: the edges that user clip planes make (GL 2.1, section 2.12), and the line stipple, which goes
//! on around a polygon (section 3.5.4) and where the scissor hides a part (section 3.4.2).

use gl_api::*;
use std::collections::BTreeSet;

const SIZE: u32 = 40;

fn context() -> Context {
    let mut c = Context::new(ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() })
        .expect("a device");
    c.ortho(0.0, SIZE.into(), 0.0, SIZE.into(), -1.0, 1.0);
    c.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
    c
}

fn pixels(c: &mut Context) -> Vec<[u8; 4]> {
    let mut bytes = vec![0; (SIZE * SIZE * 4) as usize];
    let side = SIZE as i32;
    c.read_pixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut bytes));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    bytes.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect()
}

/// The pixels that have green, and a clear picture for the next.
fn drawn(c: &mut Context) -> BTreeSet<(u32, u32)> {
    let found = (0..).zip(pixels(c)).filter(|(_, pixel)| pixel[1] != 0);
    let found = found.map(|(at, _)| (at % SIZE, at / SIZE)).collect();
    c.clear(GL_COLOR_BUFFER_BIT);
    found
}

/// A quadrilateral between two corners, which gets redder upwards; its vertices have these `w`.
fn quad(
    c: &mut Context,
    mode: GLenum,
    [left, low]: [f32; 2],
    [right, high]: [f32; 2],
    ws: [f32; 4],
) {
    c.begin(mode);
    let corners = [(left, low, 0.0), (right, low, 0.0), (right, high, 1.0), (left, high, 1.0)];
    for ((x, y, red), w) in corners.into_iter().zip(ws) {
        c.color_3f(red, 1.0, 0.0);
        c.vertex_4f(x * w, y * w, 0.0, w);
    }
    c.end();
}

/// The rim of a rectangle of pixels.
fn rim([left, low]: [u32; 2], [right, high]: [u32; 2]) -> BTreeSet<(u32, u32)> {
    let all = (left..=right).flat_map(|x| (low..=high).map(move |y| (x, y)));
    all.filter(|&(x, y)| x == left || x == right || y == low || y == high).collect()
}

#[test]
fn user_planes_give_polygons_edges() {
    let mut c = context();
    for mode in [GL_QUADS, GL_POLYGON] {
        for ws in [[1.0; 4], [1.0, 3.0, 2.0, 0.5]] {
            c.clip_plane(GL_CLIP_PLANE0, &[1.0, 0.0, 0.0, -15.5]);
            c.clip_plane(GL_CLIP_PLANE1, &[0.0, 1.0, 0.0, -10.5]);
            c.enable(GL_CLIP_PLANE0);
            quad(&mut c, mode, [5.5, 5.5], [25.5, 25.5], ws);
            assert_eq!(drawn(&mut c), rim([15, 5], [25, 25]), "{mode:#x} {ws:?}");
            c.enable(GL_CLIP_PLANE1);
            quad(&mut c, mode, [5.5, 5.5], [25.5, 25.5], ws);
            let outline = pixels(&mut c);
            assert_eq!(drawn(&mut c), rim([15, 10], [25, 25]), "{mode:#x} {ws:?}");
            c.disable(GL_CLIP_PLANE0);
            c.disable(GL_CLIP_PLANE1);
            // What the edges have is what the polygon has there.
            c.polygon_mode(GL_FRONT_AND_BACK, GL_FILL);
            quad(&mut c, mode, [5.5, 5.5], [25.5, 25.5], ws);
            let filled = pixels(&mut c);
            c.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
            drawn(&mut c);
            for at in (11..25).map(|y| (15, y)).chain((16..25).map(|x| (x, 10))) {
                let [got, want] = [&outline, &filled].map(|p| p[(at.1 * SIZE + at.0) as usize]);
                assert!(got[0].abs_diff(want[0]) <= 1, "{at:?}: {got:?}, filled {want:?}");
            }
        }
    }
    // The view volume makes none.
    quad(&mut c, GL_QUADS, [5.5, 5.5], [55.5, 25.5], [1.0; 4]);
    let open = rim([5, 5], [50, 25]).into_iter().filter(|&(x, _)| x < SIZE).collect();
    assert_eq!(drawn(&mut c), open);
}

/// Where a plane cuts an edge of the polygon, and where two planes meet within it, and nowhere else.
#[test]
fn user_planes_give_polygons_vertices() {
    let mut c = context();
    c.polygon_mode(GL_FRONT_AND_BACK, GL_POINT);
    c.clip_plane(GL_CLIP_PLANE0, &[1.0, 0.0, 0.0, -15.5]);
    c.clip_plane(GL_CLIP_PLANE1, &[0.0, 1.0, 0.0, -10.5]);
    for mode in [GL_QUADS, GL_POLYGON] {
        // Red where the right edge is cut: of 5.5 to 25.5 a quarter, in perspective a third.
        for (ws, red) in [([1.0; 4], 64_u8), ([1.0, 3.0, 2.0, 0.5], 85)] {
            c.enable(GL_CLIP_PLANE0);
            quad(&mut c, mode, [5.5, 5.5], [25.5, 25.5], ws);
            let want = BTreeSet::from([(15, 5), (25, 5), (15, 25), (25, 25)]);
            assert_eq!(drawn(&mut c), want, "{mode:#x} {ws:?}");
            c.enable(GL_CLIP_PLANE1);
            quad(&mut c, mode, [5.5, 5.5], [25.5, 25.5], ws);
            let want = BTreeSet::from([(15, 10), (25, 10), (15, 25), (25, 25)]);
            assert_eq!(drawn(&mut c), want, "{mode:#x} {ws:?}");
            // One colour all over a point.
            c.point_size(3.0);
            quad(&mut c, mode, [5.5, 5.5], [25.5, 25.5], ws);
            let found = pixels(&mut c);
            for (x, y) in [(24, 9), (25, 10), (26, 11)] {
                let [got, ..] = found[y * SIZE as usize + x];
                assert!(got.abs_diff(red) <= 1, "{x} {y}: {got} for {red}");
            }
            assert_eq!(drawn(&mut c).len(), 4 * 9);
            c.point_size(1.0);
            c.disable(GL_CLIP_PLANE0);
            c.disable(GL_CLIP_PLANE1);
        }
    }
    // What is left of an edge keeps its flag; the edge that is made has one.
    c.enable(GL_CLIP_PLANE0);
    for flag in [GL_FALSE, GL_TRUE] {
        c.begin(GL_POLYGON);
        for (x, y, flag) in
            [(5.5, 5.5, flag), (25.5, 5.5, GL_FALSE), (25.5, 25.5, GL_FALSE), (5.5, 25.5, GL_FALSE)]
        {
            c.edge_flag(flag == GL_TRUE);
            c.vertex_2f(x, y);
        }
        c.end();
        let mut want = BTreeSet::from([(15, 25)]);
        want.extend((flag == GL_TRUE).then_some((15, 5)));
        assert_eq!(drawn(&mut c), want, "{flag}");
    }
}

/// So many vertices that the polygon is drawn in parts, of which each must know where the stipple has come.
#[test]
fn a_stipple_goes_on_around_a_polygon_of_many_vertices() {
    let mut c = context();
    c.enable(GL_LINE_STIPPLE);
    c.line_stipple(3, 0x0F3F);
    c.color_3f(0.0, 1.0, 0.0);
    let mut around = |mode: GLenum| {
        c.begin(mode);
        for at in 0..20_000 {
            let (sin, cos) = (f64::from(at) / 20_000.0 * std::f64::consts::TAU).sin_cos();
            c.vertex_2d(20.0 + 15.0 * cos, 20.0 + 15.0 * sin);
        }
        c.end();
        drawn(&mut c)
    };
    let looped = around(GL_LINE_LOOP);
    assert!((20..70).contains(&looped.len()), "{}", looped.len());
    assert_eq!(around(GL_POLYGON), looped);
}

#[test]
fn a_stipple_goes_on_around_a_polygon() {
    let mut c = context();
    c.enable(GL_LINE_STIPPLE);
    for pattern in [0x00FF, 0x5555, 0x1C47] {
        c.line_stipple(1, pattern);
        let around = |low: u32| {
            let rows = [(low, 5..25), (low + 10, 6..26)].map(|(y, xs)| (y, xs.collect::<Vec<_>>()));
            let [bottom, top] = rows.map(|(y, xs)| xs.into_iter().map(move |x| (x, y)));
            let right = (low..low + 10).map(|y| (25, y));
            let left = (low + 1..=low + 10).rev().map(|y| (5, y));
            let all = bottom.chain(right).chain(top.rev()).chain(left);
            all.enumerate().filter(|(at, _)| pattern >> (at % 16) & 1 == 1).map(|(_, pixel)| pixel)
        };
        let want: BTreeSet<_> = around(5).chain(around(20)).collect();
        for (mode, convention) in [
            (GL_QUADS, GL_LAST_VERTEX_CONVENTION),
            (GL_QUADS, GL_FIRST_VERTEX_CONVENTION),
            (GL_POLYGON, GL_LAST_VERTEX_CONVENTION),
        ] {
            c.provoking_vertex(convention);
            for low in [5.5, 20.5] {
                quad(&mut c, mode, [5.5, low], [25.5, low + 10.0], [1.0; 4]);
            }
            assert_eq!(drawn(&mut c), want, "{mode:#x} {convention:#x} {pattern:#x}");
        }
    }
}

#[test]
fn a_stipple_goes_on_where_the_scissor_hides_it() {
    let mut c = context();
    c.enable(GL_LINE_STIPPLE);
    c.line_stipple(1, 0x00FF);
    let zigzag = |c: &mut Context| {
        c.color_3f(0.0, 1.0, 0.0);
        c.begin(GL_LINE_STRIP);
        for (x, y) in [(5.5, 5.5), (18.5, 5.5), (18.5, 25.5), (38.5, 25.5)] {
            c.vertex_2f(x, y);
        }
        c.end();
    };
    zigzag(&mut c);
    let whole = drawn(&mut c);
    for low in [4, 6, 20] {
        c.enable(GL_SCISSOR_TEST);
        c.scissor(0, low, SIZE as i32, SIZE as i32);
        zigzag(&mut c);
        c.disable(GL_SCISSOR_TEST);
        let want = whole.iter().copied().filter(|&(_, y)| y >= low as u32).collect();
        assert_eq!(drawn(&mut c), want, "from {low} on");
    }
}

/// A wide line is columns of one fragment, replicated (GL 2.1, section 3.4.2).
#[test]
fn a_wide_line_has_one_colour_across() {
    let mut c = context();
    c.line_width(7.0);
    for (x, y) in [(31.5, 22.5), (18.5, 33.5), (31.5, 4.5)] {
        c.clear(GL_COLOR_BUFFER_BIT);
        c.begin(GL_LINES);
        for ((x, y), red) in [((8.5, 12.5), 0.0), ((x, y), 1.0)] {
            c.color_3f(red, 1.0, 0.0);
            c.vertex_2f(x, y);
        }
        c.end();
        let picture = pixels(&mut c);
        let is_steep = y - 12.5 > x - 8.5;
        let at = |along: u32, across: u32| match is_steep {
            false => picture[(across * SIZE + along) as usize],
            true => picture[(along * SIZE + across) as usize],
        };
        let columns = (0..SIZE).filter(|&along| (0..SIZE).any(|across| at(along, across)[1] > 0));
        let reds = columns.map(|along| {
            let column = (0..SIZE).map(|across| at(along, across)).filter(|pixel| pixel[1] > 0);
            let column: Vec<_> = column.collect();
            assert_eq!(column, [column[0]; 7], "({x}, {y}): column {along}");
            column[0][0]
        });
        let reds: Vec<u8> = reds.collect();
        assert!(reds.is_sorted() && reds[0] < 15 && reds[reds.len() - 1] > 240, "{reds:?}");
    }
}
