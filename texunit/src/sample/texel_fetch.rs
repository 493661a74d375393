//! Access by index instead of by filter (GLSL 1.30, section 8.7): `texelFetch` and `textureSize`.

use super::expand;
use crate::lanes::{F32s, I32s, Kernel, LANES, Simd, U32s};
use crate::plan::Texture;

/// One call: 64 texels by their indices. Where there is no such texel or level, all components
/// are 0.
pub(crate) struct Fetch<'a> {
    pub texture: &'a Texture,
    /// Column, row, and slice or layer; a 1D array's layer is the second, cubes have their faces
    /// as layers.
    pub texel: [&'a I32s; 3],
    /// From the base level.
    pub level: &'a I32s,
    /// Added to the indices that are filtered along.
    pub offset: [i32; 3],
    pub out: &'a mut [F32s; 4],
}

impl Kernel for Fetch<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { texture, texel, level: wanted_level, offset, out } = self;
        let axes = texture.shape.axes();
        let mut found = [F32s::ZERO; 4];
        let mut inside = U32s::ZERO;
        for (number, level) in texture.levels[0].iter().enumerate() {
            let mut mask = U32s::ZERO;
            for lane in 0..LANES {
                mask[lane] = if wanted_level[lane] == number as i32 { !0 } else { 0 };
            }
            if !S::any(&mask) {
                continue;
            }
            let mut index = [U32s::ZERO; 3];
            let size = level.size();
            for axis in 0..3 {
                let source = match (texture.is_array(), axes, axis) {
                    (true, 1, 2) => Some(1),
                    (true, 2, 2) => Some(2),
                    _ if axis < axes => Some(axis),
                    _ => None,
                };
                let Some(source) = source else { continue };
                let added = if axis < axes { offset[axis] } else { 0 };
                for lane in 0..LANES {
                    let at = texel[source][lane].wrapping_add(added) as u32;
                    mask[lane] &= if at < size[axis] { !0 } else { 0 };
                    let clamped = if at < size[axis] { at } else { 0 };
                    index[axis][lane] = clamped + level.border[axis];
                }
            }
            let mut values = [F32s::ZERO; 4];
            level.fetch_stored::<S>([&index[0], &index[1], &index[2]], &mut values);
            for (found, values) in found.iter_mut().zip(&values) {
                for lane in 0..LANES {
                    found[lane] = if mask[lane] != 0 { values[lane] } else { found[lane] };
                }
            }
            for lane in 0..LANES {
                inside[lane] |= mask[lane];
            }
        }
        expand::expand(texture.format, texture.depth_mode, &mut found);
        expand::swizzle(texture.format, texture.swizzle, &mut found);
        for (out, found) in out.iter_mut().zip(&found) {
            for lane in 0..LANES {
                out[lane] = if inside[lane] != 0 { found[lane] } else { 0.0 };
            }
        }
    }
}
