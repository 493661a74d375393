//! Textures of every shape but cubes: 1D, 2D, 3D, rectangles and arrays, with borders, offsets and
//! single texels (sections 3.8.1, 3.8.7 and 3.8.8; ARB_texture_rectangle, EXT_texture_array,
//! EXT_gpu_shader4; GLSL 1.30, section 8.7).

use super::lod::Filter;
use super::mipmap::Volume;
use super::wrap::{self, Wrap};
use crate::mutation::{Mutation, Variant};

/// A shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum Target {
    D1,
    D2,
    D3,
    Rect,
    D1Array,
    D2Array,
}

impl Target {
    /// All.
    pub const ALL: [Self; 6] =
        [Self::D1, Self::D2, Self::D3, Self::Rect, Self::D1Array, Self::D2Array];

    /// Coordinates that are filtered along.
    pub fn axes(self) -> usize {
        match self {
            Self::D1 | Self::D1Array => 1,
            Self::D2 | Self::Rect | Self::D2Array => 2,
            Self::D3 => 3,
        }
    }

    /// Whether the next coordinate is a layer.
    pub fn has_layers(self) -> bool {
        match self {
            Self::D1Array | Self::D2Array => true,
            Self::D1 | Self::D2 | Self::D3 | Self::Rect => false,
        }
    }
}

/// A texture of one level.
#[derive(Clone, Debug)]
pub struct Texture {
    /// The target.
    pub target: Target,
    /// Width, height, depth without the border; layers after the filtered axes.
    pub size: [usize; 3],
    /// Border texels at either end of a filtered axis, 0 or 1.
    pub border: usize,
    /// The stored texels, the border's too.
    pub texels: Volume,
    /// Wrap of s, t, r.
    pub wrap: [Wrap; 3],
    /// `GL_TEXTURE_BORDER_COLOR`.
    pub border_color: [f64; 4],
    /// The filter within the level.
    pub filter: Filter,
}

/// Texels along an axis, counted without the border, and their weights.
type Taps = Vec<(i64, f64)>;

impl Texture {
    /// The stored texel, or the border colour where there is none.
    fn stored(&self, at: [i64; 3], variant: Variant) -> [f64; 4] {
        let border =
            if variant.has(Mutation::BorderTexelsIgnored) { 0 } else { self.border as i64 };
        let mut place = [0; 3];
        for axis in 0..3 {
            let filtered = axis < self.target.axes();
            let b = if filtered { border } else { 0 };
            if at[axis] < -b || at[axis] >= self.size[axis] as i64 + b {
                return self.border_color;
            }
            let skipped = if filtered { self.border as i64 } else { 0 };
            place[axis] = (at[axis] + skipped) as usize;
        }
        let [w, h, _] = self.texels.size;
        self.texels.texels[(place[2] * h + place[1]) * w + place[0]]
    }

    /// The texels along an axis. An offset is one of the coordinate in texels (GL 3.0, section
    /// 3.9.7), before it wraps.
    fn taps(&self, axis: usize, coordinate: f64, offset: i64, variant: Variant) -> Taps {
        let n = self.size[axis];
        let scaled = match self.target {
            Target::Rect if !variant.has(Mutation::RectNormalized) => coordinate / n as f64,
            Target::Rect | Target::D1 | Target::D2 | Target::D3 => coordinate,
            Target::D1Array | Target::D2Array => coordinate,
        };
        let offset = if variant.has(Mutation::OffsetIgnored) { 0 } else { offset };
        let wrap = self.wrap[axis];
        let u = wrap::coordinate(wrap, scaled + offset as f64 / n as f64, n, variant);
        let index = |i: f64| match wrap {
            Wrap::Repeat => i.rem_euclid(n as f64) as i64,
            Wrap::Clamp
            | Wrap::ClampToEdge
            | Wrap::ClampToBorder
            | Wrap::MirroredRepeat
            | Wrap::MirrorClamp
            | Wrap::MirrorClampToEdge
            | Wrap::MirrorClampToBorder => i as i64,
        };
        match self.filter {
            Filter::Nearest => {
                let past = matches!(wrap, Wrap::ClampToBorder | Wrap::MirrorClampToBorder);
                let last = if past { f64::INFINITY } else { n as f64 - 1.0 };
                vec![(index(u.floor().min(last)), 1.0)]
            }
            Filter::Linear => {
                let i = (u - 0.5).floor();
                let alpha = u - 0.5 - i;
                vec![(index(i), 1.0 - alpha), (index(i + 1.0), alpha)]
            }
        }
    }

