//! Scale factor, level of detail, and choice of level (section 3.8.8).

use crate::mutation::{Mutation, Variant};

/// Derivatives of (s, t) by window x and by window y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivatives {
    /// `∂(s, t)/∂x`.
    pub dx: [f64; 2],
    /// `∂(s, t)/∂y`.
    pub dy: [f64; 2],
}

/// The scale factor
/// `ρ = max(√((∂u/∂x)² + (∂v/∂x)²), √((∂u/∂y)² + (∂v/∂y)²))` with `u = s · width`,
/// `v = t · height` of the base level.
pub fn rho(d: &Derivatives, size: [usize; 2], variant: Variant) -> f64 {
    let scale = if variant.has(Mutation::RhoWithoutSize) { [1, 1] } else { size };
    let length = |d: [f64; 2]| {
        let (u, v) = (d[0] * scale[0] as f64, d[1] * scale[1] as f64);
        if variant.has(Mutation::RhoOfLargestComponent) {
            u.abs().max(v.abs())
        } else {
            (u * u + v * v).sqrt()
        }
    };
    let (x, y) = (length(d.dx), length(d.dy));
    if variant.has(Mutation::RhoOfSum) {
        x + y
    } else if variant.has(Mutation::RhoOfMinimum) {
        x.min(y)
    } else if variant.has(Mutation::RhoOfX) {
        x
    } else {
        x.max(y)
    }
}

/// The biases and the clamp of λ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LodState {
    /// `GL_TEXTURE_LOD_BIAS` of the texture object.
    pub object_bias: f64,
    /// `GL_TEXTURE_LOD_BIAS` of the texture unit (`GL_TEXTURE_FILTER_CONTROL`).
    pub unit_bias: f64,
    /// The third argument of `texture2D`.
    pub shader_bias: f64,
    /// `GL_TEXTURE_MIN_LOD`.
    pub min_lod: f64,
    /// `GL_TEXTURE_MAX_LOD`.
    pub max_lod: f64,
}

impl Default for LodState {
    /// That of a new texture object (table 6.16).
    fn default() -> Self {
        Self {
            object_bias: 0.0,
            unit_bias: 0.0,
            shader_bias: 0.0,
            min_lod: -1000.0,
            max_lod: 1000.0,
        }
    }
}

/// `λ_base = log2 ρ`, `λ' = λ_base + biases`, `λ = clamp(λ', lod_min, lod_max)`.
///
/// The sum of the biases is to be within ±`GL_MAX_TEXTURE_LOD_BIAS`, which is at least 2.
pub fn lambda(rho: f64, state: &LodState, variant: Variant) -> f64 {
    let mut base = rho.log2();
    if variant.has(Mutation::LambdaOffByOne) {
        base += 1.0;
    }
    if variant.has(Mutation::LambdaOfSquare) {
        base *= 2.0;
    }
    let unless = |mutation, bias| if variant.has(mutation) { 0.0 } else { bias };
    let bias = unless(Mutation::BiasOfObjectIgnored, state.object_bias)
        + unless(Mutation::BiasOfUnitIgnored, state.unit_bias)
        + unless(Mutation::BiasOfShaderIgnored, state.shader_bias);
    let clamp = |lambda: f64| {
        let low = if variant.has(Mutation::MinLodIgnored) { f64::MIN } else { state.min_lod };
        let high = if variant.has(Mutation::MaxLodIgnored) { f64::MAX } else { state.max_lod };
        lambda.max(low).min(high)
    };
    if variant.has(Mutation::BiasAfterClamp) { clamp(base) + bias } else { clamp(base + bias) }
}

/// A filter within a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// One texel.
    Nearest,
    /// Four texels.
    Linear,
}

/// How levels are combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mipmap {
    /// The base level only.
    None,
    /// The nearest level.
    Nearest,
    /// The two nearest levels.
    Linear,
}

/// The filters of a texture object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filters {
    /// Within a level when minified.
    pub min: Filter,
    /// Between levels when minified.
    pub mipmap: Mipmap,
    /// When magnified.
    pub mag: Filter,
}

impl Filters {
    /// The same filter always, at the base level.
    pub const fn only(filter: Filter) -> Self {
        Self { min: filter, mipmap: Mipmap::None, mag: filter }
    }

    /// All twelve pairs of minification and magnification filter.
    pub fn all() -> Vec<Self> {
        let mut all = Vec::new();
        for min in [Filter::Nearest, Filter::Linear] {
            for mipmap in [Mipmap::None, Mipmap::Nearest, Mipmap::Linear] {
                for mag in [Filter::Nearest, Filter::Linear] {
                    all.push(Self { min, mipmap, mag });
                }
            }
        }
        all
    }

