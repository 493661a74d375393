//! Draws that follow one another with nothing in between: what was decided for the first holds for the
//! others. Where primitives have no vertices in common, such draws are one.
//!
//! A draw costs what hundreds of vertices do, and programs draw sprite by sprite, or call
//! `glMultiDrawArrays`.

use crate::context::Context;
use crate::context::ended::vertices_of_primitive;
use crate::context::recorder::elements::Elements;
use crate::context::recorder::repeat::{Joined, Repeat, is_whole};
use crate::context::recorder::{Recorder, Told};
use crate::draw::reach::all_have;
use rasterizer::driver::{Buffer, Command, IndexType, Indices, PipelineDesc, Topology};
use rasterizer::ir::Stmt;

/// Draws of more vertices cost little beside them, and are left alone.
const FEW: u32 = 1 << 10;
/// So many vertices are not joined by others.
const MOST: u32 = 1 << 16;

/// Remembers the draw that this call has just recorded, of arrays whole.
pub(crate) fn keep(context: &mut Context, topology: Topology, count: u32) {
    let joined = if is_whole(topology, count) { Joined::NotYet } else { Joined::Never };
    let repeat = Repeat { at: context.changes.calls, topology, arrays: None, joined };
    context.recorder.told.repeat = Some(repeat);
}

/// Whether draws have all that they need from the one before: nobody else changes objects, and nobody asks
/// what each has done.
pub(crate) fn is_plain(context: &Context) -> bool {
    context.is_alone()
        && context.compiling.is_none()
        && context.watched.is_none()
        && !context.transform_feedback.is_active()
}

/// Draws, if nothing but draws has happened since the one before, and nothing has to be said of this one.
pub(crate) fn repeat(context: &mut Context, topology: Topology, elements: &Elements) -> bool {
    context.changes.nothing();
    let Some(last) = &context.recorder.told.repeat else { return false };
    let changed = context.changes.state.max(context.changes.numbers);
    if changed > last.at || last.topology != topology || context.recorder.is_full() {
        return false;
    }
    let known = last.arrays.or_else(|| is_plain(context).then(|| all_have(context)));
    let Some([vertices, most]) = known else { return false };
    let (count, instances) = elements.counts();
    let is_inside = match elements {
        Elements::Range { first, .. } => {
            first.checked_add(count).is_some_and(|end| end <= vertices)
        }
        Elements::Indexed { .. } => !context.debug.listens(),
    };
    if !is_whole(topology, count) || !is_inside || instances.end > most {
        return false;
    }
    // Counts primitives; nothing is captured.
    if crate::draw::capture::draw(context, topology, &[], elements).is_err() {
        return false;
    }
    context.recorder.repeat(context.changes.calls, known, elements);
    true
}

impl Recorder {
    fn repeat(&mut self, at: u64, arrays: Option<[u32; 2]>, elements: &Elements) {
        let Told { repeat: Some(last), pipeline: Some(desc), .. } = &mut self.told else { return };
        self.draws += 1;
        (last.at, last.arrays) = (at, arrays);
        if last.joined == Joined::NotYet && !may_join(desc) {
            last.joined = Joined::Never;
        }
        let (count, instances) = elements.counts();
        if last.joined != Joined::Never && instances == (0..1) && count <= FEW {
            self.held += count as usize * size_of::<u32>();
            if join(&mut self.commands.commands, &mut last.joined, elements) {
                return;
            }
        }
        if last.joined == Joined::Some {
            last.joined = Joined::NotYet;
        }
        self.push_draw(elements);
    }
}

/// Whether it makes no difference if primitives are drawn together or one after the other: they have no
/// vertices in common, a program does not count them, and none is left out because another's shader does
/// not end.
fn may_join(desc: &PipelineDesc) -> bool {
    let [vertex, fragment] = [desc.vertex.module(), desc.fragment.module()];
    vertices_of_primitive(desc.topology).is_some()
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

/// Adds vertices to the last draw, if it is a small one.
fn join(commands: &mut [Command], joined: &mut Joined, elements: &Elements) -> bool {
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
        if *joined == Joined::Some && *count <= MOST {
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
    if count > FEW || instances != (0..1) {
        return false;
    }
    let mut bytes = Vec::new();
    append(&mut bytes, &before);
    append(&mut bytes, elements);
    let indices =
        Indices { buffer: Buffer::new(bytes), offset: 0, ty: IndexType::U32, base_vertex: 0 };
    *command = Command::DrawIndexed { indices, count: count + more, instances };
    *joined = Joined::Some;
    true
}

/// Appends the numbers of vertices.
fn append(bytes: &mut Vec<u8>, elements: &Elements) {
    let (count, _) = elements.counts();
    bytes.extend((0..count).flat_map(|at| elements.number(at).to_le_bytes()));
}
