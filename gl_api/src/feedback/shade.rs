//! Vertices through the vertex stage of the state, for what is not drawn: selection, feedback,
//! transform feedback, raster positions.

use crate::context::Context;
use crate::draw::stages;
use crate::error::{Result, invalid_operation};
use rasterizer::driver::{Rim, ShaderModule, VertexBinding};
use rasterizer::ir::{Input, Output};
use rasterizer::shader::{Program, Run};
use std::sync::Arc;
use texunit::lanes::{Isa, LANES, U32s};

/// Which vertex of which instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Id {
    pub vertex: u32,
    pub instance: u32,
}

/// A vertex stage with all its outputs.
#[derive(Debug)]
pub(crate) struct Single {
    program: Program,
    /// Its outputs in order, and where each is among [`Program::outputs`].
    places: Vec<(Output, usize)>,
}

impl Single {
    pub fn new(module: &ShaderModule) -> Self {
        let program = Program::new(module.module(), |_| true);
        let mut places: Vec<(Output, usize)> = Vec::new();
        for (place, output) in program.outputs().enumerate() {
            let before = places.partition_point(|&(other, _)| other < output);
            places.insert(before, (output, place));
        }
        Self { program, places }
    }
}

/// What the vertex stage made of vertices.
pub(crate) struct Vertices {
    stage: Arc<Single>,
    /// The outputs of the first 64 vertices, then those of the next: each output of all of them.
    values: Vec<f32>,
    len: usize,
}

impl Vertices {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Which of the outputs this is, if the stage has it.
    pub fn place(&self, wanted: Output) -> Option<usize> {
        let places = &self.stage.places;
        let found = places.binary_search_by_key(&wanted, |&(output, _)| output);
        found.ok().map(|at| places[at].1)
    }

    /// The places of the clip coordinates.
    pub fn position(&self) -> [Option<usize>; 4] {
        [0, 1, 2, 3].map(|i| self.place(Output::Position(i)))
    }

    /// The places of four varyings from a slot on.
    pub fn varyings(&self, first: u16) -> [Option<usize>; 4] {
        [0, 1, 2, 3].map(|i| self.place(Output::Varying(first + i)))
    }

    /// The output at a [`Self::place`], of vertex `at`.
    pub fn value(&self, at: usize, place: usize) -> f32 {
        let (first, lane) = (at - at % LANES, at % LANES);
        let lanes = self.len.saturating_sub(first).min(LANES);
        let index = first * self.stage.places.len() + place * lanes + lane;
        self.values.get(index).copied().unwrap_or_default()
    }

    /// Four outputs of vertex `at`; those that the stage lacks are `otherwise`.
    pub fn four(&self, at: usize, places: [Option<usize>; 4], otherwise: [f32; 4]) -> [f32; 4] {
        std::array::from_fn(|i| places[i].map_or(otherwise[i], |place| self.value(at, place)))
    }

    /// Vertex `at`.
    pub fn vertex(&self, at: usize) -> Shaded<'_> {
        Shaded { vertices: self, at }
    }
}

/// What the vertex stage made of a vertex.
#[derive(Clone, Copy)]
pub(crate) struct Shaded<'a> {
    vertices: &'a Vertices,
    at: usize,
}

impl Shaded<'_> {
    /// An output, if the stage has it.
    pub fn get(&self, wanted: Output) -> Option<f32> {
        self.vertices.place(wanted).map(|place| self.vertices.value(self.at, place))
    }

    /// The clip coordinates.
    pub fn position(&self) -> [f64; 4] {
        self.vertices.four(self.at, self.vertices.position(), [0.0; 4]).map(f64::from)
    }

    /// Four varyings from a slot on; those that are not written are `otherwise`.
    pub fn varyings(&self, first: u16, otherwise: [f32; 4]) -> [f32; 4] {
        self.vertices.four(self.at, self.vertices.varyings(first), otherwise)
    }
}

/// An input of the stage for up to 64 vertices.
fn input(isa: Isa, vertices: &[VertexBinding], input: Input, ids: &[Id], out: &mut U32s) {
    match input {
        Input::Attribute { location, component } => {
            match vertices.iter().find(|binding| binding.location == location) {
                Some(VertexBinding { source, .. }) => {
                    let mut elements = [0; LANES];
                    for (element, id) in elements.iter_mut().zip(ids) {
                        *element = source.element(id.vertex, id.instance);
                    }
                    source.component(isa, component, &elements[..ids.len()], out.as_f32_mut());
                }
                None => *out = U32s::splat(0),
            }
        }
        Input::VertexId | Input::InstanceId => {
            for (lane, id) in ids.iter().enumerate() {
                out[lane] = if input == Input::VertexId { id.vertex } else { id.instance };
            }
        }
        Input::Varying(_)
        | Input::FragCoord(_)
        | Input::FrontFacing
        | Input::PointCoord(_)
        | Input::Slope { .. }
        | Input::Coverage => *out = U32s::splat(0),
    }
}

/// Runs the vertex stage of the state for vertices.
///
/// # Errors
/// As a draw, and where the shader runs too long.
pub(crate) fn shade(
    context: &mut Context,
    vertices: &[VertexBinding],
    ids: &[Id],
) -> Result<Vertices> {
    let stages = stages::choose(context, vertices, Rim::Aliased)?;
    let isa = context.recorder.isa();
    let stage = context.recorder.single_vertex(&stages.vertex);
    let program = &stage.program;
    let prepared = program.prepare(isa, &stages.reads.words, &stages.reads.vertex_textures);
    let machine = &mut context.feedback.machine;
    machine.begin(program);
    let outputs = stage.places.len();
    let mut values = Vec::with_capacity(ids.len() * outputs);
    for ids in ids.chunks(LANES) {
        for (index, &wanted) in program.inputs().iter().enumerate() {
            input(isa, vertices, wanted, ids, machine.input_mut(index));
        }
        let run = Run {
            isa,
            program,
            prepared: &prepared,
            textures: &stages.reads.vertex_textures,
            active: u64::MAX >> (LANES - ids.len()),
            budget: rasterizer::driver::DeviceDesc::BUDGET,
        };
        if machine.run(run).is_err() {
            return invalid_operation(
                "GL 2.1, section 2.15",
                "the vertex shader runs so long that it was stopped",
            );
        }
        for place in 0..outputs {
            values.extend_from_slice(&machine.output(place).as_f32().0[..ids.len()]);
        }
    }
    Ok(Vertices { stage, values, len: ids.len() })
}
