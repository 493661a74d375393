//! The versions of the language.

/// A version that `#version` can ask for, by what it has: GLSL ES 1.00 comes after 1.10, of which
/// it is nearly a subset.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Version {
    /// GLSL 1.10, what a shader without `#version` is written in.
    V110,
    /// GLSL ES 1.00.
    Es100,
    /// GLSL 1.20.
    V120,
    /// GLSL 1.30.
    V130,
    /// GLSL 1.40 as contexts with `GL_ARB_compatibility` have it: with everything of 1.30.
    V140,
}

impl Version {
    /// Every version.
    pub const ALL: [Self; 5] = [Self::V110, Self::Es100, Self::V120, Self::V130, Self::V140];
    /// The newest, which stands in for those that there are not.
    pub const NEWEST: Self = Self::V140;

    /// The number that `#version` takes and `__VERSION__` gives.
    pub fn number(self) -> i32 {
        match self {
            Self::V110 => 110,
            Self::Es100 => 100,
            Self::V120 => 120,
            Self::V130 => 130,
            Self::V140 => 140,
        }
    }

    /// As the specification's title has it.
    pub fn title(self) -> &'static str {
        match self {
            Self::V110 => "GLSL 1.10",
            Self::Es100 => "GLSL ES 1.00",
            Self::V120 => "GLSL 1.20",
            Self::V130 => "GLSL 1.30",
            Self::V140 => "GLSL 1.40",
        }
    }
}
