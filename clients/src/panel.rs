//! A window with text and controls by `egui`, drawn by `egui_glow`'s painter.

use egui::{Pos2, RawInput, Rect, Vec2};
use egui_glow::{Painter, glow};
use std::sync::Arc;

/// Draws over the picture.
pub fn draw(size: [u32; 2]) -> Result<(), Box<dyn std::error::Error>> {
    let screen = Rect::from_min_size(Pos2::ZERO, Vec2::new(size[0] as f32, size[1] as f32));
    let ui = egui::Context::default();
    let (mut on, mut amount) = (true, 0.62);
    let mut textures = egui::TexturesDelta::default();
    let mut shapes = Vec::new();
    // The first frame finds out how large the window is.
    for frame in 0..3 {
        let time = Some(f64::from(frame));
        let input = RawInput { screen_rect: Some(screen), time, ..RawInput::default() };
        let output = ui.run_ui(input, |ui| {
            let window = egui::Window::new("DetGL").fixed_pos([225.0, 95.0]);
            window.fixed_size([225.0, 120.0]).show(ui.ctx(), |ui| {
                ui.label("egui over speedy2d");
                ui.checkbox(&mut on, "the same bits everywhere");
                ui.add(egui::Slider::new(&mut amount, 0.0..=1.0).text("amount"));
                ui.add(egui::ProgressBar::new(amount).show_percentage());
            });
        });
        textures.append(output.textures_delta);
        shapes = ui.tessellate(output.shapes, 1.0);
    }
    // SAFETY: the addresses are those of the functions of these names, and the context that they
    // work on is current until after the painter is destroyed.
    let gl = unsafe { glow::Context::from_loader_function(detgl::get_proc_address) };
    let mut painter = Painter::new(Arc::new(gl), "", None, false)?;
    painter.paint_and_update_textures(size, 1.0, &shapes, &mut textures);
    painter.destroy();
    Ok(())
}
