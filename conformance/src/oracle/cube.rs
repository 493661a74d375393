//! Cube map texture selection (section 3.8.6).

use crate::mutation::{Mutation, Variant};

/// A face, in the order of GL's enums.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// `GL_TEXTURE_CUBE_MAP_POSITIVE_X`.
    PositiveX,
    /// `GL_TEXTURE_CUBE_MAP_NEGATIVE_X`.
    NegativeX,
    /// `GL_TEXTURE_CUBE_MAP_POSITIVE_Y`.
    PositiveY,
    /// `GL_TEXTURE_CUBE_MAP_NEGATIVE_Y`.
    NegativeY,
    /// `GL_TEXTURE_CUBE_MAP_POSITIVE_Z`.
    PositiveZ,
    /// `GL_TEXTURE_CUBE_MAP_NEGATIVE_Z`.
    NegativeZ,
}

impl Face {
    /// All of them, in order.
    pub const ALL: [Self; 6] = [
        Self::PositiveX,
        Self::NegativeX,
        Self::PositiveY,
        Self::NegativeY,
        Self::PositiveZ,
        Self::NegativeZ,
    ];

    /// The face through which a direction leaves the cube. Where two components are equally
    /// large the specification leaves the choice open; here the earlier axis has it.
    fn of(r: [f64; 3], variant: Variant) -> Self {
        let a = r.map(f64::abs);
        let x_first = variant.has(Mutation::CubeMajorAxisX) && a[0] > 0.0;
        let (axis, negative) = if x_first || (a[0] >= a[1] && a[0] >= a[2]) {
            (0, r[0] < 0.0)
        } else if a[1] >= a[2] {
            (2, r[1] < 0.0)
        } else {
            (4, r[2] < 0.0)
        };
        let other = negative != variant.has(Mutation::CubeFacesOfAxisSwapped);
        Self::ALL[axis + usize::from(other)]
    }

    /// `(sc, tc, ma)` as the table of section 3.8.6 has them.
    fn coordinates(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self {
            Self::PositiveX => [-z, -y, x],
            Self::NegativeX => [z, -y, x],
            Self::PositiveY => [x, z, y],
            Self::NegativeY => [x, -z, y],
            Self::PositiveZ => [x, -y, z],
            Self::NegativeZ => [-x, -y, z],
        }
    }
}

/// The face and `s = (sc/|ma| + 1)/2`, `t = (tc/|ma| + 1)/2` of a direction, of any length but 0.
pub fn select(r: [f64; 3], variant: Variant) -> (Face, [f64; 2]) {
    let face = Face::of(r, variant);
    let [mut sc, mut tc, ma] = face.coordinates(r);
    if variant.has(Mutation::CubeTopFlipped) && matches!(face, Face::PositiveY | Face::NegativeY) {
        tc = -tc;
    }
    if variant.has(Mutation::CubeHandedness) {
        sc = -sc;
    }
    if variant.has(Mutation::CubeCoordinatesSwapped) {
        (sc, tc) = (tc, sc);
    }
    let divisor = if variant.has(Mutation::CubeWithoutDivide) { 1.0 } else { ma.abs() };
    (face, [sc, tc].map(|c| 0.5 * (c / divisor + 1.0)))
}

/// The derivative of (s, t) on the face of a direction, from that of the direction:
/// `∂(sc/|ma|)/2 = (∂sc · |ma| - sc · ∂|ma|) / 2ma²`.
pub fn derivative(r: [f64; 3], d: [f64; 3], variant: Variant) -> [f64; 2] {
    let face = Face::of(r, variant);
    let [sc, tc, ma] = face.coordinates(r);
    let [dsc, dtc, dma] = face.coordinates(d);
    let change = if variant.has(Mutation::MajorAxisFixed) { 0.0 } else { dma * ma.signum() };
    [(sc, dsc), (tc, dtc)].map(|(c, dc)| 0.5 * (dc * ma.abs() - c * change) / (ma * ma))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_the_coordinates() {
        let (r, d) = ([0.3, -2.0, 0.7], [0.2, 0.5, -0.4]);
        let moved = |h: f64| select([0, 1, 2].map(|i| r[i] + h * d[i]), Variant::CORRECT).1;
        let (before, after) = (moved(-1e-6), moved(1e-6));
        let got = derivative(r, d, Variant::CORRECT);
        for i in 0..2 {
            assert!((got[i] - (after[i] - before[i]) / 2e-6).abs() < 1e-8, "{got:?}");
        }
    }

    #[test]
    fn by_hand() {
        let table = [
            ([2.0, 0.0, 0.0], Face::PositiveX, [0.5, 0.5]),
            ([2.0, 1.0, -1.0], Face::PositiveX, [0.75, 0.25]),
            ([-2.0, 1.0, -1.0], Face::NegativeX, [0.25, 0.25]),
            ([1.0, 2.0, -1.0], Face::PositiveY, [0.75, 0.25]),
            ([1.0, -2.0, -1.0], Face::NegativeY, [0.75, 0.75]),
            ([1.0, 1.0, 2.0], Face::PositiveZ, [0.75, 0.25]),
            ([1.0, 1.0, -2.0], Face::NegativeZ, [0.25, 0.25]),
        ];
        for (r, face, st) in table {
            assert_eq!(select(r, Variant::CORRECT), (face, st), "{r:?}");
        }
    }
}
