//! The vertex program over batches of 64 vertices, and the viewport transform of its outputs.

use super::fetch::{self, Elements};
use super::geometry::{Geometry, VARYINGS};
use super::geometry_stage::{Layers, Viewports};
use super::slices::VertexSlices;
use super::viewport::{ViewportTransform, WindowVertices, cut, note_culled};
use crate::desc::{PointSize, VertexBinding, VertexSource, Viewport};
use crate::ir::{Input, Output};
use crate::shader::{Invocation, Machine, OverBudget, Prepared, Program};
use crate::threads::{ObjectPool, ThreadPool};
use std::num::NonZeroU32;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use texunit::lanes::{F32s, Isa, LANES, U32s};
use texunit::plan::SamplePlan;

/// The vertex stage of a draw.
pub struct VertexStage<'a> {
    /// The instruction set.
    pub isa: Isa,
    /// Instructions a batch may run.
    pub budget: u64,
    /// What batches have run of it.
    pub operations: &'a AtomicU64,
    /// The vertex program.
    pub program: &'a Program,
    /// Its values of this draw.
    pub prepared: &'a Prepared,
    /// The threads that run it.
    pub thread_pool: &'a ThreadPool,
    /// The interpreters that run it.
    pub machines: &'a ObjectPool<Machine>,
    /// Its textures.
    pub textures: &'a [Option<Arc<SamplePlan>>],
    /// Its attributes.
    pub bindings: &'a [VertexBinding],
    /// The viewport.
    pub viewport: Viewport,
    /// Varying slots that the fragment stage reads, in the order they are stored.
    pub varyings: &'a [u16],
    /// The source of point sizes.
    pub point_size: PointSize,
    /// The attribute that holds edge flags, where they matter.
    pub edge_flag: Option<u8>,
    /// Whether the vertices are those of what is drawn.
    pub place: Placement,
    /// Whether layers matter.
    pub layers: Layers,
    /// Whether primitives go to several viewports.
    pub viewports: Viewports,
}

/// Whether vertices have a place in the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Placement {
    /// They have.
    InWindow,
    /// A geometry program reads them; they have neither a place nor outcodes.
    Nowhere,
}

/// Batches that are not worth another thread, however long their program is.
const LEAST_BATCHES: usize = 8;

/// Operations, in additions of 64 lanes, that take about as long as waking another thread and waiting for it.
const WORTH_A_THREAD: u64 = 1 << 16;

/// Shades the vertices `ids` of instances, one behind the other, in parallel where there are many. They begin at a
/// vertex of a geometry, which has at least those before it.
///
/// # Errors
/// When a batch runs over its budget.
pub fn shade(
    stage: &VertexStage<'_>,
    ids: &[u32],
    instances: Range<u32>,
    to: (&mut Geometry, usize),
) -> Result<(), OverBudget> {
    if instances.len() == 1 {
        return shade_all(stage, ids, Instances::One(instances.start), to);
    }
    let numbers: Vec<u32> =
        instances.clone().flat_map(|instance| ids.iter().map(move |_| instance)).collect();
    shade_all(stage, &ids.repeat(instances.len()), Instances::Each(&numbers), to)
}

/// The instances of the vertices of a batch.
#[derive(Clone, Copy)]
enum Instances<'a> {
    /// All vertices are of this instance.
    One(u32),
    /// The instance of each vertex.
    Each(&'a [u32]),
}

impl Instances<'_> {
    /// What `of` makes of the number of the only one, or of each vertex's.
    fn numbers<'a>(&self, out: &'a mut [u32; LANES], of: impl Fn(u32) -> u32) -> &'a [u32] {
        let numbers = match self {
            Self::One(instance) => std::slice::from_ref(instance),
            Self::Each(numbers) => numbers,
        };
        for (out, &number) in out.iter_mut().zip(numbers) {
            *out = of(number);
        }
        &out[..numbers.len()]
    }
}