    /// The filtered colour at (s, t, r), in whatever units the target has them.
    pub fn sample(&self, coordinates: [f64; 3], offset: [i64; 3], variant: Variant) -> [f64; 4] {
        let axes = self.target.axes();
        let taps = |axis: usize| -> Taps {
            if axis < axes {
                self.taps(axis, coordinates[axis], offset[axis], variant)
            } else if axis == axes && self.target.has_layers() {
                vec![(self.layer(coordinates[axis], variant), 1.0)]
            } else {
                vec![(0, 1.0)]
            }
        };
        let (columns, rows, slices) = (taps(0), taps(1), taps(2));
        let mut sum = [0.0; 4];
        for &(k, wk) in &slices {
            for &(j, wj) in &rows {
                for &(i, wi) in &columns {
                    for (sum, c) in sum.iter_mut().zip(self.stored([i, j, k], variant)) {
                        *sum += wi * wj * wk * c;
                    }
                }
            }
        }
        sum
    }

    fn layer(&self, coordinate: f64, variant: Variant) -> i64 {
        layer(coordinate, self.size[self.target.axes()], variant) as i64
    }

    /// One texel; 0 where there is none, as DetGL defines it.
    pub fn fetch(&self, at: [i64; 3], offset: [i64; 3], variant: Variant) -> [f64; 4] {
        let offset = if variant.has(Mutation::OffsetIgnored) { [0; 3] } else { offset };
        let at = [0, 1, 2].map(|axis| at[axis] + offset[axis]);
        if (0..3).any(|axis| at[axis] < 0 || at[axis] >= self.size[axis] as i64) {
            return [0.0; 4];
        }
        self.stored(at, variant)
    }
}

/// Which of `layers` a coordinate names: `max(0, min(d - 1, floor(layer + 1/2)))` (GLSL 1.30,
/// section 8.7).
pub fn layer(coordinate: f64, layers: usize, variant: Variant) -> usize {
    let half = if variant.has(Mutation::LayerFloored) { 0.0 } else { 0.5 };
    (coordinate + half).floor().clamp(0.0, layers as f64 - 1.0) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_border_texel_is_mixed_in_at_the_edge() {
        let texel = |v: f64| [v; 4];
        let texture = Texture {
            target: Target::D1,
            size: [2, 1, 1],
            border: 1,
            texels: Volume { size: [4, 1, 1], texels: [8.0, 0.0, 4.0, 2.0].map(texel).to_vec() },
            wrap: [Wrap::Clamp; 3],
            border_color: [9.0; 4],
            filter: Filter::Linear,
        };
        let at = |s: f64| texture.sample([s, 0.0, 0.0], [0; 3], Variant::CORRECT)[0];
        assert_eq!([at(0.0), at(0.5), at(7.0)], [4.0, 2.0, 3.0]);
    }

    #[test]
    fn layers_are_rounded_and_held() {
        let layers = Texture {
            target: Target::D1Array,
            size: [1, 3, 1],
            border: 0,
            texels: Volume { size: [1, 3, 1], texels: [0.0, 1.0, 2.0].map(|v| [v; 4]).to_vec() },
            wrap: [Wrap::Repeat; 3],
            border_color: [0.0; 4],
            filter: Filter::Linear,
        };
        let at = |layer: f64| layers.sample([0.5, layer, 0.0], [0; 3], Variant::CORRECT)[0];
        assert_eq!([at(-3.0), at(0.6), at(1.4), at(9.0)], [0.0, 1.0, 1.0, 2.0]);
    }
}
