//! Planes at the pixels of a batch, divided by the denominator plane for perspective (GL 2.1, equation 3.6), and the
//! derivatives of the quotients.

use super::inputs::InterpolationSource;
use crate::attachment::value_at;
use crate::ir::Axis;
use texunit::lanes::{F32s, Kernel, LANES, QUADS, Simd, U32s};

/// Column of each pixel of a quad.
pub const X: [f32; 4] = [0.0, 1.0, 0.0, 1.0];
/// Row of each pixel of a quad.
pub const Y: [f32; 4] = [0.0, 0.0, 1.0, 1.0];

/// A plane divided by the denominator plane, given the inverse of the latter. If both are equal the quotient is exactly
/// 1: a varying that is 1 at all vertices is 1 everywhere.
#[inline(always)]
pub fn divided<S: Simd>(
    source: &impl InterpolationSource,
    [plane, denominator]: [usize; 2],
    inverse: &F32s,
) -> F32s {
    let mut out = evaluate::<S>(source, plane);
    if !source.may_be_equal::<S>([plane, denominator]) {
        for lane in 0..LANES {
            out[lane] *= inverse[lane];
        }
        return out;
    }
    let (of, by) = (source.plane(plane), source.plane(denominator));
    let is_one = |pixel, quad| of(pixel, quad) == by(pixel, quad);
    let [a, b, c, d] = pixels(&mut out);
    divide_pixel(is_one, 0, inverse, a);
    divide_pixel(is_one, 1, inverse, b);
    divide_pixel(is_one, 2, inverse, c);
    divide_pixel(is_one, 3, inverse, d);
    out
}

/// One pixel of each quad times the inverse, or 1.
#[inline(always)]
fn divide_pixel(
    is_one: impl Fn(usize, usize) -> bool,
    pixel: usize,
    inverse: &F32s,
    out: &mut [f32; QUADS],
) {
    for (quad, out) in out.iter_mut().enumerate() {
        let quotient = *out * inverse[pixel * QUADS + quad];
        *out = if is_one(pixel, quad) { 1.0 } else { quotient };
    }
}

/// [`divided`], and its derivatives across and up. One loop, as all three share the quotient.
#[inline(always)]
pub fn with_slopes<S: Simd>(
    source: &impl InterpolationSource,
    planes: [usize; 2],
    inverse: &F32s,
) -> [F32s; 3] {
    S::outlined_unless_wide(WithSlopes { source, planes, inverse })
}

struct WithSlopes<'a, P> {
    source: &'a P,
    planes: [usize; 2],
    inverse: &'a F32s,
}

impl<P: InterpolationSource> Kernel for WithSlopes<'_, P> {
    type Output = [F32s; 3];
    #[inline(always)]
    fn run<S: Simd>(self) -> [F32s; 3] {
        let Self { source, planes: [plane, denominator], inverse } = self;
        let mut all = [F32s::ZERO; 3];
        let [value, across, up] = all.each_mut().map(pixels);
        let planes = (source.plane(plane), source.plane(denominator));
        for pixel in 0..4 {
            let out = (&mut value[pixel], &mut across[pixel], &mut up[pixel]);
            with_slopes_pixel(source, &planes, pixel, inverse, out);
        }
        all
    }
}

/// One pixel of each quad of it, and of its slopes.
#[inline(always)]
fn with_slopes_pixel(
    source: &impl InterpolationSource,
    (of, by): &(impl Fn(usize, usize) -> [f32; 3], impl Fn(usize, usize) -> [f32; 3]),
    pixel: usize,
    inverse: &F32s,
    (value, across, up): (&mut [f32; QUADS], &mut [f32; QUADS], &mut [f32; QUADS]),
) {
    for quad in 0..QUADS {
        let (of, by, inverse) = (of(pixel, quad), by(pixel, quad), inverse[pixel * QUADS + quad]);
        let quotient = value_at(of, source.position_in_block(pixel, quad)) * inverse;
        value[quad] = if of == by { 1.0 } else { quotient };
        across[quad] = slope(along(Axis::X, of), along(Axis::X, by), quotient, inverse);
        up[quad] = slope(along(Axis::Y, of), along(Axis::Y, by), quotient, inverse);
    }
}

/// How a plane changes along an axis.
#[inline(always)]
pub fn along(axis: Axis, [_, a, b]: [f32; 3]) -> f32 {
    match axis {
        Axis::X => a,
        Axis::Y => b,
    }
}

/// The inverse of each lane; without perspective all are equal, and one division suffices.
#[inline(always)]
pub fn invert<S: Simd>(lanes: &mut F32s) {
    let first = lanes[0].to_bits();
    let mut different = U32s::ZERO;
    for lane in 0..LANES {
        different[lane] = lanes[lane].to_bits() ^ first;
    }
    if !S::any(&different) {
        *lanes = F32s::splat(1.0 / lanes[0]);
        return;
    }
    for lane in 0..LANES {
        lanes[lane] = 1.0 / lanes[lane];
    }
}

