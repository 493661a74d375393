//! The draw before, to which the next may be added: draws that follow one another with nothing in between are one,
//! where their primitives share no vertices.
//!
//! A draw costs what hundreds of vertices do, and programs draw sprite by sprite, or call `glMultiDrawArrays`.
//! `draw/batching.rs` decides.

use crate::context::pending_primitives::vertices_of_primitive;
use crate::context::recorder::Recorder;
use crate::context::recorder::elements::Elements;
use rasterizer::driver::{Command, Topology};

/// The draw before, which is the last command of the open pass.
#[derive(Debug)]
pub(crate) struct LastDraw {
    /// [`crate::context::state_changes::StateChanges::calls`] at its call, or at the last call that was added to it.
    pub call: u64,
    pub topology: Topology,
    /// How many vertices and instances all enabled arrays have, once it was asked for.
    pub array_limits: Option<[u32; 2]>,
    pub batch: BatchState,
}

/// Whether draws can be added to the draw before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BatchState {
    /// None can.
    Closed,
    /// They can; none was.
    Single,
    /// Some were: its indices are those of several draws.
    Indexed,
}

/// Whether a number of vertices makes whole primitives, with no vertex left over.
pub(crate) fn makes_whole_primitives(topology: Topology, count: u32) -> bool {
    vertices_of_primitive(topology).is_none_or(|each| (count as usize).is_multiple_of(each))
}

impl Recorder {
    /// Records a draw with what is bound.
    pub(crate) fn push_draw(&mut self, elements: &Elements) {
        if self.emitted.first_primitive != self.first_primitive {
            self.emitted.first_primitive = self.first_primitive;
            self.commands.push(Command::SetFirstPrimitive(self.first_primitive));
        }
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

#[cfg(test)]
mod tests {
    use crate::base::args::Data;
    use crate::base::constants::*;
    use crate::context::{Context, ContextDesc};
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
