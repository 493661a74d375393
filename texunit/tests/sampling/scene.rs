//! Random images, samplers and coordinates.

use proptest::prelude::*;
use texunit::format::Format;
use texunit::image::{Image, Level, Shape};
use texunit::lanes::{F32s, LANES, lane_x, lane_y};
use texunit::sampler::{Compare, DepthMode, Filter, Mipmap, Sampler, Wrap};

/// A small generator (splitmix64), so that a case is its seed.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in `low` to `high`.
    pub fn within(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * ((self.bits() >> 40) as f32 / 16_777_216.0)
    }
}

/// An image with all levels, each filled with its own noise. Cubes take the width.
pub fn image(shape: Shape, format: Format, width: u32, height: u32, seed: u64) -> Image {
    let mut random = Random(seed);
    let height = if shape == Shape::Cube { width } else { height };
    let mut image = Image::new(shape);
    for face in 0..shape.faces() {
        for level in 0..=width.max(height).ilog2() {
            let (w, h) = ((width >> level).max(1), (height >> level).max(1));
            let mut texels = Level::new(format, w, h).unwrap();
            for y in 0..h {
                for x in 0..w {
                    let noise = [0; 4].map(|_| random.within(0.0, 1.0));
                    // Few depths, so that comparisons meet equal ones.
                    let depth = (noise[0] * 4.0).floor() / 3.0;
                    texels.put(x, y, if format.is_depth() { [depth; 4] } else { noise });
                }
            }
            image.set_level(face, level as usize, texels).unwrap();
        }
    }
    image
}

/// Coordinates of an 8×8 block: a random affine map of the pixels, up to `scale` apart, each moved
/// a little, so that the rows and columns of a quad differ.
pub fn block(random: &mut Random, scale: f32) -> [F32s; 3] {
    [(); 3].map(|()| {
        let start = random.within(-2.0, 2.0);
        let (dx, dy) = (random.within(-scale, scale), random.within(-scale, scale));
        F32s::from_fn(|lane| {
            let moved = random.within(-0.3, 0.3) * scale;
            start + lane_x(lane) as f32 * dx + lane_y(lane) as f32 * dy + moved
        })
    })
}

/// `∂/∂x` and `∂/∂y` of each lane from its quad, in `f64`.
pub fn quad_derivatives(v: &F32s, lane: usize) -> [f64; 2] {
    let (x, y) = (lane_x(lane), lane_y(lane));
    let at = |x: usize, y: usize| {
        let found = (0..LANES).find(|&l| lane_x(l) == x && lane_y(l) == y).unwrap();
        f64::from(v[found])
    };
    let (x0, y0) = (x & !1, y & !1);
    [at(x0 + 1, y) - at(x0, y), at(x, y0 + 1) - at(x, y0)]
}

pub fn formats() -> impl Strategy<Value = Format> {
    let sampled = |format: &Format| format.words() == 1 && !format.is_integer();
    prop::sample::select(Format::ALL.into_iter().filter(sampled).collect::<Vec<_>>())
}

pub fn shapes() -> impl Strategy<Value = Shape> {
    prop::sample::select(vec![Shape::D2, Shape::Cube])
}

fn wraps() -> impl Strategy<Value = Wrap> {
    use Wrap::{Clamp, ClampToBorder, ClampToEdge, MirroredRepeat, Repeat};
    prop::sample::select(vec![Repeat, Clamp, ClampToEdge, ClampToBorder, MirroredRepeat])
}

fn filters() -> impl Strategy<Value = Filter> {
    prop::sample::select(vec![Filter::Nearest, Filter::Linear])
}

fn compares() -> impl Strategy<Value = Option<Compare>> {
    use Compare::{Always, Equal, Greater, GreaterEqual, Less, LessEqual, Never, NotEqual};
    let some = [Never, Less, Equal, LessEqual, Greater, NotEqual, GreaterEqual, Always];
    prop::option::of(prop::sample::select(some.to_vec()))
}

/// Samplers whose every field varies.
pub fn samplers() -> impl Strategy<Value = Sampler> {
    let mipmaps = prop::sample::select(vec![Mipmap::None, Mipmap::Nearest, Mipmap::Linear]);
    let modes =
        prop::sample::select(vec![DepthMode::Luminance, DepthMode::Intensity, DepthMode::Alpha]);
    let lods = prop_oneof![Just([-1000.0, 1000.0]), Just([0.3, 2.2]), Just([-1.0, 0.0])];
    (
        [wraps(), wraps(), wraps()],
        (filters(), mipmaps, filters()),
        (-2.0_f32..2.0, lods, 0..3_u32, 1..6_u32),
        [-1.0_f32..2.0, -1.0_f32..2.0, -1.0_f32..2.0, -1.0_f32..2.0],
        (compares(), modes),
    )
        .prop_map(|(wrap, (min, mipmap, mag), lod, border, (compare, depth_mode))| {
            let (lod_bias, [min_lod, max_lod], base_level, above) = lod;
            Sampler {
                wrap,
                min,
                mipmap,
                mag,
                lod_bias,
                min_lod,
                max_lod,
                base_level,
                max_level: base_level + above,
                border,
                compare,
                depth_mode,
                ..Sampler::default()
            }
        })
}
