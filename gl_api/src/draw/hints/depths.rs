//! Depths of the picture before, where only its colours were cleared: the new one fails against them.

use crate::context::Context;
use crate::context::recorder::depths::{Colors, Depths, Drawn};
use crate::context::said::Hint;
use rasterizer::driver::DepthState;

const OLD: &str = "draw: glClear cleared the colours since the last picture, but not the depths, against which \
    GL_DEPTH_TEST compares: what is drawn may be hidden behind what was: call \
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT), while glDepthMask is GL_TRUE (GL 2.1, section 4.2.3)";

impl Depths {
    /// Takes note that a picture is taken.
    fn picture(&mut self) {
        self.colors = Colors::Kept;
        self.drawn = match self.drawn {
            Drawn::Nothing => Drawn::Nothing,
            Drawn::Now | Drawn::Before => Drawn::Before,
        };
    }
}

/// Looks at the depth test of a draw.
pub(crate) fn check(context: &mut Context, depth: Option<&DepthState>) {
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
pub(crate) fn picture(context: &mut Context) {
    context.window.depths.picture();
}
