//! `textureGather` in scalar `f64`, from ARB_texture_gather and from OpenGL 3.2, section 3.8.8 and table 3.20; the wrap
//! modes that this table lacks are those of GL 2.1 and EXT_texture_mirror_clamp, whose coordinate is held first.

use crate::oracle::{Answer, Oracle};
use texunit::image::Shape;
use texunit::sampler::{Seamless, Wrap};

/// A place in an image that is mirrored at 0.
fn mirror(i: f64) -> f64 {
    if i >= 0.0 { i } else { -(1.0 + i) }
}

/// The texel that stands for `i`.
fn wrapped(wrap: Wrap, i: f64, n: f64) -> f64 {
    match wrap {
        Wrap::Repeat => i.rem_euclid(n),
        Wrap::MirroredRepeat => (n - 1.0) - mirror(i.rem_euclid(2.0 * n) - n),
        Wrap::ClampToEdge => i.clamp(0.0, n - 1.0),
        Wrap::Clamp | Wrap::ClampToBorder => i.clamp(-1.0, n),
        Wrap::MirrorClampToEdge => mirror(i).clamp(0.0, n - 1.0),
        Wrap::MirrorClamp | Wrap::MirrorClampToBorder => mirror(i).clamp(0.0, n),
    }
}

impl Oracle<'_> {
    /// The four first components, as if they were a colour.
    pub fn gather(&self, at: [f64; 3]) -> Answer {
        let (place, mut margin) = self.place(at);
        let shape = self.image.shape();
        let number = self.sampler.base_level as usize;
        let (level, slice) = self.stored(place, number);
        let is_cube = matches!(shape, Shape::Cube | Shape::CubeArray);
        let seamless = is_cube && self.sampler.seamless == Seamless::On;
        let mut along = [[0.0; 2]; 2];
        for (axis, along) in along.iter_mut().enumerate() {
            let n = f64::from(level.size()[axis]);
            let scale = if shape == Shape::Rect { 1.0 } else { n };
            let wrap = match (shape, self.sampler.wrap[axis]) {
                (Shape::Rect, wrap @ (Wrap::Clamp | Wrap::ClampToBorder)) => wrap,
                (Shape::Rect, _) => Wrap::ClampToEdge,
                (_, wrap) => wrap,
            };
            let u = place.at[axis] * scale + f64::from(self.offset[axis]);
            let u = match wrap {
                Wrap::Clamp => u.clamp(0.0, n),
                Wrap::MirrorClamp => u.clamp(-n, n),
                Wrap::Repeat
                | Wrap::ClampToEdge
                | Wrap::ClampToBorder
                | Wrap::MirroredRepeat
                | Wrap::MirrorClampToEdge
                | Wrap::MirrorClampToBorder => u,
            };
            let i = (u - 0.5).floor();
            margin = margin.min((u - 0.5 - (u - 0.5).round()).abs());
            let of = |i: f64| if seamless { i } else { wrapped(wrap, i, n) };
            *along = [of(i), of(i + 1.0)];
        }
        let places = [[0, 1], [1, 1], [1, 0], [0, 0]];
        let texels = places.map(|[i, j]| {
            let at = [along[0][i] as i32, along[1][j] as i32, slice];
            let texel = match seamless {
                true => self.across(place, number, at)?,
                false => self.texel(level, at),
            };
            Some(self.swizzled(Answer { rgba: texel, margin }).rgba[0])
        });
        let others: f64 = texels.iter().flatten().sum();
        Answer { rgba: texels.map(|texel| texel.unwrap_or(others / 3.0)), margin }
    }
}
