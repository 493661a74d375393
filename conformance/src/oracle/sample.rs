//! A whole sample: λ chooses levels, a filter reads each, their weights combine them
//! (section 3.8.8).

use super::filter::{self, Addressing};
use super::lod::{self, Derivatives, Filter, Filters, LevelRange, Levels, LodState};
use super::texture::Level;
use crate::mutation::Variant;

/// The state of a texture object and unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampler {
    /// Wrap and border.
    pub at: Addressing,
    /// Filters.
    pub filters: Filters,
    /// Bias and clamp of λ.
    pub lod: LodState,
    /// Levels that are used.
    pub range: LevelRange,
}

/// The filtered colour of a mipmapped image.
pub fn sample(
    image: &[Level],
    sampler: &Sampler,
    st: [f64; 2],
    derivatives: &Derivatives,
    variant: Variant,
) -> [f64; 4] {
    at_lambda(image, sampler, st, lambda(image, sampler, derivatives, variant), variant)
}

/// The filtered colour at a given λ, bias and clamp included.
pub fn at_lambda(
    image: &[Level],
    sampler: &Sampler,
    st: [f64; 2],
    lambda: f64,
    variant: Variant,
) -> [f64; 4] {
    let read = |level: usize, filter: Filter| {
        let level = &image[level.min(image.len() - 1)];
        match filter {
            Filter::Nearest => filter::nearest(level, &sampler.at, st, variant),
            Filter::Linear => filter::linear(level, &sampler.at, st, variant),
        }
    };
    match lod::levels(lambda, sampler.filters, sampler.range, variant) {
        Levels::One(level, filter) => read(level, filter),
        Levels::Two(levels, weight, filter) => {
            let [a, b] = levels.map(|level| read(level, filter));
            std::array::from_fn(|c| (1.0 - weight) * a[c] + weight * b[c])
        }
    }
}

/// The λ of a sample: the scale factor is measured in texels of the base level.
pub fn lambda(
    image: &[Level],
    sampler: &Sampler,
    derivatives: &Derivatives,
    variant: Variant,
) -> f64 {
    let base = &image[sampler.range.base];
    lod::lambda(lod::rho(derivatives, [base.width, base.height], variant), &sampler.lod, variant)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::lod::Mipmap;
    use crate::oracle::wrap::Wrap;

    #[test]
    fn trilinear_by_hand() {
        let image: Vec<Level> = [4, 2, 1]
            .iter()
            .zip([0, 100, 200])
            .map(|(&n, c)| Level::from_fn(n, n, |_, _| [c; 4]))
            .collect();
        let sampler = Sampler {
            at: Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] },
            filters: Filters { min: Filter::Linear, mipmap: Mipmap::Linear, mag: Filter::Linear },
            lod: LodState::default(),
            range: LevelRange { base: 0, last: 2 },
        };
        let scale = 2f64.sqrt() / 4.0;
        let d = Derivatives { dx: [scale, 0.0], dy: [0.0, 0.0] };
        let value = sample(&image, &sampler, [0.3, 0.9], &d, Variant::CORRECT);
        assert!((value[0] * 255.0 - 50.0).abs() < 1e-9, "{value:?}");
    }
}
