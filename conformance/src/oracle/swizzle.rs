//! Swizzles in every way that a texture is read (GL 3.3, section 3.8.16; ARB_texture_gather).

use crate::mutation::{Mutation, Variant};

/// Where a component comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum Source {
    Red,
    Green,
    Blue,
    Alpha,
    Zero,
    One,
}

impl Source {
    /// All.
    pub const ALL: [Self; 6] =
        [Self::Red, Self::Green, Self::Blue, Self::Alpha, Self::Zero, Self::One];

    fn of(self, texel: [f64; 4]) -> f64 {
        match self {
            Self::Red => texel[0],
            Self::Green => texel[1],
            Self::Blue => texel[2],
            Self::Alpha => texel[3],
            Self::Zero => 0.0,
            Self::One => 1.0,
        }
    }
}

/// How a texture is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Path {
    /// `texelFetch`.
    Fetch,
    /// `textureGather`: the first component of four texels.
    Gather,
    /// `textureLod` beyond the edge.
    Border,
    /// `texture` of a comparison.
    Shadow,
}

impl Path {
    /// All.
    pub const ALL: [Self; 4] = [Self::Fetch, Self::Gather, Self::Border, Self::Shadow];

    fn ignored(self) -> Mutation {
        match self {
            Self::Fetch => Mutation::FetchUnswizzled,
            Self::Gather => Mutation::GatherUnswizzled,
            Self::Border => Mutation::BorderUnswizzled,
            Self::Shadow => Mutation::ShadowUnswizzled,
        }
    }
}

/// A texel as the shader gets it.
pub fn swizzled(path: Path, sources: [Source; 4], texel: [f64; 4], variant: Variant) -> [f64; 4] {
    if variant.has(path.ignored()) { texel } else { sources.map(|source| source.of(texel)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_by_hand() {
        let sources = [Source::Alpha, Source::One, Source::Red, Source::Zero];
        let got = swizzled(Path::Fetch, sources, [2.0, 3.0, 4.0, 5.0], Variant::CORRECT);
        assert_eq!(got, [5.0, 1.0, 2.0, 0.0]);
    }
}