fn shade_all(
    stage: &VertexStage<'_>,
    ids: &[u32],
    instances: Instances<'_>,
    (geometry, first): (&mut Geometry, usize),
) -> Result<(), OverBudget> {
    let stride = stage.stride();
    let distance = |output: &Output| matches!(output, Output::ClipDistance(_));
    let planes = stage.program.outputs().filter(distance).count();
    let sources: Vec<InputSource> =
        stage.program.inputs().iter().map(|&i| stage.source(i)).collect();
    let mut plane = 0..;
    let outputs = stage.program.outputs();
    let targets: Vec<OutputTarget> = outputs.map(|o| stage.target(o, &mut plane)).collect();
    (geometry.stride, geometry.planes) = (stride, planes);
    let sizes = usize::from(targets.contains(&OutputTarget::PointSize));
    // Values of an earlier draw are overwritten, except those that this draw does not write.
    let count = first + ids.len();
    geometry.values.resize(count * stride, 0.0);
    geometry.snapped.resize(count, [0; 2]);
    geometry.outcodes.resize(count, 0);
    geometry.point_sizes.resize(count * sizes, 0.0);
    geometry.distances.resize(count * planes, 0.0);
    let of_targets = |target| usize::from(targets.contains(&target));
    let (layered, placed) = (of_targets(OutputTarget::Layer), of_targets(OutputTarget::Viewport));
    geometry.layers.resize(count * layered, 0);
    geometry.viewports.resize(count * placed, 0);
    geometry.edge_flags = stage.edge_flags(ids);
    let own = &mut geometry.values[first * stride..];
    let is_value = |target: &&OutputTarget| matches!(target, OutputTarget::Value(_));
    if targets.iter().filter(is_value).count() < VARYINGS + stage.varyings.len() {
        own.fill(0.0);
    }
    let mut values = VertexSlices { rest: own, each: stride };
    let mut snapped = VertexSlices { rest: &mut geometry.snapped[first..], each: 1 };
    let mut outcodes = VertexSlices { rest: &mut geometry.outcodes[first..], each: 1 };
    let mut point_sizes =
        VertexSlices { rest: &mut geometry.point_sizes[first * sizes..], each: sizes };
    let mut distances =
        VertexSlices { rest: &mut geometry.distances[first * planes..], each: planes };
    let mut layers = VertexSlices { rest: &mut geometry.layers[first * layered..], each: layered };
    let mut viewports =
        VertexSlices { rest: &mut geometry.viewports[first * placed..], each: placed };
    let of_batch = |batch: usize, len: usize| match instances {
        Instances::One(_) => instances,
        Instances::Each(numbers) => Instances::Each(&numbers[batch * LANES..][..len]),
    };
    let mut batches = ids.chunks(LANES).enumerate().map(|(batch, ids)| Batch {
        ids,
        instances: of_batch(batch, ids.len()),
        values: values.next(ids.len()),
        snapped: snapped.next(ids.len()),
        outcodes: outcodes.next(ids.len()),
        point_sizes: point_sizes.next(ids.len()),
        distances: distances.next(ids.len()),
        layers: layers.next(ids.len()),
        viewports: viewports.next(ids.len()),
    });
    // Most draws of a scene of many have no more than one.
    let mut first = batches.next();
    let mut all: Vec<Batch<'_>> = Vec::new();
    let batches = match ids.len() <= LANES {
        true => first.as_mut_slice(),
        false => {
            all.extend(first.into_iter().chain(batches));
            &mut all[..]
        }
    };
    let stopped = AtomicBool::new(false);
    let least =
        LEAST_BATCHES.max((WORTH_A_THREAD / stage.program.cost_without_textures()) as usize);
    let borrow = || stage.machines.borrow();
    stage.thread_pool.for_each_chunk(batches, least, borrow, |machine, batches| {
        let machine = machine.get();
        machine.begin(stage.program);
        for batch in batches {
            if !stopped.load(Ordering::Relaxed)
                && stage.batch(machine, &sources, &targets, batch).is_err()
            {
                stopped.store(true, Ordering::Relaxed);
            }
        }
    });
    if stopped.into_inner() { Err(OverBudget) } else { Ok(()) }
}

