//! What every instruction set gives, against plain arithmetic.

use super::*;
use crate::lanes::LANES;
use crate::lanes::math;
use crate::lanes::{F32s, Simd, U32s};

struct Largest<'a>(&'a U32s);
impl Kernel for Largest<'_> {
    type Output = u32;
    #[inline(always)]
    fn run<S: Simd>(self) -> u32 {
        S::largest(self.0)
    }
}

#[test]
fn the_largest_word_is_found_wherever_it_lies() {
    for isa in Isa::available() {
        for lane in 0..LANES {
            for value in [1, 0x7FFF_FFFF, u32::MAX] {
                let mut words = U32s::ZERO;
                words[lane] = value;
                assert_eq!(isa.run(Largest(&words)), value, "{} lane {lane}", isa.name());
            }
        }
    }
}

struct FloorSmall<'a>(&'a F32s);
impl Kernel for FloorSmall<'_> {
    type Output = [U32s; 2];
    #[inline(always)]
    fn run<S: Simd>(self) -> [U32s; 2] {
        let (mut wholes, mut numbers) = (U32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            let (whole, number) = S::floor_small(self.0[lane]);
            wholes[lane] = whole as u32;
            numbers[lane] = number.to_bits();
        }
        [wholes, numbers]
    }
}

#[test]
fn the_floor_of_small_numbers_is_the_same_everywhere() {
    for start in [-0.0, 0.5, -7.25, 4_000_000.5, -4_000_000.5, 1e-30, -1e-30] {
        let x = U32s::from_fn(|lane| (start + lane as f32 * start * 1e-4).to_bits());
        for isa in Isa::available() {
            let [whole, number] = isa.run(FloorSmall(x.as_f32()));
            for lane in 0..LANES {
                let (want, floor) = math::floor_small(x.as_f32()[lane]);
                let found = (whole[lane] as i32, number[lane]);
                assert_eq!(found, (want, floor.to_bits()), "{} {start} {lane}", isa.name());
            }
        }
    }
}

struct Nonzero<'a>(&'a U32s);
impl Kernel for Nonzero<'_> {
    type Output = (u64, bool);
    #[inline(always)]
    fn run<S: Simd>(self) -> (u64, bool) {
        (S::nonzero(self.0), S::any(self.0))
    }
}

struct Below<'a>(&'a U32s, u32);
impl Kernel for Below<'_> {
    type Output = bool;
    #[inline(always)]
    fn run<S: Simd>(self) -> bool {
        S::below(self.0, self.1)
    }
}

#[test]
fn one_lane_that_is_not_below_is_noticed_wherever_it_lies() {
    for isa in Isa::available() {
        for bound in [1, 255, 1 << 31, u32::MAX] {
            let mut words = U32s::splat(bound - 1);
            assert!(isa.run(Below(&words, bound)), "{}", isa.name());
            assert!(!isa.run(Below(&words, 0)), "{}", isa.name());
            for lane in 0..LANES {
                for word in [bound, u32::MAX] {
                    words[lane] = word;
                    assert!(!isa.run(Below(&words, bound)), "{} lane {lane}", isa.name());
                }
                words[lane] = 0;
            }
        }
    }
}

#[test]
fn the_lanes_that_are_not_zero_are_bits() {
    for isa in Isa::available() {
        assert_eq!(isa.run(Nonzero(&U32s::ZERO)), (0, false));
        for value in [1, 0x80, 1 << 31, u32::MAX] {
            let words = U32s::from_fn(|lane| if lane * lane % 7 == 2 { value } else { 0 });
            let want = (0..LANES).fold(0, |bits, lane| bits | u64::from(words[lane] != 0) << lane);
            assert_eq!(isa.run(Nonzero(&words)), (want, true), "{}", isa.name());
        }
    }
}
