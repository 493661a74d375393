//! One level of a texture, with the arguments that all its texels share.

use super::wrap::{Axis, Indices};
use crate::image::{FACES, Level, Shape};
use crate::lanes::{F32s, LANES, U32s};
use crate::plan::Texture;
use crate::sampler::Filter;

/// A level, and the arguments that all its texels share.
#[derive(Clone, Copy)]
pub struct LevelView<'a> {
    pub texture: &'a Texture,
    pub filter: Filter,
    pub face: usize,
    /// The level's number, from the base level.
    pub number: usize,
    pub level: &'a Level,
    /// The layer of each lane (of an array of cubes: which cube); 0 where there are none.
    pub layer: &'a U32s,
    /// The reference of a depth compare.
    pub reference: &'a F32s,
}

impl LevelView<'_> {
    #[inline(always)]
    pub fn axis(&self, axis: usize) -> Axis {
        let size = [self.level.width, self.level.height, self.level.depth][axis];
        let scale = self.texture.shape.scale(size);
        Axis { wrap: self.texture.wrap[axis], size, border: self.level.border[axis], scale }
    }

    /// The slice that each lane reads where r is not filtered along.
    #[inline(always)]
    pub fn slice(&self) -> Indices {
        let mut slice = Indices { index: *self.layer, outside: U32s::ZERO };
        if self.texture.shape == Shape::CubeArray {
            for lane in 0..LANES {
                slice.index[lane] = slice.index[lane] * FACES as u32 + self.face as u32;
            }
        }
        slice
    }
}
