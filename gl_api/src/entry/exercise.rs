//! Every entry point with random arguments, made from the table: what bounded tests and the fuzz
//! target `table` draw from. An argument is random by its type, and by its name where a size would
//! only cost time.

mod arguments;

pub(crate) use arguments::Exercised;

use crate::base::constants::*;
use crate::context::Context;

/// An entry point that can be called with random arguments.
pub struct Exercise {
    /// GL's name.
    pub name: &'static str,
    #[cfg(test)]
    pub(crate) begin_end: crate::base::begin_end::BeginEnd,
    /// The call.
    pub run: fn(&mut Context, &mut Random<'_>),
}

/// Every row of the table.
pub fn exercises() -> Vec<Exercise> {
    super::table::exercises()
}

/// splitmix64, with a byte of an input mixed into each number as long as there are any.
#[derive(Debug)]
pub struct Random<'a> {
    state: u64,
    bytes: &'a [u8],
}

impl<'a> Random<'a> {
    /// The numbers of a seed, and what an input decides of them.
    pub fn new(seed: u64, bytes: &'a [u8]) -> Self {
        Self { state: seed, bytes }
    }

    /// The next number.
    pub fn number(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        if let Some((first, rest)) = self.bytes.split_first() {
            self.state ^= u64::from(*first);
            self.bytes = rest;
        }
        let z = (self.state ^ self.state >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ z >> 31
    }

    /// A number below a limit.
    pub fn below(&mut self, limit: usize) -> usize {
        (self.number() % limit as u64) as usize
    }

    fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    /// A value of the registry, mostly, or any number.
    fn enumerant(&mut self) -> u32 {
        match self.below(16) {
            0 => self.number() as u32,
            1..4 => self.below(14) as u32,
            4..12 => self.pick(COMMON),
            _ => VALUES[self.below(VALUES.len())].0,
        }
    }

    fn float(&mut self) -> f64 {
        match self.below(4) {
            0 => self.pick(&[
                0.0,
                -0.0,
                1.0,
                -1.0,
                1e30,
                -1e30,
                f64::MAX,
                f64::INFINITY,
                f64::NEG_INFINITY,
                f64::NAN,
                1e-40,
                1e7,
            ]),
            1 => f32::from_bits(self.number() as u32).into(),
            _ => self.below(2001) as f64 / 1000.0 - 1.0,
        }
    }

    fn integer(&mut self, name: &str) -> i64 {
        const LONG: [&str; 14] = [
            "width",
            "height",
            "depth",
            "count",
            "primcount",
            "instances",
            "instancecount",
            "size",
            "range",
            "n",
            "border",
            "imageSize",
            "levels",
            "samples",
        ];
        // What is as long as this says costs as much.
        if LONG.contains(&name) {
            return match self.below(8) {
                0 => self.pick(&[-1, i64::from(i32::MIN), 8193, 33]),
                _ => self.below(17) as i64,
            };
        }
        match self.below(8) {
            0 => self.pick(&[i32::MIN, -1, 255, 8192, i32::MAX]).into(),
            1 => self.number() as i32 as i64,
            2 => self.enumerant().into(),
            _ => self.below(20) as i64,
        }
    }

    fn bytes(&mut self) -> Vec<u8> {
        let length = self.pick(&[0, 1, 3, 4, 16, 64, 1000, 5000]);
        let first = self.number();
        (0..length).map(|at: u64| (first.wrapping_add(at * 37 + at / 5)) as u8).collect()
    }
}

/// Values that many calls take.
const COMMON: &[u32] = &[
    GL_TEXTURE_2D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_CUBE_MAP_POSITIVE_X,
    GL_TEXTURE_1D,
    GL_TEXTURE_3D,
    GL_TEXTURE_2D_ARRAY,
    GL_TEXTURE_CUBE_MAP_ARRAY,
    GL_TEXTURE_2D_MULTISAMPLE,
    GL_TEXTURE_2D_MULTISAMPLE_ARRAY,
    GL_RGB,
    GL_RGBA,
    GL_RGBA8,
    GL_DEPTH_COMPONENT,
    GL_UNSIGNED_BYTE,
    GL_FLOAT,
    GL_UNSIGNED_SHORT,
    GL_UNSIGNED_INT,
    GL_TEXTURE_MIN_FILTER,
    GL_NEAREST,
    GL_LINEAR,
    GL_TEXTURE0,
    GL_TEXTURE1,
    GL_MODELVIEW,
    GL_PROJECTION,
    GL_LIGHTING,
    GL_LIGHT0,
    GL_AMBIENT,
    GL_DIFFUSE,
    GL_FRONT,
    GL_BACK,
    GL_FRONT_AND_BACK,
    GL_COMPILE,
    GL_COMPILE_AND_EXECUTE,
    GL_ARRAY_BUFFER,
    GL_ELEMENT_ARRAY_BUFFER,
    GL_STATIC_DRAW,
    GL_READ_ONLY,
    GL_VERTEX_ARRAY,
    GL_COLOR_ARRAY,
    GL_FRAMEBUFFER,
    GL_RENDERBUFFER,
    GL_COLOR_ATTACHMENT0,
    GL_DEPTH_ATTACHMENT,
    GL_VERTEX_SHADER,
    GL_FRAGMENT_SHADER,
    GL_SAMPLES_PASSED,
    GL_QUERY_WAIT,
    GL_SELECT,
    GL_FEEDBACK,
    GL_RENDER,
    GL_3D_COLOR,
    GL_MAP1_VERTEX_3,
    GL_MAP2_VERTEX_3,
    GL_FILL,
    GL_LINE,
    GL_ACCUM,
    GL_RETURN,
    GL_LESS,
    GL_ALWAYS,
    GL_ONE,
    GL_SRC_ALPHA,
    GL_FUNC_ADD,
    GL_DEPTH_TEST,
    GL_BLEND,
    GL_UNPACK_ALIGNMENT,
];

#[cfg(test)]
mod tests;
