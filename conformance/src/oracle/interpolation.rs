//! Interpolation over a triangle (section 3.5.1).

use crate::mutation::{Mutation, Variant};

/// A vertex after the viewport transformation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Window x and y, in pixels.
    pub xy: [f64; 2],
    /// Normalized device depth, in [-1, 1].
    pub z: f64,
    /// Clip w.
    pub w: f64,
    /// The interpolated datum.
    pub datum: f64,
}

/// Barycentric coordinates of `p`: each the area of the triangle that `p` makes with the opposite
/// edge, over the whole area.
pub fn barycentric(triangle: &[Vertex; 3], p: [f64; 2]) -> [f64; 3] {
    let area = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
    };
    let [a, b, c] = triangle.map(|v| v.xy);
    let whole = area(a, b, c);
    [area(p, b, c) / whole, area(a, p, c) / whole, area(a, b, p) / whole]
}

/// The centre of a pixel.
fn centre(pixel: [usize; 2], variant: Variant) -> [f64; 2] {
    let half = if variant.has(Mutation::InterpolatedAtCorner) { 0.0 } else { 0.5 };
    pixel.map(|c| c as f64 + half)
}

/// The datum at a pixel's centre:
/// `f = (a·fa/wa + b·fb/wb + c·fc/wc) / (a/wa + b/wb + c/wc)`.
pub fn datum(triangle: &[Vertex; 3], pixel: [usize; 2], variant: Variant) -> f64 {
    let weights = barycentric(triangle, centre(pixel, variant));
    let w = |v: &Vertex| if variant.has(Mutation::Affine) { 1.0 } else { v.w };
    let sum = |f: &dyn Fn(&Vertex) -> f64| -> f64 {
        weights.iter().zip(triangle).map(|(weight, v)| weight * f(v) / w(v)).sum()
    };
    sum(&|v| v.datum) / sum(&|_| 1.0)
}

/// Window depth at a pixel's centre: `z = a·za + b·zb + c·zc` of the vertices' window depths,
/// `z_w = (f - n)/2 · z_d + (n + f)/2` (section 2.11.1).
pub fn depth(
    triangle: &[Vertex; 3],
    pixel: [usize; 2],
    [near, far]: [f64; 2],
    variant: Variant,
) -> f64 {
    let weights = barycentric(triangle, centre(pixel, variant));
    let [near, far] =
        if variant.has(Mutation::DepthRangeIgnored) { [0.0, 1.0] } else { [near, far] };
    let w = |v: &Vertex| if variant.has(Mutation::DepthPerspective) { v.w } else { 1.0 };
    let sum = |f: &dyn Fn(&Vertex) -> f64| -> f64 {
        weights.iter().zip(triangle).map(|(weight, v)| weight * f(v) / w(v)).sum()
    };
    sum(&|v| (far - near) / 2.0 * v.z + (near + far) / 2.0) / sum(&|_| 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> [Vertex; 3] {
        let vertex = |x, y, w, datum| Vertex { xy: [x, y], z: 2.0 * datum - 1.0, w, datum };
        [vertex(0.5, 0.5, 1.0, 0.0), vertex(4.5, 0.5, 3.0, 1.0), vertex(0.5, 4.5, 1.0, 0.0)]
    }

    #[test]
    fn halfway_to_the_far_vertex_the_near_one_weighs_more() {
        // 1/2 · 1/3 over 1/2 · 1 + 1/2 · 1/3.
        assert!((datum(&triangle(), [2, 0], Variant::CORRECT) - 0.25).abs() < 1e-15);
    }

    #[test]
    fn depth_is_affine() {
        assert!((depth(&triangle(), [2, 0], [0.0, 1.0], Variant::CORRECT) - 0.5).abs() < 1e-15);
        assert!((depth(&triangle(), [2, 0], [0.5, 0.0], Variant::CORRECT) - 0.25).abs() < 1e-15);
    }
}
