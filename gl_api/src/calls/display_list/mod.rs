//! Recording calls into a display list, and calling it: GL 2.1, section 5.4. What a list records is described in
//! [`crate::context::lists`].

pub(crate) mod primitives;

use crate::base::begin_end::BeginEnd;
use crate::base::error::Result;
use crate::base::memory::out_of_memory;
use crate::base::types::*;
use crate::context::Context;
use crate::context::immediate::Slot;
use crate::context::lists::primitives::OpenPrimitives;
use crate::context::lists::{ArrayDraw, ListMode, RecordedCall, Step};
use crate::context::recorder::elements::Elements;
use crate::draw::completeness::checked_drawable;
use crate::draw::record::draw;
use crate::pixel::store::PixelStore;
use rasterizer::driver::{Topology, VertexBinding, VertexSource};
use std::collections::TryReserveError;

impl Context {
    /// Records a call, with the unpack state that its pixels lie by if it has any.
    pub(crate) fn record_call(
        &mut self,
        name: &'static str,
        begin_end: BeginEnd,
        unpack: Option<Box<PixelStore>>,
        run: RecordedCall,
    ) {
        self.record_step(Step::Call { name, begin_end, unpack, run });
    }

    /// Carries something out that may stand between `glBegin` and `glEnd`, or records it, if a list
    /// is compiled.
    ///
    /// # Errors
    /// Those of `run`, where it is carried out.
    pub(crate) fn run_or_record(
        &mut self,
        name: &'static str,
        run: impl Fn(&mut Self) -> Result<()> + Send + Sync + 'static,
    ) -> Result<()> {
        if self.compiling.is_none() {
            return run(self);
        }
        self.record_call(name, BeginEnd::Allowed, None, Box::new(run));
        Ok(())
    }

    /// Records a step; what was open before it is closed first.
    fn record_step(&mut self, step: Step) {
        self.finish_open();
        self.keep_steps(vec![step]);
    }

    /// Adds steps to the list, and carries them out if it is to be carried out, too.
    fn keep_steps(&mut self, steps: Vec<Step>) {
        // What a list does is not recorded again.
        let Some(mut compiling) = self.compiling.take() else { return };
        if let Err(error) = compiling.steps.try_reserve(steps.len()) {
            self.compiling = Some(compiling);
            let name = steps.first().map_or("glEnd", Step::name);
            return self.no_memory_for_list(name, error);
        }
        if compiling.mode == ListMode::CompileAndExecute {
            for step in &steps {
                self.run_step(step);
            }
        }
        compiling.steps.extend(steps);
        self.compiling = Some(compiling);
    }

    /// What there is no memory for is not in the list.
    #[cold]
    #[inline(never)]
    fn no_memory_for_list(&mut self, name: &'static str, error: TryReserveError) {
        self.refuse(
            name,
            out_of_memory("GL 2.1, section 5.4", "what the display list records")(error),
        );
    }

    /// Ends a `glBegin` that the list leaves open.
    pub(crate) fn finish_open(&mut self) {
        let Some(compiling) = &mut self.compiling else { return };
        if let Some(open) = compiling.open.take() {
            compiling.begun = true;
            self.keep_calls(open);
        }
    }

    /// Adds the calls of a primitive one by one.
    fn keep_calls(&mut self, open: OpenPrimitives) {
        match open.into_steps() {
            Ok(steps) => self.keep_steps(steps),
            Err(error) => self.no_memory_for_list("glBegin", error),
        }
    }

    /// Records `glBegin`, if a list is compiled.
    pub(crate) fn record_begin(&mut self, mode: GLenum) -> bool {
        self.finish_open();
        let nested = self.immediate.is_some();
        let Some(compiling) = &mut self.compiling else { return false };
        let open = OpenPrimitives::new(mode);
        if nested || compiling.begun {
            self.keep_calls(open);
        } else {
            compiling.open = Some(open);
        }
        true
    }

    /// Records `glEnd`, if a list is compiled.
    pub(crate) fn record_end(&mut self) -> bool {
        let Some(compiling) = &mut self.compiling else { return false };
        compiling.begun = false;
        let steps = match compiling.open.take() {
            Some(open) => open.close(),
            None => Ok(vec![primitives::end_step()]),
        };
        match steps {
            Ok(steps) => self.keep_steps(steps),
            Err(error) => self.no_memory_for_list("glEnd", error),
        }
        true
    }

    /// Records an attribute, if a list is compiled.
    pub(crate) fn record_attribute(&mut self, slot: Slot, value: [f32; 4]) -> bool {
        let Some(compiling) = &mut self.compiling else { return false };
        match &mut compiling.open {
            Some(open) => {
                if let Err(error) = open.push(slot, value) {
                    self.no_memory_for_list("glVertex", error);
                }
            }
            None => self.keep_steps(vec![Step::Attribute(slot, value)]),
        }
        true
    }

    /// Records a draw of vertex arrays, if a list is compiled; else gives its parts back.
    pub(crate) fn record_arrays(
        &mut self,
        topology: Topology,
        vertices: Vec<VertexBinding>,
        elements: Elements,
    ) -> Option<(Vec<VertexBinding>, Elements)> {
        if self.compiling.is_none() {
            return Some((vertices, elements));
        }
        self.record_step(Step::Arrays(ArrayDraw { topology, vertices, elements }));
        None
    }

    /// A draw of nothing: it is still an error between `glBegin` and `glEnd`, and where the framebuffer is
    /// incomplete. Recorded, if a list is compiled.
    pub(crate) fn empty_draw(&mut self, name: &'static str) -> Result<()> {
        let run = |context: &mut Self| checked_drawable(context);
        if self.compiling.is_none() {
            return run(self);
        }
        let step =
            Step::Call { name, begin_end: BeginEnd::Refused, unpack: None, run: Box::new(run) };
        self.record_step(step);
        Ok(())
    }

    pub(crate) fn run_step(&mut self, step: &Step) {
        match step {
            Step::Call { name, begin_end, unpack, run } => {
                let before = unpack.as_ref().map(|store| {
                    let bound = std::mem::take(&mut self.state.bindings.pixel_unpack_buffer);
                    (std::mem::replace(&mut self.state.unpack, (**store).clone()), bound)
                });
                self.call(name, *begin_end, &**run);
                if let Some((store, buffer)) = before {
                    self.state.unpack = store;
                    self.state.bindings.pixel_unpack_buffer = buffer;
                }
            }
            Step::Attribute(slot, value) => self.call("glCallList", BeginEnd::Allowed, |context| {
                crate::calls::vertex::immediate::attribute(context, *slot, *value)
            }),
            Step::Primitives(shapes) => {
                for part in shapes.parts(self) {
                    self.call("glBegin", BeginEnd::Allowed, |context| shapes.draw(context, part));
                }
            }
            Step::Arrays(arrays) => {
                self.call("glDrawArrays", BeginEnd::Refused, |context| arrays.draw(context));
            }
        }
    }
}

impl ArrayDraw {
    fn draw(&self, context: &mut Context) -> Result<()> {
        let vertices = self
            .vertices
            .iter()
            .map(|binding| VertexBinding {
                location: binding.location,
                source: match &binding.source {
                    VertexSource::Constant(_) => {
                        VertexSource::Constant(context.state.current[usize::from(binding.location)])
                    }
                    array @ VertexSource::Array { .. } => array.clone(),
                },
            })
            .collect();
        draw(context, self.topology, vertices, &self.elements)
    }
}
