//! Points, lines and polygons through GL: state that is set is drawn with and answered; what is wrong
//! is refused.

#[path = "common/shading.rs"]
mod shading;

use gl_api::*;
use shading::use_program;
use std::collections::BTreeSet;

const SIZE: i32 = 16;

fn context() -> Context {
    let desc = ContextDesc { width: SIZE as u32, height: SIZE as u32, ..ContextDesc::default() };
    let mut context = Context::new(desc).expect("a device");
    let size = f64::from(SIZE);
    context.matrix_mode(GL_PROJECTION);
    context.ortho(0.0, size, 0.0, size, -1.0, 1.0);
    context.matrix_mode(GL_MODELVIEW);
    context
}

fn pixels(context: &mut Context) -> Vec<[u8; 4]> {
    let mut bytes = vec![0; (SIZE * SIZE * 4) as usize];
    let out = DataOut::Bytes(&mut bytes);
    context.read_pixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, out);
    assert_eq!(context.get_error(), GL_NO_ERROR, "{:?}", context.messages());
    bytes.as_chunks().0.to_vec()
}

/// Clears, draws, and gives the pixels with any red.
fn drawn(context: &mut Context, mode: GLenum, vertices: &[[f32; 2]]) -> BTreeSet<(i32, i32)> {
    context.clear(GL_COLOR_BUFFER_BIT);
    context.begin(mode);
    for &[x, y] in vertices {
        context.vertex_2f(x, y);
    }
    context.end();
    let all = pixels(context);
    let red = (0..).zip(&all).filter(|(_, pixel)| pixel[0] != 0);
    red.map(|(at, _)| (at % SIZE, at / SIZE)).collect()
}

fn row(y: i32, columns: impl IntoIterator<Item = i32>) -> BTreeSet<(i32, i32)> {
    columns.into_iter().map(|x| (x, y)).collect()
}

const QUAD: [[f32; 2]; 4] = [[2.5, 2.5], [8.5, 2.5], [8.5, 8.5], [2.5, 8.5]];

#[test]
fn lines_have_a_width_and_a_stipple() {
    let mut c = context();
    let line = [[1.5, 4.5], [13.5, 4.5]];
    assert_eq!(drawn(&mut c, GL_LINES, &line), row(4, 1..13));
    c.line_stipple(2, 0x5555);
    c.enable(GL_LINE_STIPPLE);
    assert_eq!(drawn(&mut c, GL_LINES, &line), row(4, (1..13).filter(|x| (x - 1) / 2 % 2 == 0)));
    c.disable(GL_LINE_STIPPLE);
    c.line_width(3.0);
    assert_eq!(drawn(&mut c, GL_LINES, &line).len(), 36);
    let mut values = [0; 2];
    c.get_integerv(GL_LINE_STIPPLE_PATTERN, &mut values);
    assert_eq!(values[0], 0x5555);
    c.line_stipple(1000, 1);
    c.get_integerv(GL_LINE_STIPPLE_REPEAT, &mut values);
    assert_eq!(values[0], 256);
}

/// GL 2.1, section 2.12: a line is cut by the view volume, and what is left has its width.
#[test]
fn lines_end_where_their_middle_leaves_the_viewport() {
    let mut c = context();
    // Window coordinates are those of `context`, whatever the viewport.
    let view = |c: &mut Context, [low, size]: [i32; 2]| {
        c.viewport(low, low, size, size);
        c.matrix_mode(GL_PROJECTION);
        c.load_identity();
        let [low, high] = [low, low + size].map(f64::from);
        c.ortho(low, high, low, high, -1.0, 1.0);
    };
    let (low, high) = (4, 12);
    for line in [
        [[2.3_f32, 6.1], [14.2, 2.7]],
        [[1.2, 3.1], [15.7, 13.9]],
        [[6.2, 1.4], [3.1, 14.2]],
        [[14.3, 15.2], [6.1, 5.4]],
        [[1.3, 3.2], [15.1, 3.4]],
    ] {
        let slope = [line[1][0] - line[0][0], line[1][1] - line[0][1]].map(f32::abs);
        let minor = usize::from(slope[0] >= slope[1]);
        c.line_width(1.0);
        view(&mut c, [0, SIZE]);
        let inside = |(x, y): &(i32, i32)| [x, y].iter().all(|v| (low..high).contains(*v));
        let middle: BTreeSet<_> =
            drawn(&mut c, GL_LINES, &line).into_iter().filter(inside).collect();
        view(&mut c, [low, high - low]);
        assert_eq!(drawn(&mut c, GL_LINES, &line), middle, "{line:?}");
        c.line_width(3.0);
        let moved = |(x, y), by| if minor == 1 { (x, y + by) } else { (x + by, y) };
        let want: BTreeSet<_> =
            middle.iter().flat_map(|&at| [-1, 0, 1].map(|by| moved(at, by))).collect();
        assert_eq!(drawn(&mut c, GL_LINES, &line), want, "{line:?}");

        // A smooth one covers as much as its part inside is long.
        let [from, to] = line.map(|end| end.map(f64::from));
        let at = |part: f64| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part);
        let is_in = |part: &u32| {
            let place = at(f64::from(*part) / 1e5);
            place.iter().all(|v| (f64::from(low)..=f64::from(high)).contains(v))
        };
        let share = (0..100_000).filter(is_in).count() as f64 / 1e5;
        let length = (to[0] - from[0]).hypot(to[1] - from[1]) * share;
        c.enable(GL_LINE_SMOOTH);
        c.enable(GL_BLEND);
        c.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        drawn(&mut c, GL_LINES, &line);
        let area: f64 = pixels(&mut c).iter().map(|pixel| f64::from(pixel[0]) / 255.0).sum();
        assert!((area - 3.0 * length).abs() < 0.1, "{line:?}: {area} of {}", 3.0 * length);
        c.disable(GL_LINE_SMOOTH);
        c.disable(GL_BLEND);
    }
}

