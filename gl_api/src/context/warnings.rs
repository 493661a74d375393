//! The draw warnings that were given already: a draw that is repeated would repeat its warnings.

use super::Context;
use super::debug::Output;
use std::collections::BTreeSet;

/// No more than this many warnings are given.
const MAX_WARNINGS: usize = 1024;

/// A warning of a call that is legal but may not be meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DrawWarning {
    NoViewport,
    NoScissor,
    NoColor,
    NoColorBuffer,
    NoColorOfShader,
    KeptColors,
    NothingRasterized,
    NoStipple,
    OtherTexels,
    NoDepth,
    NoStencil,
    NoLight,
    NoArray,
    ShortArray,
    Remainder,
    NoComparison,
    FeedbackLoop,
    NothingSeen,
    OldDepths,
    UndefinedDepths,
    ClearDepth,
    DepthNever,
    NoNear,
    StencilFails,
    AlphaFails,
    NoAlpha,
    BlackModulate,
    FailedLink,
    MissingArray,
    NoTexCoord,
    TexturingOff,
    UnitOff,
    NoList,
    NoUniform,
    NoAttribute,
    NoTexels,
    OtherFramebuffer,
    NothingDrawn,
    OtherLocation,
    Useless,
    ZeroUniform,
    LightsBehind,
}

/// The warnings that were given, by warning and subject.
#[derive(Debug)]
pub(crate) struct GivenWarnings {
    keys: BTreeSet<u32>,
    /// Whether messages were logged then.
    output: Output,
}

impl Default for GivenWarnings {
    fn default() -> Self {
        Self { keys: BTreeSet::new(), output: Output::Off }
    }
}

impl Context {
    /// Whether a warning is due for a subject (an object name, mostly): the first time, and once more when
    /// `GL_DEBUG_OUTPUT` has changed since. Callers make the text only then.
    #[cold]
    #[inline(never)]
    pub(crate) fn is_first_warning(&mut self, warning: DrawWarning, subject: u32) -> bool {
        let output = self.debug.output;
        if self.given_warnings.output != output {
            self.given_warnings = GivenWarnings { keys: BTreeSet::new(), output };
        }
        let key = (warning as u32) << 24 | (subject & 0xff_ffff);
        self.given_warnings.keys.len() < MAX_WARNINGS && self.given_warnings.keys.insert(key)
    }
}
