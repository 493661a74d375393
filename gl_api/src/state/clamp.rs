//! Colour clamping: `glClampColor` (`ARB_color_buffer_float`).
//!
//! Colours of the state (fog, environments, the alpha reference, blending, clearing, borders) are stored unclamped, and
//! clamped where they are used or queried.

use crate::base::clamp::Clamp;
use texunit::format::Format;

/// When colours are clamped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum When {
    Always,
    Never,
    /// If all colour buffers are fixed-point (`GL_FIXED_ONLY`).
    Fixed,
}

impl When {
    pub(crate) fn now(self, mut formats: impl Iterator<Item = Format>) -> Clamp {
        match self {
            Self::Always => Clamp::On,
            Self::Never => Clamp::Off,
            Self::Fixed if formats.all(is_fixed) => Clamp::On,
            Self::Fixed => Clamp::Off,
        }
    }
}

/// What `glClampColor` sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ClampState {
    /// Colours of vertices, lit or not.
    pub vertex: When,
    /// Colours of fragments, from their first to what is written.
    pub fragment: When,
    /// Colours that `glReadPixels` gives.
    pub read: When,
}

impl Default for ClampState {
    fn default() -> Self {
        Self { vertex: When::Always, fragment: When::Fixed, read: When::Fixed }
    }
}

/// Whether a buffer of this format is fixed-point.
fn is_fixed(format: Format) -> bool {
    format.info().encoding.range().is_some()
}
