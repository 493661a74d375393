//! Polynomials by Estrin's scheme: pairs of coefficients, pairs of pairs, and so on. What does not depend on one
//! another is computed side by side; Horner's scheme, of as many operations less two or three, waits for each of them.

/// `c[0] + c[1] x + c[2] x² + …`, of at most 16 coefficients.
#[inline(always)]
pub(super) fn polynomial<const N: usize>(x: f64, c: &[f64; N]) -> f64 {
    const { assert!(N <= 16) };
    let x2 = x * x;
    let x4 = x2 * x2;
    let low = eight(c, 0, [x, x2, x4]);
    if N > 8 { low + eight(c, 8, [x, x2, x4]) * (x4 * x4) } else { low }
}

/// Those from the coefficient `first` on, by it and up to seven more.
#[inline(always)]
fn eight<const N: usize>(c: &[f64; N], first: usize, [x, x2, x4]: [f64; 3]) -> f64 {
    let low = four(c, first, [x, x2]);
    if N > first + 4 { low + four(c, first + 4, [x, x2]) * x4 } else { low }
}

/// By it and up to three more.
#[inline(always)]
fn four<const N: usize>(c: &[f64; N], first: usize, [x, x2]: [f64; 2]) -> f64 {
    let low = two(c, first, x);
    if N > first + 2 { low + two(c, first + 2, x) * x2 } else { low }
}

/// By it and the next, if there is one.
#[inline(always)]
fn two<const N: usize>(c: &[f64; N], first: usize, x: f64) -> f64 {
    if N > first + 1 { c[first] + c[first + 1] * x } else { c[first] }
}

#[cfg(test)]
mod tests {
    use super::polynomial;

    fn horner(x: f64, c: &[f64]) -> f64 {
        c.iter().rev().fold(0.0, |sum, c| sum * x + c)
    }

    /// Whole numbers, whose sums and products are exact in any order.
    #[test]
    fn every_coefficient_has_its_power() {
        const C: [f64; 16] =
            [3.0, -1.0, 4.0, 1.0, -5.0, 9.0, 2.0, -6.0, 5.0, 3.0, 5.0, -8.0, 9.0, 7.0, -9.0, 3.0];
        fn check<const N: usize>() {
            let c: [f64; N] = C[..N].try_into().expect("N of them");
            for x in [0.0, 1.0, -1.0, 2.0, -3.0] {
                assert_eq!(polynomial(x, &c), horner(x, &c), "{N} at {x}");
            }
        }
        check::<1>();
        check::<2>();
        check::<3>();
        check::<5>();
        check::<7>();
        check::<8>();
        check::<9>();
        check::<12>();
        check::<15>();
        check::<16>();
    }
}
