//! The fixed function against oracles: the equations of GL 2.1 in plain `f64`, over random states.
//!
//! Each test draws into a window of one pixel. Where the fixed fragment stage gives the colour, it
//! is read as bytes: it may differ from the oracle by half a byte and what `f32` loses (0.51 / 255).
//! Where a program's fragment stage reads what the fixed vertex stage gives, it is read as 24 bits.

#[path = "../common/shading.rs"]
mod shading;

mod combine;
mod determinism;
mod fog;
mod light;
mod matrix;
mod oracle;
mod queries;
mod shaders;
mod texgen;

use gl_api::*;
use glam::{DMat4, DVec4};

/// Half a byte, and what the arithmetic of `f32` loses.
const BYTE: f64 = 0.51 / 255.0;

/// A context with a window of one pixel.
fn context() -> Context {
    let desc = ContextDesc { width: 1, height: 1, ..ContextDesc::default() };
    Context::new(desc).expect("a small window")
}

/// Uniformly distributed numbers from a seed (xorshift).
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    fn word(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 32) as u32
    }

    fn below(&mut self, n: u32) -> u32 {
        self.word() % n
    }

    fn chance(&mut self, percent: u32) -> bool {
        self.below(100) < percent
    }

    /// A number that `f32` has exactly.
    fn between(&mut self, from: f64, to: f64) -> f64 {
        f64::from((from + (to - from) * f64::from(self.word()) / f64::from(u32::MAX)) as f32)
    }

    fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len() as u32) as usize]
    }

    fn color(&mut self) -> [f32; 4] {
        [0; 4].map(|_| self.between(0.0, 1.0) as f32)
    }

    /// A rotation, a scale and a move, with condition below 10.
    fn modelview(&mut self) -> DMat4 {
        let axis = [0; 3].map(|_| self.between(-1.0, 1.0));
        let axis = glam::DVec3::from(axis).try_normalize().unwrap_or(glam::DVec3::X);
        let turn = DMat4::from_axis_angle(axis, self.between(0.0, 6.0));
        let size = [0; 3].map(|_| self.between(0.4, 2.0));
        let place = [self.between(-2.0, 2.0), self.between(-2.0, 2.0), self.between(-8.0, -3.0)];
        let matrix = DMat4::from_translation(place.into()) * turn * DMat4::from_scale(size.into());
        // As GL keeps it.
        DMat4::from_cols_array(&matrix.to_cols_array().map(|x| f64::from(x as f32)))
    }
}

/// Loads a model-view matrix, and a projection that brings object coordinates x and y to the window
/// as they are: what is drawn at x = y = 0 is in the middle of the pixel.
fn transform(c: &mut Context, modelview: DMat4) {
    let flat = DMat4::from_scale(glam::DVec3::new(1.0, 1.0, 0.0)) * modelview.inverse();
    c.matrix_mode(GL_PROJECTION);
    c.load_matrixd(&flat.to_cols_array());
    c.matrix_mode(GL_MODELVIEW);
    c.load_matrixd(&modelview.to_cols_array());
}

/// Draws a point at object coordinates (0, 0, `z`).
fn point(c: &mut Context, z: f64) {
    c.begin(GL_POINTS);
    c.vertex_3d(0.0, 0.0, z);
    c.end();
}

/// Draws a triangle over the pixel whose last vertex is at (0, 4, `z`).
fn triangle(c: &mut Context, z: f64, front: bool) {
    let x = if front { 4.0 } else { -4.0 };
    c.begin(GL_TRIANGLES);
    c.vertex_3d(-x, -4.0, z);
    c.vertex_3d(x, -4.0, z);
    c.vertex_3d(0.0, 4.0, z);
    c.end();
}

/// The pixel.
fn pixel(c: &mut Context) -> [u8; 4] {
    let mut pixel = [0; 4];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    let messages: Vec<String> = c.messages().iter().map(ToString::to_string).collect();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{messages:?}");
    pixel
}

/// The pixel as fractions.
fn color(c: &mut Context) -> [f64; 4] {
    pixel(c).map(|byte| f64::from(byte) / 255.0)
}

/// A program whose fragment stage writes the component of `value`, a `vec4` in [0, 1], that the
/// uniform `mask` selects, in 24 bits.
fn probe(c: &mut Context, value: &str) -> GLint {
    let source = format!(
        "uniform vec4 mask;
void main() {{
    float v = floor(clamp(dot({value}, mask), 0.0, 1.0) * 16777215.0);
    float high = floor(v / 65536.0);
    float rest = v - high * 65536.0;
    float middle = floor(rest / 256.0);
    gl_FragColor = vec4(high, middle, rest - middle * 256.0, 255.0) / 255.0;
}}"
    );
    let program = shading::use_program(c, "", &source);
    c.get_uniform_location(program, "mask")
}

/// What the program of [`probe`] is given, by drawing once for each component.
fn probed(c: &mut Context, mask: GLint, mut draw: impl FnMut(&mut Context)) -> [f64; 4] {
    [0, 1, 2, 3].map(|component| {
        let mut only = [0.0; 4];
        only[component] = 1.0;
        c.uniform_4fv(mask, 1, &only);
        draw(c);
        let [high, middle, low, _] = pixel(c).map(u32::from);
        f64::from(high << 16 | middle << 8 | low) / 16_777_215.0
    })
}

/// Asserts that two vectors agree; `what` tells the state.
fn assert_close(found: [f64; 4], expected: [f64; 4], tolerance: f64, what: &dyn std::fmt::Debug) {
    for i in 0..4 {
        let error = (found[i] - expected[i]).abs();
        assert!(error <= tolerance, "{found:?}, expected {expected:?}, off by {error}: {what:?}");
    }
}

/// The rows of a matrix times a vector.
fn times(matrix: &DMat4, vector: [f64; 4]) -> [f64; 4] {
    (*matrix * DVec4::from(vector)).to_array()
}
