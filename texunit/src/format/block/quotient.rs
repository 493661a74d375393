//! Whole numbers over a constant, without a division.

/// The reciprocal of `whole`: its first 13 bits, and the rest.
pub(super) const fn reciprocal(whole: u32) -> [f32; 2] {
    let exact = 1.0 / whole as f64;
    let high = f64::from_bits(exact.to_bits() >> 40 << 40);
    [high as f32, (exact - high) as f32]
}

/// `n / whole`, the nearest `f32`, as a division gives it; `n` is a whole number below 2^11 either
/// way, `reciprocal` that of `whole`.
///
/// The first product is exact, and the second so small that its error moves the sum to another
/// `f32` only where the quotient is within 2^-37 of itself of a tie, which none of them is: the test
/// below tries all.
#[inline(always)]
pub(super) fn quotient(n: f32, [high, low]: [f32; 2]) -> f32 {
    n * high + n * low
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_quotient_that_a_block_can_hold_is_the_divisions() {
        for (whole, largest) in
            [(15, 15), (186, 186), (378, 378), (1785, 1785), (1275, 1275), (889, 889), (635, 635)]
        {
            for n in -largest..=largest {
                let want = n as f32 / whole as f32;
                let got = quotient(n as f32, reciprocal(whole));
                assert_eq!(got.to_bits(), want.to_bits(), "{n} / {whole}");
            }
        }
    }
}
