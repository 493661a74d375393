//! A drawing by `speedy2d`: shapes and a picture, with GLSL 1.10 and vertex buffers.

use speedy2d::GLRenderer;
use speedy2d::color::Color;
use speedy2d::dimen::Vec2;
use speedy2d::image::{ImageDataType, ImageSmoothingMode};
use speedy2d::shape::Rectangle;

/// 8×8 RGB texels that are all different.
fn texels() -> Vec<u8> {
    let texel =
        |at: u8| [at * 4, 255 - at * 4, if (at + at / 8).is_multiple_of(2) { 220 } else { 40 }];
    (0..64).flat_map(texel).collect()
}

/// Draws over the whole picture.
pub fn draw([width, height]: [u32; 2]) -> Result<(), Box<dyn std::error::Error>> {
    // SAFETY: the addresses are those of the functions of these names, and the context that they
    // work on is current until after the renderer is dropped.
    let renderer =
        unsafe { GLRenderer::new_for_gl_context((width, height), detgl::get_proc_address) };
    let mut renderer = renderer.map_err(|error| format!("{error:?}"))?;
    let image = renderer.create_image_from_raw_pixels(
        ImageDataType::RGB,
        ImageSmoothingMode::Linear,
        (8, 8).into(),
        &texels(),
    );
    let image = image.map_err(|error| format!("{error:?}"))?;
    renderer.draw_frame(|graphics| {
        graphics.clear_screen(Color::from_rgb(0.93, 0.95, 0.98));
        graphics.draw_circle((110.0, 110.0), 80.0, Color::from_rgb(0.9, 0.35, 0.2));
        graphics.draw_circle((170.0, 150.0), 60.0, Color::from_rgba(0.1, 0.4, 0.9, 0.6));
        graphics.draw_line((20.0, 300.0), (460.0, 200.0), 5.0, Color::from_rgb(0.1, 0.1, 0.2));
        graphics.draw_triangle_three_color(
            [Vec2::new(60.0, 300.0), Vec2::new(120.0, 210.0), Vec2::new(200.0, 290.0)],
            [Color::RED, Color::GREEN, Color::BLUE],
        );
        let place = Rectangle::new(Vec2::new(220.0, 20.0), Vec2::new(340.0, 140.0));
        graphics.draw_rectangle_image(place, &image);
    });
    Ok(())
}
