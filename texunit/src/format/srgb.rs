//! The sRGB transfer function, as two tables made at compile time from exact arithmetic.
//!
//! EXT_texture_sRGB, section 3.8.x: with `c` the byte over 255,
//! `linear = c / 12.92` up to `c = 0.04045`, else `((c + 0.055) / 1.055)^2.4`.
//! `x^2.4` is `x² · (x^(1/5))²`, and the fifth root comes from Newton's iteration in `f64`, so that
//! no platform's `pow` takes part.

/// Linear light of each sRGB byte, the nearest `f32`.
pub static DECODE: [f32; 256] = {
    let mut table = [0.0; 256];
    let mut byte = 0;
    while byte < 256 {
        table[byte] = linear(byte as f64 / 255.0) as f32;
        byte += 1;
    }
    table
};

/// `THRESHOLDS[k]` is the least `f32` whose encoding is nearer to `k + 1` than to `k`: the linear
/// light of `(k + 1/2) / 255`, rounded up. The last entry, which nothing reaches, fills the table
/// up to a power of two.
pub static THRESHOLDS: [f32; 256] = {
    let mut table = [f32::INFINITY; 256];
    let mut k = 0;
    while k < 255 {
        let exact = linear((k as f64 + 0.5) / 255.0);
        let nearest = exact as f32;
        table[k] = if (nearest as f64) < exact { nearest.next_up() } else { nearest };
        k += 1;
    }
    table
};

/// The sRGB byte nearest to linear light `x` on the encoded scale. Clamps; NaN gives 0.
#[inline(always)]
pub fn encode(x: f32) -> u8 {
    // A binary search without branches: `byte` thresholds are known to be at or below `x`.
    let mut byte = 0;
    let mut step = 128;
    while step > 0 {
        byte += if x >= THRESHOLDS[(byte + step - 1) & 255] { step } else { 0 };
        step /= 2;
    }
    byte as u8
}

/// Linear light of an sRGB value in 0 to 1.
pub(super) const fn linear(c: f64) -> f64 {
    if c <= 0.04045 {
        c / 12.92
    } else {
        let x = (c + 0.055) / 1.055;
        let root = fifth_root(x);
        x * x * (root * root)
    }
}

/// `x^(1/5)` for `x` in 0.05 to 1, where 12 of Newton's steps from 1 reach the last bit.
const fn fifth_root(x: f64) -> f64 {
    let mut root = 1.0;
    let mut step = 0;
    while step < 12 {
        let fourth = root * root * root * root;
        root -= (root - x / fourth) / 5.0;
        step += 1;
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_the_formula() {
        for (byte, &got) in DECODE.iter().enumerate() {
            let c = byte as f64 / 255.0;
            let want = if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
            assert_eq!(got, want as f32, "byte {byte}");
        }
    }

    #[test]
    fn every_byte_survives_a_round_trip() {
        for byte in 0..=255u8 {
            assert_eq!(encode(DECODE[usize::from(byte)]), byte);
        }
    }

    #[test]
    fn a_threshold_belongs_to_the_upper_byte_and_what_is_below_it_to_the_lower() {
        for k in 0..255u8 {
            let threshold = THRESHOLDS[usize::from(k)];
            assert_eq!(encode(threshold), k + 1);
            assert_eq!(encode(threshold.next_down()), k);
        }
    }

    #[test]
    fn anything_else_clamps() {
        for (x, want) in [
            (-1.0, 0),
            (-0.0, 0),
            (f32::NAN, 0),
            (f32::NEG_INFINITY, 0),
            (1.0, 255),
            (7.0, 255),
            (f32::INFINITY, 255),
        ] {
            assert_eq!(encode(x), want, "{x}");
        }
    }
}
