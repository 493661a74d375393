//! What a check found.

use serde::Serialize;

/// What an error is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Unit {
    /// Of the range of a colour, depth or datum: 1 is all of it.
    FullScale,
    /// Steps of an 8-bit colour: 1/255.
    Bytes,
    /// Texels of the level.
    Texels,
    /// Levels of detail: λ.
    Levels,
    /// Times that a pixel is drawn.
    Draws,
}

impl Unit {
    /// How many of this unit make a difference of 1 between an expected and a measured value.
    pub fn per_one(self) -> f64 {
        match self {
            Self::Bytes => 255.0,
            Self::FullScale | Self::Texels | Self::Levels | Self::Draws => 1.0,
        }
    }

    /// As it stands behind a number.
    pub fn label(self) -> &'static str {
        match self {
            Self::FullScale => "of range",
            Self::Bytes => "/255",
            Self::Texels => "texels",
            Self::Levels => "levels",
            Self::Draws => "draws",
        }
    }
}

/// How a check ended.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Every error is within the tolerance.
    Pass,
    /// Some error is not.
    Fail,
    /// It could not be measured; says why.
    Broken(String),
}

/// What a check found.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// The check's name.
    pub name: &'static str,
    /// Where the formula stands.
    pub citation: &'static str,
    /// What was checked.
    pub what: &'static str,
    /// How many cases were compared.
    pub cases: u64,
    /// The largest error.
    pub largest_error: f64,
    /// What errors are measured in.
    pub unit: Unit,
    /// The largest error that passes.
    pub tolerance: f64,
    /// Why the tolerance is what it is.
    pub why: &'static str,
    /// The case with the largest error, what was expected and what came; empty without an error.
    pub worst: String,
    /// How long it took.
    pub seconds: f64,
    /// How it ended.
    pub verdict: Verdict,
}
