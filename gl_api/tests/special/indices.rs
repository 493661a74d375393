//! Colour indices: state without effect on a window of colours, and pixels that become colours.

use super::{ALL, context, draw, fine, pixel};
use gl_api::*;

#[test]
fn the_current_index_is_kept_and_changes_no_picture() {
    let mut c = context(4, 4);
    c.indexf(7.5);
    c.index_mask(3);
    c.clear_index(9.0);
    let mut values = [0.0; 3];
    for (value, name) in
        values.iter_mut().zip([GL_CURRENT_INDEX, GL_INDEX_WRITEMASK, GL_INDEX_CLEAR_VALUE])
    {
        c.get_floatv(name, std::slice::from_mut(value));
    }
    assert_eq!(values, [7.5, 3.0, 9.0]);
    c.index_pointer(GL_SHORT, 6, Data::Bytes(&[1, 0, 2, 0, 3, 0, 4, 0]));
    c.enable_client_state(GL_INDEX_ARRAY);
    c.array_element(1);
    c.get_floatv(GL_CURRENT_INDEX, &mut values[..1]);
    assert_eq!(values[0], 4.0);
    draw(&mut c, GL_QUADS, &ALL);
    assert_eq!(pixel(&mut c, 0, 0), [255; 4]);
    fine(&mut c);
}

#[test]
fn indices_are_looked_up_shifted_and_offset() {
    let mut c = context(4, 4);
    let tables = [
        (GL_PIXEL_MAP_I_TO_R, [0.0, 1.0, 0.0, 0.0]),
        (GL_PIXEL_MAP_I_TO_G, [0.0, 0.0, 1.0, 0.0]),
        (GL_PIXEL_MAP_I_TO_B, [0.0, 0.0, 0.0, 1.0]),
        (GL_PIXEL_MAP_I_TO_A, [1.0_f32; 4]),
    ];
    for (map, values) in tables {
        c.pixel_mapfv(map, 4, (&values).arg());
    }
    c.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    c.window_pos_2i(0, 0);
    c.draw_pixels(4, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, Data::Bytes(&[0, 1, 2, 7]));
    let row = |c: &mut Context, y| [0, 1, 2, 3].map(|x| pixel(c, x, y));
    let colors = [[0, 0, 0, 255], [255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255]];
    assert_eq!(row(&mut c, 0), colors, "7 has the lowest bits of 3");
    // A bitmap's bits, and lists.
    c.new_list(1, GL_COMPILE);
    c.window_pos_2i(0, 1);
    c.draw_pixels(4, 1, GL_COLOR_INDEX, GL_BITMAP, Data::Bytes(&[0b0101_0000]));
    c.end_list();
    c.call_list(1);
    assert_eq!(row(&mut c, 1), [colors[0], colors[1], colors[0], colors[1]]);
    c.pixel_transferi(GL_INDEX_SHIFT, 1);
    c.pixel_transferi(GL_INDEX_OFFSET, 1);
    c.window_pos_2i(0, 2);
    c.draw_pixels(2, 1, GL_COLOR_INDEX, GL_FLOAT, (&[0.0_f32, 1.0]).arg());
    assert_eq!(row(&mut c, 2)[..2], [colors[1], colors[3]]);
    // Textures.
    c.pixel_transferi(GL_INDEX_SHIFT, 0);
    c.pixel_transferi(GL_INDEX_OFFSET, 0);
    let (index, byte) = (GL_COLOR_INDEX, GL_UNSIGNED_BYTE);
    c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 2, 1, 0, index, byte, Data::Bytes(&[1, 2]));
    c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 1, 0, 1, 1, index, byte, Data::Bytes(&[3]));
    let mut texels = [[0; 4]; 2];
    let out = DataOut::Bytes(texels.as_flattened_mut());
    c.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, out);
    assert_eq!(texels, [colors[1], colors[3]]);
    fine(&mut c);
}
