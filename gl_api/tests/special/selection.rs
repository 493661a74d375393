//! Selection: GL 2.1, section 5.2.

use super::{ALL, context, draw, fine};
use gl_api::*;

/// A depth as hit records have it.
fn depth(z: f64) -> u32 {
    (z * f64::from(u32::MAX)).round_ties_even() as u32
}

fn select(c: &mut Context, size: i32) {
    c.select_buffer(size, DataOut::Null);
    assert_eq!(c.render_mode(GL_SELECT), 0);
    c.init_names();
}

#[test]
fn hits_have_names_and_depths() {
    let mut c = context(8, 8);
    select(&mut c, 64);
    c.push_name(7);
    draw(&mut c, GL_TRIANGLES, &[[0.0, 0.0, -0.5], [0.5, 0.0, 0.5], [0.0, 0.5, 0.0]]);
    c.push_name(8);
    draw(&mut c, GL_POINTS, &[[0.0, 0.0, 0.0]]);
    c.load_name(9);
    draw(&mut c, GL_TRIANGLES, &[[2.0, 0.0, 0.0], [3.0, 0.0, 0.0], [2.0, 1.0, 0.0]]);
    c.load_name(10);
    draw(&mut c, GL_LINES, &[[-3.0, 0.0, 1.0], [3.0, 0.0, 1.0]]);
    c.pop_name();
    c.pop_name();
    draw(&mut c, GL_QUADS, &ALL);
    assert_eq!(c.render_mode(GL_RENDER), 4);
    let expected = [
        vec![1, depth(0.25), depth(0.75), 7],
        vec![2, depth(0.5), depth(0.5), 7, 8],
        vec![2, depth(1.0), depth(1.0), 7, 10],
        vec![0, depth(0.5), depth(0.5)],
    ];
    assert_eq!(c.selection(), expected.concat());
    fine(&mut c);
    // No fragment was made.
    assert_eq!(super::pixel(&mut c, 4, 4), [0; 4]);
}

#[test]
fn what_is_culled_clipped_or_behind_a_plane_is_no_hit() {
    let mut c = context(8, 8);
    c.enable(GL_CULL_FACE);
    c.clip_plane(GL_CLIP_PLANE0, &[1.0, 0.0, 0.0, -0.5]);
    c.enable(GL_CLIP_PLANE0);
    for (name, corners, hit) in [
        (1, [[0.6, 0.0, 0.0], [0.9, 0.0, 0.0], [0.6, 0.5, 0.0]], true),
        (2, [[0.6, 0.0, 0.0], [0.6, 0.5, 0.0], [0.9, 0.0, 0.0]], false),
        (3, [[0.0, 0.0, 0.0], [0.4, 0.0, 0.0], [0.0, 0.5, 0.0]], false),
        (4, [[0.6, 0.0, 3.0], [0.9, 0.0, 3.0], [0.6, 0.5, 3.0]], false),
    ] {
        select(&mut c, 8);
        c.push_name(name);
        draw(&mut c, GL_TRIANGLES, &corners);
        assert_eq!(c.render_mode(GL_RENDER), i32::from(hit), "{name}");
    }
    fine(&mut c);
}

#[test]
fn arrays_lists_and_raster_positions_hit() {
    let mut c = context(8, 8);
    c.new_list(1, GL_COMPILE);
    c.load_name(5);
    draw(&mut c, GL_QUADS, &ALL);
    c.end_list();
    select(&mut c, 64);
    c.push_name(1);
    c.call_list(1);
    c.load_name(6);
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.vertex_pointer(3, GL_FLOAT, 0, ALL.as_flattened().arg());
    c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, Data::Bytes(&[0, 1, 2]));
    c.load_name(7);
    c.raster_pos_2f(0.0, 0.0);
    c.load_name(8);
    c.raster_pos_2f(5.0, 0.0);
    assert_eq!(c.render_mode(GL_RENDER), 3);
    let names: Vec<u32> = c.selection().chunks(4).map(|record| record[3]).collect();
    assert_eq!(names, [5, 6, 7]);
    fine(&mut c);
}

#[test]
fn a_buffer_too_small_says_so_and_keeps_what_fits() {
    let mut c = context(8, 8);
    select(&mut c, 6);
    c.push_name(1);
    draw(&mut c, GL_QUADS, &ALL);
    c.load_name(2);
    draw(&mut c, GL_QUADS, &ALL);
    assert_eq!(c.render_mode(GL_RENDER), -1);
    assert_eq!(c.selection().len(), 6);
    // Names are ignored where nothing is selected.
    c.push_name(1);
    c.pop_name();
    c.pop_name();
    fine(&mut c);
}
