//! The watched fragment: its inputs, steps, tests and writes.

use super::super::batch::Batch;
use super::Stored;
use crate::desc::{Facing, StencilFace};
use crate::output::{ColorPlan, blend_factors};
use crate::plan::{DrawPlan, FragmentInput, SampleMasks};
use crate::shader::{Invocation, Machine, OverBudget, Tracer};
use crate::trace::{Blending, Fate, Fragment, InputSource, InputValue, Test, When, Write};
use texunit::lanes::{F32s, math};

/// The results of the tests.
pub struct Tested<'a> {
    /// When.
    pub when: When,
    /// By sample.
    pub depths: &'a [f32],
    /// The stencil reference that the shader wrote, if it did.
    pub reference: Option<u8>,
    /// By sample.
    pub before: &'a Stored,
    /// By sample.
    pub after: &'a Stored,
}

impl Tested<'_> {
    /// The tests of a lane's samples, of which `masks` passed.
    pub(super) fn tests(
        &self,
        plan: &DrawPlan,
        facing: Facing,
        masks: &SampleMasks,
        lane: usize,
    ) -> impl Iterator<Item = Test> {
        let face = plan.tests.stencil.map(|stencil| match facing {
            Facing::Front => stencil.front,
            Facing::Back => stencil.back,
        });
        let face = face.map(|face| {
            let reference = self.reference.unwrap_or(face.reference);
            StencilFace { reference, ..face }
        });
        masks.iter().enumerate().filter_map(move |(sample, mask)| {
            Some(Test {
                sample,
                when: self.when,
                depth: *self.depths.get(sample)?,
                depth_test: plan.tests.depth.map(|plan| (plan.test, plan.write)),
                stencil: face,
                before: *self.before.get(sample)?,
                after: *self.after.get(sample)?,
                passed: mask >> lane & 1 == 1,
            })
        })
    }
}

/// The watched fragment while it is shaded.
#[derive(Debug)]
pub struct Shaded {
    pub(super) event: usize,
    /// Its lane of the batch.
    pub lane: usize,
    /// Its record.
    pub fragment: Box<Fragment>,
    /// By plane: the values at the vertices, of varyings.
    pub(super) values: Vec<Vec<f32>>,
}

impl Shaded {
    /// This is how it ends, unless a mask has it.
    pub fn ends_unless_in(&mut self, masks: &SampleMasks, fate: Fate) {
        if masks.iter().all(|mask| mask >> self.lane & 1 == 0) {
            self.fragment.fate = fate;
        }
    }

    /// Runs the fragment program with its steps written down.
    ///
    /// # Errors
    /// When it runs over its budget.
    pub fn run(
        &mut self,
        machine: &mut Machine,
        plan: &DrawPlan,
        batch: &Batch<'_>,
        invocation: Invocation<'_>,
    ) -> Result<u64, OverBudget> {
        self.fragment.fate = if plan.colors.is_empty() { Fate::NoColor } else { Fate::Written };
        self.interpolated(plan, batch, machine);
        let mut tracer = Tracer::new(invocation.program, self.lane);
        let alive = machine.run_traced(invocation, &mut tracer);
        for (index, output) in invocation.program.outputs().enumerate() {
            self.fragment.outputs.push((output, tracer.output(machine, index)));
        }
        (self.fragment.steps, self.fragment.more_steps) = (tracer.steps, tracer.more);
        if alive.is_err() {
            self.fragment.fate = Fate::OverBudget;
        }
        alive
    }

    /// Its inputs were interpolated.
    fn interpolated(&mut self, plan: &DrawPlan, batch: &Batch<'_>, machine: &Machine) {
        let of_program = plan.pipeline.compiled().fragment.inputs();
        let centroids = plan.samples.centroids(batch.masks);
        let at_centroid = |plane: usize| batch.plane_at_moved(plane, self.lane, &centroids);
        for (index, (&input, from)) in of_program.iter().zip(&plan.inputs).enumerate() {
            let values = |plane: usize| self.values.get(plane).cloned().unwrap_or_default();
            let source = match *from {
                FragmentInput::Smooth(plane) => InputSource::Perspective {
                    vertices: values(plane),
                    numerator: batch.plane_at(plane, self.lane),
                    denominator: plan
                        .denominator_plane
                        .map_or(1.0, |at| batch.plane_at(at, self.lane)),
                },
                FragmentInput::SmoothAtCentroid(plane) => InputSource::Perspective {
                    vertices: values(plane),
                    numerator: at_centroid(plane),
                    denominator: plan.denominator_plane.map_or(1.0, at_centroid),
                },
                FragmentInput::Linear(plane) | FragmentInput::LinearAtCentroid(plane) => {
                    InputSource::Linear(values(plane))
                }
                FragmentInput::Flat(_) => InputSource::Flat,
                FragmentInput::SmoothGradient(..) | FragmentInput::LinearGradient(..) => {
                    InputSource::Gradient
                }
                FragmentInput::X
                | FragmentInput::Y
                | FragmentInput::Depth
                | FragmentInput::Front
                | FragmentInput::Coverage
                | FragmentInput::PlaceOfSample(_)
                | FragmentInput::SampleId
                | FragmentInput::SamplePosition(_)
                | FragmentInput::Zero => InputSource::Pixel,
            };
            let bits = machine.input(index)[self.lane];
            self.fragment.inputs.push(InputValue { input, bits, source });
        }
    }

    /// Records the late tests of its samples, of which `masks` passed.
    pub fn tested(&mut self, plan: &DrawPlan, of: &Tested<'_>, masks: &SampleMasks) {
        self.fragment.tests.extend(of.tests(plan, self.fragment.facing, masks, self.lane));
    }

    /// Records that its colour is written to the samples of `masks`.
    pub fn written(
        &mut self,
        plan: &ColorPlan,
        (rgba, second): ([&F32s; 4], Option<[&F32s; 4]>),
        masks: &[u64],
        [before, after]: [&Stored; 2],
    ) {
        let of_lane = |color: [&F32s; 4]| color.map(|values| values[self.lane]);
        let (color, second) = (of_lane(rgba), second.map(of_lane));
        for (sample, (before, after)) in before.iter().zip(after).enumerate() {
            if masks.get(sample).is_none_or(|mask| mask >> self.lane & 1 == 0) {
                continue;
            }
            let blend = plan.blend.map(|state| {
                let range = plan.format.info().encoding.range();
                let in_range = |color: [f32; 4]| {
                    color.map(|c| range.map_or(c, |[low, high]| math::clamp(c, low, high)))
                };
                let (source, second) = (in_range(color), second.map(in_range));
                let sources = [source, second.unwrap_or_default()];
                let [source_factor, destination_factor, result] =
                    blend_factors(&state, sources, before.color, range);
                Blending {
                    state,
                    source,
                    second,
                    destination: before.color,
                    source_factor,
                    destination_factor,
                    result,
                }
            });
            self.fragment.writes.push(Write {
                target: plan.target,
                sample,
                format: plan.format,
                color,
                blend,
                logic_op: plan.logic_op,
                mask: plan.write,
                before: *before,
                after: *after,
            });
        }
    }
}