#[test]
fn polygons_have_modes_and_edge_flags() {
    let mut c = context();
    c.polygon_mode(GL_FRONT, GL_LINE);
    assert_eq!(drawn(&mut c, GL_QUADS, &QUAD).len(), 24);
    c.polygon_mode(GL_FRONT_AND_BACK, GL_POINT);
    assert_eq!(drawn(&mut c, GL_POLYGON, &QUAD), BTreeSet::from([(2, 2), (8, 2), (8, 8), (2, 8)]));
    let mut modes = [0; 2];
    c.get_integerv(GL_POLYGON_MODE, &mut modes);
    assert_eq!(modes, [GL_POINT as i32; 2]);
    // Edge flags of immediate mode, and of an array.
    let flags = [1_u8, 0, 0, 1];
    c.clear(GL_COLOR_BUFFER_BIT);
    c.begin(GL_QUADS);
    for ([x, y], flag) in QUAD.into_iter().zip(flags) {
        c.edge_flag(flag != 0);
        c.vertex_2f(x, y);
    }
    c.end();
    c.edge_flagv(&[1]);
    let marked = |c: &mut Context| pixels(c).iter().filter(|pixel| pixel[0] != 0).count();
    assert_eq!(marked(&mut c), 2);
    let positions: Vec<u8> = QUAD.iter().flatten().flat_map(|v| v.to_ne_bytes()).collect();
    c.vertex_pointer(2, GL_FLOAT, 0, Data::Bytes(&positions));
    c.edge_flag_pointer(0, Data::Bytes(&[0, 1, 1, 1]));
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.enable_client_state(GL_EDGE_FLAG_ARRAY);
    assert!(c.is_enabled(GL_EDGE_FLAG_ARRAY));
    c.clear(GL_COLOR_BUFFER_BIT);
    c.draw_arrays(GL_QUADS, 0, 4);
    assert_eq!(marked(&mut c), 3);
}

#[test]
fn a_polygon_stipple_reads_and_answers_by_the_pixel_store() {
    let mut c = context();
    let mut mask = [0_u8; 128];
    for (y, row) in mask.chunks_mut(4).enumerate() {
        row.copy_from_slice(&[0x81, y as u8, 0, 0xFF]);
    }
    c.polygon_stipple(Data::Bytes(&mask));
    let mut back = [0_u8; 128];
    c.get_polygon_stipple(DataOut::Bytes(&mut back));
    assert_eq!(back, mask);
    c.enable(GL_POLYGON_STIPPLE);
    let all = [[0.0, 0.0], [16.0, 0.0], [16.0, 16.0], [0.0, 16.0]];
    let got = drawn(&mut c, GL_QUADS, &all);
    for (y, row) in mask.chunks(4).enumerate().take(16) {
        for x in 0..16 {
            let on = row[x / 8] >> (7 - x % 8) & 1 == 1;
            assert_eq!(got.contains(&(x as i32, y as i32)), on, "{x}, {y}");
        }
    }
}

