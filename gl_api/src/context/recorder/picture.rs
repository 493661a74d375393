//! What is remembered of the draws since the last picture was taken, for warnings of an empty one.

use crate::base::types::GLuint;

/// The draws since the last picture.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PictureDraws {
    /// The framebuffer of the last draw.
    pub framebuffer: Option<GLuint>,
    /// How many draws were recorded before.
    pub draws_before: u64,
    /// Why the last one that was not drawn at all was not.
    pub left_out: Option<LeftOut>,
    pub lights: LightsSeen,
}

/// Why a draw is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LeftOut {
    /// It has no vertices or no instances.
    Empty(&'static str),
    /// The query of `glBeginConditionalRender` counted no samples.
    Condition,
}

/// Which faces the lights shone on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum LightsSeen {
    /// No draw was lit.
    #[default]
    None,
    /// All faces have their backs to all lights, one of them this normal.
    Behind([f32; 3]),
    /// Some draw may have got light.
    Shine,
}
