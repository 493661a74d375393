//! Frames in a window: OpenGL 2.1 draws into memory, `softbuffer` shows it in a window of `winit` (both meet in
//! `raw-window-handle`).
//!
//! `cargo run --release --manifest-path clients/Cargo.toml --features window --bin window`; a number ends it after so many
//! frames, with the last one on the screen for a second.

use gl_api::*;
use softbuffer::Surface;
use std::error::Error;
use std::num::NonZeroU32;
use std::rc::Rc;
use std::time::Duration;
use winit::application::ApplicationHandler;
use winit::dpi::{PhysicalPosition, PhysicalSize};
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, OwnedDisplayHandle};
use winit::window::{Window, WindowId};

/// Width and height at the beginning, in pixels.
const SIZE: [u32; 2] = [320, 240];

/// A triangle that is turned by frames, in a context of the window's size.
struct Scene {
    context: Context,
    size: [u32; 2],
    pixels: Vec<u8>,
}

impl Scene {
    fn new(size @ [width, height]: [u32; 2]) -> Result<Self, Box<dyn Error>> {
        let context = Context::new(ContextDesc { width, height, ..ContextDesc::default() })?;
        Ok(Self { context, size, pixels: vec![0; (width * height * 4) as usize] })
    }

    /// Draws a frame; its pixels as `softbuffer` has them, 0RGB, the highest row first.
    fn frame(&mut self, number: u32) -> impl Iterator<Item = u32> {
        let Self { context: c, size, pixels } = self;
        let [width, height] = size.map(|side| side as GLsizei);
        c.clear_color(0.2, 0.3, 0.4, 1.0);
        c.clear(GL_COLOR_BUFFER_BIT);
        c.load_identity();
        c.rotatef(2.0 * number as f32, 0.0, 0.0, 1.0);
        c.begin(GL_TRIANGLES);
        for (color, [x, y]) in [[1.0, 0.2, 0.1], [0.1, 0.9, 0.2], [0.2, 0.3, 1.0]]
            .into_iter()
            .zip([[-0.7, -0.5], [0.7, -0.5], [0.0, 0.8]])
        {
            c.color_3f(color[0], color[1], color[2]);
            c.vertex_2f(x, y);
        }
        c.end();
        let out = DataOut::Bytes(pixels);
        c.read_pixels(0, 0, width, height, GL_BGRA, GL_UNSIGNED_BYTE, out);
        let rows = pixels.chunks_exact(4 * width as usize).rev();
        rows.flat_map(|row| row.chunks_exact(4))
            .map(|bgra| u32::from_le_bytes([bgra[0], bgra[1], bgra[2], 0]))
    }
}

/// What is shown, once there is a window.
struct Shown {
    window: Rc<Window>,
    surface: Surface<OwnedDisplayHandle, Rc<Window>>,
    scene: Scene,
}

impl Shown {
    fn new(
        event_loop: &ActiveEventLoop,
        display: &softbuffer::Context<OwnedDisplayHandle>,
    ) -> Result<Self, Box<dyn Error>> {
        let attributes = Window::default_attributes()
            .with_title("DetGL")
            .with_inner_size(PhysicalSize::<u32>::from(SIZE))
            .with_position(PhysicalPosition::new(0, 0));
        let window = Rc::new(event_loop.create_window(attributes)?);
        let surface = Surface::new(display, window.clone())?;
        Ok(Self { window, surface, scene: Scene::new(SIZE)? })
    }

    /// Draws a frame in the window's present size, and shows it.
    fn show(&mut self, number: u32) -> Result<(), Box<dyn Error>> {
        let size: [u32; 2] = self.window.inner_size().into();
        let [Some(width), Some(height)] = size.map(NonZeroU32::new) else { return Ok(()) };
        if size != self.scene.size {
            self.scene = Scene::new(size)?;
        }
        self.surface.resize(width, height)?;
        let mut buffer = self.surface.buffer_mut()?;
        buffer.iter_mut().zip(self.scene.frame(number)).for_each(|(to, pixel)| *to = pixel);
        buffer.present()?;
        Ok(())
    }
}

struct Application {
    display: softbuffer::Context<OwnedDisplayHandle>,
    shown: Option<Shown>,
    number: u32,
    /// How many frames are drawn.
    end: u32,
    result: Result<(), Box<dyn Error>>,
}

impl ApplicationHandler for Application {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        match Shown::new(event_loop, &self.display) {
            Ok(shown) => {
                shown.window.request_redraw();
                self.shown = Some(shown);
            }
            Err(error) => {
                self.result = Err(error);
                event_loop.exit();
            }
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::RedrawRequested => {
                let Some(shown) = &mut self.shown else { return };
                self.result = shown.show(self.number);
                self.number += 1;
                if self.number == self.end {
                    std::thread::sleep(Duration::from_secs(1));
                }
                if self.number >= self.end || self.result.is_err() {
                    event_loop.exit();
                }
                shown.window.request_redraw();
            }
            _ => {}
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let end = std::env::args().nth(1).map_or(Ok(u32::MAX), |number| number.parse())?;
    let event_loop = EventLoop::new()?;
    event_loop.set_control_flow(ControlFlow::Wait);
    let display = softbuffer::Context::new(event_loop.owned_display_handle())?;
    let mut application = Application { display, shown: None, number: 0, end, result: Ok(()) };
    event_loop.run_app(&mut application)?;
    println!("{} frames", application.number);
    application.result
}
