//! Derivatives of texture coordinates: differences within quads of pixels (GL 2.1, section 3.8.8).

use crate::lanes::math::max;
use crate::lanes::{F32s, QUADS};

/// Derivatives of the coordinates of each axis.
#[derive(Clone, Copy)]
pub struct Derivatives<'a> {
    pub dx: [&'a F32s; 3],
    pub dy: [&'a F32s; 3],
}

/// Fine differences along each quad's rows, in both of their pixels.
#[inline(always)]
pub fn ddx_fine(v: &F32s) -> F32s {
    let mut d = F32s::ZERO;
    for q in 0..QUADS {
        let lower = v[QUADS + q] - v[q];
        let upper = v[3 * QUADS + q] - v[2 * QUADS + q];
        d[q] = lower;
        d[QUADS + q] = lower;
        d[2 * QUADS + q] = upper;
        d[3 * QUADS + q] = upper;
    }
    d
}

/// Fine differences along each quad's columns, in both of their pixels.
#[inline(always)]
pub fn ddy_fine(v: &F32s) -> F32s {
    let mut d = F32s::ZERO;
    for q in 0..QUADS {
        let left = v[2 * QUADS + q] - v[q];
        let right = v[3 * QUADS + q] - v[QUADS + q];
        d[q] = left;
        d[QUADS + q] = right;
        d[2 * QUADS + q] = left;
        d[3 * QUADS + q] = right;
    }
    d
}

/// The differences within each quad of the first `axes` coordinates.
#[inline(always)]
pub fn quad_derivatives(coords: [&F32s; 3], axes: usize) -> [[F32s; 3]; 2] {
    let mut out = [[F32s::ZERO; 3]; 2];
    for (axis, from) in coords.into_iter().enumerate().take(axes) {
        out[0][axis] = ddx_fine(from);
        out[1][axis] = ddy_fine(from);
    }
    out
}

/// ρ² of two axes.
#[inline(always)]
pub fn rho_squared(d: &Derivatives<'_>, scale: [f32; 3], lane: usize) -> f32 {
    let u = [d.dx[0][lane] * scale[0], d.dy[0][lane] * scale[0]];
    let v = [d.dx[1][lane] * scale[1], d.dy[1][lane] * scale[1]];
    rho_squared_of(u, v)
}

/// ρ² from the derivatives of u and of v along x and y, in texels.
#[inline(always)]
pub fn rho_squared_of([dudx, dudy]: [f32; 2], [dvdx, dvdy]: [f32; 2]) -> f32 {
    max(dudx * dudx + dvdx * dvdx, dudy * dudy + dvdy * dvdy)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::LANES;

    #[test]
    fn differences_are_taken_row_by_row_and_column_by_column() {
        let v = F32s::from_fn(|lane| [1.0, 3.0, 10.0, 17.0][lane / QUADS]);
        let (dx, dy) = (ddx_fine(&v), ddy_fine(&v));
        for lane in 0..LANES {
            assert_eq!(dx[lane], [2.0, 2.0, 7.0, 7.0][lane / QUADS]);
            assert_eq!(dy[lane], [9.0, 14.0, 9.0, 14.0][lane / QUADS]);
        }
    }
}
