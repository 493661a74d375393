//! Mipmaps of every shape: `textureSize`, and λ of derivatives along one, two and three axes and of
//! directions into a cube.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::pyramid::{Derivatives, Shape, lambda};
use crate::probe::{GREY, ProbeError};
use crate::rng::Rng;

/// Sizes of levels.
pub const SIZE: Check = Check {
    name: "texture-size",
    citation: "GLSL 1.30, 8.7: textureSize; GL 2.1, 3.8.1",
    what: "width, height, depth or layers of each level of 1D, 2D, 3D, cube and array textures",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers",
    run: size,
};

/// λ of one, two and three axes.
pub const LAMBDA: Check = Check {
    name: "lod-targets",
    citation: "GL 2.1, 3.8.8: λ = log2 ρ of ∂(u, v, w); EXT_texture_array",
    what: "λ of random derivatives on 1D, 2D, 3D and array textures, measured as the blend of two \
           grey levels",
    unit: Unit::Levels,
    tolerance: 20.0 / (1 << 24) as f64,
    why: "f32: half an ulp of λ ≤ 7 is 4 · 2^-24, of its grey 2^-25 · 16 levels: 8 · 2^-24; log2 and ρ a few more",
    run: |harness, tally| {
        let shapes = [Shape::D1, Shape::D2, Shape::D3, Shape::D1Array, Shape::D2Array];
        shapes.into_iter().try_for_each(|shape| levels(harness, tally, shape))
    },
};

/// λ of a direction's derivatives.
pub const CUBE_GRAD: Check = Check {
    name: "cube-grad",
    citation: "GLSL 1.30, 8.7: textureGrad of samplerCube; GL 2.1, 3.8.6 and 3.8.8",
    what: "λ of random derivatives of directions, by way of those of s and t on the face",
    unit: Unit::Levels,
    tolerance: 22.0 / (1 << 24) as f64,
    why: "f32: half an ulp of λ up to 8 is 8 · 2^-24, its grey as much; ρ loses a bit in the quotient rule where its two terms cancel",
    run: |harness, tally| levels(harness, tally, Shape::Cube),
};

/// A size for a shape: sides of the filtered axes, then layers.
fn sides(shape: Shape, rng: &mut Rng) -> [usize; 3] {
    let side = |rng: &mut Rng| rng.pick(&[1, 5, 16, 32, 64, 100]);
    let [w, h, d] = [side(rng), side(rng), side(rng)];
    let layers = rng.pick(&[1, 3, 6]);
    match shape {
        Shape::D1 => [w, 1, 1],
        Shape::D2 => [w, h, 1],
        Shape::D3 => [w.min(32), h.min(32), d.min(32)],
        Shape::Cube => [w, w, 1],
        Shape::D1Array => [w, layers, 1],
        Shape::D2Array => [w, h, layers],
    }
}

/// The sampler type of a shape, and its numbers of sizes and derivatives.
fn sampler(shape: Shape) -> (&'static str, usize, usize) {
    match shape {
        Shape::D1 => ("sampler1D", 1, 1),
        Shape::D2 => ("sampler2D", 2, 2),
        Shape::D3 => ("sampler3D", 3, 3),
        Shape::Cube => ("samplerCube", 2, 3),
        Shape::D1Array => ("sampler1DArray", 2, 1),
        Shape::D2Array => ("sampler2DArray", 3, 2),
    }
}

fn size(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("texture-size");
    for shape in Shape::ALL {
        for _ in 0..4 {
            let base = sides(shape, &mut rng);
            let cases: Vec<usize> = (0..shape.levels(base)).collect();
            let expect = |&level: &usize, variant: Variant| shape.queried(base, level, variant);
            harness.compare(tally, &(shape, base), &cases, expect, |session| {
                session.grey_levels(shape, base)?;
                let inputs: Vec<_> = cases
                    .iter()
                    .map(|&l| [[l as f32, 0.0, 0.0, 0.0], [0.0; 4], [0.0; 4]])
                    .collect();
                let (sampler, sizes, _) = sampler(shape);
                let zeros = ["0.0, 0.0, 0.0", "0.0, 0.0", "0.0"][sizes - 1];
                let body = format!(
                    "uniform {sampler} image;
                     vec4 value() {{ return vec4(textureSize(image, int(a.x)), {zeros}); }}"
                );
                session.field(&body, 4, &inputs)
            })?;
        }
    }
    Ok(())
}

/// Coordinates and their derivatives.
#[derive(Clone, Copy, Debug)]
struct Case {
    at: [f32; 3],
    derivatives: [[f32; 3]; 2],
}

impl Case {
    /// ρ from about half a texel to the whole image.
    fn random(rng: &mut Rng, shape: Shape, base: [usize; 3]) -> Self {
        let at = loop {
            let at = [0; 3].map(|_: i32| rng.real(-1.0, 1.0));
            let mut sorted = at.map(|c| c.abs());
            sorted.sort_by(f32::total_cmp);
            // Directions are of any length, but not near two faces.
            if shape != Shape::Cube || (sorted[2] > 0.1 && sorted[1] < 0.99 * sorted[2]) {
                break at;
            }
        };
        let steepest = f64::from(1u32 << rng.integer(0, 7)) / 2.0;
        let derivatives = [0; 2].map(|_: i32| {
            std::array::from_fn(|i| {
                let texels = rng.real(-steepest, steepest);
                let n = if shape == Shape::Cube { base[0] } else { base[i] };
                texels / n as f32
            })
        });
        Self { at, derivatives }
    }

    fn exact(&self) -> Derivatives {
        self.derivatives.map(|d| d.map(f64::from))
    }
}

fn levels(harness: &Harness, tally: &mut Tally, shape: Shape) -> Result<(), ProbeError> {
    let mut rng = Rng::named("lod-targets");
    for _ in 0..3 {
        let base = loop {
            let base = sides(shape, &mut rng);
            if shape.levels(base) > 3 {
                break base;
            }
        };
        let cases: Vec<Case> =
            (0..harness.cases(2048)).map(|_| Case::random(&mut rng, shape, base)).collect();
        let expect = |case: &Case, variant: Variant| {
            let at = case.at.map(f64::from);
            [lambda(shape, base, at, &case.exact(), variant), 0.0, 0.0, 0.0]
        };
        harness.compare(tally, &(shape, base), &cases, expect, |session| {
            session.grey_levels(shape, base)?;
            let four = |c: [f32; 3]| [c[0], c[1], c[2], 0.0];
            let inputs: Vec<_> = cases
                .iter()
                .map(|case| [four(case.at), four(case.derivatives[0]), four(case.derivatives[1])])
                .collect();
            let (sampler, _, derivatives) = sampler(shape);
            let swizzle = [".x", ".xy", ".xyz"];
            let d = swizzle[derivatives - 1];
            let at = swizzle[derivatives - 1 + usize::from(shape.has_layers())];
            let body = format!(
                "uniform {sampler} image;
                 vec4 value() {{ return textureGrad(image, a{at}, b{d}, c{d}); }}"
            );
            let greys = session.field(&body, 1, &inputs)?;
            Ok(greys.iter().map(|g| [g[0] * 255.0 / GREY as f64, 0.0, 0.0, 0.0]).collect())
        })?;
    }
    Ok(())
}
