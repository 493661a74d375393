//! Draws that differ from the draw before in nothing but values (uniform words, as matrices are, contents of buffers, and
//! where vertices are read from) and the textures of a program: they use its shaders and pipeline, which
//! `context/recorder/emitted_state.rs` keeps, and its textures where none were bound since.

use crate::context::Context;
use crate::context::recorder::batching::makes_whole_primitives;
use crate::context::recorder::elements::Elements;
use crate::context::recorder::emitted_state::{DrawDecisions, arrays};
use crate::context::recorder::fixed_function::StageKeys;
use crate::context::recorder::stages::Textures;
use crate::draw::no_effect;
use crate::objects::target::TextureTarget;
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
            textures_call: context.state_changes.calls,
            plain: PlainState::of(&context.state),
            topology,
            arrays: arrays(vertices).collect(),
            keys,
        }
    }

    /// Whether nothing but values, and which textures are bound, has changed since.
    fn hold(&self, context: &Context) -> bool {
        let changes = &context.state_changes;
        changes.last_state_change.max(changes.last_program_change) <= self.call
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

/// What a draw that uses the decisions of the one before emits instead.
pub(crate) struct ChangedValues {
    pub words: Vec<u32>,
    /// Of the vertex, the geometry and the fragment stage, where others may be bound.
    pub textures: Option<[Textures; 3]>,
}

/// What a draw that uses the decisions of the one before emits; `None` where it has to be decided anew.
pub(crate) fn values(
    context: &mut Context,
    topology: Topology,
    vertices: &[VertexBinding],
    elements: &Elements,
) -> Option<ChangedValues> {
    let mut decided = context.recorder.emitted.decisions.take()?;
    let is_alike = topology == decided.topology
        // Else there is a warning to give.
        && makes_whole_primitives(topology, elements.counts().0)
        && arrays(vertices).eq(decided.arrays.iter().copied())
        && allows_reuse(context)
        && !context.queries.discards()
        && !context.recorder.is_full()
        && decided.hold(context);
    let values = if is_alike { changed_values(context, &mut decided) } else { None };
    // Where a texture was drawn to, that pass has ended, and its state with it.
    let values = values.filter(|_| context.recorder.emitted.pipeline.is_some());
    if values.is_some() {
        context.recorder.emitted.decisions = Some(decided);
    }
    values
}

fn changed_values(context: &mut Context, decided: &mut DrawDecisions) -> Option<ChangedValues> {
    let words = crate::draw::stages::words(context, &decided.keys)?;
    let are_bound_anew = context.state_changes.last_binding_change > decided.textures_call;
    let textures = if are_bound_anew || reads_buffer_texture(context) {
        // The fixed function's shaders depend on what is bound.
        if decided.keys.fragment.is_some() {
            return None;
        }
        decided.textures_call = context.state_changes.calls;
        Some(crate::draw::stages::textures(context, &words)?)
    } else {
        None
    };
    Some(ChangedValues { words, textures })
}

/// Whether the program in use reads texels of a buffer, which change without a call of textures.
fn reads_buffer_texture(context: &Context) -> bool {
    let slots = context.executable().map_or(&[][..], |linked| &linked.program.samplers);
    slots.iter().any(|slot| TextureTarget::of_sampler(slot.dim) == TextureTarget::Buffer)
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
