//! A watched pixel within its tile: what clears and fragments do to it is written down.

use super::batch::{Batch, BlockOf};
use super::clear::ClearJob;
use super::depths::BlockDepth;
use super::job::{Chunk, PassJob, TileJob};
use crate::attachment::{DepthFormat, Place, Plane, TileTarget, texel_color};
use crate::desc::{Facing, StencilFace};
use crate::output::{ColorPlan, blend_factors};
use crate::plan::{DrawPlan, FragmentInput, PlaneSource, SampleMasks, Shading, moved};
use crate::primitive::{Kind, Part, Shape};
use crate::shader::{Machine, OverBudget, Run, Tracer};
use crate::sizes::TILE;
use crate::trace::{
    Blending, Clear, Cleared, Fate, Fragment, InputSource, InputValue, PixelEvent, Test, Texel,
    Vertex, Watch, When, Write,
};
use std::collections::VecDeque;
use texunit::format::Format;
use texunit::lanes::{F32s, Isa, LANES, QUADS, lane_x, lane_y, math};

/// The pixel, and its story so far.
#[derive(Debug)]
pub struct Spot {
    watch: Watch,
    /// Which block of the tile it is in, and which lane of the block it is.
    block: usize,
    lane: usize,
    formats: Formats,
    /// Those of fragments that are being shaded are taken out.
    events: Vec<Option<PixelEvent>>,
    /// The fragments that wait to be shaded, in order.
    waiting: VecDeque<Waiting>,
}

/// The formats of a pass's attachments.
#[derive(Clone, Debug)]
pub struct Formats {
    /// By index.
    pub colors: Vec<Option<Format>>,
    /// Of depth.
    pub depth: Option<DepthFormat>,
}

/// A fragment that waits.
#[derive(Debug)]
struct Waiting {
    event: usize,
    /// By plane: the values at the vertices, of varyings.
    values: Vec<Vec<f32>>,
}

/// What an attachment holds at the pixel, by sample.
pub type Stored = Vec<Texel>;

impl Spot {
    /// The watched pixel, if it is in the tile at column and row `at`.
    pub fn new(watch: &Watch, at: [u32; 2], formats: &Formats) -> Option<Box<Self>> {
        let pixel = watch.pixel();
        if [0, 1].iter().any(|&axis| pixel[axis] / TILE != at[axis]) {
            return None;
        }
        let [x, y] = pixel.map(|v| (v % TILE) as usize);
        let lane = (0..LANES).find(|&lane| (lane_x(lane), lane_y(lane)) == (x % 8, y % 8))?;
        Some(Box::new(Self {
            watch: watch.clone(),
            block: y / 8 * 8 + x / 8,
            lane,
            formats: formats.clone(),
            events: Vec::new(),
            waiting: VecDeque::new(),
        }))
    }

    /// Whether it is among the lanes of a block.
    pub fn is_in(&self, block: usize, lanes: u64) -> bool {
        self.block == block && lanes >> self.lane & 1 == 1
    }

    /// Its lane in a batch that covers it.
    pub fn lane_of(&self, place: Place<'_>, lanes: u64) -> Option<usize> {
        let lane = match place {
            Place::Block(block) => (block == self.block).then_some(self.lane)?,
            Place::Quads(blocks, quads) => {
                // Its quad may be there more than once, the pixel may not.
                let first = self.lane / QUADS * QUADS;
                let here = |(at, (&block, &quad)): (usize, (&u8, &u8))| {
                    let same =
                        usize::from(block) == self.block && usize::from(quad) == self.lane % QUADS;
                    (same && lanes >> (first + at) & 1 == 1).then_some(first + at)
                };
                blocks.iter().zip(quads).enumerate().find_map(here)?
            }
            Place::Pixels(at, _) => {
                let here = self.block * LANES + self.lane;
                (0..LANES).find(|&lane| lanes >> lane & 1 == 1 && usize::from(at[lane]) == here)?
            }
        };
        (lanes >> lane & 1 == 1).then_some(lane)
    }

