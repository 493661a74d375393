//! The versions of the language.

/// A version that `#version` can select, in the order of features: GLSL ES 1.00 comes after 1.10, of which it is
/// nearly a subset, and GLSL ES 3.00 after 3.30, of which it has most.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Version {
    /// GLSL 1.10, the version of a shader without `#version`.
    V110,
    /// GLSL ES 1.00.
    Es100,
    /// GLSL 1.20.
    V120,
    /// GLSL 1.30.
    V130,
    /// GLSL 1.40.
    V140,
    /// GLSL 1.50.
    V150,
    /// GLSL 3.30.
    V330,
    /// GLSL ES 3.00.
    Es300,
}

impl Version {
    /// Every version.
    pub const ALL: [Self; 8] = [
        Self::V110,
        Self::Es100,
        Self::V120,
        Self::V130,
        Self::V140,
        Self::V150,
        Self::V330,
        Self::Es300,
    ];
    /// The newest version, which stands in for unknown ones.
    pub const NEWEST: Self = Self::V330;

    /// Whether it is a version of GLSL ES.
    pub fn is_es(self) -> bool {
        match self {
            Self::Es100 | Self::Es300 => true,
            Self::V110 | Self::V120 | Self::V130 | Self::V140 | Self::V150 | Self::V330 => false,
        }
    }

    /// The number that `#version` takes and `__VERSION__` gives.
    pub fn number(self) -> i32 {
        match self {
            Self::V110 => 110,
            Self::Es100 => 100,
            Self::V120 => 120,
            Self::V130 => 130,
            Self::V140 => 140,
            Self::V150 => 150,
            Self::V330 => 330,
            Self::Es300 => 300,
        }
    }

    /// The title of its specification.
    pub fn title(self) -> &'static str {
        match self {
            Self::V110 => "GLSL 1.10",
            Self::Es100 => "GLSL ES 1.00",
            Self::V120 => "GLSL 1.20",
            Self::V130 => "GLSL 1.30",
            Self::V140 => "GLSL 1.40",
            Self::V150 => "GLSL 1.50",
            Self::V330 => "GLSL 3.30",
            Self::Es300 => "GLSL ES 3.00",
        }
    }
}
