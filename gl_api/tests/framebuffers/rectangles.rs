//! `glDrawPixels`, `glCopyPixels`, `glBitmap` and the raster position.

use super::{ALL, bytes, context, fine, floats, rectangle};
use gl_api::*;

/// Draws 3 × 2 pixels of RGB, each with its number as red.
fn draw(c: &mut Context) {
    c.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    let pixels: Vec<u8> = (1..=6).flat_map(|i| [i * 10, 7, 9]).collect();
    c.draw_pixels(3, 2, GL_RGB, GL_UNSIGNED_BYTE, Data::Bytes(&pixels));
    fine(c);
}

fn red(c: &mut Context) -> Vec<u8> {
    bytes(c, [0, 0, 8, 4], GL_RED, 1)
}

#[test]
fn pixels_are_drawn_where_the_raster_position_is_with_every_zoom() {
    for (position, zoom, want) in [
        (
            [1.0, 1.0],
            [1.0, 1.0],
            [[0; 8], [0, 10, 20, 30, 0, 0, 0, 0], [0, 40, 50, 60, 0, 0, 0, 0], [0; 8]],
        ),
        (
            [1.0, 0.0],
            [2.0, 1.0],
            [[0, 10, 10, 20, 20, 30, 30, 0], [0, 40, 40, 50, 50, 60, 60, 0], [0; 8], [0; 8]],
        ),
        (
            [4.0, 4.0],
            [-1.0, -2.0],
            [
                [0, 60, 50, 40, 0, 0, 0, 0],
                [0, 60, 50, 40, 0, 0, 0, 0],
                [0, 30, 20, 10, 0, 0, 0, 0],
                [0, 30, 20, 10, 0, 0, 0, 0],
            ],
        ),
        // Beyond the window on the left.
        ([-2.0, 3.0], [1.0, 1.0], [[0; 8], [0; 8], [0; 8], [30, 0, 0, 0, 0, 0, 0, 0]]),
    ] {
        let mut c = context(8, 4);
        c.window_pos_2d(position[0], position[1]);
        c.pixel_zoom(zoom[0], zoom[1]);
        draw(&mut c);
        assert_eq!(red(&mut c), want.concat(), "{position:?} {zoom:?}");
    }
}

#[test]
fn pixels_are_fragments_like_any_others() {
    let mut c = context(8, 4);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    // Scissored, blended, and behind what is there on the right.
    c.enable(GL_DEPTH_TEST);
    rectangle(&mut c, [0.0, -1.0, 1.0, 1.0], -0.5);
    c.enable(GL_SCISSOR_TEST);
    c.scissor(0, 0, 8, 1);
    c.enable(GL_BLEND);
    c.blend_func(GL_ONE, GL_ONE);
    c.window_pos_3d(2.0, 0.0, 0.5);
    draw(&mut c);
    draw(&mut c);
    c.disable(GL_SCISSOR_TEST);
    // The second time the depth is equal, which is not less.
    let mut want = [[0, 0, 0, 0, 255, 255, 255, 255]; 4];
    want[0][2..4].copy_from_slice(&[10, 20]);
    assert_eq!(red(&mut c), want.concat());
}

#[test]
fn depths_and_stencils_are_drawn_too() {
    let mut c = context(8, 4);
    c.clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    c.enable(GL_DEPTH_TEST);
    c.window_pos_2i(1, 1);
    let depths: Vec<u8> = [0.25_f32, 0.5].iter().flat_map(|d| d.to_ne_bytes()).collect();
    c.draw_pixels(2, 1, GL_DEPTH_COMPONENT, GL_FLOAT, Data::Bytes(&depths));
    let got = floats(&mut c, [0, 1, 4, 1], GL_DEPTH_COMPONENT, 1);
    for (got, want) in got.into_iter().zip([1.0, 0.25, 0.5, 1.0]) {
        assert!((got - want).abs() < 1e-6, "{got}, not {want}");
    }
    c.stencil_mask(0x0F);
    c.draw_pixels(2, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, Data::Bytes(&[0x12, 0x34]));
    assert_eq!(bytes(&mut c, [0, 1, 4, 1], GL_STENCIL_INDEX, 1), [0, 2, 4, 0]);
    c.stencil_mask(0xFF);
    // Of wider indices the bits count that the buffer has.
    let wide: Vec<u8> = [0x1234_u16, 0xFF56].iter().flat_map(|s| s.to_ne_bytes()).collect();
    c.draw_pixels(2, 1, GL_STENCIL_INDEX, GL_UNSIGNED_SHORT, Data::Bytes(&wide));
    assert_eq!(bytes(&mut c, [0, 1, 4, 1], GL_STENCIL_INDEX, 1), [0, 0x34, 0x56, 0]);
    let both = (0x80_0000_u32 << 8 | 0x77).to_ne_bytes();
    c.window_pos_2i(5, 2);
    c.draw_pixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, Data::Bytes(&both));
    assert_eq!(bytes(&mut c, [5, 2, 1, 1], GL_STENCIL_INDEX, 1), [0x77]);
    let depth = floats(&mut c, [5, 2, 1, 1], GL_DEPTH_COMPONENT, 1)[0];
    assert!((depth - 0.5).abs() < 1e-6, "{depth}");
}

