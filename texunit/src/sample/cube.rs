//! Which face a direction meets, and where (GL 2.1, section 3.8.6, table 3.19).
//!
//! The derivatives of the face coordinates are those of the projection at the pixel itself,
//! `∂(sc/|ma|) = (∂sc·|ma| - sc·∂|ma|) / ma²`, applied to the derivatives of the direction. A quad
//! that straddles an edge of the cube thus needs no neighbour's coordinates on another face.

use crate::lanes::{F32s, I32s, LANES, U32s};
use std::ops::Neg;

/// Directions projected onto the faces they meet.
pub struct Projected {
    /// Per lane 0 to 5: +X, -X, +Y, -Y, +Z, -Z.
    pub face: U32s,
    /// Coordinates on the face, 0 to 1; NaN for the zero direction and infinite ones.
    pub st: [F32s; 2],
    /// `sc/|ma|` and `tc/|ma|`.
    pub ratio: [F32s; 2],
    /// `|ma|`.
    pub major: F32s,
}

impl Projected {
    /// Nothing yet.
    pub const ZERO: Self =
        Self { face: U32s::ZERO, st: [F32s::ZERO; 2], ratio: [F32s::ZERO; 2], major: F32s::ZERO };
}

/// Projects 64 directions. Of equal magnitudes the earlier axis is taken.
#[inline(always)]
pub fn project(direction: [&F32s; 3], to: &mut Projected) {
    let Projected { face, st: [s, t], ratio: [across, up], major } = to;
    for lane in 0..LANES {
        let [x, y, z] = [direction[0][lane], direction[1][lane], direction[2][lane]];
        let of = select(x, y, z);
        let [sc, tc, ma] = to_face_axes(of, x, y, z);
        let (u, v) = (sc / ma, tc / ma);
        face[lane] = of;
        major[lane] = ma;
        across[lane] = u;
        up[lane] = v;
        s[lane] = 0.5 * (u + 1.0);
        t[lane] = 0.5 * (v + 1.0);
    }
}

/// Reprojects points beyond an edge of their face to the face that their direction meets: face, s and t.
#[inline(always)]
pub fn reproject(face: &U32s, st: [&F32s; 2]) -> (U32s, [F32s; 2]) {
    let (mut faces, mut out) = (*face, [*st[0], *st[1]]);
    for lane in 0..LANES {
        let (sc, tc) = (2.0 * st[0][lane] - 1.0, 2.0 * st[1][lane] - 1.0);
        let [x, y, z] = from_face_axes(face[lane], sc, tc, 1.0);
        let new_face = select(x, y, z);
        let [u, v, ma] = to_face_axes(new_face, x, y, z);
        // False for NaN.
        let beyond = (sc.abs() > 1.0) | (tc.abs() > 1.0);
        faces[lane] = if beyond { new_face } else { face[lane] };
        out[0][lane] = if beyond { 0.5 * (u / ma + 1.0) } else { st[0][lane] };
        out[1][lane] = if beyond { 0.5 * (v / ma + 1.0) } else { st[1][lane] };
    }
    (faces, out)
}

/// The derivatives of the face coordinates along x and y, given those of the direction.
#[inline(always)]
pub fn derivatives(on: &Projected, dx: [&F32s; 3], dy: [&F32s; 3], to: &mut [[F32s; 2]; 2]) {
    let [[dsdx, dtdx], [dsdy, dtdy]] = to;
    let Projected { face, ratio: [across, up], major, .. } = on;
    for lane in 0..LANES {
        let (face, u, v, ma) = (face[lane], across[lane], up[lane], major[lane]);
        let [dsc, dtc, dma] = to_face_axes(face, dx[0][lane], dx[1][lane], dx[2][lane]);
        dsdx[lane] = 0.5 * ((dsc - u * dma) / ma);
        dtdx[lane] = 0.5 * ((dtc - v * dma) / ma);
        let [dsc, dtc, dma] = to_face_axes(face, dy[0][lane], dy[1][lane], dy[2][lane]);
        dsdy[lane] = 0.5 * ((dsc - u * dma) / ma);
        dtdy[lane] = 0.5 * ((dtc - v * dma) / ma);
    }
}

/// The bit that negates a number.
const SIGN: u32 = 1 << 31;

#[inline(always)]
fn select(x: f32, y: f32, z: f32) -> u32 {
    let (ax, ay, az) = (x.abs(), y.abs(), z.abs());
    let on_x = (ax >= ay) & (ax >= az);
    let on_y = ay >= az;
    let not_x = if on_y { y } else { z };
    let major = if on_x { x } else { not_x };
    let not_x = if on_y { 2 } else { 4 };
    let positive = if on_x { 0 } else { not_x };
    positive | if major < 0.0 { 1 } else { 0 }
}

