//! Draws that follow one another with nothing in between: what was decided for the first holds for the
//! others. Where primitives have no vertices in common, such draws are one.
//!
//! A draw costs what hundreds of vertices do, and programs draw sprite by sprite, or call
//! `glMultiDrawArrays`.

use super::ended::vertices_of_primitive;
use super::reach::all_have;
use super::translate::Elements;
use super::{Recorder, Told};
use crate::context::Context;
use crate::transform_feedback;
use rasterizer::driver::{Buffer, Command, IndexType, Indices, PipelineDesc, Topology};
use rasterizer::ir::Stmt;

/// Draws of more vertices cost little beside them, and are left alone.
const FEW: u32 = 1 << 10;
/// So many vertices are not joined by others.
const MOST: u32 = 1 << 16;

/// The draw before, which is the last command of the open pass.
#[derive(Debug)]
pub(super) struct Repeat {
    /// How many calls there had been, or at the last which has joined it.
    at: u64,
    topology: Topology,
    /// How many vertices and instances all arrays have, once somebody has asked.
    arrays: Option<[u32; 2]>,
    joined: Joined,
}

/// Whether others may join a draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Joined {
    /// They may not.
    Never,
    /// None has.
    NotYet,
    /// Its indices are those of several.
    Some,
}

/// Remembers the draw that this call has just recorded, of arrays whole.
pub(super) fn keep(context: &mut Context, topology: Topology, count: u32) {
    let joined = if is_whole(topology, count) { Joined::NotYet } else { Joined::Never };
    let repeat = Repeat { at: context.changes.calls, topology, arrays: None, joined };
    context.recorder.told.repeat = Some(repeat);
}

/// Whether no vertex is left over.
pub(super) fn is_whole(topology: Topology, count: u32) -> bool {
    vertices_of_primitive(topology).is_none_or(|each| (count as usize).is_multiple_of(each))
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
pub(super) fn repeat(context: &mut Context, topology: Topology, elements: &Elements) -> bool {
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
    if transform_feedback::draw(context, topology, &[], elements).is_err() {
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

    /// Records the draw of what is bound.
    pub(super) fn push_draw(&mut self, elements: &Elements) {
        self.commands.push(match elements {
            Elements::Range { first, count, instances } => {
                Command::Draw { first: *first, count: *count, instances: instances.clone() }
            }
            Elements::Indexed { indices, count, instances } => {
                self.held += indices.buffer.own_bytes();
                let (indices, instances) = (indices.clone(), instances.clone());
                Command::DrawIndexed { indices, count: *count, instances }
            }
        });
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

#[cfg(test)]
mod tests {
    use crate::constants::*;
    use crate::context::{Context, ContextDesc};
    use crate::entry::Data;
    use rasterizer::driver::Command;

    /// The vertices of each recorded draw.
    fn draws(c: &Context) -> Vec<u32> {
        let commands = c.recorder.commands.commands.iter();
        let counts = commands.filter_map(|command| match command {
            Command::Draw { count, .. } | Command::DrawIndexed { count, .. } => Some(*count),
            _ => None,
        });
        counts.collect()
    }

    fn context() -> Context {
        let mut c = Context::new(ContextDesc::default()).expect("a device");
        c.bind_buffer(GL_ARRAY_BUFFER, 1);
        c.buffer_data(GL_ARRAY_BUFFER, 800, Data::Null, GL_STATIC_DRAW);
        c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
        c.enable_client_state(GL_VERTEX_ARRAY);
        c
    }

    #[test]
    fn draws_of_whole_primitives_with_nothing_in_between_are_one() {
        let mut c = context();
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        c.draw_arrays(GL_TRIANGLES, 3, 3);
        assert_eq!(draws(&c), [6]);
        c.multi_draw_arrays(GL_TRIANGLES, &[30, 9], &[3, 6], 2);
        c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, Data::Bytes(&[1, 2, 3]));
        assert_eq!(draws(&c), [18]);
        c.draw_arrays(GL_POINTS, 0, 1);
        c.draw_arrays(GL_TRIANGLES, 0, 4);
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        assert_eq!(draws(&c), [18, 1, 4, 3]);
        assert_eq!(c.get_error(), GL_NO_ERROR);
        c.draw_arrays(GL_TRIANGLES, 99, 3);
        assert_eq!((draws(&c).len(), c.get_error()), (4, GL_INVALID_OPERATION));
    }

    fn filter(c: &mut Context, filter: u32) {
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter as i32);
    }

    fn mode(c: &mut Context, mode: u32) {
        c.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode as i32);
    }

    #[test]
    fn calls_that_change_nothing_are_as_if_there_were_none() {
        let mut c = context();
        let mut calls = 0;
        let mut between = |call: fn(&mut Context), joins: bool| {
            c.draw_arrays(GL_TRIANGLES, 0, 3);
            call(&mut c);
            let before = draws(&c).len();
            c.draw_arrays(GL_TRIANGLES, 0, 3);
            calls += 1;
            assert_eq!(draws(&c).len() == before, joins, "call {calls}");
            assert_eq!(c.get_error(), GL_NO_ERROR);
        };
        for joins in [false, true] {
            between(|c| c.enable(GL_DEPTH_TEST), joins);
            between(|c| c.enable(GL_LIGHT3), joins);
            between(|c| c.bind_texture(GL_TEXTURE_2D, 3), joins);
        }
        between(|c| c.disable(GL_FOG), true);
        between(|c| c.disable(GL_DEPTH_TEST), false);
        between(|c| filter(c, GL_LINEAR), true);
        between(|c| filter(c, GL_NEAREST), false);
        between(|c| filter(c, GL_NEAREST), true);
        between(|c| mode(c, GL_MODULATE), true);
        between(|c| mode(c, GL_REPLACE), false);
        between(|c| mode(c, GL_REPLACE), true);
    }

    #[test]
    fn others_are_told_nothing_but_their_vertices() {
        let mut c = context();
        c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
        let before = c.recorder.commands.commands.len();
        c.draw_arrays(GL_TRIANGLE_STRIP, 4, 4);
        c.draw_arrays_instanced(GL_TRIANGLE_STRIP, 0, 4, 7);
        assert_eq!(c.recorder.commands.commands.len(), before + 2);
        c.color_3f(1.0, 0.0, 0.0);
        c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
        assert!(c.recorder.commands.commands.len() > before + 3);
        // A list may be called with other state.
        c.new_list(1, GL_COMPILE_AND_EXECUTE);
        (0..2).for_each(|_| c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4));
        c.end_list();
        let recorded = draws(&c).len();
        c.call_list(1);
        assert_eq!(draws(&c).len(), recorded + 2);
    }
}
