//! The arrays of 64 and the place of each lane in its 8×8 block.

use bytemuck::{Pod, Zeroable};
use std::mem::MaybeUninit;

/// Lanes in a batch: an 8×8 pixel block, 16 quads, or 64 vertices.
pub const LANES: usize = 64;
/// Quads of 2×2 pixels in a batch.
pub const QUADS: usize = LANES / 4;

macro_rules! batch {
    ($(#[$doc:meta])* $Name:ident, $T:ty) => {
        $(#[$doc])*
        #[repr(C, align(64))]
        #[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
        pub struct $Name(pub [$T; LANES]);

        impl $Name {
            /// The same value in every lane.
            #[inline(always)]
            pub const fn splat(value: $T) -> Self {
                Self([value; LANES])
            }

            /// The value of each lane as a function of its index.
            #[inline(always)]
            pub fn from_fn(mut f: impl FnMut(usize) -> $T) -> Self {
                let mut out = Self::ZERO;
                for lane in 0..LANES {
                    out.0[lane] = f(lane);
                }
                out
            }

            /// [`Self::from_fn`] of what is long, and without storing zeros first.
            #[inline(always)]
            pub fn of(f: impl PerLane<$T>) -> Self {
                let mut out = MaybeUninit::<Self>::uninit();
                for lane in 0..LANES {
                    // SAFETY: a batch is its 64 values, one after the other.
                    unsafe { out.as_mut_ptr().cast::<$T>().add(lane).write(f.at(lane)) };
                }
                // SAFETY: all of them were written.
                unsafe { out.assume_init() }
            }

            /// Zero in every lane.
            pub const ZERO: Self = Self([0 as $T; LANES]);
        }

        impl Default for $Name {
            fn default() -> Self {
                Self::ZERO
            }
        }

        impl std::ops::Index<usize> for $Name {
            type Output = $T;
            #[inline(always)]
            fn index(&self, lane: usize) -> &$T {
                &self.0[lane]
            }
        }

        impl std::ops::IndexMut<usize> for $Name {
            #[inline(always)]
            fn index_mut(&mut self, lane: usize) -> &mut $T {
                &mut self.0[lane]
            }
        }
    };
}

batch!(
    /// 64 `f32`.
    F32s, f32
);
batch!(
    /// 64 `f64`.
    F64s, f64
);
batch!(
    /// 64 `i32`.
    I32s, i32
);
batch!(
    /// 64 `u32`: raw bits, texels, or a mask whose lanes are 0 or `!0`.
    U32s, u32
);

/// A function of a lane. (A closure that is long would not be inlined, and take on no instruction set.)
pub trait PerLane<T> {
    /// What it is at a lane. `#[inline(always)]`, see [`super::Kernel`].
    fn at(&self, lane: usize) -> T;
}

macro_rules! casts {
    ($From:ident, $To:ident, $name:ident, $name_mut:ident) => {
        impl $From {
            /// The same bits under another type.
            #[inline(always)]
            pub fn $name(&self) -> &$To {
                bytemuck::cast_ref(self)
            }
            /// The same bits under another type.
            #[inline(always)]
            pub fn $name_mut(&mut self) -> &mut $To {
                bytemuck::cast_mut(self)
            }
        }
    };
}
casts!(U32s, F32s, as_f32, as_f32_mut);
casts!(U32s, I32s, as_i32, as_i32_mut);
casts!(F32s, U32s, as_u32, as_u32_mut);
casts!(I32s, U32s, as_u32, as_u32_mut);

/// A lane's column in its 8×8 block, 0 to 7 (quad-planar order, see the module's text).
#[inline(always)]
pub const fn lane_x(lane: usize) -> usize {
    (lane % QUADS % 4) * 2 + (lane / QUADS) % 2
}

/// A lane's row in its 8×8 block, 0 to 7 (quad-planar order, see the module's text).
#[inline(always)]
pub const fn lane_y(lane: usize) -> usize {
    (lane % QUADS / 4) * 2 + lane / (2 * QUADS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lanes_of_a_block_are_its_64_pixels_in_quads() {
        let mut seen = [[false; 8]; 8];
        for lane in 0..LANES {
            let (x, y) = (lane_x(lane), lane_y(lane));
            assert!(!seen[y][x]);
            seen[y][x] = true;
            let quad = lane % QUADS;
            assert_eq!((x / 2, y / 2), (quad % 4, quad / 4));
        }
    }
}