    /// Hands the story over.
    pub fn finish(self) {
        self.watch.append(self.events.into_iter().flatten().collect());
    }

    /// What an attachment holds at the pixel, by sample.
    fn stored(&self, target: Option<&TileTarget>, color: impl Fn([u32; 4]) -> [f32; 4]) -> Stored {
        let Some(target) = target else { return Vec::new() };
        let texel = |planes: &[Plane]| {
            let word =
                |at: usize| planes.get(at).map_or(0, |plane| plane.block(self.block)[self.lane]);
            let words = [0, 1, 2, 3].map(word);
            Texel { words, color: color(words) }
        };
        target.planes.chunks(target.words.max(1)).map(texel).collect()
    }

    /// A clear was done.
    fn cleared(&mut self, job: &ClearJob, stored: &Stored) {
        let pixel = self.watch.pixel().map(|v| v as i32);
        let reaches = |axis: usize| (job.area[0][axis]..job.area[1][axis]).contains(&pixel[axis]);
        if let Some(&after) = stored.first().filter(|_| reaches(0) && reaches(1)) {
            let clear = Clear { label: job.label, target: job.target, after };
            self.events.push(Some(PixelEvent::Clear(clear)));
        }
    }

    /// A shape covers the pixel.
    pub fn covered(&mut self, pass: &PassJob, chunk: &Chunk, shape: &Shape, masks: &SampleMasks) {
        let job = &pass.draws[chunk.draw];
        let before = pass.chunks.iter().take_while(|other| !std::ptr::eq(*other, chunk));
        let before = before.filter(|other| other.draw == chunk.draw);
        let before: usize = before.map(|other| other.lists.shapes.len()).sum();
        let at = chunk.lists.shapes.iter().position(|other| std::ptr::eq(other, shape));
        let corners = match (shape.kind, shape.part) {
            (Kind::Triangle, _) | (Kind::Line { .. } | Kind::Point { .. }, Part::Cut) => 3,
            (Kind::Line { .. }, Part::Whole) => 2,
            (Kind::Point { .. }, Part::Whole) => 1,
        };
        let ids = &shape.vertices[..corners];
        let vertex = |&id: &u32| {
            let window = chunk.geometry.window(&job.plan.viewport, id);
            Vertex { clip: chunk.geometry.clip(id), window }
        };
        let values = |source: &PlaneSource| match *source {
            PlaneSource::Smooth(at)
            | PlaneSource::NoPerspective(at)
            | PlaneSource::Sprite(at, _) => {
                ids.iter().map(|&id| chunk.geometry.varyings_of(id)[at]).collect()
            }
            PlaneSource::Depth
            | PlaneSource::Denominator
            | PlaneSource::InverseW
            | PlaneSource::Flat(_)
            | PlaneSource::PointCoord(_) => Vec::new(),
        };
        let covered = (0..)
            .zip(masks.iter())
            .fold(0, |bits, (sample, mask)| bits | u8::from(mask >> self.lane & 1 == 1) << sample);
        self.waiting.push_back(Waiting {
            event: self.events.len(),
            values: job.plan.planes.iter().map(values).collect(),
        });
        self.events.push(Some(PixelEvent::Fragment(Box::new(Fragment {
            label: job.label,
            shape: before + at.unwrap_or(0),
            vertices: ids.iter().map(vertex).collect(),
            facing: shape.facing,
            samples: (covered, job.plan.samples.count),
            inputs: Vec::new(),
            steps: Vec::new(),
            more_steps: 0,
            outputs: Vec::new(),
            tests: Vec::new(),
            fate: Fate::NoColor,
            writes: Vec::new(),
        }))));
    }