#[test]
fn points_have_a_size_a_rim_and_sprites() {
    let mut c = context();
    c.point_size(4.0);
    assert_eq!(drawn(&mut c, GL_POINTS, &[[6.1, 6.1]]).len(), 16);
    c.point_parameterf(GL_POINT_SIZE_MAX, 2.0);
    assert_eq!(drawn(&mut c, GL_POINTS, &[[6.1, 6.1]]).len(), 4);
    c.point_parameterf(GL_POINT_SIZE_MAX, 64.0);
    c.enable(GL_POINT_SMOOTH);
    c.enable(GL_BLEND);
    c.blend_func(GL_SRC_ALPHA, GL_ZERO);
    c.clear(GL_COLOR_BUFFER_BIT);
    drawn(&mut c, GL_POINTS, &[[6.1, 6.1]]);
    let sum: u32 = pixels(&mut c).iter().map(|pixel| u32::from(pixel[0])).sum();
    let want = std::f64::consts::PI * 4.0 * 255.0;
    assert!((f64::from(sum) - want).abs() < 0.01 * want, "{sum}, {want}");
    c.disable(GL_BLEND);
    c.enable(GL_POINT_SPRITE);
    c.tex_envi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE as i32);
    let mut on = [0];
    c.get_tex_enviv(GL_POINT_SPRITE, GL_COORD_REPLACE, &mut on);
    assert_eq!(on, [1]);
    // A texture of two rows: t = 0 is at the upper edge unless the state says otherwise.
    c.bind_texture(GL_TEXTURE_2D, 1);
    let rows = Data::Bytes(&[255, 0, 0, 255, 0, 255, 0, 255]);
    c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as i32, 1, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, rows);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST as i32);
    c.enable(GL_TEXTURE_2D);
    let upper = drawn(&mut c, GL_POINTS, &[[6.0, 6.0]]);
    let rect = |rows: std::ops::Range<i32>| -> BTreeSet<_> {
        rows.flat_map(|y| (4..8).map(move |x| (x, y))).collect()
    };
    assert_eq!(upper, rect(6..8));
    c.point_parameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT as i32);
    assert_eq!(drawn(&mut c, GL_POINTS, &[[6.0, 6.0]]), rect(4..6));
}

#[test]
fn the_size_of_points_falls_with_their_distance() {
    let mut c = context();
    c.point_size(8.0);
    // The eye is at the origin: 8 pixels away, 8 · sqrt(1 / (8² / 4)) = 2.
    c.point_parameterfv(GL_POINT_DISTANCE_ATTENUATION, &[0.0, 0.0, 0.25]);
    assert_eq!(drawn(&mut c, GL_POINTS, &[[8.0, 0.1]]).len(), 2);
    c.point_parameterf(GL_POINT_SIZE_MIN, 4.0);
    assert_eq!(drawn(&mut c, GL_POINTS, &[[8.0, 8.0]]).len(), 16);
}

#[test]
fn coverage_comes_before_the_alpha_test() {
    let mut c = context();
    c.enable(GL_LINE_SMOOTH);
    c.enable(GL_ALPHA_TEST);
    let line = [[1.0, 4.0], [13.0, 4.0]];
    // Half of each of two rows is covered.
    c.alpha_func(GL_GREATER, 0.4);
    assert_eq!(drawn(&mut c, GL_LINES, &line).len(), 24);
    c.alpha_func(GL_GREATER, 0.6);
    assert_eq!(drawn(&mut c, GL_LINES, &line).len(), 0);
}

#[test]
fn programs_give_sizes_and_two_sides() {
    let mut c = context();
    use_program(
        &mut c,
        "void main() { gl_Position = ftransform(); gl_PointSize = 3.0; \
         gl_FrontColor = vec4(1.0, 0.0, 0.0, 1.0); gl_BackColor = vec4(0.0, 1.0, 0.0, 1.0); }",
        "void main() { gl_FragColor = gl_Color; }",
    );
    assert_eq!(drawn(&mut c, GL_POINTS, &[[6.5, 6.5]]).len(), 1);
    c.enable(GL_VERTEX_PROGRAM_POINT_SIZE);
    assert_eq!(drawn(&mut c, GL_POINTS, &[[6.5, 6.5]]).len(), 9);
    let back: Vec<_> = QUAD.into_iter().rev().collect();
    let color = |c: &mut Context, vertices: &[[f32; 2]]| {
        drawn(c, GL_QUADS, vertices);
        pixels(c)[(5 * SIZE + 5) as usize]
    };
    assert_eq!(color(&mut c, &back), [255, 0, 0, 255]);
    c.enable(GL_VERTEX_PROGRAM_TWO_SIDE);
    assert_eq!(color(&mut c, &back), [0, 255, 0, 255]);
    assert_eq!(color(&mut c, &QUAD), [255, 0, 0, 255]);
}
