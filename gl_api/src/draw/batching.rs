//! Adds a draw to the draw before: draws that follow one another with nothing in between have the same state, and are
//! one where their primitives share no vertices. `context/recorder/batching.rs` has the draw before.

use crate::context::Context;
use crate::context::pending_primitives::vertices_of_primitive;
use crate::context::recorder::Recorder;
use crate::context::recorder::batching::{BatchState, LastDraw, makes_whole_primitives};
use crate::context::recorder::elements::Elements;
use crate::context::recorder::emitted_state::EmittedState;
use crate::draw::draw_reuse::allows_reuse;
use crate::draw::vertex_range::array_limits;
use rasterizer::driver::{Buffer, Command, IndexType, Indices, PipelineDesc, Topology};
use rasterizer::ir::Stmt;

/// Draws of more vertices than this are not added: the cost of the draw is small beside that of the vertices.
const MAX_ADDED: u32 = 1 << 10;
/// Nothing is added to draws of more vertices than this.
const MAX_BATCH: u32 = 1 << 16;

/// Remembers the draw that this call has recorded from whole buffers, so that later draws can be appended to it.
pub(crate) fn remember_last_draw(context: &mut Context, topology: Topology, count: u32) {
    let batch = if makes_whole_primitives(topology, count) {
        BatchState::Single
    } else {
        BatchState::Closed
    };
    let call = context.state_changes.calls;
    let last_draw = LastDraw { call, topology, array_limits: None, batch };
    // What is known of its vertices need not be true of others.
    let may_follow = !context.recorder.facts.is_of_contents();
    context.recorder.emitted.last_draw = may_follow.then_some(last_draw);
}

/// Appends a draw to the draw before, if only draws were called since and the draw causes no warning; `false` if the
/// draw must be recorded as a draw of its own.
pub(crate) fn try_append(context: &mut Context, topology: Topology, elements: &Elements) -> bool {
    context.state_changes.no_change();
    let Some(last) = &context.recorder.emitted.last_draw else { return false };
    let changes = &context.state_changes;
    let changed = changes.last_decision_change().max(changes.last_value_change);
    // Plain state may be what it was again.
    let plain = context.recorder.emitted.decisions.as_ref().map(|decided| &decided.plain);
    let is_plain_alike = changes.last_plain_change <= last.call
        || plain.is_some_and(|plain| plain.is_of(&context.state));
    if changed > last.call
        || !is_plain_alike
        || last.topology != topology
        || context.recorder.is_full()
    {
        return false;
    }
    let known = last.array_limits.or_else(|| allows_reuse(context).then(|| array_limits(context)));
    let Some([vertices, most]) = known else { return false };
    let (count, instances) = elements.counts();
    let is_inside = match elements {
        Elements::Range { first, .. } => {
            first.checked_add(count).is_some_and(|end| end <= vertices)
        }
        Elements::Indexed { .. } => !context.debug.listens(),
    };
    if !makes_whole_primitives(topology, count) || !is_inside || instances.end > most {
        return false;
    }
    // Counts primitives; nothing is captured.
    if crate::draw::capture::draw(context, (topology, topology), &[], elements).is_err() {
        return false;
    }
    context.recorder.add_draw(context.state_changes.calls, known, elements);
    true
}

impl Recorder {
    fn add_draw(&mut self, call: u64, array_limits: Option<[u32; 2]>, elements: &Elements) {
        let EmittedState { last_draw: Some(last), pipeline: Some(desc), .. } = &mut self.emitted
        else {
            return;
        };
        self.draws += 1;
        (last.call, last.array_limits) = (call, array_limits);
        if last.batch == BatchState::Single && !may_batch(desc) {
            last.batch = BatchState::Closed;
        }
        let (count, instances) = elements.counts();
        if last.batch != BatchState::Closed && instances == (0..1) && count <= MAX_ADDED {
            self.held += count as usize * size_of::<u32>();
            if join(&mut self.commands.commands, &mut last.batch, elements) {
                return;
            }
        }
        if last.batch == BatchState::Indexed {
            last.batch = BatchState::Single;
        }
        self.push_draw(elements);
    }
}

/// Whether primitives give the same picture in one draw as in several: they share no vertices, no shader reads their
/// number, and no shader can exceed its budget, which drops the draw.
fn may_batch(desc: &PipelineDesc) -> bool {
    let [vertex, fragment] = [desc.vertex.module(), desc.fragment.module()];
    vertices_of_primitive(desc.topology).is_some()
        && desc.geometry.is_none()
        && fragment.primitive_id.is_none()
        && !has_loop(&vertex.body)
        && !has_loop(&fragment.body)
}

fn has_loop(block: &[Stmt]) -> bool {
    let has = |stmt: &Stmt| {
        matches!(stmt, Stmt::Loop { .. }) || stmt.blocks().any(|block| has_loop(block))
    };
    block.iter().any(has)
}

/// Adds vertices to the last draw command, if that is small.
fn join(commands: &mut [Command], batch: &mut BatchState, elements: &Elements) -> bool {
    let (more, _) = elements.counts();
    let Some(command) = commands.last_mut() else { return false };
    let before = if let Command::Draw { first, count, instances } = command {
        let end = first.checked_add(*count);
        if let Elements::Range { first, .. } = elements
            && *instances == (0..1)
            && end == Some(*first)
        {
            *count += more;
            return true;
        }
        Elements::Range { first: *first, count: *count, instances: instances.clone() }
    } else if let Command::DrawIndexed { indices, count, instances } = command {
        if *batch == BatchState::Indexed && *count <= MAX_BATCH {
            append(indices.buffer.bytes_mut(), elements);
            *count += more;
            return true;
        }
        let (indices, instances) = (indices.clone(), instances.clone());
        Elements::Indexed { indices, count: *count, instances }
    } else {
        return false;
    };
    let (count, instances) = before.counts();
    if count > MAX_ADDED || instances != (0..1) {
        return false;
    }
    let mut bytes = Vec::new();
    append(&mut bytes, &before);
    append(&mut bytes, elements);
    let indices =
        Indices { buffer: Buffer::new(bytes), offset: 0, ty: IndexType::U32, base_vertex: 0 };
    *command = Command::DrawIndexed { indices, count: count + more, instances };
    *batch = BatchState::Indexed;
    true
}

/// Appends the numbers of vertices.
fn append(bytes: &mut Vec<u8>, elements: &Elements) {
    let (count, _) = elements.counts();
    bytes.extend((0..count).flat_map(|at| elements.number(at).to_le_bytes()));
}
