//! The geometry program over batches of 64 primitives: its inputs from shaded vertices, and the vertices that it emits
//! as shaded vertices and primitives of their own (GL 3.2, section 2.12).

use super::assemble::Primitives;
use super::geometry::{Geometry, VARYINGS};
use super::vertex_list::VertexList;
use super::viewport::{ViewportTransform, WindowVertices, cut, note_culled};
use crate::desc::{PointSize, Provoking, Viewport};
use crate::ir::{Input, Output};
use crate::shader::{Emission, Invocation, Machine, OverBudget, Prepared, Program};
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use texunit::lanes::{F32s, Isa, LANES, U32s};
use texunit::plan::SamplePlan;

/// Half of a primitive's number.
const HALF: u32 = 0xFFFF;

/// The geometry stage of a draw.
pub struct GeometryStage<'a> {
    /// The instruction set.
    pub isa: Isa,
    /// Instructions a batch may run.
    pub budget: u64,
    /// What batches have run of it.
    pub operations: &'a AtomicU64,
    /// The geometry program.
    pub program: &'a Program,
    /// Its values of this draw.
    pub prepared: &'a Prepared,
    /// Its textures.
    pub textures: &'a [Option<Arc<SamplePlan>>],
    /// The vertex program.
    pub vertex: &'a Program,
    /// Varying slots of the shaded vertices, in the order they are stored.
    pub vertex_varyings: &'a [u16],
    /// Varying slots that the fragment stage reads, in the order they are stored.
    pub varyings: &'a [u16],
    /// Which of them are the halves of the primitive's number.
    pub primitive_id: [Option<usize>; 2],
    /// The viewport.
    pub viewport: Viewport,
    /// The source of point sizes.
    pub point_size: PointSize,
    /// Which vertex provokes.
    pub provoking: Provoking,
    /// Whether layers matter.
    pub layers: Layers,
    /// Whether primitives go to several viewports.
    pub viewports: Viewports,
}

/// Whether primitives go to different layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layers {
    /// All go to one.
    One,
    /// Each to that of its provoking vertex.
    Several,
}

/// Whether primitives go to different viewports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Viewports {
    /// All go to one.
    One,
    /// Each to that of its provoking vertex.
    Several,
}

/// The source of an input of the program.
#[derive(Clone, Copy)]
enum InputSource {
    Zero,
    PrimitiveId,
    /// One of the values of a vertex of the primitive.
    Value(usize, usize),
    PointSize(usize),
    /// A clip distance, by its index among the distances.
    Distance(usize, usize),
}

/// What has been emitted, behind what else a geometry holds.
pub struct Emitted<'a> {
    pub geometry: &'a mut Geometry,
    /// By primitive: its vertices.
    pub indices: Vec<u32>,
}

