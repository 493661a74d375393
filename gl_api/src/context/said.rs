//! What was said already. A draw that repeats would repeat its warnings: each is made once.

use super::Context;
use super::debug::Output;
use std::collections::BTreeSet;

/// More than this is not said.
const MOST: usize = 1024;

/// What there is to say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Hint {
    NoViewport,
    NoScissor,
    NoColor,
    NoColorBuffer,
    NoColorOfShader,
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
    NoList,
    NoUniform,
    NoAttribute,
}

/// What was said, and of what.
#[derive(Debug)]
pub(crate) struct Said {
    keys: BTreeSet<u32>,
    /// Whether the program asked for it then.
    output: Output,
}

impl Default for Said {
    fn default() -> Self {
        Self { keys: BTreeSet::new(), output: Output::Off }
    }
}

impl Context {
    /// Whether this is to be said of a subject (a name, mostly): once, and once more where the program
    /// begins to ask for messages. The text is made afterwards.
    #[cold]
    #[inline(never)]
    pub(crate) fn is_news(&mut self, hint: Hint, subject: u32) -> bool {
        let output = self.debug.output;
        if self.said.output != output {
            self.said = Said { keys: BTreeSet::new(), output };
        }
        let key = (hint as u32) << 24 | (subject & 0xff_ffff);
        self.said.keys.len() < MOST && self.said.keys.insert(key)
    }
}
