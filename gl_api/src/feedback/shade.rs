//! Vertices through the vertex stage of the state, for what is not drawn: selection, feedback,
//! transform feedback, raster positions.

use crate::context::Context;
use crate::draw::stages;
use crate::error::{Result, invalid_operation};
use rasterizer::driver::{Rim, VertexBinding};
use rasterizer::ir::{Input, Output};
use rasterizer::shader::{Machine, Run};
use texunit::lanes::{Isa, LANES, U32s};

/// Which vertex of which instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Id {
    pub vertex: u32,
    pub instance: u32,
}

/// What the vertex stage made of vertices.
pub(crate) struct Vertices {
    outputs: Vec<Output>,
    /// The outputs of the first vertex, then those of the next.
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
        self.outputs.iter().position(|output| *output == wanted)
    }

    /// The output at a [`Self::place`], of vertex `at`.
    pub fn value(&self, at: usize, place: usize) -> f32 {
        self.values.get(at * self.outputs.len() + place).copied().unwrap_or_default()
    }

    /// Vertex `at`.
    pub fn vertex(&self, at: usize) -> Shaded<'_> {
        Shaded { vertices: self, at }
    }

    /// All of them, in order.
    pub fn iter(&self) -> impl Iterator<Item = Shaded<'_>> {
        (0..self.len).map(|at| self.vertex(at))
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
        [0, 1, 2, 3].map(|i| self.get(Output::Position(i)).unwrap_or(0.0).into())
    }

    /// Four varyings from a slot on; those that are not written are `otherwise`.
    pub fn varyings(&self, first: u16, otherwise: [f32; 4]) -> [f32; 4] {
        [0, 1, 2, 3]
            .map(|i| self.get(Output::Varying(first + i)).unwrap_or(otherwise[usize::from(i)]))
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
    let program = context.recorder.single_vertex(&stages.vertex);
    let prepared = program.prepare(isa, &stages.reads.words, &stages.reads.vertex_textures);
    let mut machine = Machine::default();
    machine.begin(&program);
    let outputs: Vec<Output> = program.outputs().collect();
    let mut values = Vec::with_capacity(ids.len() * outputs.len());
    for ids in ids.chunks(LANES) {
        for (index, &wanted) in program.inputs().iter().enumerate() {
            input(isa, vertices, wanted, ids, machine.input_mut(index));
        }
        let run = Run {
            isa,
            program: &program,
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
        for lane in 0..ids.len() {
            let value = |index: usize| machine.output(index).as_f32()[lane];
            values.extend((0..outputs.len()).map(value));
        }
    }
    Ok(Vertices { outputs, values, len: ids.len() })
}
