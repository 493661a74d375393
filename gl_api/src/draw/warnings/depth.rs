//! Warnings of a depth test that no fragment passes: depths that nobody cleared, or cleared against the comparison,
//! those of an earlier picture, and projections that give every vertex the same depth.

use crate::base::compare::COMPARE;
use crate::context::Context;
use crate::context::depth_history::{ColorClear, DepthHistory, DepthProblem, DepthSource};
use crate::context::warnings::DrawWarning;
use glam::{DMat4, DVec3, DVec4};
use rasterizer::driver::{DepthState, PipelineDesc};
use texunit::sampler::Compare;

const OLD: &str = "draw: glClear cleared the colours since the last picture, but not the depths, against which \
    GL_DEPTH_TEST compares: what is drawn may be hidden behind what was: call \
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT), while glDepthMask is GL_TRUE (GL 2.1, section 4.2.3)";
const UNDEFINED: &str = "draw: GL_DEPTH_TEST is enabled, but the depths that it compares with were never cleared, so \
    they are undefined (in DetGL 0, and nothing passes GL_LESS): call glClear(GL_COLOR_BUFFER_BIT | \
    GL_DEPTH_BUFFER_BIT) before the first draw, while glDepthMask is GL_TRUE (GL 2.1, section 4.2.3)";
const NEVER: &str = "draw: GL_DEPTH_TEST is enabled and glDepthFunc is GL_NEVER, so no fragment passes: call \
    glDepthFunc(GL_LESS), or glDisable(GL_DEPTH_TEST) (GL 2.1, section 4.1.6)";
const NO_NEAR: &str = "draw: GL_PROJECTION is a perspective with zNear = 0, so all that is drawn has the same depth, \
    and GL_DEPTH_TEST cannot tell what is in front: call gluPerspective or glFrustum with zNear > 0, such as 0.1 \
    (GL 2.1, section 2.11.2)";

impl DepthHistory {
    /// Notes that a picture is taken.
    fn picture(&mut self) {
        self.color_clear = ColorClear::No;
        self.depths = match self.depths {
            DepthSource::Undefined => DepthSource::Undefined,
            DepthSource::Cleared => DepthSource::Cleared,
            DepthSource::ThisPicture | DepthSource::EarlierPicture => DepthSource::EarlierPicture,
        };
    }
}

/// Checks the depth test of a draw.
pub(crate) fn check(context: &mut Context, desc: &PipelineDesc) {
    let Some(depth) = &desc.depth else { return };
    // The stencil buffer may count what fails.
    if depth.test == Compare::Never && desc.output.stencil.is_none() {
        say(context, DrawWarning::DepthNever, NEVER);
        return;
    }
    if context.state.bindings.draw_framebuffer == 0
        && let Some(problem) = context.window.depths.draw(depth)
    {
        hidden(context, depth, problem);
        return;
    }
    let projection = &context.state.matrices.projection.top;
    if depth.test != Compare::Always && is_without_near(projection) && reads_projection(context) {
        say(context, DrawWarning::NoNear, NO_NEAR);
    }
}

/// Whether a projection divides by the distance and gives all points the same depth, as a near plane at 0 does: z is a
/// multiple of w.
fn is_without_near(projection: &DMat4) -> bool {
    let [z, w] = [projection.row(2), projection.row(3)];
    let divides = w.truncate() != DVec3::ZERO;
    let axis = w.abs().max_position();
    let rest = z - w * (z[axis] / w[axis]);
    divides && z != DVec4::ZERO && rest.abs().max_element() <= 1e-9 * z.abs().max_element()
}

/// Whether the matrix reaches the vertices: those of the fixed function, or of a program that reads state.
fn reads_projection(context: &Context) -> bool {
    context
        .executable()
        .is_none_or(|linked| linked.vertex.is_none() || !linked.program.state.is_empty())
}

#[cold]
#[inline(never)]
fn say(context: &mut Context, warning: DrawWarning, text: &str) {
    if context.is_first_warning(warning, 0) {
        context.debug.warn(text.to_owned());
    }
}

#[cold]
#[inline(never)]
fn hidden(context: &mut Context, depth: &DepthState, problem: DepthProblem) {
    match problem {
        DepthProblem::Undefined => say(context, DrawWarning::UndefinedDepths, UNDEFINED),
        DepthProblem::Stale => say(context, DrawWarning::OldDepths, OLD),
        DepthProblem::ClearedAgainst(stored) => {
            if context.is_first_warning(DrawWarning::ClearDepth, 0) {
                let func = crate::base::constants::enum_name(COMPARE.encode(depth.test));
                let fix = match stored > 0.5 {
                    true => "glDepthFunc(GL_LESS), or glClearDepth(0)",
                    false => "glClearDepth(1), or glDepthFunc(GL_GREATER)",
                };
                context.debug.warn(format!(
                    "draw: glDepthFunc is {func}, and the depths were cleared to {stored} (glClearDepth), so \
                     nothing in front of or behind that depth passes GL_DEPTH_TEST: call {fix}, before glClear \
                     (GL 2.1, section 4.1.6)"
                ));
            }
        }
    }
}

/// Notes that a picture is taken.
pub(crate) fn picture(context: &mut Context) {
    context.window.depths.picture();
}