impl GeometryStage<'_> {
    /// Runs for a range of primitives whose vertices are in `input`.
    ///
    /// # Errors
    /// When a batch runs over its budget.
    pub fn run(
        &self,
        machine: &mut Machine,
        (input, vertex_list): (&Geometry, &VertexList),
        (primitives, range): (&Primitives, Range<u32>),
        out: &mut Emitted<'_>,
    ) -> Result<(), OverBudget> {
        let sources: Vec<InputSource> =
            self.program.inputs().iter().map(|&input| self.source(input)).collect();
        let targets = self.targets();
        let each = self.program.geometry().map_or(0, |own| usize::from(own.input.vertices()));
        let mut vertices = [[0_u32; LANES]; 6];
        machine.begin(self.program);
        for first in range.clone().step_by(LANES) {
            let count = (range.end - first).min(LANES as u32) as usize;
            let mut numbers = U32s::ZERO;
            for lane in 0..count {
                numbers[lane] = primitives.number(first + lane as u32);
            }
            match (primitives.triples(), &mut vertices) {
                (Some(_), [a, b, c, ..]) => {
                    let mut triples = [U32s::ZERO; 3];
                    vertex_list.triples(3 * first, &mut triples, count);
                    [*a, *b, *c] = triples.map(|lanes| lanes.0);
                }
                (None, vertices) => {
                    for lane in 0..count {
                        let own = primitives.with_adjacency(first + lane as u32);
                        for (to, ordinal) in vertices.iter_mut().zip(&own[..each]) {
                            to[lane] = vertex_list.local(*ordinal);
                        }
                    }
                }
            }
            for (index, source) in sources.iter().enumerate() {
                let lanes = machine.input_mut(index);
                match *source {
                    InputSource::Zero => *lanes = U32s::ZERO,
                    InputSource::PrimitiveId => *lanes = numbers,
                    InputSource::Value(vertex, at) => {
                        gather(lanes, &input.values, &vertices[vertex][..count], input.stride, at);
                    }
                    InputSource::PointSize(vertex) => {
                        gather(lanes, &input.point_sizes, &vertices[vertex][..count], 1, 0);
                    }
                    InputSource::Distance(vertex, at) => {
                        let own = &vertices[vertex][..count];
                        gather(lanes, &input.distances, own, input.planes, at);
                    }
                }
            }
            machine.run(Invocation {
                isa: self.isa,
                program: self.program,
                prepared: self.prepared,
                textures: self.textures,
                active: !0 >> (LANES - count),
                budget: self.budget,
            })?;
            self.operations.fetch_add(self.budget - machine.left(), Ordering::Relaxed);
            self.append(machine.emission(), count, &numbers, &targets, out);
        }
        Ok(())
    }

    fn source(&self, input: Input) -> InputSource {
        let Input::OfVertex { vertex, output } = input else {
            return if input == Input::PrimitiveId {
                InputSource::PrimitiveId
            } else {
                InputSource::Zero
            };
        };
        let vertex = usize::from(vertex);
        let is_written = self.vertex.output(output).is_some();
        match output {
            Output::Position(component) => InputSource::Value(vertex, component.into()),
            Output::Varying(slot) => {
                let at = self.vertex_varyings.iter().position(|&other| other == slot);
                at.map_or(InputSource::Zero, |at| InputSource::Value(vertex, VARYINGS + at))
            }
            Output::PointSize if is_written => InputSource::PointSize(vertex),
            Output::ClipDistance(_) if is_written => {
                let of_planes = |output: &Output| matches!(output, Output::ClipDistance(_));
                let at = self.vertex.outputs().filter(of_planes).position(|other| other == output);
                at.map_or(InputSource::Zero, |at| InputSource::Distance(vertex, at))
            }
            Output::PointSize
            | Output::ClipDistance(_)
            | Output::CullDistance(_)
            | Output::Color { .. }
            | Output::SecondColor(_)
            | Output::Depth
            | Output::StencilReference
            | Output::SampleMask
            | Output::Layer
            | Output::PrimitiveId
            | Output::ViewportIndex => InputSource::Zero,
        }
    }

    /// Where the scalars of an emitted vertex go.
    fn targets(&self) -> Targets {
        let mut targets = Targets::default();
        let outputs = self.program.geometry().map_or(&[][..], |interface| &interface.outputs);
        for (word, output) in outputs.iter().enumerate() {
            match *output {
                Output::Position(component) => {
                    targets.position[usize::from(component)] = Some(word)
                }
                Output::PointSize => match self.point_size {
                    PointSize::State => {}
                    PointSize::Vertex => targets.point_size = Some(word),
                },
                Output::ClipDistance(_) => targets.distances.push(word),
                Output::CullDistance(number) => targets.culls.push((word, number)),
                Output::Varying(slot) => {
                    let at = self.varyings.iter().position(|&other| other == slot);
                    targets.varyings.extend(at.map(|at| (word, VARYINGS + at)));
                }
                Output::Layer => targets.layer = Some(word),
                Output::PrimitiveId => targets.primitive_id = Some(word),
                Output::ViewportIndex => targets.viewport = Some(word),
                Output::Color { .. }
                | Output::SecondColor(_)
                | Output::Depth
                | Output::StencilReference
                | Output::SampleMask => {}
            }
        }
        targets
    }

    /// Values of an emitted vertex, a multiple of four.
    fn stride(&self) -> usize {
        (VARYINGS + self.varyings.len()).next_multiple_of(4)
    }

    /// Appends what a batch has emitted.
    fn append(
        &self,
        emission: &Emission,
        lanes: usize,
        numbers: &U32s,
        targets: &Targets,
        out: &mut Emitted<'_>,
    ) {
        let before = out.geometry.len() as u32;
        let (mut bases, mut counts) = (U32s::ZERO, U32s::ZERO);
        let (mut total, mut most) = (before, 0);
        for lane in 0..lanes {
            (bases[lane], counts[lane]) = (total, emission.count(lane));
            total += counts[lane];
            most = most.max(counts[lane]);
        }
        let (stride, planes) = (self.stride(), targets.distances.len());
        let geometry = &mut *out.geometry;
        (geometry.stride, geometry.planes) = (stride, planes);
        let end = total as usize;
        geometry.values.resize(end * stride, 0.0);
        geometry.snapped.resize(end, [0; 2]);
        geometry.outcodes.resize(end, 0);
        geometry.point_sizes.resize(end * usize::from(targets.point_size.is_some()), 0.0);
        geometry.distances.resize(end * planes, 0.0);
        geometry.layers.resize(end * usize::from(self.layers == Layers::Several), 0);
        geometry.viewports.resize(end * usize::from(self.viewports == Viewports::Several), 0);
        let mut places: Vec<(usize, usize)> = Vec::with_capacity(lanes);
        for vertex in 0..most {
            // The lanes that have such a vertex, and its place.
            places.clear();
            let having = (0..lanes).filter(|&lane| vertex < counts[lane]);
            places.extend(having.map(|lane| (lane, (bases[lane] + vertex) as usize)));
            let places = || places.iter().copied();
            let mut clip = [&F32s::ZERO; 4];
            for (component, word) in targets.position.iter().enumerate() {
                let Some(word) = *word else { continue };
                let from = emission.values(vertex, word).as_f32();
                clip[component] = from;
                places()
                    .for_each(|(lane, at)| geometry.values[at * stride + component] = from[lane]);
            }
            for &(word, value) in &targets.varyings {
                let from = emission.values(vertex, word).as_f32();
                places().for_each(|(lane, at)| geometry.values[at * stride + value] = from[lane]);
            }
            if self.primitive_id != [None; 2] {
                let from =
                    targets.primitive_id.map_or(numbers, |word| emission.values(vertex, word));
                for (part, varying) in [0, 16].into_iter().zip(self.primitive_id) {
                    let Some(varying) = varying else { continue };
                    places().for_each(|(lane, at)| {
                        let bits = from[lane] >> part & HALF;
                        geometry.values[at * stride + VARYINGS + varying] = bits as f32;
                    });
                }
            }
            if let Some(word) = targets.point_size {
                let from = emission.values(vertex, word).as_f32();
                places().for_each(|(lane, at)| geometry.point_sizes[at] = from[lane]);
            }
            if let (Layers::Several, Some(word)) = (self.layers, targets.layer) {
                let from = emission.values(vertex, word);
                places().for_each(|(lane, at)| geometry.layers[at] = from[lane]);
            }
            if let (Viewports::Several, Some(word)) = (self.viewports, targets.viewport) {
                let from = emission.values(vertex, word);
                places().for_each(|(lane, at)| geometry.viewports[at] = from[lane]);
            }
            for (plane, &word) in targets.distances.iter().enumerate() {
                let from = emission.values(vertex, word).as_f32();
                places()
                    .for_each(|(lane, at)| geometry.distances[at * planes + plane] = from[lane]);
            }
            let mut window = WindowVertices { snapped: [[0; LANES]; 2], outcodes: [0; LANES] };
            self.isa.run(ViewportTransform { clip, viewport: &self.viewport, out: &mut window });
            for &(word, number) in &targets.culls {
                let distances = emission.values(vertex, word).as_f32();
                note_culled(&mut window.outcodes, number, distances);
            }
            places().for_each(|(lane, at)| {
                geometry.snapped[at] = [window.snapped[0][lane], window.snapped[1][lane]];
                geometry.outcodes[at] = window.outcodes[lane];
            });
        }
        if planes > 0 {
            let own = geometry.outcodes[before as usize..].iter_mut();
            let distances = geometry.distances[before as usize * planes..].chunks_exact(planes);
            own.zip(distances).for_each(|(outcode, distances)| cut(outcode, distances));
        }
        let Some(interface) = self.program.geometry() else { return };
        out.indices.reserve(3 * (total - before) as usize);
        for lane in 0..lanes {
            let mut position = 0;
            for vertex in 0..counts[lane] {
                position = if emission.begins_strip(lane, vertex) { 0 } else { position + 1 };
                let corners = self.provoking.corners_of_strip(interface.output, position);
                let last = bases[lane] + vertex;
                out.indices.extend(corners.iter().map(|back| last - back));
            }
        }
    }
}

/// By word of an emitted vertex, its destination.
#[derive(Default)]
struct Targets {
    position: [Option<usize>; 4],
    /// Words, and values of the vertex.
    varyings: Vec<(usize, usize)>,
    point_size: Option<usize>,
    distances: Vec<usize>,
    /// Words and numbers of cull distances.
    culls: Vec<(usize, u8)>,
    layer: Option<usize>,
    viewport: Option<usize>,
    primitive_id: Option<usize>,
}

/// Value `at` of each of these vertices.
fn gather(lanes: &mut U32s, values: &[f32], vertices: &[u32], stride: usize, at: usize) {
    for (lane, &vertex) in lanes.0.iter_mut().zip(vertices) {
        *lane = values[vertex as usize * stride + at].to_bits();
    }
}