    /// The tests before shading were made: `masks` are left.
    fn tested_early(&mut self, plan: &DrawPlan, of: &Tested<'_>, masks: &SampleMasks) {
        let left: u64 = masks.any();
        let Some(waiting) = self.waiting.back() else { return };
        let event = self.events.get_mut(waiting.event);
        let Some(Some(PixelEvent::Fragment(fragment))) = event else { return };
        fragment.tests.extend(of.tests(plan, fragment.facing, masks, self.lane));
        if left >> self.lane & 1 == 0 {
            fragment.fate = Fate::TestFailed;
            self.waiting.pop_back();
        }
    }

    /// The fragment that is shaded now, if the batch covers the pixel.
    pub fn begin(&mut self, place: Place<'_>, lanes: u64) -> Option<Shaded> {
        let lane = self.lane_of(place, lanes)?;
        let Waiting { event, values } = self.waiting.pop_front()?;
        match self.events.get_mut(event)?.take()? {
            PixelEvent::Fragment(fragment) => Some(Shaded { event, lane, fragment, values }),
            clear @ PixelEvent::Clear(_) => {
                self.events[event] = Some(clear);
                None
            }
        }
    }

    /// It is done.
    pub fn end(&mut self, shaded: Shaded) {
        self.events[shaded.event] = Some(PixelEvent::Fragment(shaded.fragment));
    }
}

/// What is known of tests once they are made.
pub struct Tested<'a> {
    /// When.
    pub when: When,
    /// By sample.
    pub depths: &'a [f32],
    /// What the shader wrote for stencils to be compared with, if it did.
    pub reference: Option<u8>,
    /// By sample.
    pub before: &'a Stored,
    /// By sample.
    pub after: &'a Stored,
}