/// `(sc, tc, |ma|)` of table 3.19: linear in the direction, so that its derivative is itself.
///
/// The sign of the face negates ma, and sc on the X and Z faces, and tc on the Y faces; sc on the X faces and tc on
/// the X and Z faces are negated besides.
#[inline(always)]
fn to_face_axes(face: u32, x: f32, y: f32, z: f32) -> [f32; 3] {
    let (on_x, on_y) = (face < 2, face & 2 != 0);
    let sign = face << 31;
    let sc = if on_x { z } else { x };
    let sc_sign = if on_x { sign ^ SIGN } else { sign };
    let tc = if on_y { z } else { y };
    let ma = if on_x {
        x
    } else if on_y {
        y
    } else {
        z
    };
    [
        flip(sc, if on_y { 0 } else { sc_sign }),
        flip(tc, if on_y { sign } else { SIGN }),
        flip(ma, sign),
    ]
}

/// The number, negated where the bit is set.
#[inline(always)]
fn flip(v: f32, sign: u32) -> f32 {
    f32::from_bits(v.to_bits() ^ sign)
}

/// Texels of a cube, found from indices that may lie just beyond a face.
pub struct EdgeTexels {
    /// The face of each texel.
    pub face: U32s,
    /// Its column there.
    pub x: U32s,
    /// Its row there.
    pub y: U32s,
    /// `!0` beyond a corner, where there is no texel; the other fields are then any texel.
    pub missing: U32s,
}

/// The texels at `(i, j) + step` of a face of `size`, of which each index is -1 to `size`. Beyond
/// an edge, the texel of the other face that touches this edge at the same position: with indices
/// doubled and centred, a texel's centre is `(2i + 1 - size, 2j + 1 - size, size)` in `(sc, tc, ma)`,
/// and one beyond an edge is moved onto the edge, where both faces have the same direction.
#[inline(always)]
pub fn across_edge(face: u32, i: &I32s, j: &I32s, step: [i32; 2], size: i32) -> EdgeTexels {
    let mut out =
        EdgeTexels { face: U32s::splat(face), x: U32s::ZERO, y: U32s::ZERO, missing: U32s::ZERO };
    for lane in 0..LANES {
        let sc = clamped(2 * (i[lane] + step[0]) + 1 - size, size);
        let tc = clamped(2 * (j[lane] + step[1]) + 1 - size, size);
        let off_s = (sc == size) | (sc == -size);
        let off_t = (tc == size) | (tc == -size);
        let direction = from_face_axes(face, sc, tc, size);
        // The axis of the adjacent face, and its sign.
        let along =
            if off_s { from_face_axes(face, sc, 0, 0) } else { from_face_axes(face, 0, tc, 0) };
        let [x, y, z] = along;
        let axis = if x != 0 {
            0
        } else if y != 0 {
            2
        } else {
            4
        };
        let other = axis + if x + y + z < 0 { 1 } else { 0 };
        let crossed = off_s | off_t;
        let new_face = if crossed { other } else { face };
        let [sc, tc, _] =
            to_face_axes(new_face, direction[0] as f32, direction[1] as f32, direction[2] as f32);
        let index = |c: f32| clamped_index((c as i32 + size - 1) >> 1, size);
        out.face[lane] = new_face;
        out.x[lane] = index(sc);
        out.y[lane] = index(tc);
        out.missing[lane] = if off_s & off_t { !0 } else { 0 };
    }
    out
}

#[inline(always)]
fn clamped(c: i32, size: i32) -> i32 {
    let low = if c < -size { -size } else { c };
    if low > size { size } else { low }
}

#[inline(always)]
fn clamped_index(index: i32, size: i32) -> u32 {
    let low = if index < 0 { 0 } else { index };
    if low >= size { size as u32 - 1 } else { low as u32 }
}

/// The inverse of [`to_face_axes`]: the direction of `(sc, tc, ma)` on a face.
#[inline(always)]
fn from_face_axes<T: Neg<Output = T>>(face: u32, sc: T, tc: T, ma: T) -> [T; 3] {
    match face {
        0 => [ma, -tc, -sc],
        1 => [-ma, -tc, sc],
        2 => [sc, ma, tc],
        3 => [sc, -ma, -tc],
        4 => [sc, -tc, ma],
        _ => [-sc, -tc, -ma],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_face_is_turned_as_in_table_3_19() {
        // Direction, face, sc, tc, |ma|, written out from the table.
        let cases: [([f32; 3], u32, [f32; 3]); 6] = [
            ([3.0, 1.0, 2.0], 0, [-2.0, -1.0, 3.0]),
            ([-3.0, 1.0, 2.0], 1, [2.0, -1.0, 3.0]),
            ([1.0, 3.0, 2.0], 2, [1.0, 2.0, 3.0]),
            ([1.0, -3.0, 2.0], 3, [1.0, -2.0, 3.0]),
            ([1.0, 2.0, 3.0], 4, [1.0, -2.0, 3.0]),
            ([1.0, 2.0, -3.0], 5, [-1.0, -2.0, 3.0]),
        ];
        for ([x, y, z], face, want) in cases {
            assert_eq!(select(x, y, z), face);
            assert_eq!(to_face_axes(face, x, y, z), want, "face {face}");
        }
    }
}
