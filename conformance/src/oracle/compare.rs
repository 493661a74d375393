//! Depth comparison, of textures (section 3.8.14) and of fragments (section 4.1.6).

use crate::mutation::{Mutation, Variant};

/// A comparison function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compare {
    /// `GL_NEVER`.
    Never,
    /// `GL_LESS`.
    Less,
    /// `GL_EQUAL`.
    Equal,
    /// `GL_LEQUAL`.
    LessEqual,
    /// `GL_GREATER`.
    Greater,
    /// `GL_NOTEQUAL`.
    NotEqual,
    /// `GL_GEQUAL`.
    GreaterEqual,
    /// `GL_ALWAYS`.
    Always,
}

impl Compare {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Never,
        Self::Less,
        Self::Equal,
        Self::LessEqual,
        Self::Greater,
        Self::NotEqual,
        Self::GreaterEqual,
        Self::Always,
    ];

    /// `incoming OP stored`: the reference `r` with the texel `D`, or the fragment's depth with
    /// the depth buffer's.
    pub fn holds(self, incoming: f64, stored: f64, variant: Variant) -> bool {
        let (a, b) = if variant.has(Mutation::CompareReversed) {
            (stored, incoming)
        } else {
            (incoming, stored)
        };
        let equal = |normally: bool| match (variant, a == b) {
            (v, true) if v.has(Mutation::CompareStrictly) => false,
            (v, true) if v.has(Mutation::CompareLoosely) => true,
            (_, true) => normally,
            (_, false) => false,
        };
        match self {
            Self::Never => false,
            Self::Less => a < b || equal(false),
            Self::Equal => a == b,
            Self::LessEqual => a < b || equal(true),
            Self::Greater => a > b || equal(false),
            Self::NotEqual => a != b,
            Self::GreaterEqual => a > b || equal(true),
            Self::Always => true,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn truth_table() {
        let lower = [false, true, false, true, false, true, false, true];
        let same = [false, false, true, true, false, false, true, true];
        let higher = [false, false, false, false, true, true, true, true];
        for (incoming, row) in [(0.25, lower), (0.5, same), (0.75, higher)] {
            let got = Compare::ALL.map(|f| f.holds(incoming, 0.5, Variant::CORRECT));
            assert_eq!(got, row, "{incoming}");
        }
    }
}