impl Tested<'_> {
    /// The tests of a lane's samples, which passed where `masks` are left.
    fn tests(
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

impl TileJob {
    /// What a colour attachment holds at the watched pixel.
    pub fn watched_color(&self, index: usize) -> Stored {
        let Some(spot) = &self.watched else { return Vec::new() };
        let format = spot.formats.colors.get(index).copied().flatten();
        let target = self.colors.get(index).and_then(Option::as_ref);
        spot.stored(target, |words| format.map_or([0.0; 4], |format| texel_color(format, words)))
    }

    /// What the depth attachment holds there.
    pub fn watched_depth(&self) -> Stored {
        let Some(spot) = &self.watched else { return Vec::new() };
        let depth = |word: u32| spot.formats.depth.map_or(0.0, |format| format.depth(word));
        spot.stored(self.depth.as_ref(), |words| [depth(words[0]), 0.0, 0.0, 1.0])
    }

    /// A clear was done.
    pub fn note_clear(&mut self, job: &ClearJob) {
        let stored = match job.target {
            Cleared::Color(index) => self.watched_color(index),
            Cleared::Depth | Cleared::Stencil => self.watched_depth(),
        };
        if let Some(spot) = &mut self.watched {
            spot.cleared(job, &stored);
        }
    }

    /// Tests of a block were made before shading; `before` is what was stored.
    pub fn note_early(
        &mut self,
        isa: Isa,
        plan: &DrawPlan,
        of: &BlockOf<'_>,
        masks: &SampleMasks,
        before: &Stored,
    ) {
        let after = self.watched_depth();
        let Some(spot) = &mut self.watched else { return };
        let depth = |sample: usize| {
            let plane =
                plan.depth_plane.map(|at| moved(of.planes[at], plan.samples.offset(sample)));
            let depths = plan.viewport.depths();
            plane.map_or(0.0, |plane| isa.run(BlockDepth { plane, depths })[spot.lane])
        };
        let depths: Vec<f32> = (0..plan.samples.count).map(depth).collect();
        let (when, reference, after) = (When::Early, None, &after);
        let tested = Tested { when, depths: &depths, reference, before, after };
        spot.tested_early(plan, &tested, masks);
        if plan.shading == Shading::Off {
            spot.waiting.clear();
        }
    }
}

/// The watched fragment while it is shaded.
#[derive(Debug)]
pub struct Shaded {
    event: usize,
    /// Its lane of the batch.
    pub lane: usize,
    /// Its story.
    pub fragment: Box<Fragment>,
    /// By plane: the values at the vertices, of varyings.
    values: Vec<Vec<f32>>,
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
        run: Run<'_>,
    ) -> Result<u64, OverBudget> {
        self.fragment.fate = if plan.colors.is_empty() { Fate::NoColor } else { Fate::Written };
        self.interpolated(plan, batch, machine);
        let mut tracer = Tracer::new(run.program, self.lane);
        let kept = machine.run_traced(run, &mut tracer);
        for (index, output) in run.program.outputs().enumerate() {
            self.fragment.outputs.push((output, tracer.output(machine, index)));
        }
        (self.fragment.steps, self.fragment.more_steps) = (tracer.steps, tracer.more);
        if kept.is_err() {
            self.fragment.fate = Fate::OverBudget;
        }
        kept
    }

    /// Its inputs were interpolated.
    fn interpolated(&mut self, plan: &DrawPlan, batch: &Batch<'_>, machine: &Machine) {
        let of_program = plan.pipeline.compiled().fragment.inputs();
        let centroids = plan.samples.centroids(batch.masks);
        let within = |plane: usize| batch.at_moved(plane, self.lane, &centroids);
        for (index, (&input, from)) in of_program.iter().zip(&plan.inputs).enumerate() {
            let values = |plane: usize| self.values.get(plane).cloned().unwrap_or_default();
            let source = match *from {
                FragmentInput::Smooth(plane) => InputSource::Perspective {
                    vertices: values(plane),
                    numerator: batch.at(plane, self.lane),
                    denominator: plan.denominator_plane.map_or(1.0, |at| batch.at(at, self.lane)),
                },
                FragmentInput::SmoothWithin(plane) => InputSource::Perspective {
                    vertices: values(plane),
                    numerator: within(plane),
                    denominator: plan.denominator_plane.map_or(1.0, within),
                },
                FragmentInput::Linear(plane) | FragmentInput::LinearWithin(plane) => {
                    InputSource::Linear(values(plane))
                }
                FragmentInput::Flat(_) => InputSource::Flat,
                FragmentInput::SmoothSlope(..) | FragmentInput::LinearSlope(..) => {
                    InputSource::Slope
                }
                FragmentInput::X
                | FragmentInput::Y
                | FragmentInput::Depth
                | FragmentInput::Front
                | FragmentInput::Coverage
                | FragmentInput::Zero => InputSource::Pixel,
            };
            let bits = machine.input(index)[self.lane];
            self.fragment.inputs.push(InputValue { input, bits, source });
        }
    }

    /// Its samples were tested after shading: `masks` are left.
    pub fn tested(&mut self, plan: &DrawPlan, of: &Tested<'_>, masks: &SampleMasks) {
        self.fragment.tests.extend(of.tests(plan, self.fragment.facing, masks, self.lane));
    }

    /// Its colour was written to the samples of `masks`.
    pub fn written(
        &mut self,
        plan: &ColorPlan,
        rgba: [&F32s; 4],
        masks: &[u64],
        [before, after]: [&Stored; 2],
    ) {
        let color = rgba.map(|values| values[self.lane]);
        for (sample, (before, after)) in before.iter().zip(after).enumerate() {
            if masks.get(sample).is_none_or(|mask| mask >> self.lane & 1 == 0) {
                continue;
            }
            let blend = plan.blend.map(|state| {
                let range = plan.format.info().encoding.range();
                let clamped =
                    color.map(|c| range.map_or(c, |[low, high]| math::clamp(c, low, high)));
                let [source_factor, destination_factor, result] =
                    blend_factors(&state, clamped, before.color, range);
                Blending {
                    state,
                    source: clamped,
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
