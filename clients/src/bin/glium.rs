//! `glium` on OpenGL 3.3, core profile, without glutin: a cube of six colours, with depth.
//!
//! `cargo run --release --manifest-path clients/Cargo.toml --bin glium -- picture.png`

use gl_api::{Api, Context, ContextDesc};
use glium::backend::{Backend, Facade};
use glium::debug::DebugCallbackBehavior;
use glium::{DrawParameters, Surface, SwapBuffersError, implement_vertex, uniform};
use std::error::Error;
use std::ffi::c_void;
use std::rc::Rc;

/// Width and height in pixels.
const SIZE: (u32, u32) = (256, 192);

/// The context that is current on this thread as long as glium's exists.
struct Current;

// SAFETY: the addresses are those of the functions of these names, and `draw` keeps the context current.
unsafe impl Backend for Current {
    fn swap_buffers(&self) -> Result<(), SwapBuffersError> {
        Ok(())
    }

    unsafe fn get_proc_address(&self, name: &str) -> *const c_void {
        detgl::get_proc_address(name)
    }

    fn get_framebuffer_dimensions(&self) -> (u32, u32) {
        SIZE
    }

    fn resize(&self, _: (u32, u32)) {}

    fn is_current(&self) -> bool {
        true
    }

    unsafe fn make_current(&self) {}
}

/// What glium's objects are made of.
struct Display(Rc<glium::backend::Context>);

impl Facade for Display {
    fn get_context(&self) -> &Rc<glium::backend::Context> {
        &self.0
    }
}

#[derive(Clone, Copy)]
struct Vertex {
    position: [f32; 3],
    color: [f32; 3],
}

implement_vertex!(Vertex, position, color);

/// Two triangles for each face, the face's axis and side as its colour.
fn cube() -> Vec<Vertex> {
    let mut all = Vec::new();
    for axis in 0..3 {
        for side in [-1.0_f32, 1.0] {
            for [u, v] in
                [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            {
                let (mut position, mut color) = ([side; 3], [0.3 + 0.2 * side; 3]);
                (position[(axis + 1) % 3], position[(axis + 2) % 3]) = (u, v);
                color[axis] = 1.0;
                all.push(Vertex { position, color });
            }
        }
    }
    all
}

const VERTEX: &str = "#version 330 core
uniform mat4 turned;
in vec3 position, color;
out vec3 surface;
void main() { surface = color; gl_Position = turned * vec4(0.5 * position, 1.0); }";

const FRAGMENT: &str = "#version 330 core
in vec3 surface;
out vec4 color;
void main() { color = vec4(surface, 1.0); }";

/// Draws the picture: rows of RGBA bytes, the highest first.
fn draw() -> Result<image::RgbaImage, Box<dyn Error>> {
    let (width, height) = SIZE;
    let desc = ContextDesc { api: Api::Core, width, height, ..Default::default() };
    let _current = Context::new(desc)?.make_current();
    // SAFETY: the context of `Current` is current until glium's is dropped.
    let context =
        unsafe { glium::backend::Context::new(Current, false, DebugCallbackBehavior::Ignore) };
    let display = Display(context.map_err(|error| format!("{error:?}"))?);
    let vertices = glium::VertexBuffer::new(&display, &cube())?;
    let indices = glium::index::NoIndices(glium::index::PrimitiveType::TrianglesList);
    let program = glium::Program::from_source(&display, VERTEX, FRAGMENT, None)?;
    // A turn about y and one about x, 3:4:5 and 5:12:13, and the window's proportions.
    let turned = [
        [0.75 * 0.8, 0.6 * 5.0 / 13.0, 0.6 * 12.0 / 13.0, 0.0],
        [0.0, 12.0 / 13.0, -5.0 / 13.0, 0.0],
        [0.75 * -0.6, 0.8 * 5.0 / 13.0, 0.8 * 12.0 / 13.0, 0.0],
        [0.0, 0.0, 0.0, 1.0_f32],
    ];
    let parameters = DrawParameters {
        depth: glium::Depth { test: glium::DepthTest::IfLess, write: true, ..Default::default() },
        ..Default::default()
    };
    let mut frame = glium::Frame::new(display.0.clone(), SIZE);
    frame.clear_color_and_depth((0.93, 0.95, 0.98, 1.0), 1.0);
    frame.draw(&vertices, indices, &program, &uniform! { turned: turned }, &parameters)?;
    frame.finish()?;
    let picture: glium::texture::RawImage2d<u8> = display.0.read_front_buffer()?;
    detgl_clients::picture([width, height], picture.data.into_owned())
}

fn main() -> Result<(), Box<dyn Error>> {
    detgl_clients::save(&draw()?, "glium.png")
}

#[cfg(test)]
mod tests {
    #[test]
    fn it_draws_the_same_bits_as_ever() {
        let golden = image::load_from_memory(include_bytes!("../../glium.png"));
        let picture = super::draw().expect("glium draws");
        assert!(picture == golden.expect("a picture").into_rgba8());
    }
}
