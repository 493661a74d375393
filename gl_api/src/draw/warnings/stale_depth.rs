//! The warning of depths that an earlier picture left, where only colours were cleared ([`crate::context::stale_depth`]).

use crate::context::Context;
use crate::context::stale_depth::{ColorClear, DepthHistory, DepthSource};
use crate::context::warnings::DrawWarning;
use rasterizer::driver::DepthState;

const OLD: &str = "draw: glClear cleared the colours since the last picture, but not the depths, against which \
    GL_DEPTH_TEST compares: what is drawn may be hidden behind what was: call \
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT), while glDepthMask is GL_TRUE (GL 2.1, section 4.2.3)";

impl DepthHistory {
    /// Notes that a picture is taken.
    fn picture(&mut self) {
        self.color_clear = ColorClear::No;
        self.depths = match self.depths {
            DepthSource::Cleared => DepthSource::Cleared,
            DepthSource::ThisPicture | DepthSource::EarlierPicture => DepthSource::EarlierPicture,
        };
    }
}

/// Checks the depth test of a draw.
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
    if context.is_first_warning(DrawWarning::OldDepths, 0) {
        context.debug.warn(OLD.to_owned());
    }
}

/// Notes that a picture is taken.
pub(crate) fn picture(context: &mut Context) {
    context.window.depths.picture();
}
