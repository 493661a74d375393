//! The vertex program over batches of 64, and the viewport transform of what it gives.

use super::fetch;
use super::place::{Place, Placed, ShadedVertex, cut};
use crate::driver::{PointSize, PointState, VertexBinding, VertexSource, Viewport};
use crate::ir::{Input, Output};
use crate::pool::Pool;
use crate::primitive::{Corner, MAX_DISTANCES};
use crate::shader::{Machine, OverBudget, Prepared, Program, Run};
use rayon::prelude::*;
use std::num::NonZeroU32;
use std::sync::Arc;
use texunit::lanes::{F32s, Isa, LANES, U32s};
use texunit::plan::SamplePlan;

/// The vertices of a chunk of a draw.
#[derive(Debug, Default)]
pub struct Geometry {
    /// One for each vertex.
    pub vertices: Vec<ShadedVertex>,
    /// `stride` for each vertex.
    pub varyings: Vec<f32>,
    /// Varyings of a vertex.
    pub stride: usize,
    /// `planes` clip distances for each vertex.
    distances: Vec<f32>,
    /// Clip distances of a vertex.
    planes: usize,
    /// The edge flag of each vertex; empty where all are set.
    edge_flags: Vec<f32>,
}

impl Geometry {
    /// The varyings of a vertex.
    pub fn varyings_of(&self, vertex: u32) -> &[f32] {
        &self.varyings[vertex as usize * self.stride..][..self.stride]
    }

    /// A vertex as a corner of a polygon to be clipped.
    pub fn corner(&self, vertex: u32) -> Corner {
        let mut distances = [0.0; MAX_DISTANCES];
        let own = &self.distances[vertex as usize * self.planes..][..self.planes];
        for (to, &from) in distances.iter_mut().zip(own) {
            *to = from.into();
        }
        Corner { clip: self.vertices[vertex as usize].clip.map(f64::from), distances }
    }

    /// Whether a boundary edge begins at a vertex (GL 2.1, section 2.6.2).
    pub fn begins_boundary(&self, vertex: u32) -> bool {
        self.edge_flags.get(vertex as usize).is_none_or(|&flag| flag != 0.0)
    }
}

/// What every vertex of a draw goes through.
pub struct VertexStage<'a> {
    /// The instruction set.
    pub isa: Isa,
    /// Instructions a batch may run.
    pub budget: u64,
    /// The vertex program.
    pub program: &'a Program,
    /// Its values of this draw.
    pub prepared: &'a Prepared,
    /// What runs it.
    pub machines: &'a Pool<Machine>,
    /// Where the memory of its results comes from.
    pub geometries: &'a Pool<Geometry>,
    /// Its textures.
    pub textures: &'a [Option<Arc<SamplePlan>>],
    /// Its attributes.
    pub bindings: &'a [VertexBinding],
    /// Where the window is.
    pub viewport: Viewport,
    /// Varying slots that the fragment stage reads, in the order they are stored.
    pub varyings: &'a [u16],
    /// The size of points and where it comes from.
    pub point: &'a PointState,
    /// The attribute that holds edge flags, where they matter.
    pub edge_flag: Option<u8>,
}

/// Shades the vertices `ids`, in parallel where there are many.
///
/// # Errors
/// When a batch runs over its budget.
pub fn shade(stage: &VertexStage<'_>, ids: &[u32], instance: u32) -> Result<Geometry, OverBudget> {
    let stride = stage.varyings.len();
    let distance = |output: &Output| matches!(output, Output::ClipDistance(_));
    let planes = stage.program.outputs().filter(distance).count();
    let sources: Vec<Source> = stage.program.inputs().iter().map(|&i| stage.source(i)).collect();
    let mut plane = 0..;
    let outputs = stage.program.outputs();
    let targets: Vec<Target> = outputs.map(|o| stage.target(o, &mut plane)).collect();
    let mut geometry = stage.geometries.take();
    (geometry.stride, geometry.planes) = (stride, planes);
    // What it holds of another draw is written over, but for varyings that this one does not write.
    geometry.vertices.resize(ids.len(), ShadedVertex::default());
    geometry.varyings.resize(ids.len() * stride, 0.0);
    geometry.distances.resize(ids.len() * planes, 0.0);
    geometry.edge_flags = stage.edge_flags(ids);
    let is_varying = |target: &&Target| matches!(target, Target::Varying(_));
    if targets.iter().filter(is_varying).count() < stride {
        geometry.varyings.fill(0.0);
    }
    let lend = || {
        let mut machine = stage.machines.lend();
        machine.get().begin(stage.program);
        machine
    };
    let vertices = geometry.vertices.chunks_mut(LANES);
    let varyings = pieces(&mut geometry.varyings, ids.len(), stride);
    let distances = pieces(&mut geometry.distances, ids.len(), planes);
    let batches = ids.chunks(LANES).zip(vertices).zip(varyings.into_iter().zip(distances));
    let mut batches: Vec<Batch<'_>> = batches
        .map(|((ids, vertices), (varyings, distances))| Batch {
            ids,
            instance,
            vertices,
            varyings,
            distances,
        })
        .collect();
    if batches.len() <= 4 {
        let mut machine = lend();
        for batch in &mut batches {
            stage.batch(machine.get(), &sources, &targets, batch)?;
        }
    } else {
        batches.par_iter_mut().with_min_len(4).try_for_each_init(lend, |machine, batch| {
            stage.batch(machine.get(), &sources, &targets, batch)
        })?;
    }
    Ok(geometry)
}

/// `stride` values of each of `count` vertices, cut into batches. (`chunks_mut` takes no stride of
/// zero.)
fn pieces(values: &mut [f32], count: usize, stride: usize) -> Vec<&mut [f32]> {
    let mut pieces = Vec::with_capacity(count.div_ceil(LANES));
    let mut rest = values;
    for first in (0..count).step_by(LANES) {
        let (piece, after) = rest.split_at_mut(LANES.min(count - first) * stride);
        pieces.push(piece);
        rest = after;
    }
    pieces
}

