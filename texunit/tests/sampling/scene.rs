//! Random images, samplers and coordinates.

use proptest::prelude::*;
use texunit::format::Format;
use texunit::image::{Image, Level, Shape};
use texunit::lanes::{F32s, LANES, lane_x, lane_y};
use texunit::sampler::{
    Compare, DepthFilter, DepthMode, Filter, Mipmap, Sampler, Seamless, SrgbRead, Swizzle, Wrap,
};

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

/// An image with all levels, each filled with its own noise; with a border where the shape and the
/// format may have one and the seed is odd. Cubes take the width; what else the shape lacks is 1.
pub fn image(shape: Shape, format: Format, width: u32, height: u32, seed: u64) -> Image {
    let mut random = Random(seed);
    let mut size = match shape {
        Shape::D1 => [width, 1, 1],
        Shape::D2 | Shape::Rect => [width, height, 1],
        Shape::D3 => [width, height, 5],
        Shape::Cube => [width, width, 1],
        Shape::D1Array => [width, 1, 3],
        Shape::D2Array => [width, height, 3],
        Shape::CubeArray => [width, width, 18],
    };
    let border = shape.border(if format.block().is_none() { (seed % 2) as u32 } else { 0 });
    let mut image = Image::new(shape);
    let levels = match shape {
        Shape::Rect => 1,
        _ => size[..shape.axes()].iter().max().unwrap().ilog2() + 1,
    };
    for level in 0..levels {
        for face in 0..shape.faces() {
            let mut texels = Level::with_size(format, size, border).unwrap();
            texels.fill(|_| {
                let noise = [0; 4].map(|_| random.within(0.0, 1.0));
                // Few depths, so that comparisons meet equal ones.
                let depth = (noise[0] * 4.0).floor() / 3.0;
                if format.is_depth() { [depth; 4] } else { noise }
            });
            image.set_level(face, level as usize, texels).unwrap();
        }
        size = shape.halved(size);
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

/// What a filter may mix: integers are only fetched.
pub fn formats() -> impl Strategy<Value = Format> {
    let formats = Format::ALL.into_iter().filter(|format| !format.is_integer());
    prop::sample::select(formats.collect::<Vec<_>>())
}

pub fn shapes() -> impl Strategy<Value = Shape> {
    prop::sample::select(Shape::ALL.to_vec())
}

fn wraps() -> impl Strategy<Value = Wrap> {
    prop::sample::select(Wrap::ALL.to_vec())
}

fn swizzles() -> impl Strategy<Value = [Swizzle; 4]> {
    let turned = [Swizzle::Alpha, Swizzle::One, Swizzle::Green, Swizzle::Zero];
    prop::sample::select(vec![Swizzle::IDENTITY, Swizzle::IDENTITY, turned])
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
    let modes = prop::sample::select(vec![
        DepthMode::Luminance,
        DepthMode::Intensity,
        DepthMode::Alpha,
        DepthMode::Red,
    ]);
    let seams = prop::sample::select(vec![Seamless::Off, Seamless::On]);
    let lods = prop_oneof![Just([-1000.0, 1000.0]), Just([0.3, 2.2]), Just([-1.0, 0.0])];
    (
        [wraps(), wraps(), wraps()],
        (filters(), mipmaps, filters()),
        (-2.0_f32..2.0, lods, 0..3_u32, 1..6_u32),
        [-1.0_f32..2.0, -1.0_f32..2.0, -1.0_f32..2.0, -1.0_f32..2.0],
        (compares(), modes),
        (prop::sample::select(vec![1.0, 1.0, 2.5, 16.0]), swizzles(), seams),
    )
        .prop_map(|(wrap, (min, mipmap, mag), lod, border, (compare, depth_mode), last)| {
            let (max_anisotropy, swizzle, seamless) = last;
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
                border: border.into(),
                compare,
                depth_mode,
                depth_filter: DepthFilter::Any,
                max_anisotropy,
                seamless,
                srgb: SrgbRead::Decode,
                swizzle,
            }
        })
}

/// The sampler that a shape takes: rectangles have one level.
pub fn for_shape(shape: Shape, sampler: Sampler) -> Sampler {
    match shape {
        Shape::Rect => Sampler { mipmap: Mipmap::None, base_level: 0, ..sampler },
        Shape::D1
        | Shape::D2
        | Shape::D3
        | Shape::Cube
        | Shape::D1Array
        | Shape::D2Array
        | Shape::CubeArray => sampler,
    }
}
