//! Depths of the picture before, where only its colours were cleared: the new one fails against them.

use crate::context::Context;
use crate::context::said::Hint;
use rasterizer::driver::{ClearValue, DepthState, DepthWrite};
use texunit::sampler::Compare;

/// Which picture has left depths in a window, and whether the picture that is drawn began with a clear of its colours.
#[derive(Debug, Default)]
pub(crate) struct Depths {
    drawn: Drawn,
    colors: Colors,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Drawn {
    /// Nothing was since they were cleared.
    #[default]
    Nothing,
    /// This picture.
    Now,
    /// One before.
    Before,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Colors {
    #[default]
    Kept,
    Cleared,
}

const OLD: &str = "draw: glClear cleared the colours since the last picture, but not the depths, against which \
    GL_DEPTH_TEST compares: what is drawn may be hidden behind what was: call \
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT), while glDepthMask is GL_TRUE (GL 2.1, section 4.2.3)";

impl Depths {
    /// Takes note of what is cleared.
    pub fn clear(&mut self, clears: &[ClearValue]) {
        for value in clears {
            match value {
                ClearValue::Color { .. } | ClearValue::Texel { .. } => {
                    self.colors = Colors::Cleared
                }
                ClearValue::Depth(_) => self.drawn = Drawn::Nothing,
                ClearValue::Stencil { .. } => {}
            }
        }
    }

    /// Takes note that a picture is taken.
    fn picture(&mut self) {
        self.colors = Colors::Kept;
        self.drawn = match self.drawn {
            Drawn::Nothing => Drawn::Nothing,
            Drawn::Now | Drawn::Before => Drawn::Before,
        };
    }

    /// Takes note of a draw; says whether it is compared with what a picture before has left.
    fn draw(&mut self, depth: &DepthState) -> bool {
        let compares = depth.test != Compare::Always;
        let is_hidden = compares && (self.drawn, self.colors) == (Drawn::Before, Colors::Cleared);
        if depth.write == DepthWrite::On && (self.drawn == Drawn::Nothing || !compares) {
            self.drawn = Drawn::Now;
        }
        is_hidden
    }
}

/// Looks at the depth test of a draw.
pub(in crate::draw) fn check(context: &mut Context, depth: Option<&DepthState>) {
    let Some(depth) = depth.filter(|_| context.state.bindings.draw_framebuffer == 0) else {
        return;
    };
    if context.window.depths.draw(depth) {
        hidden(context);
    }
}

#[cold]
#[inline(never)]
fn hidden(context: &mut Context) {
    if context.is_news(Hint::OldDepths, 0) {
        context.debug.warn(OLD.to_owned());
    }
}

/// Takes note that a picture is taken.
pub(super) fn picture(context: &mut Context) {
    context.window.depths.picture();
}
