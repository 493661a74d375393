//! `femtovg` (OpenGL ES 3.0): paths by the stencil buffer, gradients, a pattern with mipmaps, a layer in a framebuffer of
//! its own, scissors.
//!
//! `cargo run --release --manifest-path clients/Cargo.toml --bin femtovg -- picture.png`

use femtovg::{
    Canvas, Color, CompositeOperation, ImageFlags, ImageSource, LineCap, LineJoin, Paint, Path,
    PixelFormat, RenderTarget, renderer::OpenGl,
};
use gl_api::{Api, Context, ContextDesc};
use std::error::Error;

/// Width and height in pixels.
const SIZE: [u32; 2] = [320, 240];

/// Draws the picture: rows of RGBA bytes, the highest first.
fn draw() -> Result<image::RgbaImage, Box<dyn Error>> {
    let [width, height] = SIZE;
    let desc = ContextDesc { api: Api::Es2, width, height, ..Default::default() };
    let _current = Context::new(desc)?.make_current();
    // SAFETY: the addresses are those of the functions of these names, on the current context.
    let renderer = unsafe { OpenGl::new_from_function(detgl::get_proc_address)? };
    let mut canvas = Canvas::new(renderer)?;
    canvas.set_size(width, height, 1.0);
    canvas.clear_rect(0, 0, width, height, Color::rgb(50, 70, 100));

    let mut star = Path::new();
    for at in 0..5 {
        let (y, x) = (at as f32 * 2.513_274).sin_cos();
        let (x, y) = (80.0 + 60.0 * x, 75.0 + 60.0 * y);
        if at == 0 { star.move_to(x, y) } else { star.line_to(x, y) }
    }
    star.close();
    let stops = [
        (0.0, Color::rgb(255, 240, 90)),
        (0.6, Color::rgb(240, 80, 40)),
        (1.0, Color::rgb(90, 20, 120)),
    ];
    let fill = Paint::radial_gradient_stops(80.0, 75.0, 5.0, 60.0, stops)
        .with_fill_rule(femtovg::FillRule::EvenOdd);
    canvas.fill_path(&star, &fill);

    let mut curve = Path::new();
    curve.move_to(20.0, 200.0);
    curve.bezier_to(90.0, 90.0, 160.0, 300.0, 300.0, 150.0);
    for (line, color) in
        [(14.0, Color::rgbaf(0.0, 0.0, 0.0, 0.5)), (6.0, Color::rgb(120, 230, 160))]
    {
        let paint = Paint::color(color)
            .with_line_width(line)
            .with_line_cap(LineCap::Round)
            .with_line_join(LineJoin::Round);
        canvas.stroke_path(&curve, &paint);
    }

    let texels: Vec<femtovg::rgb::RGBA8> = (0..=255_u8)
        .map(|at| femtovg::rgb::RGBA8::new(at, 255 - at, (at % 16) * 16, 255))
        .collect();
    let image = femtovg::imgref::Img::new(&texels[..], 16, 16);
    let image = canvas.create_image(
        ImageSource::from(image),
        ImageFlags::REPEAT_X | ImageFlags::REPEAT_Y | ImageFlags::GENERATE_MIPMAPS,
    )?;
    canvas.save();
    canvas.translate(230.0, 70.0);
    canvas.rotate(0.4);
    let mut card = Path::new();
    card.rounded_rect(-60.0, -45.0, 120.0, 90.0, 18.0);
    canvas.fill_path(&card, &Paint::image(image, -60.0, -45.0, 40.0, 30.0, 0.3, 0.9));
    let shadow = Paint::box_gradient(
        -60.0,
        -45.0,
        120.0,
        90.0,
        18.0,
        16.0,
        Color::rgba(0, 0, 0, 0),
        Color::rgba(255, 255, 255, 200),
    );
    canvas.fill_path(&card, &shadow);
    canvas.restore();

    let layer = canvas.create_image_empty(
        96,
        96,
        PixelFormat::Rgba8,
        ImageFlags::FLIP_Y | ImageFlags::PREMULTIPLIED,
    )?;
    canvas.set_render_target(RenderTarget::Image(layer));
    canvas.clear_rect(0, 0, 96, 96, Color::rgbaf(0.0, 0.0, 0.0, 0.0));
    let mut disc = Path::new();
    disc.circle(48.0, 48.0, 40.0);
    canvas.fill_path(
        &disc,
        &Paint::linear_gradient(
            0.0,
            0.0,
            96.0,
            96.0,
            Color::rgb(90, 160, 255),
            Color::rgb(255, 90, 200),
        ),
    );
    canvas.global_composite_operation(CompositeOperation::DestinationOut);
    let mut hole = Path::new();
    hole.rect(36.0, 20.0, 24.0, 56.0);
    canvas.fill_path(&hole, &Paint::color(Color::rgbaf(0.0, 0.0, 0.0, 0.8)));
    canvas.global_composite_operation(CompositeOperation::SourceOver);
    canvas.set_render_target(RenderTarget::Screen);
    let mut area = Path::new();
    area.rect(190.0, 140.0, 96.0, 96.0);
    canvas.scissor(195.0, 140.0, 80.0, 90.0);
    canvas.fill_path(&area, &Paint::image(layer, 190.0, 140.0, 96.0, 96.0, 0.0, 1.0));
    canvas.reset_scissor();
    canvas.flush();
    let picture = canvas.screenshot()?;
    let texels: Vec<_> = picture.pixels().flat_map(|texel| <[u8; 4]>::from(texel)).collect();
    Ok(image::RgbaImage::from_raw(width, height, texels).ok_or("as many as needed")?)
}

fn main() -> Result<(), Box<dyn Error>> {
    detgl_clients::save(&draw()?, "femtovg.png")
}

#[cfg(test)]
mod tests {
    #[test]
    fn it_draws_the_same_bits_as_ever() {
        let golden = image::load_from_memory(include_bytes!("../../femtovg.png"));
        let picture = super::draw().expect("femtovg draws");
        assert!(picture == golden.expect("a picture").into_rgba8());
    }
}
