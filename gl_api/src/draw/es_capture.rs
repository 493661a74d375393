//! What OpenGL ES refuses of draws while transform feedback is active (3.0, section 2.14.2).

use crate::base::error::{Result, invalid_operation};
use crate::context::Context;
use crate::draw::capture::has_room;
use crate::state::transform_feedback::{Active, CapturedPrimitive};
use rasterizer::driver::Topology;

const SECTION: &str = "OpenGL ES 3.0, section 2.14.2";

/// Checks a draw of vertices in their order while OpenGL ES captures them: the mode is the captured one, and all whole
/// primitives have room (3.0, section 2.14.2).
///
/// # Errors
/// `GL_INVALID_OPERATION`.
pub(crate) fn check_draw(
    context: &Context,
    topology: Topology,
    (count, instances): (usize, u64),
) -> Result<()> {
    let Some(active) = captured_in_es(context) else { return Ok(()) };
    if active.kind.topology() != topology {
        let rule = format!("mode must be that of glBeginTransformFeedback: {}", active.kind.noun());
        return invalid_operation(SECTION, rule);
    }
    let whole = count - count % CapturedPrimitive::of(topology).corners();
    let vertices = whole as u64 * instances;
    if !has_room(context, active, vertices) {
        let rule = format!(
            "the buffers of transform feedback have no room for {vertices} vertices more: bind larger ones with \
             glBindBufferBase"
        );
        return invalid_operation(SECTION, rule);
    }
    Ok(())
}

/// Refuses draws by index while OpenGL ES captures vertices (3.0, section 2.14.2).
///
/// # Errors
/// `GL_INVALID_OPERATION`.
pub(crate) fn check_indices(context: &Context) -> Result<()> {
    if captured_in_es(context).is_some() {
        return invalid_operation(
            SECTION,
            "transform feedback captures no draws by index: call glDrawArrays, or \
             glPauseTransformFeedback before",
        );
    }
    Ok(())
}

/// What is captured now, in a context of OpenGL ES.
fn captured_in_es(context: &Context) -> Option<&Active> {
    context.transform_feedback.active.as_ref().filter(|_| context.profile.is_es())
}
