//! The size of each lane's level, and where its texels are.

use crate::image::{FACES, Shape};
use crate::lanes::math::clamp;
use crate::lanes::{F32s, LANES, Simd, U32s};
use crate::plan::Texture;
use crate::sample::wrap::{mirrored_repeat, repeated};
use crate::sampler::Wrap;

/// A level of each lane, of an image of two axes without border.
pub struct LaneLevel<'a> {
    /// The face of each lane.
    pub face: &'a U32s,
    /// The number of the level's first face in [`Sources`](crate::lanes::Sources).
    first_source: U32s,
    /// The layer of each lane; of an array of cubes, which cube.
    layer: &'a U32s,
    /// Width and height.
    pub size: [U32s; 2],
    /// Bytes of a texel.
    bytes: u32,
    shape: Shape,
}

impl<'a> LaneLevel<'a> {
    #[inline(always)]
    pub fn new(texture: &Texture, level: &U32s, face: &'a U32s, layer: &'a U32s) -> Self {
        let mut out = Self {
            face,
            first_source: U32s::ZERO,
            layer,
            size: [U32s::ZERO; 2],
            bytes: texture.format.bytes() as u32,
            shape: texture.shape,
        };
        let [width, height, _] = texture.size;
        let [widths, heights] = &mut out.size;
        for lane in 0..LANES {
            let level = level[lane];
            let halved = [width >> (level & 31), height >> (level & 31)];
            widths[lane] = if halved[0] > 1 { halved[0] } else { 1 };
            heights[lane] = if halved[1] > 1 { halved[1] } else { 1 };
            out.first_source[lane] = level * FACES as u32;
        }
        out
    }

    /// Texels along an axis as a number.
    #[inline(always)]
    fn length(&self, axis: usize) -> F32s {
        let mut out = F32s::ZERO;
        for lane in 0..LANES {
            out[lane] = self.size[axis][lane] as i32 as f32;
        }
        out
    }

    /// The wrapped coordinate in texels, as [`Axis::texel_coordinate`](crate::sample::wrap::Axis::texel_coordinate) has
    /// it.
    #[inline(always)]
    pub fn texel_coordinate<S: Simd>(&self, wrap: Wrap, axis: usize, s: &F32s) -> F32s {
        let length = self.length(axis);
        let mut u = F32s::ZERO;
        match wrap {
            Wrap::Repeat => {
                for lane in 0..LANES {
                    u[lane] = repeated::<S>(s[lane], length[lane]);
                }
            }
            Wrap::MirroredRepeat => {
                for lane in 0..LANES {
                    let (mirrored, _) = mirrored_repeat::<S>(s[lane]);
                    u[lane] = clamp(mirrored * length[lane], 0.5, length[lane] - 0.5);
                }
            }
            Wrap::ClampToEdge => {
                for lane in 0..LANES {
                    u[lane] = clamp(s[lane] * length[lane], 0.5, length[lane] - 0.5);
                }
            }
            // Of seamless cubes, and of nearest filters. Textures with the modes after it have the general kernel.
            Wrap::Clamp
            | Wrap::ClampToBorder
            | Wrap::MirrorClamp
            | Wrap::MirrorClampToEdge
            | Wrap::MirrorClampToBorder => {
                for lane in 0..LANES {
                    u[lane] = clamp(s[lane] * length[lane], 0.0, length[lane]);
                }
            }
        }
        u
    }

    /// The number of each lane's source, on these faces.
    #[inline(always)]
    pub fn sources(&self, face: &U32s) -> U32s {
        let mut out = self.first_source;
        if self.shape == Shape::Cube {
            for lane in 0..LANES {
                out[lane] += face[lane];
            }
        }
        out
    }

    /// Bytes of a row.
    #[inline(always)]
    pub fn row(&self) -> U32s {
        let mut out = U32s::ZERO;
        for lane in 0..LANES {
            out[lane] = self.size[0][lane].wrapping_mul(self.bytes);
        }
        out
    }

    /// The byte offset of texel (0, 0) on these faces.
    #[inline(always)]
    pub fn start(&self, face: &U32s) -> U32s {
        let mut out = U32s::ZERO;
        if self.shape == Shape::Cube {
            return out;
        }
        let [width, height] = &self.size;
        for lane in 0..LANES {
            let slice = width[lane].wrapping_mul(height[lane]).wrapping_mul(self.bytes);
            let number = if self.shape == Shape::CubeArray {
                self.layer[lane].wrapping_mul(FACES as u32).wrapping_add(face[lane])
            } else {
                self.layer[lane]
            };
            out[lane] = number.wrapping_mul(slice);
        }
        out
    }

    /// The byte offset of texel (x, y) on these faces.
    #[inline(always)]
    pub fn offsets(&self, face: &U32s, [x, y]: [&U32s; 2]) -> U32s {
        let (mut out, row) = (self.start(face), self.row());
        for lane in 0..LANES {
            let line = y[lane].wrapping_mul(row[lane]);
            out[lane] = out[lane].wrapping_add(x[lane].wrapping_mul(self.bytes).wrapping_add(line));
        }
        out
    }
}
