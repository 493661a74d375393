//! Feedback: GL 2.1, section 5.3.

use super::{ALL, context, draw, fine};
use gl_api::*;

fn feed(c: &mut Context, ty: GLenum) {
    c.feedback_buffer(256, ty, DataOut::Null);
    assert_eq!(c.render_mode(GL_FEEDBACK), 0);
}

/// What a draw writes.
fn fed(c: &mut Context, ty: GLenum, draw: impl FnOnce(&mut Context)) -> Vec<f32> {
    feed(c, ty);
    draw(c);
    let count = c.render_mode(GL_RENDER);
    fine(c);
    assert_eq!(c.feedback().len(), count as usize);
    c.feedback().to_vec()
}

const POINT: f32 = GL_POINT_TOKEN as f32;
const LINE: f32 = GL_LINE_TOKEN as f32;
const RESET: f32 = GL_LINE_RESET_TOKEN as f32;
const POLYGON: f32 = GL_POLYGON_TOKEN as f32;

#[test]
fn primitives_come_in_window_coordinates() {
    let mut c = context(8, 4);
    let points = fed(&mut c, GL_3D, |c| draw(c, GL_POINTS, &[[0.0, 0.0, 0.0], [0.5, 0.5, -1.0]]));
    assert_eq!(points, [POINT, 4.0, 2.0, 0.5, POINT, 6.0, 3.0, 0.0]);
    let corners = [[-1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    let strip = fed(&mut c, GL_2D, |c| draw(c, GL_LINE_STRIP, &corners));
    assert_eq!(strip, [RESET, 0.0, 2.0, 4.0, 2.0, LINE, 4.0, 2.0, 8.0, 2.0]);
    let quad = fed(&mut c, GL_2D, |c| draw(c, GL_QUADS, &ALL));
    assert_eq!(quad, [POLYGON, 4.0, 0.0, 0.0, 8.0, 0.0, 8.0, 4.0, 0.0, 4.0]);
    // A corner is cut off: two new ones.
    let cut = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let cut = fed(&mut c, GL_2D, |c| draw(c, GL_TRIANGLES, &cut));
    assert_eq!(cut, [POLYGON, 4.0, 4.0, 2.0, 8.0, 2.0, 8.0, 3.0, 4.0, 4.0]);
}

/// Vertices are run 64 at a time.
#[test]
fn each_vertex_of_many_has_its_own_numbers() {
    let mut c = context(256, 4);
    let x = |at: u16| f32::from(at) + 28.0;
    c.feedback_buffer(1 << 12, GL_3D_COLOR, DataOut::Null);
    c.render_mode(GL_FEEDBACK);
    c.begin(GL_POINTS);
    for at in 0..150 {
        c.color_3f(f32::from(at) / 256.0, 1.0, 0.0);
        c.vertex_2f(x(at) / 128.0 - 1.0, 0.0);
    }
    c.end();
    assert_eq!(c.render_mode(GL_RENDER), 150 * 8);
    let point = |at: u16| [POINT, x(at), 2.0, 0.5, f32::from(at) / 256.0, 1.0, 0.0, 1.0];
    let points: Vec<f32> = (0..150).flat_map(point).collect();
    assert_eq!(c.feedback(), points);
    fine(&mut c);
}

#[test]
fn colours_coordinates_and_tokens_come_along() {
    let mut c = context(8, 4);
    c.color_4f(0.25, 0.5, 0.75, 1.0);
    c.tex_coord_4f(1.0, 2.0, 3.0, 4.0);
    let one = |c: &mut Context| {
        c.pass_through(42.0);
        draw(c, GL_POINTS, &[[0.0, 0.0, 0.0]]);
    };
    let token = [GL_PASS_THROUGH_TOKEN as f32, 42.0, POINT];
    let (position, color, texture) =
        ([4.0, 2.0, 0.5], [0.25, 0.5, 0.75, 1.0], [1.0, 2.0, 3.0, 4.0]);
    let all = fed(&mut c, GL_3D_COLOR, one);
    assert_eq!(all, [&token[..], &position, &color].concat());
    let all = fed(&mut c, GL_3D_COLOR_TEXTURE, one);
    assert_eq!(all, [&token[..], &position, &color, &texture].concat());
    let all = fed(&mut c, GL_4D_COLOR_TEXTURE, one);
    assert_eq!(all, [&token[..], &position, &[1.0], &color, &texture].concat());
    let pixels = fed(&mut c, GL_2D, |c| {
        c.raster_pos_2f(0.0, 0.0);
        c.bitmap(8, 1, 0.0, 0.0, 1.0, 0.0, Data::Bytes(&[255]));
        // What has no bits is a bitmap, too.
        c.bitmap(0, 0, 0.0, 0.0, 1.0, 0.0, Data::Null);
        c.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(&[0; 4]));
        c.copy_pixels(0, 0, 1, 1, GL_COLOR);
    });
    let [bitmap, draw, copy] = [GL_BITMAP_TOKEN, GL_DRAW_PIXEL_TOKEN, GL_COPY_PIXEL_TOKEN];
    let tokens = [bitmap, draw, copy].map(|token| token as f32);
    let starts = [4.0, 5.0, 6.0, 6.0];
    let rows = [tokens[0], tokens[0], tokens[1], tokens[2]].into_iter().zip(starts);
    let want: Vec<f32> = rows.flat_map(|(token, x)| [token, x, 2.0]).collect();
    assert_eq!(pixels, want);
}

/// GL 2.1, section 2.5: of the calls of a list, only the one that is wrong is ignored.
#[test]
fn a_second_begin_of_a_list_leaves_its_vertices_to_the_first() {
    let calls: [fn(&mut Context); 3] = [
        |_| (),
        |c| c.begin(GL_LINES),
        // A call that is refused, too, between them.
        |c| {
            c.enable(GL_BLEND);
            c.begin(GL_LINES);
        },
    ];
    for (row, call) in calls.into_iter().enumerate() {
        for mode in [GL_COMPILE, GL_COMPILE_AND_EXECUTE] {
            let mut c = context(8, 4);
            feed(&mut c, GL_2D);
            c.new_list(1, mode);
            c.begin(GL_POINTS);
            c.vertex_2f(0.0, 0.0);
            call(&mut c);
            c.vertex_2f(0.5, 0.5);
            c.end();
            // Afterwards all is as before.
            c.begin(GL_POINTS);
            c.vertex_2f(0.5, 0.0);
            c.end();
            c.end_list();
            if mode == GL_COMPILE {
                c.call_list(1);
            }
            assert_eq!(c.get_error() == GL_INVALID_OPERATION, row > 0);
            let count = c.render_mode(GL_RENDER);
            let points = [POINT, 4.0, 2.0, POINT, 6.0, 3.0, POINT, 6.0, 2.0];
            assert_eq!(c.feedback(), points, "{row}");
            assert_eq!(count, 9);
        }
    }
}

#[test]
fn polygon_modes_shading_and_lights_are_applied_before() {
    let mut c = context(8, 4);
    let corners = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, 1.0, 0.0]];
    c.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
    let lines = fed(&mut c, GL_2D, |c| {
        c.begin(GL_TRIANGLES);
        for (corner, edge) in corners.iter().zip([true, false, true]) {
            c.edge_flag(edge);
            c.vertex_3fv(corner);
        }
        c.end();
    });
    assert_eq!(lines, [RESET, 0.0, 0.0, 8.0, 0.0, LINE, 0.0, 4.0, 0.0, 0.0]);
    c.polygon_mode(GL_FRONT_AND_BACK, GL_POINT);
    let points = fed(&mut c, GL_2D, |c| draw(c, GL_TRIANGLES, &corners));
    assert_eq!(points, [POINT, 0.0, 0.0, POINT, 8.0, 0.0, POINT, 0.0, 4.0]);
    c.polygon_mode(GL_FRONT_AND_BACK, GL_FILL);
    c.shade_model(GL_FLAT);
    let colored = |c: &mut Context| {
        c.begin(GL_TRIANGLES);
        for (corner, red) in corners.iter().zip([0.0, 0.5, 1.0]) {
            c.color_3f(red, 0.0, 0.0);
            c.vertex_3fv(corner);
        }
        c.end();
    };
    let flat = fed(&mut c, GL_3D_COLOR, colored);
    let reds: Vec<f32> = flat[2..].chunks(7).map(|corner| corner[3]).collect();
    assert_eq!(reds, [1.0; 3], "the last vertex provokes");
    c.enable(GL_LIGHTING);
    c.materialfv(GL_FRONT, GL_EMISSION, &[0.5, 0.0, 0.0, 1.0]);
    c.materialfv(GL_BACK, GL_EMISSION, &[0.0, 0.5, 0.0, 1.0]);
    c.materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, &[0.0; 4]);
    c.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    let front = fed(&mut c, GL_3D_COLOR, |c| draw(c, GL_TRIANGLES, &corners));
    assert_eq!(front[5..8], [0.5, 0.0, 0.0]);
    let turned = [corners[0], corners[2], corners[1]];
    let back = fed(&mut c, GL_3D_COLOR, |c| draw(c, GL_TRIANGLES, &turned));
    assert_eq!(back[5..8], [0.0, 0.5, 0.0]);
}

#[test]
fn a_buffer_too_small_says_so() {
    let mut c = context(8, 4);
    c.feedback_buffer(5, GL_2D, DataOut::Null);
    c.render_mode(GL_FEEDBACK);
    draw(&mut c, GL_POINTS, &[[0.0; 3]; 2]);
    assert_eq!(c.render_mode(GL_RENDER), -1);
    assert_eq!(c.feedback().len(), 5);
    // Tokens are ignored elsewhere.
    c.pass_through(1.0);
    fine(&mut c);
}
