//! Multisample state: GL 2.1, sections 3.2.1 and 4.1.3; `ARB_texture_multisample`, sections
//! 3.3.1 and 4.1.3.

use crate::base::types::*;
use crate::glsl::limits::MAX_SAMPLE_MASK_WORDS as MASK_WORDS;

/// How many words a sample mask has (`GL_MAX_SAMPLE_MASK_WORDS`).
pub(crate) const MAX_SAMPLE_MASK_WORDS: GLuint = MASK_WORDS as GLuint;

/// What `glSampleCoverage`, `glSampleMaski` and `glMinSampleShading` set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Multisample {
    /// The part of the samples that is kept, from 0 to 1.
    pub value: f32,
    /// Whether the others are kept instead.
    pub invert: bool,
    /// The samples that `GL_SAMPLE_MASK` keeps, bit by sample.
    pub mask: GLbitfield,
    /// The part of the samples that are shaded each by itself, from 0 to 1, where `GL_SAMPLE_SHADING` is enabled.
    pub shaded: f32,
}

impl Default for Multisample {
    fn default() -> Self {
        Self { value: 1.0, invert: false, mask: GLbitfield::MAX, shaded: 0.0 }
    }
}