/// Where an input of the program comes from.
enum Source<'a> {
    Attribute(&'a VertexSource, u8),
    /// An attribute with an element for so many instances.
    Instanced(&'a VertexSource, u8, NonZeroU32),
    /// An attribute without a binding.
    Missing(f32),
    VertexId,
    InstanceId,
}

/// Where an output of the program goes.
enum Target {
    Position(usize),
    PointSize,
    Varying(usize),
    /// A clip distance, by its place among the distances.
    Distance(usize),
    Nowhere,
}

/// A batch of vertices: what goes in, and where the results go.
struct Batch<'a> {
    ids: &'a [u32],
    instance: u32,
    vertices: &'a mut [ShadedVertex],
    varyings: &'a mut [f32],
    distances: &'a mut [f32],
}

impl VertexStage<'_> {
    fn source(&self, input: Input) -> Source<'_> {
        match input {
            Input::Attribute { location, component } => {
                match self.bindings.iter().find(|binding| binding.location == location) {
                    Some(VertexBinding { source, .. }) => match source.divisor() {
                        Some(divisor) => Source::Instanced(source, component, divisor),
                        None => Source::Attribute(source, component),
                    },
                    None => Source::Missing(if component == 3 { 1.0 } else { 0.0 }),
                }
            }
            Input::VertexId => Source::VertexId,
            Input::InstanceId => Source::InstanceId,
            Input::Varying(_)
            | Input::Slope { .. }
            | Input::FragCoord(_)
            | Input::FrontFacing
            | Input::PointCoord(_)
            | Input::Coverage => Source::Missing(0.0),
        }
    }

    /// The edge flags of vertices; none where they do not matter or are all set.
    fn edge_flags(&self, ids: &[u32]) -> Vec<f32> {
        let binding = self.bindings.iter().find(|binding| Some(binding.location) == self.edge_flag);
        let Some(binding) = binding else { return Vec::new() };
        let mut flags = Vec::with_capacity(ids.len());
        for ids in ids.chunks(LANES) {
            let mut lanes = F32s::ZERO;
            fetch::component(self.isa, &binding.source, 0, ids, &mut lanes);
            flags.extend_from_slice(&lanes.0[..ids.len()]);
        }
        flags
    }

    fn target(&self, output: Output, plane: &mut impl Iterator<Item = usize>) -> Target {
        match output {
            Output::Position(component) => Target::Position(usize::from(component)),
            Output::PointSize => match self.point.source {
                PointSize::State => Target::Nowhere,
                PointSize::Vertex => Target::PointSize,
            },
            Output::Varying(slot) => match self.varyings.iter().position(|&s| s == slot) {
                Some(at) => Target::Varying(at),
                None => Target::Nowhere,
            },
            Output::ClipDistance(_) => plane.next().map_or(Target::Nowhere, Target::Distance),
            Output::Color { .. } | Output::Depth => Target::Nowhere,
        }
    }

    fn batch(
        &self,
        machine: &mut Machine,
        sources: &[Source<'_>],
        targets: &[Target],
        batch: &mut Batch<'_>,
    ) -> Result<(), OverBudget> {
        let Batch { ids, instance, vertices, varyings, distances } = batch;
        for (index, source) in sources.iter().enumerate() {
            let lanes = machine.input_mut(index);
            match source {
                Source::Attribute(source, component) => {
                    fetch::component(self.isa, source, *component, ids, lanes.as_f32_mut());
                }
                Source::Instanced(source, component, divisor) => {
                    let element = *instance / *divisor;
                    fetch::component(self.isa, source, *component, &[element], lanes.as_f32_mut());
                    *lanes = U32s::splat(lanes[0]);
                }
                Source::Missing(value) => lanes.0 = [value.to_bits(); LANES],
                Source::VertexId => lanes.0[..ids.len()].copy_from_slice(ids),
                Source::InstanceId => lanes.0 = [*instance; LANES],
            }
        }
        machine.run(Run {
            isa: self.isa,
            program: self.program,
            prepared: self.prepared,
            textures: self.textures,
            active: !0 >> (LANES - ids.len()),
            budget: self.budget,
        })?;
        let stride = self.varyings.len();
        let mut clip = [&F32s::ZERO; 4];
        for (index, target) in targets.iter().enumerate() {
            if let Target::Position(component) = *target {
                clip[component] = machine.output(index).as_f32();
            }
        }
        let mut placed = Placed::default();
        self.isa.run(Place { clip, viewport: &self.viewport, out: &mut placed });
        placed.store(clip, self.point.size, vertices);
        for (index, target) in targets.iter().enumerate() {
            let lanes = machine.output(index).as_f32();
            match *target {
                Target::PointSize => {
                    for (vertex, &value) in vertices.iter_mut().zip(&lanes.0) {
                        vertex.point_size = value;
                    }
                }
                Target::Varying(at) => {
                    for (all, &value) in varyings.chunks_exact_mut(stride).zip(&lanes.0) {
                        all[at] = value;
                    }
                }
                Target::Distance(at) => {
                    let all = distances.chunks_exact_mut(distances.len() / ids.len());
                    for (all, &value) in all.zip(&lanes.0) {
                        all[at] = value;
                    }
                }
                Target::Position(_) | Target::Nowhere => {}
            }
        }
        if !distances.is_empty() {
            let planes = distances.len() / ids.len();
            for (vertex, own) in vertices.iter_mut().zip(distances.chunks_exact(planes)) {
                cut(vertex, own);
            }
        }
        Ok(())
    }
}