#[test]
fn what_was_drawn_is_copied() {
    let mut c = context(8, 4);
    c.window_pos_2i(0, 0);
    draw(&mut c);
    c.window_pos_2i(4, 1);
    c.copy_pixels(0, 0, 3, 2, GL_COLOR);
    fine(&mut c);
    let want = [
        [10, 20, 30, 0, 0, 0, 0, 0],
        [40, 50, 60, 0, 10, 20, 30, 0],
        [0, 0, 0, 0, 40, 50, 60, 0],
        [0; 8],
    ];
    assert_eq!(red(&mut c), want.concat());
}

#[test]
fn a_bitmap_draws_its_bits_and_moves_on() {
    let mut c = context(8, 4);
    c.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    c.color_3f(1.0, 0.0, 0.0);
    c.matrix_mode(GL_PROJECTION);
    c.ortho(0.0, 8.0, 0.0, 4.0, -1.0, 1.0);
    c.raster_pos_2i(2, 1);
    // The colour is that of when the position was set.
    c.color_3f(0.0, 1.0, 0.0);
    c.bitmap(3, 2, 1.0, 0.0, 4.0, 0.0, Data::Bytes(&[0b1010_0000, 0b0100_0000]));
    c.bitmap(1, 1, 0.0, 0.0, 0.0, 1.0, Data::Bytes(&[0xFF]));
    fine(&mut c);
    let want = [[0; 8], [0, 255, 0, 255, 0, 0, 255, 0], [0, 0, 255, 0, 0, 0, 0, 0], [0; 8]];
    assert_eq!(red(&mut c), want.concat());
    let mut position = [0.0; 4];
    c.get_floatv(GL_CURRENT_RASTER_POSITION, &mut position);
    assert_eq!(position, [6.0, 2.0, 0.5, 1.0]);
}

#[test]
fn a_position_outside_the_view_volume_is_not_valid() {
    let mut c = context(8, 4);
    c.raster_pos_2f(1.5, 0.0);
    let mut valid = [9];
    c.get_integerv(GL_CURRENT_RASTER_POSITION_VALID, &mut valid);
    assert_eq!(valid, [0]);
    draw(&mut c);
    c.bitmap(1, 1, 0.0, 0.0, 1.0, 1.0, Data::Bytes(&[0xFF]));
    assert_eq!(red(&mut c), [0; 32]);
    c.raster_pos_4d(0.0, 0.0, 0.0, 2.0);
    c.get_integerv(GL_CURRENT_RASTER_POSITION_VALID, &mut valid);
    assert_eq!(valid, [1]);
    c.color_3f(1.0, 1.0, 1.0);
    rectangle(&mut c, ALL, 0.0);
    fine(&mut c);
}

#[test]
fn a_raster_position_of_the_window_may_have_a_w() {
    let mut c = context(4, 4);
    c.depth_range(0.5, 1.0);
    let position = |c: &mut Context| {
        let mut found = [0.0; 4];
        c.get_doublev(GL_CURRENT_RASTER_POSITION, &mut found);
        found
    };
    c.window_pos_4i(3, -2, 0, 7);
    assert_eq!(position(&mut c), [3.0, -2.0, 0.5, 7.0]);
    c.window_pos_4dv(&[1.5, 2.5, 0.5, -0.25]);
    assert_eq!(position(&mut c), [1.5, 2.5, 0.75, -0.25]);
    c.window_pos_3s(1, 2, 1);
    assert_eq!(position(&mut c), [1.0, 2.0, 1.0, 1.0]);
    fine(&mut c);
}
