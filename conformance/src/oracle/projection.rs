//! Projective texture coordinates (section 3.8.8: `s/q`, `t/q`; GLSL 1.20, section 8.7:
//! `texture2DProj`).

use crate::mutation::{Mutation, Variant};

/// (s, t) of the coordinates (s, t, r, q).
pub fn divide([s, t, r, q]: [f64; 4], variant: Variant) -> [f64; 2] {
    if variant.has(Mutation::MissingDivide) {
        [s, t]
    } else if variant.has(Mutation::DivideOfSOnly) {
        [s / q, t]
    } else if variant.has(Mutation::DivideByW) {
        [s / r, t / r]
    } else {
        [s / q, t / q]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn by_hand() {
        assert_eq!(divide([1.0, 3.0, 9.0, -2.0], Variant::CORRECT), [-0.5, -1.5]);
    }
}
