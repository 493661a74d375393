//! The viewport transform and the clip tests of shaded vertices, 64 at a time.

use crate::desc::{ClipDepth, DepthClip, Viewport};
use crate::sizes::{GUARD_BAND, SUBPIXEL};
use texunit::lanes::{F32s, Kernel, LANES, Simd};

/// The sides of the clip volume that a vertex is outside of, a bit each; from bit 16 on, the user clip planes that it
/// is beyond; from bit 24 on, its negative cull distances.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcode(pub u32);

impl Outcode {
    /// `x < -w`.
    pub const LEFT: u32 = 1;
    /// `x > w`.
    pub const RIGHT: u32 = 2;
    /// `y < -w`.
    pub const BOTTOM: u32 = 4;
    /// `y > w`.
    pub const TOP: u32 = 8;
    /// `z < -w`, or `z < 0` where depths begin at 0.
    pub const NEAR: u32 = 16;
    /// `z > w`.
    pub const FAR: u32 = 32;
    /// `w` is not above zero.
    pub const BEHIND: u32 = 64;
    /// Outside the guard band.
    pub const GUARD: u32 = 128;
    /// A coordinate is inf or NaN: the primitive is dropped.
    pub const INVALID: u32 = 256;
    /// Beyond a user clip plane.
    pub const USER: u32 = 512;
    /// If every vertex is outside of one of these, nothing of a primitive, or of an edge of it, is seen.
    pub const OUTSIDE: u32 =
        Self::LEFT | Self::RIGHT | Self::BOTTOM | Self::TOP | Self::NEAR | Self::FAR | Self::BEHIND;
    /// The cull distances: if one is negative at every vertex, the primitive is rejected. Edges and corners that a polygon
    /// is drawn as are no primitives (`ARB_cull_distance`).
    pub const CULLED: u32 = 0xFF << Self::FIRST_CULL;
    /// If every vertex is outside of one of these, the primitive is rejected.
    pub const REJECT: u32 = Self::OUTSIDE | Self::CULLED;
    /// The bit of the first cull distance.
    pub const FIRST_CULL: u32 = 24;
    /// If any vertex is outside of one of these, the primitive is clipped.
    pub const CUT: u32 = Self::NEAR | Self::FAR | Self::BEHIND | Self::GUARD | Self::USER;

    /// The user clip planes that the vertex is beyond, bit by plane.
    pub fn user(self) -> u8 {
        (self.0 >> 16) as u8
    }
}

/// Adding and subtracting this rounds to an integer, which is then in the lowest bits.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;

/// Viewport transform (GL 2.1, section 2.11.1), snap and clip tests of 64 vertices.
pub(super) struct ViewportTransform<'a> {
    pub clip: [&'a F32s; 4],
    pub viewport: &'a Viewport,
    pub out: &'a mut WindowVertices,
}

/// The positions of 64 vertices.
pub(super) struct WindowVertices {
    pub snapped: [[i32; LANES]; 2],
    pub outcodes: [u32; LANES],
}

impl Kernel for ViewportTransform<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { clip: [x, y, z, w], viewport, out } = self;
        let (half, center) = (viewport.half(), viewport.center());
        // The same operations as `Viewport::window`.
        let mut window = [[0.0; LANES]; 2];
        for (axis, (position, window)) in [x, y].into_iter().zip(&mut window).enumerate() {
            for lane in 0..LANES {
                let ndc = f64::from(position[lane]) / f64::from(w[lane]);
                window[lane] = ndc * half[axis] + center[axis];
            }
            for (to, &window) in out.snapped[axis].iter_mut().zip(&*window) {
                *to = snap(window);
            }
        }
        let [across, up] = &window;
        let bit = |out: bool, bit: u32| if out { bit } else { 0 };
        let clipped = match viewport.depth_clip {
            DepthClip::Cut => !0,
            DepthClip::Clamp => !(Outcode::NEAR | Outcode::FAR),
        };
        // The near plane is at z = near_w · w.
        let near_w = match viewport.clip_control.depth {
            ClipDepth::NegativeOneToOne => -1.0,
            ClipDepth::ZeroToOne => 0.0,
        };
        for lane in 0..LANES {
            let (x, y, z, w) = (x[lane], y[lane], z[lane], w[lane]);
            let inside = |v: f64| v.abs() <= GUARD_BAND;
            let in_band = inside(across[lane]) & inside(up[lane]);
            let finite = x.is_finite() & y.is_finite() & z.is_finite() & w.is_finite();
            let code = bit(x < -w, Outcode::LEFT)
                | bit(x > w, Outcode::RIGHT)
                | bit(y < -w, Outcode::BOTTOM)
                | bit(y > w, Outcode::TOP)
                | bit(z < near_w * w, Outcode::NEAR)
                | bit(z > w, Outcode::FAR)
                | bit(w <= 0.0, Outcode::BEHIND)
                | bit(!in_band, Outcode::GUARD);
            out.outcodes[lane] = if finite { code & clipped } else { Outcode::INVALID };
        }
    }
}

/// To the nearest subpixel, within 24 bits. The clamp acts only where a cut between coordinates of
/// 1e30 and of 1 has rounded to a point outside the guard band; NaN becomes the edge of the band.
#[inline(always)]
pub fn snap(window: f64) -> i32 {
    let window = if window > -GUARD_BAND { window } else { -GUARD_BAND };
    let window = if window < GUARD_BAND { window } else { GUARD_BAND };
    let v = window * f64::from(SUBPIXEL) + 0.5;
    let rounded = v + TO_INTEGER;
    let integer = rounded.to_bits() as i32;
    // Rounded to nearest: subtract one where the rounding was upward.
    integer - i32::from(rounded - TO_INTEGER > v)
}

/// Notes which of 64 vertices have a negative distance, the one of this number.
pub(super) fn note_culled(outcodes: &mut [u32; LANES], number: u8, distances: &F32s) {
    for (outcode, distance) in outcodes.iter_mut().zip(&distances.0) {
        *outcode |= u32::from(*distance < 0.0) << (Outcode::FIRST_CULL + u32::from(number));
    }
}

/// Clip tests against the user clip planes. A NaN distance drops the primitive.
pub(super) fn cut(outcode: &mut u32, distances: &[f32]) {
    for (plane, distance) in distances.iter().enumerate() {
        if !distance.is_finite() {
            *outcode = Outcode::INVALID;
        } else if *distance < 0.0 {
            *outcode |= Outcode::USER | 1 << (16 + plane);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapping_is_the_floor_of_half_a_subpixel_more() {
        for i in -4_000_000..4_000_000_i32 {
            let v = f64::from(i) / 61_440.0 + f64::from(i % 7) * 1e-9;
            assert_eq!(snap(v), (v * 256.0 + 0.5).floor() as i32, "{v}");
        }
        assert_eq!(snap(1e30), 8_388_608);
        assert_eq!(snap(-1e30), -8_388_608);
        assert_eq!(snap(f64::NAN), -8_388_608);
    }
}
