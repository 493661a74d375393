//! Draws that differ from the draw before in nothing but values (uniform words, as matrices are, and where vertices are
//! read from): they use its shaders, pipeline and textures, which `context/recorder/emitted_state.rs` keeps.

use crate::context::Context;
use crate::context::recorder::batching::makes_whole_primitives;
use crate::context::recorder::elements::Elements;
use crate::context::recorder::emitted_state::{DrawDecisions, arrays};
use crate::context::recorder::fixed_function::StageKeys;
use crate::draw::no_effect;
use crate::state::plain::PlainState;
use rasterizer::driver::{Topology, VertexBinding};

impl DrawDecisions {
    /// The decisions of the draw of this call.
    pub fn new(
        context: &Context,
        topology: Topology,
        vertices: &[VertexBinding],
        keys: StageKeys,
    ) -> Self {
        Self {
            call: context.state_changes.calls,
            plain: PlainState::of(&context.state),
            topology,
            arrays: arrays(vertices).collect(),
            keys,
        }
    }

    /// Whether nothing but values has changed since.
    fn hold(&self, context: &Context) -> bool {
        let changes = &context.state_changes;
        changes.last_state_change <= self.call
            && (changes.last_plain_change <= self.call || self.plain.decides_alike(&context.state))
    }
}

/// The attributes that the draw before read, bit by location, if this draw may use its decisions.
pub(crate) fn attributes(context: &Context) -> Option<u64> {
    let emitted = &context.recorder.emitted;
    let decided = emitted.decisions.as_ref()?;
    let may_be_alike = context.compiling.is_none() && decided.hold(context);
    may_be_alike.then(|| emitted.attributes_read())
}

/// The uniform words of a draw that uses the decisions of the one before; `None` where it has to be decided anew.
pub(crate) fn words(
    context: &mut Context,
    topology: Topology,
    vertices: &[VertexBinding],
    elements: &Elements,
) -> Option<Vec<u32>> {
    let decided = context.recorder.emitted.decisions.take()?;
    let is_alike = topology == decided.topology
        // Else there is a warning to give.
        && makes_whole_primitives(topology, elements.counts().0)
        && arrays(vertices).eq(decided.arrays.iter().copied())
        && allows_reuse(context)
        && !context.queries.discards()
        && !context.recorder.is_full()
        && decided.hold(context);
    let words = if is_alike { crate::draw::stages::words(context, &decided.keys) } else { None };
    context.recorder.emitted.decisions = Some(decided);
    words
}

/// Whether a draw may take over what was decided for the one before: no other context changes objects, and no list,
/// watch or transform feedback needs each draw by itself.
pub(crate) fn allows_reuse(context: &Context) -> bool {
    no_effect::leaves_out(context)
        && context.objects.shared.is_exclusive()
        && context.compiling.is_none()
        && context.watched.is_none()
        && !context.transform_feedback.is_active()
        && !crate::draw::capture::counts_emitted(context)
}
