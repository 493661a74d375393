//! Mipmaps of every shape: the sizes of their levels, and the level of detail that derivatives of
//! their coordinates ask for (sections 3.8.8 and 3.8.6; GLSL 1.30, section 8.7).

use super::cube;
use crate::mutation::{Mutation, Variant};

/// A shape with levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum Shape {
    D1,
    D2,
    D3,
    Cube,
    D1Array,
    D2Array,
}

impl Shape {
    /// All.
    pub const ALL: [Self; 6] =
        [Self::D1, Self::D2, Self::D3, Self::Cube, Self::D1Array, Self::D2Array];

    /// Coordinates that are filtered along, once a face is chosen.
    pub fn axes(self) -> usize {
        match self {
            Self::D1 | Self::D1Array => 1,
            Self::D2 | Self::Cube | Self::D2Array => 2,
            Self::D3 => 3,
        }
    }

    /// Whether a size that comes after those is the number of layers.
    pub fn has_layers(self) -> bool {
        match self {
            Self::D1Array | Self::D2Array => true,
            Self::D1 | Self::D2 | Self::D3 | Self::Cube => false,
        }
    }

    /// The size of a level: `max(1, floor(side / 2^level))`; as many layers as before.
    pub fn level(self, base: [usize; 3], level: usize, variant: Variant) -> [usize; 3] {
        let halved = if variant.has(Mutation::LayersHalved) { 3 } else { self.axes() };
        std::array::from_fn(|i| if i < halved { (base[i] >> level).max(1) } else { base[i] })
    }

    /// How many levels a complete mipmap of this size has.
    pub fn levels(self, base: [usize; 3]) -> usize {
        let largest = base[..self.axes()].iter().max().copied().unwrap_or(1);
        largest.ilog2() as usize + 1
    }

    /// `textureSize`: the components that the function gives, and 0 for the others.
    pub fn queried(self, base: [usize; 3], level: usize, variant: Variant) -> [f64; 4] {
        let level = if variant.has(Mutation::SizeOfBaseLevel) { 0 } else { level };
        let size = self.level(base, level, variant);
        let given = self.axes() + usize::from(self.has_layers());
        std::array::from_fn(|i| if i < given { size[i] as f64 } else { 0.0 })
    }
}

/// Derivatives of the coordinates by window x and by window y.
pub type Derivatives = [[f64; 3]; 2];

/// `λ = log2 max(|∂(u, v, w)/∂x|, |∂(u, v, w)/∂y|)`, within the levels. Of a cube, the derivatives
/// are those of the coordinates on the face that `at` selects.
pub fn lambda(
    shape: Shape,
    base: [usize; 3],
    at: [f64; 3],
    derivatives: &Derivatives,
    variant: Variant,
) -> f64 {
    let axes = if variant.has(Mutation::LastAxisFree) { shape.axes() - 1 } else { shape.axes() };
    let length = |d: [f64; 3]| {
        let d = match shape {
            Shape::Cube => {
                let [s, t] = cube::derivative(at, d, variant);
                [s, t, 0.0]
            }
            Shape::D1 | Shape::D2 | Shape::D3 | Shape::D1Array | Shape::D2Array => d,
        };
        let square = |i: usize| {
            let n = if variant.has(Mutation::RhoWithoutSize) { 1 } else { base[i] };
            (d[i] * n as f64).powi(2)
        };
        (0..axes).map(square).sum::<f64>().sqrt()
    };
    let [x, y] = derivatives.map(length);
    let rho = if variant.has(Mutation::RhoOfX) { x } else { x.max(y) };
    rho.log2().clamp(0.0, (shape.levels(base) - 1) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn sizes_by_hand() {
        assert_eq!(Shape::D3.queried([8, 5, 3], 1, TRUE), [4.0, 2.0, 1.0, 0.0]);
        assert_eq!(Shape::D1Array.queried([8, 5, 1], 2, TRUE), [2.0, 5.0, 0.0, 0.0]);
        assert_eq!(Shape::D2Array.queried([8, 5, 3], 3, TRUE), [1.0, 1.0, 3.0, 0.0]);
        assert_eq!(Shape::D2Array.levels([8, 5, 30]), 4);
    }

    #[test]
    fn lambdas_by_hand() {
        // 3, 0, 4 texels a pixel; 5 is between levels 2 and 3.
        let d = [[3.0 / 16.0, 0.0, 4.0 / 8.0], [0.0; 3]];
        let lambda = lambda(Shape::D3, [16, 32, 8], [0.0; 3], &d, TRUE);
        assert!((lambda - 5.0_f64.log2()).abs() < 1e-12);
    }
}
