//! Level of detail: ρ, λ, bias and clamp, read off a mipmap whose levels have one grey each.
//!
//! Level `l` is the grey `16·l/255`, so that a trilinear sample is `16·λ/255`. Coordinates are
//! computed in the shader from the pixel's position in its quad, with few enough bits that their
//! differences are exact: ρ is known to the last bit.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{self, Derivatives, Filter, Filters, LevelRange, LodState, Mipmap};
use crate::oracle::sample::Sampler;
use crate::oracle::texture::{Level, level_count, level_size};
use crate::oracle::wrap::Wrap;
use crate::probe::{Precision, ProbeError, shader};
use crate::rng::Rng;

const WHY: &str = "f32: half an ulp of λ ≤ 9 is 2^-21, of its grey 2^-25 · 16 levels; \
                   log2 and ρ a few ulp more";

/// ρ and λ.
pub const LOD: Check = Check {
    name: "lod",
    citation: "GL 2.1, 3.8.8: λ_base = log2 ρ",
    what: "ρ of the larger footprint side, its log2, measured as the blend of two levels",
    unit: Unit::Levels,
    tolerance: 32.0 / (1 << 24) as f64,
    why: WHY,
    run: |harness, tally| run(harness, tally, &[LodState::default()]),
};

/// Bias and clamp.
pub const BIAS_CLAMP: Check = Check {
    name: "lod-bias-clamp",
    citation: "GL 2.1, 3.8.8: λ = clamp(λ_base + bias, lod_min, lod_max)",
    what: "bias of object, unit and shader, then GL_TEXTURE_MIN_LOD and GL_TEXTURE_MAX_LOD",
    unit: Unit::Levels,
    tolerance: 32.0 / (1 << 24) as f64,
    why: WHY,
    run: |harness, tally| {
        let plain = LodState::default();
        let states = [
            LodState { object_bias: 1.25, ..plain },
            LodState { unit_bias: -0.75, ..plain },
            LodState { object_bias: 0.5, unit_bias: 0.5, ..plain },
            LodState { min_lod: 2.5, ..plain },
            LodState { max_lod: 3.25, ..plain },
            LodState { object_bias: 1.5, min_lod: 1.5, max_lod: 4.75, ..plain },
        ];
        run(harness, tally, &states)
    },
};

/// Coordinates with derivatives, and the shader's bias.
#[derive(Clone, Copy, Debug)]
pub struct Footprint {
    /// (s, t) of the pixel that is read.
    pub st: [f32; 2],
    /// `∂(s, t)/∂x`.
    pub dx: [f32; 2],
    /// `∂(s, t)/∂y`.
    pub dy: [f32; 2],
    /// The shader's bias.
    pub bias: f32,
}

impl Footprint {
    /// A random footprint: ρ from about 1/4 of a texel to the whole image, all numbers short enough that
    /// sums of them are exact in `f32`.
    pub fn random(rng: &mut Rng, size: [usize; 2], bias: f32) -> Self {
        // 8 bits, scaled by a power of two: u-derivative from 2^-2 to 2^9.
        let mut derivative = |n: usize| {
            let texels = rng.integer(128, 255) as f64 / 256.0
                * f64::from(1u32 << rng.integer(0, i64::from(n.ilog2()) + 2))
                / 4.0;
            let sign = if rng.integer(0, 1) == 0 { 1.0 } else { -1.0 };
            (sign * texels / n as f64) as f32
        };
        let dx = size.map(&mut derivative);
        let dy = size.map(&mut derivative);
        let st = [0; 2].map(|_: i32| rng.dyadic(0.0, 1.0, 1.0 / 256.0));
        Self { st, dx, dy, bias }
    }

    /// The arguments of the oracle.
    pub fn derivatives(&self) -> Derivatives {
        Derivatives { dx: self.dx.map(f64::from), dy: self.dy.map(f64::from) }
    }

    /// The inputs of the shader.
    pub fn inputs(&self) -> [[f32; 4]; 3] {
        let Self { st: [s, t], dx, dy, bias } = *self;
        [[s, t, 0.0, 1.0], [dx[0], dx[1], dy[0], dy[1]], [bias, 0.0, 0.0, 0.0]]
    }
}

const SIZES: [[usize; 2]; 4] = [[256, 256], [256, 16], [2, 128], [32, 32]];
const GREY: usize = 16;

fn run(harness: &Harness, tally: &mut Tally, states: &[LodState]) -> Result<(), ProbeError> {
    let mut rng = Rng::named("lod");
    let filters = Filters { min: Filter::Linear, mipmap: Mipmap::Linear, mag: Filter::Linear };
    for (size, state) in SIZES.iter().flat_map(|&size| states.iter().map(move |&s| (size, s))) {
        let last = level_count(size) - 1;
        let image: Vec<Level> = (0..=last)
            .map(|l| {
                let [w, h] = level_size(size, l);
                Level::from_fn(w, h, |_, _| [(l * GREY) as u8; 4])
            })
            .collect();
        let sampler = Sampler {
            at: Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] },
            filters,
            lod: state,
            range: LevelRange { base: 0, last },
        };
        let cases: Vec<Footprint> = (0..harness.cases(2048))
            .map(|_| {
                let bias =
                    if state != LodState::default() { rng.dyadic(-1.0, 1.0, 0.125) } else { 0.0 };
                Footprint::random(&mut rng, size, bias)
            })
            .collect();
        let expect = |case: &Footprint, variant: Variant| {
            let state = LodState { shader_bias: f64::from(case.bias), ..state };
            let rho = lod::rho(&case.derivatives(), size, variant);
            [lod::lambda(rho, &state, variant).clamp(0.0, last as f64), 0.0, 0.0, 0.0]
        };
        harness.compare(tally, &(size, state), &cases, expect, |session| {
            session.texture_2d(&image, &sampler)?;
            let program =
                session.program(shader::TEXTURE_2D_BIAS, Precision::Exact { components: 1 })?;
            let inputs: Vec<_> = cases.iter().map(Footprint::inputs).collect();
            let greys = session.cells(&program, &inputs)?;
            Ok(greys.iter().map(|c| [c[0] * 255.0 / GREY as f64, 0.0, 0.0, 0.0]).collect())
        })?;
    }
    Ok(())
}