    /// The λ up to which the image is magnified: 1/2 when the magnification filter is linear and
    /// the minification filter nearest within mipmap levels, so that the switch does not jump;
    /// otherwise 0 (section 3.8.9).
    pub fn threshold(&self, variant: Variant) -> f64 {
        let shifted = self.mag == Filter::Linear
            && self.min == Filter::Nearest
            && self.mipmap != Mipmap::None
            && !variant.has(Mutation::MagnifiedAtZero);
        if shifted { 0.5 } else { 0.0 }
    }
}

/// Which levels exist.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LevelRange {
    /// `GL_TEXTURE_BASE_LEVEL`.
    pub base: usize,
    /// `q = min(p, GL_TEXTURE_MAX_LEVEL)`: the smallest level that is used.
    pub last: usize,
}

/// The levels that a sample reads for a λ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Levels {
    /// This level, with this filter.
    One(usize, Filter),
    /// Two levels with this filter, and the weight of the second.
    Two([usize; 2], f64, Filter),
}

/// Chooses levels: magnified up to the threshold, else
/// `d = ceil(base + λ + 1/2) - 1` (nearest), or `d1 = floor(base + λ)`, `d2 = d1 + 1` with weight
/// `frac(λ)` (linear), none beyond `q`.
pub fn levels(lambda: f64, filters: Filters, range: LevelRange, variant: Variant) -> Levels {
    let base = if variant.has(Mutation::BaseLevelIgnored) { 0 } else { range.base };
    if lambda <= filters.threshold(variant) {
        return Levels::One(base, filters.mag);
    }
    let last = if variant.has(Mutation::MaxLevelIgnored) { f64::MAX } else { range.last as f64 };
    let position = base as f64 + lambda;
    let nearest = || {
        let d = if variant.has(Mutation::LevelByFloor) {
            position.floor()
        } else if variant.has(Mutation::LevelByCeil) {
            position.ceil()
        } else if lambda <= 0.5 {
            base as f64
        } else {
            (position + 0.5).ceil() - 1.0
        };
        Levels::One(d.min(last) as usize, filters.min)
    };
    match filters.mipmap {
        Mipmap::None => Levels::One(base, filters.min),
        Mipmap::Nearest => nearest(),
        Mipmap::Linear if variant.has(Mutation::OneLevelForTwo) => nearest(),
        Mipmap::Linear if position >= last => Levels::One(range.last, filters.min),
        Mipmap::Linear => {
            let lower = position.floor();
            let weight = position - lower;
            let reversed = variant.has(Mutation::LevelWeightsReversed);
            let weight = if reversed { 1.0 - weight } else { weight };
            Levels::Two([lower as usize, lower as usize + 1], weight, filters.min)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;
    const TRILINEAR: Filters =
        Filters { min: Filter::Linear, mipmap: Mipmap::Linear, mag: Filter::Linear };
    const RANGE: LevelRange = LevelRange { base: 0, last: 4 };

    #[test]
    fn rho_is_the_longer_footprint_side() {
        let d = Derivatives { dx: [3.0 / 16.0, 4.0 / 8.0], dy: [1.0, 0.0] };
        assert_eq!(rho(&d, [16, 8], TRUE), 16.0);
        assert_eq!(rho(&Derivatives { dy: [0.0; 2], ..d }, [16, 8], TRUE), 5.0);
    }

    #[test]
    fn bias_comes_before_the_clamp() {
        let state =
            LodState { object_bias: 1.5, unit_bias: -0.5, max_lod: 2.5, ..LodState::default() };
        assert_eq!(lambda(2.0, &state, TRUE), 2.0);
        assert_eq!(lambda(4.0, &state, TRUE), 2.5);
    }

    #[test]
    fn levels_by_hand() {
        let nearest = Filters { mipmap: Mipmap::Nearest, ..TRILINEAR };
        let table = [
            (-1.0, TRILINEAR, Levels::One(0, Filter::Linear)),
            (1.25, TRILINEAR, Levels::Two([1, 2], 0.25, Filter::Linear)),
            (9.0, TRILINEAR, Levels::One(4, Filter::Linear)),
            (1.5, nearest, Levels::One(1, Filter::Linear)),
            (1.75, nearest, Levels::One(2, Filter::Linear)),
            (4.75, nearest, Levels::One(4, Filter::Linear)),
        ];
        for (lambda, filters, expected) in table {
            assert_eq!(levels(lambda, filters, RANGE, TRUE), expected, "{lambda}");
        }
    }

    #[test]
    fn the_switch_to_magnification_shifts_for_nearest_in_mipmaps() {
        let shifted = Filters { min: Filter::Nearest, ..TRILINEAR };
        assert_eq!(levels(0.4, shifted, RANGE, TRUE), Levels::One(0, Filter::Linear));
        assert_eq!(Filters::only(Filter::Linear).threshold(TRUE), 0.0);
    }
}