/// A plane at every lane.
#[inline(always)]
pub fn evaluate<S: Simd>(source: &impl InterpolationSource, plane: usize) -> F32s {
    S::outlined_unless_wide(Evaluate { source, plane })
}

struct Evaluate<'a, P> {
    source: &'a P,
    plane: usize,
}

impl<P: InterpolationSource> Kernel for Evaluate<'_, P> {
    type Output = F32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> F32s {
        evaluate_plane(self.source, self.source.plane(self.plane))
    }
}

/// [`evaluate`], of planes that the caller has.
#[inline(always)]
pub fn evaluate_plane(
    source: &impl InterpolationSource,
    plane: impl Fn(usize, usize) -> [f32; 3],
) -> F32s {
    let mut out = F32s::ZERO;
    let [first, second, third, fourth] = pixels(&mut out);
    evaluate_pixel(source, &plane, 0, first);
    evaluate_pixel(source, &plane, 1, second);
    evaluate_pixel(source, &plane, 2, third);
    evaluate_pixel(source, &plane, 3, fourth);
    out
}

/// A plane at one pixel of each quad.
#[inline(always)]
fn evaluate_pixel(
    source: &impl InterpolationSource,
    plane: &impl Fn(usize, usize) -> [f32; 3],
    pixel: usize,
    out: &mut [f32; QUADS],
) {
    for (quad, out) in out.iter_mut().enumerate() {
        *out = value_at(plane(pixel, quad), source.position_in_block(pixel, quad));
    }
}

/// The derivative of the quotient of two planes, given the steps of both:
/// `(n / d)' = (n' - n / d · d') / d`, of `n / d` and `1 / d`.
#[inline(always)]
fn slope(of: f32, by: f32, quotient: f32, inverse: f32) -> f32 {
    (of - quotient * by) * inverse
}

/// A plane at every lane, moved so far across and up from the pixel's centre.
#[inline(always)]
pub fn evaluate_moved<S: Simd>(
    source: &impl InterpolationSource,
    plane: usize,
    [x, y]: &[F32s; 2],
) -> F32s {
    let mut out = evaluate::<S>(source, plane);
    let plane = source.plane(plane);
    for lane in 0..LANES {
        let [_, a, b] = plane(lane / QUADS, lane % QUADS);
        out[lane] += x[lane] * a + y[lane] * b;
    }
    out
}

/// The lanes by pixel of the quad. A loop over pixels around a loop over quads would be vectorized
/// the wrong way round, with scattered stores.
#[inline(always)]
fn pixels(lanes: &mut F32s) -> &mut [[f32; QUADS]; 4] {
    bytemuck::cast_mut(&mut lanes.0)
}

#[cfg(test)]
mod tests {
    use super::super::batch::{BlockOf, EarlyTests};
    use super::*;
    use crate::desc::Facing;
    use proptest::prelude::*;
    use texunit::lanes::Isa;

    /// The quotient of two planes, plain and with its slopes.
    struct PlainAndWithSlopes<'a>(&'a BlockOf<'a>, [usize; 2]);

    impl Kernel for PlainAndWithSlopes<'_> {
        type Output = (F32s, F32s, [F32s; 3]);
        fn run<S: Simd>(self) -> Self::Output {
            let Self(block, planes) = self;
            let mut inverse = evaluate::<S>(block, planes[1]);
            invert::<S>(&mut inverse);
            let plain = divided::<S>(block, planes, &inverse);
            (inverse, plain, with_slopes::<S>(block, planes, &inverse))
        }
    }

    fn number() -> impl Strategy<Value = f32> {
        prop_oneof![-2.0..2.0f32, Just(0.0), Just(-0.0), Just(1.0), -1e30..1e30f32]
    }

    proptest! {
        #[test]
        fn slopes_come_with_the_same_quotient(
            of in prop::array::uniform3(number()), by in prop::array::uniform3(number()), same: bool,
        ) {
            let planes = [if same { by } else { of }, by];
            let block = BlockOf {
                planes: &planes,
                facing: Facing::Front,
                tests: EarlyTests::Due,
                block: 0,
                x: 0,
                y: 0,
                coverage: None,
            };
            for isa in Isa::available() {
                let (inverse, plain, [value, across, up]) = isa.run(PlainAndWithSlopes(&block, [0, 1]));
                for lane in 0..LANES {
                    let at = block.position_in_block(lane / QUADS, lane % QUADS);
                    let quotient = value_at(planes[0], at) * inverse[lane];
                    let slope = |axis: usize| {
                        (planes[0][axis] - quotient * planes[1][axis]) * inverse[lane]
                    };
                    let is_same = |a: f32, b: f32| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
                    prop_assert!(is_same(value[lane], plain[lane]), "{} lane {lane}", isa.name());
                    prop_assert!(is_same(across[lane], slope(1)), "{} lane {lane}", isa.name());
                    prop_assert!(is_same(up[lane], slope(2)), "{} lane {lane}", isa.name());
                }
            }
        }
    }
}