/// The source of an input of the program.
enum InputSource<'a> {
    Attribute(&'a VertexSource, u8),
    /// An attribute that advances once for a number of instances.
    Instanced(&'a VertexSource, u8, NonZeroU32),
    /// An attribute without a binding.
    Missing(f32),
    VertexId,
    InstanceId,
}

/// The destination of an output of the program.
#[derive(Clone, Copy, PartialEq, Eq)]
enum OutputTarget {
    PointSize,
    /// One of the vertex's values.
    Value(usize),
    /// A clip distance, by its index among the distances.
    Distance(usize),
    /// A cull distance, by its number.
    Cull(u8),
    Layer,
    Viewport,
    Nowhere,
}

/// A batch of up to 64 vertices: its inputs and the slices for its results.
struct Batch<'a> {
    ids: &'a [u32],
    instances: Instances<'a>,
    values: &'a mut [f32],
    snapped: &'a mut [[i32; 2]],
    outcodes: &'a mut [u32],
    point_sizes: &'a mut [f32],
    distances: &'a mut [f32],
    layers: &'a mut [u32],
    viewports: &'a mut [u32],
}

impl VertexStage<'_> {
    /// Values of a vertex, a multiple of four.
    fn stride(&self) -> usize {
        (VARYINGS + self.varyings.len()).next_multiple_of(4)
    }

    fn source(&self, input: Input) -> InputSource<'_> {
        match input {
            Input::Attribute { location, component } => {
                match self.bindings.iter().find(|binding| binding.location == location) {
                    Some(VertexBinding { source, .. }) => match source.divisor() {
                        Some(divisor) => InputSource::Instanced(source, component, divisor),
                        None => InputSource::Attribute(source, component),
                    },
                    None => InputSource::Missing(if component == 3 { 1.0 } else { 0.0 }),
                }
            }
            Input::VertexId => InputSource::VertexId,
            Input::InstanceId => InputSource::InstanceId,
            Input::OfVertex { .. }
            | Input::PrimitiveId
            | Input::Varying(_)
            | Input::Gradient { .. }
            | Input::FragCoord(_)
            | Input::FrontFacing
            | Input::PointCoord(_)
            | Input::Coverage
            | Input::SampleId
            | Input::SamplePosition(_)
            | Input::LineDirection(_) => InputSource::Missing(0.0),
        }
    }

    /// The edge flags of vertices; none where they do not matter or are all set.
    fn edge_flags(&self, ids: &[u32]) -> Vec<f32> {
        let binding = self.bindings.iter().find(|binding| Some(binding.location) == self.edge_flag);
        let Some(binding) = binding else { return Vec::new() };
        let mut flags = Vec::with_capacity(ids.len());
        for ids in ids.chunks(LANES) {
            let mut lanes = F32s::ZERO;
            fetch::component(self.isa, &binding.source, 0, Elements::new(ids), &mut lanes);
            flags.extend_from_slice(&lanes.0[..ids.len()]);
        }
        flags
    }

    fn target(&self, output: Output, plane: &mut impl Iterator<Item = usize>) -> OutputTarget {
        match output {
            Output::Position(component) => OutputTarget::Value(component.into()),
            Output::PointSize => match self.point_size {
                PointSize::State => OutputTarget::Nowhere,
                PointSize::Vertex => OutputTarget::PointSize,
            },
            Output::Varying(slot) => match self.varyings.iter().position(|&s| s == slot) {
                Some(at) => OutputTarget::Value(VARYINGS + at),
                None => OutputTarget::Nowhere,
            },
            Output::CullDistance(number) => OutputTarget::Cull(number),
            Output::ClipDistance(_) => {
                plane.next().map_or(OutputTarget::Nowhere, OutputTarget::Distance)
            }
            Output::Layer if self.layers == Layers::Several => OutputTarget::Layer,
            Output::ViewportIndex if self.viewports == Viewports::Several => OutputTarget::Viewport,
            Output::Color { .. }
            | Output::SecondColor(_)
            | Output::Depth
            | Output::StencilReference
            | Output::SampleMask
            | Output::Layer
            | Output::PrimitiveId
            | Output::ViewportIndex => OutputTarget::Nowhere,
        }
    }

    fn batch(
        &self,
        machine: &mut Machine,
        sources: &[InputSource<'_>],
        targets: &[OutputTarget],
        batch: &mut Batch<'_>,
    ) -> Result<(), OverBudget> {
        let Batch { ids, instances, values, snapped, outcodes, point_sizes, distances, .. } = batch;
        let elements = Elements::new(ids);
        for (index, source) in sources.iter().enumerate() {
            let lanes = machine.input_mut(index);
            match source {
                InputSource::Attribute(source, component) => {
                    fetch::component(self.isa, source, *component, elements, lanes.as_f32_mut());
                }
                InputSource::Instanced(source, component, divisor) => {
                    let mut of = [0; LANES];
                    let of = instances.numbers(&mut of, |instance| instance / *divisor);
                    let elements = Elements::new(of);
                    fetch::component(self.isa, source, *component, elements, lanes.as_f32_mut());
                    if let Instances::One(_) = instances {
                        *lanes = U32s::splat(lanes[0]);
                    }
                }
                InputSource::Missing(value) => lanes.0 = [value.to_bits(); LANES],
                InputSource::VertexId => lanes.0[..ids.len()].copy_from_slice(ids),
                InputSource::InstanceId => match instances {
                    Instances::One(instance) => *lanes = U32s::splat(*instance),
                    Instances::Each(numbers) => lanes.0[..ids.len()].copy_from_slice(numbers),
                },
            }
        }
        machine.run(Invocation {
            isa: self.isa,
            program: self.program,
            prepared: self.prepared,
            textures: self.textures,
            active: !0 >> (LANES - ids.len()),
            budget: self.budget,
        })?;
        if self.program.has_loops() {
            self.operations.fetch_add(self.budget - machine.left(), Ordering::Relaxed);
        }
        let stride = self.stride();
        let mut clip = [&F32s::ZERO; 4];
        let mut culled: Option<[u32; LANES]> = None;
        for (index, &target) in targets.iter().enumerate() {
            let (lanes, words) =
                (machine.output(index).as_f32(), &machine.output(index).0[..ids.len()]);
            match target {
                OutputTarget::PointSize => point_sizes.copy_from_slice(&lanes.0[..ids.len()]),
                OutputTarget::Value(at) => {
                    if let Some(clip) = clip.get_mut(at) {
                        *clip = lanes;
                    }
                    scatter(values, at, stride, lanes);
                }
                OutputTarget::Distance(at) => {
                    let planes = distances.len() / ids.len();
                    scatter(distances, at, planes, lanes);
                }
                OutputTarget::Cull(number) => {
                    note_culled(culled.get_or_insert([0; LANES]), number, lanes);
                }
                OutputTarget::Layer => batch.layers.copy_from_slice(words),
                OutputTarget::Viewport => batch.viewports.copy_from_slice(words),
                OutputTarget::Nowhere => {}
            }
        }
        if self.place == Placement::Nowhere {
            return Ok(());
        }
        let mut window = WindowVertices { snapped: [[0; LANES]; 2], outcodes: [0; LANES] };
        self.isa.run(ViewportTransform { clip, viewport: &self.viewport, out: &mut window });
        for (lane, to) in snapped.iter_mut().enumerate().take(LANES) {
            *to = [window.snapped[0][lane], window.snapped[1][lane]];
        }
        outcodes.copy_from_slice(&window.outcodes[..ids.len()]);
        if let Some(culled) = culled {
            outcodes.iter_mut().zip(culled).for_each(|(outcode, culled)| *outcode |= culled);
        }
        if !distances.is_empty() {
            let planes = distances.len() / ids.len();
            for (outcode, own) in outcodes.iter_mut().zip(distances.chunks_exact(planes)) {
                cut(outcode, own);
            }
        }
        Ok(())
    }
}

/// Writes value `at` of each vertex of a batch.
fn scatter(values: &mut [f32], at: usize, stride: usize, lanes: &F32s) {
    let Some(values) = values.get_mut(at..) else { return };
    for (to, &value) in values.iter_mut().step_by(stride).zip(&lanes.0) {
        *to = value;
    }
}
